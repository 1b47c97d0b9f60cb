//! Random executions of the safety application instructions on both halves of the library.
//!
//! `cargo run --release -p twinrung-trio --example random_instructions -- --executions 1000000`
//!
//! `--instruction DCS` for one of them, `--seed N` for other numbers, `--scans N` scans of each loaded program.

use std::process::ExitCode;
use std::time::Instant;

use twinrung_catalog::{Instruction, Opcode};
use twinrung_trio::instructions::Walk;

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().collect();
    let word = |name: &str| {
        let at = arguments.iter().position(|one| one == name);
        at.and_then(|at| arguments.get(at + 1))
    };
    let number = |name: &str, otherwise: u64| word(name).and_then(|text| text.parse().ok()).unwrap_or(otherwise);
    let all = Opcode::ALL.iter().copied().filter(|opcode| opcode.instruction().safety.is_some());
    let chosen: Vec<Opcode> = match word("--instruction") {
        None => all.collect(),
        Some(mnemonic) => match Instruction::by_mnemonic(mnemonic).filter(|one| one.safety.is_some()) {
            Some(instruction) => vec![instruction.opcode],
            None => {
                eprintln!("{mnemonic} is no safety application instruction");
                return ExitCode::FAILURE;
            }
        },
    };
    let (seed, executions, scans) = (number("--seed", 1), number("--executions", 1_000_000), number("--scans", 12_000));
    let mut differences = 0;
    for opcode in chosen {
        let begun = Instant::now();
        let walked = Walk { opcode, seed, executions, scans }.run();
        println!("{walked}, {:.1} s", begun.elapsed().as_secs_f64());
        walked.differences.iter().for_each(|difference| println!("{difference}"));
        differences += walked.differences.len();
    }
    if differences == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}
