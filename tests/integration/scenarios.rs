//! Scenarios and coverage: `docs/spec/test.md`.

mod command;
mod coverage;
mod mutants;
mod page;
mod samples;
mod support;
mod time;
mod verdict;
