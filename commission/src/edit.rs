//! Online edits of safety routines: what was changed, and how far it has come (1756-RM093 Online Editing).

use serde::{Deserialize, Deserializer, Serialize, Serializer};
use twinrung_bytecode::signature::{bytes_of, long_form};
use twinrung_controller::protection::Edits;

/// What the manual adds to the watchdog while the application is unlocked and without signature, in ms: for so long can a write by
/// communication hold the safety task off (1756-RM093F p. 49).
pub const HOLD_OFF_MS: u32 = 2;

/// How far an online edit has come.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Stage {
    /// Changed, and not yet accepted: the controller does not have it.
    Pending,
    /// In the controller; the original rungs execute.
    Accepted,
    /// In the controller; the changed rungs execute.
    Tested,
}

impl Stage {
    /// As protection calls it.
    pub const fn edits(self) -> Edits {
        match self {
            Stage::Pending => Edits::Pending,
            Stage::Accepted => Edits::Accepted,
            Stage::Tested => Edits::Tested,
        }
    }

    /// In words.
    pub const fn words(self) -> &'static str {
        match self {
            Stage::Pending => "pending: the controller does not have it yet",
            Stage::Accepted => "accepted: the original rungs execute",
            Stage::Tested => "tested: the changed rungs execute",
        }
    }
}

/// An online edit.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct OnlineEdit {
    /// How far it has come.
    pub stage: Stage,
    /// The routines that it changes: `Program/Routine`.
    pub routines: Vec<String>,
    /// The application with the changed rungs, as a sealed image.
    #[serde(serialize_with = "write_bytes", deserialize_with = "read_bytes")]
    pub image: Vec<u8>,
    /// An image with both versions, of which a switch chooses one: what executes once the edit is accepted.
    #[serde(serialize_with = "write_bytes", deserialize_with = "read_bytes")]
    pub both: Vec<u8>,
}

fn write_bytes<S: Serializer>(bytes: &[u8], to: S) -> Result<S::Ok, S::Error> {
    to.serialize_str(&long_form(bytes))
}

fn read_bytes<'de, D: Deserializer<'de>>(from: D) -> Result<Vec<u8>, D::Error> {
    let text = String::deserialize(from)?;
    let bytes = bytes_of(&text);
    bytes.ok_or_else(|| serde::de::Error::custom("an image is written in pairs of hexadecimal digits"))
}
