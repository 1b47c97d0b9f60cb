//! An observer that disturbs an execution in one place, and counts the places where it could.

use std::sync::Arc;

use twinrung_bytecode::channel::Place;
use twinrung_bytecode::index::{BitCell, WordCell};
use twinrung_bytecode::observer::{ElementUpset, Observer, RungUpset};

use super::fault::Upset;

/// Places of one execution.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) struct Places {
    /// Rungs that were entered.
    pub rungs: u64,
    /// Instructions that were asked about.
    pub instructions: u64,
    /// Values that were written.
    pub values: u64,
}

impl Places {
    /// Places of a kind of upset.
    pub(super) const fn of(self, upset: Upset) -> u64 {
        match upset {
            Upset::RungSkipped | Upset::RungRepeated | Upset::RungJumped => self.rungs,
            Upset::InstructionSkipped | Upset::InstructionRepeated | Upset::BranchWrong => self.instructions,
            Upset::ValueFlipped => self.values,
        }
    }
}

/// Upsets one place of an execution.
#[derive(Debug, Clone)]
pub(super) struct Upsetter {
    target: Option<(Upset, u64, u64)>,
    places: Places,
    /// Rungs of each routine.
    rungs: Arc<[u32]>,
}

impl Upsetter {
    /// Counts alone.
    pub(super) fn counting(rungs: Arc<[u32]>) -> Upsetter {
        Upsetter { target: None, places: Places::default(), rungs }
    }

    /// Upsets the place with this number; the second number is a rung or a bit.
    pub(super) fn upsetting(rungs: Arc<[u32]>, upset: Upset, place: u64, second: u64) -> Upsetter {
        Upsetter { target: Some((upset, place, second)), places: Places::default(), rungs }
    }

    /// What it counted.
    pub(super) fn places(&self) -> Places {
        self.places
    }

    fn is_meant(&self, number: u64) -> Option<(Upset, u64)> {
        self.target.filter(|(_, place, _)| *place == number).map(|(upset, _, second)| (upset, second))
    }

    fn value_mask(&mut self) -> Option<u64> {
        let number = self.places.values;
        self.places.values += 1;
        self.is_meant(number).filter(|(upset, _)| *upset == Upset::ValueFlipped).map(|(_, second)| second)
    }
}

impl Observer for Upsetter {
    fn rung_upset(&mut self, place: Place) -> RungUpset {
        let number = self.places.rungs;
        self.places.rungs += 1;
        match self.is_meant(number) {
            Some((Upset::RungSkipped, _)) => RungUpset::Skip,
            Some((Upset::RungRepeated, _)) => RungUpset::Repeat,
            Some((Upset::RungJumped, second)) => {
                let rungs = self.rungs.get(place.routine.position()).copied().unwrap_or_default();
                RungUpset::Goto((second % (u64::from(rungs) + 1)) as u32)
            }
            _ => RungUpset::None,
        }
    }

    fn element_upset(&mut self, _place: Place) -> ElementUpset {
        let number = self.places.instructions;
        self.places.instructions += 1;
        match self.is_meant(number) {
            Some((Upset::InstructionSkipped, _)) => ElementUpset::Skip,
            Some((Upset::InstructionRepeated, _)) => ElementUpset::Repeat,
            Some((Upset::BranchWrong, _)) => ElementUpset::Invert,
            _ => ElementUpset::None,
        }
    }

    fn bit_arrives(&mut self, _cell: BitCell, value: bool) -> bool {
        value != self.value_mask().is_some()
    }

    fn word_arrives(&mut self, _cell: WordCell, value: i32) -> i32 {
        self.value_mask().map_or(value, |second| value ^ (1 << (second % 32)))
    }
}
