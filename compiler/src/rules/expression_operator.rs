//! Operators and functions that expressions of safety logic may not hold. 1756-RM093 Table 12, footnote 2.

use twinrung_grammar::tree::{BinaryOperator, Name, Span};

use crate::diagnostic::Finding;
use crate::operand::ExpressionKind;

rule! {
    /// An operator that safety expressions may not hold.
    "S0104", Error, "an expression uses what is not certified",
    "Expressions of safety logic hold + - * / MOD, AND OR XOR NOT, ABS and SQR; CMP and FSC also relations. Powers, trigonometry, logarithms and conversions are not certified. Compute such a value in a standard task, or by steps.",
    "1756-RM093 Table 12, footnote 2; general-instructions.md A.9",
    good: sample!("    A, B : DINT (Class := Safety);\n", "      N: CPT(B,ABS(A) + 1);\n"),
    bad: sample!("    A, B : DINT (Class := Safety);\n", "      N: CPT(B,<<SIN(A)>>);\n")
}

/// The finding for an operator.
pub(crate) fn operator(operator: BinaryOperator, kind: ExpressionKind, span: Span) -> Finding {
    if operator.is_relation() {
        let place = if kind == ExpressionKind::Subscript { "a subscript" } else { "an expression that gives a number" };
        return Finding::new(&CODE, span, format!("a relation in {place}"))
            .help("compare with CMP or with a compare instruction");
    }
    Finding::new(&CODE, span, "the operator ** is not certified for safety logic").help("multiply by steps")
}

/// The finding for a function.
pub(crate) fn function(function: &Name, span: Span) -> Finding {
    let message = format!("{function} is not certified in expressions of safety logic");
    Finding::new(&CODE, span, message).help("ABS and SQR are; other values come from a standard task through the tag map")
}
