//! What each instruction costs on this machine, measured, and from it a time for the bound: an estimate.
//!
//! The cost of an instruction is what a rung with it takes longer than the same rung without it, on both channels and in
//! the comparison, in the worse of two scans: with all rungs true and with all rungs false. What the interpreters gain by
//! looking at several instructions at once, and what they lose when a program does not fit the caches, is not in it.

use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};
use std::time::Duration;

use serde::Serialize;
use twinrung_bytecode::bound::{self, Bound, Work};
use twinrung_bytecode::index::BitCell;
use twinrung_bytecode::observer::Silent;
use twinrung_bytecode::{AdmittedImage, admit};
use twinrung_catalog::Opcode;
use twinrung_compiler::{Completion, check, compile};
use twinrung_controller::DualController;
use twinrung_grammar::tree::Sources;

use super::Stopwatch;
use crate::drive::runs;
use crate::instruction_rungs::{self, Literals, PERIOD_MS, Subject};
use crate::names;
use crate::signal::Signal;

/// Rungs of a calibration project.
const RUNGS: usize = 200;
/// Scans of a calibration: half of them with true rungs.
const SCANS: u64 = 60;
/// Contacts, coils and elements whose sum is divided.
const MANY: u32 = 8;
const ELEMENTS: u32 = 256;

/// An estimate of the time of the longest path.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Estimate {
    /// The time of the longest path, in ns.
    pub bound_ns: u64,
    /// The costs that it is made of, in ns.
    pub costs: Vec<CostRow>,
    /// The longest path program by program, routine by routine and rung by rung, in ps.
    #[serde(skip)]
    pub picoseconds: Bound,
}

/// The cost of one thing that a scan does.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct CostRow {
    /// A mnemonic, `rung`, `Add-On call`, `FAL element` or `scan`.
    pub of: String,
    /// On both channels and in the comparison, in ns.
    pub ns: f64,
}

/// Estimates the time of the bound of an image with costs measured now. Only what the image holds is calibrated.
///
/// # Errors
///
/// A calibration project that does not compile: a defect of ours.
pub fn estimate(image: &AdmittedImage) -> Result<Estimate, String> {
    let used: RefCell<BTreeSet<Work>> = RefCell::default();
    bound::bound(image, &|work| {
        used.borrow_mut().insert(work);
        0
    });
    let mut calibration = Calibration::new()?;
    let mut costs: BTreeMap<Work, f64> = BTreeMap::new();
    for work in used.into_inner() {
        costs.insert(work, calibration.cost(work)?);
    }
    let picoseconds = |work| costs.get(&work).map_or(0, |ns| (ns * 1000.0).round() as u64);
    let picoseconds = bound::bound(image, &picoseconds);
    let mut rows = vec![CostRow { of: "scan".to_owned(), ns: calibration.scan_ns }];
    rows.extend(costs.into_iter().map(|(work, ns)| CostRow { of: name(work), ns }));
    let bound_ns = (picoseconds.total / 1000).saturating_add(calibration.scan_ns as u64);
    Ok(Estimate { bound_ns, costs: rows, picoseconds })
}

/// What a row of costs is called.
fn name(work: Work) -> String {
    match work {
        Work::Rung => "rung".to_owned(),
        Work::AddOnCall => "Add-On call".to_owned(),
        Work::Instruction(opcode) => opcode.instruction().mnemonic.to_owned(),
        Work::FileElement(opcode) => format!("{} element", opcode.instruction().mnemonic),
    }
}

struct Calibration {
    /// What a scan costs before its first rung.
    scan_ns: f64,
    /// All rungs of the project without a subject.
    bare_ns: f64,
    contact_ns: f64,
    coil_ns: f64,
}

impl Calibration {
    fn new() -> Result<Calibration, String> {
        let scan_ns = time_of(Subject::Nothing, 1)?;
        let bare_ns = time_of(Subject::Nothing, RUNGS)?;
        let slope = |subject, many: u32| {
            time_of(subject, RUNGS).map(|ns| (ns - bare_ns).max(0.0) / (RUNGS as f64 * f64::from(many)))
        };
        let contact_ns = slope(Subject::Contacts(Opcode::Xic, MANY as usize), MANY)?;
        let coil_ns = slope(Subject::Coils(Opcode::Ote, MANY as usize), MANY)?;
        Ok(Calibration { scan_ns, bare_ns, contact_ns, coil_ns })
    }

    fn cost(&mut self, work: Work) -> Result<f64, String> {
        let above = |subject, many: u32| {
            time_of(subject, RUNGS).map(|ns| (ns - self.bare_ns).max(0.0) / (RUNGS as f64 * f64::from(many)))
        };
        match work {
            Work::Rung => {
                let whole = (self.bare_ns - self.scan_ns).max(0.0) / (RUNGS as f64 - 1.0);
                Ok((whole - self.contact_ns - self.coil_ns).max(0.0))
            }
            Work::AddOnCall => above(Subject::AddOnCall, 1),
            Work::FileElement(opcode) => {
                let few = time_of(Subject::One(opcode, 1), RUNGS)?;
                let many = time_of(Subject::One(opcode, 1 + ELEMENTS), RUNGS)?;
                Ok((many - few).max(0.0) / (RUNGS as f64 * f64::from(ELEMENTS)))
            }
            Work::Instruction(opcode) => match opcode {
                Opcode::Xic => Ok(self.contact_ns),
                Opcode::Xio => above(Subject::Contacts(opcode, MANY as usize), MANY),
                Opcode::Ote => Ok(self.coil_ns),
                Opcode::Otl | Opcode::Otu => above(Subject::Coils(opcode, MANY as usize), MANY),
                Opcode::Fal | Opcode::Fsc => above(Subject::One(opcode, 1), 1),
                // What hands control over costs what a call of a subroutine costs; it stands for all of them.
                Opcode::Jsr | Opcode::Sbr | Opcode::Ret | Opcode::Jmp | Opcode::Tnd => above(Subject::Subroutine, 1),
                Opcode::Lbl | Opcode::Mcr => above(Subject::One(Opcode::Nop, 0), 1),
                Opcode::Event => above(Subject::One(Opcode::Clr, 0), 1),
                Opcode::Gsv | Opcode::Ssv => above(Subject::One(Opcode::Cop, 0), 1),
                _ => above(Subject::One(opcode, 0), 1),
            },
        }
    }
}

/// The time of a scan of a calibration project in ns: the median of the scans with true rungs or of those with false
/// rungs, whichever is longer.
fn time_of(subject: Subject, rungs: usize) -> Result<f64, String> {
    let mut reason = String::new();
    for literals in [Literals::Least, Literals::Greatest] {
        let text = instruction_rungs::project(subject, rungs, literals)
            .ok_or_else(|| format!("{subject:?} cannot be calibrated"))?;
        match compiled(&text) {
            Ok((image, bytes)) => return timed(image, &bytes, rungs),
            Err(error) => reason = error,
        }
    }
    Err(format!("{subject:?}: {reason}"))
}

/// A project of calibration rungs, compiled and admitted.
fn compiled(text: &str) -> Result<(AdmittedImage, Vec<u8>), String> {
    let mut sources = Sources::new();
    let reading = twinrung_grammar::read(&mut sources, "calibration.rll", text.as_bytes().to_vec());
    let checked = check(&reading, &Completion::default());
    let project = checked.project.ok_or_else(|| {
        checked.findings.into_iter().find(|finding| finding.is_error()).map_or_else(String::new, |error| error.message)
    })?;
    let bytes = compile(&project).map_err(|finding| finding.message)?.bytes;
    let image = admit(&bytes).map_err(|error| error.to_string())?;
    Ok((image, bytes))
}

fn timed(image: AdmittedImage, bytes: &[u8], rungs: usize) -> Result<f64, String> {
    let mut conditions = Vec::with_capacity(rungs);
    for rung in 0..rungs {
        match names::signal(&image, &format!("C{rung}")).map_err(|error| error.to_string())? {
            Signal::Bit(cell) => conditions.push(cell),
            other => return Err(format!("{other:?} is no BOOL")),
        }
    }
    let mut controller = DualController::load(image, bytes).map_err(|error| error.to_string())?;
    let cells: BTreeSet<BitCell> = conditions.iter().copied().collect();
    for range in runs(cells.into_iter().map(Signal::Bit)) {
        controller.freeze_also(range);
    }
    controller.power_up_in_run();
    let mut clock = Stopwatch::new(None);
    let mut times = [Vec::new(), Vec::new()];
    for scan in 0..SCANS {
        let truth = scan.is_multiple_of(2);
        conditions.iter().for_each(|cell| controller.drive_bit(*cell, truth));
        let report = controller.scan_observed((scan * PERIOD_MS) as i64, &mut clock, &mut Silent, &mut Silent);
        if let Some(reason) = report.stopped {
            return Err(format!("a calibration stopped: {reason:?}"));
        }
        // Both channels and the comparison.
        let [_, primary, partner, compare, _] = clock.parts();
        times[usize::from(truth)].push(primary + partner + compare);
    }
    let median = |times: &mut Vec<Duration>| {
        times.sort_unstable();
        times.get(times.len() / 2).copied().unwrap_or_default()
    };
    let [mut off, mut on] = times;
    Ok(median(&mut off).max(median(&mut on)).as_nanos() as f64)
}
