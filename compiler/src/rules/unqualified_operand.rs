//! Standard data in an operand that takes safety data only. dual-channel-inputs.md C7, C8.

use twinrung_grammar::tree::Span;

use crate::diagnostic::Finding;

rule! {
    /// Unqualified data in the place of a channel, a contact or a feedback.
    "S0702", Error, "standard data stands in the place of a channel or feedback",
    "Channels, contacts, feedbacks, and what opens a guard, mutes or overrides a device, are what a safety instruction judges by: they are wired to safety inputs. Standard data, also through logic, is no channel. A reset, a test request and an unlock request may be standard data: the instruction itself watches their edge.",
    "1756-RM093, Standard Tags in Safety Routines; dual-channel-inputs.md C7 and C8",
    good: sample!(io; "    E : DCI_STOP (Class := Safety);\n    Panel_Reset : BOOL;\n    Reset : BOOL (Class := Safety, MappedFrom := Panel_Reset);\n", "      N: DCS(E,E-STOP,EQUIVALENT - ACTIVE HIGH,500,MANUAL,MANUAL,Field_In:I.Pt00Data,Field_In:I.Pt01Data,Field_In:I.CombinedInputStatus,Reset);\n      N: XIC(E.O1)XIO(Field_Out:I.ConnectionFaulted)OTE(Field_Out:O.Pt00Data);\n"),
    bad: sample!(io; "    E : DCI_STOP (Class := Safety);\n    Panel_Stop : BOOL;\n    Stop, Channel : BOOL (Class := Safety);\n    Mapped_Stop : BOOL (Class := Safety, MappedFrom := Panel_Stop);\n", "      N: XIC(Mapped_Stop)OTE(Channel);\n      N: DCS(E,E-STOP,EQUIVALENT - ACTIVE HIGH,500,MANUAL,MANUAL,Field_In:I.Pt00Data,<<Channel>>,Field_In:I.CombinedInputStatus,Field_In:I.Pt02Data);\n      N: XIC(E.O1)XIO(Field_Out:I.ConnectionFaulted)OTE(Field_Out:O.Pt00Data);\n")
}

/// The finding for an operand, by its name.
pub(crate) fn finding(operand: &str, from: &str, span: Span) -> Finding {
    let message = format!("{operand} takes safety data only; {from} alone decides it here");
    Finding::new(&CODE, span, message).help("wire the device to a safety input and name its point here")
}
