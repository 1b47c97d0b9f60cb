//! A signal: one value of a running controller, by the name an engineer writes.

use std::fmt;

use twinrung_bytecode::index::{BitCell, WordCell};
use twinrung_catalog::Element;

/// One value of a running controller.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Signal {
    /// A BOOL.
    Bit(BitCell),
    /// A number.
    Word(WordCell, Element),
    /// A bit of an integer.
    WordBit(WordCell, u8),
    /// A BOOL as it is published: what the machine sees.
    PublishedBit(BitCell),
    /// A number as it is published.
    PublishedWord(WordCell, Element),
    /// A bit of an integer as it is published.
    PublishedWordBit(WordCell, u8),
    /// 0 Program, 1 Run.
    ControllerMode,
    /// 0, or type x 1000 + code of the fault that stopped the safety task.
    ControllerFault,
}

/// A recorded value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Value {
    /// BOOL.
    Bool(bool),
    /// SINT, INT or DINT.
    Integer(i32),
    /// REAL.
    Real(f32),
}

impl Value {
    /// Whether it is a true BOOL, or not 0.
    pub fn is_true(&self) -> bool {
        match self {
            Value::Bool(value) => *value,
            Value::Integer(value) => *value != 0,
            Value::Real(value) => *value != 0.0,
        }
    }
}

impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Value::Bool(value) => write!(f, "{}", u8::from(*value)),
            Value::Integer(value) => write!(f, "{value}"),
            // The shortest text that reads back as the same bits, the same on every machine.
            Value::Real(value) => write!(f, "{value:?}"),
        }
    }
}

/// Why a name is not a signal, or a text is not a value of it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum SignalError {
    /// No tag of that name.
    NoSuchTag {
        /// The name as written.
        name: String,
        /// A name that is close to it.
        close: Option<String>,
    },
    /// The tag is there but what follows its name is not.
    NoSuchMember {
        /// The name as written.
        name: String,
        /// The part that is not there.
        part: String,
    },
    /// It names a structure or an array, which has no single value.
    NotOneValue {
        /// The name as written.
        name: String,
    },
    /// A program tag's program is not there.
    NoSuchProgram {
        /// The name as written.
        name: String,
    },
    /// Logic writes the tag: a stimulus may not drive it.
    WrittenByLogic {
        /// The name as written.
        name: String,
    },
    /// A published value or a controller value cannot be driven.
    NotDriven {
        /// The name as written.
        name: String,
    },
    /// The text is not a value of the tag's type.
    Value {
        /// The name as written.
        name: String,
        /// The text.
        found: String,
        /// The type.
        element: Element,
    },
}

impl fmt::Display for SignalError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            SignalError::NoSuchTag { name, close: Some(close) } => {
                write!(f, "there is no tag `{name}`; did you mean `{close}`?")
            }
            SignalError::NoSuchTag { name, close: None } => write!(f, "there is no safety tag `{name}`"),
            SignalError::NoSuchMember { name, part } => write!(f, "`{name}`: there is no `{part}`"),
            SignalError::NotOneValue { name } => {
                write!(f, "`{name}` is a structure or an array; name one of its members or elements")
            }
            SignalError::NoSuchProgram { name } => {
                write!(f, "`{name}`: there is no such program; a program's tag is written Program:NAME.TAG")
            }
            SignalError::WrittenByLogic { name } => {
                write!(f, "`{name}` is written by logic; a stimulus may drive only what no logic writes")
            }
            SignalError::NotDriven { name } => write!(f, "`{name}` can be recorded, not driven"),
            SignalError::Value { name, found, element } => {
                write!(f, "`{found}` is not a value of `{name}`, which is a {}", element.name())
            }
        }
    }
}

impl std::error::Error for SignalError {}

impl Signal {
    /// The same place as it is published.
    pub fn published(self) -> Signal {
        match self {
            Signal::Bit(cell) => Signal::PublishedBit(cell),
            Signal::Word(cell, element) => Signal::PublishedWord(cell, element),
            Signal::WordBit(cell, bit) => Signal::PublishedWordBit(cell, bit),
            other => other,
        }
    }
}

/// What a word cell of this type holds, as a value.
pub fn number(word: i32, element: Element) -> Value {
    if element == Element::Real { Value::Real(f32::from_bits(word as u32)) } else { Value::Integer(word) }
}

/// A bit of a word, counted from the least; past the last it is the last.
pub fn bit_of(word: i32, bit: u8) -> Value {
    Value::Bool((word >> bit.min(31)) & 1 == 1)
}

/// Reads a stimulus cell as a value of an elementary type; the result is the content of its cell.
pub fn parse_value(name: &str, text: &str, element: Element) -> Result<i32, SignalError> {
    let wrong = || SignalError::Value { name: name.to_owned(), found: text.to_owned(), element };
    let within = |least: i32, greatest: i32| {
        text.parse::<i32>().ok().filter(|value| (least..=greatest).contains(value)).ok_or_else(wrong)
    };
    match element {
        Element::Bool => within(0, 1),
        Element::Sint => within(i32::from(i8::MIN), i32::from(i8::MAX)),
        Element::Int => within(i32::from(i16::MIN), i32::from(i16::MAX)),
        Element::Dint => within(i32::MIN, i32::MAX),
        Element::Real => text.parse::<f32>().map(|value| value.to_bits() as i32).map_err(|_| wrong()),
    }
}
