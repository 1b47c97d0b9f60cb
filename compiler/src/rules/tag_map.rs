//! Lines of the safety tag map. neutral-text-and-l5x.md D.2.

use twinrung_grammar::tree::Span;

use crate::diagnostic::Finding;
use crate::project::{Tag, TagClass, TagKind, TagScope};

rule! {
    /// A line of the tag map that cannot hold.
    "S0305", Error, "a line of the safety tag map cannot hold",
    "The map copies a standard tag of the controller to a safety tag of the controller of the same type, each safety tag from one standard tag only. Neither may be connected to a module or another controller. What comes from the standard side is SIL 2 at most, so the safety tag is not declared SIL 3.",
    "1756-RM093, Tag Mapping, and Appendix G; neutral-text-and-l5x.md D.2",
    good: sample!("    Panel_Speed : DINT;\n    Speed : DINT (Class := Safety, MappedFrom := Panel_Speed);\n    Run : BOOL (Class := Safety);\n", "      N: GRT(Speed,7)OTE(Run);\n"),
    bad: sample!("    Panel_Speed : INT;\n    Speed : DINT (Class := Safety, MappedFrom := <<Panel_Speed>>);\n    Run : BOOL (Class := Safety);\n", "      N: GRT(Speed,7)OTE(Run);\n")
}

/// Why a line does not hold.
pub(crate) fn finding(standard: &str, source: Option<&Tag>, receiver: &Tag, span: Span) -> Option<Finding> {
    let refuse = |message: String, help: &str| Some(Finding::new(&CODE, span, message).help(help));
    let Some(source) = source else {
        return refuse(format!("the standard tag `{standard}` is not declared"), "declare it in the controller, or correct the name");
    };
    if source.class == TagClass::Safety {
        return refuse(format!("`{}` is a safety tag already", source.name), "map a standard tag; safety logic reads this one as it is");
    }
    if receiver.class == TagClass::Standard {
        return refuse(format!("`{}` receives a mapped value and is no safety tag", receiver.name), "declare it with Class := Safety");
    }
    if receiver.scope != TagScope::Controller {
        return refuse(format!("`{}` receives a mapped value and belongs to a program", receiver.name), "declare it in the controller");
    }
    if !matches!(receiver.kind, TagKind::Base) {
        return refuse(
            format!("`{}` receives a mapped value and is no plain tag", receiver.name),
            "map to a tag of its own, neither alias nor connected to anything",
        );
    }
    if receiver.constant {
        return refuse(format!("`{}` receives a mapped value and is constant", receiver.name), "take Constant away");
    }
    if receiver.sil == Some(3) {
        let message = format!("`{}` receives a mapped value and is declared SIL 3", receiver.name);
        return refuse(message, "declare SIL := 2: what the standard side reads is SIL 2 at most, also in two channels");
    }
    let same = source.type_name.eq_ignore_ascii_case(&receiver.type_name) && source.dimensions == receiver.dimensions;
    if !source.is_alias() && !same {
        let message =
            format!("`{}` is {} and `{}` is {}", source.name, type_text(source), receiver.name, type_text(receiver));
        return refuse(message, "give both tags the same type");
    }
    None
}

/// The type of a tag as text writes it.
pub(crate) fn type_text(tag: &Tag) -> String {
    let sizes: Vec<String> = tag.dimensions.iter().take_while(|size| **size > 0).map(u32::to_string).collect();
    if sizes.is_empty() { tag.type_name.to_string() } else { format!("{}[{}]", tag.type_name, sizes.join(",")) }
}

/// The finding for a safety tag that the map does not find.
pub(crate) fn unknown(name: &str, span: Span) -> Finding {
    Finding::new(&CODE, span, format!("the safety tag `{name}` is not declared"))
        .help("declare it in the controller with Class := Safety, or correct the name")
}

/// The finding for a safety tag with two sources.
pub(crate) fn twice(receiver: &Tag, first: Span, span: Span) -> Finding {
    Finding::new(&CODE, span, format!("`{}` receives two standard tags", receiver.name))
        .label(first, "the other line")
        .help("keep one of the two lines")
}
