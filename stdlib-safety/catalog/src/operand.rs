//! What an operand may be.

use crate::predefined::PredefinedType;

/// One operand of an instruction, in neutral-text order.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Operand {
    /// The operand's name as the manuals label it.
    pub name: &'static str,
    /// What may stand there.
    pub kind: OperandKind,
    /// Whether any number of further operands of this kind may follow (only on the last operand).
    pub repeats: bool,
}

/// What an instruction does with the data of an operand.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Access {
    /// It is read.
    Read,
    /// It is written, and not read.
    Write,
    /// It is read and written.
    ReadWrite,
}

impl Access {
    /// Whether the instruction can change the operand.
    pub const fn writes(self) -> bool {
        matches!(self, Access::Write | Access::ReadWrite)
    }
}

/// What may stand in an operand's place.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum OperandKind {
    /// A BOOL tag, an element of a BOOL array, a bit of an integer, or a status keyword where it is only read.
    Bit(Access),
    /// SINT, INT, DINT or REAL: a tag, or an immediate where it is only read.
    Number(Access),
    /// SINT, INT or DINT: a tag, or an immediate where it is only read.
    Integer(Access),
    /// A tag of exactly this structure type.
    Structure(&'static PredefinedType, Access),
    /// A TIMER, COUNTER or CONTROL tag (RES).
    Resettable,
    /// Shows the member of the preceding structure operand; `?` keeps its value, a literal initialises it.
    Pseudo(&'static str),
    /// Source of COP: a number, structure or element of an array of either.
    CopySource,
    /// Destination of COP.
    CopyDestination,
    /// Destination of FLL: a number tag, the first of the elements that are filled.
    FillDestination,
    /// A positive integer literal (number of elements).
    ConstantLength,
    /// An arithmetic expression (CPT, FAL).
    Expression,
    /// An expression that is used as a truth value (CMP, FSC).
    Condition,
    /// `ALL`, `INC` or a positive integer (elements per scan). In an image: 0 = ALL, -1 = INC, n = n.
    FileMode,
    /// `REVERSE`, `WORD` or `HIGH/LOW`. In an image: 0, 1, 2.
    ByteOrder,
    /// An array or an element of one (SIZE).
    Array,
    /// 0, 1 or 2: which dimension (SIZE).
    Dimension,
    /// A label of the same routine, jumped to.
    Label,
    /// A label, defined here.
    LabelDefinition,
    /// A routine of the same program.
    Routine,
    /// How many of the operands that follow are inputs (JSR).
    InputCount,
    /// A parameter passed in, received or returned (JSR, SBR, RET): BOOL, a number or a structure.
    Parameter(Access),
    /// An event task of class Standard.
    EventTask,
    /// GSV/SSV object class.
    SystemClass,
    /// GSV/SSV instance name, may be empty.
    SystemInstance,
    /// GSV/SSV attribute.
    SystemAttribute,
    /// GSV destination or SSV source: a tag with enough bytes from its start.
    SystemData(Access),
    /// One word out of a list; the image holds its value.
    Choice(&'static ChoiceList),
    /// An integer literal in a range, both ends included, in `unit` ("ms", "s", "" where it has none), a multiple of `step`.
    Literal {
        /// Whether 0 is admitted beside the range ("no limit", "not used").
        or_zero: bool,
        /// Least value admitted.
        least: i32,
        /// Greatest value admitted.
        greatest: i32,
        /// The value must be a multiple of this.
        step: i32,
        /// `ms`, `s`, or empty.
        unit: &'static str,
    },
    /// BOOL input of a safety application instruction: a tag, or an immediate 0 or 1 where `immediate`.
    SafetyBit {
        /// Whether 0 and 1 may stand there.
        immediate: bool,
    },
    /// DINT input of a safety application instruction, read in every scan: a tag (SINT and INT are sign-extended), or
    /// an immediate.
    SafetyInteger {
        /// Least and greatest value of an immediate; `None` where only a tag may stand. What a tag holds is judged by
        /// the instruction itself when it runs.
        immediate: Option<(i32, i32)>,
        /// `ms`, or empty.
        unit: &'static str,
    },
    /// REAL input of a safety application instruction, read in every scan: a tag, or a finite immediate.
    SafetyReal {
        /// Whether an immediate may stand there.
        immediate: bool,
        /// Whether an immediate below 0 is refused.
        not_negative: bool,
    },
}

/// A literal in milliseconds, both ends included.
pub const fn milliseconds(least: i32, greatest: i32) -> OperandKind {
    OperandKind::Literal { or_zero: false, least, greatest, step: 1, unit: "ms" }
}

/// A BOOL input where only a tag may stand.
pub const TAG: OperandKind = OperandKind::SafetyBit { immediate: false };

/// A BOOL input where a tag or an immediate 0 or 1 may stand.
pub const TAG_OR_IMMEDIATE: OperandKind = OperandKind::SafetyBit { immediate: true };

/// The words that may stand in a choice operand.
#[derive(Debug, PartialEq, Eq)]
pub struct ChoiceList {
    /// The list's name as the manuals label it.
    pub name: &'static str,
    /// Words and values; the first spelling of a value is the one that is printed, the others are read too.
    pub words: &'static [(&'static str, i32)],
}

impl ChoiceList {
    /// The value of a word, or of the decimal number of one of the list's values. Case, `_` for blanks and repeated
    /// blanks make no difference. dual-channel-inputs.md D1.
    pub fn value(&self, word: &str) -> Option<i32> {
        let number = word.trim().parse::<i32>().ok();
        self.words
            .iter()
            .find(|(known, value)| same_words(known, word) || number == Some(*value))
            .map(|(_, value)| *value)
    }

    /// The word that is printed for a value.
    pub fn word(&self, value: i32) -> Option<&'static str> {
        self.words.iter().find(|(_, known)| *known == value).map(|(word, _)| *word)
    }
}

fn same_words(known: &str, written: &str) -> bool {
    let words = |text| -> core::str::Split<'_, fn(char) -> bool> {
        str::split(text, (|c: char| c == '_' || c.is_whitespace()) as fn(char) -> bool)
    };
    let mut known = words(known).filter(|word| !word.is_empty());
    let mut written = words(written).filter(|word| !word.is_empty());
    loop {
        match (known.next(), written.next()) {
            (None, None) => return true,
            (Some(a), Some(b)) if a.eq_ignore_ascii_case(b) => {}
            _ => return false,
        }
    }
}

/// Declares an operand that occurs once.
pub const fn operand(name: &'static str, kind: OperandKind) -> Operand {
    Operand { name, kind, repeats: false }
}

/// Declares the last operand, which may occur any number of times.
pub const fn repeated(name: &'static str, kind: OperandKind) -> Operand {
    Operand { name, kind, repeats: true }
}
