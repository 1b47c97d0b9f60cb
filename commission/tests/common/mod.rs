//! Controllers to begin with.

use twinrung_commission::{ControllerState, Identity};

/// A 1756-L73S, as it comes out of its box.
pub fn controller() -> ControllerState {
    ControllerState::new(Identity { catalog_number: "1756-L73S".to_owned(), series: 'B', revision: 20 })
}
