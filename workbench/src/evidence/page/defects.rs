//! Seeded defects.

use crate::bench::count;
use crate::html::{self, Cell};

use super::super::{DefectEvidence, Measured, Method, SeededDefect};

pub(super) fn write(out: &mut String, evidence: &DefectEvidence) {
    html::heading(out, 2, "Seeded defects");
    html::paragraph(
        out,
        "Mistakes that a programmer could have made, put into one channel, one at a time, and how long the fuzzer takes from its start to the first difference. Guided is the fuzzer as it is, plain is random generation alone. Made again by:",
    );
    html::commands(
        out,
        ["cargo run --release -p twinrung-defects", "cargo run --release -p twinrung-defects -- --plain"],
    );
    let methods = [("guided", &evidence.guided), ("plain", &evidence.plain)];
    for (name, method) in methods {
        let listed = evidence.defects.len();
        match method.measured {
            0 => html::warning(out, &format!("{name}: not measured.")),
            measured if measured < listed => {
                html::warning(out, &format!("{name}: {} of {listed} not measured.", listed - measured))
            }
            _ => {}
        }
    }
    let heads = ["", "listed", "measured", "found", "within 20 s", "median", "longest", "median of programs"];
    let row = |(name, method): (&str, &Method)| {
        let seconds = |seconds: Option<f64>| {
            Cell::Number(seconds.map_or_else(|| "none".to_owned(), |seconds| format!("{seconds:.1} s")))
        };
        vec![
            Cell::text(name),
            Cell::count(evidence.defects.len() as u64),
            Cell::count(method.measured as u64),
            Cell::count(method.found as u64),
            Cell::count(method.quick as u64),
            seconds(method.median),
            seconds(method.longest),
            Cell::Number(method.median_programs.map_or_else(|| "none".to_owned(), count)),
        ]
    };
    html::table(out, &heads, methods.into_iter().filter(|(_, method)| method.measured > 0).map(row));
    for (name, _) in methods {
        let text = match evidence.conditions.get(name) {
            None => format!("{name}: threads, seed and machine were not recorded."),
            Some(of) => format!(
                "{name}: {} threads, seed {}, given up after {} s; version {}, {}; {}, {} processors.",
                of.jobs, of.seed, of.limit_s, of.version, of.rustc, of.processor, of.cores
            ),
        };
        html::paragraph(out, &text);
    }
    let heads = ["channel", "defect", "the mistake", "guided", "programs", "plain", "programs"];
    html::table(out, &heads, evidence.defects.iter().map(defect));
}

fn defect(defect: &SeededDefect) -> Vec<Cell> {
    let [guided, guided_programs] = cells(defect.guided);
    let [plain, plain_programs] = cells(defect.plain);
    vec![
        Cell::text(&defect.channel),
        Cell::text(&defect.name),
        Cell::text(&defect.why),
        guided,
        guided_programs,
        plain,
        plain_programs,
    ]
}

fn cells(measured: Option<Measured>) -> [Cell; 2] {
    match measured {
        None => [Cell::Not("not measured".to_owned()), Cell::Number(String::new())],
        Some(one) if one.found => [Cell::Number(format!("{:.1} s", one.seconds)), Cell::count(one.cases)],
        Some(one) => [Cell::Not(format!("not found in {:.0} s", one.seconds)), Cell::count(one.cases)],
    }
}
