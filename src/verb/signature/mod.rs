//! `twinrung signature`: the signatures of safety Add-On Instructions, and their seals.

mod listing;
mod seal;

use std::io;
use std::path::PathBuf;
use std::process::ExitCode;

use clap::{Args, Subcommand};
use jiff::Timestamp;

use crate::format::Format;
use crate::input::Complete;
use crate::terminal;

/// Arguments of `signature`.
#[derive(Debug, Args)]
#[command(
    after_help = "The instruction signature covers the whole definition, comments and descriptions too, and seals it: twinrung check\n\
refuses a sealed instruction that was changed (S0801). The safety instruction signature covers what executes.\n\
\n\
  twinrung signature library.rll generate Monitored_Valve\n  \
twinrung signature library.rll --format json > recorded.json\n  \
twinrung signature project.rll compare recorded.json      after the instruction was imported\n\
\n\
Exit code: 0 done, 1 refused or not the same, 2 could not read or write."
)]
pub struct Signature {
    /// The project: .rll, .L5K, .L5X, or a folder
    file: PathBuf,
    #[command(subcommand)]
    action: Option<Do>,
    /// How to print the listing
    #[arg(long, value_enum, default_value_t = Format::Human)]
    format: Format,
    #[command(flatten)]
    complete: Complete,
}

#[derive(Debug, Subcommand)]
enum Do {
    /// List the signatures of all safety Add-On Instructions; also without an action
    Show,
    /// Generate the instruction signature: it seals the instruction
    Generate {
        /// The Add-On Instruction
        name: String,
        /// The date and time to use, instead of the clock's: 2026-11-22T18:00:00Z
        #[arg(long, value_name = "TIMESTAMP")]
        clock: Option<Timestamp>,
    },
    /// Remove the instruction signature; the history stays
    Remove {
        /// The Add-On Instruction
        name: String,
    },
    /// Add an entry with the instruction signature to the history, which holds at most six
    Entry {
        /// The Add-On Instruction
        name: String,
        /// The name of the user
        #[arg(long)]
        user: String,
        /// What is to be said of it
        #[arg(long)]
        description: String,
    },
    /// Compare with a listing that was recorded with --format json
    Compare {
        /// The listing
        recorded: PathBuf,
    },
}

/// Lists, seals, compares.
pub fn run(arguments: &Signature) -> io::Result<ExitCode> {
    let mut out = terminal::out();
    let (file, complete) = (&arguments.file, &arguments.complete);
    match &arguments.action {
        None | Some(Do::Show) => listing::show(&mut out, file, complete, arguments.format == Format::Json),
        Some(Do::Compare { recorded }) => listing::compare(&mut out, file, complete, recorded),
        Some(Do::Generate { name, clock }) => seal::generate(&mut out, file, complete, name, *clock),
        Some(Do::Remove { name }) => seal::remove(&mut out, file, name),
        Some(Do::Entry { name, user, description }) => seal::entry(&mut out, file, name, user, description),
    }
}
