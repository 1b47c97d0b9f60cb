//! Signature, lock, forces, card and faults of a controller.

mod common;

use std::collections::HashSet;

use common::controller;
use jiff::Timestamp;
use twinrung_commission::lifecycle::Project;
use twinrung_commission::{
    Application, Card, ControllerState, Downloaded, Fault, FaultKind, Force, Identity, LOG_ENTRIES_MAX, LoadMode,
    PasswordError, Refused, SafetyTaskSignature,
};
use twinrung_controller::Mode;
use twinrung_controller::protection::Keyswitch;

fn project(id: u8) -> Project {
    Project {
        made_for: controller().identity,
        id: [id; 32],
        application: Application {
            name: format!("Project_{id}"),
            image: vec![id; 3],
            instructions: Vec::new(),
            from_image: false,
        },
    }
}

fn at(seconds: i64) -> Timestamp {
    Timestamp::from_second(seconds).unwrap()
}

/// With project 1.
fn downloaded() -> ControllerState {
    let mut state = controller();
    state.download(project(1)).unwrap();
    state
}

/// With project 1 and its signature.
fn signed() -> ControllerState {
    let mut state = downloaded();
    state.generate_signature([1; 32], at(1000)).unwrap();
    state
}

fn rule<T: std::fmt::Debug>(result: Result<T, Refused>) -> &'static str {
    match result {
        Err(Refused::Rule { rule, .. }) => rule.code,
        other => panic!("{other:?}"),
    }
}

fn fault(kind: FaultKind) -> Fault {
    Fault { kind, fault_type: 14, code: 7, at_ms: 40, what: "the channels differ".to_owned() }
}

fn forced(tag: &str) -> Force {
    Force { tag: tag.to_owned(), value: "1".to_owned() }
}

/// REQ-SIGN-001, REQ-SIGN-002
#[test]
fn signature_when_generated_then_it_is_the_application_s_id_with_date_and_time() {
    let state = signed();
    let signature = SafetyTaskSignature { id: [1; 32], generated: at(1000) };
    assert_eq!(state.signature, Some(signature));
    assert_eq!(signature.to_string(), "0101_0101  1970-01-01T00:16:40Z");
}

/// REQ-SIGN-002
#[test]
fn signature_when_a_condition_is_missing_then_it_is_not_generated_and_nothing_changes() {
    let refused = |change: fn(&mut ControllerState)| {
        let mut state = downloaded();
        change(&mut state);
        let before = state.clone();
        let code = rule(state.generate_signature([1; 32], at(1)));
        assert_eq!(state, before);
        code
    };
    assert_eq!(refused(|state| state.change_mode(Mode::Run).unwrap()), "P21");
    assert_eq!(refused(|state| state.lock(None).unwrap()), "P22");
    assert_eq!(refused(|state| state.install_force(forced("Doors:I.Pt00Data")).unwrap()), "P23");
    assert_eq!(
        refused(|state| {
            state.install_force(forced("Doors:I.Pt00Data")).unwrap();
            state.enable_forces(false).unwrap();
        }),
        "P23"
    );
    assert_eq!(refused(|state| state.report_fault(fault(FaultKind::Recoverable))), "P25");
    assert_eq!(rule(controller().generate_signature([1; 32], at(1))), "P03");
    assert_eq!(rule(signed().generate_signature([1; 32], at(1))), "P20");
}

/// REQ-SIGN-003
#[test]
fn signature_when_locked_or_the_keyswitch_is_in_run_then_it_is_not_deleted() {
    let mut state = signed();
    state.lock(None).unwrap();
    assert_eq!(rule(state.delete_signature()), "P22");
    state.unlock(None).unwrap();
    state.turn_keyswitch(Keyswitch::Run).unwrap();
    assert_eq!(rule(state.delete_signature()), "P26");
    state.turn_keyswitch(Keyswitch::Program).unwrap();
    state.delete_signature().unwrap();
    assert_eq!(state.signature, None);
}

/// REQ-SIGN-004
#[test]
fn download_when_the_project_gives_the_same_id_then_the_signature_stays_with_its_date() {
    let mut state = signed();
    state.lock(None).unwrap();
    let signature = state.signature.unwrap();
    assert_eq!(state.download(project(1)), Ok(Downloaded::SignatureKept(signature)));
    assert_eq!((state.signature, state.locked), (Some(signature), true));
}

/// REQ-SIGN-004
#[test]
fn download_when_the_project_is_another_then_a_locked_controller_refuses_and_an_unlocked_one_deletes_its_signature() {
    let mut state = signed();
    let signature = state.signature.unwrap();
    state.lock(None).unwrap();
    assert_eq!(rule(state.download(project(2))), "P15");
    assert_eq!(state.application.as_ref().unwrap().name, "Project_1");
    state.unlock(None).unwrap();
    assert_eq!(state.download(project(2)), Ok(Downloaded::SignatureDeleted(signature)));
    assert_eq!((state.signature, state.application.unwrap().name.as_str()), (None, "Project_2"));
}

/// REQ-SIGN-004
#[test]
fn download_when_type_revision_or_series_differ_then_it_is_refused_as_the_lock_asks() {
    let mut state = signed();
    let with = |change: fn(&mut Identity)| {
        let mut project = project(1);
        change(&mut project.made_for);
        project
    };
    assert_eq!(rule(state.download(with(|made_for| made_for.catalog_number = "1756-L72S".to_owned()))), "P12");
    assert_eq!(rule(state.download(with(|made_for| made_for.revision = 21))), "P13");
    assert!(state.download(with(|made_for| made_for.series = 'C')).is_ok());
    state.lock(None).unwrap();
    assert_eq!(rule(state.download(with(|made_for| made_for.series = 'C'))), "P17");
    assert_eq!(rule(downloaded_and_locked().download(project(1))), "P14");
    state.change_mode(Mode::Run).unwrap();
    assert_eq!(rule(state.download(project(1))), "P11");
}

fn downloaded_and_locked() -> ControllerState {
    let mut state = downloaded();
    state.lock(None).unwrap();
    state
}

/// REQ-MODE-004
#[test]
fn lock_when_passwords_are_set_then_each_asks_for_its_own() {
    let mut state = signed();
    state.set_password(true, None, Some(b"shut")).unwrap();
    state.set_password(false, None, Some(b"open")).unwrap();
    assert_eq!(state.lock(None), Err(Refused::Password(PasswordError::Missing)));
    assert_eq!(state.lock(Some(b"open")), Err(Refused::Password(PasswordError::Wrong)));
    state.lock(Some(b"shut")).unwrap();
    assert_eq!(state.unlock(Some(b"shut")), Err(Refused::Password(PasswordError::Wrong)));
    assert!(state.locked);
    state.unlock(Some(b"open")).unwrap();
    assert_eq!(state.set_password(false, None, None), Err(Refused::Password(PasswordError::Missing)));
    state.set_password(false, Some(b"open"), None).unwrap();
    state.lock(Some(b"shut")).unwrap();
    state.unlock(None).unwrap();
}

/// REQ-MODE-004. What is kept is a salted Argon2id hash; nothing prints it.
#[test]
fn password_when_kept_then_neither_it_nor_an_equal_hash_of_it_is_found() {
    let mut state = downloaded();
    state.set_password(true, None, Some(b"correct horse")).unwrap();
    state.set_password(false, None, Some(b"correct horse")).unwrap();
    let kept = serde_json::to_string(&state).unwrap();
    assert!(kept.contains("$argon2id$") && !kept.contains("correct horse"));
    assert_ne!(state.passwords.lock, state.passwords.unlock);
    assert!(!format!("{state:?}").contains("argon2id"));
    assert_eq!(state.set_password(true, Some(b"correct horse"), Some(b"")), Err(PasswordError::Length.into()));
}

/// REQ-MODE-005
#[test]
fn forces_when_installed_then_neither_lock_nor_signature_is_had_until_they_are_removed() {
    let mut state = downloaded();
    state.install_force(forced("Doors:I.Pt00Data")).unwrap();
    state.install_force(forced("doors:i.pt00data")).unwrap();
    assert_eq!(state.forces.len(), 1);
    state.enable_forces(false).unwrap();
    assert_eq!(rule(state.lock(None)), "P32");
    assert_eq!(state.remove_force(Some("Doors:I.Pt01Data")), Err(Refused::NoForce("Doors:I.Pt01Data".to_owned())));
    state.remove_force(None).unwrap();
    state.lock(None).unwrap();
    assert_eq!(rule(state.install_force(forced("Doors:I.Pt00Data"))), "P40");
    assert_eq!(rule(signed().install_force(forced("Doors:I.Pt00Data"))), "P41");
}

/// REQ-MODE-006
#[test]
fn module_when_inhibited_then_it_can_be_undone_until_lock_or_signature() {
    let mut state = downloaded();
    state.inhibit("Doors", true).unwrap();
    assert_eq!(state.inhibit("doors", true), Err(Refused::Module("doors".to_owned())));
    state.lock(None).unwrap();
    assert_eq!(rule(state.inhibit("Doors", false)), "P47");
    state.unlock(None).unwrap();
    state.inhibit("Doors", false).unwrap();
    assert_eq!(state.inhibited, Vec::<String>::new());
    assert_eq!(rule(signed().inhibit("Doors", true)), "P48");
}

/// REQ-MODE-007
#[test]
fn keyswitch_when_turned_then_it_brings_its_mode_and_software_cannot_change_it() {
    let mut state = downloaded();
    state.turn_keyswitch(Keyswitch::Run).unwrap();
    assert_eq!(state.mode, Mode::Run);
    assert_eq!(rule(state.change_mode(Mode::Program)), "P05");
    assert_eq!(rule(state.lock(None)), "P30");
    state.turn_keyswitch(Keyswitch::Remote).unwrap();
    assert_eq!(state.mode, Mode::Run);
    state.turn_keyswitch(Keyswitch::Program).unwrap();
    assert_eq!((state.mode, rule(state.change_mode(Mode::Run))), (Mode::Program, "P06"));
    assert_eq!(state.turn_keyswitch(Keyswitch::Program), Err(Refused::Keyswitch));
    assert_eq!(rule(controller().change_mode(Mode::Run)), "P03");
}

/// REQ-SIGN-005
#[test]
fn card_when_loaded_into_an_unlocked_controller_then_lock_passwords_and_signature_are_those_of_the_card() {
    let mut origin = signed();
    origin.set_password(false, None, Some(b"open")).unwrap();
    origin.lock(None).unwrap();
    let card = origin.store_to_card(LoadMode::RemoteProgram).unwrap();
    let card = Card::decode(&card.encode().unwrap()).unwrap();
    let mut state = controller();
    state.download(project(2)).unwrap();
    state.load_from_card(card).unwrap();
    assert_eq!((state.locked, state.signature, state.mode), (true, origin.signature, Mode::Program));
    assert_eq!(state.passwords, origin.passwords);
    assert_eq!(state.application, origin.application);
}

/// REQ-SIGN-005
#[test]
fn card_when_the_controller_is_locked_then_only_its_own_signature_is_loaded() {
    let mut other = controller();
    other.download(project(2)).unwrap();
    let without = other.store_to_card(LoadMode::RemoteRun).unwrap();
    other.generate_signature([2; 32], at(5)).unwrap();
    let with_other = other.store_to_card(LoadMode::RemoteRun).unwrap();
    let own = signed().store_to_card(LoadMode::RemoteRun).unwrap();
    let mut state = signed();
    state.lock(None).unwrap();
    assert_eq!(rule(state.load_from_card(with_other)), "P15");
    assert_eq!(rule(state.load_from_card(without)), "P16");
    state.load_from_card(own.clone()).unwrap();
    assert_eq!((state.locked, state.mode), (true, Mode::Run));
    assert_eq!(rule(state.load_from_card(own.clone())), "P11");
    assert_eq!(rule(downloaded_and_locked().load_from_card(own)), "P14");
}

/// REQ-SIGN-005
#[test]
fn card_when_the_controller_has_none_or_its_bytes_are_damaged_then_it_is_refused() {
    let old = Identity { catalog_number: "1756-L63S".to_owned(), series: 'A', revision: 17 };
    let mut state = ControllerState::new(old.clone());
    state.download(Project { made_for: old, ..project(1) }).unwrap();
    assert_eq!(rule(state.store_to_card(LoadMode::RemoteProgram)), "P04");
    let mut bytes = signed().store_to_card(LoadMode::RemoteProgram).unwrap().encode().unwrap();
    let last = bytes.len() - 40;
    bytes[last] ^= 1;
    assert!(Card::decode(&bytes).is_err());
}

/// REQ-FAULT-001
#[test]
fn safety_fault_when_there_is_a_signature_then_clearing_reinitializes_from_it_and_otherwise_a_download_does() {
    let mut state = signed();
    state.report_fault(fault(FaultKind::NonrecoverableSafety));
    state.clear_fault().unwrap();
    assert_eq!(state.fault, None);
    let mut state = downloaded();
    state.report_fault(fault(FaultKind::NonrecoverableSafety));
    assert_eq!(rule(state.clear_fault()), "P72");
    state.download(project(1)).unwrap();
    assert_eq!(state.fault, None);
    assert!(state.log[0].outcome.as_ref().unwrap().contains("download"));
}

/// REQ-FAULT-002
#[test]
fn safety_fault_when_overridden_then_it_is_not_cleared() {
    let mut state = downloaded();
    state.report_fault(fault(FaultKind::NonrecoverableSafety));
    state.override_fault().unwrap();
    assert!(state.overridden && state.fault.is_some());
    assert_eq!(rule(state.generate_signature([1; 32], at(1))), "P25");
    assert_eq!(rule(downloaded().override_fault()), "P70");
}

/// REQ-FAULT-003
#[test]
fn controller_fault_when_it_happens_then_the_application_is_lost_and_only_a_download_recovers() {
    let mut state = signed();
    state.lock(None).unwrap();
    state.report_fault(fault(FaultKind::NonrecoverableController));
    assert_eq!((&state.application, state.signature, state.locked), (&None, None, false));
    assert_eq!(rule(state.clear_fault()), "P71");
    assert_eq!(rule(state.change_mode(Mode::Run)), "P03");
    state.download(project(1)).unwrap();
    assert_eq!(state.fault, None);
}

/// REQ-FAULT-001. Every state that actions lead to is one that can occur.
#[test]
fn recoverable_fault_when_cleared_then_the_logic_goes_on_without_a_signature_too() {
    let mut state = downloaded();
    state.report_fault(fault(FaultKind::Recoverable));
    assert!(state.protection().impossible().is_none());
    state.clear_fault().unwrap();
    assert_eq!(state.fault, None);
}

/// REQ-FAULT-004
#[test]
fn fault_log_when_full_then_the_oldest_entry_goes() {
    let mut state = downloaded();
    for number in 0..=LOG_ENTRIES_MAX {
        state.report_fault(Fault { at_ms: number as u64, ..fault(FaultKind::Recoverable) });
    }
    assert_eq!((state.log.len(), state.log[0].fault.at_ms), (LOG_ENTRIES_MAX, 1));
}

/// What somebody may ask of a controller, refused or not.
const ACTIONS: [fn(&mut ControllerState); 22] = [
    |state| drop(state.download(project(1))),
    |state| drop(state.download(project(2))),
    |state| drop(state.change_mode(Mode::Run)),
    |state| drop(state.change_mode(Mode::Program)),
    |state| drop(state.turn_keyswitch(Keyswitch::Run)),
    |state| drop(state.turn_keyswitch(Keyswitch::Remote)),
    |state| drop(state.turn_keyswitch(Keyswitch::Program)),
    |state| drop(state.generate_signature([1; 32], at(1))),
    |state| drop(state.delete_signature()),
    |state| drop(state.lock(None)),
    |state| drop(state.unlock(None)),
    |state| drop(state.install_force(forced("Doors:I.Pt00Data"))),
    |state| drop(state.remove_force(None)),
    |state| drop(state.enable_forces(false)),
    |state| drop(state.enable_forces(true)),
    |state| drop(state.inhibit("Doors", true)),
    |state| drop(state.load_from_card(signed().store_to_card(LoadMode::RemoteRun).unwrap())),
    |state| drop(state.load_from_card(downloaded_and_locked().store_to_card(LoadMode::RemoteProgram).unwrap())),
    |state| drop(state.clear_fault()),
    |state| drop(state.override_fault()),
    // What the controller raises by itself: a fault of the safety task in Run, one of its diagnostics at any time.
    |state| {
        let faults = [fault(FaultKind::NonrecoverableSafety)];
        faults.into_iter().filter(|_| state.mode == Mode::Run).collect::<Vec<_>>().into_iter().for_each(|fault| {
            state.report_fault(fault);
        });
    },
    |state| state.report_fault(fault(FaultKind::NonrecoverableController)),
];

/// REQ-MODE-008. All states that any sequence of actions reaches, from a controller out of its box.
#[test]
fn states_when_every_sequence_of_actions_is_followed_then_none_is_reached_that_cannot_occur() {
    let mut seen = HashSet::new();
    let mut open = vec![controller()];
    while let Some(state) = open.pop() {
        assert!(state.protection().impossible().is_none(), "{:?}", state.protection());
        let next = ACTIONS.iter().map(|action| {
            let mut next = state.clone();
            action(&mut next);
            next.log.clear();
            next
        });
        open.extend(next.filter(|next| seen.insert(format!("{next:?}"))));
    }
    println!("{} states of a controller", seen.len());
    assert!(seen.len() > 100);
}
