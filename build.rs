//! Tells the command which compiler builds it. Cargo runs this again when the compiler changes.

use std::process::Command;

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    let compiler = std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
    let said =
        Command::new(compiler).arg("--version").output().ok().and_then(|said| String::from_utf8(said.stdout).ok());
    println!("cargo::rustc-env=TWINRUNG_RUSTC={}", said.unwrap_or_default().trim());
}
