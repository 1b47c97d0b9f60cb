//! `docs/protection.md`: what a controller permits in which state, from the controller's table.

use std::fmt::Write;

use twinrung_controller::Mode;
use twinrung_controller::protection::{
    Action, Edits, Forces, IMPOSSIBLE, Offer, OfferedSignature, RULES, SafetyTaskStatus, State, impossible, judge,
};

use super::markdown::escaped;

/// The states of Table 8, and the two of Program mode beside them.
fn states() -> Vec<(String, State)> {
    let mut states = Vec::new();
    for mode in [Mode::Program, Mode::Run] {
        for (locked, signed) in [(false, false), (true, false), (false, true), (true, true)] {
            let mode_name = if mode == Mode::Run { "Run" } else { "Program" };
            let lock = if locked { "locked" } else { "unlocked" };
            let signature = if signed { "signature" } else { "no signature" };
            let state = State::online(mode, locked, signed);
            states.push((format!("{mode_name}, {lock}, {signature}"), state));
        }
    }
    states
}

/// A row of the first table: an action, and what else must be so that only lock, signature and mode decide.
struct Row {
    name: &'static str,
    action: Action,
    with: fn(State) -> State,
}

fn rows() -> Vec<Row> {
    let as_it_is: fn(State) -> State = |state| state;
    let forced: fn(State) -> State = |state| State { forces: Forces::Enabled, ..state };
    let accepted: fn(State) -> State = |state| State { edits: Edits::Accepted, ..state };
    let faulted: fn(State) -> State = |state| State { status: SafetyTaskStatus::NonrecoverableSafetyFault, ..state };
    let (same, other) = (Offer::fitting(OfferedSignature::Same), Offer::fitting(OfferedSignature::Other));
    let plain = [
        Action::ChangeMode(Mode::Run),
        Action::ChangeMode(Mode::Program),
        Action::Upload,
        Action::StoreToCard,
        Action::GenerateSignature,
        Action::DeleteSignature,
        Action::Lock,
        Action::Unlock,
        Action::InstallForce,
        Action::WriteSafetyData,
        Action::BeginEdit,
        Action::InhibitModule,
        Action::UninhibitModule,
    ];
    let plain = plain.map(|action| (action.verb().name(), action, as_it_is));
    let others = [
        ("download, the same signature", Action::Download(same), as_it_is),
        ("download, another application", Action::Download(other), as_it_is),
        ("load from the card, the same signature", Action::LoadFromCard(same), as_it_is),
        ("load from the card, another application", Action::LoadFromCard(other), as_it_is),
        ("remove a force, when one is installed", Action::RemoveForce, forced),
        ("assemble online edits, when some are accepted", Action::AssembleEdits, accepted),
        ("cancel online edits, when some are accepted", Action::CancelEdits, accepted),
        ("clear a nonrecoverable safety fault", Action::ClearFault, faulted),
        ("override a nonrecoverable safety fault", Action::OverrideFault, faulted),
    ];
    let row = |(name, action, with): (&'static str, Action, fn(State) -> State)| Row { name, action, with };
    plain.into_iter().chain(others).map(row).collect()
}

fn cell(state: State, action: Action) -> &'static str {
    match (impossible(state, action), judge(state, action)) {
        (Some(_), _) => "cannot occur",
        (None, Ok(())) => "yes",
        (None, Err(rule)) => rule.code,
    }
}

/// The page.
pub fn protection_page() -> String {
    let mut out = String::from(
        "# Modes and protection\n\nWhat a controller permits in which state. This page is made from the table that the \
         controller asks (`vm/controller/src/protection`), and a test compares the two; another test holds the table to what \
         1756-RM093I says, cell by cell (`vm/controller/tests/protection.table`).\n\n## By mode, lock and signature\n\nOnline, keyswitch in REM, no forces, no online edits, \
         safety task status OK, where the row does not say otherwise. A number is the reason below.\n\n",
    );
    let states = states();
    let heads: Vec<&str> = states.iter().map(|(name, _)| name.as_str()).collect();
    let _ = writeln!(out, "| action | {} |\n|---|{}", heads.join(" | "), "---|".repeat(heads.len()));
    for Row { name, action, with } in rows() {
        let cells: Vec<&str> = states.iter().map(|(_, state)| cell(with(*state), action)).collect();
        let _ = writeln!(out, "| {name} | {} |", cells.join(" | "));
    }
    let reached: Vec<&str> = states.iter().map(|(_, state)| state.integrity()).collect();
    let _ = writeln!(out, "| *good for, at most (Table 8)* | {} |", reached.join(" | "));
    out.push_str(
        "\n## Every reason\n\nA row refuses its actions when all that the third column says is so. Of those that refuse an \
         action, the first is given.\n\n| | refuses | when | because | way out | source |\n|---|---|---|---|---|---|\n",
    );
    for rule in RULES {
        let actions: Vec<&str> = rule.actions.iter().map(|verb| verb.name()).collect();
        let when: Vec<&str> = rule.when.iter().map(|condition| condition.words()).collect();
        let cells = [&actions.join(", "), &when.join(", "), rule.reason, rule.way_out, rule.source].map(escaped);
        let _ = writeln!(out, "| {} | {} |", rule.code, cells.join(" | "));
    }
    out.push_str("\n## What cannot occur\n\n| reason | source |\n|---|---|\n");
    for one in IMPOSSIBLE {
        let _ = writeln!(out, "| {} | {} |", escaped(one.reason), escaped(one.source));
    }
    out
}
