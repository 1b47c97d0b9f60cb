//! Every instruction that can stand alone on a rung: a scan of 100 rungs that hold it, true and false in turn.

use criterion::{Criterion, Throughput};
use twinrung_benches::{checked, controller, image};
use twinrung_bytecode::observer::Silent;
use twinrung_catalog::Opcode;
use twinrung_workbench::bench::Stopwatch;
use twinrung_workbench::instruction_rungs::{Literals, PERIOD_MS, Subject, project};
use twinrung_workbench::{Signal, drive, names};

const RUNGS: usize = 100;
const ELEMENTS: u32 = 16;

pub fn benches(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("instruction");
    group.throughput(Throughput::Elements(RUNGS as u64)).sample_size(20);
    for opcode in Opcode::ALL.iter().copied() {
        let texts = [Literals::Least, Literals::Greatest]
            .into_iter()
            .filter_map(|literals| project(Subject::One(opcode, ELEMENTS), RUNGS, literals));
        let Some(checked) = texts.filter_map(|text| checked("instruction.rll", &text).ok()).next() else { continue };
        let (admitted, bytes) = image(&checked).expect("a checked project compiles");
        let cells: Vec<_> = (0..RUNGS)
            .filter_map(|rung| match names::signal(&admitted, &format!("C{rung}")) {
                Ok(Signal::Bit(cell)) => Some(cell),
                _ => None,
            })
            .collect();
        group.bench_function(opcode.instruction().mnemonic, |bencher| {
            let mut controller = controller(&admitted, &bytes).expect("both channels load it");
            for range in cells.iter().filter_map(|cell| drive::cells(Signal::Bit(*cell))) {
                controller.freeze_also(range);
            }
            let mut scan = 0;
            bencher.iter_custom(|scans| {
                let mut clock = Stopwatch::new(None);
                let mut sum = std::time::Duration::ZERO;
                for _ in 0..scans {
                    cells.iter().for_each(|cell| controller.drive_bit(*cell, scan % 2 == 0));
                    let now_ms = (scan * PERIOD_MS) as i64;
                    controller.scan_observed(now_ms, &mut clock, &mut Silent, &mut Silent);
                    scan += 1;
                    sum += clock.parts().iter().sum::<std::time::Duration>();
                }
                sum
            });
        });
    }
    group.finish();
}
