//! The random walk: programs of several calls, loaded once and run through many epochs, each from a reset of both channels.

use std::collections::BTreeSet;
use std::fmt;

use twinrung_catalog::{Code, CodeWord, Opcode};
use twinrung_contest::Signal;

use super::halves::Halves;
use super::project::program;
use super::shrink::{Log, shrink};
use crate::Subject;
use twinrung_contest::generate::Random;
use twinrung_contest::generate::safety::{Call, Driver, Inputs};

/// Calls of one program: a load costs as much as thousands of scans.
const CALLS: usize = 12;

/// Periods in ms.
const PERIODS_MS: &[u32] = &[1, 10, 10, 10, 100, 3, 7, 16, 20, 33, 50, 250, 499];

/// Differences after which there is nothing new to learn.
const DIFFERENCES: usize = 3;

/// Random executions of one instruction.
#[derive(Debug, Clone, Copy)]
pub struct Walk {
    /// The instruction.
    pub opcode: Opcode,
    /// Everything follows from this.
    pub seed: u64,
    /// Executions at least: calls times scans.
    pub executions: u64,
    /// Scans of each program before another is loaded.
    pub scans: u64,
}

/// What a walk came across.
#[derive(Debug)]
pub struct Walked {
    /// The instruction.
    pub opcode: Opcode,
    /// Executions: calls times scans.
    pub executions: u64,
    /// Programs, each with its own configurations.
    pub programs: u64,
    /// Epochs: both channels were reset and prescanned.
    pub epochs: u64,
    /// Positions of the declared codes that were shown.
    pub reached: BTreeSet<usize>,
    /// Executions with O1 on, or another first output.
    pub active: u64,
    /// The shortest run found for each difference of the two halves.
    pub differences: Vec<String>,
}

impl Walk {
    /// Walks until so many executions are done, or differences show.
    pub fn run(self) -> Walked {
        let (opcode, reached, differences) = (self.opcode, BTreeSet::new(), Vec::new());
        let mut walked = Walked { opcode, executions: 0, programs: 0, epochs: 0, reached, active: 0, differences };
        let mut random = Random::new(self.seed ^ (self.opcode as u64) << 32);
        while walked.executions < self.executions && walked.differences.len() < DIFFERENCES {
            self.program(random.bits(), &mut walked);
        }
        walked
    }

    fn program(self, seed: u64, walked: &mut Walked) {
        let random = &mut Random::new(seed);
        let instruction = self.opcode.instruction();
        let calls: Vec<Call> = (0..CALLS).map(|_| Call::random(random, instruction)).collect();
        let text = program(&calls);
        let subject = Subject::from_text(&text).unwrap_or_else(|errors| panic!("{errors:#?}\n{text}"));
        let mut halves = Halves::new(&subject, &calls);
        walked.programs += 1;
        let mut scans = 0;
        while scans < self.scans {
            let epoch = random.bits();
            let mut codes = Codes::new(instruction.safety.map_or(&[][..], |safety| safety.codes), &halves, calls.len());
            let run = run_epoch(&mut halves, &calls, epoch, None, Some(&mut codes));
            walked.epochs += 1;
            scans += run.scans;
            walked.executions += run.scans * CALLS as u64;
            walked.active += run.active;
            walked.reached.extend(codes.reached);
            if let Some(call) = run.differing {
                let mut log = Log::default();
                run_epoch(&mut halves, &calls, epoch, Some((call, &mut log)), None);
                walked.differences.push(shrink(&calls[call], log));
                return;
            }
        }
    }
}

struct Epoch {
    scans: u64,
    active: u64,
    differing: Option<usize>,
}

/// One epoch: determined by its seed, so that it can be run again with a log.
fn run_epoch(
    halves: &mut Halves,
    calls: &[Call],
    seed: u64,
    mut log: Option<(usize, &mut Log)>,
    mut codes: Option<&mut Codes>,
) -> Epoch {
    let random = &mut Random::new(seed);
    let longest = calls.iter().map(Call::longest_period_ms).min().unwrap_or(500);
    let admitted: Vec<u32> = PERIODS_MS.iter().copied().filter(|period| *period <= longest).collect();
    let period_ms = i64::from(*random.of(&admitted));
    let mut drivers: Vec<Driver> = calls.iter().map(|call| Driver::new(call, period_ms)).collect();
    let is_uneven = random.percent(4);
    let mut now_ms = if random.percent(50) { 0 } else { (random.bits() >> 24) as i64 };
    let mut epoch = Epoch { scans: 0, active: 0, differing: None };
    let length = random.between(200, 2_500);
    let outputs: Vec<Option<Signal>> = (0..calls.len()).map(|call| halves.member(call, "O1")).collect();
    halves.reset();
    for scan in 0..length {
        for (number, driver) in drivers.iter_mut().enumerate() {
            driver.advance(random, now_ms);
            let Inputs { rung, operands } = &driver.inputs;
            halves.set_rung(number, *rung);
            operands.iter().enumerate().for_each(|(index, value)| halves.set_operand(number, index, *value));
        }
        let prescan = scan == 0 || random.one_in(400);
        if let Some((call, log)) = &mut log {
            log.push(now_ms, prescan, drivers[*call].inputs.clone());
        }
        if prescan {
            halves.prescan(now_ms);
        }
        epoch.differing = halves.differing();
        if epoch.differing.is_none() {
            halves.scan(now_ms);
            epoch.scans += 1;
            epoch.differing = halves.differing();
        }
        if epoch.differing.is_some() {
            return epoch;
        }
        for (driver, signal) in drivers.iter_mut().zip(&outputs) {
            let output = signal.map_or(0, |signal| halves.read(signal));
            driver.observe(random, output, now_ms);
            epoch.active += u64::from(output != 0);
        }
        if let Some(codes) = &mut codes {
            codes.look(halves);
        }
        now_ms += match random.below(20_000) {
            0 => random.below(4_000_000) as i64,
            1..=5 => random.below(10_000) as i64,
            _ if is_uneven => (period_ms + random.below(3) as i64 - 1).max(0),
            _ => period_ms,
        };
    }
    epoch
}

/// Which declared codes the calls have shown.
struct Codes {
    declared: &'static [Code],
    /// The words and flags that show codes, with the value that was seen last.
    words: Vec<(&'static str, Signal, i32)>,
    reached: BTreeSet<usize>,
}

fn word(code: &Code) -> &'static str {
    match code.word {
        CodeWord::Fault => "FaultCode",
        CodeWord::Diagnostic => "DiagnosticCode",
        CodeWord::Flag(member) => member,
    }
}

impl Codes {
    fn new(declared: &'static [Code], halves: &Halves, calls: usize) -> Codes {
        let mut names: Vec<&'static str> = declared.iter().map(word).collect();
        names.sort_unstable();
        names.dedup();
        let of = |call: usize| {
            let found = |name: &&'static str| halves.member(call, name).map(|signal| (*name, signal, 0));
            names.iter().filter_map(found).collect::<Vec<_>>()
        };
        Codes { declared, words: (0..calls).flat_map(of).collect(), reached: BTreeSet::new() }
    }

    fn look(&mut self, halves: &Halves) {
        for (name, signal, last) in &mut self.words {
            let value = halves.read(*signal);
            if value != *last {
                *last = value;
                let shown = |code: &Code| word(code) == *name && code.value == value;
                self.reached.extend(self.declared.iter().position(shown));
            }
        }
    }
}

impl Walked {
    /// The declared codes that were not shown.
    pub fn missed(&self) -> Vec<&'static Code> {
        let declared = self.opcode.instruction().safety.map_or(&[][..], |safety| safety.codes);
        declared.iter().enumerate().filter(|(at, _)| !self.reached.contains(at)).map(|(_, code)| code).collect()
    }
}

impl fmt::Display for Walked {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let missed = self.missed();
        let declared = self.reached.len() + missed.len();
        let words: Vec<String> = missed.iter().map(|code| format!("{} 16#{:X}", word(code), code.value)).collect();
        write!(
            f,
            "{:<6} {:>9} executions, {:>5} programs, {:>6} epochs, O1 on in {:>2} %, codes {}/{declared}{}{}, {} differences",
            self.opcode.instruction().mnemonic,
            self.executions,
            self.programs,
            self.epochs,
            self.active * 100 / self.executions.max(1),
            self.reached.len(),
            if words.is_empty() { "" } else { " without " },
            words.join(" "),
            self.differences.len()
        )
    }
}
