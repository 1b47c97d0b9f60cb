//! GSV and SSV reach attributes of safety objects only. 1756-RM093 Table 12, footnote 4.

use twinrung_catalog::instructions::system::{ATTRIBUTES, Attribute};
use twinrung_grammar::tree::{Operand, Span};

use crate::diagnostic::Finding;
use crate::names::closest;
use crate::project::Profile;

rule! {
    /// An attribute that the safety task cannot reach.
    "S0107", Error, "GSV or SSV names what the safety task cannot reach",
    "The safety task reads attributes of safety objects only, and sets only the MajorFaultRecord of a safety program. Read the attribute in a standard task and map the value.",
    "1756-RM093 Table 12, footnote 4; general-instructions.md A.10",
    good: sample!("    Exists : SINT (Class := Safety);\n", "      N: GSV(SAFETY,,SafetySignatureExists,Exists);\n"),
    bad: sample!("    Now : DINT[7] (Class := Safety);\n", "      N: GSV(<<WALLCLOCKTIME>>,,DateTime,Now[0]);\n")
}

/// The finding for a class.
pub(crate) fn class(shown: &Operand) -> Finding {
    let message = format!("the safety task cannot reach objects of class {}", shown.text);
    let finding = Finding::new(&CODE, shown.span, message);
    match closest(&shown.text, ATTRIBUTES.iter().map(|attribute| attribute.class)) {
        Some(like) => finding.help(format!("did you mean {like}?")),
        None => finding.help("its classes are TASK, PROGRAM, ROUTINE and SAFETY; map other values from a standard task"),
    }
}

/// The finding for an attribute.
pub(crate) fn attribute(class: &str, name: &str, span: Span) -> Finding {
    let of_class = || ATTRIBUTES.iter().filter(move |attribute| attribute.class == class).map(|attribute| attribute.name);
    let finding = Finding::new(&CODE, span, format!("the safety task cannot reach the attribute {name} of {class}"));
    match closest(name, of_class()) {
        Some(like) => finding.help(format!("did you mean {like}?")),
        None => finding.help(format!("it reaches {}", of_class().collect::<Vec<_>>().join(", "))),
    }
}

/// The finding for SSV on what can only be read.
pub(crate) fn read_only(attribute: &Attribute, span: Span) -> Finding {
    Finding::new(&CODE, span, format!("the safety task cannot set {}", attribute.name))
        .help("SSV sets only the MajorFaultRecord of a safety program")
}

/// The finding for an attribute that this controller does not have.
pub(crate) fn not_here(attribute: &Attribute, profile: &Profile, span: Span) -> Finding {
    let message = format!("the safety task of the {} cannot reach {}", profile.controller.catalog_number, attribute.name);
    Finding::new(&CODE, span, message).help("read it in a standard task and map the value")
}
