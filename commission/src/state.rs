//! What a controller holds.

use serde::{Deserialize, Serialize};
use twinrung_controller::Mode;
use twinrung_controller::protection::{Edits, Forces, Keyswitch, Place, SafetyTaskStatus, State};

use crate::edit::OnlineEdit;
use crate::fault::{Fault, LogEntry};
use crate::identity::Identity;
use crate::instruction::SealedInstruction;
use crate::password::Passwords;
use crate::signature::SafetyTaskSignature;
use crate::words::{KeyswitchWord, ModeWord};

/// What was downloaded, beside its image.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Application {
    /// The project's name.
    pub name: String,
    /// The sealed image.
    #[serde(skip)]
    pub image: Vec<u8>,
    /// Its safety Add-On Instructions: their safety instruction signatures are generated when they are downloaded.
    #[serde(default)]
    pub instructions: Vec<SealedInstruction>,
    /// Whether it came as an image: that has no text, so that nobody knows whether its Add-On Instructions were sealed.
    #[serde(default)]
    pub from_image: bool,
}

/// A force on a value of an I/O, produced or consumed safety tag.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Force {
    /// The value's full name.
    pub tag: String,
    /// What it is held at, as text.
    pub value: String,
}

/// A controller between two commands.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct ControllerState {
    /// Which controller it is.
    pub identity: Identity,
    /// The keyswitch.
    #[serde(with = "KeyswitchWord")]
    pub keyswitch: Keyswitch,
    /// The mode.
    #[serde(with = "ModeWord")]
    pub mode: Mode,
    /// Whether the application is safety-locked.
    pub locked: bool,
    /// The passwords for that.
    pub passwords: Passwords,
    /// What was downloaded.
    pub application: Option<Application>,
    /// The safety task signature.
    pub signature: Option<SafetyTaskSignature>,
    /// The installed forces.
    pub forces: Vec<Force>,
    /// Whether they are enabled.
    pub forces_enabled: bool,
    /// The online edit of safety routines.
    #[serde(default)]
    pub edit: Option<OnlineEdit>,
    /// Modules whose connection is inhibited.
    pub inhibited: Vec<String>,
    /// The fault of the safety task.
    pub fault: Option<Fault>,
    /// Whether that was overridden: standard tasks go on, the fault stays.
    pub overridden: bool,
    /// The fault log, oldest first.
    pub log: Vec<LogEntry>,
}

impl ControllerState {
    /// A controller as it comes out of its box: keyswitch in REM, Program mode, unlocked, empty.
    pub fn new(identity: Identity) -> ControllerState {
        ControllerState {
            identity,
            keyswitch: Keyswitch::Remote,
            mode: Mode::Program,
            locked: false,
            passwords: Passwords::default(),
            application: None,
            signature: None,
            forces: Vec::new(),
            forces_enabled: false,
            edit: None,
            inhibited: Vec::new(),
            fault: None,
            overridden: false,
            log: Vec::new(),
        }
    }

    /// The status of the safety task.
    pub fn status(&self) -> SafetyTaskStatus {
        match (&self.fault, &self.application) {
            (Some(fault), _) => fault.kind.status(),
            (None, None) => SafetyTaskStatus::NoProject,
            (None, Some(_)) => SafetyTaskStatus::Ok,
        }
    }

    /// What protection asks.
    pub fn protection(&self) -> State {
        State {
            place: Place::Online,
            keyswitch: self.keyswitch,
            mode: self.mode,
            locked: self.locked,
            signed: self.signature.is_some(),
            forces: match (self.forces.is_empty(), self.forces_enabled) {
                (true, _) => Forces::None,
                (false, false) => Forces::Disabled,
                (false, true) => Forces::Enabled,
            },
            edits: self.edit.as_ref().map_or(Edits::None, |edit| edit.stage.edits()),
            status: self.status(),
            takes_card: self.identity.takes_card(),
        }
    }
}
