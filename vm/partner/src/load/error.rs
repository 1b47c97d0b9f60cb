//! Why an image cannot be loaded.

use alloc::string::String;
use core::fmt;

use twinrung_bytecode::index::{OperandIndex, RoutineIndex};

/// Why this channel could not load an admitted image.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum LoadError {
    /// P001: an operand is not what the admitted form says; the image was changed after it was admitted, or the
    /// verifier has a gap.
    Operand(OperandIndex),
    /// P002: the code of a routine is not what the admitted form says.
    Routine(RoutineIndex),
    /// P003: the cells of the image and the channel's own do not fit the largest bank.
    Cells(usize),
    /// P004: subscripts and expressions unfold to too many operations.
    Operations,
    /// P005: the ladder library has no definition for this safety application instruction.
    Library(&'static str),
    /// P006: the definition in the ladder library does not fit the instruction's declaration.
    LibraryParameter {
        /// The instruction.
        mnemonic: &'static str,
        /// The parameter that does not fit.
        parameter: String,
    },
    /// P007: the ladder library itself is not readable, or not the one that was verified when it was built.
    LibraryImage(String),
}

impl fmt::Display for LoadError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            LoadError::Operand(operand) => {
                write!(f, "P001: operand {} is malformed; admit the image again", operand.0)
            }
            LoadError::Routine(routine) => {
                write!(f, "P002: the code of routine {} is malformed; admit the image again", routine.0)
            }
            LoadError::Cells(cells) => {
                write!(f, "P003: {cells} cells do not fit the partner's memory; split the application")
            }
            LoadError::Operations => f.write_str(
                "P004: subscripts and expressions unfold to too many operations; use fewer nested subscripts",
            ),
            LoadError::Library(mnemonic) => {
                write!(f, "P005: the partner's library has no ladder for {mnemonic}; use a release that has it")
            }
            LoadError::LibraryParameter { mnemonic, parameter } => {
                write!(
                    f,
                    "P006: parameter {parameter} of the partner's ladder for {mnemonic} fits no operand or member"
                )
            }
            LoadError::LibraryImage(reason) => write!(f, "P007: the partner's library cannot be read: {reason}"),
        }
    }
}

impl core::error::Error for LoadError {}
