//! Tags that logic may not write. 1756-RM093, tag mapping; neutral-text-and-l5x.md D.2, D.5.

use crate::diagnostic::{Finding, Findings};
use crate::names::Map;
use crate::project::{Project, TagKind};
use crate::rules::usage;

rule! {
    /// A mapped, consumed or constant tag that logic writes.
    "S0304", Error, "logic writes a tag that is not its own",
    "A mapped tag is overwritten at the start of every scan, a consumed tag belongs to the controller that produces it, a constant tag never changes. Write another tag.",
    "1756-RM093, Tag Mapping and Consumed Tags; neutral-text-and-l5x.md D.2, D.5",
    good: sample!("    Panel_Reset : BOOL;\n    Reset : BOOL (Class := Safety, MappedFrom := Panel_Reset);\n    Run : BOOL (Class := Safety);\n", "      N: XIC(Reset)OTE(Run);\n"),
    bad: sample!("    Panel_Reset : BOOL;\n    Reset : BOOL (Class := Safety, MappedFrom := Panel_Reset);\n    Run : BOOL (Class := Safety);\n", "      N: XIC(Run)OTU(<<Reset>>);\n")
}

/// Writes of such tags.
pub(crate) fn check(project: &Project, findings: &mut Findings) {
    let mapped: Map<_, _> = project.map.iter().map(|line| (line.safety, line.span)).collect();
    let any = !mapped.is_empty()
        || project.tags.iter().any(|tag| tag.constant || matches!(tag.kind, TagKind::Consumed))
        || project.add_ons.iter().any(|add_on| add_on.parameters.iter().any(|parameter| parameter.constant));
    if !any {
        return;
    }
    usage::accesses(project, &mut |access| {
        if !access.writes {
            return;
        }
        if let (crate::operand::LocationBase::InOut(parameter), Some(owner)) = (access.reference.location.base, access.owner)
        {
            let parameter = &project.add_on(owner).parameters[usize::from(parameter)];
            if parameter.constant {
                let message = format!("the parameter `{}` is constant and is written", parameter.name);
                let finding = Finding::new(&CODE, access.span, message).label(parameter.span, "declared here");
                findings.push(finding.help("take Constant away, or work on a copy"));
            }
        }
        // The alias may be constant as well as what it designates.
        let root = match access.reference.root {
            crate::operand::Root::Tag(tag) => Some(tag),
            _ => None,
        };
        let Some(id) = access.reference.base_tag() else { return };
        let tag = project.tag(id);
        let constant = tag.constant || root.is_some_and(|root| project.tag(root).constant);
        let finding = if let Some(span) = mapped.get(&id) {
            Finding::new(&CODE, access.span, format!("`{}` receives a standard tag and is written by logic", tag.name))
                .label(*span, "mapped here")
                .help("write another safety tag; the map overwrites this one at the start of every scan")
        } else if matches!(tag.kind, TagKind::Consumed) {
            Finding::new(&CODE, access.span, format!("`{}` is consumed from another controller and written by logic", tag.name))
                .label(tag.span, "declared here")
                .help("write another safety tag")
        } else if constant {
            Finding::new(&CODE, access.span, format!("`{}` is constant and written by logic", tag.name))
                .label(tag.span, "declared here")
                .help("take Constant away, or write another tag")
        } else {
            return;
        };
        findings.push(finding);
    });
}
