//! Standard data that controls a safety output. 1756-RM093, Standard Tags in Safety Routines, Figure 14; docs/data-flow.md.

use twinrung_grammar::tree::Span;

use crate::diagnostic::Finding;

rule! {
    /// Unqualified data that controls a safety output.
    "S0701", Error, "standard data controls a safety output",
    "A tag of the tag map, and a member of a module that is marked STANDARD, holds standard data: it is unqualified, and so is every tag that it alone can switch. It must not switch a safety output on by itself, whatever tags, timers, moves, subroutines and Add-On Instructions lie between. Put a contact of safety data in series with it on each path, as Figure 14 of the manual does; let a stuck bit not restart (ONS). Standard data may switch an output off.",
    "1756-RM093, Standard Tags in Safety Routines, Figure 14; DESIGN 4",
    good: sample!(io; "    Panel_Start : BOOL;\n    Start : BOOL (Class := Safety, MappedFrom := Panel_Start);\n    Edge, Run : BOOL (Class := Safety);\n", "      N: [XIC(Start) ONS(Edge) ,XIC(Run) ]XIC(Field_In:I.Pt00Data)XIO(Field_In:I.ConnectionFaulted)OTE(Run);\n      N: XIC(Run)XIO(Field_Out:I.ConnectionFaulted)OTE(Field_Out:O.Pt00Data);\n"),
    bad: sample!(io; "    Panel_Start : BOOL;\n    Start : BOOL (Class := Safety, MappedFrom := Panel_Start);\n    Run : BOOL (Class := Safety);\n", "      N: [XIC(<<Start>>) ,XIC(Field_In:I.Pt00Data) ]XIO(Field_In:I.ConnectionFaulted)OTE(Run);\n      N: XIC(Run)XIO(Field_Out:I.ConnectionFaulted)OTE(Field_Out:O.Pt00Data);\n")
}

/// The finding for data from outside and the first output that it reaches.
pub(crate) fn finding(from: &str, to: &str, further: usize, span: Span) -> Finding {
    let message = format!("{from} alone can switch the safety output `{to}`{}", and_further(further));
    Finding::new(&CODE, span, message)
        .help("put a contact of safety data in series with it, here or on a rung that its path goes through")
}

/// How many more outputs there are.
pub(crate) fn and_further(further: usize) -> String {
    match further {
        0 => String::new(),
        1 => " and 1 more".to_owned(),
        more => format!(" and {more} more"),
    }
}
