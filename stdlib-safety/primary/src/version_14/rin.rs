//! RIN, Redundant Input: two normally open channels. `v14-and-metal-form.md` 2.

use super::circuit::circuit_instruction;
use twinrung_catalog::types::safety::version_14::REDUNDANT_INPUT;

/// T_INC. 2, recalled 90 %.
const INCONSISTENT_MS: i32 = 500;
/// The value of Channel B in its active state. 2, H-RIN.
const CHANNEL_B_ACTIVE: bool = true;

circuit_instruction! {
    /// Memory of a RIN call.
    Rin, REDUNDANT_INPUT;
    channel_b_active: CHANNEL_B_ACTIVE,
    inconsistent_ms: INCONSISTENT_MS
}
