//! Decompiled text: the exporter's blanks, operands, expressions.

use crate::support::{REAL, *};
use twinrung_bytecode::format::*;

#[test]
fn branches_when_rendered_then_in_the_exporters_blanks() {
    let mut b = build();
    let [a, c, d, e] = ["a", "b", "c", "d"].map(|name| b.bit(name));
    let (xic, xio, ote) = (|x| op(Opcode::Xic, &[x]), |x| op(Opcode::Xio, &[x]), |x| op(Opcode::Ote, &[x]));
    b.rung(&[xic(a), branch(&[vec![xic(c), xio(d)], vec![xic(e)]]), ote(e)]);
    b.rung(&[branch(&[vec![xic(a)], vec![]]), ote(c)]);
    b.rung(&[branch(&[vec![], vec![xic(a), xio(c)]]), ote(d)]);
    b.rung(&[branch(&[vec![branch(&[vec![xic(a)], vec![xic(c)]]), xio(d)], vec![xic(e)]]), ote(e)]);
    b.rung(&[op(Opcode::Afi, &[])]);
    assert_eq!(
        b.text(),
        "XIC(a)[XIC(b) XIO(c) ,XIC(d) ]OTE(d);\n\
         [XIC(a) ,]OTE(b);\n\
         [,XIC(a) XIO(b) ]OTE(c);\n\
         [[XIC(a) ,XIC(b) ] XIO(c) ,XIC(d) ]OTE(d);\n\
         AFI();\n"
    );
    assert_eq!(b.rule(), "admitted");
}

#[test]
fn literals_when_rendered_then_in_their_radix_and_shortest_form() {
    let mut b = build();
    let d = b.data("d", REAL);
    let literals = [
        (OperandRecord::Integer { radix: 10, value: -5 }, "-5"),
        (OperandRecord::Integer { radix: 16, value: 0x00FF }, "16#ff"),
        (OperandRecord::Integer { radix: 16, value: -1 }, "16#ffffffff"),
        (OperandRecord::Integer { radix: 8, value: 8 }, "8#10"),
        (OperandRecord::Integer { radix: 2, value: 5 }, "2#101"),
        (OperandRecord::Integer { radix: 16, value: 0 }, "16#0"),
        (OperandRecord::Real(15.0f32.to_bits()), "15.0"),
        (OperandRecord::Real(0.1f32.to_bits()), "0.1"),
        (OperandRecord::Real((-0.0f32).to_bits()), "-0.0"),
        (OperandRecord::Real(1e-7f32.to_bits()), "1e-7"),
        (OperandRecord::Real(1e16f32.to_bits()), "1e16"),
    ];
    for (literal, _) in literals.iter() {
        let source = b.operand(literal.clone());
        b.rung(&[op(Opcode::Mov, &[source, d])]);
    }
    let expected: String = literals.iter().map(|(_, text)| format!("MOV({text},d);\n")).collect();
    assert_eq!(b.text(), expected);
    assert_eq!(b.rule(), "admitted");
}

/// Renders `CMP(expression)` of a postfix list over a, b, c and the literal -5 (`n`).
fn infix(postfix: &str) -> String {
    let mut build = build();
    let [a, b, c] = ["a", "b", "c"].map(|name| build.data(name, DINT));
    let n = build.integer(-5);
    let operations: Vec<Operation> = postfix
        .split(' ')
        .map(|word| match word {
            "a" => Operation::Push(a),
            "b" => Operation::Push(b),
            "c" => Operation::Push(c),
            "n" => Operation::Push(n),
            "~" => Operation::Apply(OPERATION_NEGATE),
            "NOT" => Operation::Apply(OPERATION_NOT),
            "ABS" => Operation::Apply(OPERATION_ABSOLUTE),
            "SQR" => Operation::Apply(OPERATION_SQUARE_ROOT),
            "+" => Operation::Apply(OPERATION_ADD),
            "-" => Operation::Apply(OPERATION_SUBTRACT),
            "*" => Operation::Apply(OPERATION_MULTIPLY),
            "/" => Operation::Apply(OPERATION_DIVIDE),
            "MOD" => Operation::Apply(OPERATION_MODULO),
            "AND" => Operation::Apply(OPERATION_AND),
            "OR" => Operation::Apply(OPERATION_OR),
            "XOR" => Operation::Apply(OPERATION_XOR),
            ">" => Operation::Apply(OPERATION_GREATER),
            "=" => Operation::Apply(OPERATION_EQUAL),
            other => panic!("{other}"),
        })
        .collect();
    let expression = build.expression(&operations);
    build.rung(&[op(Opcode::Cmp, &[expression])]);
    assert_eq!(build.rule(), "admitted", "{postfix}");
    build.text().trim_end_matches(");\n").trim_start_matches("CMP(").to_string()
}

#[test]
fn expressions_when_rendered_then_with_the_fewest_parentheses() {
    for (postfix, expected) in [
        ("a b c * +", "a+b*c"),
        ("a b + c *", "(a+b)*c"),
        ("a b - c -", "a-b-c"),
        ("a b c - -", "a-(b-c)"),
        ("a b c / *", "a*(b/c)"),
        ("a b MOD c *", "a MOD b*c"),
        ("a b AND c OR", "a AND b OR c"),
        ("a b c OR AND", "a AND (b OR c)"),
        ("a b OR c XOR", "(a OR b) XOR c"),
        ("a b + c AND", "a+b AND c"),
        ("a ~", "-a"),
        ("a ~ ~", "-(-a)"),
        ("a NOT NOT", "NOT NOT a"),
        ("a ~ NOT", "NOT -a"),
        ("a b + ~", "-(a+b)"),
        ("a b + ABS", "ABS(a+b)"),
        ("a ABS SQR", "SQR(ABS(a))"),
        ("a n -", "a-(-5)"),
        ("a n *", "a*-5"),
        ("a b ~ +", "a+(-b)"),
        ("a b ~ c * +", "a+(-b*c)"),
        ("n a +", "-5+a"),
        ("a b >", "a>b"),
        ("a b * c >", "a*b>c"),
        ("a b + c >", "(a+b)>c"),
        ("a b > c +", "(a>b)+c"),
        ("a b > c =", "(a>b)=c"),
        ("a b > b c > AND", "(a>b) AND (b>c)"),
        ("a b > NOT", "NOT (a>b)"),
        ("a n >", "a>-5"),
        ("a b > c *", "(a>b)*c"),
    ] {
        assert_eq!(infix(postfix), expected, "{postfix}");
    }
}
