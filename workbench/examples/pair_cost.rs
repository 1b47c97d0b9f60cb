//! What both channels and the comparison cost in one thread on a project of the shared mixes: median ns per rung over all scans, with the
//! stimulus of `drive.h` and the hash that every contender ends with.
//!
//! `cargo run --release -p twinrung-workbench --example pair_cost -- PROJECT.rll [SCANS] [TOGGLES]`

use std::path::Path;
use std::time::Instant;

use twinrung_bytecode::admit;
use twinrung_bytecode::index::{BitCell, TagIndex, WordCell};
use twinrung_bytecode::observer::Silent;
use twinrung_compiler::{Completion, check, compile};
use twinrung_controller::{CellRange, DualController, Part, ScanClock};
use twinrung_grammar::read_path;
use twinrung_grammar::tree::Sources;
use twinrung_workbench::{Signal, names};

/// Takes the time at the end of each part.
struct Stopwatch {
    begun: Instant,
    last: Instant,
    parts_ns: [Vec<u64>; 5],
    whole_ns: Vec<u64>,
}

impl ScanClock for Stopwatch {
    fn begin(&mut self) {
        self.begun = Instant::now();
        self.last = self.begun;
    }

    fn ended(&mut self, part: Part) {
        let now = Instant::now();
        self.parts_ns[part as usize].push((now - self.last).as_nanos() as u64);
        if part == Part::Publish {
            self.whole_ns.push((now - self.begun).as_nanos() as u64);
        }
        self.last = now;
    }

    fn expired(&mut self) -> bool {
        false
    }
}

fn median(values: &mut [u64]) -> u64 {
    values.sort_unstable();
    values.get(values.len() / 2).copied().unwrap_or_default()
}

fn fnv(hash: u64, bytes: &[u8]) -> u64 {
    bytes.iter().fold(hash, |hash, byte| (hash ^ u64::from(*byte)).wrapping_mul(1_099_511_628_211))
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let path = arguments.first().ok_or("give a project")?;
    let scans: i64 = arguments.get(1).map_or(Ok(300), |text| text.parse())?;
    let toggles: usize = arguments.get(2).map_or(Ok(16), |text| text.parse())?;
    let mut sources = Sources::new();
    let checked = check(&read_path(&mut sources, Path::new(path)), &Completion::default());
    let project = checked.project.ok_or_else(|| format!("{:?}", checked.findings.first()))?;
    let bytes = compile(&project).map_err(|finding| finding.message)?.bytes;
    let image = admit(&bytes)?;
    let rungs = u64::from(image.rung_counts().iter().sum::<u32>());
    let mut controller = DualController::load(image, &bytes).map_err(|error| error.to_string())?;
    let bits = |controller: &DualController, letter: char| -> Vec<BitCell> {
        (0..)
            .map_while(|index| match names::signal(controller.image(), &format!("{letter}{index}")) {
                Ok(Signal::Bit(cell)) => Some(cell),
                _ => None,
            })
            .collect()
    };
    let (inputs, coils) = (bits(&controller, 'x'), bits(&controller, 'y'));
    let numbers: Vec<WordCell> = (0..)
        .map_while(|index| match names::signal(controller.image(), &format!("n{index}")) {
            Ok(Signal::Word(cell, _)) => Some(cell),
            _ => None,
        })
        .collect();
    let first = inputs.first().ok_or("no inputs")?.0;
    let count = inputs.len() as u32;
    controller.freeze_also(CellRange {
        tag: TagIndex(u32::MAX),
        bit_cell: first,
        bit_cells: count,
        word_cell: 0,
        word_cells: 0,
    });
    controller.power_up_in_run();
    let mut random = 88_172_645_463_325_252_u64;
    let mut values = vec![false; inputs.len()];
    let now = Instant::now();
    let mut stopwatch = Stopwatch { begun: now, last: now, parts_ns: Default::default(), whole_ns: Vec::new() };
    for scan in 0..scans {
        for _ in 0..toggles {
            random ^= random << 13;
            random ^= random >> 7;
            random ^= random << 17;
            let index = ((random >> 20) & 255) as usize;
            values[index] = !values[index];
            controller.drive_bit(inputs[index], values[index]);
        }
        let report = controller.scan_observed(scan * 10, &mut stopwatch, &mut Silent, &mut Silent);
        if let Some(reason) = report.stopped {
            return Err(format!("stopped in scan {scan}: {reason:?}").into());
        }
    }
    let mut hash = 14_695_981_039_346_656_037;
    for cell in coils {
        hash = fnv(hash, &[u8::from(controller.bit(cell).unwrap_or_default())]);
    }
    for cell in numbers {
        hash = fnv(hash, &controller.word(cell).unwrap_or_default().to_le_bytes());
    }
    let per_rung = |ns: u64| ns as f64 / rungs as f64;
    let parts: Vec<String> = Part::ALL
        .iter()
        .map(|part| format!("{part:?} {:.2}", per_rung(median(&mut stopwatch.parts_ns[*part as usize]))))
        .collect();
    let whole = per_rung(median(&mut stopwatch.whole_ns));
    println!("rungs={rungs} p50={whole:.2} ns/rung ({})  yn={hash:016x}", parts.join(", "));
    Ok(())
}
