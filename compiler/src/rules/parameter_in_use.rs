//! A number from outside that takes part in a safety function. 1756-RM093, Changing Parameters in SIL-rated Systems.

use twinrung_grammar::tree::Span;

use super::unqualified_output::and_further;
use crate::diagnostic::Finding;

rule! {
    /// A mapped number that takes part in switching an output without the sequence for parameters.
    "W0117", Warning, "a number from outside takes part in a safety function without the manual's sequence",
    "A mapped number (a limit, a time, a count) takes part in switching a safety output. Safety data stands in series, so it does not switch it alone; yet a value that was sent wrongly changes the safety function. If an operator terminal or a program changes it, let it come by the sequence of S0704: two tags, compared, in range, acknowledged. If it has nothing to do with safety, keep it out of the path.",
    "1756-RM093, Changing Parameters in SIL-rated Systems; DESIGN 4",
    good: sample!(io; "    Terminal_Speed_1, Terminal_Speed_2 : DINT;\n    Terminal_Accept : BOOL;\n    Speed_1 : DINT (Class := Safety, MappedFrom := Terminal_Speed_1);\n    Speed_2 : DINT (Class := Safety, MappedFrom := Terminal_Speed_2);\n    Accept : BOOL (Class := Safety, MappedFrom := Terminal_Accept);\n    Edge : BOOL (Class := Safety);\n    Limit, Speed : DINT (Class := Safety);\n", "      N: XIC(Accept)ONS(Edge)EQU(Speed_1,Speed_2)LIM(10,Speed_1,250)MOV(Speed_1,Limit);\n      N: LES(Speed,Limit)XIC(Field_In:I.Pt00Data)XIO(Field_In:I.ConnectionFaulted)XIO(Field_Out:I.ConnectionFaulted)OTE(Field_Out:O.Pt00Data);\n"),
    bad: sample!(io; "    Terminal_Speed : DINT;\n    Limit : DINT (Class := Safety, MappedFrom := Terminal_Speed);\n    Speed : DINT (Class := Safety);\n", "      N: LES(Speed,<<Limit>>)XIC(Field_In:I.Pt00Data)XIO(Field_In:I.ConnectionFaulted)XIO(Field_Out:I.ConnectionFaulted)OTE(Field_Out:O.Pt00Data);\n")
}

/// The finding for a number from outside and the first output that it takes part in switching.
pub(crate) fn finding(
    from: &str,
    to: &str,
    further: usize,
    missing: Option<&[&'static str]>,
    span: Span,
) -> Finding {
    let message = format!("the number {from} takes part in switching `{to}`{}", and_further(further));
    let help = match missing {
        Some(missing) => missing.join("; "),
        None => "let it come by the sequence of S0704, or keep it out of the path".to_owned(),
    };
    Finding::new(&CODE, span, message).help(help)
}
