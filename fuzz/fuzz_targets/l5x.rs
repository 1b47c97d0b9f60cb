//! Fuzzes the reading of L5X exports. See `fuzz/README.md`.

#![no_main]

use libfuzzer_sys::fuzz_target;
use twinrung_hostile::Target;

fuzz_target!(|bytes: &[u8]| Target::L5x.run(bytes));
