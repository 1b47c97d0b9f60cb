//! The state of a controller, or of a project file, as far as protection asks.

use super::action::{Action, OfferedSignature};
use crate::mode::Mode;

/// Where the safety application is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Place {
    /// In a controller.
    Online,
    /// In a project file, without a controller.
    Offline,
}

/// The switch at the front of the controller.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Keyswitch {
    /// RUN: the controller executes, and software cannot change that.
    Run,
    /// REM: software changes the mode.
    Remote,
    /// PROG: the controller does not execute, and software cannot change that.
    Program,
}

/// Forces on safety tags.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Forces {
    /// None is installed.
    None,
    /// Installed and disabled: values are the logic's.
    Disabled,
    /// Installed and enabled.
    Enabled,
}

/// Online edits of safety routines.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Edits {
    /// None.
    None,
    /// A rung has been changed and not yet accepted.
    Pending,
    /// Accepted into the controller; the original rungs execute.
    Accepted,
    /// Accepted, and the new rungs execute.
    Tested,
}

/// The state of the safety task.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SafetyTaskStatus {
    /// The controller holds no project.
    NoProject,
    /// OK.
    Ok,
    /// A recoverable fault stopped the logic, and no fault routine cleared it.
    RecoverableFault,
    /// A nonrecoverable safety fault shut the safety task down.
    NonrecoverableSafetyFault,
    /// The diagnostics of a channel failed: partnership is lost, and the application with it.
    NonrecoverableControllerFault,
}

/// What protection asks of a controller or a project file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct State {
    /// Where the application is.
    pub place: Place,
    /// The keyswitch.
    pub keyswitch: Keyswitch,
    /// The mode.
    pub mode: Mode,
    /// Whether the application is safety-locked.
    pub locked: bool,
    /// Whether a safety task signature exists.
    pub signed: bool,
    /// Forces on safety tags.
    pub forces: Forces,
    /// Online edits of safety routines.
    pub edits: Edits,
    /// The safety task.
    pub status: SafetyTaskStatus,
    /// Whether the controller has a memory card (revision 18 or later).
    pub takes_card: bool,
}

/// Why a combination cannot occur.
#[derive(Debug)]
pub struct Impossible {
    /// The reason.
    pub reason: &'static str,
    /// Where it comes from.
    pub source: &'static str,
    matches: fn(&State) -> bool,
}

const fn impossible(reason: &'static str, source: &'static str, matches: fn(&State) -> bool) -> Impossible {
    Impossible { reason, source, matches }
}

/// The combinations that cannot occur.
pub static IMPOSSIBLE: &[Impossible] = &[
    impossible(
        "a project file has no keyswitch, no mode, no fault, no online edit, no enabled force and no card",
        "1756-RM093 Chapter 6 (decided)",
        |state| {
            state.place == Place::Offline
                && (state.keyswitch != Keyswitch::Remote
                    || state.mode != Mode::Program
                    || state.status != SafetyTaskStatus::Ok
                    || state.edits != Edits::None
                    || state.forces == Forces::Enabled
                    || !state.takes_card)
        },
    ),
    impossible("the keyswitch in RUN is the mode Run", "recalled", |state| {
        state.keyswitch == Keyswitch::Run
            && state.mode == Mode::Program
            && !matches!(state.status, SafetyTaskStatus::NoProject | SafetyTaskStatus::NonrecoverableControllerFault)
    }),
    impossible("the keyswitch in PROG is the mode Program", "recalled", |state| {
        state.keyswitch == Keyswitch::Program && state.mode == Mode::Run
    }),
    impossible(
        "forces are removed before a safety task signature is generated, and none is installed while it exists",
        "1756-RM093 Table 8; Force Data",
        |state| state.signed && state.forces != Forces::None,
    ),
    impossible(
        "forces are removed before the application is locked, and none is installed while it is. Table 8 says of Run, locked, \
         without signature that existing forces are maintained; Force Data says that there are none",
        "1756-RM093 Force Data; Lock the GuardLogix Controller",
        |state| state.locked && state.forces != Forces::None,
    ),
    impossible("pending edits cannot exist while the application is locked", "1756-RM093 Online Editing", |state| {
        state.locked && state.edits == Edits::Pending
    }),
    impossible(
        "a safety task signature is generated without online edits, and none begins while it exists",
        "1756-RM093 Online Editing; of accepted edits decided: a signature is of one text",
        |state| state.signed && state.edits != Edits::None,
    ),
    impossible(
        "without an application there is nothing to run, lock, sign, force or edit",
        "1756-RM093 Nonrecoverable Controller Faults: recovery is a download (decided)",
        |state| {
            matches!(state.status, SafetyTaskStatus::NoProject | SafetyTaskStatus::NonrecoverableControllerFault)
                && (state.mode == Mode::Run
                    || state.locked
                    || state.signed
                    || state.forces != Forces::None
                    || state.edits != Edits::None)
        },
    ),
];

/// An offer that nothing can make.
static UNSIGNED_AND_SAME: Impossible = impossible(
    "the controller has no safety task signature that another could be the same as",
    "1756-RM093 Downloading the Safety Application Program",
    |state| !state.signed,
);

pub(super) fn impossible_offer(state: State, action: Action) -> Option<&'static Impossible> {
    let (Action::Download(offer) | Action::LoadFromCard(offer)) = action else { return None };
    (offer.signature == OfferedSignature::Same && (UNSIGNED_AND_SAME.matches)(&state)).then_some(&UNSIGNED_AND_SAME)
}

impl State {
    /// A controller in this mode, locked and signed or not, with nothing else that protection asks about: keyswitch in REM, no
    /// forces, no edits, safety task status OK. A row of Table 8.
    pub const fn online(mode: Mode, locked: bool, signed: bool) -> State {
        State {
            place: Place::Online,
            keyswitch: Keyswitch::Remote,
            mode,
            locked,
            signed,
            forces: Forces::None,
            edits: Edits::None,
            status: SafetyTaskStatus::Ok,
            takes_card: true,
        }
    }

    /// What the safety task reaches in this state, when everything else that the manual asks is kept (1756-RM093 Table 8).
    pub const fn integrity(&self) -> &'static str {
        match (self.mode, self.locked, self.signed) {
            (Mode::Program, _, _) => "nothing: safety logic does not execute in Program mode",
            (Mode::Run, false, false) => "development only",
            (Mode::Run, true, false) => "PLd/Cat. 3, control reliable, SIL 2",
            (Mode::Run, _, true) => "PLe/Cat. 4, control reliable, SIL 3",
        }
    }

    /// Why this state cannot occur; nothing where it can.
    pub fn impossible(&self) -> Option<&'static Impossible> {
        IMPOSSIBLE.iter().find(|one| (one.matches)(self))
    }

    /// Every combination, those that cannot occur among them.
    pub fn all() -> impl Iterator<Item = State> {
        let switches = || {
            [Keyswitch::Run, Keyswitch::Remote, Keyswitch::Program]
                .into_iter()
                .flat_map(|keyswitch| [Mode::Program, Mode::Run].into_iter().map(move |mode| (keyswitch, mode)))
        };
        let protections = || {
            [false, true].into_iter().flat_map(|locked| [false, true].into_iter().map(move |signed| (locked, signed)))
        };
        let changes = || {
            [Forces::None, Forces::Disabled, Forces::Enabled].into_iter().flat_map(|forces| {
                [Edits::None, Edits::Pending, Edits::Accepted, Edits::Tested]
                    .into_iter()
                    .map(move |edits| (forces, edits))
            })
        };
        let conditions = || {
            [
                SafetyTaskStatus::NoProject,
                SafetyTaskStatus::Ok,
                SafetyTaskStatus::RecoverableFault,
                SafetyTaskStatus::NonrecoverableSafetyFault,
                SafetyTaskStatus::NonrecoverableControllerFault,
            ]
            .into_iter()
            .flat_map(|status| {
                [Place::Online, Place::Offline]
                    .into_iter()
                    .flat_map(move |place| [true, false].into_iter().map(move |takes_card| (status, place, takes_card)))
            })
        };
        switches().flat_map(move |(keyswitch, mode)| {
            protections().flat_map(move |(locked, signed)| {
                changes().flat_map(move |(forces, edits)| {
                    conditions().map(move |(status, place, takes_card)| State {
                        place,
                        keyswitch,
                        mode,
                        locked,
                        signed,
                        forces,
                        edits,
                        status,
                        takes_card,
                    })
                })
            })
        })
    }
}
