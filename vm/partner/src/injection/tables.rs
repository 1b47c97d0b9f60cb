//! Bits of the records that hold numbers alone, field after field.

use twinrung_bytecode::injection::Field;

use crate::ladder::{Argument, Body, Dynamic, Expression, Input, Jump, Location, Output, OwnCells, PrivateCells, Step};
use crate::panel::record::{Compare, Extract, Insert, Move, Other, Panel, Sum, Timer};
use crate::panel::{Kind, Region, Run};
use crate::walk::address::Address;

/// Each field of a record by its path, with its type; `@I` names the type of cell numbers where the record leaves it open.
macro_rules! record {
    ($(@$generic:ident)? $type:ty { $($($path:tt).+ : $field:ty),* $(,)? }) => {
        impl $(<$generic: Field>)? Field for $type {
            const BITS: u32 = 0u32 $(.wrapping_add(<$field as Field>::BITS))*;

            fn bit(&self, mut bit: u32) -> bool {
                $(match bit.checked_sub(<$field as Field>::BITS) {
                    None => return self.$($path).+.bit(bit),
                    Some(rest) => bit = rest,
                })*
                let _ = bit;
                false
            }

            fn flip(&mut self, mut bit: u32) -> bool {
                $(match bit.checked_sub(<$field as Field>::BITS) {
                    None => return self.$($path).+.flip(bit),
                    Some(rest) => bit = rest,
                })*
                let _ = bit;
                false
            }
        }
    };
}

record!(Dynamic { location: Location, begin: u32, end: u32 });
record!(Expression { begin: u32, end: u32 });
record!(Body { routine.0: u32, begin: u32, add_on: bool, counter: u32, counters: u32 });
record!(Input { argument: u32, parameter: Location });
record!(Output { argument: Argument, parameter: Location });
record!(PrivateCells { bit: u32, bits: u32, word: u32, words: u32 });
record!(Jump { target: u32, rung: u32, counter: u32 });
record!(OwnCells { true_bit: u32, false_bit: u32, override_bit: u32, first_scan_bit: u32 });
record!(Region { first_run: u32, runs: u32, end: u32, executed: u32, first_guard: u32, guards: u32 });
record!(Run { kind: Kind, begin: u32, end: u32 });
record!(@I Compare<I> { left: I, right: I, output: I, accept: u8 });
record!(@I Extract<I> { word: I, output: I, bit: u8 });
record!(@I Insert<I> { condition: I, word: I, bit: u8, above: u8, when_true: bool, clears: bool });
record!(@I Timer<I> { condition: I, bit: I, word: I });
record!(@I Move<I> { sequence: u32, condition: I, source: I, destination: I, above: u8 });
record!(@I Sum<I> { sequence: u32, condition: I, left: I, right: I, destination: I, above: u8, subtract: bool });
record!(Other { sequence: u32, condition: u32, output: u32, step: Step });
record!(Address { bit: u32, word: u32, elements: u32, number: u8 });

/// Table, inputs, output.
impl<I: Field, T: Field, const CONTACTS: usize> Field for Panel<I, T, CONTACTS> {
    const BITS: u32 = T::BITS.wrapping_add(I::BITS.wrapping_mul((CONTACTS as u32).wrapping_add(1)));

    fn bit(&self, bit: u32) -> bool {
        match bit.checked_sub(T::BITS) {
            None => self.table.bit(bit),
            Some(rest) => {
                let (cell, bit) = cell_and_bit::<I>(rest);
                self.inputs.get(cell).unwrap_or(&self.output).bit(bit)
            }
        }
    }

    fn flip(&mut self, bit: u32) -> bool {
        match bit.checked_sub(T::BITS) {
            None => self.table.flip(bit),
            Some(rest) => {
                let (cell, bit) = cell_and_bit::<I>(rest);
                self.inputs.get_mut(cell).unwrap_or(&mut self.output).flip(bit)
            }
        }
    }
}

/// Which cell's number of a panel a bit belongs to, and which bit of it that is.
fn cell_and_bit<I: Field>(bit: u32) -> (usize, u32) {
    let cell = bit.checked_div(I::BITS).unwrap_or(0);
    (cell as usize, bit.wrapping_sub(cell.wrapping_mul(I::BITS)))
}
