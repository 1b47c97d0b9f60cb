//! `twinrung controller`: a controller that is kept in a folder, to commission a project as Chapter 6 of the manual asks.

mod application;
mod edits;
mod folder;
mod protect;
mod replacement;
mod scans;
mod status;

use std::io::{self, Write};
use std::path::PathBuf;
use std::process::ExitCode;

use clap::{Args, Subcommand, ValueEnum};
use jiff::Timestamp;
use twinrung_commission::LoadMode;

use crate::exit;
use crate::format::Format;
use crate::input::Complete;
use crate::terminal;

use folder::Kept;

/// Arguments of `controller`.
#[derive(Debug, Args)]
#[command(after_help = "From a project to a locked controller, in the order of 1756-RM093 Figure 15:\n  \
twinrung controller cell download project.L5X\n  twinrung controller cell mode run\n  \
twinrung controller cell run --stimulus tests.csv\n  twinrung controller cell mode program\n  \
twinrung controller cell generate\n  twinrung controller cell lock\n  twinrung controller cell status\n\
\n\
Every change is written whole or not at all; what was said to be done survives a loss of power.\n\
Exit code: 0 done, 1 refused, 2 could not read or write, 3 nonrecoverable fault, 4 recoverable fault not handled.")]
pub struct Controller {
    /// The folder that keeps the controller; the first download makes it
    folder: PathBuf,
    #[command(subcommand)]
    action: Do,
}

#[derive(Debug, Subcommand)]
enum Do {
    /// What it is, what it holds, and what is permitted now
    Status {
        /// How to print
        #[arg(long, value_enum, default_value_t = Format::Human)]
        format: Format,
    },
    /// Download a project; the signature stays where the project gives the same one
    Download(application::Download),
    /// Write the application that the controller holds as an image
    Upload {
        /// Where to write the image
        image: PathBuf,
    },
    /// Say whether a project is the one in the controller
    Compare {
        /// The project: .rll, .L5K, .L5X, a folder, or an image
        project: PathBuf,
        #[command(flatten)]
        complete: Complete,
    },
    /// Change the mode, in more than one period and less than two
    Mode {
        /// The mode
        mode: ModeName,
        /// When it is asked for, in ms after a scan; half a period where this is not given
        #[arg(long, value_name = "MS")]
        at: Option<u64>,
    },
    /// Turn the keyswitch; RUN and PROG bring their mode with them
    Keyswitch {
        /// The position
        position: Position,
    },
    /// Run scans in the state that the controller is in
    Run(scans::Run),
    /// Generate the safety task signature: ID, date and time
    Generate {
        /// The date and time to use, instead of the clock's: 2026-11-22T18:00:00Z
        #[arg(long, value_name = "TIMESTAMP")]
        clock: Option<Timestamp>,
    },
    /// Delete the safety task signature
    Delete,
    /// Safety-lock the application
    Lock {
        /// The file that holds the lock password, - for the standard input
        #[arg(long, value_name = "FILE")]
        password: Option<PathBuf>,
    },
    /// Safety-unlock the application
    Unlock {
        /// The file that holds the unlock password, - for the standard input
        #[arg(long, value_name = "FILE")]
        password: Option<PathBuf>,
    },
    /// Set, change or remove the password for locking or for unlocking
    Password(protect::Password),
    /// Force a value of an I/O, produced or consumed safety tag
    Force {
        /// The value's full name, and what to hold it at: Doors:I.Pt00Data=1
        #[arg(value_name = "TAG=VALUE")]
        assignment: String,
    },
    /// Remove a force
    Unforce {
        /// The value's full name; all forces where this is not given
        tag: Option<String>,
    },
    /// Enable or disable the installed forces
    Forces {
        /// What to do with them
        change: Change,
    },
    /// Change rungs of safety routines online: begin, accept, test, untest, assemble, cancel
    Edit {
        #[command(subcommand)]
        step: edits::Step,
    },
    /// Inhibit the connection of a safety module
    Inhibit {
        /// The module
        module: String,
    },
    /// End the inhibition of a module
    Uninhibit {
        /// The module
        module: String,
    },
    /// Say whether a replaced module is configured, and what is to be done first
    Replace(replacement::Replace),
    /// Store the application on a memory card
    Store {
        /// The file that is the card
        card: PathBuf,
        /// The mode after a load
        #[arg(long, value_enum, default_value_t = AfterLoad::RemoteProgram)]
        load_mode: AfterLoad,
    },
    /// Load the application of a memory card
    Load {
        /// The file that is the card
        card: PathBuf,
    },
    /// Let the diagnostics of one channel's hardware fail: a nonrecoverable controller fault, to rehearse the recovery
    LosePartner,
    /// Show the fault log
    Faults,
    /// Clear the fault: safety memory is reinitialized from the signature
    Clear,
    /// Override the fault: standard tasks go on, the safety task does not
    Override,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum ModeName {
    /// The logic executes.
    Run,
    /// The logic does not execute, outputs are off.
    Program,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Position {
    /// RUN.
    Run,
    /// REM: software changes the mode.
    Rem,
    /// PROG.
    Prog,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Change {
    /// Let them act.
    Enable,
    /// Leave them installed, without effect.
    Disable,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum AfterLoad {
    /// A person starts the machine: the manual recommends it.
    RemoteProgram,
    /// The machine starts.
    RemoteRun,
}

impl From<AfterLoad> for LoadMode {
    fn from(after: AfterLoad) -> LoadMode {
        match after {
            AfterLoad::RemoteProgram => LoadMode::RemoteProgram,
            AfterLoad::RemoteRun => LoadMode::RemoteRun,
        }
    }
}

/// What an action ends with, other than a file or a folder that cannot be read or written.
type Ended = io::Result<ExitCode>;

/// Does what is asked, and keeps what it changed before it says so.
pub fn run(arguments: &Controller) -> io::Result<ExitCode> {
    let mut out = terminal::out();
    let mut kept = match &arguments.action {
        Do::Download(download) => {
            return application::download(&mut out, &arguments.folder, download);
        }
        Do::Load { card } => return application::load(&mut out, &arguments.folder, card),
        _ => Kept::open(&arguments.folder)?,
    };
    match &arguments.action {
        Do::Download(_) | Do::Load { .. } => Ok(ExitCode::SUCCESS),
        Do::Status { format } => match format {
            Format::Human => status::human(&mut out, &arguments.folder, &kept),
            Format::Json => status::json(&mut out, &kept),
        },
        Do::Upload { image } => application::upload(&mut out, &kept, image),
        Do::Compare { project, complete } => application::compare(&mut out, &kept, project, complete),
        Do::Mode { mode, at } => scans::change_mode(&mut out, &mut kept, *mode, *at),
        Do::Keyswitch { position } => scans::turn_keyswitch(&mut out, &mut kept, *position),
        Do::Run(run) => scans::run(&mut out, &mut kept, run),
        Do::Generate { clock } => application::generate(&mut out, &mut kept, *clock),
        Do::Delete => application::delete(&mut out, &mut kept),
        Do::Lock { password } => protect::lock(&mut out, &mut kept, password.as_deref()),
        Do::Unlock { password } => protect::unlock(&mut out, &mut kept, password.as_deref()),
        Do::Password(password) => protect::password(&mut out, &mut kept, password),
        Do::Force { assignment } => protect::force(&mut out, &mut kept, assignment),
        Do::Unforce { tag } => protect::unforce(&mut out, &mut kept, tag.as_deref()),
        Do::Forces { change } => protect::enable(&mut out, &mut kept, *change == Change::Enable),
        Do::Edit { step } => edits::edit(&mut out, &mut kept, step),
        Do::Inhibit { module } => protect::inhibit(&mut out, &mut kept, module, true),
        Do::Uninhibit { module } => protect::inhibit(&mut out, &mut kept, module, false),
        Do::Replace(replace) => replacement::replace(&mut out, &kept, replace),
        Do::Store { card, load_mode } => application::store(&mut out, &kept, card, (*load_mode).into()),
        Do::LosePartner => protect::lose_partner(&mut out, &mut kept),
        Do::Faults => status::faults(&mut out, &kept),
        Do::Clear => protect::clear(&mut out, &mut kept),
        Do::Override => protect::override_fault(&mut out, &mut kept),
    }
}

/// Says why something was refused.
fn refuse(out: &mut dyn Write, why: &dyn std::fmt::Display) -> Ended {
    writeln!(out, "{why}")?;
    Ok(ExitCode::from(exit::REFUSED))
}
