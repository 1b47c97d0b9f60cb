//! `twinrung show`: what an image, or the image of a project, holds.

use std::io::{self, Write};
use std::path::PathBuf;
use std::process::ExitCode;

use clap::{Args, ValueEnum};
use twinrung_bytecode::image::{Image, TagKind};
use twinrung_bytecode::index::RoutineIndex;
use twinrung_bytecode::signature::{leaves, long_form, short_form};
use twinrung_bytecode::{container, text};

use crate::input::{self, Complete, Loaded};
use crate::terminal;

/// Arguments of `show`.
#[derive(Debug, Args)]
#[command(after_help = "Exit code: 0 shown, 1 refused, 2 could not read.")]
pub struct Show {
    /// An image, or a project that is compiled first
    file: PathBuf,
    /// What to show; everything but code where this is not given
    #[arg(long, value_enum)]
    only: Option<What>,
    #[command(flatten)]
    complete: Complete,
}

/// A part of an image.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum What {
    /// Both signatures, and every leaf that they cover
    Signatures,
    /// Sections with offset and length
    Sections,
    /// Tags with their cells
    Layout,
    /// Routines as neutral text
    Text,
    /// Routines as code
    Code,
}

/// Shows.
pub fn run(arguments: &Show) -> io::Result<ExitCode> {
    let mut out = terminal::out();
    let loaded = match input::image(&mut out, &arguments.file, &arguments.complete, "")? {
        Ok(loaded) => loaded,
        Err(code) => return Ok(code),
    };
    let wanted = |what| arguments.only.is_none_or(|only| only == what);
    if wanted(What::Signatures) {
        signatures(&mut out, &loaded)?;
    }
    if wanted(What::Sections) {
        sections(&mut out, &loaded)?;
    }
    if wanted(What::Layout) {
        layout(&mut out, loaded.image.image())?;
    }
    if wanted(What::Text) {
        texts(&mut out, loaded.image.image())?;
    }
    if arguments.only == Some(What::Code) {
        code(&mut out, loaded.image.image())?;
    }
    Ok(ExitCode::SUCCESS)
}

fn signatures(out: &mut dyn Write, loaded: &Loaded) -> io::Result<()> {
    let (application, image) = (loaded.image.application_signature(), loaded.image.image_signature());
    writeln!(out, "safety application signature  {}  {}", short_form(application), long_form(application))?;
    writeln!(out, "image signature               {}  {}", short_form(image), long_form(image))?;
    for leaf in leaves(loaded.image.image()).map_err(failed_image)? {
        let name = if leaf.name.is_empty() { "(controller)" } else { &leaf.name };
        writeln!(out, "  {}  {:<19} {name}", short_form(&leaf.hash), leaf.kind.name())?;
    }
    writeln!(out)
}

fn sections(out: &mut dyn Write, loaded: &Loaded) -> io::Result<()> {
    writeln!(out, "{:>10} {:>10}  section", "offset", "bytes")?;
    for place in container::section_places(&loaded.bytes).map_err(failed_image)? {
        writeln!(out, "{:>10} {:>10}  {}", place.offset, place.length, place.section.name())?;
    }
    writeln!(out)
}

fn layout(out: &mut dyn Write, image: &Image) -> io::Result<()> {
    writeln!(out, "{:>8} {:>8}  tag", "bit cell", "word")?;
    for tag in &image.tags {
        let program = tag.program.and_then(|program| image.programs.get(program.position()));
        let scope = program.map_or_else(String::new, |program| format!("Program:{}.", program.name));
        let kind = match tag.kind {
            TagKind::Base => "",
            TagKind::Alias(_) => "alias",
            TagKind::Produced => "produced",
            TagKind::Consumed => "consumed",
            TagKind::ModuleInput => "module input",
            TagKind::ModuleOutput => "module output",
        };
        let type_name = text::type_name(image, tag.type_reference);
        match tag.kind {
            TagKind::Alias(_) => writeln!(out, "{:>8} {:>8}  {scope}{} : {type_name} {kind}", "-", "-", tag.name)?,
            _ => writeln!(out, "{:>8} {:>8}  {scope}{} : {type_name} {kind}", tag.bit_cell, tag.word_cell, tag.name)?,
        }
    }
    writeln!(out)
}

fn texts(out: &mut dyn Write, image: &Image) -> io::Result<()> {
    for (index, routine) in image.routines.iter().enumerate() {
        writeln!(out, "{}", text::routine_name(image, RoutineIndex(index as u32)))?;
        for (rung, line) in routine.text.lines().enumerate() {
            writeln!(out, "{rung:>6}  {line}")?;
        }
        writeln!(out)?;
    }
    Ok(())
}

fn code(out: &mut dyn Write, image: &Image) -> io::Result<()> {
    for (index, routine) in image.routines.iter().enumerate() {
        writeln!(out, "{}  ({} bytes)", text::routine_name(image, RoutineIndex(index as u32)), routine.code.len())?;
        for (line, bytes) in routine.code.chunks(16).enumerate() {
            let hexadecimal: Vec<String> = bytes.iter().map(|byte| format!("{byte:02x}")).collect();
            writeln!(out, "{:08x}  {}", line * 16, hexadecimal.join(" "))?;
        }
        writeln!(out)?;
    }
    Ok(())
}

fn failed_image(error: twinrung_bytecode::ImageError) -> io::Error {
    io::Error::other(error.to_string())
}
