//! The length of COP (and, decided, of FLL) is a constant. 1756-RM093 Table 12, footnote 3.

use twinrung_grammar::tree::Operand;

use crate::diagnostic::Finding;

rule! {
    /// The length of a copy is no constant.
    "S0105", Error, "the length of COP is not a constant",
    "What a copy in safety logic reaches must be known before it runs: the length of COP and FLL is a literal. Write the number of elements; copy parts that vary one by one.",
    "1756-RM093 Table 12, footnote 3; general-instructions.md A.6 (FLL decided)",
    good: sample!("    A, B : DINT[8] (Class := Safety);\n", "      N: COP(A[0],B[0],8);\n"),
    bad: sample!("    A, B : DINT[8] (Class := Safety);\n    Count : DINT (Class := Safety);\n", "      N: COP(A[0],B[0],<<Count>>);\n")
}

/// The finding for a length that is no literal.
pub(crate) fn finding(shown: &Operand) -> Finding {
    let message = format!("the length is `{}`, not a constant", shown.text);
    Finding::new(&CODE, shown.span, message).help("write the number of elements as a literal; parts whose number varies are copied one by one")
}
