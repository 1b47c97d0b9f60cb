//! Scenarios and coverage: `docs/spec/test.md`.

mod command;
mod coverage;
mod mutants;
mod page;
mod samples;
mod support;
mod terminals;
mod time;
mod verdict;
