//! The evaluators against the tables of each base instruction, and against each other over random programs.

mod random_programs;
mod tables;
