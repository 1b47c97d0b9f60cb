//! Why an image is refused: one variant for each rule, with its place.

use core::fmt;

use crate::index::*;
use crate::operand::DecodeError;

/// An instruction of the image.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Site {
    /// The routine.
    pub routine: RoutineIndex,
    /// The rung, from 0.
    pub rung: u32,
    /// The instruction on the rung, from 0, in the order of the code.
    pub element: u32,
}

impl fmt::Display for Site {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "routine {}, rung {}, element {}", self.routine, self.rung, self.element)
    }
}

macro_rules! rules {
    ($($name:ident $({ $($field:ident: $type:ty),* $(,)? })? => $text:literal;)*) => {
        /// Why an image is refused. The sentence of a variant is what it prints.
        #[derive(Debug, Clone, PartialEq, Eq)]
        pub enum ImageError {
            $(
                #[doc = $text]
                $name $({
                    $(#[doc = concat!("The ", stringify!($field), " that the sentence names.")] $field: $type,)*
                })?,
            )*
        }

        impl ImageError {
            /// The names of all rules.
            pub const RULES: &'static [&'static str] = &[$(stringify!($name),)*];

            /// The name of the rule that the image breaks.
            pub const fn rule(&self) -> &'static str {
                match self {
                    $(ImageError::$name { .. } => stringify!($name),)*
                }
            }
        }

        impl fmt::Display for ImageError {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                match self {
                    $(ImageError::$name $({ $($field),* })? => write!(f, $text),)*
                }
            }
        }
    };
}

rules! {
    // The file.
    TooManyBytes { count: usize } => "an image of {count} bytes is larger than any that is read";
    NotAnImage => "the file does not begin as an image does";
    UnknownVersion { version: u32 } => "version {version} of the image format is not known here";
    SectionTable { offset: usize } => "byte {offset}: the sections are not those of an image, in their order";
    Truncated { offset: usize } => "byte {offset}: the bytes end before what they promise";
    SlackBytes { offset: usize } => "byte {offset}: bytes are left over";
    NotABoolean { offset: usize } => "byte {offset}: neither 0 nor 1";
    NotText { offset: usize } => "byte {offset}: the text is not UTF-8";
    TooMany { offset: usize, count: usize, limit: usize } => "byte {offset}: {count} entries are more than the {limit} that a table may have";
    UnknownChoice { offset: usize } => "byte {offset}: no choice has this number";
    OperandOffsets { offset: usize } => "byte {offset}: the entries of the operand table do not follow each other";

    // The signatures.
    ImageSignature => "the image signature is not that of the file's content";
    ApplicationSignature => "the application signature is not that of the application's texts and declarations";

    // Code and operands as such.
    UnknownOpcode { routine: RoutineIndex, offset: usize, opcode: u8 } => "routine {routine}, byte {offset}: no instruction has the number {opcode}";
    CodeTruncated { routine: RoutineIndex, offset: usize } => "routine {routine}, byte {offset}: the code ends within an element";
    OperandEncoding { operand: OperandIndex, why: DecodeError } => "operand {operand} is not encoded as operands are: {why}";
    NoSuchOperand { operand: OperandIndex } => "operand {operand} does not exist";
    OperandOrder { operand: OperandIndex } => "operand {operand} does not stand before the operand that uses it";
    OperandDepth { operand: OperandIndex } => "operand {operand} stands too deep within the subscripts of another";
    OperandWithoutText { operand: OperandIndex } => "operand {operand} names what does not exist, or stands where it has no text";
    CallWithoutInstance { operand: OperandIndex } => "operand {operand} is called as the instance of an Add-On Instruction, and is none";
    ExpressionShape { operand: OperandIndex } => "operand {operand} is not a postfix expression that leaves one value";
    MarkOrder { routine: RoutineIndex, rung: u32 } => "routine {routine}, rung {rung}: rungs, branches and legs do not begin and end in turn";

    // Types.
    Layout { why: crate::layout::LayoutError } => "the structure types have no layout: {why:?}";
}

impl core::error::Error for ImageError {}
