//! Compiles the ladder of the library to the image that the crate carries, and verifies it: a library that is not admitted
//! is not built.

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
    let admitted = twinrung_bytecode::admit_library(&image)?;
    let out = PathBuf::from(env::var_os("OUT_DIR").ok_or("OUT_DIR is not set: run this through cargo")?);
    fs::write(out.join("library.signature"), admitted.image_signature())?;
    fs::write(out.join("library.image"), image)?;
    Ok(())
}
