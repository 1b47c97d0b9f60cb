//! The shared mixes, timed: `cargo test --release -p twinrung-primary mix -- --ignored --nocapture`, with the folder of
//! `gen.py`'s output in MIX.

extern crate std;

use std::println;
use std::string::String;
use std::time::Instant;
use std::vec::Vec;

use twinrung_bytecode::channel::{Channel, ScanInputs};
use twinrung_bytecode::index::BitCell;
use twinrung_bytecode::observer::Silent;

use super::assembler::Assembler;

#[test]
#[ignore = "a measurement"]
fn mix_when_scanned_then_timed() {
    let folder = std::env::var("MIX").expect("MIX");
    let text = std::fs::read_to_string(std::format!("{folder}/project.rll")).expect("project.rll");
    let mut assembler = Assembler::new();
    let mut rungs: Vec<&str> = Vec::new();
    for line in text.lines().map(str::trim) {
        if let Some(rung) = line.strip_prefix("N: ") {
            rungs.push(rung);
        } else if let Some((name, declared)) = line.split_once(" : ") {
            assembler.tag(name, declared.split_whitespace().next().expect("a type"));
        }
    }
    assembler.main(&rungs);
    for rung in &rungs {
        for (at, _) in rung.match_indices("TON(") {
            let operands: Vec<&str> = rung[at + 4..].split(')').next().expect("operands").split(',').collect();
            let super::assembler::Cell::Word(cell) = assembler.cell(&std::format!("{}.PRE", operands[0])) else {
                panic!("PRE")
            };
            assembler.image.initial_words[cell as usize] = operands[1].parse().expect("a preset");
        }
    }
    let begin = Instant::now();
    let mut primary = assembler.build();
    println!("load {:?}", begin.elapsed());
    let tables = &primary.program.tables;
    println!(
        "runs {} gates {} timers {} compares {} arithmetic {} general {} bank {}",
        tables.runs.len(),
        tables.narrow.len() + tables.wide.len(),
        tables.timers.len(),
        tables.compares.len(),
        tables.arithmetic.len(),
        tables.general.len(),
        primary.machine.bits.len()
    );
    let rows = std::fs::read_to_string(std::format!("{folder}/stimulus.csv")).expect("stimulus.csv");
    let rows: Vec<Vec<bool>> =
        rows.lines().skip(1).map(|row| row.split(',').skip(1).map(|cell| cell == "1").collect()).collect();
    let inputs = |now_ms| ScanInputs { now_ms, budget: u64::MAX, system_values: &[] };
    let mut best: Vec<f64> = Vec::new();
    for round in 0..5 {
        primary.reset();
        primary.prescan(inputs(0), &mut Silent);
        let mut times: Vec<f64> = Vec::new();
        for (scan, row) in rows.iter().enumerate() {
            for (cell, value) in row.iter().enumerate() {
                primary.set_bit(BitCell(cell as u32), *value);
            }
            let begin = Instant::now();
            primary.scan(inputs(scan as i64 * 10), &mut Silent);
            times.push(begin.elapsed().as_nanos() as f64);
        }
        times.sort_by(f64::total_cmp);
        best.push(times[times.len() / 2] / rungs.len() as f64);
        if round == 0 {
            println!("yn {:016x}", hash(&mut assembler, &primary, rungs.len()));
        }
    }
    println!("p50 ns per rung {best:.2?}");
}

fn hash(assembler: &mut Assembler, primary: &crate::Primary, rungs: usize) -> u64 {
    let mut hash = 14_695_981_039_346_656_037u64;
    let mut add = |byte: u8| {
        hash ^= u64::from(byte);
        hash = hash.wrapping_mul(1_099_511_628_211);
    };
    let cell = |assembler: &mut Assembler, name: String| match assembler.cell(&name) {
        super::assembler::Cell::Bit(cell) | super::assembler::Cell::Word(cell) => cell as usize,
    };
    for rung in 0..rungs {
        let cell = cell(assembler, std::format!("y{rung}"));
        add(primary.bits()[cell]);
    }
    for number in 0..rungs / 5 {
        let cell = cell(assembler, std::format!("n{number}"));
        for byte in primary.words()[cell].to_le_bytes() {
            add(byte);
        }
    }
    hash
}
