//! Safety routines are ladder. 1756-RM093, safety programs.

use twinrung_grammar::tree::Span;

use crate::diagnostic::Finding;

rule! {
    /// A safety routine that is no ladder.
    "S0109", Error, "a safety routine is not ladder",
    "Only ladder is certified for safety routines. Write the routine as ladder, or move it to a standard program.",
    "1756-RM093, Safety Routines",
    good: sample!("    Run : BOOL (Class := Safety);\n", "      N: OTE(Run);\n"),
    bad: sample!("    Run : BOOL (Class := Safety);\n", "      N: OTE(Run);\n    END_ROUTINE\n    ST_ROUTINE <<Other>>\n      'Run := 1;\n    END_ST_ROUTINE\n    ROUTINE Last\n      N: NOP();\n")
}

/// The finding for a routine.
pub(crate) fn finding(span: Span, message: &str) -> Finding {
    Finding::new(&CODE, span, message).help("only ladder is certified: write it as ladder, or move it to a standard program")
}
