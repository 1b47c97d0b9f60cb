//! The memory card: what is stored on it and loaded from it.

use serde::{Deserialize, Serialize};

use crate::identity::Identity;
use crate::password::Passwords;
use crate::record::{self, RecordError, RecordKind};
use crate::signature::SafetyTaskSignature;
use crate::state::Application;

/// The mode that the controller enters after a load.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum LoadMode {
    /// Remote Program: a person starts the machine. The manual recommends it.
    RemoteProgram,
    /// Remote Run.
    RemoteRun,
}

/// What a card holds.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Card {
    /// The controller that it was stored by.
    pub made_for: Identity,
    /// Whether the application was locked.
    pub locked: bool,
    /// The passwords for that.
    pub passwords: Passwords,
    /// The signature.
    pub signature: Option<SafetyTaskSignature>,
    /// The mode after a load.
    pub load_mode: LoadMode,
    /// The application.
    pub application: Application,
}

impl Card {
    /// Its bytes.
    ///
    /// # Errors
    ///
    /// [`RecordError::Content`].
    pub fn encode(&self) -> Result<Vec<u8>, RecordError> {
        record::encode(RecordKind::Card, 0, self, &self.application.image)
    }

    /// Reads its bytes.
    ///
    /// # Errors
    ///
    /// [`RecordError`].
    pub fn decode(bytes: &[u8]) -> Result<Card, RecordError> {
        let (_, mut card, image) = record::decode::<Card>(RecordKind::Card, bytes)?;
        card.application.image = image;
        Ok(card)
    }
}
