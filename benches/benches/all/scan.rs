//! Scans of generated programs and of the samples; the comparison alone.

use std::path::Path;
use std::time::Duration;

use criterion::{BenchmarkId, Criterion, Throughput};
use twinrung_benches::{checked, checked_path, controller, image};
use twinrung_bytecode::AdmittedImage;
use twinrung_bytecode::observer::Silent;
use twinrung_controller::{DualController, Part};
use twinrung_workbench::bench::Inputs;
use twinrung_workbench::bench::Stopwatch;
use twinrung_workbench::mix::{Mix, PERIOD_MS, Program, Toggles};

pub fn benches(criterion: &mut Criterion) {
    for mix in [Mix::Simple, Mix::Plant] {
        for rungs in [1000, 10_000, 100_000] {
            let project =
                checked("mix.rll", &Program::new(mix, rungs, 1).rll()).expect("a generated program is admitted");
            let (admitted, bytes) = image(&project).expect("a checked project compiles");
            let mut group = criterion.benchmark_group("scan");
            group.throughput(Throughput::Elements(rungs as u64)).sample_size(if rungs > 10_000 { 20 } else { 100 });
            group.bench_function(BenchmarkId::new(mix.to_string(), rungs), |bencher| {
                let mut driven = Driven::mix(&admitted, &bytes);
                bencher.iter_custom(|scans| driven.time(scans, |parts| parts.iter().sum()));
            });
            group.finish();
            let mut group = criterion.benchmark_group("comparison");
            group.throughput(Throughput::Elements(rungs as u64)).sample_size(20);
            group.bench_function(BenchmarkId::new(mix.to_string(), rungs), |bencher| {
                let mut driven = Driven::mix(&admitted, &bytes);
                bencher.iter_custom(|scans| driven.time(scans, |parts| parts[Part::Compare as usize]));
            });
            group.finish();
        }
    }
    samples(criterion);
}

fn samples(criterion: &mut Criterion) {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../samples");
    let mut entries: Vec<_> =
        folder.read_dir().expect("the samples are there").filter_map(|entry| Some(entry.ok()?.path())).collect();
    entries.sort();
    let mut group = criterion.benchmark_group("sample");
    for path in entries.iter().filter(|path| path.is_dir()) {
        // Folders that hold samples of refused projects have no image.
        let Ok(project) = checked_path(path) else { continue };
        let (admitted, bytes) = image(&project).expect("a checked project compiles");
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        group.bench_function(name, |bencher| {
            let mut driven = Driven::at_random(&admitted, &bytes);
            bencher.iter_custom(|scans| driven.time(scans, |parts| parts.iter().sum()));
        });
    }
    group.finish();
}

enum Source {
    Toggles(Toggles),
    Random(Inputs),
}

/// A controller whose inputs move.
struct Driven {
    controller: DualController,
    source: Source,
    scans: u64,
}

impl Driven {
    fn mix(admitted: &AdmittedImage, bytes: &[u8]) -> Driven {
        let mut controller = controller(admitted, bytes).expect("both channels load it");
        let source = Source::Toggles(Toggles::new(&mut controller, 16).expect("a generated program"));
        Driven { controller, source, scans: 0 }
    }

    fn at_random(admitted: &AdmittedImage, bytes: &[u8]) -> Driven {
        let mut controller = controller(admitted, bytes).expect("both channels load it");
        let source = Source::Random(Inputs::new(&mut controller, 1));
        Driven { controller, source, scans: 0 }
    }

    fn time(&mut self, scans: u64, of: impl Fn(&[Duration; 5]) -> Duration) -> Duration {
        let mut clock = Stopwatch::new(None);
        let mut sum = Duration::ZERO;
        for _ in 0..scans {
            match &mut self.source {
                Source::Toggles(toggles) => toggles.before(&mut self.controller),
                Source::Random(inputs) => inputs.before(&mut self.controller, self.scans),
            }
            let now_ms = (self.scans * PERIOD_MS) as i64;
            self.controller.scan_observed(now_ms, &mut clock, &mut Silent, &mut Silent);
            self.scans += 1;
            sum += of(&clock.parts());
        }
        sum
    }
}
