//! Which instructions can fault, and which words of timers logic can write.

use alloc::vec::Vec;

use twinrung_catalog::{Opcode, OperandKind};

use crate::program::{Content, FormulaOperation, Instruction, Location, NONE, Operand, Program};

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
                let operand = program.operand(instruction.operands, index);
                if writes(*instruction, index) {
                    note(program, *instruction, operand, &mut ranges);
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


fn note(program: &Program, instruction: Instruction, operand: Operand, ranges: &mut Vec<(u32, u32)>) {
    match operand {
        Operand::Word { location, .. } | Operand::WordBit { location, .. } | Operand::Region { location, .. } => {
            let cells = words(program, instruction, operand);
            ranges.push(span(program, location, cells));
        }
        _ => {}
    }
}

/// Word cells that an instruction reaches through an operand.
pub(crate) fn words(program: &Program, instruction: Instruction, operand: Operand) -> u32 {
    let copied = copied(program, instruction, operand).map(|(_, words)| words);
    match operand {
        Operand::Region { word_cells, .. } => copied.unwrap_or(word_cells),
        Operand::Word { .. } => copied.unwrap_or(1),
        Operand::WordBit { .. } => 1,
        _ => 0,
    }
}

/// Bit cells that an instruction reaches through an operand.
pub(crate) fn bits(program: &Program, instruction: Instruction, operand: Operand) -> u32 {
    match operand {
        Operand::Region { bit_cells, .. } => {
            copied(program, instruction, operand).map_or(bit_cells, |(bits, _)| bits)
        }
        Operand::Bit(_) => 1,
        _ => 0,
    }
}

/// Bit and word cells of a copy's side: as many elements as the longer side of the plan has bytes for.
fn copied(program: &Program, instruction: Instruction, operand: Operand) -> Option<(u32, u32)> {
    if !matches!(instruction.opcode, Opcode::Cop | Opcode::Fll | Opcode::Gsv | Opcode::Ssv) {
        return None;
    }
    let plan = program.copies.get(instruction.extra as usize)?;
    let content = match operand {
        Operand::Region { content, .. } => content,
        Operand::Word { element, .. } => Content::Element(element),
        _ => return None,
    };
    let side = if plan.source.content == content { plan.source } else { plan.destination };
    let bytes = plan.length.saturating_mul(plan.destination.bytes.max(plan.source.bytes));
    let elements = bytes.checked_div(side.bytes).unwrap_or(0).saturating_add(1).min(side.count);
    let elements = elements.max(plan.length.min(side.count));
    Some((elements.saturating_mul(side.bit_cells), elements.saturating_mul(side.word_cells)))
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
