//! What fault injection reaches of this channel: every bit of the decoded program, of the cells, and of what else lasts
//! from one execution to the next.
//!
//! Not listed is what every execution writes before it reads it: stacks, values of formulas, values on their way
//! between routines, the scratch and lasting cells behind those of the image. A test fills all of it with other values
//! and sees nothing of it.

mod records;

use twinrung_bytecode::channel::Status;
use twinrung_bytecode::injection::{BitVisitor, Injectable, Memory, Part};
use twinrung_bytecode::layout::Field;
use twinrung_safety_primary::State;
use twinrung_safety_primary::injection::Bits;

use crate::Primary;
use crate::lower::table::Tables;
use crate::machine::{Keeper, Machine};
use crate::program::Program;

impl Injectable for Primary {
    fn visit_bits(&mut self, memory: Memory, visitor: &mut BitVisitor) {
        match memory {
            Memory::Program => {
                program(&mut self.program, visitor);
                self.machine.visit_loaded(visitor);
            }
            Memory::Cells => self.machine.visit_cells(visitor),
            Memory::State => self.machine.visit_state(visitor),
        }
    }
}

/// Values side by side, all of the same number of bits.
struct Row<'a, T>(&'a mut [T]);

impl<T: Bits> Row<'_, T> {
    fn width(&self) -> u64 {
        self.0.first().map_or(0, |value| u64::from(value.count()))
    }

    /// The value with this bit, and which of its bits it is.
    fn find(&self, bit: u64) -> Option<(usize, u32)> {
        let index = bit.checked_div(self.width())?;
        let within = bit.checked_rem(self.width())?;
        Some((index as usize, within as u32))
    }
}

impl<T: Bits> Part for Row<'_, T> {
    fn bits(&self) -> u64 {
        self.width().saturating_mul(self.0.len() as u64)
    }

    fn bit(&self, bit: u64) -> bool {
        self.find(bit).is_some_and(|(index, bit)| self.0.get(index).is_some_and(|value| value.bit(bit)))
    }

    fn flip(&mut self, bit: u64) -> bool {
        self.find(bit).is_some_and(|(index, bit)| self.0.get_mut(index).is_some_and(|value| value.flip(bit)))
    }
}

/// The memory of one call of a safety application instruction.
struct Library<'a>(&'a mut State);

impl Part for Library<'_> {
    fn bits(&self) -> u64 {
        u64::from(self.0.bits())
    }

    fn bit(&self, bit: u64) -> bool {
        self.0.bit(bit as u32)
    }

    fn flip(&mut self, bit: u64) -> bool {
        self.0.flip(bit as u32)
    }
}

fn row<T: Bits>(values: &mut [T], visitor: &mut BitVisitor) {
    visitor.part(&mut Row(values));
}

fn one<T: Bits>(value: &mut T, visitor: &mut BitVisitor) {
    row(core::slice::from_mut(value), visitor);
}

fn program(program: &mut Program, visitor: &mut BitVisitor) {
    let Program {
        codes,
        instructions,
        operands,
        formulas,
        formula_operations,
        bodies,
        labels,
        jumps,
        calls,
        arguments,
        copies,
        fields,
        safety_calls,
        programs,
        schedule,
        system_values,
        steps,
        tables,
        bit_cells,
        word_cells,
        rail,
        first_scan,
        zero,
        one: one_cell,
        watched_timers,
    } = program;
    row(codes, visitor);
    row(instructions, visitor);
    row(operands, visitor);
    row(formulas, visitor);
    row(formula_operations, visitor);
    row(bodies, visitor);
    row(labels, visitor);
    row(jumps, visitor);
    row(calls, visitor);
    row(arguments, visitor);
    row(copies, visitor);
    for Field { byte, bit, element, cell } in fields {
        visitor.field(byte);
        visitor.field(bit);
        one(element, visitor);
        visitor.field(cell);
    }
    row(safety_calls, visitor);
    row(programs, visitor);
    visitor.fields(schedule);
    row(system_values, visitor);
    row(steps, visitor);
    let Tables { runs, narrow, wide, timers, compares, word_bits, arithmetic, general } = tables;
    row(runs, visitor);
    row(narrow, visitor);
    row(wide, visitor);
    row(timers, visitor);
    row(compares, visitor);
    row(word_bits, visitor);
    row(arithmetic, visitor);
    row(general, visitor);
    for cell in [bit_cells, word_cells, rail, first_scan, zero, one_cell] {
        visitor.field(cell);
    }
    visitor.fields(watched_timers);
}

impl Machine {
    /// What loading made and no execution writes: initial values, constants, and which instruction each state is of.
    fn visit_loaded(&mut self, visitor: &mut BitVisitor) {
        visitor.fields(&mut self.initial_bits);
        visitor.fields(&mut self.initial_words);
        visitor.fields(&mut self.constants);
        visitor.field(&mut self.most_returns);
        for keeper in &mut self.keepers {
            one(&mut keeper.opcode, visitor);
        }
        // Behind the image's own: the bit cells that are always 0 and always 1, and the words of constants.
        let constants = self.bits.iter_mut().skip(self.initial_bits.len()).take(2);
        constants.for_each(|cell| visitor.field(cell));
        visitor.fields(self.words.get_mut(self.initial_words.len()..).unwrap_or_default());
    }

    fn visit_cells(&mut self, visitor: &mut BitVisitor) {
        visitor.fields(self.bits.get_mut(..self.initial_bits.len()).unwrap_or_default());
        visitor.fields(self.words.get_mut(..self.initial_words.len()).unwrap_or_default());
    }

    fn visit_state(&mut self, visitor: &mut BitVisitor) {
        let Machine {
            bits: _,
            words: _,
            hidden,
            keepers,
            initial_bits: _,
            initial_words: _,
            constants: _,
            status,
            first_scan_armed,
            events,
            records,
            frames: _,
            branches: _,
            visited: _,
            jumps: _,
            values: _,
            overflowed: _,
            addresses: _,
            slots: _,
            numbers: _,
            returns: _,
            most_returns: _,
            passing_bits: _,
            passing_words: _,
            copied: _,
            program: _,
            handling: _,
            handled: _,
            spent: _,
            path,
            doubtful,
        } = self;
        visitor.fields(hidden);
        for Keeper { opcode: _, state, prescanned } in keepers {
            visitor.part(&mut Library(state));
            visitor.field(prescanned);
        }
        let Status { first_scan, overflow, zero, negative, carry, minor_fault, minor_faults, executed, cleared_faults } =
            status;
        for flag in [first_scan, overflow, zero, negative, carry, minor_fault, first_scan_armed, doubtful] {
            visitor.field(flag);
        }
        visitor.field(minor_faults);
        visitor.field(path);
        visitor.field(executed);
        visitor.field(cleared_faults);
        visitor.fields(events);
        for record in records {
            visitor.fields(record);
        }
    }
}
