//! How many elements one execution of FAL or FSC can begin.

use twinrung_catalog::types::base::CONTROL;
use twinrung_catalog::{Opcode, OperandKind};

use super::walk::decoded;
use crate::admitted::AdmittedImage;
use crate::code::Operands;
use crate::index::WordCell;
use crate::limits;
use crate::operand::{Access, AccessType, Base, OperandRecord};

/// The most elements; 0 for every other instruction.
pub(super) fn most(image: &AdmittedImage, opcode: Opcode, operands: Operands<'_>) -> u64 {
    if !matches!(opcode, Opcode::Fal | Opcode::Fsc) {
        return 0;
    }
    let of_mode = match position(opcode, |kind| matches!(kind, OperandKind::FileMode))
        .and_then(|at| decoded(image.image(), operands.get(at)?))
    {
        Some(OperandRecord::Choice(-1)) => 1,
        Some(OperandRecord::Choice(count)) if count > 0 => u64::from(count.unsigned_abs()),
        _ => u64::MAX,
    };
    of_mode.min(constant_length(image, opcode, operands).unwrap_or(u64::from(limits::ARRAY_ELEMENTS)))
}

fn position(opcode: Opcode, is: impl Fn(OperandKind) -> bool) -> Option<usize> {
    opcode.instruction().operands.iter().position(|operand| is(operand.kind))
}

/// LEN, where it lies in the image's own cells, nothing but file instructions writes its CONTROL, and the instruction does
/// not store into that CONTROL itself.
fn constant_length(image: &AdmittedImage, opcode: Opcode, operands: Operands<'_>) -> Option<u64> {
    let OperandRecord::Reference(control) = decoded(image.image(), operands.get(0)?)? else { return None };
    let AccessType::Structure(index) = control.access.access_type else { return None };
    if control.access.base != Base::Absolute || !control.access.terms.is_empty() {
        return None;
    }
    let layout = image.layouts().get(index.position())?;
    let cell = |name: &str| {
        let (member, _) = CONTROL.member(name)?;
        control.access.word_cell.checked_add(layout.members.get(member)?.word_cell)
    };
    let (length, place) = (cell("LEN")?, cell("POS")?);
    if !image.is_constant_word(WordCell(length)) {
        return None;
    }
    if let Some(at) = position(opcode, |kind| matches!(kind, OperandKind::Number(access) if access.writes())) {
        let OperandRecord::Reference(destination) = decoded(image.image(), operands.get(at)?)? else { return None };
        let (begin, end) = reach(&destination.access)?;
        if [length, place].iter().any(|cell| (begin..=end).contains(cell)) {
            return None;
        }
    }
    let value = *image.image().initial_words.get(length as usize)?;
    Some(u64::try_from(value).unwrap_or(0))
}

/// First and last word cell that an access to one word can reach.
fn reach(access: &Access) -> Option<(u32, u32)> {
    if access.base != Base::Absolute {
        return None;
    }
    let mut end = access.word_cell;
    for term in &access.terms {
        end = end.checked_add(term.word_stride.checked_mul(term.length.saturating_sub(1))?)?;
    }
    Some((access.word_cell, end))
}
