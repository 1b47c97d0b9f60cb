//! From text to loaded channels, step by step.

use criterion::{BenchmarkId, Criterion, Throughput};
use twinrung_benches::{checked, controller, image};
use twinrung_bytecode::{admit, bound};
use twinrung_compiler::{Completion, check, compile};
use twinrung_grammar::read;
use twinrung_grammar::tree::Sources;
use twinrung_workbench::mix::{Mix, Program};

const RUNGS: usize = 1000;

pub fn benches(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("build");
    group.throughput(Throughput::Elements(RUNGS as u64));
    for mix in [Mix::Simple, Mix::Plant] {
        let program = Program::new(mix, RUNGS, 1);
        for (form, name, text) in [("rll", "mix.rll", program.rll()), ("L5X", "mix.L5X", program.l5x())] {
            group.bench_function(BenchmarkId::new(format!("parse {form}"), mix), |bencher| {
                bencher.iter(|| read(&mut Sources::new(), name, text.clone().into_bytes()));
            });
        }
        let mut sources = Sources::new();
        let reading = read(&mut sources, "mix.rll", program.rll().into_bytes());
        group.bench_function(BenchmarkId::new("check", mix), |bencher| {
            bencher.iter(|| check(&reading, &Completion::default()));
        });
        let project = checked("mix.rll", &program.rll()).expect("a generated program is admitted");
        group.bench_function(BenchmarkId::new("compile", mix), |bencher| bencher.iter(|| compile(&project)));
        let (admitted, bytes) = image(&project).expect("a checked project compiles");
        group.bench_function(BenchmarkId::new("verify", mix), |bencher| bencher.iter(|| admit(&bytes)));
        group.bench_function(BenchmarkId::new("load", mix), |bencher| {
            bencher.iter(|| controller(&admitted, &bytes).expect("both channels load it"));
        });
        group.bench_function(BenchmarkId::new("bound", mix), |bencher| bencher.iter(|| bound::instructions(&admitted)));
    }
    group.finish();
}
