//! Which declared codes the vectors reach.

use crate::error::VectorError;
use alloc::vec::Vec;
use twinrung_catalog::{Code, Opcode};

/// What the vectors of one instruction cover.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Coverage {
    /// The instruction.
    pub opcode: Opcode,
    /// How many vectors it has.
    pub vectors: usize,
    /// The declared codes that some vector expects.
    pub reached: Vec<&'static Code>,
    /// The declared codes that no vector expects.
    pub missing: Vec<&'static Code>,
}

/// What the vectors of an instruction cover.
///
/// # Errors
///
/// As [`for_instruction`](crate::for_instruction).
pub fn coverage(opcode: Opcode) -> Result<Coverage, VectorError> {
    let vectors = crate::for_instruction(opcode)?;
    let declared = opcode.instruction().safety.map_or(&[][..], |declaration| declaration.codes);
    let (reached, missing) = declared
        .iter()
        .partition(|code| vectors.iter().any(|vector| vector.expected_codes().any(|expected| expected == *code)));
    Ok(Coverage { opcode, vectors: vectors.len(), reached, missing })
}
