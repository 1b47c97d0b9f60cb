//! Operands read as tags, expressions, immediate values and words.

use twinrung_grammar::tree::{ErrorKind, Expression, Number, Operand, Part, Radix, SourceId, Sources, Span};
use twinrung_grammar::{print_expression, print_tag, read, read_expression, read_immediate, read_tag, read_words};

fn operand(text: &str) -> Operand {
    Operand { text: text.into(), span: Span::new(SourceId(0), 0, text.len() as u32), origin: None }
}

fn tag(text: &str) -> String {
    print_tag(&read_tag(&operand(text)).unwrap())
}

fn expression(text: &str) -> String {
    print_expression(&read_expression(&operand(text)).unwrap())
}

fn refusal(text: &str) -> (ErrorKind, u32, u32) {
    let error = read_expression(&operand(text)).unwrap_err();
    (error.kind, error.span.start, error.span.end)
}

fn number(text: &str) -> Number {
    read_immediate(&operand(text)).unwrap().number
}

fn integer(magnitude: u64, radix: Radix) -> Number {
    Number::Integer { negative: false, magnitude, radix }
}

/// REQ-LANG-021
#[test]
fn tag_when_of_any_form_then_is_read() {
    for text in [
        "a",
        "_a1",
        "a.b.c",
        "a.5",
        "a[1]",
        "a[1,2]",
        "a[1,2,3]",
        "a[i].b[j,2].7",
        "a.[i]",
        "a.[t.ACC]",
        "Local:2:I.Data.3",
        "Adapter:3:I.Pt01.Data",
        "Doors:I.Pt00Data",
        "Mod:SI.x",
        "\\Prog.Tag.m",
        "S:FS",
        "S:MINOR",
        "a[b[c[1]]]",
        "a[i+1]",
        "a.AND",
        "T.MOD.5",
        "Node30ComboModule:I.Pt07Data",
    ] {
        assert_eq!(tag(text), text);
    }
}

#[test]
fn tag_when_it_has_blanks_then_is_read_without_them() {
    assert_eq!(tag("a [ 1 , i + 2 ] . b"), "a[1,i+2].b");
}

#[test]
fn tag_when_something_else_then_is_an_error() {
    for text in
        ["", "?", "5", "a+b", "a b", "a.", "a[", "a[]", "a[1,2,3,4]", "'AB'", "a.b:c", "a..b", "a.1x", "(a)", "a]"]
    {
        assert!(read_tag(&operand(text)).is_err(), "{text}");
    }
}

#[test]
fn tag_when_read_then_parts_have_their_places() {
    let tag = read_tag(&operand("Doors:I.Pt[i].7")).unwrap();
    let places: Vec<_> = tag
        .parts
        .iter()
        .map(|part| match part {
            Part::Member(name) => name.span,
            Part::Subscripts { span, .. } | Part::Bit { span, .. } | Part::BitSubscript { span, .. } => *span,
        })
        .map(|span| (span.start, span.end))
        .collect();
    assert_eq!(((tag.base.span.start, tag.base.span.end), places), ((0, 7), vec![(8, 10), (10, 13), (14, 15)]));
}

/// REQ-LANG-023, REQ-LANG-032
#[test]
fn expression_when_precedence_decides_then_needs_no_parentheses() {
    for (text, canonical) in [
        ("a + b * c", "a+b*c"),
        ("(a + b) * c", "(a+b)*c"),
        ("a - (b - c)", "a-(b-c)"),
        ("(a - b) - c", "a-b-c"),
        ("a and b or c xor not d", "a AND b OR c XOR NOT d"),
        ("(a > b) AND (c <= 16#ff)", "(a>b) AND (c<=16#ff)"),
        ("-a ** 2", "-a**2"),
        ("(-a) ** 2", "(-a)**2"),
        ("a * -5", "a*-5"),
        ("- 5 + - x", "-5+-x"),
        ("SQR ( a MOD 3 ) / Abs(b[i,1])", "SQR(a MOD 3)/Abs(b[i,1])"),
        ("HMI_MS*.6", "HMI_MS*.6"),
        ("a=b[Ctl.POS]", "a=b[Ctl.POS]"),
        ("(a+1)>b", "(a+1)>b"),
        ("NOT(a)", "NOT a"),
        ("((a))", "a"),
    ] {
        assert_eq!(expression(text), canonical);
        assert_eq!(expression(canonical), canonical);
    }
}

/// REQ-LANG-023
#[test]
fn expression_when_a_relation_is_mixed_then_is_ambiguous() {
    assert_eq!(refusal("a + b = c"), (ErrorKind::AmbiguousRelation, 6, 7));
    for text in ["a > b + c", "a AND b > c", "a > b OR c", "a < b < c", "x*(a = b - c)", "t[a > b - 1]", "a=b AND c=d"]
    {
        assert_eq!(refusal(text).0, ErrorKind::AmbiguousRelation, "{text}");
    }
}

#[test]
fn expression_when_a_relation_stands_beside_products_then_is_read() {
    assert_eq!(expression("a*2>-b/c"), "a*2>-b/c");
    assert_eq!(expression("NOT a = b"), "NOT a=b");
}

#[test]
fn expression_when_malformed_then_the_error_points_at_it() {
    assert_eq!(refusal("a + * b"), (ErrorKind::MalformedExpression, 4, 5));
    assert_eq!(refusal("a && b"), (ErrorKind::MalformedExpression, 2, 3));
    assert_eq!(refusal("a + ?"), (ErrorKind::MalformedExpression, 4, 5));
    assert_eq!(refusal("a + 16#fg"), (ErrorKind::MalformedNumber, 4, 9));
    assert_eq!(refusal("(a"), (ErrorKind::MalformedExpression, 2, 2));
}

#[test]
fn expression_when_function_is_unknown_then_is_kept() {
    assert!(matches!(read_expression(&operand("SIN(a)")).unwrap(), Expression::Call { .. }));
}

/// REQ-LANG-022
#[test]
fn number_when_of_any_form_then_is_read() {
    assert_eq!(number("100"), integer(100, Radix::Decimal));
    assert_eq!(number("-5"), Number::Integer { negative: true, magnitude: 5, radix: Radix::Decimal });
    assert_eq!(number("16#0000_00fF"), integer(255, Radix::Hexadecimal));
    assert_eq!(number("8#000_017"), integer(15, Radix::Octal));
    assert_eq!(number("2#0000_1111"), integer(15, Radix::Binary));
    assert_eq!(number("15.0"), Number::Real { bits: 15f32.to_bits() });
    assert_eq!(number("-3.25"), Number::Real { bits: (-3.25f32).to_bits() });
    assert_eq!(number("1.5000000e+01"), Number::Real { bits: 15f32.to_bits() });
    assert_eq!(number("1e-3"), Number::Real { bits: 1e-3f32.to_bits() });
    assert_eq!(number(".6"), Number::Real { bits: 0.6f32.to_bits() });
    assert_eq!(number("1.#QNAN"), Number::Special { bits: 0x7FC0_0000 });
    assert_eq!(number("-1.#INF"), Number::Special { bits: 0xFF80_0000 });
    assert_eq!(number("1.$"), Number::Special { bits: 0x7F80_0000 });
    assert_eq!(number("'A$00$'b'"), Number::Ascii(vec![b'A', 0, b'\'', b'b']));
}

/// REQ-LANG-022
#[test]
fn number_when_between_two_reals_then_is_rounded_once() {
    // Halfway between two binary32 values as binary64 sees it; the decimal text is above.
    assert_eq!(number("1.00000017881393432617187499"), Number::Real { bits: 0x3F80_0001 });
    assert_eq!(number("16777217.0"), Number::Real { bits: 16_777_216f32.to_bits() });
}

#[test]
fn number_when_no_number_then_is_an_error() {
    for (text, kind) in [
        ("16#", ErrorKind::MalformedNumber),
        ("16#xyz", ErrorKind::MalformedNumber),
        ("2#12", ErrorKind::MalformedNumber),
        ("3#1", ErrorKind::MalformedNumber),
        ("1.2.3", ErrorKind::MalformedNumber),
        ("99999999999999999999", ErrorKind::MalformedNumber),
        ("1e99", ErrorKind::MalformedNumber),
        ("'$Z'", ErrorKind::MalformedEscape),
        ("abc", ErrorKind::MalformedNumber),
        ("", ErrorKind::MalformedNumber),
    ] {
        assert_eq!(read_immediate(&operand(text)).unwrap_err().kind, kind, "{text}");
    }
}

/// REQ-LANG-020, REQ-LANG-024
#[test]
fn words_when_written_in_any_way_then_are_the_same() {
    for text in [
        "EQUIVALENT - ACTIVE HIGH",
        "equivalent  -  active high",
        "'Equivalent - Active High'",
        "\"EQUIVALENT - ACTIVE HIGH\"",
    ] {
        assert_eq!(read_words(&operand(text)).unwrap().text, "EQUIVALENT - ACTIVE HIGH");
    }
    assert_eq!(read_words(&operand("E-STOP")).unwrap().text, "E-STOP");
}

#[test]
fn words_when_something_else_then_are_an_error() {
    for text in ["", "?", "''", "a+b", "a[1]"] {
        assert_eq!(read_words(&operand(text)).unwrap_err().kind, ErrorKind::MalformedWords, "{text}");
    }
}

/// REQ-LANG-006
#[test]
fn operand_when_over_several_lines_then_places_are_exact() {
    let mut sources = Sources::new();
    let text = "ROUTINE R\nN: CMP(first (* c *) >\n   // here\n   second.Member)OTE(x);\nEND_ROUTINE\n";
    let reading = read(&mut sources, "r.rll", text.into());
    let rung = &reading.file.routines[0].rungs()[0];
    let twinrung_grammar::tree::Element::Instruction(compare) = &rung.elements[0] else { unreachable!() };
    let operand = &compare.operands[0];
    assert_eq!(operand.text, "first > second.Member");
    let Expression::Binary { right, .. } = read_expression(operand).unwrap() else { unreachable!() };
    assert_eq!(sources.text(right.span()), "second.Member");
    assert_eq!(rung.trivia.leading(), ["(* c *)", "// here"]);
}

/// REQ-LANG-006
#[test]
fn operand_when_entities_stand_in_it_then_places_are_exact() {
    let mut sources = Sources::new();
    let text = "<RSLogix5000Content><Controller Name='C'><Programs><Program Name='P'><Routines><Routine Name='R' Type='RLL'>\
                <RLLContent><Rung Number='0' Type='N'><Text> CMP(a&lt;&gt;second)OTE(x); </Text></Rung></RLLContent>\
                </Routine></Routines></Program></Programs></Controller></RSLogix5000Content>";
    let reading = read(&mut sources, "r.L5X", text.into());
    let rung = &reading.file.programs[0].routines[0].rungs()[0];
    let [twinrung_grammar::tree::Element::Instruction(compare), twinrung_grammar::tree::Element::Instruction(coil)] =
        &rung.elements[..]
    else {
        unreachable!()
    };
    assert_eq!(compare.operands[0].text, "a<>second");
    let Expression::Binary { right, .. } = read_expression(&compare.operands[0]).unwrap() else { unreachable!() };
    assert_eq!(sources.text(right.span()), "second");
    assert_eq!(sources.text(coil.operands[0].span), "x");
    assert_eq!(sources.text(coil.mnemonic.span), "OTE");
}
