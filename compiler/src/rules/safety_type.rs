//! Types that a safety tag may have. 1756-RM093 Table 7.

use twinrung_grammar::tree::Span;

use crate::diagnostic::Finding;

rule! {
    /// A type that no safety tag may have.
    "S0201", Error, "a type is not valid for safety tags",
    "A safety tag is BOOL, SINT, INT, DINT, REAL (not on every controller), a predefined type of Table 7, or made of these. Use one of them; 64-bit and unsigned numbers, messages, axes and alarms stay in standard tags.",
    "1756-RM093 Table 7",
    good: sample!("    Count : DINT (Class := Safety);\n    Run : BOOL (Class := Safety);\n", "      N: GRT(Count,7)OTE(Run);\n"),
    bad: sample!("    Count : <<LINT>> (Class := Safety);\n    Run : BOOL (Class := Safety);\n", "      N: OTE(Run);\n")
}

/// The finding for a declaration.
pub(crate) fn finding(what: &str, type_name: &str, declared: &str, span: Span) -> Finding {
    let within = if type_name.eq_ignore_ascii_case(declared) { String::new() } else { format!(" (within {declared})") };
    let message = format!("`{what}` is a safety tag and cannot be a {type_name}{within}");
    Finding::new(&CODE, span, message).help("use BOOL, SINT, INT, DINT or a type of Table 7 of the safety reference manual")
}
