//! REAL where the controller has none. 1756-RM093 Table 7 and Table 12, footnote 1.

use twinrung_grammar::tree::Span;

use crate::diagnostic::{Finding, Findings};
use crate::project::{Profile, Project, TagClass};

rule! {
    /// REAL where the controller has none.
    "S0202", Error, "REAL is not admitted on this controller",
    "Safety data of the 1756-L6xS and 1768-L4xS is never REAL: not as a tag, not as a member of a type at any depth, not as a literal in logic. Count in integers (for instance hundredths), or use a 1756-L7xS or later.",
    "1756-RM093 Table 7; Table 12, footnote 1",
    good: sample!(on "1756-L73S", "20"; "    A, B : REAL (Class := Safety);\n", "      N: MOV(A,B);\n"),
    bad: sample!(on "1756-L63S", "20"; "    A : <<REAL>> (Class := Safety);\n    B : BOOL (Class := Safety);\n", "      N: OTE(B);\n")
}

/// The finding for a literal.
pub(crate) fn literal(profile: &Profile, span: Span) -> Finding {
    let message = format!("a REAL literal on the {}, whose safety logic has no REAL", profile.controller.catalog_number);
    Finding::new(&CODE, span, message).help("write an integer")
}

/// Safety tags and Add-On Instructions whose type is or holds REAL.
pub(crate) fn check(project: &Project, findings: &mut Findings) {
    let Some(profile) = &project.profile else { return };
    if profile.has_real() {
        return;
    }
    for tag in project.tags.iter().filter(|tag| tag.class == TagClass::Safety && !tag.is_alias()) {
        if tag.type_reference.is_some_and(|reference| project.types.holds_real(reference)) {
            findings.push(declared(profile, &tag.name, &tag.type_name, tag.type_span));
        }
    }
    for add_on in &project.add_ons {
        for parameter in &add_on.parameters {
            if parameter.type_reference.is_some_and(|reference| project.types.holds_real(reference)) {
                let type_name = parameter.type_reference.map_or("", |reference| project.types.name(reference));
                findings.push(declared(profile, &parameter.name, type_name, parameter.span));
            }
        }
        for local in &add_on.locals {
            if local.type_reference.is_some_and(|reference| project.types.holds_real(reference)) {
                let type_name = local.type_reference.map_or("", |reference| project.types.name(reference));
                findings.push(declared(profile, &local.name, type_name, local.span));
            }
        }
    }
}

fn declared(profile: &Profile, name: &str, type_name: &str, span: Span) -> Finding {
    let is_real = type_name.eq_ignore_ascii_case("REAL");
    let holds = if is_real { "is REAL".to_owned() } else { format!("is a {type_name}, which holds REAL") };
    let message = format!("`{name}` {holds}: the {} has no REAL in safety data", profile.controller.catalog_number);
    Finding::new(&CODE, span, message).help("use DINT in a finer unit (hundredths, with what it is compared with scaled alike), or a 1756-L7xS or later")
}
