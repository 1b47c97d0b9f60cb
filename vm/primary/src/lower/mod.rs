//! Lowers bodies into steps: boolean networks into uniform gates, other instructions into records beside their equals,
//! and what may fault or change the flow into single steps.

pub(crate) mod cone;
mod hazard;
mod rail;
mod rung;
mod schedule;
pub(crate) mod table;
mod work;

use alloc::collections::BTreeMap;
use alloc::vec::Vec;

use crate::error::LoadError;
use crate::program::{NONE, Program};
use hazard::Written;
use schedule::{SCRATCH, Scheduler};

/// Cells that 16 bits can name.
const NARROW: usize = 1 << 16;
/// Sizes of the bit bank; the smallest that suffices is taken. 2^24 image cells and as many others fit the largest.
pub(crate) const BANKS: [usize; 5] = [NARROW, 1 << 18, 1 << 20, 1 << 22, 1 << 25];

/// What the banks hold beside the image's cells.
pub(crate) struct Banks {
    pub(crate) bits: usize,
    pub(crate) constants: Vec<i32>,
}

/// Word constants behind the image's cells, each once.
pub(crate) struct Constants {
    first: u32,
    pub(crate) values: Vec<i32>,
    known: BTreeMap<i32, u32>,
}

impl Constants {
    /// The cell of a constant.
    pub(crate) fn cell(&mut self, value: i32) -> u32 {
        let fresh = self.first.saturating_add(self.values.len() as u32);
        let cell = *self.known.entry(value).or_insert(fresh);
        if cell == fresh {
            self.values.push(value);
        }
        cell
    }
}

/// Lowers every body that runs by steps.
pub(crate) fn lower(program: &mut Program) -> Result<Banks, LoadError> {
    let bits = program.bit_cells;
    program.zero = bits;
    program.one = bits.saturating_add(1);
    program.rail = bits.saturating_add(2);
    program.first_scan = bits.saturating_add(3);
    let mut lasting = bits.saturating_add(4);
    let mut constants = Constants { first: program.word_cells, values: Vec::new(), known: BTreeMap::new() };
    let written = Written::collect(program);
    let overridden = program.instructions.iter().any(|instruction| instruction.opcode == twinrung_catalog::Opcode::Mcr);
    let mut scheduler = Scheduler::default();
    for body in 0..program.bodies.len() {
        lasting = rung::lower_body(
            program,
            body,
            rung::Around {
                scheduler: &mut scheduler,
                constants: &mut constants,
                written: &written,
                first_lasting: lasting,
                overridden,
            },
        )?;
    }
    program.watched_timers.sort_unstable();
    program.watched_timers.dedup();
    let scratch = lasting;
    let needed = (scratch as usize).saturating_add(scheduler.scratch as usize);
    let bank =
        BANKS.into_iter().find(|size| *size >= needed).ok_or(LoadError::TooLarge("the scratch of boolean networks"))?;
    program.tables.map_bits(|cell| {
        if (SCRATCH..NONE).contains(&cell) { cell.wrapping_sub(SCRATCH).wrapping_add(scratch) } else { cell }
    });
    if bank == NARROW {
        program.tables.narrow();
    }
    Ok(Banks { bits: bank, constants: constants.values })
}
