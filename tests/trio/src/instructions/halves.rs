//! The two channels, one with each half of the library, and the cells of the calls.

use twinrung_bytecode::channel::{Channel, ScanEnd, ScanInputs};
use twinrung_bytecode::observer::Silent;
use twinrung_contest::cells::{self, plain_bit, plain_word};
use twinrung_contest::generate::safety::{Call, Given};
use twinrung_contest::{Signal, names};
use twinrung_partner::Partner;
use twinrung_primary::Primary;

use super::project::operand_tag;
use crate::Subject;

/// More than any program of calls executes in a scan.
const BUDGET: u64 = 1_000_000;

/// Both channels with the same program.
pub struct Halves {
    primary: Primary,
    partner: Partner,
    cells: Vec<Cells>,
}

/// Where the data of a call lie.
struct Cells {
    rung: Signal,
    operands: Vec<Option<Signal>>,
    members: Vec<(&'static str, Signal)>,
}

impl Halves {
    /// Loads a program of calls.
    pub fn new(subject: &Subject, calls: &[Call]) -> Halves {
        let signal = |name: &str| names::signal(&subject.image, name).unwrap_or_else(|error| panic!("{error}"));
        let cells = |(number, call): (usize, &Call)| {
            let members = call.instruction.safety.map_or(&[][..], |safety| safety.backing.members);
            let operand =
                |(index, given): (usize, &Given)| (*given == Given::Tag).then(|| signal(&operand_tag(number, index)));
            Cells {
                rung: signal(&format!("Rung_{number}")),
                operands: call.operands.iter().enumerate().map(operand).collect(),
                members: members
                    .iter()
                    .filter(|member| member.length == 0)
                    .map(|member| (member.name, signal(&format!("Backing_{number}.{}", member.name))))
                    .collect(),
            }
        };
        Halves {
            primary: Primary::load(&subject.image).unwrap_or_else(|error| panic!("primary: {error}")),
            partner: Partner::load(&subject.image).unwrap_or_else(|error| panic!("partner: {error}")),
            cells: calls.iter().enumerate().map(cells).collect(),
        }
    }

    /// What they were after loading.
    pub fn reset(&mut self) {
        self.primary.reset();
        self.partner.reset();
    }

    /// Sets the rung condition of a call.
    pub fn set_rung(&mut self, call: usize, value: bool) {
        self.set(self.cells[call].rung, i32::from(value));
    }

    /// Sets an operand of a call, where it is a tag.
    pub fn set_operand(&mut self, call: usize, index: usize, value: i32) {
        if let Some(signal) = self.cells[call].operands[index] {
            self.set(signal, value);
        }
    }

    fn set(&mut self, signal: Signal, value: i32) {
        cells::write(&mut self.primary, signal, value);
        cells::write(&mut self.partner, signal, value);
    }

    /// Where a member of a call's backing tag lies.
    pub fn member(&self, call: usize, name: &str) -> Option<Signal> {
        self.cells[call].members.iter().find(|(known, _)| *known == name).map(|(_, signal)| *signal)
    }

    /// A value in the primary.
    pub fn read(&self, signal: Signal) -> i32 {
        cells::read(&self.primary, signal)
    }

    /// Prescans both.
    pub fn prescan(&mut self, now_ms: i64) {
        let inputs = ScanInputs { now_ms, budget: BUDGET, system_values: &[] };
        let ends = (self.primary.prescan(inputs, &mut Silent), self.partner.prescan(inputs, &mut Silent));
        assert_eq!(ends, (ScanEnd::Completed, ScanEnd::Completed));
    }

    /// Scans both.
    pub fn scan(&mut self, now_ms: i64) {
        let inputs = ScanInputs { now_ms, budget: BUDGET, system_values: &[] };
        let ends = (self.primary.scan(inputs, &mut Silent), self.partner.scan(inputs, &mut Silent));
        assert_eq!(ends, (ScanEnd::Completed, ScanEnd::Completed));
    }

    /// The call whose data differ, if any: everything that the channels hold is looked at.
    pub fn differing(&self) -> Option<usize> {
        let bits = self.primary.bits().iter().zip(self.partner.bits());
        let words = self.primary.words().iter().zip(self.partner.words());
        let same_bits = bits.fold(0, |sum, (a, b)| sum | (plain_bit::<Primary>(*a) ^ plain_bit::<Partner>(*b)));
        let same_words = words.fold(0, |sum, (a, b)| sum | (plain_word::<Primary>(*a) ^ plain_word::<Partner>(*b)));
        if same_bits == 0 && same_words == 0 {
            return None;
        }
        Some((0..self.cells.len()).find(|call| !self.differences(*call).is_empty()).unwrap_or_default())
    }

    /// Members of a call's backing tag that differ, with the values of primary and partner.
    pub fn differences(&self, call: usize) -> Vec<(&'static str, i32, i32)> {
        let members = self.cells[call].members.iter();
        let values = members
            .map(|(name, signal)| (*name, cells::read(&self.primary, *signal), cells::read(&self.partner, *signal)));
        values.filter(|(_, primary, partner)| primary != partner).collect()
    }
}
