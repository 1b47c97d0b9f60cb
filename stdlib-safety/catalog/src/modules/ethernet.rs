//! Guard I/O on EtherNet/IP. Source: 1791ES-UM001 (November 2016): Module Definition for the menus and tag names,
//! Table 22 for the classes, Tables 42 to 60 for the assemblies, Table 69 for the muting lamps. The menus Input Data
//! (Safety, Safety - Readback) and Input Status are one list here, since each pair of choices has one assembly. Defaults
//! are the manual's: no status, safety outputs. What the catalogue number says of the points, the manual's Table 6 confirms.

use super::members::*;
use super::{ConnectionChoice, Module, ModuleMember, NONE, OutputOperation, choice};
use crate::points::{self, Points};

/// Input connections of a module with 8 inputs, 8 outputs and 8 test outputs. For the 1791ES-IB8XOBV4 the manual's Table 42
/// has 820 with `PT_STATUS_MUTING`, whose layout lacks the output status that its picture of the tag shows; 836, which has
/// it and stands in the tables of the other two modules, is taken for all three (decided).
const INPUTS_8_OUTPUTS_8: &[ConnectionChoice] = &[
    choice("NONE", 516, 1, &[]),
    choice("PT_STATUS_MUTING", 836, 4, &[input_status(8), output_status(8), MUTING_3_7, OUTPUT_POWER, INPUT_POWER]),
    choice("COMBINED_STATUS_MUTING", 804, 2, &[MUTING_3_7, OUTPUT_POWER, INPUT_POWER, COMBINED_OUTPUT, COMBINED_INPUT]),
    choice(
        "READBACK_PT_STATUS_MUTING",
        852,
        5,
        &[input_status(8), output_status(8), readback(8), MUTING_3_7, OUTPUT_POWER, INPUT_POWER],
    ),
    choice(
        "READBACK_PT_STATUS_MUTING_TEST_OUTPUT",
        884,
        6,
        &[input_status(8), output_status(8), readback(8), test_status(8), MUTING_3_7, OUTPUT_POWER, INPUT_POWER],
    ),
];

/// Output connections of the same modules.
const OUTPUTS_8_TESTS_8: &[ConnectionChoice] = &[
    choice("SAFETY", 564, 1, &[data(8)]),
    choice("TEST", 34, 1, &[test_data(8)]),
    choice("COMBINED", 708, 2, &[data(8), test_data(8)]),
    NONE,
];

const INPUTS_12_OUTPUTS_4: &[ConnectionChoice] = &[
    choice("NONE", 524, 2, &[]),
    choice("PT_STATUS_MUTING", 844, 5, &[input_status(12), output_status(4), MUTING_3_7_11, OUTPUT_POWER, INPUT_POWER]),
    choice(
        "COMBINED_STATUS_MUTING",
        812,
        3,
        &[MUTING_3_7_11, OUTPUT_POWER, INPUT_POWER, COMBINED_OUTPUT, COMBINED_INPUT],
    ),
    choice(
        "READBACK_PT_STATUS_MUTING",
        860,
        5,
        &[input_status(12), output_status(4), readback(4), MUTING_3_7_11, OUTPUT_POWER, INPUT_POWER],
    ),
    choice(
        "READBACK_PT_STATUS_MUTING_TEST_OUTPUT",
        892,
        7,
        &[input_status(12), output_status(4), readback(4), test_status(12), MUTING_3_7_11, OUTPUT_POWER, INPUT_POWER],
    ),
];

const OUTPUTS_4_TESTS_12: &[ConnectionChoice] = &[
    choice("SAFETY", 563, 1, &[data(4)]),
    choice("TEST", 37, 2, &[test_data(12)]),
    choice("COMBINED", 964, 2, &[data(4), test_data(12)]),
    NONE,
];

const INPUT_8: &[&[ModuleMember]] = &[CONNECTION, data(8)];
const INPUT_12: &[&[ModuleMember]] = &[CONNECTION, data(12)];
const POINTS_8: &[&Points] = &[&points::INPUTS_8_TESTS_8, &points::TESTS_8, &points::OUTPUTS_8];
const POINTS_12: &[&Points] = &[&points::INPUTS_12_TESTS_12, &points::TESTS_12, &points::OUTPUTS_4];

/// A module with eight inputs, eight test outputs and eight outputs.
pub(super) const fn module_8(
    catalog_number: &'static str,
    name: &'static str,
    output_operation: OutputOperation,
) -> Module {
    Module {
        catalog_number,
        name,
        input: INPUT_8,
        input_status: INPUTS_8_OUTPUTS_8,
        output_data: OUTPUTS_8_TESTS_8,
        points: POINTS_8,
        muting_lamps: &[3, 7],
        pulsing_tests: 0,
        output_operation,
    }
}

const fn module_12(catalog_number: &'static str, name: &'static str, output_operation: OutputOperation) -> Module {
    Module {
        catalog_number,
        name,
        input: INPUT_12,
        input_status: INPUTS_12_OUTPUTS_4,
        output_data: OUTPUTS_4_TESTS_12,
        points: POINTS_12,
        muting_lamps: &[3, 7, 11],
        pulsing_tests: 0,
        output_operation,
    }
}

const COMPACT: &str = "CompactBlock Guard I/O, EtherNet/IP";
const ARMOR: &str = "ArmorBlock Guard I/O, EtherNet/IP";

/// Eight inputs, four bipolar output pairs.
pub(super) static ES_1791_IB8XOBV4: Module = module_8("1791ES-IB8XOBV4", COMPACT, OutputOperation::PairsOnly);
/// Eight inputs, four bipolar output pairs.
pub(super) static ES_1732_IB8XOBV4: Module = module_8("1732ES-IB8XOBV4", ARMOR, OutputOperation::PairsOnly);
/// Eight inputs, eight sourcing outputs.
pub(super) static ES_1732_IB8XOB8: Module = module_8("1732ES-IB8XOB8", ARMOR, OutputOperation::SingleOrDual);
/// Twelve inputs, four sourcing outputs.
pub(super) static ES_1732_IB12XOB4: Module = module_12("1732ES-IB12XOB4", ARMOR, OutputOperation::SingleOrDual);
/// Twelve inputs, two bipolar output pairs.
pub(super) static ES_1732_IB12XOBV2: Module = module_12("1732ES-IB12XOBV2", ARMOR, OutputOperation::PairsOnly);
