//! What changes a controller: each change asks the table of protection first, and is done whole or not at all.

use std::fmt;

use jiff::Timestamp;
use twinrung_controller::Mode;
use twinrung_controller::protection::{Action, Keyswitch, OfferedSignature, Rule, judge};

use crate::card::{Card, LoadMode};
use crate::fault::{Fault, FaultKind, LOG_ENTRIES_MAX, LogEntry};
use crate::identity::Identity;
use crate::password::{self, PasswordError};
use crate::signature::SafetyTaskSignature;
use crate::state::{Application, ControllerState, Force};

/// Why a change was refused. The state is as it was.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Refused {
    /// The table of protection says so.
    Rule {
        /// What was asked for.
        action: Action,
        /// The row.
        rule: &'static Rule,
    },
    /// The password.
    Password(PasswordError),
    /// No force is installed on this tag.
    NoForce(String),
    /// The module is inhibited already, or is not.
    Module(String),
    /// The keyswitch stands there already.
    Keyswitch,
}

impl fmt::Display for Refused {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Refused::Rule { action, rule } => {
                let verb = action.verb().name();
                write!(
                    f,
                    "{} refused: {}\n  way out: {}\n  {}: {}",
                    verb, rule.reason, rule.way_out, rule.code, rule.source
                )
            }
            Refused::Password(error) => write!(f, "{error}"),
            Refused::NoForce(tag) => write!(f, "no force is installed on {tag}"),
            Refused::Module(module) => write!(f, "the connection of {module} is so already"),
            Refused::Keyswitch => f.write_str("the keyswitch stands there already"),
        }
    }
}

impl std::error::Error for Refused {}

impl From<PasswordError> for Refused {
    fn from(error: PasswordError) -> Refused {
        Refused::Password(error)
    }
}

/// A project that is offered to a controller.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Project {
    /// What it was made for.
    pub made_for: Identity,
    /// Its safety application signature.
    pub id: [u8; 32],
    /// Its name and image.
    pub application: Application,
}

/// What became of the signature in a download.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Downloaded {
    /// The project matches it: it is kept, with its date and time.
    SignatureKept(SafetyTaskSignature),
    /// The project is another one: it is deleted, and the application is to be validated again.
    SignatureDeleted(SafetyTaskSignature),
    /// There was none: the application is to be tested.
    Unsigned,
}

impl ControllerState {
    /// Whether an action is permitted now.
    ///
    /// # Errors
    ///
    /// [`Refused::Rule`].
    pub fn permit(&self, action: Action) -> Result<(), Refused> {
        judge(self.protection(), action).map_err(|rule| Refused::Rule { action, rule })
    }

    /// Changes the mode by software.
    ///
    /// # Errors
    ///
    /// As the table says.
    pub fn change_mode(&mut self, mode: Mode) -> Result<(), Refused> {
        self.permit(Action::ChangeMode(mode))?;
        self.mode = mode;
        Ok(())
    }

    /// Turns the keyswitch: RUN and PROG bring their mode with them. Nobody is asked; it takes the key.
    ///
    /// # Errors
    ///
    /// [`Refused::Keyswitch`] where it stands there; RUN as software's change to Run where there is no application.
    pub fn turn_keyswitch(&mut self, keyswitch: Keyswitch) -> Result<(), Refused> {
        if self.keyswitch == keyswitch {
            return Err(Refused::Keyswitch);
        }
        self.keyswitch = keyswitch;
        self.mode = match keyswitch {
            Keyswitch::Run if self.application.is_some() => Mode::Run,
            Keyswitch::Run | Keyswitch::Program => Mode::Program,
            Keyswitch::Remote => self.mode,
        };
        Ok(())
    }

    /// What an ID is beside the controller's signature.
    fn beside_own(&self, id: Option<[u8; 32]>) -> OfferedSignature {
        match (id, self.signature) {
            (None, _) => OfferedSignature::Without,
            (Some(id), Some(own)) if id == own.id => OfferedSignature::Same,
            (Some(_), _) => OfferedSignature::Other,
        }
    }

    /// Downloads a project. The controller's signature stays where the project gives the same ID, and is deleted where it
    /// gives another. Lock and passwords stay as they are; forces, inhibited modules and the fault do not.
    ///
    /// # Errors
    ///
    /// As the table says.
    pub fn download(&mut self, project: Project) -> Result<Downloaded, Refused> {
        let signature = self.beside_own(Some(project.id));
        self.permit(Action::Download(self.identity.offer(&project.made_for, signature)))?;
        let before = self.signature;
        self.take(project.application);
        Ok(match before {
            Some(kept) if kept.id == project.id => {
                self.signature = Some(kept);
                Downloaded::SignatureKept(kept)
            }
            Some(deleted) => Downloaded::SignatureDeleted(deleted),
            None => Downloaded::Unsigned,
        })
    }

    fn take(&mut self, application: Application) {
        self.application = Some(application);
        self.signature = None;
        self.forces.clear();
        self.forces_enabled = false;
        self.edit = None;
        self.inhibited.clear();
        self.settle("safety memory was reinitialized by a download");
    }

    /// Generates the safety task signature: `id` is that of the application in the controller.
    ///
    /// # Errors
    ///
    /// As the table says.
    pub fn generate_signature(&mut self, id: [u8; 32], now: Timestamp) -> Result<SafetyTaskSignature, Refused> {
        self.permit(Action::GenerateSignature)?;
        let signature = SafetyTaskSignature { id, generated: now };
        self.signature = Some(signature);
        Ok(signature)
    }

    /// Deletes the safety task signature.
    ///
    /// # Errors
    ///
    /// As the table says.
    pub fn delete_signature(&mut self) -> Result<(), Refused> {
        self.permit(Action::DeleteSignature)?;
        self.signature = None;
        Ok(())
    }

    /// Safety-locks the application.
    ///
    /// # Errors
    ///
    /// As the table says; the lock password, where one is set.
    pub fn lock(&mut self, given: Option<&[u8]>) -> Result<(), Refused> {
        self.permit(Action::Lock)?;
        password::check(self.passwords.lock.as_ref(), given)?;
        self.locked = true;
        Ok(())
    }

    /// Safety-unlocks the application.
    ///
    /// # Errors
    ///
    /// As the table says; the unlock password, where one is set.
    pub fn unlock(&mut self, given: Option<&[u8]>) -> Result<(), Refused> {
        self.permit(Action::Unlock)?;
        password::check(self.passwords.unlock.as_ref(), given)?;
        self.locked = false;
        Ok(())
    }

    /// Sets the lock password, or the unlock password; `None` removes it. The one that is set must be given.
    ///
    /// # Errors
    ///
    /// The passwords.
    pub fn set_password(&mut self, of_lock: bool, old: Option<&[u8]>, new: Option<&[u8]>) -> Result<(), Refused> {
        let slot = if of_lock { &mut self.passwords.lock } else { &mut self.passwords.unlock };
        password::check(slot.as_ref(), old)?;
        *slot = new.map(password::hash).transpose()?;
        Ok(())
    }

    /// Installs a force and enables forces. Another one on the same value goes.
    ///
    /// # Errors
    ///
    /// As the table says.
    pub fn install_force(&mut self, force: Force) -> Result<(), Refused> {
        self.permit(Action::InstallForce)?;
        self.forces.retain(|one| !one.tag.eq_ignore_ascii_case(&force.tag));
        self.forces.push(force);
        self.forces_enabled = true;
        Ok(())
    }

    /// Removes the force on a value, or all of them.
    ///
    /// # Errors
    ///
    /// As the table says; [`Refused::NoForce`].
    pub fn remove_force(&mut self, tag: Option<&str>) -> Result<(), Refused> {
        self.permit(Action::RemoveForce)?;
        let before = self.forces.len();
        self.forces.retain(|one| tag.is_some_and(|tag| !one.tag.eq_ignore_ascii_case(tag)));
        match tag {
            Some(tag) if self.forces.len() == before => Err(Refused::NoForce(tag.to_owned())),
            _ => {
                self.forces_enabled &= !self.forces.is_empty();
                Ok(())
            }
        }
    }

    /// Enables or disables the installed forces.
    ///
    /// # Errors
    ///
    /// As the table says.
    pub fn enable_forces(&mut self, enabled: bool) -> Result<(), Refused> {
        self.permit(if enabled { Action::EnableForces } else { Action::DisableForces })?;
        self.forces_enabled = enabled;
        Ok(())
    }

    /// Inhibits the connection of a module, or ends that.
    ///
    /// # Errors
    ///
    /// As the table says; [`Refused::Module`].
    pub fn inhibit(&mut self, module: &str, inhibited: bool) -> Result<(), Refused> {
        self.permit(if inhibited { Action::InhibitModule } else { Action::UninhibitModule })?;
        let place = self.inhibited.iter().position(|one| one.eq_ignore_ascii_case(module));
        match (place, inhibited) {
            (None, true) => self.inhibited.push(module.to_owned()),
            (Some(at), false) => drop(self.inhibited.remove(at)),
            _ => return Err(Refused::Module(module.to_owned())),
        }
        Ok(())
    }

    /// What the memory card is to hold.
    ///
    /// # Errors
    ///
    /// As the table says.
    pub fn store_to_card(&self, load_mode: LoadMode) -> Result<Card, Refused> {
        self.permit(Action::StoreToCard)?;
        let application = self.application.clone().unwrap_or(Application {
            name: String::new(),
            image: Vec::new(),
            instructions: Vec::new(),
            from_image: false,
        });
        Ok(Card {
            made_for: self.identity.clone(),
            locked: self.locked,
            passwords: self.passwords.clone(),
            signature: self.signature,
            load_mode,
            application,
        })
    }

    /// Loads what a card holds. An unlocked controller takes lock, passwords and signature from the card; a locked one takes
    /// only what has its own signature, so that these stay.
    ///
    /// # Errors
    ///
    /// As the table says.
    pub fn load_from_card(&mut self, card: Card) -> Result<(), Refused> {
        let signature = self.beside_own(card.signature.map(|signature| signature.id));
        self.permit(Action::LoadFromCard(self.identity.offer(&card.made_for, signature)))?;
        let own = (self.locked, self.passwords.clone(), self.signature);
        let (locked, passwords, signature) =
            if self.locked { own } else { (card.locked, card.passwords, card.signature) };
        self.take(card.application);
        self.locked = locked;
        self.passwords = passwords;
        self.signature = signature;
        self.mode = match (self.keyswitch, card.load_mode) {
            (Keyswitch::Run, _) | (Keyswitch::Remote, LoadMode::RemoteRun) => Mode::Run,
            _ => Mode::Program,
        };
        Ok(())
    }

    /// A fault happened: it is logged, and the safety task has it. A nonrecoverable controller fault loses the application.
    pub fn report_fault(&mut self, fault: Fault) {
        if self.log.len() >= LOG_ENTRIES_MAX {
            self.log.remove(0);
        }
        self.log.push(LogEntry { fault: fault.clone(), outcome: None });
        if fault.kind == FaultKind::NonrecoverableController {
            self.application = None;
            self.signature = None;
            self.locked = false;
            self.forces.clear();
            self.forces_enabled = false;
            self.edit = None;
            self.inhibited.clear();
            self.mode = Mode::Program;
        }
        self.fault = Some(fault);
        self.overridden = false;
    }

    /// Clears the fault. After a nonrecoverable safety fault safety memory is reinitialized from the application that the
    /// signature names.
    ///
    /// # Errors
    ///
    /// As the table says.
    pub fn clear_fault(&mut self) -> Result<(), Refused> {
        self.permit(Action::ClearFault)?;
        let of_safety = self.fault.as_ref().is_some_and(|fault| fault.kind == FaultKind::NonrecoverableSafety);
        self.settle(if of_safety {
            "cleared; safety memory was reinitialized from the safety task signature"
        } else {
            "cleared; safety connections were closed and opened again"
        });
        Ok(())
    }

    /// Overrides the fault: its log entry is cleared and standard tasks go on. The safety task stays as it is.
    ///
    /// # Errors
    ///
    /// As the table says.
    pub fn override_fault(&mut self) -> Result<(), Refused> {
        self.permit(Action::OverrideFault)?;
        self.overridden = true;
        self.note("overridden, not cleared: standard tasks go on");
        Ok(())
    }

    fn settle(&mut self, outcome: &str) {
        if self.fault.is_some() {
            self.note(outcome);
        }
        self.fault = None;
        self.overridden = false;
    }

    fn note(&mut self, outcome: &str) {
        if let Some(entry) = self.log.last_mut() {
            entry.outcome = Some(outcome.to_owned());
        }
    }
}
