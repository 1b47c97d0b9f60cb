//! Runs random programs on primary, partner and judge until the time is up, or so many rungs were executed.
//!
//! `cargo run --release -p twinrung-trio --example random_programs -- --seed 1 --executions 100000000`
//!
//! `--minutes N` instead of `--executions N`, `--scans N` scans of each program, `--rungs N` rungs of a main routine,
//! `--failures N` to stop after so many, `--print` to print the program of the seed.

use std::process::ExitCode;
use std::time::{Duration, Instant};

use twinrung_trio::Trios;
use twinrung_workbench::fuzz::{Campaign, size_of};
use twinrung_workbench::generate::{self, Size};

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().collect();
    let number = |name: &str, otherwise: f64| -> f64 {
        let at = arguments.iter().position(|one| one == name);
        at.and_then(|at| arguments.get(at + 1)).and_then(|text| text.parse().ok()).unwrap_or(otherwise)
    };
    let first = number("--seed", 1.0) as u64;
    let begun = Instant::now();
    let executions = number("--executions", f64::INFINITY);
    let otherwise = if executions.is_finite() { 1e6 } else { 1.0 };
    let longest = Duration::from_secs_f64(number("--minutes", otherwise) * 60.0);
    let scans = number("--scans", 500.0) as usize;
    let rungs = number("--rungs", 0.0) as usize;
    let most_failures = number("--failures", 5.0) as usize;
    let size = |seed: u64| match rungs {
        0 => size_of(seed),
        rungs => Size::of_rungs(rungs),
    };
    if arguments.iter().any(|one| one == "--print") {
        println!("{}", generate::program(first, size(first)).text);
        return ExitCode::SUCCESS;
    }
    // Panics of the evaluators are caught, shrunk and reported with the disagreements.
    std::panic::set_hook(Box::new(|_| {}));
    let mut campaign = Campaign::default();
    let (mut seed, mut shown) = (first, 0);
    while begun.elapsed() < longest
        && (campaign.total.executions.rungs as f64) < executions
        && campaign.failures.len() < most_failures
    {
        campaign.run::<Trios>(seed, size(seed), scans);
        for failure in &campaign.failures[shown..] {
            println!("{failure}");
        }
        shown = campaign.failures.len();
        seed += 1;
    }
    for (reason, (count, seed)) in &campaign.reasons {
        println!("refused {count} (seed {seed}): {reason}");
    }
    print!("{}", campaign.total.executions.coverage);
    println!("seeds {first} to {}: {campaign}", seed.saturating_sub(1));
    let seconds = begun.elapsed().as_secs_f64();
    println!("{:.0} rung executions in a second, {seconds:.0} s", campaign.total.executions.rungs as f64 / seconds);
    if campaign.failures.is_empty() { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}
