//! Machine instructions of one scan, counted by valgrind's callgrind: for changes too small for a noisy clock.
//!
//! `cargo bench -p twinrung-benches --bench instructions -- [--save FILE] [--against FILE]`. Where valgrind is missing it says so
//! and ends well.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::process::Command;

use twinrung_benches::{Inputs, Result, checked, image, timed};
use twinrung_controller::Partner;
use twinrung_workbench::mix::{Mix, Program};

/// What is counted: mix, rungs, scans. A count is that of many scans less that of few, so that loading is not in it.
const WORK: [(Mix, usize); 2] = [(Mix::Simple, 1000), (Mix::Plant, 1000)];
const FEW: u64 = 5;
const MANY: u64 = 25;

fn main() -> Result<()> {
    let arguments: Vec<String> = std::env::args().skip(1).filter(|argument| argument != "--bench").collect();
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    match arguments.as_slice() {
        ["work", mix, rungs, scans] => {
            let program = Program::new(mix.parse()?, rungs.parse()?, 1);
            let (image, bytes) = image(&checked("mix.rll", &program.rll())?)?;
            timed::<Partner>(&image, &bytes, scans.parse()?, Inputs::Toggled(16)).map(|_| ())
        }
        [] => count_all().map(|_| ()),
        ["--save", file] => Ok(std::fs::write(file, text(&count_all()?))?),
        ["--against", file] => compare(&std::fs::read_to_string(file)?, &count_all()?),
        // What `cargo test --benches` passes on.
        _ => Ok(()),
    }
}

type Counts = BTreeMap<String, u64>;

fn count_all() -> Result<Counts> {
    let mut counts = Counts::new();
    if Command::new("valgrind").arg("--version").output().is_err() {
        println!("skipped: valgrind is not installed");
        return Ok(counts);
    }
    for (mix, rungs) in WORK {
        let scans = collected(mix, rungs, MANY)?.saturating_sub(collected(mix, rungs, FEW)?) / (MANY - FEW);
        println!("scan {mix} {rungs}: {scans} instructions, {:.1} per rung", scans as f64 / rungs as f64);
        counts.insert(format!("{mix}-{rungs}"), scans);
    }
    Ok(counts)
}

fn collected(mix: Mix, rungs: usize, scans: u64) -> Result<u64> {
    let out = tempfile::NamedTempFile::new()?;
    let output = Command::new("valgrind")
        .arg("--tool=callgrind")
        .arg(format!("--callgrind-out-file={}", out.path().display()))
        .arg(std::env::current_exe()?)
        .args(["work", &mix.to_string(), &rungs.to_string(), &scans.to_string()])
        .output()?;
    let said = String::from_utf8_lossy(&output.stderr);
    let collected = said.lines().find_map(|line| line.split_once("Collected : ")).map(|(_, number)| number.trim());
    collected.and_then(|number| number.parse().ok()).ok_or_else(|| format!("callgrind: {said}").into())
}

fn text(counts: &Counts) -> String {
    counts.iter().fold(String::new(), |mut text, (name, count)| {
        let _ = writeln!(text, "{name} {count}");
        text
    })
}

fn compare(before: &str, now: &Counts) -> Result<()> {
    for (name, count) in before.lines().filter_map(|line| line.split_once(' ')) {
        let before: f64 = count.trim().parse()?;
        if let Some(now) = now.get(name) {
            println!("{name}: {:+.2} %", 100.0 * (*now as f64 / before - 1.0));
        }
    }
    Ok(())
}
