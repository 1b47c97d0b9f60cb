//! A compiled routine on primary, partner and judge, its data moved at random.

use twinrung_catalog::Element;
use twinrung_trio::{Ended, Subject, Trio};
use twinrung_workbench::generate::{Random, any_value};
use twinrung_workbench::{Signal, Value};

/// Scans of each routine.
const SCANS: i64 = 40;

/// Values that are moved before each scan.
const MOVED: usize = 12;

/// Members whose random values would make nearly every scan end with a fault.
const KEPT: &[&str] = &[".PRE", ".ACC", ".LEN", ".POS"];

/// What a run amounted to.
#[derive(Debug, Clone, Copy, Default)]
pub struct Ran {
    /// Scans, the prescan aside.
    pub scans: u64,
    /// Those that a major fault ended: a random subscript out of range, a negative preset.
    pub faulted: u64,
    /// Instructions that each evaluator executed.
    pub instructions: u64,
}

/// Runs some scans. Panics at the first difference.
pub fn scans(subject: &Subject, name: &str) -> Ran {
    let mut random = Random::new(name.bytes().fold(7, |seed, byte| seed * 31 % 1_000_003 + u64::from(byte)));
    let mut trio = Trio::new(subject);
    let mut signals = trio.signals();
    signals.retain(|(name, _)| !KEPT.iter().any(|member| name.ends_with(member)));
    let mut ran = Ran::default();
    trio.prescan(0).unwrap_or_else(|error| panic!("{name}: {error}"));
    for scan in 1..=SCANS {
        for _ in 0..MOVED.min(signals.len()) {
            let signal = random.of(&signals).1;
            move_one(&mut trio, signal, &mut random);
        }
        let ended = trio.scan(scan * 10).unwrap_or_else(|error| panic!("{name}: {error}"));
        ran.scans += 1;
        ran.faulted += u64::from(ended != Ended::Completed);
    }
    ran.instructions = trio.executed();
    ran
}

/// Subscripts and steps are small numbers, so most integers are.
fn move_one(trio: &mut Trio<'_>, signal: Signal, random: &mut Random) {
    let value = |random: &mut Random, element: Element| match any_value(random, element) {
        Value::Integer(value) if random.percent(70) => Value::Integer(value.rem_euclid(8)),
        value => value,
    };
    match signal {
        Signal::Bit(cell) => trio.set_bit(cell, random.percent(50)),
        Signal::Word(cell, element) => match value(random, element) {
            Value::Real(value) => trio.set_word(cell, value.to_bits() as i32),
            Value::Integer(value) => trio.set_word(cell, value),
            Value::Bool(_) => {}
        },
        _ => {}
    }
}
