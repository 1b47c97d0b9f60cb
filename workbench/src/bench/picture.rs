//! A report as a picture on a terminal.

use std::fmt::Write as _;

use super::units::{count, time};
use super::{Bucket, Quantiles, Report};

/// Lines of the histogram.
const LINES: usize = 16;
/// Columns beside a bar.
const BESIDE: usize = 44;
/// Widest name of a routine, and widest text of a rung.
const NAME: usize = 36;
/// Most routines that are listed; JSON and the page have all of them.
const ROUTINES: usize = 20;

/// Draws a report in so many columns.
pub fn picture(report: &Report, columns: usize) -> String {
    let mut out = String::new();
    let _ = writeln!(
        out,
        "{}, safety application {}: {} rungs, {} scans on both channels, compared after each\n",
        report.project,
        report.signature,
        count(report.rungs),
        count(report.scans)
    );
    histogram(&mut out, report, columns);
    parts(&mut out, report);
    if let Some(on_threads) = report.on_threads() {
        let _ = writeln!(out, "{on_threads}\n");
    }
    instructions(&mut out, report, columns);
    if let Some(longest) = report.longest_path() {
        let _ = writeln!(out, "{longest}");
    }
    if let Some(inputs) = &report.inputs {
        let _ = writeln!(
            out,
            "Inputs at random: {} of {} BOOL inputs were off and on, {} numbers moved.",
            count(inputs.both_truths),
            count(inputs.bools),
            count(inputs.numbers)
        );
    }
    let _ = writeln!(
        out,
        "The clock was read 6 times in each scan, {} each; nothing is subtracted for it.",
        time(report.clock_ns)
    );
    if let Some(hash) = &report.hash {
        let _ = writeln!(out, "State after the last scan: {hash}");
    }
    if let Some(stopped) = &report.stopped {
        let _ = writeln!(out, "\nEnded early in {stopped}.");
    }
    let _ = writeln!(out, "\n{}", report.verdict());
    out
}

/// Neighbouring buckets joined until there are few enough; the last, which holds what took longer, stays alone.
fn joined(buckets: &[Bucket], most: usize) -> Vec<Bucket> {
    let Some((last, rest)) = buckets.split_last() else { return Vec::new() };
    let each = rest.len().div_ceil(most.saturating_sub(1).max(1)).max(1);
    let join = |group: &[Bucket]| {
        let (first, last) = (group.first()?, group.last()?);
        Some(Bucket { from_ns: first.from_ns, to_ns: last.to_ns, scans: group.iter().map(|bucket| bucket.scans).sum() })
    };
    rest.chunks(each).filter_map(join).chain([*last]).collect()
}

fn histogram(out: &mut String, report: &Report, columns: usize) {
    let lines = joined(&report.histogram, LINES);
    let greatest = lines.iter().map(|line| line.scans).max().unwrap_or(0).max(1);
    let width = columns.saturating_sub(BESIDE).max(10);
    let marks = report.scan_ns.marks();
    for (index, line) in lines.iter().enumerate() {
        let is_last = index + 1 == lines.len();
        let here: Vec<&str> = marks
            .iter()
            .filter(|(_, ns)| (line.from_ns..line.to_ns).contains(ns) || (is_last && *ns >= line.to_ns))
            .map(|(name, _)| *name)
            .collect();
        let _ = writeln!(
            out,
            "{:>8} {} {:>9}  {}",
            time(line.from_ns),
            bar(line.scans, greatest, width),
            count(line.scans),
            here.join(" ")
        );
    }
    out.push('\n');
}

/// A bar in eighths of a column; what is not nothing is seen.
fn bar(value: u64, greatest: u64, width: usize) -> String {
    const EIGHTHS: [char; 8] = [' ', '▏', '▎', '▍', '▌', '▋', '▊', '▉'];
    let eighths = (value as u128 * width as u128 * 8 / u128::from(greatest)) as usize;
    let eighths = if value > 0 { eighths.max(1) } else { 0 };
    let mut bar: String = std::iter::repeat_n('█', eighths / 8).collect();
    if !eighths.is_multiple_of(8) {
        bar.push(EIGHTHS[eighths % 8]);
    }
    let shown = bar.chars().count();
    bar.extend(std::iter::repeat_n(' ', width.saturating_sub(shown)));
    bar
}

fn parts(out: &mut String, report: &Report) {
    let mut row = |name: &str, cells: [String; 4]| {
        let cells = cells.map(|cell| format!(" {cell:>9}")).concat();
        let _ = writeln!(out, "{name:<13}{cells}");
    };
    let times = |quantiles: Quantiles| quantiles.marks().map(|(_, ns)| time(ns));
    row("", report.scan_ns.marks().map(|(name, _)| name.to_owned()));
    row("scan", times(report.scan_ns));
    for (name, quantiles) in report.parts() {
        row(&format!("  {name}"), times(quantiles));
    }
    if let Some(jitter) = report.jitter_ns {
        row("began late by", times(jitter));
    }
    out.push('\n');
}

fn instructions(out: &mut String, report: &Report, columns: usize) {
    let mut row = |name: &str, rungs: &str, seen: &str, bound: &str, estimate: &str| {
        let _ = writeln!(out, "{:<NAME$} {rungs:>7} {seen:>14} {bound:>14} {estimate:>10}", cut(name, NAME));
    };
    let estimated = |ns: Option<u64>| ns.map(|ns| format!("~{}", time(ns))).unwrap_or_default();
    row("instructions in a scan", "rungs", "at most seen", "bound", "bound");
    row(
        "all",
        &count(report.rungs),
        &count(report.max_instructions),
        &count(report.bound_instructions),
        &estimated(report.estimate.as_ref().map(|estimate| estimate.bound_ns)),
    );
    row(
        "prescan",
        "",
        &report.prescan_instructions.map(count).unwrap_or_default(),
        &count(report.bound_prescan_instructions),
        "",
    );
    for program in &report.programs {
        row(
            &program.program,
            "",
            &count(program.max_instructions),
            &count(program.bound_instructions),
            &estimated(program.estimated_ns),
        );
    }
    for routine in report.routines.iter().take(ROUTINES) {
        // A routine of an Add-On Instruction counts with those that call it.
        let own = (routine.bound_instructions > 0).then_some(routine.bound_instructions);
        row(
            &format!("  {}", routine.routine),
            &count(routine.rungs),
            &count(routine.max_instructions),
            &own.map_or_else(|| "-".to_owned(), count),
            &estimated(routine.estimated_ns.filter(|_| own.is_some())),
        );
    }
    if let Some(more) = report.routines.len().checked_sub(ROUTINES).filter(|more| *more > 0) {
        row(&format!("  and {} more", count(more as u64)), "", "", "", "");
    }
    let _ = writeln!(out, "\nmost expensive rungs");
    for rung in &report.most_expensive_rungs {
        let place = format!("{} rung {}", rung.routine, rung.rung);
        let _ = writeln!(
            out,
            "{:>6} {:>9}  {:<28} {}",
            count(rung.max_instructions),
            estimated(rung.estimated_ns),
            cut(&place, 28),
            cut(&rung.text, columns.saturating_sub(NAME + 11).max(20))
        );
    }
    out.push('\n');
}

fn cut(text: &str, width: usize) -> String {
    if text.chars().count() <= width {
        return text.to_owned();
    }
    text.chars().take(width.saturating_sub(3)).chain("...".chars()).collect()
}
