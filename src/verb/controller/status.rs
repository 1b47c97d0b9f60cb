//! What a controller is, what it holds, and what is permitted now.

use std::io::Write;
use std::path::Path;
use std::process::ExitCode;

use serde::Serialize;
use twinrung_bytecode::signature::short_form;
use twinrung_commission::{Application, LogEntry, Permission, SealedInstruction, permissions};
use twinrung_controller::Mode;
use twinrung_controller::protection::{Keyswitch, SafetyTaskStatus};

use super::folder::Kept;
use super::{Ended, edits};
use crate::format::write_json;

pub(super) const fn mode_name(mode: Mode) -> &'static str {
    match mode {
        Mode::Run => "Run",
        Mode::Program => "Program",
    }
}

pub(super) const fn keyswitch_name(keyswitch: Keyswitch) -> &'static str {
    match keyswitch {
        Keyswitch::Run => "RUN",
        Keyswitch::Remote => "REM",
        Keyswitch::Program => "PROG",
    }
}

const fn status_name(status: SafetyTaskStatus) -> &'static str {
    match status {
        SafetyTaskStatus::NoProject => "no application",
        SafetyTaskStatus::Ok => "OK",
        SafetyTaskStatus::RecoverableFault => "recoverable fault",
        SafetyTaskStatus::NonrecoverableSafetyFault => "nonrecoverable safety fault",
        SafetyTaskStatus::NonrecoverableControllerFault => "nonrecoverable controller fault",
    }
}

fn action_name(permission: &Permission) -> String {
    match permission.offer {
        Some(offer) => format!("{} ({offer})", permission.verb.name()),
        None => permission.verb.name().to_owned(),
    }
}

/// The safety Add-On Instructions, each with the three values that are compared after a download.
pub(super) fn instruction_lines(application: &Application) -> impl Iterator<Item = String> {
    application.instructions.iter().map(|one| instruction_line(one, application.from_image))
}

fn instruction_line(one: &SealedInstruction, from_image: bool) -> String {
    let safety = short_form(&one.safety);
    match (&one.instruction, &one.generated) {
        (Some(id), Some(generated)) => {
            format!(
                "{}: instruction signature {}  {generated}, safety instruction signature {safety}",
                one.name,
                short_form(id)
            )
        }
        _ if from_image => {
            format!("{}: an image does not say whether it is sealed; safety instruction signature {safety}", one.name)
        }
        _ => format!("{}: not sealed, safety instruction signature {safety}", one.name),
    }
}

pub(super) fn human(out: &mut dyn Write, folder: &Path, kept: &Kept) -> Ended {
    let state = &kept.state;
    let admitted = kept.admitted()?;
    let application = match (&state.application, &admitted) {
        (Some(application), Some((image, _))) => {
            format!("{}  {}", application.name, short_form(image.application_signature()))
        }
        _ => "none".to_owned(),
    };
    let set = [(&state.passwords.lock, "lock"), (&state.passwords.unlock, "unlock")];
    let set: Vec<&str> = set.iter().filter(|(hash, _)| hash.is_some()).map(|(_, name)| *name).collect();
    let locked = if state.locked { "locked" } else { "unlocked" };
    let passwords =
        if set.is_empty() { "no passwords".to_owned() } else { format!("password for {}", set.join(" and ")) };
    let lines = [
        ("controller", format!("{}, state {}", folder.display(), kept.generation())),
        ("hardware", state.identity.to_string()),
        ("application", application),
        ("keyswitch, mode", format!("{}, {}", keyswitch_name(state.keyswitch), mode_name(state.mode))),
        ("safety task status", status_name(state.status()).to_owned()),
        ("safety lock", format!("{locked}; {passwords}")),
        ("signature", state.signature.map_or_else(|| "none".to_owned(), |signature| signature.to_string())),
        ("good for", state.protection().integrity().to_owned()),
    ];
    for (name, text) in lines {
        writeln!(out, "{name:20}{text}")?;
    }
    for line in state.application.iter().flat_map(instruction_lines) {
        writeln!(out, "{:20}{line}", "instruction")?;
    }
    for force in &state.forces {
        let enabled = if state.forces_enabled { "" } else { " (disabled)" };
        writeln!(out, "{:20}{} = {}{enabled}", "force", force.tag, force.value)?;
    }
    if let Some(edit) = &state.edit {
        writeln!(out, "{:20}{}; changes {}", "online edit", edit.stage.words(), edit.routines.join(", "))?;
    }
    if admitted.is_some() && edits::can_be_held_off(state) {
        writeln!(out, "{:20}{}", "watchdog", edits::hold_off(kept)?)?;
    }
    for module in &state.inhibited {
        writeln!(out, "{:20}{module}", "inhibited")?;
    }
    if let Some(fault) = &state.fault {
        let overridden = if state.overridden { "; overridden, not cleared" } else { "" };
        writeln!(
            out,
            "{:20}{}/{} at {} ms, {}{overridden}",
            "fault", fault.fault_type, fault.code, fault.at_ms, fault.what
        )?;
    }
    let all = permissions(state);
    let permitted: Vec<String> = all.iter().filter(|one| one.refused.is_empty()).map(action_name).collect();
    writeln!(out, "\npermitted now")?;
    for name in permitted {
        writeln!(out, "  {name}")?;
    }
    writeln!(out, "\nrefused now")?;
    for permission in all.iter().filter(|one| !one.refused.is_empty()) {
        writeln!(out, "  {}", action_name(permission))?;
        for rule in &permission.refused {
            writeln!(out, "      {} {}: {}", rule.code, rule.reason, rule.way_out)?;
        }
    }
    Ok(ExitCode::SUCCESS)
}

#[derive(Serialize)]
struct Json<'a> {
    generation: u64,
    catalog_number: &'a str,
    series: char,
    revision: u16,
    application: Option<&'a str>,
    application_signature: Option<String>,
    keyswitch: &'static str,
    mode: &'static str,
    status: &'static str,
    locked: bool,
    lock_password: bool,
    unlock_password: bool,
    signature: Option<twinrung_commission::SafetyTaskSignature>,
    instructions: &'a [SealedInstruction],
    /// Whether the application came as an image, which does not say what is sealed.
    from_image: bool,
    forces: &'a [twinrung_commission::Force],
    forces_enabled: bool,
    online_edit: Option<&'static str>,
    inhibited: &'a [String],
    fault: &'a Option<twinrung_commission::Fault>,
    overridden: bool,
    log: &'a [LogEntry],
    permissions: Vec<JsonPermission>,
}

#[derive(Serialize)]
struct JsonPermission {
    action: String,
    permitted: bool,
    refused: Vec<JsonRule>,
}

#[derive(Serialize)]
struct JsonRule {
    code: &'static str,
    reason: &'static str,
    way_out: &'static str,
}

pub(super) fn json(out: &mut dyn Write, kept: &Kept) -> Ended {
    let state = &kept.state;
    let signature = kept.admitted()?.map(|(image, _)| short_form(image.application_signature()).to_string());
    let permissions = permissions(state)
        .iter()
        .map(|one| JsonPermission {
            action: action_name(one),
            permitted: one.refused.is_empty(),
            refused: one
                .refused
                .iter()
                .map(|rule| JsonRule { code: rule.code, reason: rule.reason, way_out: rule.way_out })
                .collect(),
        })
        .collect();
    let json = Json {
        generation: kept.generation(),
        catalog_number: &state.identity.catalog_number,
        series: state.identity.series,
        revision: state.identity.revision,
        application: state.application.as_ref().map(|application| application.name.as_str()),
        application_signature: signature,
        keyswitch: keyswitch_name(state.keyswitch),
        mode: mode_name(state.mode),
        status: status_name(state.status()),
        locked: state.locked,
        lock_password: state.passwords.lock.is_some(),
        unlock_password: state.passwords.unlock.is_some(),
        signature: state.signature,
        instructions: state.application.as_ref().map_or(&[], |application| &application.instructions),
        from_image: state.application.as_ref().is_some_and(|application| application.from_image),
        forces: &state.forces,
        forces_enabled: state.forces_enabled,
        online_edit: state.edit.as_ref().map(|edit| edit.stage.words()),
        inhibited: &state.inhibited,
        fault: &state.fault,
        overridden: state.overridden,
        log: &state.log,
        permissions,
    };
    write_json(out, &json)?;
    Ok(ExitCode::SUCCESS)
}

pub(super) fn faults(out: &mut dyn Write, kept: &Kept) -> Ended {
    if kept.state.log.is_empty() {
        writeln!(out, "no fault was logged")?;
    }
    for LogEntry { fault, outcome } in &kept.state.log {
        let outcome = outcome.as_deref().unwrap_or("present");
        let (kind, what) = (fault.kind.name(), &fault.what);
        writeln!(out, "{}/{} at {} ms  {kind}: {what}; {outcome}", fault.fault_type, fault.code, fault.at_ms)?;
    }
    Ok(ExitCode::SUCCESS)
}
