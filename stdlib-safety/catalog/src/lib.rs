//! The certified set, declared once.
//!
//! Every instruction that safety logic may hold, every predefined type, option word, operand range, fault code and
//! controller stands here as plain data with its source. The compiler's rules, the image verifier, the
//! disassembler, `explain`, the program generator and the tests all read this crate; nothing else repeats it.
//!
//! This crate depends on nothing, allocates nothing, and never computes a result of an instruction.

#![no_std]
#![forbid(unsafe_code)]

pub mod code;
pub mod controller;
pub mod execution;
pub mod failure;
pub mod instruction;
pub mod instructions;
pub mod modules;
pub mod operand;
pub mod points;
pub mod predefined;
pub mod reaction;
pub mod types;

pub use code::{Code, CodeWord};
pub use controller::{Controller, Family};
pub use execution::Execution;
pub use instruction::{Group, Instruction, Opcode, Position, Relation, Requires, STATUS_OPERANDS, SafetyApplication};
pub use operand::{Access, ChoiceList, Operand, OperandKind};
pub use predefined::{Element, Member, MemberRole, PredefinedType, REPORTS};
