//! Input that nobody means well with: no panic, no recursion without a limit, no time without one.

use proptest::prelude::*;
use twinrung_grammar::tree::{ErrorKind, Operand, Sources, Span};
use twinrung_grammar::{Reading, limits, print_file, read, read_expression, read_immediate, read_tag, read_words};

const SAMPLE: &str = include_str!("samples/cell.L5K");

fn read_text(text: impl Into<Vec<u8>>) -> Reading {
    read(&mut Sources::new(), "hostile.rll", text.into())
}

fn kinds(reading: &Reading) -> Vec<ErrorKind> {
    reading.errors.iter().map(|error| error.kind).collect()
}

fn operand(text: &str) -> Operand {
    Operand { text: text.into(), span: Span::default(), origin: None }
}

fn in_routine(rung: &str) -> String {
    format!("ROUTINE Main\nN: {rung}\nEND_ROUTINE\n")
}

/// REQ-LANG-005
#[test]
fn branches_when_at_the_limit_then_are_read() {
    let depth = limits::BRANCH_DEPTH_MAX;
    let reading = read_text(in_routine(&format!("{}XIC(a){};", "[".repeat(depth), "]".repeat(depth))));
    assert_eq!(kinds(&reading), []);
}

/// REQ-LANG-005
#[test]
fn branches_when_one_past_the_limit_then_are_an_error() {
    let depth = limits::BRANCH_DEPTH_MAX + 1;
    let reading = read_text(in_routine(&format!("{}XIC(a){};", "[".repeat(depth), "]".repeat(depth))));
    assert_eq!(kinds(&reading), [ErrorKind::TooDeep]);
}

#[test]
fn expression_when_at_the_limit_then_is_read() {
    let depth = limits::EXPRESSION_DEPTH_MAX - 1;
    assert!(read_expression(&operand(&format!("{}a{}", "(".repeat(depth), ")".repeat(depth)))).is_ok());
}

#[test]
fn expression_when_one_past_the_limit_then_is_an_error() {
    let depth = limits::EXPRESSION_DEPTH_MAX;
    let error = read_expression(&operand(&format!("{}a{}", "(".repeat(depth), ")".repeat(depth)))).unwrap_err();
    assert_eq!(error.kind, ErrorKind::TooDeep);
}

#[test]
fn expression_when_it_is_a_long_chain_then_is_an_error() {
    let error =
        read_expression(&operand(&format!("a{}", "+a".repeat(limits::EXPRESSION_OPERATORS_MAX + 1)))).unwrap_err();
    assert_eq!(error.kind, ErrorKind::TooMany);
}

#[test]
fn expression_when_it_is_all_signs_then_is_an_error() {
    assert_eq!(read_expression(&operand(&"-".repeat(10_000))).unwrap_err().kind, ErrorKind::TooDeep);
    assert_eq!(read_expression(&operand(&"NOT ".repeat(10_000))).unwrap_err().kind, ErrorKind::TooDeep);
}

#[test]
fn operands_when_more_than_the_limit_then_are_an_error() {
    let reading = read_text(in_routine(&format!("JSR(a{});", ",a".repeat(limits::OPERANDS_MAX))));
    assert_eq!(kinds(&reading), [ErrorKind::TooMany]);
}

#[test]
fn names_when_more_than_the_limit_then_are_an_error() {
    let reading = read_text(format!("TAG a{} : DINT; b : DINT; END_TAG", ", a".repeat(limits::NAMES_MAX)));
    assert_eq!(kinds(&reading), [ErrorKind::TooMany]);
    assert_eq!(reading.file.tags.len(), 2);
}

#[test]
fn names_when_their_declaration_is_long_then_are_an_error() {
    let text = "x".repeat(limits::JOINED_BYTES_MAX);
    let reading = read_text(format!("TAG a, b : DINT (Description := \"{text}\"); END_TAG"));
    assert_eq!(kinds(&reading), [ErrorKind::TooMany]);
}

#[test]
fn value_when_one_past_the_limit_then_is_an_error() {
    let depth = limits::VALUE_DEPTH_MAX + 1;
    let text = format!("TAG a : DINT := {}1{}; b : DINT; END_TAG", "[".repeat(depth), "]".repeat(depth));
    let reading = read_text(text);
    assert_eq!(kinds(&reading), [ErrorKind::TooDeep]);
    assert_eq!(reading.file.tags.len(), 1);
}

#[test]
fn elements_when_nested_without_end_then_are_an_error() {
    let reading = read_text(format!("<RSLogix5000Content>{}", "<Controller>".repeat(100_000)));
    assert!(kinds(&reading).contains(&ErrorKind::MalformedXml));
}

#[test]
fn structures_when_nested_past_the_limit_then_are_an_error() {
    let depth = limits::VALUE_DEPTH_MAX + 1;
    let (open, close) = ("<Structure>".repeat(depth), "</Structure>".repeat(depth));
    let text = format!(
        "<RSLogix5000Content><Controller Name=\"C\"><Tags><Tag Name=\"t\"><Data Format=\"Decorated\">{open}{close}\
         </Data></Tag></Tags></Controller></RSLogix5000Content>"
    );
    let reading = read_text(text);
    assert_eq!(kinds(&reading), [ErrorKind::TooDeep]);
    assert_eq!(reading.file.tags.len(), 1);
}

#[test]
fn errors_when_more_than_the_limit_then_the_last_says_so() {
    let reading = read_text("@ ;".repeat(limits::ERRORS_MAX + 10));
    assert_eq!(reading.errors.len(), limits::ERRORS_MAX + 1);
    assert!(kinds(&reading).contains(&ErrorKind::TooMany));
}

/// Each of these once made a reader look through the rest of the file for every line of it.
#[test]
fn file_when_nothing_ends_in_it_then_is_read_in_linear_time() {
    let line = 20_000;
    for text in [
        "(* \n",
        "\"\n",
        "'\n",
        "[[[___\n",
        "TREND a\n",
        "N: XIC(a\n",
        "N: (* \n",
        "RC: \"\n",
        "a : b\n",
        "MODULE m (\n",
    ] {
        read_text(text.repeat(line));
        read_text(in_routine(&text.repeat(line)));
        read_text(format!("TAG\n{}", text.repeat(line)));
        read_text(format!("PROGRAM p\nTAG\n{}", text.repeat(line)));
    }
}

#[test]
fn document_type_when_in_a_file_then_nothing_after_it_is_read() {
    let reading = read_text("<!DOCTYPE a [<!ENTITY b \"c\">]><RSLogix5000Content>&b;</RSLogix5000Content>");
    assert!(kinds(&reading).contains(&ErrorKind::MalformedXml));
}

/// REQ-LANG-003
#[test]
fn file_when_not_utf8_then_the_rest_is_read() {
    let reading = read_text(b"TAG a : DINT (Description := \"Gr\xFC\xDFe\"); END_TAG".to_vec());
    assert_eq!(kinds(&reading), [ErrorKind::NotUtf8]);
    assert_eq!(reading.file.tags.len(), 1);
}

/// REQ-LANG-003
#[test]
fn file_when_utf16_then_is_refused() {
    assert_eq!(kinds(&read_text(vec![0xFF, 0xFE, b'T', 0])), [ErrorKind::NotUtf8]);
}

#[test]
fn file_when_empty_then_is_an_error() {
    assert_eq!(kinds(&read_text("")), [ErrorKind::Empty]);
    assert_eq!(kinds(&read_text("// nothing\n")), [ErrorKind::Empty]);
}

proptest! {
    /// REQ-LANG-001
    #[test]
    fn bytes_when_read_then_nothing_panics(bytes in proptest::collection::vec(any::<u8>(), 0..400)) {
        print_file(&read_text(bytes).file);
    }

    #[test]
    fn noise_when_read_then_nothing_panics(text in r#"[\[\](){},;:='"$/*\\.#<>&!a-cN0-2 \n-]{0,200}"#) {
        print_file(&read_text(text.clone()).file);
        print_file(&read_text(in_routine(&text)).file);
        print_file(&read_text(format!("TAG {text} END_TAG")).file);
        print_file(&read_text(format!("<RSLogix5000Content><Controller><Tags><Tag><Data Format=\"L5K\">{text}")).file);
        let operand = operand(&text);
        let _ = (read_tag(&operand), read_expression(&operand), read_immediate(&operand), read_words(&operand));
    }

    #[test]
    fn sample_when_cut_and_changed_then_nothing_panics(
        cut in 0..SAMPLE.len(),
        changes in proptest::collection::vec((0..SAMPLE.len(), any::<u8>()), 0..8),
    ) {
        let mut bytes = SAMPLE.as_bytes().to_vec();
        for (at, byte) in changes {
            bytes[at] = byte;
        }
        print_file(&read_text(bytes.clone()).file);
        bytes.truncate(cut);
        print_file(&read_text(bytes).file);
    }

    #[test]
    fn words_when_shuffled_then_nothing_panics(words in proptest::collection::vec(word(), 0..60)) {
        let text = words.join(" ");
        let reading = read_text(text);
        print_file(&reading.file);
    }
}

fn word() -> impl Strategy<Value = &'static str> {
    proptest::sample::select(vec![
        "CONTROLLER",
        "END_CONTROLLER",
        "PROGRAM",
        "END_PROGRAM",
        "ROUTINE",
        "END_ROUTINE",
        "TAG",
        "END_TAG",
        "MODULE",
        "END_MODULE",
        "CONNECTION",
        "END_CONNECTION",
        "DATATYPE",
        "END_DATATYPE",
        "ADD_ON_INSTRUCTION_DEFINITION",
        "END_ADD_ON_INSTRUCTION_DEFINITION",
        "PARAMETERS",
        "END_PARAMETERS",
        "LOCAL_TAGS",
        "END_LOCAL_TAGS",
        "TASK",
        "END_TASK",
        "TREND",
        "END_TREND",
        "ST_ROUTINE",
        "END_ST_ROUTINE",
        "ENCODED_DATA",
        "END_ENCODED_DATA",
        "POINT",
        "TEST",
        "BIT",
        "OF",
        "N:",
        "RC:",
        "a",
        "b",
        ":",
        ":=",
        ";",
        ",",
        "(",
        ")",
        "[",
        "]",
        "1",
        "16#ff",
        "\"text\"",
        "'text'",
        "// comment\n",
        "(* comment *)",
        "\n",
        ".",
        "IE_VER",
        "XIC(a)",
        "OTE(b);",
        "Class := Safety",
        "[[[___",
        "___]]]",
    ])
}
