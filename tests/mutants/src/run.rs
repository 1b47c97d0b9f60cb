//! Running the tests with one mutant switched on.

use std::io;
use std::process::{Command, Stdio};
use std::thread;
use std::time::{Duration, Instant};

use twinrung_mutants::{SWITCH, Tests};

/// What the tests say of a mutant.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Verdict {
    /// A test failed.
    Caught,
    /// The tests came to no end.
    Timeout,
    /// All tests passed.
    Missed,
}

/// Runs the programs one after the other until one fails.
///
/// # Errors
///
/// When a program cannot be run.
pub fn run(tests: &[Tests], number: usize, limit: Duration) -> io::Result<Verdict> {
    for one in tests {
        let mut child = Command::new(&one.program)
            .current_dir(&one.folder)
            .env(SWITCH, number.to_string())
            .stdin(Stdio::null())
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()?;
        let begun = Instant::now();
        let ended = loop {
            if let Some(status) = child.try_wait()? {
                break Some(status);
            }
            if begun.elapsed() > limit {
                child.kill()?;
                child.wait()?;
                break None;
            }
            thread::sleep(Duration::from_millis(20));
        };
        match ended {
            None => return Ok(Verdict::Timeout),
            Some(status) if !status.success() => return Ok(Verdict::Caught),
            Some(_) => {}
        }
    }
    Ok(Verdict::Missed)
}
