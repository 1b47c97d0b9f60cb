//! ESTOP, Emergency Stop. `v14-and-metal-form.md` 2.

use super::circuit::circuit_instruction;
use twinrung_catalog::types::safety::version_14::EMERGENCY_STOP;

/// T_INC. 2, recalled 90 %.
const INCONSISTENT_MS: i32 = 500;
/// The value of Channel B in its active state: closed contacts. 2, recalled 95 %.
const CHANNEL_B_ACTIVE: bool = true;

circuit_instruction! {
    /// Memory of an ESTOP call.
    Estop, EMERGENCY_STOP;
    channel_b_active: CHANNEL_B_ACTIVE,
    inconsistent_ms: INCONSISTENT_MS
}
