//! The signatures of a safety Add-On Instruction, as they are recorded and compared (1756-RM093 Appendix B, Verify Safety Add-On
//! Instruction Signatures).

use serde::{Deserialize, Serialize};

use crate::signature::{read_id, write_id};

/// A safety Add-On Instruction of an application.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct SealedInstruction {
    /// Its name.
    pub name: String,
    /// The instruction signature: what was sealed; nothing where nothing seals it.
    #[serde(with = "optional_id")]
    pub instruction: Option<[u8; 32]>,
    /// Its date and time.
    pub generated: Option<String>,
    /// The safety instruction signature: what executes.
    #[serde(serialize_with = "write_id", deserialize_with = "read_id")]
    pub safety: [u8; 32],
    /// The signature history, oldest first, a line for each entry.
    #[serde(default)]
    pub history: Vec<String>,
}

impl SealedInstruction {
    /// In what it is not as it was recorded: the three values that the manual has compared.
    pub fn differences(&self, recorded: &SealedInstruction) -> Vec<&'static str> {
        let parts = [
            (self.instruction == recorded.instruction, "the instruction signature is another"),
            (self.generated == recorded.generated, "the date and time of the instruction signature is another"),
            (self.safety == recorded.safety, "the safety instruction signature is another: it executes otherwise"),
        ];
        parts.into_iter().filter(|(same, _)| !same).map(|(_, words)| words).collect()
    }
}

/// An ID that may be missing.
mod optional_id {
    use serde::{Deserialize, Deserializer, Serialize, Serializer};

    use crate::signature::{read_id, write_id};

    #[derive(Serialize, Deserialize)]
    struct Id(#[serde(serialize_with = "write_id", deserialize_with = "read_id")] [u8; 32]);

    pub(super) fn serialize<S: Serializer>(id: &Option<[u8; 32]>, to: S) -> Result<S::Ok, S::Error> {
        id.map(Id).serialize(to)
    }

    pub(super) fn deserialize<'de, D: Deserializer<'de>>(from: D) -> Result<Option<[u8; 32]>, D::Error> {
        Ok(Option::<Id>::deserialize(from)?.map(|Id(id)| id))
    }
}
