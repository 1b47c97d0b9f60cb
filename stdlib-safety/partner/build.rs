//! Compiles the ladder of the library to the image that the crate carries.

use std::error::Error;
use std::path::PathBuf;
use std::{env, fs};

#[path = "src/sources.rs"]
mod sources;

fn main() -> Result<(), Box<dyn Error>> {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rerun-if-changed=src/sources.rs");
    println!("cargo::rerun-if-changed=rll");
    let image = twinrung_compiler::compile_library(sources::SOURCES)?;
    let out = env::var_os("OUT_DIR").ok_or("OUT_DIR is not set: run this through cargo")?;
    fs::write(PathBuf::from(out).join("library.image"), image)?;
    Ok(())
}
