//! Text to tree and back: Rockwell neutral text, `.rll`, L5K and L5X; and scenario files.
//!
//! It may depend on lexer, parser and XML libraries only. It must never know an instruction, a type
//! or a rule: a rung is mnemonics with operands, and an operand is a run of atoms until the compiler
//! asks for a reading of it. It must never panic, recurse without a limit, or take more than
//! linear time on any input.

mod budget;
mod components;
mod errors;
mod excerpt;
mod fields;
pub mod limits;
mod print;
mod read;
mod reading;
mod scenario;
mod text;
pub mod tree;
mod xml;

pub use print::{
    Unprintable, print_element, print_expression, print_file, print_file_checked, print_operand, print_rung, print_tag,
};
pub use read::{Reading, read, read_path};
pub use reading::{read_expression, read_immediate, read_number, read_tag, read_words, unescape};
pub use scenario::{ScenarioReading, laid_out, read_scenarios};
