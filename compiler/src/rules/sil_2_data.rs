//! SIL 2 data that controls a SIL 3 output. 1756-RM093, SIL 2 Safety Logic; Appendix G.

use twinrung_grammar::tree::Span;

use super::unqualified_output::and_further;
use crate::diagnostic::Finding;

rule! {
    /// SIL 2 data that controls what is declared SIL 3.
    "S0703", Error, "SIL 2 data controls a SIL 3 output",
    "An input point that is evaluated alone is SIL 2 unless its declaration says otherwise; a pair that a safety instruction or the module evaluates is SIL 3; a tag is what SIL := 2 or 3 says. What is declared SIL 3 must not be switched on by SIL 2 data alone. Put SIL 3 data in series, or evaluate both channels of the device.",
    "1756-RM093, SIL 2 Safety Logic, and Appendix G; DESIGN 4",
    good: sample!(io; "    E : DCI_STOP (Class := Safety);\n    Motor OF Field_Out:O.Pt00Data (SIL := 3);\n", "      N: DCS(E,E-STOP,EQUIVALENT - ACTIVE HIGH,500,MANUAL,MANUAL,Field_In:I.Pt00Data,Field_In:I.Pt01Data,Field_In:I.CombinedInputStatus,Field_In:I.Pt02Data);\n      N: XIC(E.O1)XIC(Field_In:I.Pt03Data)XIO(Field_Out:I.ConnectionFaulted)OTE(Motor);\n"),
    bad: sample!(io; "    Motor OF Field_Out:O.Pt00Data (SIL := 3);\n", "      N: XIC(<<Field_In:I.Pt03Data>>)XIO(Field_In:I.ConnectionFaulted)XIO(Field_Out:I.ConnectionFaulted)OTE(Motor);\n")
}

/// The finding for SIL 2 data and the first SIL 3 output that it reaches.
pub(crate) fn finding(from: &str, to: &str, further: usize, span: Span) -> Finding {
    let message = format!("`{from}` is SIL 2 and alone can switch `{to}`{}, which is declared SIL 3", and_further(further));
    Finding::new(&CODE, span, message)
        .help("put SIL 3 data in series with it, evaluate the pair of channels, or declare what it really is with SIL")
}
