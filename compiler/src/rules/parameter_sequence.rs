//! A number from outside that controls a safety output. 1756-RM093, Changing Parameters in SIL-rated Systems.

use twinrung_grammar::tree::Span;

use super::unqualified_output::and_further;
use crate::diagnostic::Finding;

rule! {
    /// A parameter from an operator terminal without the sequence that the manual demands.
    "S0704", Error, "a parameter from outside is used without the manual's sequence",
    "A number of the tag map is standard data: an operator terminal or a standard program writes it. It may become a parameter of a safety function only in one way: it arrives in two tags by two commands; safety logic compares the two and checks both ends of the range; both are read back and shown; the operator acknowledges; on the edge of that the value is moved on. One MOV with these conditions before it (or in bits that a coil of its own sets) is recognized, and what it writes counts as qualified: XIC of the acknowledgement with ONS first, so that a button that is held accepts nothing; EQU of the two mapped tags; LIM (or GEQ and LEQ) with bounds of safety logic.",
    "1756-RM093, Changing Parameters in SIL-rated Systems; DESIGN 4",
    good: sample!(io; "    Terminal_Speed_1, Terminal_Speed_2 : DINT;\n    Terminal_Accept : BOOL;\n    Speed_1 : DINT (Class := Safety, MappedFrom := Terminal_Speed_1);\n    Speed_2 : DINT (Class := Safety, MappedFrom := Terminal_Speed_2);\n    Accept : BOOL (Class := Safety, MappedFrom := Terminal_Accept);\n    Edge : BOOL (Class := Safety);\n    Limit, Speed : DINT (Class := Safety);\n", "      N: XIC(Accept)ONS(Edge)EQU(Speed_1,Speed_2)LIM(10,Speed_1,250)MOV(Speed_1,Limit);\n      N: XIC(Field_In:I.Pt00Data)ADD(Speed,1,Speed);\n      N: LES(Speed,Limit)XIO(Field_In:I.ConnectionFaulted)XIO(Field_Out:I.ConnectionFaulted)OTE(Field_Out:O.Pt00Data);\n"),
    bad: sample!(io; "    Terminal_Speed_1 : DINT;\n    Speed_1 : DINT (Class := Safety, MappedFrom := Terminal_Speed_1);\n    Limit, Speed : DINT (Class := Safety);\n", "      N: LIM(10,Speed_1,250)MOV(<<Speed_1>>,Limit);\n      N: XIC(Field_In:I.Pt00Data)ADD(Speed,1,Speed);\n      N: LES(Speed,Limit)XIO(Field_In:I.ConnectionFaulted)XIO(Field_Out:I.ConnectionFaulted)OTE(Field_Out:O.Pt00Data);\n")
}

/// The finding for a number from outside and the first output that it reaches.
pub(crate) fn finding(
    from: &str,
    to: &str,
    further: usize,
    missing: Option<&[&'static str]>,
    span: Span,
) -> Finding {
    let message = format!("the number {from} alone can switch the safety output `{to}`{}", and_further(further));
    let help = match missing {
        Some(missing) => missing.join("; "),
        None => "let it arrive in two tags, compare them, check the range, let the operator acknowledge, and move it on"
            .to_owned(),
    };
    Finding::new(&CODE, span, message).help(help)
}
