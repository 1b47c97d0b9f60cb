//! Typed operands, and their bytes as [`mod@crate::format`] describes them. The compiler writes these and the verifier
//! reads them; each interpreter has a decoder of its own.

use alloc::string::String;
use alloc::vec::Vec;

use twinrung_catalog::Element;

use crate::format;
use crate::index::{AddOnIndex, EventTaskIndex, OperandIndex, RoutineIndex, SystemValueIndex, TagIndex, TypeIndex};

mod decode;

pub use decode::DecodeError;
pub(crate) use decode::whole_tag;

/// One entry of the operand table.
#[derive(Debug, Clone, PartialEq)]
pub enum OperandRecord {
    /// An integer literal.
    Integer {
        /// 10, 16, 8 or 2: how the text writes it.
        radix: u8,
        /// Its value.
        value: i32,
    },
    /// A REAL literal: its bits.
    Real(u32),
    /// A word out of a list.
    Choice(i32),
    /// `?`
    Unassigned,
    /// A label, a system class or an instance name.
    Text(String),
    /// A routine of the same program.
    Routine(RoutineIndex),
    /// A status keyword, `format::STATUS_*`.
    Status(u8),
    /// An attribute of a system object.
    SystemValue(SystemValueIndex),
    /// An event task.
    EventTask(EventTaskIndex),
    /// A postfix expression.
    Expression(Vec<Operation>),
    /// Data.
    Reference(Reference),
}

/// One operation of an expression.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Operation {
    /// Push the value of an operand.
    Push(OperandIndex),
    /// Apply an operator, `format::OPERATION_*`.
    Apply(u8),
}

/// A reference to data: what the text says, and where the data is.
#[derive(Debug, Clone, PartialEq)]
pub struct Reference {
    /// Where the path begins.
    pub root: Root,
    /// The steps from there.
    pub steps: Vec<Step>,
    /// Where the data is.
    pub access: Access,
}

/// Where a path begins.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Root {
    /// A tag.
    Tag(TagIndex),
    /// A member of the instance type of the Add-On Instruction.
    Member(AddOnIndex, u16),
    /// An InOut parameter of the Add-On Instruction.
    InOut(AddOnIndex, u16),
}

/// One step of a path.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Step {
    /// Into a member.
    Member(u16),
    /// To an element.
    Subscript(Vec<Subscript>),
    /// To a bit of an integer.
    Bit(u8),
    /// To a bit of an integer that an operand numbers.
    BitOperand(OperandIndex),
}

/// One subscript.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Subscript {
    /// A number.
    Constant(u32),
    /// A reference to a word, or an integer expression.
    Operand(OperandIndex),
}

/// What an access reaches.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Shape {
    /// One bit cell.
    Bit,
    /// One word cell.
    Word,
    /// One bit of a word cell.
    WordBit(BitNumber),
    /// A structure or a whole array.
    Region,
}

/// Which bit of a word, and how many bits the word has.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum BitNumber {
    /// By number.
    Constant {
        /// The bit.
        bit: u8,
        /// 8, 16 or 32.
        length: u8,
    },
    /// By operand.
    Operand {
        /// The operand that numbers it.
        operand: OperandIndex,
        /// 8, 16 or 32.
        length: u8,
    },
}

/// What cells count from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Base {
    /// The image's own cells.
    Absolute,
    /// The instance of the Add-On Instruction whose routine this is.
    Instance,
    /// The argument of this InOut parameter.
    InOut(u16),
}

/// The type at the end of a path.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum AccessType {
    /// Elementary (for a bit of a word: the word's type).
    Element(Element),
    /// A structure.
    Structure(TypeIndex),
}

/// A variable subscript.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Term {
    /// What gives the value.
    pub operand: OperandIndex,
    /// The value must be below this.
    pub length: u32,
    /// Bit cells from one element to the next.
    pub bit_stride: u32,
    /// Word cells from one element to the next.
    pub word_stride: u32,
}

/// Where data is.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Access {
    /// What is reached.
    pub shape: Shape,
    /// The type of it.
    pub access_type: AccessType,
    /// What the cells count from.
    pub base: Base,
    /// Bit cell without variable subscripts.
    pub bit_cell: u32,
    /// Word cell without variable subscripts.
    pub word_cell: u32,
    /// Elements from here to the end of the innermost array.
    pub count: u32,
    /// Variable subscripts.
    pub terms: Vec<Term>,
}

impl OperandRecord {
    /// Appends the entry's bytes.
    pub fn encode(&self, out: &mut Vec<u8>) {
        match self {
            OperandRecord::Integer { radix, value } => {
                out.extend_from_slice(&[format::INTEGER, *radix]);
                out.extend_from_slice(&value.to_le_bytes());
            }
            OperandRecord::Real(bits) => {
                out.push(format::REAL);
                out.extend_from_slice(&bits.to_le_bytes());
            }
            OperandRecord::Choice(value) => {
                out.push(format::CHOICE);
                out.extend_from_slice(&value.to_le_bytes());
            }
            OperandRecord::Unassigned => out.push(format::UNASSIGNED),
            OperandRecord::Text(text) => {
                out.push(format::TEXT);
                out.extend_from_slice(&(text.len() as u16).to_le_bytes());
                out.extend_from_slice(text.as_bytes());
            }
            OperandRecord::Routine(routine) => {
                out.push(format::ROUTINE);
                out.extend_from_slice(&routine.0.to_le_bytes());
            }
            OperandRecord::Status(keyword) => out.extend_from_slice(&[format::STATUS, *keyword]),
            OperandRecord::SystemValue(index) => {
                out.push(format::SYSTEM_VALUE);
                out.extend_from_slice(&index.0.to_le_bytes());
            }
            OperandRecord::EventTask(index) => {
                out.push(format::EVENT_TASK);
                out.extend_from_slice(&index.0.to_le_bytes());
            }
            OperandRecord::Expression(operations) => {
                out.push(format::EXPRESSION);
                out.extend_from_slice(&(operations.len() as u16).to_le_bytes());
                for operation in operations {
                    match operation {
                        Operation::Push(operand) => {
                            out.push(format::OPERATION_PUSH);
                            out.extend_from_slice(&operand.0.to_le_bytes());
                        }
                        Operation::Apply(operator) => out.push(*operator),
                    }
                }
            }
            OperandRecord::Reference(reference) => reference.encode(out),
        }
    }
}

impl Reference {
    fn encode(&self, out: &mut Vec<u8>) {
        let mut path = Vec::new();
        match self.root {
            Root::Tag(tag) => {
                path.push(format::ROOT_TAG);
                path.extend_from_slice(&tag.0.to_le_bytes());
            }
            Root::Member(add_on, member) => {
                path.push(format::ROOT_MEMBER);
                path.extend_from_slice(&add_on.0.to_le_bytes());
                path.extend_from_slice(&member.to_le_bytes());
            }
            Root::InOut(add_on, parameter) => {
                path.push(format::ROOT_IN_OUT);
                path.extend_from_slice(&add_on.0.to_le_bytes());
                path.extend_from_slice(&parameter.to_le_bytes());
            }
        }
        for step in &self.steps {
            match step {
                Step::Member(member) => {
                    path.push(format::STEP_MEMBER);
                    path.extend_from_slice(&member.to_le_bytes());
                }
                Step::Subscript(subscripts) => {
                    path.extend_from_slice(&[format::STEP_SUBSCRIPT, subscripts.len() as u8]);
                    for subscript in subscripts {
                        let (tag, value) = match subscript {
                            Subscript::Constant(value) => (format::SUBSCRIPT_CONSTANT, *value),
                            Subscript::Operand(operand) => (format::SUBSCRIPT_OPERAND, operand.0),
                        };
                        path.push(tag);
                        path.extend_from_slice(&value.to_le_bytes());
                    }
                }
                Step::Bit(bit) => path.extend_from_slice(&[format::STEP_BIT, *bit]),
                Step::BitOperand(operand) => {
                    path.push(format::STEP_BIT_OPERAND);
                    path.extend_from_slice(&operand.0.to_le_bytes());
                }
            }
        }
        out.push(format::REFERENCE);
        out.extend_from_slice(&(path.len() as u16).to_le_bytes());
        out.extend_from_slice(&path);
        self.access.encode(out);
    }
}

impl Access {
    fn encode(&self, out: &mut Vec<u8>) {
        let shape = match self.shape {
            Shape::Bit => format::SHAPE_BIT,
            Shape::Word => format::SHAPE_WORD,
            Shape::WordBit(_) => format::SHAPE_WORD_BIT,
            Shape::Region => format::SHAPE_REGION,
        };
        let (element, type_index) = match self.access_type {
            AccessType::Element(element) => (element as u8, format::NO_INDEX),
            AccessType::Structure(index) => (format::NO_ELEMENT, index.0),
        };
        let (base, parameter) = match self.base {
            Base::Absolute => (format::BASE_ABSOLUTE, format::NO_INDEX),
            Base::Instance => (format::BASE_INSTANCE, format::NO_INDEX),
            Base::InOut(parameter) => (format::BASE_IN_OUT, parameter),
        };
        out.extend_from_slice(&[shape, element]);
        out.extend_from_slice(&type_index.to_le_bytes());
        out.push(base);
        out.extend_from_slice(&parameter.to_le_bytes());
        for cell in [self.bit_cell, self.word_cell, self.count] {
            out.extend_from_slice(&cell.to_le_bytes());
        }
        out.push(self.terms.len() as u8);
        for term in &self.terms {
            for number in [term.operand.0, term.length, term.bit_stride, term.word_stride] {
                out.extend_from_slice(&number.to_le_bytes());
            }
        }
        let (bit, operand, length) = match self.shape {
            Shape::WordBit(BitNumber::Constant { bit, length }) => (bit, format::NO_OPERAND, length),
            Shape::WordBit(BitNumber::Operand { operand, length }) => (format::NO_BIT, operand.0, length),
            _ => (format::NO_BIT, format::NO_OPERAND, 0),
        };
        out.push(bit);
        out.extend_from_slice(&operand.to_le_bytes());
        out.push(length);
    }
}
