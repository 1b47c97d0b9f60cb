//! Fuzzes the reading of images, signed again after mutation. See `fuzz/README.md`.

#![no_main]

use libfuzzer_sys::fuzz_target;
use twinrung_hostile::Target;

fuzz_target!(|bytes: &[u8]| Target::Image.run(bytes));
