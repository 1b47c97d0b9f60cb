//! DIN, Diverse Input: one normally open and one normally closed channel. `v14-and-metal-form.md` 2.

use super::circuit::circuit_instruction;
use twinrung_catalog::types::safety::version_14::DIVERSE_INPUT;

/// T_INC. 2, recalled 90 %.
const INCONSISTENT_MS: i32 = 500;
/// The value of Channel B in its active state: normally closed. 2, H-DIN.
const CHANNEL_B_ACTIVE: bool = false;

circuit_instruction! {
    /// Memory of a DIN call.
    Din, DIVERSE_INPUT;
    channel_b_active: CHANNEL_B_ACTIVE,
    inconsistent_ms: INCONSISTENT_MS
}
