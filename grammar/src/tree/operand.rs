//! What an operand can be read as: a tag reference, an expression, an immediate value, words.

use super::{CompactString, Name, Span};

/// A reference to a tag, an element, a member or a bit.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct TagReference {
    /// `\Program.`: a parameter of another program.
    pub program: Option<Name>,
    /// The tag: a name, a module tag (`Doors:I`, `Local:2:I`), or a status keyword (`S:FS`).
    pub base: Name,
    /// Members, subscripts and bits in order.
    pub parts: Vec<Part>,
    /// Everything.
    pub span: Span,
}

/// One step from a tag into its data.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Part {
    /// `.Member`
    Member(Name),
    /// `[i]`, `[i,j]`, `[i,j,k]`
    Subscripts {
        /// One to three.
        subscripts: Vec<Expression>,
        /// Brackets included.
        span: Span,
    },
    /// `.5`
    Bit {
        /// The bit, from 0.
        number: u32,
        /// Without the dot.
        span: Span,
    },
    /// `.[Index]`
    BitSubscript {
        /// Which bit.
        index: Box<Expression>,
        /// Brackets included.
        span: Span,
    },
}

/// An expression of CMP, CPT, FAL, FSC or a subscript.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Expression {
    /// An immediate value.
    Immediate(Immediate),
    /// A tag.
    Tag(TagReference),
    /// `-a`, `NOT a`
    Unary {
        /// Which.
        operator: UnaryOperator,
        /// Of what.
        operand: Box<Expression>,
        /// Everything.
        span: Span,
    },
    /// `a + b`
    Binary {
        /// Which.
        operator: BinaryOperator,
        /// Left.
        left: Box<Expression>,
        /// Right.
        right: Box<Expression>,
        /// Everything.
        span: Span,
    },
    /// `SQR(a)`: also functions that nobody knows.
    Call {
        /// The function, as written.
        function: Name,
        /// What it is called with.
        arguments: Vec<Expression>,
        /// Everything.
        span: Span,
    },
}

impl Expression {
    /// Where (surrounding parentheses not included).
    pub fn span(&self) -> Span {
        match self {
            Expression::Immediate(immediate) => immediate.span,
            Expression::Tag(tag) => tag.span,
            Expression::Unary { span, .. } | Expression::Binary { span, .. } | Expression::Call { span, .. } => *span,
        }
    }
}

/// Operators before their operand.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum UnaryOperator {
    /// `-`
    Negate,
    /// `NOT`
    Not,
}

/// Operators between their operands.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum BinaryOperator {
    /// `**` (not admitted in safety logic)
    Power,
    /// `*`
    Multiply,
    /// `/`
    Divide,
    /// `MOD`
    Modulo,
    /// `<`
    Less,
    /// `<=`
    LessOrEqual,
    /// `>`
    Greater,
    /// `>=`
    GreaterOrEqual,
    /// `=`
    Equal,
    /// `<>`
    NotEqual,
    /// `-`
    Subtract,
    /// `+`
    Add,
    /// `AND`
    And,
    /// `XOR`
    Xor,
    /// `OR`
    Or,
}

impl BinaryOperator {
    /// Whether the result is 0 or 1.
    pub fn is_relation(self) -> bool {
        use BinaryOperator::*;
        matches!(self, Less | LessOrEqual | Greater | GreaterOrEqual | Equal | NotEqual)
    }
}

/// An immediate value and how it was written.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Immediate {
    /// What it is.
    pub number: Number,
    /// As written.
    pub text: CompactString,
    /// Where.
    pub span: Span,
}

/// What a literal says.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Number {
    /// A whole number; `16#ff` and the like are bit patterns that the compiler fits to a type.
    Integer {
        /// A minus sign.
        negative: bool,
        /// The digits' value.
        magnitude: u64,
        /// The base.
        radix: Radix,
    },
    /// A REAL: the bits of the binary32 nearest to the decimal text (halves to even).
    Real {
        /// IEEE 754 binary32.
        bits: u32,
    },
    /// `1.#QNAN`, `1.#INF`, `1.$` ...: the bits of that value.
    Special {
        /// IEEE 754 binary32.
        bits: u32,
    },
    /// `'AB'`: the bytes, escapes resolved.
    Ascii(Vec<u8>),
}

/// The base in which an integer is written.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Radix {
    /// `100`
    Decimal,
    /// `16#64`
    Hexadecimal,
    /// `8#144`
    Octal,
    /// `2#0110_0100`
    Binary,
}

/// Option words: `EQUIVALENT - ACTIVE HIGH`.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Words {
    /// Upper case; one blank between words, none around a hyphen that had none (`E-STOP`); quotes
    /// around the whole removed.
    pub text: CompactString,
    /// Where.
    pub span: Span,
}
