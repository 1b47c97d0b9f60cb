//! What the benchmarks share: projects compiled and loaded, scans whose parts are timed.
//!
//! It may depend on everything that a user's command depends on. It never asserts a time: it prints them.

#![forbid(unsafe_code)]

use std::path::Path;
use std::time::Duration;

use twinrung_bytecode::channel::Channel;
use twinrung_bytecode::observer::Silent;
use twinrung_bytecode::{AdmittedImage, admit};
use twinrung_compiler::{CheckedProject, Completion, check, compile};
use twinrung_controller::{Controller, DualController, Primary};
use twinrung_grammar::tree::Sources;
use twinrung_workbench::bench::Stopwatch;
use twinrung_workbench::mix::{PERIOD_MS, Toggles, hash};

/// What goes wrong in a benchmark, in words.
pub type Result<T> = std::result::Result<T, Box<dyn std::error::Error>>;

/// Checks source text.
pub fn checked(name: &str, text: &str) -> Result<CheckedProject> {
    let mut sources = Sources::new();
    let reading = twinrung_grammar::read(&mut sources, name, text.as_bytes().to_vec());
    project(check(&reading, &Completion::default()))
}

/// Checks a file or a folder.
pub fn checked_path(path: &Path) -> Result<CheckedProject> {
    let mut sources = Sources::new();
    project(check(&twinrung_grammar::read_path(&mut sources, path), &Completion::default()))
}

fn project(checked: twinrung_compiler::Checked) -> Result<CheckedProject> {
    let first = checked.findings.into_iter().find(|finding| finding.is_error());
    checked.project.ok_or_else(|| first.map_or_else(|| "refused".to_owned(), |finding| finding.message).into())
}

/// The sealed bytes of a project, and the image that a loader makes of them.
pub fn image(project: &CheckedProject) -> Result<(AdmittedImage, Vec<u8>)> {
    let bytes = compile(project).map_err(|finding| finding.message)?.bytes;
    Ok((admit(&bytes)?, bytes))
}

/// A controller in Run with an image.
pub fn controller(image: &AdmittedImage, bytes: &[u8]) -> Result<DualController> {
    with_partner(image, bytes)
}

fn with_partner<B: Channel>(image: &AdmittedImage, bytes: &[u8]) -> Result<Controller<Primary, B>> {
    let mut controller = Controller::load(image.clone(), bytes).map_err(|error| error.to_string())?;
    controller.power_up_in_run();
    Ok(controller)
}

/// How the inputs of a mix move.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Inputs {
    /// So many toggles before each scan.
    Toggled(usize),
    /// Every input drawn anew before each scan.
    Redrawn,
}

/// Medians of a run in ns, and the state that it ended with.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Timing {
    /// The whole scan: freeze, both channels, comparison, publish.
    pub scan_ns: u64,
    /// Its parts, in the order of [`twinrung_controller::Part::ALL`].
    pub parts_ns: [u64; 5],
    /// The state after the last scan.
    pub hash: u64,
}

/// Runs a generated program with this partner.
pub fn timed<B: Channel>(image: &AdmittedImage, bytes: &[u8], scans: u64, inputs: Inputs) -> Result<Timing> {
    let mut controller = with_partner::<B>(image, bytes)?;
    let each_scan = if let Inputs::Toggled(count) = inputs { count } else { 0 };
    let mut toggles = Toggles::new(&mut controller, each_scan).ok_or("not a generated program")?;
    let mut clock = Stopwatch::new(None);
    let mut times: [Vec<u64>; 6] = Default::default();
    for scan in 0..scans {
        match inputs {
            Inputs::Toggled(_) => toggles.before(&mut controller),
            Inputs::Redrawn => toggles.redraw(&mut controller),
        }
        let now_ms = (scan * PERIOD_MS) as i64;
        let report = controller.scan_observed(now_ms, &mut clock, &mut Silent, &mut Silent);
        if let Some(reason) = report.stopped {
            return Err(format!("stopped in scan {scan}: {reason:?}").into());
        }
        let parts = clock.parts();
        times[5].push(parts.iter().sum::<Duration>().as_nanos() as u64);
        parts.iter().zip(&mut times).for_each(|(part, times)| times.push(part.as_nanos() as u64));
    }
    let [freeze, primary, partner, compare, publish, scan] = times.map(median);
    Ok(Timing { scan_ns: scan, parts_ns: [freeze, primary, partner, compare, publish], hash: hash(&controller) })
}

/// The median of some numbers; the lesser of the middle two is not averaged with the greater.
pub fn median<T: PartialOrd + Copy + Default>(mut values: Vec<T>) -> T {
    values.sort_unstable_by(|a, b| a.partial_cmp(b).unwrap_or(std::cmp::Ordering::Equal));
    values.get(values.len() / 2).copied().unwrap_or_default()
}
