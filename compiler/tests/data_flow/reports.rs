//! What a finding says of the path.

use twinrung_compiler::{Completion, check};
use twinrung_grammar::tree::Sources;

use crate::support::read;
use crate::{messages, text};

/// The texts of the related places of the first error.
fn labels(text: &str) -> Vec<String> {
    let mut sources = Sources::new();
    let reading = read(&mut sources, "sample.rll", text);
    let checked = check(&reading, &Completion::default());
    let first = checked.findings.iter().find(|finding| finding.is_error()).unwrap();
    first.labels.iter().map(|label| label.text.clone()).collect()
}

#[test]
fn path_when_longer_than_twelve_steps_then_its_first_and_last_six_are_shown() {
    let chain: String = (0..13).map(|at| format!("XIC(Bits[{at}])OTE(Bits[{}])\n", at + 1)).collect();
    let shown = labels(&text("", "", &format!("XIC(Std)OTE(Bits[0])\n{chain}XIC(Bits[13])OTE(Motor)"), ""));
    let steps: Vec<usize> = shown.iter().filter_map(|label| label.split('.').next()?.parse().ok()).collect();
    assert_eq!(steps, [1, 2, 3, 4, 5, 6, 10, 11, 12, 13, 14, 15], "{shown:#?}");
}

#[test]
fn cell_when_in_an_array_of_one_two_or_three_dimensions_then_named_with_its_subscripts() {
    let named = |dimensions: &str, element: &str| {
        let tags = format!("    Table : DINT[{dimensions}] (Class := Safety, SIL := 3);");
        let shown = messages(&text("", &tags, &format!("XIC(In:I.Pt04Data)MOV(1,{element})"), ""));
        shown.iter().filter(|message| message.contains(&format!("`{element}`"))).count()
    };
    assert_eq!(named("5", "Table[4]"), 1);
    assert_eq!(named("2,3", "Table[1,2]"), 1);
    assert_eq!(named("2,3,4", "Table[1,0,3]"), 1);
    assert_eq!(named("2,3,4", "Table[0,2,1]"), 1);
}
