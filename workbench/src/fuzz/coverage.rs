//! What a run has reached: instructions with a true and a false rung, instructions after one another, and forms of operands.

use std::collections::BTreeSet;
use std::fmt;

use twinrung_catalog::Opcode;
use twinrung_compiler::operand::{Operand, Reference, Root, Step, Subscript};

/// Opcodes are one byte; 0 stands for the call of an Add-On Instruction.
const OPCODES: usize = 256;

/// What was reached.
#[derive(Debug, Clone)]
pub struct Coverage {
    /// For each opcode, evaluations with a false and with a true rung.
    seen: Vec<[u64; 2]>,
    /// For each opcode and the opcode evaluated after it on the same rung, whether that happened.
    pairs: Vec<bool>,
    /// For each opcode, each operand from 0, the forms that were executed on a true rung.
    forms: BTreeSet<(u8, u8, Form)>,
}

/// How an operand is written, as far as decoding and addressing differ by it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Form {
    /// An integer literal.
    Integer,
    /// A REAL literal.
    Real,
    /// A word out of a list, a name, a routine, a label, or nothing.
    Word,
    /// An expression.
    Expression,
    /// Data.
    Data {
        /// Whether it is reached through an instance or an InOut parameter of an Add-On Instruction.
        inside_add_on: bool,
        /// Whether a tag chooses the element.
        tag_subscript: bool,
        /// Whether it is a bit of an integer.
        bit: bool,
    },
}

impl Form {
    /// The form of an operand.
    pub(crate) fn of(operand: &Operand) -> Form {
        match operand {
            Operand::Integer { .. } => Form::Integer,
            Operand::Real(_) => Form::Real,
            Operand::Expression(_) => Form::Expression,
            Operand::Reference(reference) => Form::of_reference(reference),
            _ => Form::Word,
        }
    }

    fn of_reference(reference: &Reference) -> Form {
        let by_tag = |subscript: &Subscript| matches!(subscript, Subscript::Expression(_));
        Form::Data {
            inside_add_on: !matches!(reference.root, Root::Tag(_)),
            tag_subscript: reference.steps.iter().any(|step| match step {
                Step::Subscript(subscripts) => subscripts.iter().any(by_tag),
                Step::BitExpression(_) => true,
                _ => false,
            }),
            bit: reference.steps.iter().any(|step| matches!(step, Step::Bit(_) | Step::BitExpression(_))),
        }
    }
}

impl Default for Coverage {
    fn default() -> Coverage {
        Coverage { seen: vec![[0; 2]; OPCODES], pairs: vec![false; OPCODES * OPCODES], forms: BTreeSet::new() }
    }
}

impl Coverage {
    pub(crate) fn evaluated(&mut self, opcode: u8, after: Option<u8>, condition: bool) {
        self.seen[usize::from(opcode)][usize::from(condition)] += 1;
        if let Some(after) = after {
            self.pairs[usize::from(after) * OPCODES + usize::from(opcode)] = true;
        }
    }

    pub(crate) fn formed(&mut self, opcode: u8, operand: usize, form: Form) {
        self.forms.insert((opcode, operand.min(usize::from(u8::MAX)) as u8, form));
    }

    /// Adds what another run reached.
    pub fn add(&mut self, other: &Coverage) {
        for (sum, one) in self.seen.iter_mut().zip(&other.seen) {
            sum[0] += one[0];
            sum[1] += one[1];
        }
        self.pairs.iter_mut().zip(&other.pairs).for_each(|(sum, one)| *sum |= one);
        self.forms.extend(&other.forms);
    }

    /// Evaluations of an instruction with a false and with a true rung.
    pub fn of(&self, opcode: Opcode) -> [u64; 2] {
        self.seen[usize::from(opcode as u8)]
    }

    /// Instructions that were evaluated one after the other on a rung, in ordered pairs.
    pub fn pairs(&self) -> usize {
        self.pairs.iter().filter(|reached| **reached).count()
    }

    /// Instruction, operand and form, in threes.
    pub fn forms(&self) -> usize {
        self.forms.len()
    }

    /// Base instructions that were not evaluated, or not on a true or on a false rung, with what is missing.
    pub fn missing(&self) -> Vec<String> {
        let base = Opcode::ALL.iter().filter(|opcode| !opcode.instruction().group.is_safety_library());
        base.filter_map(|opcode| {
            let words = match self.of(*opcode) {
                [0, 0] => "",
                [0, _] => " false",
                [_, 0] => " true",
                _ => return None,
            };
            Some(format!("{}{words}", opcode.instruction().mnemonic))
        })
        .collect()
    }
}

impl fmt::Display for Coverage {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let base = Opcode::ALL.iter().filter(|opcode| !opcode.instruction().group.is_safety_library());
        for opcode in base {
            let [off, on] = self.of(*opcode);
            writeln!(f, "{:<6} {on:>12} true {off:>12} false", opcode.instruction().mnemonic)?;
        }
        let [off, on] = self.seen[0];
        writeln!(f, "Add-On {on:>12} true {off:>12} false")
    }
}
