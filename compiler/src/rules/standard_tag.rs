//! A standard tag in safety logic. 1756-RM093, safety tags.

use twinrung_grammar::tree::TagReference;

use crate::diagnostic::Finding;
use crate::project::Tag;
use crate::rules::tag_map;

rule! {
    /// A standard tag in safety logic.
    "S0301", Error, "safety logic uses a standard tag",
    "Safety logic neither reads nor writes standard tags: anything may write them, and they exist once. Declare the tag with Class := Safety; or let the standard value come in through the tag map, and qualify it with safety data.",
    "1756-RM093, Safety Tags; general-instructions.md 1",
    good: sample!("    Panel_Reset : BOOL;\n    Reset : BOOL (Class := Safety, MappedFrom := Panel_Reset);\n    Run : BOOL (Class := Safety);\n", "      N: XIC(Reset)OTE(Run);\n"),
    bad: sample!("    Panel_Reset : BOOL;\n    Run : BOOL (Class := Safety);\n", "      N: XIC(<<Panel_Reset>>)OTE(Run);\n")
}

/// The finding for a reference to a standard tag.
pub(crate) fn finding(declared: &Tag, tag: &TagReference, writes: bool) -> Finding {
    let does = if writes { "writes" } else { "reads" };
    let message = format!("safety logic {does} the standard tag `{}`", declared.name);
    let help = if writes {
        "declare it with Class := Safety; standard logic may read it there".to_owned()
    } else {
        let (name, type_name) = (&declared.name, tag_map::type_text(declared));
        format!(
            "let it come in through the tag map: declare Safe_{name} : {type_name} (Class := Safety, MappedFrom := {name}) \
             and use that, in series with safety data; declare it with Class := Safety only where safety logic alone writes it"
        )
    };
    Finding::new(&CODE, tag.base.span, message).label(declared.span, "declared here, of class Standard").help(help)
}
