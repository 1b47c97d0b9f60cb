//! Machine instructions of one scan, counted by valgrind's callgrind: for changes too small for a noisy clock.
//!
//! `cargo bench -p twinrung-benches --bench instructions -- [--save FILE] [--against FILE]`. Where valgrind is missing it says so
//! and ends well.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::process::Command;

use twinrung_benches::{Result, checked, controller, image};
use twinrung_controller::DualController;
use twinrung_workbench::mix::{Mix, PERIOD_MS, Program, Toggles};

/// What is counted: mix, rungs.
const WORK: [(Mix, usize); 2] = [(Mix::Simple, 1000), (Mix::Plant, 1000)];
/// Scans that are counted, after as many that are not: the first also prescans.
const SCANS: u64 = 25;
/// Callgrind counts only while this function runs: what loading takes differs from run to run, since hash tables are seeded
/// at random, by more than the changes that are looked for.
const COUNTED: &str = "--toggle-collect=*counted_scans*";

fn main() -> Result<()> {
    let arguments: Vec<String> = std::env::args().skip(1).filter(|argument| argument != "--bench").collect();
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    match arguments.as_slice() {
        ["work", mix, rungs] => work(&Program::new(mix.parse()?, rungs.parse()?, 1)),
        [] => count_all().map(|_| ()),
        ["--save", file] => Ok(std::fs::write(file, text(&count_all()?))?),
        ["--against", file] => compare(&std::fs::read_to_string(file)?, &count_all()?),
        // What `cargo test --benches` passes on.
        _ => Ok(()),
    }
}

fn work(program: &Program) -> Result<()> {
    let (image, bytes) = image(&checked("mix.rll", &program.rll())?)?;
    let mut controller = controller(&image, &bytes)?;
    let mut toggles = Toggles::new(&mut controller, 16).ok_or("not a generated program")?;
    for scan in 0..SCANS {
        toggles.before(&mut controller);
        controller.scan((scan * PERIOD_MS) as i64);
    }
    counted_scans(&mut controller, &mut toggles);
    match controller.stopped() {
        Some(reason) => Err(format!("stopped: {reason:?}").into()),
        None => Ok(()),
    }
}

/// A function of its own, so that callgrind finds it by its name.
#[inline(never)]
fn counted_scans(controller: &mut DualController, toggles: &mut Toggles) {
    for scan in SCANS..2 * SCANS {
        toggles.before(controller);
        controller.scan((scan * PERIOD_MS) as i64);
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
        let scans = collected(mix, rungs)? / SCANS;
        println!("scan {mix} {rungs}: {scans} instructions, {:.1} per rung", scans as f64 / rungs as f64);
        counts.insert(format!("{mix}-{rungs}"), scans);
    }
    Ok(counts)
}

fn collected(mix: Mix, rungs: usize) -> Result<u64> {
    let out = tempfile::NamedTempFile::new()?;
    let output = Command::new("valgrind")
        .arg("--tool=callgrind")
        .arg(COUNTED)
        .arg(format!("--callgrind-out-file={}", out.path().display()))
        .arg(std::env::current_exe()?)
        .args(["work", &mix.to_string(), &rungs.to_string()])
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
