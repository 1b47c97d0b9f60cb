//! A bar for what takes long.

use std::io::{self, IsTerminal};
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

/// What takes shorter than this shows no bar.
const SHOWN_AFTER: Duration = Duration::from_millis(500);
/// Scans between two looks at the clock and two drawings: the bar is to disturb nothing that is measured.
const EVERY: u64 = 256;

/// Does something in so many scans; it says after each how many are done.
pub fn with_progress<T>(scans: u64, run: impl FnOnce(&mut dyn FnMut(u64)) -> T) -> T {
    if !io::stderr().is_terminal() {
        return run(&mut |_| {});
    }
    let bar = ProgressBar::with_draw_target(Some(scans), ProgressDrawTarget::hidden());
    bar.set_style(
        ProgressStyle::with_template("{bar:40} {pos}/{len} scans, {per_sec}, {eta} left")
            .unwrap_or_else(|_| ProgressStyle::default_bar()),
    );
    let begun = Instant::now();
    let mut shown = false;
    let outcome = run(&mut |done| {
        if !done.is_multiple_of(EVERY) {
            return;
        }
        if !shown && begun.elapsed() > SHOWN_AFTER {
            bar.set_draw_target(ProgressDrawTarget::stderr());
            shown = true;
        }
        bar.set_position(done);
    });
    bar.finish_and_clear();
    outcome
}
