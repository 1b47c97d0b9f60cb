//! Fuzzes the reading of scenarios. See `fuzz/README.md`.

#![no_main]

use libfuzzer_sys::fuzz_target;
use twinrung_hostile::Target;

fuzz_target!(|bytes: &[u8]| Target::Scenario.run(bytes));
