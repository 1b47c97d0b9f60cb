//! ENPEND, Enable Pendant. `v14-and-metal-form.md` 2.

use super::circuit::circuit_instruction;
use twinrung_catalog::types::safety::version_14::ENABLE_PENDANT;

/// T_INC: a grip is squeezed slowly. 2, recalled 70 %; 500 ms is the safe fallback if it proves wrong.
const INCONSISTENT_MS: i32 = 3000;
/// The value of Channel B in its active state. 2, recalled 85 %.
const CHANNEL_B_ACTIVE: bool = true;

circuit_instruction! {
    /// Memory of an ENPEND call.
    Enpend, ENABLE_PENDANT;
    channel_b_active: CHANNEL_B_ACTIVE,
    inconsistent_ms: INCONSISTENT_MS
}
