//! Channel 1: the primary interpreter.
//!
//! Loading turns an image into tables. Contacts, branches, coils, latches and one-shots become uniform gates (four
//! cells, a truth table, one cell out) that a scan evaluates in a plain loop, in a time that does not depend on the
//! data; timers, comparisons, moves and arithmetic become records that stand beside their equals; only what may fault
//! or change the flow stands alone. The order keeps every dependency of the text. A scan that somebody observes, a
//! prescan, and what is left of a rung after a fault go through the text's own order instead, with equal results.
//!
//! May depend on the image format, the catalog, its own half of the safety library and `libm`, and on nothing of the
//! partner. Allocates only while loading, never recurses on input, cannot panic.

#![no_std]
#![forbid(unsafe_code)]
#![cfg_attr(
    not(test),
    deny(
        clippy::indexing_slicing,
        clippy::arithmetic_side_effects,
        clippy::panic,
        clippy::unwrap_used,
        clippy::expect_used
    )
)]

extern crate alloc;

mod error;
#[cfg(any(test, feature = "injection"))]
mod injection;
mod load;
mod lower;
mod machine;
mod number;
mod program;
mod run;
mod stack;
#[cfg(test)]
mod tests;

use twinrung_bytecode::AdmittedImage;
use twinrung_bytecode::channel::{Channel, FaultRecord, Representation, ScanEnd, ScanInputs, Status};
use twinrung_bytecode::image::Image;
use twinrung_bytecode::index::{BitCell, EventTaskIndex, ProgramIndex, WordCell};
use twinrung_bytecode::layout::TypeLayout;
use twinrung_bytecode::observer::Observer;

pub use error::LoadError;
use machine::Machine;
use program::Program;
use run::Run;

/// The primary: holds cells as they are. A clone goes on as the original would.
#[derive(Debug, Clone)]
pub struct Primary {
    program: Program,
    machine: Machine,
}

impl Primary {
    fn from_records(image: &Image, layouts: &[TypeLayout]) -> Result<Primary, LoadError> {
        let loaded = load::load(image, layouts)?;
        let machine = Machine::new(image, &loaded)?;
        Ok(Primary { program: loaded.program, machine })
    }
}

impl Channel for Primary {
    type LoadError = LoadError;

    const REPRESENTATION: Representation = Representation::Plain;

    fn load(image: &AdmittedImage) -> Result<Self, LoadError> {
        Primary::from_records(image.image(), image.layouts())
    }

    fn reset(&mut self) {
        self.machine.reset(&self.program);
    }

    fn prescan<O: Observer>(&mut self, inputs: ScanInputs<'_>, observer: &mut O) -> ScanEnd {
        Run { program: &self.program, machine: &mut self.machine, inputs, observer }.prescan()
    }

    fn scan<O: Observer>(&mut self, inputs: ScanInputs<'_>, observer: &mut O) -> ScanEnd {
        Run { program: &self.program, machine: &mut self.machine, inputs, observer }.scan()
    }

    fn set_bit(&mut self, cell: BitCell, value: bool) {
        if cell.0 < self.program.bit_cells {
            self.machine.put_bit(cell.0, value);
        }
    }

    fn set_word(&mut self, cell: WordCell, value: i32) {
        if cell.0 < self.program.word_cells {
            self.machine.put_word(cell.0, value as u32);
            self.machine.doubtful |= value < 0;
        }
    }

    fn bits(&self) -> &[u8] {
        self.machine.bits.get(..self.program.bit_cells as usize).unwrap_or_default()
    }

    fn words(&self) -> &[u32] {
        self.machine.words.get(..self.program.word_cells as usize).unwrap_or_default()
    }

    fn status(&self) -> Status {
        self.machine.status
    }

    fn events(&self, task: EventTaskIndex) -> u32 {
        self.machine.events.get(task.position()).copied().unwrap_or(0)
    }

    fn fault_record(&self, program: ProgramIndex) -> Option<FaultRecord> {
        self.machine.records.get(program.position()).copied()
    }

    fn path_signature(&self) -> u32 {
        self.machine.path
    }
}
