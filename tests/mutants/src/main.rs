//! Runs the tests of a crate with each mutant of a list.
//!
//! `cargo mutants` builds the tests once for each mutant, which for a large crate takes nearly all of the time. This takes
//! the list that `cargo mutants --list --json` writes, weaves all of them into one build, and runs the tests with one switched on
//! at a time.
//!
//! ```text
//! git clone . ../woven && cd ../woven
//! cargo mutants --list --json -p twinrung-compiler --shard 0/14 --sharding round-robin > list.json
//! cargo run -p twinrung-mutants -- --list list.json -- -p twinrung-compiler
//! ```
//!
//! It changes the sources of the folder that it runs in and puts them back at the end. It begins in a clone without changes alone, so
//! that `git checkout .` puts back what an interruption left woven. It may depend on nothing of this project, and no release may
//! use it.

#![forbid(unsafe_code)]

mod run;

use std::collections::BTreeSet;
use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};
use std::time::Duration;

use clap::Parser;
use twinrung_mutants::{Loom, Mutant};

use run::Verdict;

/// Weaves the mutants of a list into a crate, builds it once, and runs its tests with each of them.
#[derive(Debug, Parser)]
struct Arguments {
    /// What `cargo mutants --list --json` wrote.
    #[arg(long)]
    list: PathBuf,
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
    clean(Path::new("."))?;
    let mut mutants: Vec<Mutant> = serde_json::from_str(&fs::read_to_string(&arguments.list)?)?;
    if let Some(path) = &arguments.only {
        let names = fs::read_to_string(path)?;
        let names: BTreeSet<&str> = names.lines().collect();
        mutants.retain(|mutant| names.contains(mutant.name.as_str()));
    }
    let listed = mutants.len();
    let mut loom = Loom::new(Path::new("."), mutants)?;
    let words: Vec<String> =
        ["test", "--no-run"].into_iter().map(str::to_owned).chain(arguments.tests.clone()).collect();
    let tests = loom.build(&words)?.tests;
    if tests.is_empty() {
        // Every mutant would be missed.
        return Err(
            "no program of tests was built: name packages that have tests behind --, as `-- -p twinrung-compiler`"
                .into(),
        );
    }
    let limit = Duration::from_secs(arguments.timeout);
    if run::run(&tests, 0, limit)? != Verdict::Missed {
        return Err("the tests fail without a mutant".into());
    }
    let viable = loom.viable().count();
    let (mut caught, mut timeout, mut missed) = (0, 0, Vec::new());
    for (done, (number, mutant)) in loom.viable().enumerate() {
        let verdict = run::run(&tests, number, limit)?;
        match verdict {
            Verdict::Caught => caught += 1,
            Verdict::Timeout => timeout += 1,
            Verdict::Missed => missed.push(mutant.name.clone()),
        }
        println!("{}/{viable} {verdict:?} {}", done + 1, mutant.name);
    }
    fs::write(&arguments.missed, missed.iter().map(|name| format!("{name}\n")).collect::<String>())?;
    println!(
        "listed {listed}, not woven {}, unviable {}, caught {caught}, timeout {timeout}, missed {}",
        loom.unwoven().len(),
        loom.unviable().count(),
        missed.len()
    );
    loom.unwoven().iter().for_each(|(mutant, why)| println!("not woven: {} ({why:?})", mutant.name));
    loom.unviable().for_each(|mutant| println!("unviable: {}", mutant.name));
    Ok(())
}

/// Refuses a folder whose sources are not those of its commit: what is woven into them could not be told from what is not.
fn clean(root: &Path) -> Result<(), Box<dyn Error>> {
    let status =
        Command::new("git").args(["status", "--porcelain", "--untracked-files=no"]).current_dir(root).output()?;
    if !status.status.success() {
        return Err("this is no clone of a repository, and what an interruption leaves woven could not be put back: run this in one".into());
    }
    match String::from_utf8_lossy(&status.stdout).lines().next() {
        None => Ok(()),
        Some(first) => Err(format!(
            "there are changes that are not committed ({first}): commit them, or, where an interrupted run left its mutants, `git checkout .`"
        )
        .into()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn folder_when_it_has_changes_or_is_no_clone_then_nothing_is_woven_into_it() {
        let folder = tempfile::tempdir().unwrap();
        let root = folder.path();
        let git = |arguments: &[&str]| {
            let named = ["-c", "user.name=a", "-c", "user.email=a@b"];
            let ended = Command::new("git").args(named).args(arguments).current_dir(root).output().unwrap();
            assert!(ended.status.success(), "{ended:?}");
        };
        assert!(clean(root).unwrap_err().to_string().contains("no clone of a repository"));
        git(&["init", "--quiet"]);
        fs::write(root.join("a.rs"), "one").unwrap();
        git(&["add", "a.rs"]);
        git(&["commit", "--quiet", "--message", "a"]);
        fs::write(root.join("list.json"), "[]").unwrap();
        assert!(clean(root).is_ok());
        fs::write(root.join("a.rs"), "woven").unwrap();
        assert!(clean(root).unwrap_err().to_string().contains("a.rs"));
    }
}
