//! POINT Guard modules. Source: 1734-UM013, chapter 5 for the menus, Tables 5 to 10 and 22 to 25 for the assemblies,
//! `Values and States of Tags` for the classes.

use super::members::*;
use super::{Module, NONE, OutputOperation, choice, choice_without_assembly};
use crate::points;

/// Eight safety inputs, four test outputs.
pub(super) static IB8S: Module = Module {
    catalog_number: "1734-IB8S",
    name: "POINT Guard safety digital input",
    input: &[CONNECTION, data(8)],
    input_status: &[
        choice("COMBINED_STATUS_MUTING", 788, 2, &[MUTING_1_3, INPUT_POWER, COMBINED_INPUT]),
        choice("NONE", 516, 1, &[]),
        choice("PT_STATUS", 548, 2, &[status(8)]),
        choice("PT_STATUS_MUTING", 820, 3, &[status(8), MUTING_1_3, INPUT_POWER]),
        choice("PT_STATUS_MUTING_TEST_OUTPUT", 868, 4, &[status(8), test_status(4), MUTING_1_3, INPUT_POWER]),
        // Not in the manual: a public export of a series B module has it, as AB:1734_IB8S_Safety6:I:0.
        choice_without_assembly("COMBINED_STATUS_POWER", &[INPUT_POWER, COMBINED_INPUT]),
    ],
    output_data: &[NONE, choice("TEST", 33, 1, &[test_data(4)])],
    points: &[&points::INPUTS_8_TESTS_4, &points::TESTS_4],
    muting_lamps: &[1, 3],
    pulsing_tests: 2,
    output_operation: OutputOperation::SingleOrDual,
};

/// Eight safety outputs.
pub(super) static OB8S: Module = Module {
    catalog_number: "1734-OB8S",
    name: "POINT Guard safety digital output",
    input: &[CONNECTION],
    input_status: &[
        choice("COMBINED_STATUS_READBACK_POWER", 1044, 2, &[readback(8), OUTPUT_POWER, COMBINED_OUTPUT]),
        NONE,
        choice("PT_STATUS", 580, 1, &[output_status(8)]),
        choice("PT_STATUS_READBACK", 1028, 2, &[output_status(8), readback(8)]),
    ],
    output_data: &[choice("SAFETY", 564, 1, &[data(8)]), NONE],
    points: &[&points::OUTPUTS_8],
    muting_lamps: &[],
    pulsing_tests: 0,
    output_operation: OutputOperation::SingleOrDual,
};

/// Four safety analog inputs. The menu is called Process Data there; here it is `InputStatus` as for the other modules.
pub(super) static IE4S: Module = Module {
    catalog_number: "1734-IE4S",
    name: "POINT Guard safety analog input",
    input: &[CONNECTION, CHANNEL_DATA],
    input_status: &[
        choice("STATUS", 402, 9, &[CHANNEL_STATUS]),
        choice("STATUS_ALARMS", 786, 13, &[CHANNEL_STATUS, CHANNEL_ALARMS]),
        choice(
            "STATUS_ALARMS_FAULTS",
            802,
            18,
            &[CHANNEL_STATUS, CHANNEL_ALARM, CHANNEL_FAULT_REASON, CHANNEL_ALARMS, INPUT_POWER],
        ),
    ],
    output_data: &[NONE, choice("SAFETY_TACHOMETER", 770, 1, &[RESET_TACHOMETER])],
    points: &[&points::ANALOG_INPUTS],
    muting_lamps: &[],
    pulsing_tests: 0,
    output_operation: OutputOperation::SingleOrDual,
};
