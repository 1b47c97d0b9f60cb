//! Tests of the whole: from files to recordings, through every crate. One binary, since linking is what takes time.

mod bench;
mod bench_command;
mod bench_mixes;
mod bound;
mod cell;
mod certified_set;
mod channel_bits;
mod checklists;
mod command;
mod controller;
mod corpus;
mod defects;
#[cfg(feature = "injection")]
mod evidence;
mod faults;
mod freestanding;
mod fuzz;
mod fuzz_campaign;
mod hostile;
mod house;
mod idioms;
mod image_bits;
#[cfg(feature = "injection")]
mod inject;
mod line;
mod line_command;
mod mutations;
mod online_edits;
mod options;
mod pages;
mod plant_program;
mod random_instructions;
mod reaction;
mod refused;
mod replacement;
mod samples;
mod scenarios;
mod sealed_data;
mod signature;
mod support;
mod two_threads;
mod vectors;
mod verdict;
mod wrong_instruction;
mod wrong_partner;
