//! Every refused program is refused with the code meant for it, and with errors of that code alone.

use std::collections::BTreeSet;
use std::fs;

use crate::support::{lines, project_path, read_whole};

/// File name and code.
const REFUSED: &[(&str, &str)] = &[
    ("backing-tag-used-twice", "S0601"),
    ("cmp-on-an-l63s", "S0102"),
    ("cop-with-a-tag-as-length", "S0105"),
    ("discrepancy-time-of-4-ms", "E0305"),
    ("mapped-sil-2-data-on-a-sil-3-output", "S0703"),
    ("mapped-tag-declared-sil-3", "S0305"),
    ("mapped-tag-written", "S0304"),
    ("own-member-as-operand", "S0608"),
    ("parameter-without-acknowledgement", "S0704"),
    ("period-of-501-ms", "S0502"),
    ("real-on-an-l63s", "S0202"),
    ("recursion", "S0604"),
    ("single-output-on-a-module-of-pairs", "S0415"),
    ("single-point-on-a-sil-3-output", "S0703"),
    ("standard-bit-switches-an-output", "S0701"),
    ("standard-data-as-a-channel", "S0702"),
    ("standard-tag-in-safety-logic", "S0301"),
    ("uncertified-instruction", "S0101"),
    ("unfinished-operand", "E0303"),
    ("unknown-tag", "E0201"),
    ("watchdog-above-the-period", "S0503"),
];

#[test]
fn refused_programs_when_checked_then_each_is_refused_with_its_code_alone() {
    let mut wrong = Vec::new();
    for (name, code) in REFUSED {
        let read = read_whole(&project_path("samples/refused").join(format!("{name}.rll")));
        let errors: BTreeSet<&str> =
            read.findings.iter().filter(|finding| finding.is_error()).map(|finding| finding.code.id).collect();
        if errors != BTreeSet::from([*code]) {
            wrong.push((name, code, lines(&read)));
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

#[test]
fn refused_programs_when_the_folder_is_listed_then_all_are_in_the_table() {
    let listed: BTreeSet<String> = REFUSED.iter().map(|(name, _)| format!("{name}.rll")).collect();
    let found: BTreeSet<String> = fs::read_dir(project_path("samples/refused"))
        .unwrap()
        .map(|entry| entry.unwrap().file_name().to_string_lossy().into_owned())
        .collect();
    assert_eq!(listed, found);
}
