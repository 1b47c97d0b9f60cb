//! Tests of the whole: from files to recordings, through every crate. One binary, since linking is what takes time.

mod bench;
mod bench_mixes;
mod bound;
mod corpus;
mod freestanding;
mod house;
mod idioms;
mod image_bits;
mod mutations;
mod plant_program;
mod refused;
mod samples;
mod support;
mod vectors;
mod wrong_instruction;
