//! Test vectors of the safety application instructions: what goes in, what must come out, and where that stands.
//!
//! Every vector is a run of one instruction from its prescan on. Its expectations come from the reference alone: the
//! trace tables are taken over row by row, the others apply the reference's state machines to further inputs. Both
//! halves of the safety library are judged by them. A vector names every output member at time 0, so each scan is
//! compared completely.
//!
//! # The format
//!
//! One text file per instruction, `vectors/<mnemonic>.vectors`. A line that begins with `;` is a comment; blank lines
//! separate vectors. Names are members of the backing tag, in the spelling of the catalog.
//!
//! ```text
//! vector DCS-9
//! shows  input-status fault, one Reset edge clears it and energizes O1
//! source dual-channel-inputs.md 4.6, trace DCS-9
//! mark   sourced or recalled
//! period 10
//! config RestartType=MANUAL ColdStartType=AUTOMATIC DiscrepancyTime=100 InputType=EQUIVALENT_ACTIVE_HIGH SafetyFunction=E-STOP
//! 0      InputStatus=1 ChannelA=1 ChannelB=1 -> O1=1 FP=0 FaultCode=0 DiagnosticCode=0
//! 50     InputStatus=0 ChannelA=0 ChannelB=0 -> O1=0 FP=1 FaultCode=16#20 DiagnosticCode=16#20
//! 200    end
//! ```
//!
//! * `shows`: what the vector is about. `source`: file and section of the reference; `trace ...` where a row of its
//!   tables was taken over. `mark`: the reference's origin mark of what is expected (`recalled`, `decided`, `doc`).
//! * `normal`: marks the one vector of an instruction that shows its normal operation, and says what to see in it. The
//!   instruction's page draws its timing diagram from this vector.
//! * `period`: the periods in ms with which the vector may be run, each with the same expectations.
//! * `config`: the configuration operands, choices as words with `_` for blanks.
//! * A line that begins with a number is a time in ms since the first scan. Left of `->` stand input operands that
//!   change before the scan at that time, `rung=0` or `rung=1`, and `prescan` where a prescan comes before that scan;
//!   right of it output members that have this value from that scan on. Everything keeps its value until a later line.
//!   `leap=N` stands there too: the scan at this time and all after it come N ms later, so that times can be run that no
//!   period reaches. Later lines and `end` keep their times as if nothing had leapt.
//!   A configuration operand may stand there too: it then changes at run time, which no admitted image can do.
//! * At the start every input is 0, the rung condition is 1, and a prescan has been executed with the operands of
//!   time 0. Scans are at 0, period, 2 x period ... up to and including the time of `end`.
//! * Values are decimal, `16#` hexadecimal, a word of a choice list, or a REAL where the member is REAL (`NaN`, `inf`).
//!
//! This crate depends on the catalog alone. It executes no instruction.

#![no_std]
#![forbid(unsafe_code)]
#![cfg_attr(
    not(test),
    deny(
        clippy::indexing_slicing,
        clippy::arithmetic_side_effects,
        clippy::panic,
        clippy::unwrap_used,
        clippy::expect_used
    )
)]

extern crate alloc;

mod coverage;
mod error;
mod parse;
mod replay;
mod text;
mod value;
mod vector;

pub use coverage::{Coverage, coverage};
pub use error::{VectorError, VectorErrorKind};
pub use parse::parse;
pub use replay::{Half, Mismatch, Replay, Scan, run};
pub use vector::{Expectation, Setting, Step, Vector};

use alloc::vec::Vec;
use twinrung_catalog::Opcode;

/// The vector that shows the normal operation of an instruction; `None` where no vector is marked so.
///
/// # Errors
///
/// As [`for_instruction`].
pub fn normal_operation(opcode: Opcode) -> Result<Option<Vector>, VectorError> {
    Ok(for_instruction(opcode)?.into_iter().find(|vector| !vector.normal.is_empty()))
}

/// The vectors of an instruction, in the order of its file.
///
/// # Errors
///
/// [`VectorErrorKind::NoVectors`] for an instruction that is not a safety application instruction; else the first line
/// of the file that cannot be read.
pub fn for_instruction(opcode: Opcode) -> Result<Vec<Vector>, VectorError> {
    match text::of(opcode) {
        Some(text) => parse(opcode, text),
        None => Err(VectorError { opcode, line: 0, kind: VectorErrorKind::NoVectors }),
    }
}
