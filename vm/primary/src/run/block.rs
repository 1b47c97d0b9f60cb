//! Runs a block: one plain loop for each run of equal work. No loop makes a choice that depends on data.

use twinrung_bytecode::observer::Observer;
use twinrung_bytecode::observer::Silent;

use super::Run;
use super::timer::advanced;
use crate::lower::BANKS;
use crate::lower::table::{
    ArithmeticRecord, CompareRecord, Gate, GeneralRecord, Kind, TimerRecord, WordBitRecord, WorkRun,
};
use crate::machine::Machine;
use crate::number::{Binary, Relation, integer_binary};
use crate::program::{NONE, Range};

/// Status flags beside the order of the instruction that they come from.
const OVERFLOW: u32 = 1;
const ZERO: u32 = 2;
const NEGATIVE: u32 = 4;
const CARRY: u32 = 8;
const FLAG_BITS: u32 = 4;

impl<O: Observer> Run<'_, O> {
    /// Runs the work of a block.
    pub(super) fn block(&mut self, runs: Range) {
        let program = self.program;
        let tables = &program.tables;
        // Order and flags of the last instruction, in the order of the text, that affected the status.
        let mut last = 0u32;
        for WorkRun { kind, range } in runs.of(&tables.runs) {
            match kind {
                Kind::Gates => gates(self.machine, range.of(&tables.narrow), range.of(&tables.wide)),
                Kind::Compares(relation) => compares(self.machine, *relation, range.of(&tables.compares)),
                Kind::WordBits => word_bits(self.machine, range.of(&tables.word_bits)),
                Kind::OnDelays => timers::<ON>(self.machine, self.inputs.now_ms, range.of(&tables.timers)),
                Kind::OffDelays => timers::<OFF>(self.machine, self.inputs.now_ms, range.of(&tables.timers)),
                Kind::Retentives => timers::<RETENTIVE>(self.machine, self.inputs.now_ms, range.of(&tables.timers)),
                Kind::Moves => last = last.max(moves(self.machine, range.of(&tables.arithmetic))),
                Kind::Arithmetic(operator) => {
                    last = last.max(self.arithmetic(*operator, range.of(&tables.arithmetic)));
                }
                Kind::General => last = last.max(self.general(range.of(&tables.general))),
            }
        }
        if last != 0 {
            let status = &mut self.machine.status;
            status.overflow = last & OVERFLOW != 0;
            status.zero = last & ZERO != 0;
            status.negative = last & NEGATIVE != 0;
            status.carry = last & CARRY != 0;
        }
    }

    fn arithmetic(&mut self, operator: Binary, records: &[ArithmeticRecord]) -> u32 {
        let (last, overflows) = match operator {
            Binary::Add => arithmetic(self.machine, records, |left, right| {
                let (value, overflow) = left.overflowing_add(right);
                (value, overflow, (value as u32) < (left as u32))
            }),
            Binary::Subtract => arithmetic(self.machine, records, |left, right| {
                let (value, overflow) = left.overflowing_sub(right);
                (value, overflow, (left as u32) < (right as u32))
            }),
            operator => arithmetic(self.machine, records, |left, right| {
                let outcome = integer_binary(operator, left, right);
                let value = match outcome.value {
                    crate::number::Number::Integer(value) => value,
                    crate::number::Number::Real(_) => 0,
                };
                (value, outcome.overflow, outcome.carry)
            }),
        };
        if overflows != 0 {
            let status = &mut self.machine.status;
            status.minor_fault = true;
            status.minor_faults = status.minor_faults.saturating_add(overflows);
        }
        last
    }

    fn general(&mut self, records: &[GeneralRecord]) -> u32 {
        let mut last = 0u32;
        for record in records {
            let Some(instruction) = self.program.instructions.get(record.instruction as usize).copied() else {
                continue;
            };
            let input = self.machine.bit(record.input);
            let mut silent =
                Run { program: self.program, machine: &mut *self.machine, inputs: self.inputs, observer: &mut Silent };
            // The loader put only what cannot fault here.
            let out = silent.execute(instruction, input).unwrap_or(false);
            if record.output != NONE {
                self.machine.put_bit(record.output, out);
            }
            if record.order != 0 && input {
                let status = &self.machine.status;
                let flags = u32::from(status.overflow)
                    | u32::from(status.zero).wrapping_mul(ZERO)
                    | u32::from(status.negative).wrapping_mul(NEGATIVE)
                    | u32::from(status.carry).wrapping_mul(CARRY);
                last = last.max(record.order.wrapping_shl(FLAG_BITS) | flags);
            }
        }
        last
    }
}

/// Runs gates in the bank's own size, which spares every bounds check.
fn gates(machine: &mut Machine, narrow: &[Gate<u16>], wide: &[Gate<u32>]) {
    let [first, second, third, fourth, _] = BANKS;
    let bank = machine.bits.as_mut_slice();
    match bank.len() {
        size if size == first => evaluate::<{ BANKS[0] }, u16>(bank, narrow),
        size if size == second => evaluate::<{ BANKS[1] }, u32>(bank, wide),
        size if size == third => evaluate::<{ BANKS[2] }, u32>(bank, wide),
        size if size == fourth => evaluate::<{ BANKS[3] }, u32>(bank, wide),
        _ => evaluate::<{ BANKS[4] }, u32>(bank, wide),
    }
}

fn evaluate<const N: usize, T: Copy + Into<u32>>(bank: &mut [u8], gates: &[Gate<T>]) {
    let Ok(bank) = <&mut [u8; N]>::try_from(bank) else { return };
    let mask = N.wrapping_sub(1);
    for gate in gates {
        let at = |cell: T| u32::from(bank.get(cell.into() as usize & mask).copied().unwrap_or(0));
        let [a, b, c, d] = gate.inputs;
        let index = at(a) | at(b).wrapping_shl(1) | at(c).wrapping_shl(2) | at(d).wrapping_shl(3);
        let value = u32::from(gate.table).wrapping_shr(index) & 1;
        if let Some(out) = bank.get_mut(gate.out.into() as usize & mask) {
            *out = value as u8;
        }
    }
}

fn compares(machine: &mut Machine, relation: Relation, records: &[CompareRecord]) {
    match relation {
        Relation::Equal => compare(machine, records, |left, right| left == right),
        Relation::NotEqual => compare(machine, records, |left, right| left != right),
        Relation::Greater => compare(machine, records, |left, right| left > right),
        Relation::GreaterOrEqual => compare(machine, records, |left, right| left >= right),
        Relation::Less => compare(machine, records, |left, right| left < right),
        Relation::LessOrEqual => compare(machine, records, |left, right| left <= right),
    }
}

fn compare(machine: &mut Machine, records: &[CompareRecord], holds: impl Fn(i32, i32) -> bool) {
    for record in records {
        let value = holds(machine.word(record.left), machine.word(record.right));
        machine.put_bit(record.out, value);
    }
}

fn word_bits(machine: &mut Machine, records: &[WordBitRecord]) {
    for record in records {
        let value = machine.word(record.word).wrapping_shr(record.bit) & 1 != 0;
        machine.put_bit(record.out, value);
    }
}

const ON: u8 = 0;
const OFF: u8 = 1;
const RETENTIVE: u8 = 2;

/// One of two values, without a branch.
fn select(condition: bool, yes: i32, no: i32) -> i32 {
    let mask = i32::from(condition).wrapping_neg();
    (yes & mask) | (no & !mask)
}

/// Timers (general-instructions.md A.2), each state computed and chosen without a branch. PRE and ACC are not negative:
/// the scan goes by codes otherwise.
fn timers<const KIND: u8>(machine: &mut Machine, now: i64, records: &[TimerRecord]) {
    for record in records {
        let input = machine.bit(record.input);
        let bits = machine.bits.get_mut(record.bit as usize..).and_then(|bits| bits.first_chunk_mut::<3>());
        let words = machine.words.get_mut(record.word as usize..).and_then(|words| words.first_chunk_mut::<2>());
        let hidden = machine.hidden.get_mut((record.word / 2) as usize);
        let (Some([enabled_cell, timing_cell, done_cell]), Some([preset, accumulated]), Some(hidden)) =
            (bits, words, hidden)
        else {
            continue;
        };
        let (enabled, done) = (*enabled_cell != 0, *done_cell != 0);
        // For TOF the roles of true and false, and of DN set and clear, are exchanged.
        let inverted = KIND == OFF;
        let active = input != inverted;
        let timing = active & (done == inverted);
        let stepping = timing & (enabled != inverted);
        let advanced = advanced(*accumulated as i32, now.saturating_sub(*hidden));
        let finished = stepping & (advanced >= *preset as i32);
        let stepped = select(stepping, advanced, *accumulated as i32);
        let (next_done, next_accumulated) = match KIND {
            ON => (active & (done | finished), select(active, stepped, 0)),
            OFF => (!active | (done & !finished), select(active, stepped, 0)),
            _ => (done | finished, stepped),
        };
        let records_time = if inverted { timing } else { active };
        let mask = i64::from(records_time).wrapping_neg();
        *enabled_cell = u8::from(input);
        *timing_cell = u8::from(timing & !finished);
        *done_cell = u8::from(next_done);
        *accumulated = next_accumulated as u32;
        *hidden = (now & mask) | (*hidden & !mask);
    }
}

fn flags(order: u32, value: i32) -> u32 {
    order.wrapping_shl(FLAG_BITS)
        | u32::from(value == 0).wrapping_mul(ZERO)
        | u32::from(value < 0).wrapping_mul(NEGATIVE)
}

/// Moves; gives order and flags of the last one.
fn moves(machine: &mut Machine, records: &[ArithmeticRecord]) -> u32 {
    let mut last = 0u32;
    for record in records {
        let input = machine.bit(record.input);
        let value = machine.word(record.left);
        if let Some(destination) = machine.words.get_mut(record.destination as usize) {
            *destination = select(input, value, *destination as i32) as u32;
        }
        last = last.max(select(input, flags(record.order, value) as i32, 0) as u32);
    }
    last
}

/// Arithmetic; gives order and flags of the last one, and how many overflowed.
fn arithmetic(
    machine: &mut Machine,
    records: &[ArithmeticRecord],
    operation: impl Fn(i32, i32) -> (i32, bool, bool),
) -> (u32, u32) {
    let (mut last, mut overflows) = (0u32, 0u32);
    for record in records {
        let input = machine.bit(record.input);
        let (value, overflow, carry) = operation(machine.word(record.left), machine.word(record.right));
        if let Some(destination) = machine.words.get_mut(record.destination as usize) {
            *destination = select(input, value, *destination as i32) as u32;
        }
        let flags = flags(record.order, value) | u32::from(overflow) | u32::from(carry).wrapping_mul(CARRY);
        last = last.max(select(input, flags as i32, 0) as u32);
        overflows = overflows.saturating_add(u32::from(input & overflow));
    }
    (last, overflows)
}
