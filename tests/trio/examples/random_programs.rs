//! Runs random programs on primary, partner and judge until the time is up.
//!
//! `cargo run --release -p twinrung-trio --example random_programs -- --seed 1 --minutes 10`

use std::collections::BTreeMap;
use std::process::ExitCode;
use std::time::{Duration, Instant};

use twinrung_trio::generate::{self, Size};
use twinrung_trio::{Counts, Outcome, replay, shrink};

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().collect();
    let number = |name: &str, otherwise: f64| -> f64 {
        let at = arguments.iter().position(|one| one == name);
        at.and_then(|at| arguments.get(at + 1)).and_then(|text| text.parse().ok()).unwrap_or(otherwise)
    };
    let first = number("--seed", 1.0) as u64;
    let until = Instant::now() + Duration::from_secs_f64(number("--minutes", 1.0) * 60.0);
    let scans = number("--scans", 120.0) as usize;
    let most_failures = number("--failures", 5.0) as usize;
    let only_print = arguments.iter().any(|one| one == "--print");
    // Panics of the evaluators are findings and are reported as such.
    std::panic::set_hook(Box::new(|_| {}));
    let (mut programs, mut refused, mut failures, mut rung_executions) = (0u64, 0u64, 0usize, 0u64);
    let mut total = Counts::default();
    let mut reasons: BTreeMap<String, (u64, u64)> = BTreeMap::new();
    let mut seed = first;
    while Instant::now() < until && failures < most_failures {
        let size = if seed % 4 == 0 { Size::LARGE } else { Size::SMALL };
        let generated = generate::program(seed, size);
        let stimulus = generate::stimulus(seed, &generated, scans);
        if only_print {
            println!("{}", generated.text);
            return ExitCode::SUCCESS;
        }
        programs += 1;
        match replay(&generated.text, &stimulus) {
            Outcome::Agreed(counts) => {
                total.scans += counts.scans;
                total.faulted += counts.faulted;
                total.over_budget += counts.over_budget;
                total.cleared += counts.cleared;
                total.instructions += counts.instructions;
                rung_executions += counts.scans * generated.rungs() as u64;
            }
            Outcome::Refused(findings) => {
                refused += 1;
                for finding in findings.iter().take(1) {
                    reasons.entry(finding.clone()).or_insert((0, seed)).0 += 1;
                }
            }
            Outcome::Failed { report, steps } => {
                failures += 1;
                println!("seed {seed}, step {steps}: {report}");
                let (text, stimulus, report) = shrink(&generated, &stimulus);
                println!("shrunk:\n{text}\nbudget {}", stimulus.budget);
                for step in &stimulus.steps {
                    println!("  {} {} ms {:?}", if step.prescan { "prescan" } else { "scan" }, step.now_ms, step.values);
                }
                println!("{report}");
            }
        }
        seed += 1;
    }
    for (reason, (count, seed)) in reasons.iter().take(40) {
        println!("refused {count} (seed {seed}): {reason}");
    }
    println!(
        "seeds {first} to {}: {programs} programs, {refused} refused, {} scans ({} faulted, {} over budget, {} faults cleared), \
         {} instructions, {rung_executions} rung executions, {failures} failures",
        seed - 1,
        total.scans,
        total.faulted,
        total.over_budget,
        total.cleared,
        total.instructions
    );
    if failures == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}
