//! Doing something, and again whenever a file changes.

use std::convert::Infallible;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::mpsc;
use std::time::Duration;

use notify::{Event, EventKind, RecursiveMode, Watcher};

use crate::failed;
use crate::terminal::tell;

/// An editor writes a file in several steps; what follows within this time belongs to the same change.
const SETTLES_WITHIN: Duration = Duration::from_millis(200);
/// Endings of the files that matter: what is written beside them (reports, recordings) does not begin another run.
const ENDINGS: [&str; 5] = ["scenario", "rll", "l5x", "l5k", "image"];

/// Does `work`, and again after each change in the folders that `places` names; ends with the process. The folders are watched
/// before the work begins, so that a change made meanwhile begins it once more.
pub fn watched(
    mut places: impl FnMut() -> io::Result<Vec<PathBuf>>,
    mut work: impl FnMut() -> io::Result<()>,
) -> io::Result<Infallible> {
    let (sender, receiver) = mpsc::channel();
    let mut watcher = notify::recommended_watcher(sender).map_err(failed)?;
    let mut watched: Vec<PathBuf> = Vec::new();
    loop {
        for place in places()? {
            if !watched.contains(&place) {
                watcher.watch(&place, RecursiveMode::NonRecursive).map_err(failed)?;
                watched.push(place);
            }
        }
        if let Err(error) = work() {
            tell(format_args!("twinrung: {error}"));
        }
        tell(format_args!("waiting for a change"));
        loop {
            let event = receiver.recv().map_err(failed)?.map_err(failed)?;
            if matters(&event) {
                break;
            }
        }
        while receiver.recv_timeout(SETTLES_WITHIN).is_ok() {}
    }
}

fn matters(event: &Event) -> bool {
    let changes = matches!(event.kind, EventKind::Create(_) | EventKind::Modify(_) | EventKind::Remove(_));
    let of_interest = |path: &PathBuf| {
        let ending = Path::new(path).extension().and_then(|ending| ending.to_str()).map(str::to_ascii_lowercase);
        ending.is_some_and(|ending| ENDINGS.contains(&ending.as_str()))
    };
    changes && event.paths.iter().any(of_interest)
}
