//! Which controller this is.

use serde::{Deserialize, Serialize};
use twinrung_controller::protection::{Offer, OfferedSignature};

/// The first major revision whose controllers have a memory card (1756-RM093 Storing and Loading a Project from Nonvolatile
/// Memory).
pub const FIRST_REVISION_WITH_CARD: u16 = 18;

/// The hardware and its operating system, or what a project was made for.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Identity {
    /// Catalogue number.
    pub catalog_number: String,
    /// Series of the hardware, `A` to `Z`.
    pub series: char,
    /// Major revision of the operating system.
    pub revision: u16,
}

impl Identity {
    /// Whether it has a memory card.
    pub const fn takes_card(&self) -> bool {
        self.revision >= FIRST_REVISION_WITH_CARD
    }

    /// What a project for `other` with this signature is to this controller.
    pub fn offer(&self, other: &Identity, signature: OfferedSignature) -> Offer {
        Offer {
            signature,
            same_type: self.catalog_number.eq_ignore_ascii_case(&other.catalog_number),
            same_revision: self.revision == other.revision,
            same_series: self.series.eq_ignore_ascii_case(&other.series),
        }
    }
}

impl std::fmt::Display for Identity {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} series {}, revision {}", self.catalog_number, self.series, self.revision)
    }
}
