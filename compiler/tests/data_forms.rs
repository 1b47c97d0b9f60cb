//! What the forms of a tag's data say: lists, decorated data, the memory image.

mod support;

use support::{admitted, export, lines, project, read, refused};
use twinrung_compiler::{Completion, check, compile};
use twinrung_grammar::tree::Sources;

/// The codes of the errors of an export whose only tag has this type and these forms of data.
fn codes(kind: &str, forms: &str) -> Vec<&'static str> {
    let mut sources = Sources::new();
    let reading = read(&mut sources, "sample.L5X", &export(&tag(kind, forms), "NOP();"));
    let checked = check(&reading, &Completion::default());
    checked.findings.iter().filter(|finding| finding.is_error()).map(|finding| finding.code.id).collect()
}

fn tag(kind: &str, forms: &str) -> String {
    format!("<Tag Name=\"One\" TagType=\"Base\" {kind} Class=\"Safety\" Constant=\"false\">{forms}</Tag>")
}

/// The bits and words with which the only tag of an export begins.
fn cells(kind: &str, forms: &str) -> (Vec<u8>, Vec<i32>) {
    let mut sources = Sources::new();
    let reading = read(&mut sources, "sample.L5X", &export(&tag(kind, forms), "NOP();"));
    let checked = check(&reading, &Completion::default());
    let shown = lines(&sources, &checked);
    let compiled = compile(&checked.project.unwrap_or_else(|| panic!("{shown}"))).unwrap();
    let image = twinrung_bytecode::admit(&compiled.bytes).unwrap();
    (image.image().initial_bits.clone(), image.image().initial_words.clone())
}

fn words(kind: &str, forms: &str) -> Vec<i32> {
    cells(kind, forms).1
}

const BITS: &str = "DataType=\"BOOL\" Dimensions=\"32\"";
const NUMBERS: &str = "DataType=\"DINT\" Dimensions=\"3\"";
const AXES: &str = "DataType=\"Axis_T\" Dimensions=\"2\"";

#[test]
fn memory_image_when_of_elements_and_arrays_then_each_value_in_its_cell() {
    assert_eq!(cells("DataType=\"BOOL\"", "<Data>01</Data>").0, [1]);
    assert_eq!(words("DataType=\"INT\"", "<Data>FE FF</Data>"), [-2]);
    assert_eq!(words(NUMBERS, "<Data>01 00 00 00 02 00 00 00 FF FF FF FF</Data>"), [1, 2, -1]);
    assert_eq!(words("DataType=\"SINT\" Dimensions=\"4\"", "<Data>01 02 FF 04</Data>"), [1, 2, -1, 4]);
    let bits = cells(BITS, "<Data>05 01 00 80</Data>").0;
    let set: Vec<usize> = (0..32).filter(|at| bits[*at] == 1).collect();
    assert_eq!(set, [0, 2, 8, 31]);
}

#[test]
fn memory_image_when_of_structures_in_an_array_then_each_value_in_its_cell() {
    let (bits, words) = cells(AXES, "<Data>02 00 FD FF 01 00 07 00</Data>");
    assert_eq!(words, [-3, 7]);
    assert_eq!(bits, [0, 1, 1, 0]);
}

#[test]
fn decorated_array_when_an_element_is_outside_or_missing_then_refused() {
    let array = |elements: &[(u32, i32)]| {
        let shown: String =
            elements.iter().map(|(at, value)| format!("<Element Index=\"[{at}]\" Value=\"{value}\"/>")).collect();
        format!(
            "<Data Format=\"Decorated\"><Array DataType=\"DINT\" Dimensions=\"3\" Radix=\"Decimal\">{shown}</Array></Data>"
        )
    };
    assert_eq!(words(NUMBERS, &array(&[(0, 7), (1, 8), (2, 9)])), [7, 8, 9]);
    assert_eq!(codes(NUMBERS, &array(&[(0, 7), (1, 8), (3, 9)])), ["E0309"]);
    assert_eq!(codes(NUMBERS, &array(&[(0, 7), (1, 8)])), ["E0309"]);
}

/// Two forms of one number.
fn two_forms(kind: &str, decorated: &str, list: &str) -> Vec<&'static str> {
    let forms = format!(
        "<Data Format=\"L5K\"><![CDATA[{list}]]></Data><Data Format=\"Decorated\"><DataValue DataType=\"{kind}\" Value=\"{decorated}\"/></Data>"
    );
    codes(&format!("DataType=\"{kind}\""), &forms)
}

#[test]
fn real_when_two_forms_write_it_with_other_digits_then_they_agree_and_another_value_does_not() {
    assert_eq!(two_forms("REAL", "1.1", "1.1000001e+000"), Vec::<&str>::new());
    assert_eq!(two_forms("REAL", "1.1", "1.2"), ["E0308"]);
    assert_eq!(two_forms("REAL", "1.1", "-1.1"), ["E0308"]);
    assert_eq!(two_forms("REAL", "0.0", "1.0"), ["E0308"]);
}

#[test]
fn structure_when_two_forms_differ_then_only_its_real_may_in_its_last_digits() {
    let judged = |list: &str, speed: &str, ratio: &str| {
        let forms = format!(
            "<Data Format=\"L5K\"><![CDATA[{list}]]></Data><Data Format=\"Decorated\"><Structure DataType=\"Axis_T\"><DataValueMember \
             Name=\"Enabled\" DataType=\"BOOL\" Value=\"0\"/><DataValueMember Name=\"Homed\" DataType=\"BOOL\" \
             Value=\"1\"/><DataValueMember Name=\"Speed\" DataType=\"DINT\" Value=\"{speed}\"/><DataValueMember Name=\"Ratio\" \
             DataType=\"REAL\" Value=\"{ratio}\"/></Structure></Data>"
        );
        let member = |name: &str, kind: &str| {
            format!("<Member Name=\"{name}\" DataType=\"{kind}\" Dimension=\"0\" Hidden=\"false\"/>")
        };
        let text = export(&tag("DataType=\"Axis_T\"", &forms), "NOP();");
        let begin = text.find("<Member Name=\"Speed\"").unwrap();
        let end = begin + text[begin..].find("</Members>").unwrap();
        let text = format!("{}{}{}{}", &text[..begin], member("Speed", "DINT"), member("Ratio", "REAL"), &text[end..]);
        let mut sources = Sources::new();
        let checked = check(&read(&mut sources, "sample.L5X", &text), &Completion::default());
        let errors = checked.findings.iter().filter(|finding| finding.is_error());
        errors.map(|finding| finding.code.id).collect::<Vec<_>>()
    };
    assert_eq!(judged("[2,1065353216,1.1]", "1065353216", "1.1000001"), Vec::<&str>::new());
    assert_eq!(judged("[2,1065353216,1.1]", "1065353217", "1.1"), ["E0308"]);
    assert_eq!(judged("[2,1065353216,1.1]", "1065353216", "1.2"), ["E0308"]);
}

#[test]
fn integer_when_two_forms_differ_in_its_last_digit_then_they_disagree() {
    assert_eq!(two_forms("DINT", "1065353216", "1065353216"), Vec::<&str>::new());
    assert_eq!(two_forms("DINT", "1065353216", "1065353217"), ["E0308"]);
    assert_eq!(two_forms("DINT", "3", "4"), ["E0308"]);
}

const TAG: &str = "    X : BOOL (Class := Safety);\n";

#[test]
fn integer_when_at_the_end_of_its_range_then_admitted_and_beyond_it_refused() {
    let with = |kind: &str, value: &str| {
        project("", &format!("{TAG}    N : {kind} (Class := Safety) := {value};"), "NOP()", "")
    };
    for (kind, value) in [
        ("SINT", "127"),
        ("SINT", "-128"),
        ("SINT", "16#ff"),
        ("INT", "32767"),
        ("INT", "-32768"),
        ("DINT", "2147483647"),
        ("DINT", "-2147483648"),
        ("BOOL", "1"),
    ] {
        refused(&with(kind, value), &[]);
    }
    for (kind, value) in [
        ("SINT", "128"),
        ("SINT", "-129"),
        ("SINT", "16#100"),
        ("INT", "32768"),
        ("INT", "-32769"),
        ("DINT", "2147483648"),
        ("BOOL", "2"),
        ("DINT", "1.5"),
    ] {
        refused(&with(kind, &format!("<<{value}>>")), &["E0309"]);
    }
}

#[test]
fn list_when_bits_of_a_type_fill_more_than_a_byte_then_each_byte_is_a_value() {
    let members: String = (0..10).map(|at| format!("    BOOL B{at};\n")).collect();
    let types = format!("  DATATYPE Flags_T\n{members}    INT Count;\n    BOOL Last;\n  END_DATATYPE\n");
    let tags = "    Flags : Flags_T (Class := Safety) := [129,2,5,1];";
    let image = admitted(&project(&types, tags, "NOP()", ""));
    assert_eq!(image.image().initial_bits, [1, 0, 0, 0, 0, 0, 0, 1, 0, 1, 1]);
    assert_eq!(image.image().initial_words, [5]);
}

#[test]
fn characters_when_they_are_the_value_of_an_integer_then_its_bytes() {
    let forms = |kind: &str, value: &str| {
        format!("<Data Format=\"Decorated\"><DataValue DataType=\"{kind}\" Radix=\"ASCII\" Value=\"{value}\"/></Data>")
    };
    let shown = |kind: &str, value: &str| words(&format!("DataType=\"{kind}\""), &forms(kind, value));
    assert_eq!(shown("SINT", "'$FE'"), [-2]);
    assert_eq!(shown("INT", "'$FF$FE'"), [-2]);
    assert_eq!(shown("INT", "'AB'"), [0x4142]);
    assert_eq!(shown("DINT", "'ABCD'"), [0x4142_4344]);
    assert_eq!(codes("DataType=\"INT\"", &forms("INT", "'ABC'")), ["E0309"]);
    assert_eq!(codes("DataType=\"BOOL\"", &forms("BOOL", "'A'")), ["E0309"]);
}
