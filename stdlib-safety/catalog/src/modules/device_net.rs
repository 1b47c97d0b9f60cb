//! Guard I/O on DeviceNet. Of 1791DS-UM001 two pages could be had: 70 (classes of the tags, lamps on T3, T7, T11, T15) and
//! 148 (tag names and four test outputs of IB12, IB8XOB8 and IB4XOW4). Its menus and most assemblies are not known: what a
//! choice adds is put together here from those names (decided), and instances are left open except those that IASIMP-QS005
//! Table 9 names. The two modules with bipolar outputs have the largest assembly of their EtherNet/IP counterparts
//! (884, IASIMP-QS005 Table 9), so they are taken to have all others of them too (decided). Of the 1791DS-IB4XOX4 nothing
//! but the catalogue number is known: it has no tags here.

use super::ethernet::module_8;
use super::members::*;
use super::{ConnectionChoice, Module, NONE, OutputOperation, choice_without_assembly};
use crate::points::{self, Points};

const COMPACT: &str = "CompactBlock Guard I/O, DeviceNet";
const ARMOR: &str = "ArmorBlock Guard I/O, DeviceNet";

const fn module(
    catalog_number: &'static str,
    input: &'static [&'static [super::ModuleMember]],
    input_status: &'static [ConnectionChoice],
    output_data: &'static [ConnectionChoice],
    points: &'static [&'static Points],
) -> Module {
    Module {
        catalog_number,
        name: COMPACT,
        input,
        input_status,
        output_data,
        points,
        muting_lamps: &[3],
        pulsing_tests: 0,
        output_operation: OutputOperation::PairsForSafety,
    }
}

/// Twelve inputs, four test outputs.
pub(super) static DS_1791_IB12: Module = module(
    "1791DS-IB12",
    &[CONNECTION, data(12)],
    &[NONE, choice_without_assembly("PT_STATUS", &[input_status(12)])],
    &[NONE, choice_without_assembly("TEST", &[test_data(4)])],
    &[&points::INPUTS_12_TESTS_4, &points::TESTS_4],
);

/// Eight inputs, four test outputs, eight sourcing outputs.
pub(super) static DS_1791_IB8XOB8: Module = module(
    "1791DS-IB8XOB8",
    &[CONNECTION, data(8)],
    &[
        NONE,
        choice_without_assembly("PT_STATUS", &[input_status(8), output_status(8)]),
        choice_without_assembly("READBACK_PT_STATUS", &[input_status(8), output_status(8), readback(8)]),
    ],
    &[
        choice_without_assembly("SAFETY", &[data(8)]),
        choice_without_assembly("TEST", &[test_data(4)]),
        choice_without_assembly("COMBINED", &[data(8), test_data(4)]),
        NONE,
    ],
    &[&points::INPUTS_8_TESTS_4, &points::TESTS_4, &points::OUTPUTS_8],
);

/// Four inputs, four test outputs, four relay outputs.
pub(super) static DS_1791_IB4XOW4: Module = module(
    "1791DS-IB4XOW4",
    &[CONNECTION, data(4)],
    &[
        NONE,
        choice_without_assembly("PT_STATUS", &[input_status(4), output_status(4)]),
        choice_without_assembly("READBACK_PT_STATUS", &[input_status(4), output_status(4), readback(4)]),
    ],
    &[
        choice_without_assembly("SAFETY", &[data(4)]),
        choice_without_assembly("TEST", &[test_data(4)]),
        choice_without_assembly("COMBINED", &[data(4), test_data(4)]),
        NONE,
    ],
    &[&points::INPUTS_4_TESTS_4, &points::TESTS_4, &points::OUTPUTS_4],
);

/// Named in a reliability example of 1756-RM093 only. Test outputs decided: those of the other modules of its kind.
/// Appendix G has no word on its outputs.
pub(super) static DS_1791_IB4XOX4: Module = Module {
    output_operation: OutputOperation::SingleOrDual,
    ..module("1791DS-IB4XOX4", &[], &[], &[], &[&points::INPUTS_4_TESTS_4, &points::TESTS_4, &points::OUTPUTS_4])
};

/// Eight inputs, four bipolar output pairs.
pub(super) static DS_1791_IB8XOBV4: Module = module_8("1791DS-IB8XOBV4", COMPACT, OutputOperation::PairsOnly);
/// Eight inputs, four bipolar output pairs.
pub(super) static DS_1732_IB8XOBV4: Module = module_8("1732DS-IB8XOBV4", ARMOR, OutputOperation::PairsOnly);
