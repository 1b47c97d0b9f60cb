//! Both channels on two threads against both on one: from which size on it pays.

use std::sync::atomic::{AtomicU32, Ordering};
use std::time::Instant;

use twinrung_benches::{Inputs, Result, median, timed};
use twinrung_controller::{Part, Partner};
use twinrung_workbench::OnThread;
use twinrung_workbench::mix::Mix;

use crate::options::Options;
use crate::scanning::generated;
use crate::table;

/// The sizes that are compared.
const RUNGS: [usize; 6] = [100, 300, 1000, 3000, 10_000, 100_000];
/// Rungs that a run executes in all its scans, within bounds: the medians of small programs need more scans than those of large ones.
const RUNGS_IN_ALL: usize = 2_000_000;
const SCANS: std::ops::RangeInclusive<usize> = 60..=5000;

/// Hand-overs that are timed.
const ROUNDS: u32 = 100_000;

/// How long it takes from one thread to another and back, in ns, by a number that both write in turn: the mean of many. It
/// says how far apart the processors are that the two threads are on, and what two threads cost follows from that.
fn round_trip_ns() -> u128 {
    let turn = AtomicU32::new(0);
    let wait_for = |number| {
        while turn.load(Ordering::Acquire) != number {
            std::hint::spin_loop();
        }
    };
    std::thread::scope(|scope| {
        scope.spawn(|| {
            for round in 0..ROUNDS {
                wait_for(2 * round + 1);
                turn.store(2 * round + 2, Ordering::Release);
            }
        });
        let begun = Instant::now();
        for round in 0..ROUNDS {
            turn.store(2 * round + 1, Ordering::Release);
            wait_for(2 * round + 2);
        }
        begun.elapsed().as_nanos() / u128::from(ROUNDS)
    })
}

/// The figure for when two threads pay.
pub fn on_two(options: &Options) -> Result<()> {
    let before = round_trip_ns();
    table::begin(
        &format!("Both channels on two threads against one, {} pairs", options.pairs),
        &[
            "mix",
            "rungs",
            "one thread, us per scan",
            "two threads, us per scan",
            "primary",
            "wait for the partner",
            "comparison",
            "ratio",
            "hash",
        ],
    );
    let mut from = Vec::new();
    for mix in [Mix::Simple, Mix::Plant] {
        // The least size from which on every ratio is below 1.
        let mut pays_from = None;
        for rungs in RUNGS {
            let program = generated(mix, rungs, options.seeds[0])?;
            let scans = (RUNGS_IN_ALL / rungs).clamp(*SCANS.start(), *SCANS.end()) as u64;
            let mut runs = Vec::new();
            for _ in 0..options.pairs {
                let one = timed::<Partner>(&program.image, &program.bytes, scans, Inputs::Toggled(16))?;
                let two = timed::<OnThread<Partner>>(&program.image, &program.bytes, scans, Inputs::Toggled(16))?;
                if one.hash != two.hash {
                    return Err(format!(
                        "{mix}, {rungs} rungs: one thread ends with {:016x}, two with {:016x}",
                        one.hash, two.hash
                    )
                    .into());
                }
                runs.push((one, two));
            }
            let us = |of: &dyn Fn(&(_, _)) -> u64| {
                format!("{:.2}", median(runs.iter().map(of).collect::<Vec<u64>>()) as f64 / 1e3)
            };
            let part = |part: Part| us(&|(_, two)| two.parts_ns[part as usize]);
            let ratios: Vec<f64> = runs.iter().map(|(one, two)| two.scan_ns as f64 / one.scan_ns as f64).collect();
            pays_from = if median(ratios.clone()) < 1.0 { pays_from.or(Some(rungs)) } else { None };
            table::row(&[
                mix.to_string(),
                rungs.to_string(),
                us(&|(one, _)| one.scan_ns),
                us(&|(_, two)| two.scan_ns),
                part(Part::Primary),
                part(Part::Partner),
                part(Part::Compare),
                table::spread(&ratios),
                "equal".to_owned(),
            ]);
        }
        from.push((mix, pays_from));
    }
    table::end(None);
    println!("From one thread to the other and back: {before} ns before, {} ns after.\n", round_trip_ns());
    for (mix, rungs) in from {
        match rungs {
            Some(rungs) => println!("`{mix}`: two threads pay from {rungs} rungs on.\n"),
            None => println!("`{mix}`: two threads do not pay at {} rungs.\n", RUNGS[RUNGS.len() - 1]),
        }
    }
    Ok(())
}
