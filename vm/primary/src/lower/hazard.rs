//! Which instructions can fault, and which words of timers logic can write.

use alloc::vec::Vec;

use twinrung_catalog::{Opcode, OperandKind};

use crate::program::{FormulaOperation, Instruction, Location, NONE, Operand, Program};

/// Ranges of word cells that instructions other than timers may make negative.
pub(crate) struct Written {
    /// First cell and first cell behind, sorted, without overlap.
    ranges: Vec<(u32, u32)>,
}

impl Written {
    /// Collects what every instruction writes.
    pub(crate) fn collect(program: &Program) -> Written {
        let mut ranges = Vec::new();
        for instruction in &program.instructions {
            let harmless = match instruction.opcode {
                Opcode::Ton | Opcode::Tof | Opcode::Rto | Opcode::Res => true,
                // The usual way to set a preset.
                Opcode::Mov => matches!(program.operand(instruction.operands, 0), Operand::Integer(0..)),
                Opcode::Clr => true,
                _ => false,
            };
            if harmless {
                continue;
            }
            for index in 0..instruction.operands.count as usize {
                let (_, words) = cells(program, *instruction, index);
                match program.operand(instruction.operands, index).location() {
                    Some(location) if words > 0 && writes(*instruction, index) => {
                        ranges.push(span(program, location, words));
                    }
                    _ => {}
                }
            }
        }
        for argument in &program.arguments {
            for index in [argument.inside, argument.outside] {
                if let Some(Operand::Word { location, .. }) = program.operands.get(index as usize) {
                    ranges.push(span(program, *location, 1));
                }
            }
        }
        ranges.sort_unstable();
        let mut merged: Vec<(u32, u32)> = Vec::new();
        for (first, end) in ranges {
            match merged.last_mut() {
                Some((_, last)) if first <= *last => *last = end.max(*last),
                _ => merged.push((first, end)),
            }
        }
        Written { ranges: merged }
    }

    /// Whether any of `count` cells from `first` on may be written.
    pub(crate) fn touches(&self, first: u32, count: u32) -> bool {
        let end = first.saturating_add(count);
        let position = self.ranges.partition_point(|(_, behind)| *behind <= first);
        self.ranges.get(position).is_some_and(|(begin, _)| *begin < end)
    }
}

/// Whether an instruction may write the data of an operand.
pub(crate) fn writes(instruction: Instruction, index: usize) -> bool {
    // The loader has replaced SIZE's operands by the size and the destination.
    if instruction.opcode == Opcode::Size {
        return index == 1;
    }
    instruction.opcode.instruction().operand(index).is_some_and(|declared| match declared.kind {
        OperandKind::Bit(access)
        | OperandKind::Number(access)
        | OperandKind::Integer(access)
        | OperandKind::Structure(_, access)
        | OperandKind::Parameter(access)
        | OperandKind::SystemData(access) => access.writes(),
        OperandKind::Resettable | OperandKind::CopyDestination | OperandKind::FillDestination => true,
        _ => false,
    })
}

/// Bit and word cells that an instruction reaches through its operand at `index`.
pub(crate) fn cells(program: &Program, instruction: Instruction, index: usize) -> (u32, u32) {
    let plan = program.copies.get(instruction.extra as usize);
    let side = match (instruction.opcode, index, plan) {
        (Opcode::Cop, 0, Some(plan)) => Some((plan.source, plan.source_length())),
        (Opcode::Cop | Opcode::Fll, 1, Some(plan)) | (Opcode::Gsv | Opcode::Ssv, 3, Some(plan)) => {
            Some((plan.destination, plan.length))
        }
        _ => None,
    };
    if let Some((side, elements)) = side {
        return (elements.saturating_mul(side.bit_cells), elements.saturating_mul(side.word_cells));
    }
    match program.operand(instruction.operands, index) {
        Operand::Region { bit_cells, word_cells, .. } => (bit_cells, word_cells),
        Operand::Word { .. } | Operand::WordBit { .. } => (0, 1),
        Operand::Bit(_) => (1, 0),
        _ => (0, 0),
    }
}

/// The word cells that a location can reach, all values of its subscripts considered.
fn span(program: &Program, location: Location, cells: u32) -> (u32, u32) {
    let mut reach = 0u32;
    if location.formula != NONE {
        let formula = program.formulas.get(location.formula as usize).copied().unwrap_or_default();
        for operation in formula.of(&program.formula_operations) {
            if let FormulaOperation::Index { length, word_stride, .. } = operation {
                reach = reach.saturating_add(length.saturating_sub(1).saturating_mul(*word_stride));
            }
        }
    }
    let end = location.word.saturating_add(reach).saturating_add(cells);
    (location.word, end)
}
