//! The loader: bytes, signatures, text, and every rule of the verifier.

mod admitted;
mod code;
mod container;
mod declaration_text;
mod declarations;
mod hostile;
mod instructions;
mod operands;
mod rules;
mod subroutines;
mod support;
mod tags;
mod text;
