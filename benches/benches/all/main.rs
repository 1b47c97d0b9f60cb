//! All criterion benches. `cargo bench -p twinrung-benches --bench all -- [FILTER]`; docs/performance.md says how to compare
//! with a baseline.

mod instruction;
mod reading;
mod scan;

use criterion::Criterion;

fn main() {
    let mut criterion = Criterion::default().configure_from_args();
    reading::benches(&mut criterion);
    scan::benches(&mut criterion);
    instruction::benches(&mut criterion);
    criterion.final_summary();
}
