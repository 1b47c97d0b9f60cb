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
    &safety::analog::DCA_INPUT,
    &safety::analog::DCAF_INPUT,
    &safety::dual_channel::DCI_STOP,
    &safety::dual_channel::DCI_STOP_TEST,
    &safety::dual_channel::DCI_STOP_TEST_LOCK,
    &safety::dual_channel::DCI_STOP_TEST_MUTE,
    &safety::dual_channel::DCI_MONITOR,
    &safety::dual_channel::DCI_START,
    &safety::dual_channel::SAFETY_MAT,
    &safety::dual_channel::THRS_ENHANCED,
    &safety::muting::MUTING_TWO_SENSOR_ASYM,
    &safety::muting::MUTING_TWO_SENSOR_SYM,
    &safety::muting::MUTING_FOUR_SENSOR_BIDIR,
    &safety::output::CONFIGURABLE_ROUT,
    &safety::output::REDUNDANT_OUTPUT,
    &safety::press::EIGHT_POS_MODE_SELECTOR,
    &safety::press::CB_CRANKSHAFT_POS_MONITOR,
    &safety::press::CAMSHAFT_MONITOR,
    &safety::press::AUX_VALVE_CONTROL,
    &safety::press::MAIN_VALVE_CONTROL,
    &safety::press::MANUAL_VALVE_CONTROL,
    &safety::press::CB_INCH_MODE,
    &safety::press::CB_SINGLE_STROKE_MODE,
    &safety::press::CB_CONTINUOUS_MODE,
    &safety::version_14::DIVERSE_INPUT,
    &safety::version_14::REDUNDANT_INPUT,
    &safety::version_14::ENABLE_PENDANT,
    &safety::version_14::EMERGENCY_STOP,
    &safety::version_14::LIGHT_CURTAIN,
    &safety::version_14::FIVE_POS_MODE_SELECTOR,
    &safety::version_14::TWO_HAND_RUN_STATION,
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
