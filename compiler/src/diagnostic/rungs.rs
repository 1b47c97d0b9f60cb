//! From a place in a file to the rung that stands there.

use twinrung_grammar::tree::{File, Routine, Rung, Span};

use super::{Finding, RungPlace};
use crate::project::UNNAMED_PROGRAM;

/// A rung with its routine.
#[derive(Debug, Clone, Copy)]
pub struct PlacedRung<'a> {
    /// The program, or the Add-On Instruction.
    pub owner: &'a str,
    /// The routine.
    pub routine: &'a str,
    /// The rung, from 0.
    pub number: u32,
    /// The rung.
    pub rung: &'a Rung,
}

impl PlacedRung<'_> {
    /// `Program/Routine`, or the Add-On Instruction's `Name/Routine`.
    pub fn routine_name(&self) -> String {
        format!("{}/{}", self.owner, self.routine)
    }
}

/// All rungs of some files, ordered by place.
#[derive(Debug, Default)]
pub struct RungIndex<'a> {
    rungs: Vec<PlacedRung<'a>>,
}

impl<'a> RungIndex<'a> {
    /// Gathers the rungs of programs, of Add-On Instructions and of routines outside a program.
    pub fn new(files: impl IntoIterator<Item = &'a File>) -> RungIndex<'a> {
        let mut rungs = Vec::new();
        for file in files {
            let of_programs = file.programs.iter().map(|one| (one.name.as_str(), &one.routines));
            let of_add_ons = file.add_on_instructions.iter().map(|one| (one.name.as_str(), &one.routines));
            let alone = std::iter::once((UNNAMED_PROGRAM, &file.routines));
            for (owner, routines) in of_programs.chain(of_add_ons).chain(alone) {
                routines.iter().for_each(|routine| push(owner, routine, &mut rungs));
            }
        }
        rungs.sort_by_key(|one| (one.rung.span.source, one.rung.span.start));
        RungIndex { rungs }
    }

    /// The rung in which a place begins.
    pub fn at(&self, place: Span) -> Option<&PlacedRung<'a>> {
        let key = (place.source, place.start);
        let after = self.rungs.partition_point(|one| (one.rung.span.source, one.rung.span.start) <= key);
        let one = self.rungs.get(after.checked_sub(1)?)?;
        (one.rung.span.source == place.source && place.start <= one.rung.span.end).then_some(one)
    }

    /// Says of a finding on which rung it is.
    pub(crate) fn place(&self, finding: &mut Finding) {
        finding.rung = self
            .at(finding.span)
            .map(|one| Box::new(RungPlace { routine: one.routine_name(), rung: one.number, span: one.rung.span }));
    }
}

fn push<'a>(owner: &'a str, routine: &'a Routine, rungs: &mut Vec<PlacedRung<'a>>) {
    let placed = routine.rungs().iter().enumerate().map(|(number, rung)| PlacedRung {
        owner,
        routine: routine.name.as_str(),
        number: number as u32,
        rung,
    });
    rungs.extend(placed);
}
