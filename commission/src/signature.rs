//! The safety task signature: ID, date and time.

use std::fmt;

use jiff::Timestamp;
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use twinrung_bytecode::signature::{long_form, of_long_form, short_form};

/// The safety task signature (1756-RM093 Generate the Safety Task Signature). Its ID is the safety application signature: it
/// covers logic, data and configuration, and is the same wherever the same application is built.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub struct SafetyTaskSignature {
    /// The ID.
    #[serde(serialize_with = "write_id", deserialize_with = "read_id")]
    pub id: [u8; 32],
    /// When it was generated.
    pub generated: Timestamp,
}

impl fmt::Display for SafetyTaskSignature {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}  {}", short_form(&self.id), self.generated)
    }
}

pub(crate) fn write_id<S: Serializer>(id: &[u8; 32], to: S) -> Result<S::Ok, S::Error> {
    to.serialize_str(&long_form(id))
}

pub(crate) fn read_id<'de, D: Deserializer<'de>>(from: D) -> Result<[u8; 32], D::Error> {
    let text = String::deserialize(from)?;
    of_long_form(&text).ok_or_else(|| serde::de::Error::custom("an ID has 64 hexadecimal digits"))
}
