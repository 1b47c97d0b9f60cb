//! All predefined structures.

pub mod base;
pub mod safety;

use crate::predefined::PredefinedType;

/// Every predefined structure that a safety tag may have and whose layout is known here.
pub static ALL: &[&PredefinedType] = &[
    &base::TIMER,
    &base::COUNTER,
    &base::CONTROL,
    &base::CONNECTION_STATUS,
    &base::STRING,
    &safety::dual_channel::DCI_STOP,
    &safety::output::CONFIGURABLE_ROUT,
];

/// Types that Table 7 of 1756-RM093 lists as valid for safety tags but that no admitted instruction uses: a tag may
/// have them, its data is opaque to safety logic.
pub static LISTED_WITHOUT_LAYOUT: &[&str] = &[
    "CAM_PROFILE",
    "EXT_ROUTINE_CONTROL",
    "EXT_ROUTINE_PARAMETERS",
    "FBD_BIT_FIELD_DISTRIBUTE",
    "FBD_CONVERT",
    "FBD_COUNTER",
    "FBD_LOGICAL",
    "FBD_MASK_EQUAL",
    "FBD_MASKED_MOVE",
    "FBD_TIMER",
    "MOTION_INSTRUCTION",
    "PHASE",
    "PHASE_INSTRUCTION",
    "SERIAL_PORT_CONTROL",
    "SFC_ACTION",
    "SFC_STEP",
    "SFC_STOP",
];
