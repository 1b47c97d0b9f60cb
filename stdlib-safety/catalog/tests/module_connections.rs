//! Every connection choice of every module against tables typed from the manuals: word, assembly instance and size, members.
//! `Pt00..07Data` stands for eight members. Sources: 1734-UM013 Tables 5 to 10 and 22 to 25 with the menus of chapter 5;
//! 1791ES-UM001 Tables 42 to 60 with its Module Definition; for DeviceNet see the catalogue's `device_net.rs`.

use twinrung_catalog::modules::{self, ConnectionChoice, MemberClass, Module, class_of_input, is_safety_output};

/// Catalogue number, direction, word, instance and size (0 where none is known), members that the choice adds.
type Row = (&'static str, &'static str, &'static str, (u16, u8), &'static str);

const ALARMS: &str = "Ch0HHAlarmStatus Ch0LLAlarmStatus Ch0HAlarmStatus Ch0LAlarmStatus Ch0TachOverfrequency Ch0TachUnderfrequency Ch0TachDualLow \
    Ch1HHAlarmStatus Ch1LLAlarmStatus Ch1HAlarmStatus Ch1LAlarmStatus Ch1TachOverfrequency Ch1TachUnderfrequency Ch1TachDualLow \
    Ch2HHAlarmStatus Ch2LLAlarmStatus Ch2HAlarmStatus Ch2LAlarmStatus Ch2TachOverfrequency Ch2TachUnderfrequency Ch2TachDualLow \
    Ch3HHAlarmStatus Ch3LLAlarmStatus Ch3HAlarmStatus Ch3LAlarmStatus Ch3TachOverfrequency Ch3TachUnderfrequency Ch3TachDualLow";

/// POINT Guard.
const POINT_GUARD: &[Row] = &[
    (
        "1734-IB8S",
        "I",
        "COMBINED_STATUS_MUTING",
        (0x314, 2),
        "Muting01Status Muting03Status InputPowerStatus CombinedInputStatus",
    ),
    ("1734-IB8S", "I", "NONE", (0x204, 1), ""),
    ("1734-IB8S", "I", "PT_STATUS", (0x224, 2), "Pt00..07Status"),
    ("1734-IB8S", "I", "PT_STATUS_MUTING", (0x334, 3), "Pt00..07Status Muting01Status Muting03Status InputPowerStatus"),
    (
        "1734-IB8S",
        "I",
        "PT_STATUS_MUTING_TEST_OUTPUT",
        (0x364, 4),
        "Pt00..07Status Pt00..03TestOutputStatus Muting01Status Muting03Status InputPowerStatus",
    ),
    ("1734-IB8S", "I", "COMBINED_STATUS_POWER", (0, 0), "InputPowerStatus CombinedInputStatus"),
    ("1734-IB8S", "O", "NONE", (0, 0), ""),
    ("1734-IB8S", "O", "TEST", (0x21, 1), "Test00..03Data"),
    (
        "1734-OB8S",
        "I",
        "COMBINED_STATUS_READBACK_POWER",
        (0x414, 2),
        "Pt00..07Readback OutputPowerStatus CombinedOutputStatus",
    ),
    ("1734-OB8S", "I", "NONE", (0, 0), ""),
    ("1734-OB8S", "I", "PT_STATUS", (0x244, 1), "Pt00..07OutputStatus"),
    ("1734-OB8S", "I", "PT_STATUS_READBACK", (0x404, 2), "Pt00..07OutputStatus Pt00..07Readback"),
    ("1734-OB8S", "O", "SAFETY", (0x234, 1), "Pt00..07Data"),
    ("1734-OB8S", "O", "NONE", (0, 0), ""),
    ("1734-IE4S", "I", "STATUS", (0x192, 9), "Ch0..3InputStatus"),
    ("1734-IE4S", "I", "STATUS_ALARMS", (0x312, 13), "Ch0..3InputStatus ALARMS"),
    (
        "1734-IE4S",
        "I",
        "STATUS_ALARMS_FAULTS",
        (0x322, 18),
        "Ch0..3InputStatus Ch0..3CombinedAlarmStatus Ch0..3FaultReason ALARMS InputPowerStatus",
    ),
    ("1734-IE4S", "O", "NONE", (0, 0), ""),
    ("1734-IE4S", "O", "SAFETY_TACHOMETER", (0x302, 1), "Ch0..3ResetTach"),
];

/// Eight inputs, eight outputs, eight test outputs: without the catalogue number.
const EIGHT: &[Row] = &[
    ("", "I", "NONE", (0x204, 1), ""),
    (
        "",
        "I",
        "PT_STATUS_MUTING",
        (0x344, 4),
        "Pt00..07InputStatus Pt00..07OutputStatus Muting03Status Muting07Status OutputPowerStatus InputPowerStatus",
    ),
    (
        "",
        "I",
        "COMBINED_STATUS_MUTING",
        (0x324, 2),
        "Muting03Status Muting07Status OutputPowerStatus InputPowerStatus CombinedOutputStatus CombinedInputStatus",
    ),
    (
        "",
        "I",
        "READBACK_PT_STATUS_MUTING",
        (0x354, 5),
        "Pt00..07InputStatus Pt00..07OutputStatus Pt00..07Readback Muting03Status Muting07Status OutputPowerStatus InputPowerStatus",
    ),
    (
        "",
        "I",
        "READBACK_PT_STATUS_MUTING_TEST_OUTPUT",
        (0x374, 6),
        "Pt00..07InputStatus Pt00..07OutputStatus Pt00..07Readback Pt00..07TestOutputStatus Muting03Status Muting07Status OutputPowerStatus InputPowerStatus",
    ),
    ("", "O", "SAFETY", (0x234, 1), "Pt00..07Data"),
    ("", "O", "TEST", (0x22, 1), "Test00..07Data"),
    ("", "O", "COMBINED", (0x2C4, 2), "Pt00..07Data Test00..07Data"),
    ("", "O", "NONE", (0, 0), ""),
];

/// Twelve inputs, four outputs, twelve test outputs: without the catalogue number.
const TWELVE: &[Row] = &[
    ("", "I", "NONE", (0x20C, 2), ""),
    (
        "",
        "I",
        "PT_STATUS_MUTING",
        (0x34C, 5),
        "Pt00..11InputStatus Pt00..03OutputStatus Muting03Status Muting07Status Muting11Status OutputPowerStatus InputPowerStatus",
    ),
    (
        "",
        "I",
        "COMBINED_STATUS_MUTING",
        (0x32C, 3),
        "Muting03Status Muting07Status Muting11Status OutputPowerStatus InputPowerStatus CombinedOutputStatus CombinedInputStatus",
    ),
    (
        "",
        "I",
        "READBACK_PT_STATUS_MUTING",
        (0x35C, 5),
        "Pt00..11InputStatus Pt00..03OutputStatus Pt00..03Readback Muting03Status Muting07Status Muting11Status OutputPowerStatus InputPowerStatus",
    ),
    (
        "",
        "I",
        "READBACK_PT_STATUS_MUTING_TEST_OUTPUT",
        (0x37C, 7),
        "Pt00..11InputStatus Pt00..03OutputStatus Pt00..03Readback Pt00..11TestOutputStatus Muting03Status Muting07Status Muting11Status OutputPowerStatus InputPowerStatus",
    ),
    ("", "O", "SAFETY", (0x233, 1), "Pt00..03Data"),
    ("", "O", "TEST", (0x25, 2), "Test00..11Data"),
    ("", "O", "COMBINED", (0x3C4, 2), "Pt00..03Data Test00..11Data"),
    ("", "O", "NONE", (0, 0), ""),
];

/// Guard I/O on DeviceNet with four test outputs.
const DEVICE_NET: &[Row] = &[
    ("1791DS-IB12", "I", "NONE", (0, 0), ""),
    ("1791DS-IB12", "I", "PT_STATUS", (0, 0), "Pt00..11InputStatus"),
    ("1791DS-IB12", "O", "NONE", (0, 0), ""),
    ("1791DS-IB12", "O", "TEST", (0, 0), "Test00..03Data"),
    ("1791DS-IB8XOB8", "I", "NONE", (0, 0), ""),
    ("1791DS-IB8XOB8", "I", "PT_STATUS", (0, 0), "Pt00..07InputStatus Pt00..07OutputStatus"),
    ("1791DS-IB8XOB8", "I", "READBACK_PT_STATUS", (0, 0), "Pt00..07InputStatus Pt00..07OutputStatus Pt00..07Readback"),
    ("1791DS-IB8XOB8", "O", "SAFETY", (0, 0), "Pt00..07Data"),
    ("1791DS-IB8XOB8", "O", "TEST", (0, 0), "Test00..03Data"),
    ("1791DS-IB8XOB8", "O", "COMBINED", (0, 0), "Pt00..07Data Test00..03Data"),
    ("1791DS-IB8XOB8", "O", "NONE", (0, 0), ""),
    ("1791DS-IB4XOW4", "I", "NONE", (0, 0), ""),
    ("1791DS-IB4XOW4", "I", "PT_STATUS", (0, 0), "Pt00..03InputStatus Pt00..03OutputStatus"),
    ("1791DS-IB4XOW4", "I", "READBACK_PT_STATUS", (0, 0), "Pt00..03InputStatus Pt00..03OutputStatus Pt00..03Readback"),
    ("1791DS-IB4XOW4", "O", "SAFETY", (0, 0), "Pt00..03Data"),
    ("1791DS-IB4XOW4", "O", "TEST", (0, 0), "Test00..03Data"),
    ("1791DS-IB4XOW4", "O", "COMBINED", (0, 0), "Pt00..03Data Test00..03Data"),
    ("1791DS-IB4XOW4", "O", "NONE", (0, 0), ""),
];

const EIGHTS: [&str; 5] =
    ["1791ES-IB8XOBV4", "1732ES-IB8XOBV4", "1732ES-IB8XOB8", "1791DS-IB8XOBV4", "1732DS-IB8XOBV4"];
const TWELVES: [&str; 2] = ["1732ES-IB12XOB4", "1732ES-IB12XOBV2"];

/// The members that a word of a row stands for.
fn expand(word: &str) -> Vec<String> {
    match (word, word.split_once("..")) {
        ("ALARMS", _) => ALARMS.split_whitespace().map(str::to_owned).collect(),
        (_, Some((before, after))) => {
            let digits: String = after.chars().take_while(char::is_ascii_digit).collect();
            let (letters, rest) = (before.trim_end_matches('0'), &after[digits.len()..]);
            let width = before.len() - letters.len();
            let last: u32 = digits.parse().expect("a number");
            (0..=last).map(|number| format!("{letters}{number:0width$}{rest}")).collect()
        }
        (_, None) => vec![word.to_owned()],
    }
}

fn shown(catalog: &str, direction: &str, word: &str, assembly: (u16, u8), members: &[String]) -> String {
    format!("{catalog} {direction} {word} {assembly:?} {}", members.join(" "))
}

fn typed() -> Vec<String> {
    let of = |catalog: Option<&str>, row: &Row| {
        let members: Vec<String> = row.4.split_whitespace().flat_map(expand).collect();
        shown(catalog.unwrap_or(row.0), row.1, row.2, row.3, &members)
    };
    let own = POINT_GUARD.iter().chain(DEVICE_NET).map(|row| of(None, row));
    let eights = EIGHTS.iter().flat_map(|catalog| EIGHT.iter().map(move |row| of(Some(catalog), row)));
    let twelves = TWELVES.iter().flat_map(|catalog| TWELVE.iter().map(move |row| of(Some(catalog), row)));
    let mut list: Vec<String> = own.chain(eights).chain(twelves).collect();
    list.sort();
    list
}

fn declared() -> Vec<String> {
    let of = |module: &Module, direction: &str, choice: &ConnectionChoice| {
        let assembly = choice.assembly.map_or((0, 0), |one| (one.instance, one.bytes));
        let members: Vec<String> = choice.each_member().map(|one| one.name.to_owned()).collect();
        shown(module.catalog_number, direction, choice.word, assembly, &members)
    };
    let mut list: Vec<String> = Vec::new();
    for module in modules::ALL {
        list.extend(module.input_status.iter().map(|choice| of(module, "I", choice)));
        list.extend(module.output_data.iter().map(|choice| of(module, "O", choice)));
    }
    list.sort();
    list
}

#[test]
fn connection_choices_when_compared_with_the_manuals_then_words_assemblies_and_members_are_the_same() {
    assert_eq!(declared(), typed());
}

#[test]
fn input_tags_when_listed_then_they_begin_with_the_connection_and_the_data() {
    let begins: Vec<String> = modules::ALL
        .iter()
        .map(|module| {
            let names: Vec<&str> = module.each_input().map(|one| one.name).collect();
            let (first, last) = (names.get(2).unwrap_or(&"-"), names.last().unwrap_or(&"-"));
            format!("{} {} {first} {last}", module.catalog_number, names.len())
        })
        .collect();
    let expected = [
        "1734-IB8S 10 Pt00Data Pt07Data",
        "1734-OB8S 2 - ConnectionFaulted",
        "1734-IE4S 6 Ch0Data Ch3Data",
        "1791ES-IB8XOBV4 10 Pt00Data Pt07Data",
        "1732ES-IB8XOBV4 10 Pt00Data Pt07Data",
        "1732ES-IB8XOB8 10 Pt00Data Pt07Data",
        "1732ES-IB12XOB4 14 Pt00Data Pt11Data",
        "1732ES-IB12XOBV2 14 Pt00Data Pt11Data",
        "1791DS-IB12 14 Pt00Data Pt11Data",
        "1791DS-IB8XOB8 10 Pt00Data Pt07Data",
        "1791DS-IB4XOW4 6 Pt00Data Pt03Data",
        "1791DS-IB4XOX4 0 - -",
        "1791DS-IB8XOBV4 10 Pt00Data Pt07Data",
        "1732DS-IB8XOBV4 10 Pt00Data Pt07Data",
    ];
    assert_eq!(begins, expected);
}

/// Points, test outputs and outputs by the catalogue numbers; lamps by Table 69 of 1791ES-UM001, Table 19 of 1734-UM013.
#[test]
fn points_when_counted_then_they_are_those_of_the_catalogue_numbers_and_test_sources_name_test_outputs() {
    let shown: Vec<String> = modules::ALL
        .iter()
        .map(|module| {
            let points: Vec<String> =
                module.points.iter().map(|kind| format!("{}{}", kind.letter, kind.count)).collect();
            format!("{} {} lamps {:?}", module.catalog_number, points.join(" "), module.muting_lamps)
        })
        .collect();
    let expected = [
        "1734-IB8S I8 T4 lamps [1, 3]",
        "1734-OB8S O8 lamps []",
        "1734-IE4S C4 lamps []",
        "1791ES-IB8XOBV4 I8 T8 O8 lamps [3, 7]",
        "1732ES-IB8XOBV4 I8 T8 O8 lamps [3, 7]",
        "1732ES-IB8XOB8 I8 T8 O8 lamps [3, 7]",
        "1732ES-IB12XOB4 I12 T12 O4 lamps [3, 7, 11]",
        "1732ES-IB12XOBV2 I12 T12 O4 lamps [3, 7, 11]",
        "1791DS-IB12 I12 T4 lamps [3]",
        "1791DS-IB8XOB8 I8 T4 O8 lamps [3]",
        "1791DS-IB4XOW4 I4 T4 O4 lamps [3]",
        "1791DS-IB4XOX4 I4 T4 O4 lamps [3]",
        "1791DS-IB8XOBV4 I8 T8 O8 lamps [3, 7]",
        "1732DS-IB8XOBV4 I8 T8 O8 lamps [3, 7]",
    ];
    assert_eq!(shown, expected);
    let sources_differ: Vec<&str> = modules::ALL
        .iter()
        .filter(|module| test_sources(module).is_some_and(|count| count != test_outputs(module) + 1))
        .map(|module| module.catalog_number)
        .collect();
    assert_eq!(sources_differ, Vec::<&str>::new());
}

fn test_outputs(module: &Module) -> usize {
    module.points.iter().filter(|kind| kind.test).map(|kind| kind.count as usize).sum()
}

/// How many words `TestSource` has, NONE among them.
fn test_sources(module: &Module) -> Option<usize> {
    let settings = module.points.iter().flat_map(|kind| kind.settings);
    settings.filter(|one| one.key == "TestSource").find_map(|one| match one.value {
        twinrung_catalog::points::SettingValue::Word(words) => Some(words.len()),
        twinrung_catalog::points::SettingValue::Number { .. } => None,
    })
}

/// `Values and States of Tags` of 1734-UM013, and Table 22 of 1791ES-UM001.
#[test]
fn members_when_the_manuals_mark_them_then_they_have_that_class() {
    let classes = [
        ("1734-IB8S", "RunMode", MemberClass::ConnectionStatus),
        ("1734-IB8S", "Pt07Data", MemberClass::Safety),
        ("1734-IB8S", "CombinedInputStatus", MemberClass::Safety),
        ("1734-IB8S", "Pt00Status", MemberClass::Safety),
        ("1734-IB8S", "Muting03Status", MemberClass::Safety),
        ("1734-IB8S", "Pt03TestOutputStatus", MemberClass::Standard),
        ("1734-IB8S", "InputPowerStatus", MemberClass::Standard),
        ("1734-OB8S", "Pt00Readback", MemberClass::Standard),
        ("1734-OB8S", "OutputPowerStatus", MemberClass::Standard),
        ("1734-OB8S", "CombinedOutputStatus", MemberClass::Safety),
        ("1734-IE4S", "Ch0Data", MemberClass::Safety),
        ("1734-IE4S", "Ch3InputStatus", MemberClass::Safety),
        ("1734-IE4S", "Ch0CombinedAlarmStatus", MemberClass::Standard),
        ("1734-IE4S", "Ch0FaultReason", MemberClass::Standard),
        ("1734-IE4S", "Ch0HHAlarmStatus", MemberClass::Standard),
        ("1734-IE4S", "Ch0LAlarmStatus", MemberClass::Standard),
        ("1734-IE4S", "Ch0TachOverfrequency", MemberClass::Safety),
        ("1734-IE4S", "Ch0TachDualLow", MemberClass::Safety),
        ("1732ES-IB12XOB4", "Pt11InputStatus", MemberClass::Safety),
        ("1732ES-IB12XOB4", "Pt03Readback", MemberClass::Standard),
        ("1732ES-IB12XOB4", "Muting11Status", MemberClass::Safety),
        ("1791ES-IB8XOBV4", "Pt07TestOutputStatus", MemberClass::Standard),
        // By the name alone.
        ("1791DS-IB4XOX4", "Pt00Monitor", MemberClass::Standard),
        ("1732ES-IB16", "InputPowerStatus", MemberClass::Standard),
        ("5069-IB8S", "Ch0HAlarm", MemberClass::Standard),
        ("5069-IB8S", "Pt00Data", MemberClass::Safety),
    ];
    let wrong: Vec<_> =
        classes.iter().filter(|(catalog, name, class)| class_of_input(catalog, name) != *class).collect();
    assert!(wrong.is_empty(), "{wrong:#?}");
    assert!(is_safety_output("1791DS-IB8XOB8", "Pt00Data") && !is_safety_output("1791DS-IB8XOB8", "Test00Data"));
}
