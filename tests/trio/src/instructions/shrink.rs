//! The shortest run on which the two halves still differ, as lines of a vector.

use std::fmt::Write;

use twinrung_contest::generate::safety::{Call, Given, Inputs, value_text};

use super::halves::Halves;
use super::project::program;
use crate::Subject;

/// The inputs of one call, scan by scan.
#[derive(Debug, Clone, Default)]
pub struct Log {
    scans: Vec<Scan>,
}

#[derive(Debug, Clone)]
struct Scan {
    now_ms: i64,
    prescan: bool,
    inputs: Inputs,
}

impl Log {
    /// Adds a scan.
    pub fn push(&mut self, now_ms: i64, prescan: bool, inputs: Inputs) {
        self.scans.push(Scan { now_ms, prescan, inputs });
    }
}

/// Scans until the halves differ; nothing when they do not.
fn replay(halves: &mut Halves, log: &Log) -> Option<usize> {
    halves.reset();
    for (at, scan) in log.scans.iter().enumerate() {
        halves.set_rung(0, scan.inputs.rung);
        scan.inputs.operands.iter().enumerate().for_each(|(index, value)| halves.set_operand(0, index, *value));
        if scan.prescan || at == 0 {
            halves.prescan(scan.now_ms);
            if halves.differing().is_some() {
                return Some(at);
            }
        }
        halves.scan(scan.now_ms);
        if halves.differing().is_some() {
            return Some(at);
        }
    }
    None
}

/// Runs the call alone, takes away what is not needed, and tells what is left.
pub fn shrink(call: &Call, mut log: Log) -> String {
    let text = program(std::slice::from_ref(call));
    let subject = Subject::from_text(&text).unwrap_or_else(|errors| panic!("{errors:#?}\n{text}"));
    let mut halves = Halves::new(&subject, std::slice::from_ref(call));
    let Some(at) = replay(&mut halves, &log) else {
        return format!("{}: differs only beside other calls", call.instruction.mnemonic);
    };
    log.scans.truncate(at + 1);
    let mut attempt = |log: &mut Log, smaller: Log| match replay(&mut halves, &smaller) {
        Some(at) => {
            *log = smaller;
            log.scans.truncate(at + 1);
            true
        }
        None => false,
    };
    // Scans at the beginning, many at once first.
    let mut count = log.scans.len() / 2;
    while count > 0 {
        let kept = Log { scans: log.scans[count.min(log.scans.len() - 1)..].to_vec() };
        if !attempt(&mut log, kept) {
            count /= 2;
        }
        count = count.min(log.scans.len() / 2);
    }
    // Prescans.
    for at in 1..log.scans.len() {
        if log.scans.get(at).is_some_and(|scan| scan.prescan) {
            let mut fewer = log.clone();
            fewer.scans[at].prescan = false;
            attempt(&mut log, fewer);
        }
    }
    // Changes: from each on, the value before it is kept until the next one.
    for pass in 0..2 {
        for index in 0..=call.operands.len() {
            let mut at = log.scans.len();
            while at > 1 {
                at -= 1;
                if at < log.scans.len() && value(&log, at, index) != value(&log, at - 1, index) {
                    let same = kept(&log, at, index, pass == 1);
                    attempt(&mut log, same);
                }
            }
        }
    }
    replay(&mut halves, &log);
    told(call, &log, &halves)
}

fn value(log: &Log, at: usize, index: usize) -> i32 {
    let inputs = &log.scans[at].inputs;
    inputs.operands.get(index).copied().unwrap_or(i32::from(inputs.rung))
}

/// The log with the change at a scan taken back; with `to_the_end`, and every later one of the same operand.
fn kept(log: &Log, at: usize, index: usize, to_the_end: bool) -> Log {
    let (before, changed) = (value(log, at - 1, index), value(log, at, index));
    let mut smaller = log.clone();
    for scan in &mut smaller.scans[at..] {
        let inputs = &mut scan.inputs;
        let current = inputs.operands.get(index).copied().unwrap_or(i32::from(inputs.rung));
        if current != changed && !to_the_end {
            break;
        }
        match inputs.operands.get_mut(index) {
            Some(place) => *place = before,
            None => inputs.rung = before != 0,
        }
    }
    smaller
}

fn told(call: &Call, log: &Log, halves: &Halves) -> String {
    let start = log.scans.first().map_or(0, |scan| scan.now_ms);
    let mut text = format!("{}\nconfig{}\n", call.instruction.mnemonic, call.configuration());
    let mut before: Option<&Scan> = None;
    for scan in &log.scans {
        let mut words = String::new();
        if scan.prescan && before.is_some() {
            words.push_str(" prescan");
        }
        if before.map_or(!scan.inputs.rung, |one| one.inputs.rung != scan.inputs.rung) {
            let _ = write!(words, " rung={}", i32::from(scan.inputs.rung));
        }
        for (index, value) in scan.inputs.operands.iter().enumerate() {
            let known = before.map_or(0, |one| one.inputs.operands[index]);
            if *value != known && call.operands[index] == Given::Tag {
                let _ = write!(words, " {}={}", call.member(index), value_text(call.kind(index), *value));
            }
        }
        if !words.is_empty() {
            let _ = writeln!(text, "{:<6}{words}", scan.now_ms - start);
        }
        before = Some(scan);
    }
    let steps: Vec<i64> = log.scans.windows(2).map(|pair| pair[1].now_ms - pair[0].now_ms).collect();
    let (least, greatest) = (steps.iter().min().copied().unwrap_or(0), steps.iter().max().copied().unwrap_or(0));
    let end = log.scans.last().map_or(0, |scan| scan.now_ms) - start;
    let _ = writeln!(text, "{} scans, {least} to {greatest} ms apart; at {end} ms:", log.scans.len());
    for (name, primary, partner) in halves.differences(0) {
        let _ = writeln!(text, "  {name}: primary {primary} (16#{primary:X}), partner {partner} (16#{partner:X})");
    }
    text
}
