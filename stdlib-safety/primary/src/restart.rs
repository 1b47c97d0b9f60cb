//! Automatic restart.

/// An automatic restart energizes the output when every enabling condition has held this long without a break.
/// dual-channel-inputs.md 1.4 (recalled-medium), muting-and-outputs.md 1.5 (recalled 80 %).
pub(crate) const AUTOMATIC_RESTART_MS: i32 = 50;
