//! Why a vector file cannot be read.

use core::fmt;
use twinrung_catalog::Opcode;

/// A line of a vector file that cannot be read.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct VectorError {
    /// The instruction whose file it is.
    pub opcode: Opcode,
    /// The line, counted from 1; 0 where no line is meant.
    pub line: usize,
    /// What is wrong.
    pub kind: VectorErrorKind,
}

/// What is wrong with a line of a vector file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum VectorErrorKind {
    /// The instruction has no vectors: it is not a safety application instruction.
    NoVectors,
    /// The line begins with no known word.
    UnknownLine,
    /// A line stands before `vector`, or a part of the head after the first time.
    OutOfPlace,
    /// `vector`, `source`, `mark`, `period` or `end` is missing.
    Incomplete,
    /// A time or a period is not a number, or is 0 where it must not be.
    BadNumber,
    /// Times do not rise, or a time is no multiple of every period.
    BadTime,
    /// An item is not `NAME=value`.
    BadItem,
    /// No operand of the instruction is mirrored in a member of this name.
    UnknownOperand,
    /// The name is not that of an output member.
    UnknownMember,
    /// The value cannot be read as the member's type or word.
    BadValue,
}

impl fmt::Display for VectorErrorKind {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(match self {
            Self::NoVectors => "the instruction is not a safety application instruction",
            Self::UnknownLine => "the line begins with no known word",
            Self::OutOfPlace => "the line stands out of place",
            Self::Incomplete => "the vector lacks its name, source, mark, period or end",
            Self::BadNumber => "a number was expected",
            Self::BadTime => "times must rise and be multiples of every period",
            Self::BadItem => "an item must read NAME=value",
            Self::UnknownOperand => "no operand is mirrored in a member of this name",
            Self::UnknownMember => "no output member has this name",
            Self::BadValue => "the value does not fit the member",
        })
    }
}

impl fmt::Display for VectorError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "{}.vectors:{}: {}", self.opcode.instruction().mnemonic, self.line, self.kind)
    }
}

impl core::error::Error for VectorError {}
