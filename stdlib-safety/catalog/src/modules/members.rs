//! Members of module tags by the words that the programming software gives them, and the groups that connection choices
//! are made of. Point numbers have two digits, channel numbers one.

use super::ModuleMember;
use super::{analog, connection, safety, small, standard};

/// `RunMode` and `ConnectionFaulted`: every safety connection brings them.
pub(super) const CONNECTION: &[ModuleMember] = &[connection("RunMode"), connection("ConnectionFaulted")];
/// Field power of the inputs. It is marked STANDARD in every module manual.
pub(super) const INPUT_POWER: &[ModuleMember] = &[standard("InputPowerStatus")];
/// Field power of the outputs.
pub(super) const OUTPUT_POWER: &[ModuleMember] = &[standard("OutputPowerStatus")];
/// One status for all inputs.
pub(super) const COMBINED_INPUT: &[ModuleMember] = &[safety("CombinedInputStatus")];
/// One status for all outputs.
pub(super) const COMBINED_OUTPUT: &[ModuleMember] = &[safety("CombinedOutputStatus")];

/// States of points.
const POINT_DATA: &[ModuleMember] = &[
    safety("Pt00Data"),
    safety("Pt01Data"),
    safety("Pt02Data"),
    safety("Pt03Data"),
    safety("Pt04Data"),
    safety("Pt05Data"),
    safety("Pt06Data"),
    safety("Pt07Data"),
    safety("Pt08Data"),
    safety("Pt09Data"),
    safety("Pt10Data"),
    safety("Pt11Data"),
];

/// Status of inputs, as a 1734-IB8S names it.
const POINT_STATUS: &[ModuleMember] = &[
    safety("Pt00Status"),
    safety("Pt01Status"),
    safety("Pt02Status"),
    safety("Pt03Status"),
    safety("Pt04Status"),
    safety("Pt05Status"),
    safety("Pt06Status"),
    safety("Pt07Status"),
];

/// Status of inputs, as modules name it that have outputs too.
const POINT_INPUT_STATUS: &[ModuleMember] = &[
    safety("Pt00InputStatus"),
    safety("Pt01InputStatus"),
    safety("Pt02InputStatus"),
    safety("Pt03InputStatus"),
    safety("Pt04InputStatus"),
    safety("Pt05InputStatus"),
    safety("Pt06InputStatus"),
    safety("Pt07InputStatus"),
    safety("Pt08InputStatus"),
    safety("Pt09InputStatus"),
    safety("Pt10InputStatus"),
    safety("Pt11InputStatus"),
];

/// Status of outputs.
const POINT_OUTPUT_STATUS: &[ModuleMember] = &[
    safety("Pt00OutputStatus"),
    safety("Pt01OutputStatus"),
    safety("Pt02OutputStatus"),
    safety("Pt03OutputStatus"),
    safety("Pt04OutputStatus"),
    safety("Pt05OutputStatus"),
    safety("Pt06OutputStatus"),
    safety("Pt07OutputStatus"),
];

/// Voltage at the output terminals. Marked STANDARD.
const POINT_READBACK: &[ModuleMember] = &[
    standard("Pt00Readback"),
    standard("Pt01Readback"),
    standard("Pt02Readback"),
    standard("Pt03Readback"),
    standard("Pt04Readback"),
    standard("Pt05Readback"),
    standard("Pt06Readback"),
    standard("Pt07Readback"),
];

/// Status of test outputs. Marked STANDARD.
const TEST_STATUS: &[ModuleMember] = &[
    standard("Pt00TestOutputStatus"),
    standard("Pt01TestOutputStatus"),
    standard("Pt02TestOutputStatus"),
    standard("Pt03TestOutputStatus"),
    standard("Pt04TestOutputStatus"),
    standard("Pt05TestOutputStatus"),
    standard("Pt06TestOutputStatus"),
    standard("Pt07TestOutputStatus"),
    standard("Pt08TestOutputStatus"),
    standard("Pt09TestOutputStatus"),
    standard("Pt10TestOutputStatus"),
    standard("Pt11TestOutputStatus"),
];

/// What switches test outputs. Marked STANDARD.
const TEST_DATA: &[ModuleMember] = &[
    standard("Test00Data"),
    standard("Test01Data"),
    standard("Test02Data"),
    standard("Test03Data"),
    standard("Test04Data"),
    standard("Test05Data"),
    standard("Test06Data"),
    standard("Test07Data"),
    standard("Test08Data"),
    standard("Test09Data"),
    standard("Test10Data"),
    standard("Test11Data"),
];

/// The first members of a table.
const fn first(table: &'static [ModuleMember], count: usize) -> &'static [ModuleMember] {
    table.split_at(count).0
}

/// States of so many points, at most 12.
pub(super) const fn data(count: usize) -> &'static [ModuleMember] {
    first(POINT_DATA, count)
}

/// Status of so many inputs, at most 8, of an input module.
pub(super) const fn status(count: usize) -> &'static [ModuleMember] {
    first(POINT_STATUS, count)
}

/// Status of so many inputs, at most 12, of Guard I/O.
pub(super) const fn input_status(count: usize) -> &'static [ModuleMember] {
    first(POINT_INPUT_STATUS, count)
}

/// Status of so many outputs, at most 8.
pub(super) const fn output_status(count: usize) -> &'static [ModuleMember] {
    first(POINT_OUTPUT_STATUS, count)
}

/// Read-backs of so many outputs, at most 8.
pub(super) const fn readback(count: usize) -> &'static [ModuleMember] {
    first(POINT_READBACK, count)
}

/// Status of so many test outputs, at most 12.
pub(super) const fn test_status(count: usize) -> &'static [ModuleMember] {
    first(TEST_STATUS, count)
}

/// Data of so many test outputs, at most 12.
pub(super) const fn test_data(count: usize) -> &'static [ModuleMember] {
    first(TEST_DATA, count)
}

/// Lamps on T1 and T3.
pub(super) const MUTING_1_3: &[ModuleMember] = &[safety("Muting01Status"), safety("Muting03Status")];
/// Lamps on T3 and T7.
pub(super) const MUTING_3_7: &[ModuleMember] = &[safety("Muting03Status"), safety("Muting07Status")];
/// Lamps on T3, T7 and T11.
pub(super) const MUTING_3_7_11: &[ModuleMember] =
    &[safety("Muting03Status"), safety("Muting07Status"), safety("Muting11Status")];

/// Values of analog channels.
pub(super) const CHANNEL_DATA: &[ModuleMember] =
    &[analog("Ch0Data"), analog("Ch1Data"), analog("Ch2Data"), analog("Ch3Data")];
/// Status of analog channels. A public faceplate library has the name, for the type AB:1734_IE4S3:I:0.
pub(super) const CHANNEL_STATUS: &[ModuleMember] =
    &[safety("Ch0InputStatus"), safety("Ch1InputStatus"), safety("Ch2InputStatus"), safety("Ch3InputStatus")];
/// Whether a channel is between its alarms. Marked STANDARD; name decided after the assembly table.
pub(super) const CHANNEL_ALARM: &[ModuleMember] = &[
    standard("Ch0CombinedAlarmStatus"),
    standard("Ch1CombinedAlarmStatus"),
    standard("Ch2CombinedAlarmStatus"),
    standard("Ch3CombinedAlarmStatus"),
];
/// Why a channel failed: the codes of 1734-UM013 Table 16. Marked STANDARD; name decided.
pub(super) const CHANNEL_FAULT_REASON: &[ModuleMember] =
    &[small("Ch0FaultReason"), small("Ch1FaultReason"), small("Ch2FaultReason"), small("Ch3FaultReason")];
/// Ends a latched overfrequency. Name decided.
pub(super) const RESET_TACHOMETER: &[ModuleMember] =
    &[safety("Ch0ResetTach"), safety("Ch1ResetTach"), safety("Ch2ResetTach"), safety("Ch3ResetTach")];
/// One byte of alarms for each channel, in the order of its bits (1734-UM013 Table 25). Names decided after the words of
/// `Values and States of Tags`; the alarms are marked STANDARD there, the tachometer conditions SAFETY.
pub(super) const CHANNEL_ALARMS: &[ModuleMember] = &[
    standard("Ch0HHAlarmStatus"),
    standard("Ch0LLAlarmStatus"),
    standard("Ch0HAlarmStatus"),
    standard("Ch0LAlarmStatus"),
    safety("Ch0TachOverfrequency"),
    safety("Ch0TachUnderfrequency"),
    safety("Ch0TachDualLow"),
    standard("Ch1HHAlarmStatus"),
    standard("Ch1LLAlarmStatus"),
    standard("Ch1HAlarmStatus"),
    standard("Ch1LAlarmStatus"),
    safety("Ch1TachOverfrequency"),
    safety("Ch1TachUnderfrequency"),
    safety("Ch1TachDualLow"),
    standard("Ch2HHAlarmStatus"),
    standard("Ch2LLAlarmStatus"),
    standard("Ch2HAlarmStatus"),
    standard("Ch2LAlarmStatus"),
    safety("Ch2TachOverfrequency"),
    safety("Ch2TachUnderfrequency"),
    safety("Ch2TachDualLow"),
    standard("Ch3HHAlarmStatus"),
    standard("Ch3LLAlarmStatus"),
    standard("Ch3HAlarmStatus"),
    standard("Ch3LAlarmStatus"),
    safety("Ch3TachOverfrequency"),
    safety("Ch3TachUnderfrequency"),
    safety("Ch3TachDualLow"),
];
