//! Which cells an instruction reads and writes, and which instructions a region can take.

use alloc::vec::Vec;

use twinrung_catalog::{Group, Opcode};

use super::lower::Tables;
use crate::ladder::{Argument, Code, Location, Operation, Span, Step, StructureKind};

/// Cells that one COP or FLL of a region may touch; longer ones stay steps.
const SPAN_CELLS: u32 = 64;

/// A cell that an instruction touches.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Effect {
    /// The cell.
    pub(crate) cell: u32,
    /// Whether it is a word.
    pub(crate) word: bool,
    /// Whether it is written.
    pub(crate) written: bool,
}

impl Effect {
    /// The bit cell, where one is written.
    pub(crate) fn written_bit(&self) -> Option<u32> {
        (self.written && !self.word).then_some(self.cell)
    }
}

/// The cells of a region's instructions of no special kind.
#[derive(Debug, Default)]
pub(crate) struct Effects {
    /// Cells, instruction after instruction.
    pub(crate) cells: Vec<Effect>,
}

impl Effects {
    /// Forgets all.
    pub(crate) fn clear(&mut self) {
        self.cells.clear();
    }

    fn push(&mut self, cell: u32, word: bool, written: bool) {
        self.cells.push(Effect { cell, word, written });
    }

    fn bits(&mut self, first: u32, count: u32) {
        for number in 0..count {
            self.push(first.wrapping_add(number), false, true);
        }
    }
}

fn is_bit(argument: Option<&Argument>) -> bool {
    matches!(argument, Some(Argument::At(Location::Bit(_) | Location::WordBit(..))))
}

fn is_number(argument: &Argument) -> bool {
    matches!(argument, Argument::Integer(_) | Argument::Real(_) | Argument::At(Location::Word(..)))
}

fn span(tables: &Tables<'_>, argument: Option<&Argument>) -> Option<Span> {
    match argument {
        Some(Argument::Span(index)) => tables.spans.get(*index as usize).copied(),
        _ => None,
    }
}

fn is_short(tables: &Tables<'_>, argument: Option<&Argument>, length: Option<&Argument>) -> bool {
    let (Some(span), Some(Argument::Integer(length))) = (span(tables, argument), length) else { return false };
    let length = u32::try_from(*length).unwrap_or(u32::MAX);
    let cells = span.bits.saturating_add(span.words).saturating_mul(length);
    matches!(span.start, Argument::At(_)) && length <= span.count && cells <= SPAN_CELLS
}

fn is_fixed(tables: &Tables<'_>, argument: Option<&Argument>) -> bool {
    let Some(Argument::Expression(index)) = argument else { return false };
    operations(tables, *index).iter().all(|operation| {
        matches!(
            operation,
            Operation::Integer(_)
                | Operation::Real(_)
                | Operation::Word(..)
                | Operation::Pattern
                | Operation::Apply { .. }
        )
    })
}

fn operations<'a>(tables: &'a Tables<'_>, expression: u32) -> &'a [Operation] {
    let range = tables.expressions.get(expression as usize);
    range.and_then(|range| tables.operations.get(range.begin as usize..range.end as usize)).unwrap_or(&[])
}

/// Whether a region can take the step: it cannot fault, jump or call, and all its cells are known.
pub(crate) fn is_admissible(tables: &Tables<'_>, step: Step, zone: bool) -> bool {
    let Code::Instruction(opcode) = step.code else {
        return matches!(step.code, Code::Branch | Code::NextLeg | Code::EndBranch);
    };
    let arguments = tables.arguments_of(step);
    let (first, second, third) = (arguments.first(), arguments.get(1), arguments.get(2));
    match opcode {
        Opcode::Xic | Opcode::Xio | Opcode::Ote | Opcode::Otl | Opcode::Otu | Opcode::Ons => is_bit(first),
        Opcode::Osr | Opcode::Osf => is_bit(first) && is_bit(second) && first != second,
        Opcode::Afi | Opcode::Nop | Opcode::Lbl | Opcode::Sbr => true,
        Opcode::Mcr => zone,
        Opcode::Ton | Opcode::Tof | Opcode::Rto | Opcode::Ctu | Opcode::Ctd => {
            matches!(first, Some(Argument::At(Location::Region { .. })))
        }
        Opcode::Res => matches!(
            first,
            Some(Argument::At(Location::Region {
                kind: StructureKind::Timer | StructureKind::Counter | StructureKind::Control,
                ..
            }))
        ),
        Opcode::Cmp => is_fixed(tables, first),
        Opcode::Cpt => matches!(first, Some(Argument::At(Location::Word(..)))) && is_fixed(tables, second),
        Opcode::Cop => is_short(tables, first, third) && is_short(tables, second, third),
        Opcode::Fll => first.is_some_and(is_number) && is_short(tables, second, third),
        Opcode::Fal | Opcode::Fsc => false,
        _ => match opcode.instruction().group {
            Group::Compare | Group::Move | Group::Logical | Group::Math => arguments.iter().all(is_number),
            Group::Array => arguments.iter().all(is_number),
            _ => false,
        },
    }
}

/// Whether the instruction reads or changes the arithmetic status.
pub(crate) fn has_status(opcode: Opcode) -> bool {
    match opcode.instruction().group {
        Group::Math | Group::Logical | Group::Array => true,
        Group::Move => !matches!(opcode, Opcode::Cop | Opcode::Swpb),
        Group::Compare => opcode == Opcode::Cmp,
        _ => false,
    }
}

fn written_span(span: Span, length: Option<&Argument>, effects: &mut Effects, written: bool) {
    let length = match length {
        Some(Argument::Integer(length)) => u32::try_from(*length).unwrap_or(0),
        _ => 0,
    };
    let (bit, word) = match span.start {
        Argument::At(Location::Region { bit, word, .. }) => (bit, word),
        Argument::At(Location::Word(word, _)) => (0, word),
        _ => (0, 0),
    };
    for number in 0..span.bits.saturating_mul(length) {
        effects.push(bit.wrapping_add(number), false, written);
    }
    for number in 0..span.words.saturating_mul(length) {
        effects.push(word.wrapping_add(number), true, written);
    }
}

/// The cells of an instruction of no special kind.
pub(crate) fn of_step(tables: &Tables<'_>, step: Step, opcode: Opcode, effects: &mut Effects) {
    let arguments = tables.arguments_of(step);
    let last = arguments.len().wrapping_sub(1);
    match opcode {
        Opcode::Ctu | Opcode::Ctd | Opcode::Res => {
            if let Some(Argument::At(Location::Region { bit, word, kind })) = arguments.first() {
                let bits = match kind {
                    StructureKind::Timer => 3,
                    StructureKind::Counter => 5,
                    _ => 8,
                };
                effects.bits(*bit, bits);
                effects.push(*word, true, false);
                effects.push(word.wrapping_add(1), true, true);
            }
        }
        Opcode::Cop => {
            for (index, written) in [(0usize, false), (1, true)] {
                if let Some(span) = span(tables, arguments.get(index)) {
                    written_span(span, arguments.get(2), effects, written);
                }
            }
        }
        _ => {
            for (index, argument) in arguments.iter().enumerate() {
                match argument {
                    Argument::At(Location::Word(cell, _)) => {
                        let destination = match opcode {
                            Opcode::Cpt => index == 0,
                            Opcode::Fll => false,
                            _ => index == last && opcode.instruction().group != Group::Compare,
                        };
                        effects.push(*cell, true, destination);
                    }
                    Argument::Expression(index) => {
                        for operation in operations(tables, *index) {
                            if let Operation::Word(cell, _) = operation {
                                effects.push(*cell, true, false);
                            }
                        }
                    }
                    Argument::Span(_) => {
                        if let Some(span) = span(tables, Some(argument)) {
                            written_span(span, arguments.get(2), effects, true);
                        }
                    }
                    _ => {}
                }
            }
        }
    }
}

/// The words that a step writes, timers and RES left out: these keep what a timer requires of its words.
pub(crate) fn written_words(tables: &Tables<'_>, step: Step, words: &mut Vec<u32>) {
    let Code::Instruction(opcode) = step.code else { return };
    match opcode {
        Opcode::Ote | Opcode::Otl | Opcode::Otu | Opcode::Ons | Opcode::Osr | Opcode::Osf => {
            for argument in tables.arguments_of(step) {
                if let Argument::At(Location::WordBit(word, ..)) = argument {
                    words.push(*word);
                }
            }
        }
        Opcode::Ton | Opcode::Tof | Opcode::Rto | Opcode::Res => {}
        _ => {
            let mut effects = Effects::default();
            of_step(tables, step, opcode, &mut effects);
            words.extend(effects.cells.iter().filter(|effect| effect.word && effect.written).map(|effect| effect.cell));
        }
    }
}
