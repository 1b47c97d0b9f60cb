//! Running a vector scan by scan.

use crate::vector::{Setting, Vector};
use alloc::vec;
use alloc::vec::Vec;
use core::fmt;
use twinrung_catalog::MemberRole;

/// A vector on its way, scan by scan.
#[derive(Debug, Clone)]
pub struct Replay<'vector> {
    vector: &'vector Vector,
    period_ms: u32,
    next_ms: Option<u32>,
    leapt_ms: i64,
    next_step: usize,
    rung: bool,
    operands: Vec<i32>,
    expected: Vec<Option<i32>>,
}

/// One scan of a replay.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Scan {
    /// Time in ms, with the leaps so far.
    pub now_ms: i64,
    /// Whether a prescan comes first. The first scan always has one.
    pub prescan: bool,
    /// The rung condition.
    pub rung: bool,
}

impl Vector {
    /// Begins a run with one of the vector's periods.
    pub fn replay(&self, period_ms: u32) -> Replay<'_> {
        let declaration = self.declaration();
        let operands = declaration.map_or(0, |declaration| declaration.mirrored.len());
        let members = declaration.map_or(0, |declaration| declaration.backing.members.len());
        let mut replay = Replay {
            vector: self,
            period_ms,
            next_ms: Some(0),
            leapt_ms: 0,
            next_step: 0,
            rung: true,
            operands: vec![0; operands],
            expected: vec![None; members],
        };
        self.configuration.iter().for_each(|setting| replay.set(setting));
        replay
    }
}

impl Replay<'_> {
    /// The next scan; afterwards [`operands`](Self::operands) and [`expected`](Self::expected) are those of this scan.
    pub fn next_scan(&mut self) -> Option<Scan> {
        let vector = self.vector;
        let now_ms = self.next_ms.filter(|now| *now <= vector.end_ms)?;
        self.next_ms = now_ms.checked_add(self.period_ms);
        let mut prescan = now_ms == 0;
        while let Some(step) = vector.steps.get(self.next_step).filter(|step| step.at_ms <= now_ms) {
            self.next_step = self.next_step.saturating_add(1);
            self.leapt_ms = self.leapt_ms.saturating_add(i64::from(step.leap_ms));
            prescan |= step.prescan;
            self.rung = step.rung.unwrap_or(self.rung);
            step.inputs.iter().for_each(|setting| self.set(setting));
            for expectation in &step.expected {
                if let Some(place) = self.expected.get_mut(expectation.member) {
                    *place = Some(expectation.value);
                }
            }
        }
        Some(Scan { now_ms: i64::from(now_ms).saturating_add(self.leapt_ms), prescan, rung: self.rung })
    }

    fn set(&mut self, setting: &Setting) {
        if let Some(place) = self.operands.get_mut(setting.operand) {
            *place = setting.value;
        }
    }

    /// The operands after the backing tag, in catalog order: BOOL 0 or 1, DINT, or the bits of a REAL.
    pub fn operands(&self) -> &[i32] {
        &self.operands
    }

    /// For each member of the backing type what it must be after this scan; `None` where nothing is expected.
    pub fn expected(&self) -> &[Option<i32>] {
        &self.expected
    }
}

/// Something that executes one safety application instruction: a half of the safety library.
///
/// `operands` are the values of the operands after the backing tag, `members` those of the backing type, both in
/// catalog order. Input and configuration members are already mirrored; only output members are written.
pub trait Half {
    /// Executes the prescan.
    fn prescan(&mut self, operands: &[i32], members: &mut [i32]);
    /// Executes the instruction once.
    fn scan(&mut self, rung: bool, now_ms: i64, operands: &[i32], members: &mut [i32]);
}

/// The first difference between a half and a vector.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Mismatch {
    /// The vector.
    pub vector: &'static str,
    /// The period in ms.
    pub period_ms: u32,
    /// The scan in which it differed, in ms.
    pub at_ms: i64,
    /// The member that differed.
    pub member: &'static str,
    /// What the vector expects.
    pub expected: i32,
    /// What the half shows.
    pub found: i32,
}

impl fmt::Display for Mismatch {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { vector, period_ms, at_ms, member, expected, found } = self;
        write!(
            formatter,
            "{vector} (period {period_ms} ms) at {at_ms} ms: {member} is {found} (16#{found:X}), expected {expected} (16#{expected:X})"
        )
    }
}

impl core::error::Error for Mismatch {}

/// Runs a vector on a half, doing around the call what an interpreter does, and compares every expected member after
/// every scan.
///
/// # Errors
///
/// The first difference.
pub fn run(vector: &Vector, period_ms: u32, half: &mut impl Half) -> Result<(), Mismatch> {
    let Some(declaration) = vector.declaration() else { return Ok(()) };
    let declared = declaration.backing.members;
    let mut members = vec![0; declared.len()];
    let mut replay = vector.replay(period_ms);
    while let Some(scan) = replay.next_scan() {
        if scan.prescan {
            mirror(declaration.mirrored, declared, replay.operands(), &mut members, true);
            show_rung(declared, &mut members, false);
            half.prescan(replay.operands(), &mut members);
        }
        mirror(declaration.mirrored, declared, replay.operands(), &mut members, false);
        show_rung(declared, &mut members, scan.rung);
        half.scan(scan.rung, scan.now_ms, replay.operands(), &mut members);
        show_rung(declared, &mut members, scan.rung);
        for ((member, found), expected) in declared.iter().zip(&members).zip(replay.expected()) {
            if let Some(expected) = expected.filter(|expected| expected != found) {
                let (vector, at_ms, found) = (vector.name, scan.now_ms, *found);
                return Err(Mismatch { vector, period_ms, at_ms, member: member.name, expected, found });
            }
        }
    }
    Ok(())
}

/// Copies operands into the members that mirror them; `configuration` copies those of configuration operands only.
fn mirror(
    mirrored: &[&str],
    declared: &[twinrung_catalog::Member],
    operands: &[i32],
    members: &mut [i32],
    configuration: bool,
) {
    for (member, place) in declared.iter().zip(members) {
        let operand = mirrored.iter().position(|name| *name == member.name);
        let copied = !configuration || member.role == MemberRole::Configuration;
        if let Some(value) = operand.filter(|_| copied).and_then(|operand| operands.get(operand)) {
            *place = *value;
        }
    }
}

fn show_rung(declared: &[twinrung_catalog::Member], members: &mut [i32], rung: bool) {
    for (member, place) in declared.iter().zip(members) {
        if matches!(member.name, "EnableIn" | "EnableOut") {
            *place = i32::from(rung);
        }
    }
}
