//! A report as one HTML page that needs nothing else.

use crate::bench::count;
use crate::html::{self, Cell, duration};

use super::interval::Coverage;
use super::recorded::Recorded;
use super::report::{ClassReport, MechanismReport, Summary, mechanisms};
use super::{Group, Mechanism};

/// Writes the page.
pub fn page(recorded: &Recorded) -> String {
    let Recorded { report, provenance, .. } = recorded;
    let mut out = html::begin(&format!("Faults injected into {}", recorded.project));
    html::paragraph(
        &mut out,
        &format!(
            "Safety application {}; {} scans driven by {}; each fault followed for {} scans; seed {}; {} faults in {} on {} threads.",
            recorded.signature,
            count(u64::from(report.scans)),
            recorded.stimulus,
            report.follow,
            report.seed,
            count(report.injected()),
            duration(provenance.seconds),
            provenance.jobs
        ),
    );
    let must_be_found = report.groups.iter().filter(|one| one.group != Group::Residual && one.injected > 0);
    match must_be_found.map(|one| one.let_out).reduce(|sum, one| sum + one) {
        None => html::warning(&mut out, "Nothing was injected that the controller has to find."),
        Some(0) => html::paragraph(&mut out, "No fault that the controller has to find let a wrong output out."),
        Some(wrong) => html::warning(
            &mut out,
            &format!("{} faults that the controller has to find let a wrong output out.", count(wrong)),
        ),
    }
    groups_table(&mut out, &report.groups);
    html::heading(&mut out, 2, "By mechanism");
    mechanisms_table(&mut out, mechanisms(&report.classes));
    html::heading(&mut out, 2, "By class");
    classes_table(&mut out, &report.classes);
    let mut missed = report.classes.iter().filter(|class| class.let_out > 0).peekable();
    if missed.peek().is_some() {
        html::heading(&mut out, 2, "Wrong outputs let out");
    }
    for class in missed {
        html::heading(&mut out, 3, &format!("{}: {}", class.name, count(class.let_out)));
        let lines: Vec<String> = class.misses.iter().map(|miss| format!("{} {miss}", recorded.replay)).collect();
        html::commands(&mut out, lines.iter().map(String::as_str));
    }
    out.push_str(html::END);
    out
}

/// Groups, with their diagnostic coverage.
pub fn groups_table(out: &mut String, groups: &[Summary]) {
    let heads = [
        "faults",
        "injected",
        "shown by a run",
        "wrong output let out",
        "diagnostic coverage",
        "95 % (Clopper-Pearson)",
    ];
    let rows = groups.iter().map(|group| {
        let [share, interval] = coverage_cells(Some(group.coverage).filter(|_| group.effective > 0));
        vec![
            Cell::text(group_words(group.group)),
            Cell::count(group.injected),
            Cell::count(group.effective),
            Cell::count(group.let_out),
            share,
            interval,
        ]
    });
    html::table(out, &heads, rows);
}

/// Which faults a group is.
pub const fn group_words(group: Group) -> &'static str {
    match group {
        Group::Channel => "in one channel",
        Group::Shared => "in what both channels share",
        Group::Residual => "residual: a controller alone cannot see them",
    }
}

/// Mechanisms, with the scans until they found something.
pub fn mechanisms_table(out: &mut String, found: impl IntoIterator<Item = (Mechanism, MechanismReport)>) {
    let heads =
        ["found by", "faults", "in the fault's own scan", "half within scans", "99 % within scans", "all within scans"];
    let rows = found.into_iter().map(|(mechanism, found)| {
        let at_once = found.by_scan.first().copied().unwrap_or_default();
        let within = |percent| Cell::count(found.within(percent) as u64);
        vec![
            Cell::text(mechanism.words()),
            Cell::count(found.faults),
            Cell::Number(format!("{:.1} %", 100.0 * at_once as f64 / found.faults.max(1) as f64)),
            within(50),
            within(99),
            Cell::count(u64::from(found.scans_max)),
        ]
    });
    html::table(out, &heads, rows);
}

/// Classes: what became of each fault, and the coverage of those that a run showed.
pub fn classes_table(out: &mut String, classes: &[ClassReport]) {
    let heads = [
        "class",
        "group",
        "places",
        "injected",
        "masked",
        "latent",
        "detected",
        "off",
        "let out",
        "coverage",
        "95 %",
        "found by (scans at most)",
    ];
    let rows = classes.iter().map(|class| {
        let [share, interval] = coverage_cells(class.coverage);
        let found: Vec<String> = class
            .mechanisms
            .iter()
            .map(|(mechanism, found)| format!("{}: {} ({})", mechanism.words(), count(found.faults), found.scans_max))
            .collect();
        vec![
            Cell::Code(class.name.clone()),
            Cell::text(class.group.name()),
            Cell::count(class.population),
            Cell::count(class.injected),
            Cell::count(class.masked + class.impossible),
            Cell::count(class.latent),
            Cell::count(class.detected),
            Cell::count(class.off),
            Cell::count(class.let_out),
            share,
            interval,
            Cell::text(found.join("; ")),
        ]
    });
    html::table(out, &heads, rows);
}

/// A share and its interval; where nothing was shown, nothing is known.
fn coverage_cells(coverage: Option<Coverage>) -> [Cell; 2] {
    let percent = |share: f64| format!("{:.4}", share * 100.0);
    match coverage {
        None => [Cell::Number("none shown".to_owned()), Cell::Number(String::new())],
        Some(coverage) => [
            Cell::Number(format!("{} %", percent(coverage.share))),
            Cell::Number(format!("{} to {} %", percent(coverage.lower), percent(coverage.upper))),
        ],
    }
}
