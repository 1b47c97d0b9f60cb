//! Rungs with every mnemonic and operand resolved.

use twinrung_catalog::{Instruction as Declaration, Opcode, Position};
use twinrung_grammar::tree::{RungKind, Span};

use super::{AddOnId, OperandId, RoutineId};

/// A set of opcodes.
#[derive(Debug, Clone)]
pub struct OpcodeSet {
    has: [bool; 256],
}

impl Default for OpcodeSet {
    fn default() -> OpcodeSet {
        OpcodeSet { has: [false; 256] }
    }
}

impl OpcodeSet {
    /// Adds one.
    pub fn insert(&mut self, opcode: Opcode) {
        self.has[usize::from(opcode as u8)] = true;
    }

    /// Whether one of these is in it.
    pub fn any(&self, opcodes: &[Opcode]) -> bool {
        opcodes.iter().any(|opcode| self.has[usize::from(*opcode as u8)])
    }

    /// Whether a safety application instruction is in it.
    pub fn any_safety(&self) -> bool {
        Opcode::ALL.iter().any(|opcode| self.any(&[*opcode]) && opcode.instruction().safety.is_some())
    }
}

/// A rung.
#[derive(Debug)]
pub struct Rung {
    /// What is in series from rail to rail.
    pub elements: Vec<Element>,
    /// Normal, or part of an online edit.
    pub kind: RungKind,
    /// The rung's text.
    pub span: Span,
    /// Whether something on it could not be resolved and was left out.
    pub incomplete: bool,
}

/// One thing in a series.
#[derive(Debug)]
pub enum Element {
    /// An instruction or a call of an Add-On Instruction.
    Instruction(Instruction),
    /// Parallel legs, at least one; an empty one is a short circuit.
    Branch(Branch),
}

/// Parallel legs.
#[derive(Debug)]
pub struct Branch {
    /// From top to bottom.
    pub legs: Vec<Vec<Element>>,
    /// Brackets included.
    pub span: Span,
}

/// What is called.
#[derive(Debug, Clone, Copy)]
pub enum Call {
    /// An instruction of the catalog.
    Catalog(&'static Declaration),
    /// An Add-On Instruction.
    AddOn(AddOnId),
}

impl Call {
    /// The opcode, for an instruction of the catalog.
    pub fn opcode(self) -> Option<Opcode> {
        match self {
            Call::Catalog(declaration) => Some(declaration.opcode),
            Call::AddOn(_) => None,
        }
    }

    /// Where it may stand on a rung.
    pub fn position(self) -> Position {
        match self {
            Call::Catalog(declaration) => declaration.position,
            Call::AddOn(_) => Position::Output,
        }
    }
}

/// An instruction on a rung.
#[derive(Debug)]
pub struct Instruction {
    /// What is called.
    pub call: Call,
    /// Its operands in order; of an Add-On Instruction the instance, then one for each parameter that has an argument.
    pub operands: Box<[OperandUse]>,
    /// Its number on the rung, from 0, counted as the image counts (general: instructions only, in the order of the
    /// text).
    pub element: u32,
    /// Mnemonic and parentheses.
    pub span: Span,
}

/// An operand in its place.
#[derive(Debug, Clone, Copy)]
pub struct OperandUse {
    /// The operand.
    pub id: OperandId,
    /// Where the text says it.
    pub span: Span,
}

/// Where an instruction stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Place {
    /// The routine.
    pub routine: RoutineId,
    /// The rung, from 0.
    pub rung: u32,
    /// The instruction on it, from 0.
    pub element: u32,
}

impl Rung {
    /// Visits every instruction in the order of the text. Branches nest at most as deep as the grammar admits.
    pub fn visit<'a>(&'a self, visitor: &mut impl FnMut(&'a Instruction)) {
        fn series<'a>(elements: &'a [Element], visitor: &mut impl FnMut(&'a Instruction)) {
            for element in elements {
                match element {
                    Element::Instruction(instruction) => visitor(instruction),
                    Element::Branch(branch) => {
                        for leg in &branch.legs {
                            series(leg, visitor);
                        }
                    }
                }
            }
        }
        series(&self.elements, visitor);
    }
}
