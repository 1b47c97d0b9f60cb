//! Where mutation begins: the samples, in all their forms.

use std::fs;
use std::path::{Path, PathBuf};

use twinrung_compiler::{Completion, check, compile};
use twinrung_grammar::read_path;
use twinrung_grammar::tree::Sources;

use crate::Target;

/// Folders that hold good beginnings, from the root of the project.
const FOLDERS: [&str; 3] = ["samples", "grammar/tests", "tests/verdict"];

/// The seeds of a target with their names, in a fixed order.
///
/// # Errors
/// When a folder or file cannot be read.
pub fn seeds(target: Target) -> std::io::Result<Vec<(String, Vec<u8>)>> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let endings: &[&str] = match target {
        Target::Source => &["rll", "L5K"],
        Target::L5x => &["L5X"],
        Target::Scenario => &["scenario"],
        Target::Image => &["rll"],
    };
    let mut list = Vec::new();
    for folder in FOLDERS {
        for path in files(&root.join(folder))? {
            if !path.extension().is_some_and(|own| endings.iter().any(|ending| own.eq_ignore_ascii_case(ending))) {
                continue;
            }
            let name = path.strip_prefix(&root).unwrap_or(&path).to_string_lossy().replace(['/', '\\'], "-");
            match target {
                Target::Source | Target::L5x | Target::Scenario => list.push((name, fs::read(&path)?)),
                Target::Image => list.extend(image(&path).map(|bytes| (name, bytes))),
            }
        }
    }
    if target == Target::Scenario {
        list.push(("setups-that-multiply".to_owned(), setups_that_multiply().into_bytes()));
    }
    Ok(list)
}

/// Setups that each begin with eight others: laid out they would be 8^15 lines.
fn setups_that_multiply() -> String {
    let with = |setup: usize| format!("  with \"{setup}\"\n").repeat(8);
    let setups: String = (1..15).map(|setup| format!("setup \"{setup}\"\n{}end\n", with(setup - 1))).collect();
    let first = "setup \"0\"\n  when Reset is on\n  then K1 is off\nend\n";
    format!("{first}{setups}scenario \"x\"\n{}  then K1 is off\nend\n", with(14))
}

/// The image of a sample; nothing for one that is refused.
fn image(path: &Path) -> Option<Vec<u8>> {
    let reading = read_path(&mut Sources::new(), path);
    let project = check(&reading, &Completion::default()).project?;
    compile(&project).ok().map(|compiled| compiled.bytes)
}

fn files(folder: &Path) -> std::io::Result<Vec<PathBuf>> {
    let mut found = Vec::new();
    let mut open = vec![folder.to_owned()];
    while let Some(folder) = open.pop() {
        for entry in fs::read_dir(folder)? {
            let path = entry?.path();
            if path.is_dir() { open.push(path) } else { found.push(path) }
        }
    }
    found.sort();
    Ok(found)
}
