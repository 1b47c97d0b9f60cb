//! Mutants of a crate, all of them in one build.
//!
//! `cargo mutants` builds the tests once for each mutant, which for a large crate takes nearly all of the time. This takes
//! the list that `cargo mutants --list --json` writes, weaves a changed copy of the function for each mutant into the
//! sources, builds once, and runs the tests with one mutant switched on at a time. What is built while none is switched on
//! (the ladder half of the safety library is, by the compiler) is not changed by a mutant.
//!
//! ```text
//! git clone . ../woven && cd ../woven
//! cargo mutants --list --json -p twinrung-compiler --shard 0/14 --sharding round-robin > list.json
//! cargo run -p twinrung-mutants -- --list list.json --package compiler -- -p twinrung-compiler
//! ```
//!
//! It changes the sources of the folder that it runs in and puts them back at the end: run it in a clone. It may depend on
//! nothing of this project, and no release may use it.

#![forbid(unsafe_code)]

mod build;
mod list;
mod run;
mod weave;

use std::collections::btree_map::Entry;
use std::collections::{BTreeMap, BTreeSet};
use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Duration;

use clap::Parser;

use list::Mutant;
use run::Verdict;

/// Weaves the mutants of a list into a crate, builds it once, and runs its tests with each of them.
#[derive(Debug, Parser)]
struct Arguments {
    /// What `cargo mutants --list --json` wrote.
    #[arg(long)]
    list: PathBuf,
    /// The folder of the crate that is changed, from the root of the workspace.
    #[arg(long)]
    package: PathBuf,
    /// Only the mutants whose names stand in this file, one in each line.
    #[arg(long)]
    only: Option<PathBuf>,
    /// Seconds after which a program of tests is taken for one that comes to no end.
    #[arg(long, default_value_t = 60)]
    timeout: u64,
    /// Where the names of those that no test noticed are written.
    #[arg(long, default_value = "missed.txt")]
    missed: PathBuf,
    /// Which tests: arguments of `cargo test`.
    #[arg(last = true)]
    tests: Vec<String>,
}

/// The sources as they were, put back in the end.
struct Originals(BTreeMap<PathBuf, String>);

impl Drop for Originals {
    fn drop(&mut self) {
        for (path, text) in &self.0 {
            if let Err(error) = fs::write(path, text) {
                eprintln!("{} is still woven: {error}", path.display());
            }
        }
    }
}

fn main() -> ExitCode {
    match measure(&Arguments::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::from(2)
        }
    }
}

fn measure(arguments: &Arguments) -> Result<(), Box<dyn Error>> {
    let mut mutants: Vec<Mutant> = serde_json::from_str(&fs::read_to_string(&arguments.list)?)?;
    if let Some(path) = &arguments.only {
        let names = fs::read_to_string(path)?;
        let names: BTreeSet<&str> = names.lines().collect();
        mutants.retain(|mutant| names.contains(mutant.name.as_str()));
    }
    let listed = mutants.len();
    let root_file = arguments.package.join("src/lib.rs");
    let mut originals = Originals(BTreeMap::new());
    for path in mutants.iter().map(|mutant| PathBuf::from(&mutant.file)).chain([root_file.clone()]) {
        if let Entry::Vacant(entry) = originals.0.entry(path) {
            let text = fs::read_to_string(entry.key())?;
            entry.insert(text);
        }
    }
    let mut unwoven = Vec::new();
    mutants.retain(|mutant| match weave::weavable(&originals.0[Path::new(&mutant.file)], mutant) {
        Ok(()) => true,
        Err(why) => {
            unwoven.push(format!("{} ({why:?})", mutant.name));
            false
        }
    });
    let mut unviable: BTreeSet<usize> = BTreeSet::new();
    let tests = loop {
        let places = write_woven(&originals, &root_file, &mutants, &unviable)?;
        let built = build::build(Path::new("."), &arguments.tests)?;
        if built.words.is_empty() {
            break built.tests;
        }
        let before = unviable.len();
        for (file, line) in &built.errors {
            let holds = |(range, _): &&(std::ops::Range<usize>, usize)| range.contains(line);
            unviable.extend(places.get(file).into_iter().flatten().filter(holds).map(|(_, number)| *number));
        }
        println!("{} mutants do not compile", unviable.len());
        if unviable.len() == before {
            return Err(format!("errors outside of the mutants:\n{}", built.words.join("\n")).into());
        }
    };
    let limit = Duration::from_secs(arguments.timeout);
    if run::run(&tests, 0, limit)? != Verdict::Missed {
        return Err("the tests fail without a mutant".into());
    }
    let viable: Vec<(usize, &Mutant)> = mutants
        .iter()
        .enumerate()
        .map(|(at, mutant)| (at + 1, mutant))
        .filter(|(number, _)| !unviable.contains(number))
        .collect();
    let (mut caught, mut timeout, mut missed) = (0, 0, Vec::new());
    for (done, (number, mutant)) in viable.iter().enumerate() {
        let verdict = run::run(&tests, *number, limit)?;
        match verdict {
            Verdict::Caught => caught += 1,
            Verdict::Timeout => timeout += 1,
            Verdict::Missed => missed.push(mutant.name.clone()),
        }
        println!("{}/{} {verdict:?} {}", done + 1, viable.len(), mutant.name);
    }
    fs::write(&arguments.missed, missed.iter().map(|name| format!("{name}\n")).collect::<String>())?;
    println!(
        "listed {listed}, not woven {}, unviable {}, caught {caught}, timeout {timeout}, missed {}",
        unwoven.len(),
        unviable.len(),
        missed.len()
    );
    unwoven.iter().for_each(|name| println!("not woven: {name}"));
    unviable.iter().for_each(|number| println!("unviable: {}", mutants[number - 1].name));
    Ok(())
}

/// Lines of each file that belong to a mutant.
type Places = BTreeMap<String, Vec<(std::ops::Range<usize>, usize)>>;

fn write_woven(
    originals: &Originals,
    root_file: &Path,
    mutants: &[Mutant],
    unviable: &BTreeSet<usize>,
) -> Result<Places, Box<dyn Error>> {
    let mut places = Places::new();
    for (path, text) in &originals.0 {
        let in_file = |(_, mutant): &(usize, &Mutant)| Path::new(&mutant.file) == path;
        let numbered = mutants.iter().enumerate().map(|(at, mutant)| (at + 1, mutant));
        let own: Vec<(usize, &Mutant)> =
            numbered.filter(in_file).filter(|(number, _)| !unviable.contains(number)).collect();
        let mut woven = weave::weave(text, &own);
        if path == root_file {
            woven.text.push_str(weave::SWITCHING);
        }
        if fs::read_to_string(path)? != woven.text {
            fs::write(path, &woven.text)?;
        }
        places.insert(path.display().to_string(), woven.lines);
    }
    Ok(places)
}
