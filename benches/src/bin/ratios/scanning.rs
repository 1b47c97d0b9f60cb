//! Scans: against C, against their own data, against their size.

use twinrung_benches::{Inputs, Result, Timing, checked, image, median, timed};
use twinrung_bytecode::AdmittedImage;
use twinrung_controller::Partner;
use twinrung_workbench::mix::{Mix, Program};

use crate::options::Options;
use crate::reference::{self, Reference};
use crate::table;

/// A generated program, compiled.
pub struct Generated {
    /// What a loader makes of its bytes.
    pub image: AdmittedImage,
    /// The sealed bytes.
    pub bytes: Vec<u8>,
    /// The text.
    pub rll: String,
}

/// Generates and compiles.
pub fn generated(mix: Mix, rungs: usize, seed: u64) -> Result<Generated> {
    let rll = Program::new(mix, rungs, seed).rll();
    let (image, bytes) = image(&checked("mix.rll", &rll)?)?;
    Ok(Generated { image, bytes, rll })
}

fn seeds(options: &Options, mix: Mix) -> Vec<u64> {
    match mix {
        Mix::Simple => options.seeds.iter().copied().take(1).collect(),
        Mix::Plant => options.seeds.clone(),
    }
}

/// Both channels and the comparison in one thread, against the direct-threaded interpreter in C doing the work once.
pub fn against_c(options: &Options) -> Result<()> {
    let Some(shared) = reference::folder() else {
        println!("Skipped: ../shared/bench is not here, and with it the C renderings.\n");
        return Ok(());
    };
    for (mix, limit) in [(Mix::Simple, 1.0), (Mix::Plant, 0.5)] {
        table::begin(
            &format!("Mix `{mix}`, ns per rung, medians of {} paired runs of {} scans", options.pairs, options.scans),
            &[
                "rungs",
                "seed",
                "C, direct-threaded, once",
                "both + comparison",
                "primary",
                "partner",
                "comparison",
                "ratio",
                "hash",
            ],
        );
        let mut medians = Vec::new();
        for rungs in options.rungs.iter().copied() {
            for seed in seeds(options, mix) {
                let program = generated(mix, rungs, seed)?;
                let reference = Reference::new(&shared, mix, rungs, seed, &program.rll)?;
                let mut runs = Vec::new();
                for _ in 0..options.pairs {
                    let c = reference.run(options.scans)?;
                    let own = timed::<Partner>(&program.image, &program.bytes, options.scans, Inputs::Toggled(16))?;
                    if c.hash != own.hash {
                        return Err(format!(
                            "{mix}, {rungs} rungs, seed {seed}: C ends with {:016x}, the channels with {:016x}",
                            c.hash, own.hash
                        )
                        .into());
                    }
                    runs.push((c, own));
                }
                let per_rung = |of: fn(&Timing) -> u64| {
                    median(runs.iter().map(|(_, own)| of(own) as f64 / rungs as f64).collect())
                };
                let ratios: Vec<f64> =
                    runs.iter().map(|(c, own)| own.scan_ns as f64 / rungs as f64 / c.ns_per_rung).collect();
                medians.push(median(ratios.clone()));
                table::row(&[
                    rungs.to_string(),
                    seed.to_string(),
                    format!("{:.2}", median(runs.iter().map(|(c, _)| c.ns_per_rung).collect())),
                    format!("{:.2}", per_rung(|own| own.scan_ns)),
                    format!("{:.2}", per_rung(|own| own.parts_ns[1])),
                    format!("{:.2}", per_rung(|own| own.parts_ns[2])),
                    format!("{:.2}", per_rung(|own| own.parts_ns[3])),
                    table::spread(&ratios),
                    "equal".to_owned(),
                ]);
            }
        }
        table::end(Some((limit, &medians)));
    }
    Ok(())
}

/// Every input drawn anew before each scan, against no input changing.
pub fn data_dependence(options: &Options) -> Result<()> {
    table::begin(
        &format!("Every input redrawn each scan against none changing, {} pairs", options.pairs),
        &["mix", "rungs", "none changing, ns per rung", "all redrawn, ns per rung", "ratio"],
    );
    let mut medians = Vec::new();
    for mix in [Mix::Simple, Mix::Plant] {
        for rungs in options.rungs.iter().copied() {
            let program = generated(mix, rungs, options.seeds[0])?;
            let mut runs = Vec::new();
            for _ in 0..options.pairs {
                let still = timed::<Partner>(&program.image, &program.bytes, options.scans, Inputs::Toggled(0))?;
                let moved = timed::<Partner>(&program.image, &program.bytes, options.scans, Inputs::Redrawn)?;
                runs.push((still.scan_ns as f64 / rungs as f64, moved.scan_ns as f64 / rungs as f64));
            }
            let ratios: Vec<f64> = runs.iter().map(|(still, moved)| moved / still).collect();
            medians.push(median(ratios.clone()));
            table::row(&[
                mix.to_string(),
                rungs.to_string(),
                format!("{:.2}", median(runs.iter().map(|(still, _)| *still).collect())),
                format!("{:.2}", median(runs.iter().map(|(_, moved)| *moved).collect())),
                table::spread(&ratios),
            ]);
        }
    }
    table::end(Some((1.15, &medians)));
    Ok(())
}

/// Cost per rung of a large program against that of one with 1,000 rungs.
pub fn size_dependence(options: &Options) -> Result<()> {
    const SMALL: usize = 1000;
    table::begin(
        &format!("Cost per rung at {} rungs against {SMALL}, {} pairs", options.large, options.pairs),
        &["mix", "small, ns per rung", "large, ns per rung", "ratio"],
    );
    let mut medians = Vec::new();
    // A scan of the large program takes a hundred times as long: fewer of them say as much.
    let scans = (options.scans / 5).max(20);
    for mix in [Mix::Simple, Mix::Plant] {
        let small = generated(mix, SMALL, options.seeds[0])?;
        let large = generated(mix, options.large, options.seeds[0])?;
        let mut runs = Vec::new();
        for _ in 0..options.pairs {
            let a = timed::<Partner>(&small.image, &small.bytes, options.scans, Inputs::Toggled(16))?;
            let b = timed::<Partner>(&large.image, &large.bytes, scans, Inputs::Toggled(16))?;
            runs.push((a.scan_ns as f64 / SMALL as f64, b.scan_ns as f64 / options.large as f64));
        }
        let ratios: Vec<f64> = runs.iter().map(|(small, large)| large / small).collect();
        medians.push(median(ratios.clone()));
        table::row(&[
            mix.to_string(),
            format!("{:.2}", median(runs.iter().map(|(small, _)| *small).collect())),
            format!("{:.2}", median(runs.iter().map(|(_, large)| *large).collect())),
            table::spread(&ratios),
        ]);
    }
    table::end(Some((1.5, &medians)));
    Ok(())
}
