//! An alias joins no standard tag with a safety tag. 1756-RM093, safety tags.

use twinrung_grammar::tree::Span;

use crate::diagnostic::Finding;
use crate::project::{Tag, TagClass};

rule! {
    /// An alias of the other class.
    "S0303", Error, "an alias joins standard and safety data",
    "An alias has the class of what it designates. A standard name for safety data would let standard logic write it; a safety name for standard data would let safety logic trust it. Leave the class away, or map the tag.",
    "1756-RM093, Safety Tags: no aliasing between standard and safety tags",
    good: sample!("    Guard : BOOL (Class := Safety);\n    Door OF Guard;\n    Run : BOOL (Class := Safety);\n", "      N: XIC(Door)OTE(Run);\n"),
    bad: sample!("    Guard : BOOL;\n    Door OF <<Guard>> (Class := Safety);\n    Run : BOOL (Class := Safety);\n", "      N: XIC(Door)OTE(Run);\n")
}

/// The finding for an alias.
pub(crate) fn finding(alias: &Tag, own: TagClass, own_span: Span, target: Option<&Tag>, operand: Span) -> Finding {
    let word = |class| match class {
        TagClass::Standard => "standard",
        TagClass::Safety => "safety",
    };
    let other = if own == TagClass::Safety { TagClass::Standard } else { TagClass::Safety };
    let message = format!("the {} alias `{}` designates {} data", word(own), alias.name, word(other));
    let finding = Finding::new(&CODE, operand, message).label(own_span, "the class is named here");
    let finding = match target {
        Some(target) => finding.label(target.span, format!("declared here, of class {}", word(other))),
        None => finding,
    };
    finding.help("leave the class of the alias away; to bring a standard value into safety logic use the tag map")
}
