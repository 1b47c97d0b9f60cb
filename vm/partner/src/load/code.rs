//! Reads the code bytes of routines: this channel's own decoder of `twinrung_bytecode::format`.

use alloc::vec;
use alloc::vec::Vec;

use twinrung_bytecode::format;
use twinrung_bytecode::image::{Image, Owner};
use twinrung_bytecode::index::OperandIndex;
use twinrung_catalog::Opcode;

use super::cursor::Cursor;

/// One item of a routine's code.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Item<'a> {
    /// Begins a rung.
    Rung,
    /// Ends a rung.
    EndRung,
    /// Begins a branch.
    Branch,
    /// Begins the next leg.
    NextLeg,
    /// Ends a branch.
    EndBranch,
    /// An instruction and its operands.
    Instruction(Opcode, Operands<'a>),
    /// A call of an Add-On Instruction and its operands.
    AddOn(Operands<'a>),
}

/// The operands of an item.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Operands<'a> {
    bytes: &'a [u8],
}

impl Operands<'_> {
    /// How many there are.
    pub(crate) const fn len(&self) -> usize {
        self.bytes.len() / 4
    }

    /// One of them.
    pub(crate) fn get(&self, index: usize) -> Option<OperandIndex> {
        let begin = index.checked_mul(4)?;
        let bytes = self.bytes.get(begin..begin.checked_add(4)?)?;
        Some(OperandIndex(u32::from_le_bytes(bytes.try_into().ok()?)))
    }

    /// All of them.
    pub(crate) fn iter(&self) -> impl Iterator<Item = OperandIndex> + '_ {
        (0..self.len()).filter_map(|index| self.get(index))
    }
}

/// The next item; `None` at the end and where the code is malformed (then bytes are left).
pub(crate) fn item<'a>(cursor: &mut Cursor<'a>) -> Option<Item<'a>> {
    let code = cursor.byte()?;
    Some(match code {
        format::RUNG => Item::Rung,
        format::END_RUNG => Item::EndRung,
        format::BRANCH => Item::Branch,
        format::NEXT_LEG => Item::NextLeg,
        format::END_BRANCH => Item::EndBranch,
        number => {
            let operands = usize::from(cursor.byte()?);
            let operands = Operands { bytes: cursor.take(operands.checked_mul(4)?)? };
            if number == format::ADD_ON {
                Item::AddOn(operands)
            } else {
                Item::Instruction(Opcode::from_number(number)?, operands)
            }
        }
    })
}

/// For each program whether its MCR override can be on: one of its routines holds an MCR. Add-On Instructions hold none
/// (REQ-EXEC-021).
pub(crate) fn zones(image: &Image) -> Vec<bool> {
    let mut zones = vec![false; image.programs.len()];
    for routine in &image.routines {
        let Owner::Program(program) = routine.owner else { continue };
        let mut cursor = Cursor::new(&routine.code);
        let mut items = core::iter::from_fn(|| item(&mut cursor));
        if let Some(zone) = zones.get_mut(program.position()) {
            *zone |= items.any(|item| matches!(item, Item::Instruction(Opcode::Mcr, _)));
        }
    }
    zones
}

/// Whether a safety application instruction stands anywhere.
pub(crate) fn needs_library(image: &Image) -> bool {
    image.routines.iter().any(|routine| {
        let mut cursor = Cursor::new(&routine.code);
        core::iter::from_fn(|| item(&mut cursor)).any(|item| match item {
            Item::Instruction(opcode, _) => opcode.instruction().group.is_safety_library(),
            _ => false,
        })
    })
}
