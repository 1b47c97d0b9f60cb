//! Code numbers that more than one instruction shows. A number that belongs to one instruction stands in its file.

/// Nothing to report. dual-channel-inputs.md 1.9, recalled-high.
pub(crate) const NONE: i32 = 0;
/// Diagnostic: Reset is held ON while an edge is awaited. dual-channel-inputs.md 1.9, number recalled-high, when shown decided D17.
pub(crate) const RESET_HELD: i32 = 0x05;
/// Fault and diagnostic: Input Status lost, Input Status OFF. dual-channel-inputs.md 1.9, recalled-high.
pub(crate) const INPUT_STATUS: i32 = 0x20;
/// Fault and diagnostic: Output Status lost, Output Status OFF. muting-and-outputs.md 1.6, recalled 75 %.
pub(crate) const OUTPUT_STATUS: i32 = 0x21;
/// Diagnostic of DCSRT and THRSe: actuated but not armed, release first. dual-channel-inputs.md 1.9, decided.
pub(crate) const NOT_ARMED: i32 = 0xF130;
