//! Modes, keyswitch and scans.

use std::io::{self, Write};
use std::path::PathBuf;
use std::process::ExitCode;

use clap::Args;
use twinrung_bytecode::AdmittedImage;
use twinrung_commission::{ControllerState, Fault, FaultKind, Refused};
use twinrung_controller::Mode;
use twinrung_controller::protection::{Action, Keyswitch};
use twinrung_partner::Partner;
use twinrung_primary::Primary;
use twinrung_workbench::Run as Session;
use twinrung_workbench::Stimulus;
use twinrung_workbench::both_versions::SWITCH;
use twinrung_workbench::connected;
use twinrung_workbench::hold::Hold;
use twinrung_workbench::reaction::milliseconds;
use twinrung_workbench::run::default_names;
use twinrung_workbench::stimulus::StimulusRow;
use twinrung_workbench::transition::{Transition, transition};

use super::folder::Kept;
use super::status::{keyswitch_name, mode_name};
use super::{Ended, ModeName, Position, refuse};
use crate::play::{DIAGRAM_ROWS, Playing, explained, listed};
use crate::{exit, failed, input};

/// Arguments of `controller FOLDER run`.
#[derive(Debug, Args)]
#[command(
    after_help = "The controller powers up in the mode that it is in: each run begins with the initial values. Forces and inhibited\n\
modules act. A fault stays with the controller until it is cleared.\n\
A stimulus may drive safety data that is no input only while the controller is unlocked and without signature."
)]
pub(super) struct Run {
    /// What drives the inputs
    #[arg(long, value_name = "CSV")]
    stimulus: Option<PathBuf>,
    /// What to record: names, or @FILE with one name on each line
    #[arg(long, value_name = "TAG,TAG|@LIST")]
    record: Option<String>,
    /// Test the accepted online edit from the first scan at or after this time on, in ms; it stays tested
    #[arg(long, value_name = "MS")]
    test_edits: Option<u64>,
    /// Untest it from the first scan at or after this time on, in ms
    #[arg(long, value_name = "MS")]
    untest_edits: Option<u64>,
    #[command(flatten)]
    playing: Playing,
}

/// What is held in scans: the safe state of inhibited modules, then forces.
fn holds(state: &ControllerState, image: &AdmittedImage) -> io::Result<Vec<Hold>> {
    let mut holds: Vec<Hold> =
        state.inhibited.iter().filter_map(|module| connected::inhibited(image, module)).flatten().collect();
    for force in state.forces.iter().filter(|_| state.forces_enabled) {
        holds.push(connected::force(image, &force.tag, &force.value).map_err(failed)?);
    }
    Ok(holds)
}

pub(super) fn change_mode(out: &mut dyn Write, kept: &mut Kept, mode: ModeName, at: Option<u64>) -> Ended {
    let mode = if mode == ModeName::Run { Mode::Run } else { Mode::Program };
    let before = kept.state.mode;
    if let Err(why) = kept.state.change_mode(mode) {
        return refuse(out, &why);
    }
    if before == mode {
        writeln!(out, "the controller is in {} mode", mode_name(mode))?;
        return Ok(ExitCode::SUCCESS);
    }
    pass(out, kept, at)
}

pub(super) fn turn_keyswitch(out: &mut dyn Write, kept: &mut Kept, position: Position) -> Ended {
    let before = kept.state.mode;
    let keyswitch = match position {
        Position::Run => Keyswitch::Run,
        Position::Rem => Keyswitch::Remote,
        Position::Prog => Keyswitch::Program,
    };
    if let Err(why) = kept.state.turn_keyswitch(keyswitch) {
        return refuse(out, &why);
    }
    writeln!(out, "the keyswitch is in {}", keyswitch_name(keyswitch))?;
    if kept.state.mode == before {
        kept.keep()?;
        return Ok(ExitCode::SUCCESS);
    }
    pass(out, kept, None)
}

/// Lets the scans pass that a mode change takes, keeps the new mode, and says how long it took.
fn pass(out: &mut dyn Write, kept: &mut Kept, at: Option<u64>) -> Ended {
    let mode = kept.state.mode;
    let fault = match (kept.executing()?, &kept.state.fault) {
        (Some((image, bytes)), None) => {
            let holds = holds(&kept.state, &image)?;
            let period_us = image.image().task.as_ref().map_or(0, |task| u64::from(task.period_us));
            let asked_us = at.map_or(period_us / 2, |at| at.saturating_mul(1000));
            if asked_us == 0 || asked_us >= period_us {
                return Err(io::Error::other(format!(
                    "--at is a time between two scans: above 0 and below the period of {} ms",
                    milliseconds(period_us)
                )));
            }
            let done: Transition =
                transition::<Primary, Partner>(image.clone(), bytes, mode, asked_us, &holds).map_err(failed)?;
            writeln!(
                out,
                "{} mode {} ms after it was asked for: more than one period of {} ms, less than two",
                mode_name(mode),
                milliseconds(done.took_us()),
                milliseconds(period_us)
            )?;
            done.stopped.map(|reason| Fault::of(reason, done.acted_ms, explained(&image, reason)))
        }
        _ => {
            writeln!(out, "{} mode", mode_name(mode))?;
            None
        }
    };
    let code = fault.as_ref().map_or(ExitCode::SUCCESS, |fault| code_of(fault.kind));
    if let Some(fault) = fault {
        writeln!(out, "{} {}/{}: {}", fault.kind.name(), fault.fault_type, fault.code, fault.what)?;
        kept.state.report_fault(fault);
    }
    kept.keep()?;
    Ok(code)
}

fn code_of(kind: FaultKind) -> ExitCode {
    match kind {
        FaultKind::Recoverable => ExitCode::from(exit::RECOVERABLE),
        FaultKind::NonrecoverableSafety | FaultKind::NonrecoverableController => ExitCode::from(exit::NONRECOVERABLE),
    }
}

/// When the switch of an online edit is to be turned, in ms, and where to.
fn turns(arguments: &Run) -> Vec<(u64, bool)> {
    let mut turns: Vec<(u64, bool)> = Vec::new();
    turns.extend(arguments.test_edits.map(|at_ms| (at_ms, true)));
    turns.extend(arguments.untest_edits.map(|at_ms| (at_ms, false)));
    turns.sort_by_key(|(at_ms, _)| *at_ms);
    turns
}

/// Turns the switch: `state` is then as it is after the last of these turns.
fn turn(state: &mut ControllerState, turns: &[(u64, bool)]) -> Result<(), Refused> {
    turns.iter().try_for_each(|(_, test)| if *test { state.test_edits() } else { state.untest_edits() })
}

/// A stimulus with the switch of an online edit as its last column.
fn switched(stimulus: Option<Stimulus>, tested: bool, turns: &[(u64, bool)]) -> io::Result<Stimulus> {
    let Stimulus { mut tags, mut rows } = stimulus.unwrap_or_else(|| Stimulus { tags: Vec::new(), rows: Vec::new() });
    if tags.iter().any(|tag| tag.eq_ignore_ascii_case(SWITCH)) {
        return Err(io::Error::other(format!("{SWITCH} is turned by edit test and --test-edits, not by a stimulus")));
    }
    rows.iter_mut().for_each(|row| row.cells.push(None));
    let column = tags.len();
    tags.push(SWITCH.to_owned());
    for (time_ms, value) in [(0, tested)].iter().chain(turns) {
        let at = rows.partition_point(|row| row.time_ms < *time_ms);
        if rows.get(at).is_none_or(|row| row.time_ms != *time_ms) {
            rows.insert(at, StimulusRow { line: 0, time_ms: *time_ms, cells: vec![None; column + 1] });
        }
        if let Some(cell) = rows.get_mut(at).and_then(|row| row.cells.get_mut(column)) {
            *cell = Some(u8::from(*value).to_string());
        }
    }
    Ok(Stimulus { tags, rows })
}

pub(super) fn run(out: &mut dyn Write, kept: &mut Kept, arguments: &Run) -> Ended {
    if let Some(fault) = &kept.state.fault {
        writeln!(
            out,
            "the safety task does not execute, outputs are off: {} {}/{}, {}",
            fault.kind.name(),
            fault.fault_type,
            fault.code,
            fault.what
        )?;
        return Ok(code_of(fault.kind));
    }
    let mut turns = turns(arguments);
    if let Err(why) = turn(&mut kept.state.clone(), &turns) {
        return refuse(out, &why);
    }
    let (executing, tested) = match kept.both_versions()? {
        Some((image, bytes, tested)) => (Some((image, bytes)), Some(tested)),
        None => (kept.executing()?, None),
    };
    let Some((image, bytes)) = executing else {
        return refuse(out, &"the controller holds no application: download the project");
    };
    let stimulus = match &arguments.stimulus {
        Some(path) => input::stimulus(path, Some(path))?,
        None => None,
    };
    let manipulated = stimulus.as_ref().map(|stimulus| connected::safety_data(&image, &stimulus.tags));
    if let Some(tag) = manipulated.iter().flatten().next()
        && let Err(why) = kept.state.permit(Action::WriteSafetyData)
    {
        writeln!(out, "the stimulus drives {tag}, which is safety data and no input")?;
        return refuse(out, &why);
    }
    let stimulus = match tested {
        Some(tested) => Some(switched(stimulus, tested, &turns)?),
        None => stimulus,
    };
    let names = match &arguments.record {
        Some(list) => listed(list)?,
        None => default_names(&image, stimulus.as_ref(), DIAGRAM_ROWS),
    };
    let holds = holds(&kept.state, &image)?;
    let mut session: Session<Primary, Partner> = Session::in_mode(image, bytes, kept.state.mode).map_err(failed)?;
    holds.into_iter().for_each(|hold| session.hold(hold));
    let heading = format!("{} mode, one scan every {} ms", mode_name(kept.state.mode), session.period_ms());
    let played = arguments.playing.play(&mut session, stimulus.as_ref(), &names)?;
    // What was not reached, or would have come after the task stopped, did not happen.
    let executed_until_ms = played.executed_until_ms(session.period_ms());
    turns.retain(|(at_ms, _)| executed_until_ms.is_some_and(|last_ms| *at_ms <= last_ms));
    if !turns.is_empty() {
        turn(&mut kept.state, &turns).map_err(failed)?;
        kept.keep()?;
    }
    if let Some((at_ms, reason)) = played.stopped() {
        let what = explained(session.controller().image(), reason);
        kept.state.report_fault(Fault::of(reason, at_ms, what));
        kept.keep()?;
    }
    arguments.playing.show(out, &mut session, &played, &heading)
}
