//! Some thousands of mutants, the same in every run: no panic, and memory within the bound. The fuzzers under `fuzz/` go
//! on where this ends. `TWINRUNG_MUTANTS=100000` makes more.

use peak_alloc::PeakAlloc;
use twinrung_hostile::{Mutator, Target, seeds};

#[global_allocator]
static ALLOCATED: PeakAlloc = PeakAlloc;

/// Mutants of each target.
const MUTANTS: usize = 1_500;
/// Bytes that a mutant of at most 1 MiB may make the tool hold, beyond what was held before.
const BYTES_MAX: usize = 256 << 20;

fn mutants() -> usize {
    std::env::var("TWINRUNG_MUTANTS").ok().and_then(|text| text.parse().ok()).unwrap_or(MUTANTS)
}

/// REQ-CHECK-008. One test, so that nothing else allocates meanwhile.
#[test]
fn targets_when_mutants_of_the_samples_are_thrown_at_them_then_none_panics_or_takes_too_much_memory() {
    for target in Target::ALL {
        let seeds = seeds(target).unwrap();
        assert!(!seeds.is_empty());
        let mut mutator = Mutator::new(0x7477_696e);
        for number in 0..mutants() {
            let (name, seed) = &seeds[number % seeds.len()];
            let other = &seeds[(number * 7 + 3) % seeds.len()].1;
            let mutant = mutator.mutant(seed, other);
            let before = ALLOCATED.current_usage();
            ALLOCATED.reset_peak_usage();
            target.run(&mutant);
            let taken = ALLOCATED.peak_usage().saturating_sub(before);
            assert!(taken <= BYTES_MAX, "{} mutant {number} of {name} takes {taken} bytes", target.name());
        }
    }
}
