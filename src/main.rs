//! The `twinrung` command.

#![forbid(unsafe_code)]

mod exit;
mod files;
mod findings;
mod format;
mod input;
mod instructions;
mod play;
mod progress;
mod stopwatch;
mod terminal;
mod verb;
mod watch;

use std::io;
use std::process::ExitCode;

use clap::{Parser, Subcommand};

/// Safety ladder logic: verify, compile, sign, and run it on two interpreters that compare every safety tag.
#[derive(Debug, Parser)]
#[command(
    version,
    about,
    after_help = "FILE is a .rll, .L5K or .L5X file, a folder that is one project, or an image.\n\
\n\
First steps:\n  twinrung check  project.L5X                        a verdict in milliseconds\n  \
twinrung run    samples/estop-with-contactors      what happens, scan by scan\n  \
twinrung explain DCS                               what an instruction does, with its fault codes"
)]
struct Command {
    #[command(subcommand)]
    verb: Verb,
}

#[derive(Debug, Subcommand)]
enum Verb {
    /// Verify a project against the safety rules
    Check(verb::check::Check),
    /// Fill in the checklists of the safety reference manual from a project
    Checklist(verb::checklist::Checklist),
    /// Verify, compile and sign; prints the signatures
    Build(verb::build::Build),
    /// Run scans on both interpreters and record what happened
    Run(verb::run::Run),
    /// Test a project with scenarios on both interpreters, and say what they cover
    Test(verb::test::Test),
    /// Commission a controller that is kept in a folder: modes, lock, signature, forces, faults
    Controller(verb::controller::Controller),
    /// Run several controllers together: produced and consumed safety tags, and what becomes of a lost connection
    Line(verb::line::LineOfControllers),
    /// Show, generate, remove and compare the signatures of safety Add-On Instructions
    Signature(verb::signature::Signature),
    /// Measure the scan time against period and watchdog
    Bench(verb::bench::Bench),
    /// Run random programs on both interpreters until they differ
    Fuzz(verb::fuzz::Fuzz),
    /// Add up the reaction time, and the probability of failure, from each safety input to each safety output
    Reaction(verb::reaction::Reaction),
    /// Inject faults into a running project and say what found them
    #[cfg(feature = "injection")]
    Inject(verb::inject::Inject),
    /// Add up what was measured of a release, hold it against its floors, and write the page
    #[cfg(feature = "injection")]
    Evidence(verb::evidence::Evidence),
    /// Show an image: signatures, sections, layout, neutral text
    Show(verb::show::Show),
    /// Say what differs between two projects or images
    Diff(verb::diff::Diff),
    /// Write .rll in its canonical form
    Fmt(verb::fmt::Fmt),
    /// Explain a code or an instruction
    Explain(verb::explain::Explain),
}

fn main() -> ExitCode {
    let outcome = match Command::parse().verb {
        Verb::Check(arguments) => verb::check::run(&arguments),
        Verb::Checklist(arguments) => verb::checklist::run(&arguments),
        Verb::Build(arguments) => verb::build::run(&arguments),
        Verb::Run(arguments) => verb::run::run(&arguments),
        Verb::Test(arguments) => verb::test::run(&arguments),
        Verb::Controller(arguments) => verb::controller::run(&arguments),
        Verb::Line(arguments) => verb::line::run(&arguments),
        Verb::Signature(arguments) => verb::signature::run(&arguments),
        Verb::Bench(arguments) => verb::bench::run(&arguments),
        Verb::Fuzz(arguments) => verb::fuzz::run(&arguments),
        Verb::Reaction(arguments) => verb::reaction::run(&arguments),
        #[cfg(feature = "injection")]
        Verb::Inject(arguments) => verb::inject::run(&arguments),
        #[cfg(feature = "injection")]
        Verb::Evidence(arguments) => verb::evidence::run(&arguments),
        Verb::Show(arguments) => verb::show::run(&arguments),
        Verb::Diff(arguments) => verb::diff::run(&arguments),
        Verb::Fmt(arguments) => verb::fmt::run(&arguments),
        Verb::Explain(arguments) => verb::explain::run(&arguments),
    };
    match outcome {
        Ok(code) => code,
        Err(error) => {
            terminal::tell(format_args!("twinrung: {error}"));
            ExitCode::from(exit::UNREADABLE)
        }
    }
}

/// An error of a verb as the one that `main` prints.
fn failed(error: impl std::error::Error + Send + Sync + 'static) -> io::Error {
    io::Error::other(error.to_string())
}
