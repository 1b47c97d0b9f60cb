//! A report as one HTML page that needs nothing else.

use std::fmt::Write as _;

use crate::html::{self, escaped};

use super::Report;
use super::units::{count, time};

/// Drawing size in user units.
const WIDTH: f64 = 900.0;
const HEIGHT: f64 = 260.0;
/// Room for the marks above the bars, and for the times below them.
const ABOVE: f64 = 40.0;
const BELOW: f64 = 30.0;

/// Writes the page.
pub fn page(report: &Report) -> String {
    let mut out = html::begin(&format!("Scan time of {}", report.project));
    let _ = writeln!(
        out,
        "<p>Safety application {}; {} rungs; {} scans on both channels, compared after each; \
         period {}, watchdog {}.</p>\n<p class=\"verdict\">{}</p>",
        escaped(&report.signature),
        count(report.rungs),
        count(report.scans),
        time(report.period_ns),
        time(report.watchdog_ns),
        escaped(&report.verdict()),
    );
    if let Some(stopped) = &report.stopped {
        let _ = writeln!(out, "<p>Ended early in {}.</p>", escaped(stopped));
    }
    if let Some(longest) = report.longest_path() {
        let _ = writeln!(out, "<p>{}</p>", escaped(&longest));
    }
    histogram(&mut out, report);
    parts(&mut out, report);
    if let Some(on_threads) = report.on_threads() {
        let _ = writeln!(out, "<p>{on_threads}</p>");
    }
    instructions(&mut out, report);
    out.push_str(html::END);
    out
}

fn histogram(out: &mut String, report: &Report) {
    let (Some(first), Some(last)) = (report.histogram.first(), report.histogram.last()) else { return };
    // The last bucket, which holds what took longer, is drawn as wide as the others: its own width would hide them.
    let step = first.to_ns.saturating_sub(first.from_ns).max(1) as f64;
    let each = WIDTH / report.histogram.len() as f64;
    let beyond = last.to_ns.saturating_sub(last.from_ns).max(1) as f64;
    let x = |ns: u64| {
        let inside = ns.min(last.from_ns).saturating_sub(first.from_ns) as f64 / step;
        (inside + ns.saturating_sub(last.from_ns) as f64 / beyond) * each
    };
    let most = report.histogram.iter().map(|bucket| bucket.scans).max().unwrap_or(0).max(1) as f64;
    let total = HEIGHT + ABOVE + BELOW;
    let _ = writeln!(
        out,
        "<h2>Distribution</h2>\n<svg viewBox=\"-10 0 {} {total}\" role=\"img\" aria-label=\"Histogram of the scan time\">",
        WIDTH + 70.0
    );
    for bucket in report.histogram.iter().filter(|bucket| bucket.scans > 0) {
        let (from, to) = (x(bucket.from_ns), x(bucket.to_ns));
        // At least one unit high: what happened once is seen.
        let height = (bucket.scans as f64 / most * HEIGHT).max(1.0);
        let _ = writeln!(
            out,
            "<rect class=\"bar\" x=\"{from:.1}\" y=\"{:.1}\" width=\"{:.1}\" height=\"{height:.1}\"><title>{} to {}: {} scans</title></rect>",
            ABOVE + HEIGHT - height,
            (to - from - 0.5).max(0.5),
            time(bucket.from_ns),
            time(bucket.to_ns),
            count(bucket.scans)
        );
    }
    let base = ABOVE + HEIGHT;
    let _ = writeln!(out, "<line class=\"axis\" x1=\"0\" y1=\"{base}\" x2=\"{WIDTH}\" y2=\"{base}\"/>");
    for (index, (name, ns)) in report.scan_ns.marks().into_iter().enumerate() {
        let (at, top) = (x(ns), 12.0 + 8.0 * index as f64);
        let _ = writeln!(
            out,
            "<line class=\"mark\" x1=\"{at:.1}\" y1=\"{top}\" x2=\"{at:.1}\" y2=\"{base}\"/><text x=\"{:.1}\" y=\"{:.1}\">{name} {}</text>",
            at + 3.0,
            top + 4.0,
            time(ns)
        );
    }
    for step in 0..=4_u64 {
        let ns = first.from_ns + (last.from_ns - first.from_ns) / 4 * step;
        let anchor = if step == 0 { "start" } else { "middle" };
        let _ = writeln!(
            out,
            "<text x=\"{:.1}\" y=\"{:.1}\" text-anchor=\"{anchor}\">{}</text>",
            x(ns),
            base + 18.0,
            time(ns)
        );
    }
    out.push_str("</svg>\n");
}

fn parts(out: &mut String, report: &Report) {
    let heads = report.scan_ns.marks().map(|(name, _)| format!("<th>{name}</th>")).concat();
    let _ = writeln!(out, "<h2>Parts of a scan</h2>\n<table class=\"numbers\"><tr><th></th>{heads}</tr>");
    let late = report.jitter_ns.map(|jitter| ("began late by", jitter));
    for (name, quantiles) in std::iter::once(("scan", report.scan_ns)).chain(report.parts()).chain(late) {
        let cells = quantiles.marks().map(|(_, ns)| format!("<td>{}</td>", time(ns))).concat();
        let _ = writeln!(out, "<tr><td>{name}</td>{cells}</tr>");
    }
    out.push_str("</table>\n");
}

fn instructions(out: &mut String, report: &Report) {
    out.push_str(
        "<h2>Instructions in a scan</h2>\n<table class=\"numbers\"><tr><th></th><th>rungs</th><th>at most seen</th><th>bound</th>\
         <th>bound, estimated time</th></tr>\n",
    );
    let estimated = |ns: Option<u64>| ns.map(time).unwrap_or_default();
    let mut row = |name: &str, rungs: Option<u64>, seen: u64, bound: u64, ns: Option<u64>| {
        let _ = writeln!(
            out,
            "<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>",
            escaped(name),
            rungs.map(count).unwrap_or_default(),
            count(seen),
            if bound == 0 { String::new() } else { count(bound) },
            estimated(ns.filter(|_| bound > 0))
        );
    };
    let whole = report.estimate.as_ref().map(|estimate| estimate.bound_ns);
    row("all", Some(report.rungs), report.max_instructions, report.bound_instructions, whole);
    let prescanned = report.prescan_instructions.unwrap_or_default();
    row("prescan", None, prescanned, report.bound_prescan_instructions, None);
    for program in &report.programs {
        row(&program.program, None, program.max_instructions, program.bound_instructions, program.estimated_ns);
    }
    for routine in &report.routines {
        let (seen, bound) = (routine.max_instructions, routine.bound_instructions);
        row(&routine.routine, Some(routine.rungs), seen, bound, routine.estimated_ns);
    }
    out.push_str(
        "</table>\n<h2>Most expensive rungs</h2>\n<table class=\"numbers\"><tr><th>rung</th><th>instructions</th><th>bound</th>\
         <th>estimated time</th><th>text</th></tr>\n",
    );
    for rung in &report.most_expensive_rungs {
        let _ = writeln!(
            out,
            "<tr><td>{} {}</td><td>{}</td><td>{}</td><td>{}</td><td style=\"text-align:left\"><code>{}</code></td></tr>",
            escaped(&rung.routine),
            rung.rung,
            count(rung.max_instructions),
            count(rung.bound_instructions),
            estimated(rung.estimated_ns),
            escaped(&rung.text)
        );
    }
    out.push_str("</table>\n");
}
