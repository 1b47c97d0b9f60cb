//! `twinrung diff`: what differs between two projects or images, what drives outputs first.

use std::collections::BTreeMap;
use std::io::{self, Write};
use std::path::PathBuf;
use std::process::ExitCode;

use clap::Args;
use twinrung_bytecode::AdmittedImage;
use twinrung_bytecode::image::Image;
use twinrung_bytecode::index::{ProgramIndex, RoutineIndex};
use twinrung_bytecode::signature::{Leaf, LeafKind, leaves, short_form};
use twinrung_bytecode::text;

use crate::input::{self, Complete};
use crate::{exit, terminal};

/// Arguments of `diff`.
#[derive(Debug, Args)]
#[command(after_help = "Exit code: 0 the safety application signatures agree, 1 they differ, 2 could not read.")]
pub struct Diff {
    /// A project or an image
    a: PathBuf,
    /// Another project or image
    b: PathBuf,
    #[command(flatten)]
    complete: Complete,
}

/// Compares.
pub fn run(arguments: &Diff) -> io::Result<ExitCode> {
    let mut out = terminal::out();
    let mut image = |path| input::image(&mut out, path, &arguments.complete, "");
    let (Ok(a), Ok(b)) = (image(&arguments.a)?, image(&arguments.b)?) else {
        return Ok(ExitCode::from(exit::UNREADABLE));
    };
    let (one, other) = (a.image.application_signature(), b.image.application_signature());
    if one == other {
        writeln!(out, "same safety application, signature {}", short_form(one))?;
        if a.image.image_signature() != b.image.image_signature() {
            writeln!(out, "the images differ in their bytes only (another release of the compiler)")?;
        }
        return Ok(ExitCode::SUCCESS);
    }
    writeln!(out, "safety application signatures {} and {}", short_form(one), short_form(other))?;
    changes(&mut out, &a.image, &b.image)?;
    Ok(ExitCode::from(exit::REFUSED))
}

/// Leaves by kind and name, in the order in which a reviewer wants them: logic, task, modules, map, then data.
fn by_name(image: &Image) -> io::Result<BTreeMap<(u8, &'static str, String), Leaf>> {
    let found = leaves(image).map_err(|error| io::Error::other(error.to_string()))?;
    Ok(found.into_iter().map(|leaf| ((weight(leaf.kind), leaf.kind.name(), leaf.name.clone()), leaf)).collect())
}

fn weight(kind: LeafKind) -> u8 {
    match kind {
        LeafKind::Routine => 0,
        LeafKind::AddOn => 1,
        LeafKind::Program => 2,
        LeafKind::Task => 3,
        LeafKind::Module => 4,
        LeafKind::Map => 5,
        LeafKind::Controller => 6,
        LeafKind::Tags => 7,
        LeafKind::Type => 8,
    }
}

fn changes(out: &mut dyn Write, a: &AdmittedImage, b: &AdmittedImage) -> io::Result<()> {
    let (ours, theirs) = (by_name(a.image())?, by_name(b.image())?);
    let mut keys: Vec<_> = ours.keys().chain(theirs.keys()).collect();
    keys.sort();
    keys.dedup();
    for key in keys {
        let (_, kind, name) = key;
        match (ours.get(key), theirs.get(key)) {
            (Some(one), Some(other)) if one.hash == other.hash => {}
            (Some(one), Some(_)) => {
                writeln!(out, "changed  {kind} {name}")?;
                details(out, a, b, one)?;
            }
            (Some(_), None) => writeln!(out, "removed  {kind} {name}")?,
            (None, _) => writeln!(out, "added    {kind} {name}")?,
        }
    }
    Ok(())
}

fn details(out: &mut dyn Write, a: &AdmittedImage, b: &AdmittedImage, leaf: &Leaf) -> io::Result<()> {
    let (admitted_a, admitted_b) = (a, b);
    let (a, b) = (a.image(), b.image());
    let (before, after) = match leaf.kind {
        LeafKind::Routine => (routine(a, &leaf.name), routine(b, &leaf.name)),
        LeafKind::Module => (module(a, &leaf.name), module(b, &leaf.name)),
        LeafKind::Tags => (tags(admitted_a, &leaf.name), tags(admitted_b, &leaf.name)),
        LeafKind::Task => (task(a), task(b)),
        _ => return Ok(()),
    };
    for (index, line) in before.iter().enumerate() {
        if !after.contains(line) {
            writeln!(out, "  - {index:>4}  {line}")?;
        }
    }
    for (index, line) in after.iter().enumerate() {
        if !before.contains(line) {
            writeln!(out, "  + {index:>4}  {line}")?;
        }
    }
    Ok(())
}

fn routine(image: &Image, name: &str) -> Vec<String> {
    let position =
        (0..image.routines.len()).find(|index| text::routine_name(image, RoutineIndex(*index as u32)) == name);
    position.map(|index| image.routines[index].text.lines().map(str::to_owned).collect()).unwrap_or_default()
}

fn module(image: &Image, name: &str) -> Vec<String> {
    let found = image.modules.iter().find(|module| module.name == name);
    found.map(|module| module.text.lines().map(str::to_owned).collect()).unwrap_or_default()
}

fn tags(admitted: &AdmittedImage, program: &str) -> Vec<String> {
    let image = admitted.image();
    let mut rendered = String::new();
    let index = image.programs.iter().position(|record| record.name == program);
    let program = index.map(|index| ProgramIndex(index as u16));
    match text::write_tags(image, admitted.layouts(), program, &mut rendered) {
        Ok(()) => rendered.lines().map(str::to_owned).collect(),
        Err(error) => vec![format!("{error:?}")],
    }
}

fn task(image: &Image) -> Vec<String> {
    let Some(task) = &image.task else { return Vec::new() };
    let schedule = task.schedule.iter().filter_map(|program| image.programs.get(program.position()));
    let schedule: Vec<&str> = schedule.map(|program| program.name.as_str()).collect();
    vec![
        format!("name {}", task.name),
        format!("period {} us", task.period_us),
        format!("watchdog {} us", task.watchdog_us),
        format!("priority {}", task.priority),
        format!("schedule {}", schedule.join(", ")),
    ]
}
