//! The code of all routines: first the structure of the rungs, then the text, then instruction by instruction.

use alloc::rc::Rc;
use alloc::vec::Vec;

use super::calls::{Calls, Signature};
use super::instruction::Check;
use super::operands::Entries;
use super::state::{State, Summary};
use super::tables::Tables;
use super::text::check_text;
use crate::admitted::CellSet;
use crate::code::{Mark, Marks};
use crate::error::{ImageError, Site};
use crate::image::{Owner, RoutineRecord};
use crate::index::{AddOnIndex, RoutineIndex};
use crate::limits;
use crate::text::code_error;

/// What the check of the code has found.
pub(super) struct Code {
    /// Rungs of each routine.
    pub(super) rungs: Vec<u32>,
    /// Cells that programs write.
    pub(super) writes: CellSet,
    /// Words that programs write other than through the CONTROL operand of a file instruction.
    pub(super) written_by_others: Vec<bool>,
}

pub(super) fn check_code(tables: &Tables<'_>, entries: &Entries) -> Result<Code, ImageError> {
    let image = tables.image;
    let mut rungs = Vec::with_capacity(image.routines.len());
    let mut total = 0usize;
    for (index, record) in image.routines.iter().enumerate() {
        let routine = RoutineIndex(index as u32);
        let count = check_structure(routine, record)?;
        total = total.saturating_add(count as usize);
        if total > limits::RUNGS {
            return Err(ImageError::RungCount);
        }
        rungs.push(count);
        check_text(image, routine, record)?;
    }
    let mut state = State::new();
    let mut calls = Calls::new(image.routines.len());
    let mut expanded = 0u64;
    // Add-On Instructions first, callees before callers: a call then finds what it needs of its callee.
    for (index, add_on) in image.add_ons.iter().enumerate() {
        state.current = Summary::new(add_on);
        let owner = Owner::AddOn(AddOnIndex(index as u16));
        for routine in [Some(add_on.logic), add_on.prescan, add_on.enable_in_false].into_iter().flatten() {
            if let Some(record) = image.routines.get(routine.position()) {
                let length = check_routine(tables, entries, &mut state, &mut calls, routine, record, owner)?;
                state.current.length = state.current.length.saturating_add(length);
            }
        }
        expanded = expanded.saturating_add(state.current.length);
        let done = core::mem::take(&mut state.current);
        state.summaries.push(Rc::new(done));
    }
    state.current = Summary::default();
    for (index, record) in image.routines.iter().enumerate() {
        let routine = RoutineIndex(index as u32);
        if let Owner::Program(_) = record.owner {
            let length = check_routine(tables, entries, &mut state, &mut calls, routine, record, record.owner)?;
            expanded = expanded.saturating_add(length);
        }
    }
    if expanded > limits::EXPANDED_INSTRUCTIONS as u64 {
        return Err(ImageError::ExpandedLength);
    }
    calls.check(image)?;
    let (writes, written_by_others) = state.writes(image.initial_bits.len(), image.initial_words.len());
    Ok(Code { rungs, writes, written_by_others })
}

/// Rungs, branches and legs begin and end in turn, within their bounds. Answers with the number of rungs.
fn check_structure(routine: RoutineIndex, record: &RoutineRecord) -> Result<u32, ImageError> {
    let mut rung = 0u32;
    let mut elements: Option<usize> = None;
    let mut legs: Vec<usize> = Vec::new();
    let mut marks = Marks::new(&record.code);
    loop {
        let offset = marks.offset();
        let Some(mark) = marks.next() else { break };
        let mark = mark.map_err(|error| code_error(routine, error))?;
        match (mark, &mut elements) {
            (Mark::Rung, None) => elements = Some(0),
            (Mark::Rung, Some(_)) | (_, None) => return Err(ImageError::RungOutside { routine, offset }),
            (Mark::EndRung, Some(count)) => {
                if !legs.is_empty() {
                    return Err(ImageError::BranchOpen { routine, rung });
                }
                if *count == 0 {
                    return Err(ImageError::RungEmpty { routine, rung });
                }
                elements = None;
                rung = rung.saturating_add(1);
            }
            (Mark::Branch, Some(_)) => {
                if legs.len() >= limits::BRANCH_DEPTH {
                    return Err(ImageError::BranchDepth { routine, rung });
                }
                legs.push(1);
            }
            (Mark::NextLeg, Some(_)) => {
                let count = legs.last_mut().ok_or(ImageError::BranchUnopened { routine, rung })?;
                *count = count.saturating_add(1);
                if *count > limits::BRANCH_LEGS {
                    return Err(ImageError::BranchLegs { routine, rung });
                }
            }
            (Mark::EndBranch, Some(_)) => {
                legs.pop().ok_or(ImageError::BranchUnopened { routine, rung })?;
            }
            (Mark::Instruction(..) | Mark::AddOn(_), Some(count)) => {
                *count = count.saturating_add(1);
                if *count > limits::INSTRUCTIONS_PER_RUNG {
                    return Err(ImageError::RungLength { routine, rung });
                }
            }
        }
    }
    if elements.is_some() { Err(ImageError::RungOpen { routine }) } else { Ok(rung) }
}

/// Every instruction of a routine. Answers with their number, Add-On calls replaced by what they run.
fn check_routine(
    tables: &Tables<'_>,
    entries: &Entries,
    state: &mut State,
    calls: &mut Calls,
    routine: RoutineIndex,
    record: &RoutineRecord,
    owner: Owner,
) -> Result<u64, ImageError> {
    let mut check = Check {
        tables,
        entries,
        state,
        owner,
        at: Site { routine, rung: 0, element: 0 },
        first: true,
        signature: Signature::default(),
        calls: Vec::new(),
        length: 0,
    };
    for mark in Marks::new(&record.code) {
        match mark.map_err(|error| code_error(routine, error))? {
            Mark::Rung => {
                check.at.element = 0;
                check.first = true;
            }
            Mark::EndRung => check.at.rung = check.at.rung.saturating_add(1),
            Mark::Branch | Mark::NextLeg | Mark::EndBranch => check.first = false,
            Mark::Instruction(instruction, operands) => {
                check.instruction(instruction, operands)?;
                check.next();
            }
            Mark::AddOn(operands) => {
                check.add_on(operands)?;
                check.next();
            }
        }
        if check.length > limits::EXPANDED_INSTRUCTIONS as u64 {
            return Err(ImageError::ExpandedLength);
        }
    }
    check.signature.check_labels()?;
    let length = check.length;
    let (signature, made) = (check.signature, check.calls);
    calls.add(routine, signature, made, length);
    Ok(length)
}
