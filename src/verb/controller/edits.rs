//! Online edits of safety routines.

use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::Subcommand;
use twinrung_bytecode::signature::short_form;
use twinrung_commission::ControllerState;
use twinrung_commission::edit::HOLD_OFF_MS;
use twinrung_controller::fits;
use twinrung_controller::protection::Action;
use twinrung_grammar::tree::File;
use twinrung_workbench::both_versions::put_side_by_side;
use twinrung_workbench::online_edit::changed_safety_call;
use twinrung_workbench::reaction::milliseconds;

use super::folder::Kept;
use super::{Ended, refuse};
use crate::input::{self, Complete, Input};
use crate::{exit, failed};

/// A step of an online edit.
#[derive(Debug, Subcommand)]
#[command(after_help = "From a changed rung to the program:\n  \
twinrung controller cell edit begin changed.rll\n  twinrung controller cell edit accept\n  \
twinrung controller cell run --stimulus tests.csv --test-edits 500\n  twinrung controller cell edit assemble\n\
\n\
Only rungs of safety routines change: no tag, type, module, task or Add-On Instruction, and no call of a safety application\n\
instruction, whose configuration takes effect with a change from Program to Run.")]
pub(super) enum Step {
    /// Take the changed rungs of a project; the controller does not have them yet
    Begin {
        /// The project with the changed rungs: .rll, .L5K, .L5X, or a folder
        project: PathBuf,
        #[command(flatten)]
        complete: Complete,
    },
    /// Accept them into the controller; the original rungs execute
    Accept,
    /// Let the changed rungs execute
    Test,
    /// Let the original rungs execute again
    Untest,
    /// Make the changed rungs the program
    Assemble,
    /// Drop the changed rungs
    Cancel,
}

pub(super) fn edit(out: &mut dyn Write, kept: &mut Kept, step: &Step) -> Ended {
    let (done, words) = match step {
        Step::Begin { project, complete } => return begin(out, kept, project, complete),
        Step::Accept => (kept.state.accept_edits(), "accepted: the original rungs execute"),
        Step::Test => (kept.state.test_edits(), "tested: the changed rungs execute"),
        Step::Untest => (kept.state.untest_edits(), "untested: the original rungs execute"),
        Step::Assemble => (kept.state.assemble_edits(), "assembled: the changed rungs are the program"),
        Step::Cancel => (kept.state.cancel_edits(), "cancelled: the program is what it was"),
    };
    if let Err(why) = done {
        return refuse(out, &why);
    }
    kept.keep()?;
    writeln!(out, "{words}")?;
    match step {
        Step::Assemble => {
            writeln!(out, "the application is another one: what the edit affects is to be validated again")?;
        }
        Step::Test => writeln!(out, "{}", hold_off(kept)?)?,
        _ => {}
    }
    Ok(ExitCode::SUCCESS)
}

fn begin(out: &mut dyn Write, kept: &mut Kept, project: &Path, complete: &Complete) -> Ended {
    if let Err(why) = kept.state.permit(Action::BeginEdit) {
        return refuse(out, &why);
    }
    let read = match input::open(project, complete).map_err(failed)? {
        Input::Project(read) => read,
        Input::Image(_) => return refuse(out, &"an image has no text that could stand beside the original rungs"),
    };
    let loaded = match input::image_of(out, project, &read, "; no edit was begun")? {
        Ok(loaded) => loaded,
        Err(code) => return Ok(code),
    };
    let Some((own, _)) = kept.admitted()? else { return Ok(ExitCode::from(exit::REFUSED)) };
    let routines = match fits(own.image(), loaded.image.image()) {
        Ok(routines) if routines.is_empty() => {
            return refuse(out, &"no rung of a safety routine differs from the application in the controller");
        }
        Ok(routines) => routines,
        Err(why) => {
            return refuse(
                out,
                &format!(
                    "an online edit changes rungs of safety routines only: {why}\n  way out: download the project"
                ),
            );
        }
    };
    if let Some(call) = changed_safety_call(own.image(), loaded.image.image()) {
        return refuse(
            out,
            &format!(
                "an online edit changes no safety application instruction: {call}\n  way out: download the project"
            ),
        );
    }
    let (before, after) = (own.image(), loaded.image.image());
    let side_by_side = |tree: &mut File| put_side_by_side(tree, before, after, &routines);
    let both = match read.changed(complete, side_by_side).map_err(failed)? {
        Ok(both) => both,
        Err(why) => return refuse(out, &format!("{why}\n  way out: download the project")),
    };
    let both = match input::image_of(
        out,
        project,
        &both,
        " with the original rungs beside the changed ones; no edit was begun",
    )? {
        Ok(both) => both.bytes,
        Err(code) => return Ok(code),
    };
    let id = short_form(loaded.image.application_signature());
    for routine in &routines {
        writeln!(out, "changes {routine}")?;
    }
    if let Err(why) = kept.state.begin_edit(routines, loaded.bytes, both) {
        return refuse(out, &why);
    }
    kept.keep()?;
    writeln!(out, "pending: the application with these changes is {id}")?;
    Ok(ExitCode::SUCCESS)
}

/// What the manual says of the watchdog while communication can write safety memory (1756-RM093F p. 49).
pub(super) fn hold_off(kept: &Kept) -> io::Result<String> {
    let task = kept.admitted()?.and_then(|(image, _)| image.image().task.clone());
    let (period_us, watchdog_us) = task.map_or((0, 0), |task| (u64::from(task.period_us), u64::from(task.watchdog_us)));
    let hold_off_us = u64::from(HOLD_OFF_MS) * 1000;
    let room = if watchdog_us <= hold_off_us {
        "that alone is all of the watchdog: a timeout can occur"
    } else if watchdog_us.saturating_add(hold_off_us) > period_us {
        "more than the period is not possible, so scans have that much less time"
    } else {
        "a timeout can occur without it"
    };
    Ok(format!(
        "unlocked and without signature, communication can hold the safety task off: allow {HOLD_OFF_MS} ms more on the watchdog of {} ms; {room}",
        milliseconds(watchdog_us)
    ))
}

/// Whether communication can hold the safety task off.
pub(super) fn can_be_held_off(state: &ControllerState) -> bool {
    !state.locked && state.signature.is_none()
}
