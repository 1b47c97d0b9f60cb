//! How the controller's own words are written in a record.

use serde::{Deserialize, Serialize};
use twinrung_controller::Mode;
use twinrung_controller::protection::Keyswitch;

/// A keyswitch.
#[derive(Serialize, Deserialize)]
#[serde(remote = "Keyswitch", rename_all = "lowercase")]
pub(crate) enum KeyswitchWord {
    Run,
    Remote,
    Program,
}

/// A mode.
#[derive(Serialize, Deserialize)]
#[serde(remote = "Mode", rename_all = "lowercase")]
pub(crate) enum ModeWord {
    Program,
    Run,
}
