//! Printing and reading are inverse, spans aside; printing twice changes nothing.

mod support;

use proptest::prelude::*;
use support::trees::{expression, file};
use support::without_spans;
use twinrung_grammar::tree::{Operand, Sources, Span};
use twinrung_grammar::{print_expression, print_file, read, read_expression};

proptest! {
    /// REQ-LANG-030
    #[test]
    fn file_when_printed_and_read_then_is_the_same(file in file()) {
        let text = print_file(&file);
        let reading = read(&mut Sources::new(), "printed.rll", text.clone().into_bytes());
        prop_assert!(reading.errors.is_empty(), "{:?}\n{text}", reading.errors);
        prop_assert_eq!(without_spans(&reading.file), without_spans(&file), "{}", text);
    }

    /// REQ-LANG-030
    #[test]
    fn file_when_printed_twice_then_text_is_the_same(file in file()) {
        let once = print_file(&file);
        let reading = read(&mut Sources::new(), "printed.rll", once.clone().into_bytes());
        prop_assert_eq!(print_file(&reading.file), once);
    }

    /// REQ-LANG-032
    #[test]
    fn expression_when_printed_and_read_then_is_the_same(expression in expression()) {
        let text = print_expression(&expression);
        let operand = Operand { text: text.as_str().into(), span: Span::default(), origin: None };
        let read = read_expression(&operand);
        prop_assert!(read.is_ok(), "{read:?}\n{text}");
        prop_assert_eq!(without_spans(&read.unwrap()), without_spans(&expression), "{}", text);
    }
}
