//! Names of the controller, its tasks and modules, and of what the tag map reads: an image writes them all, and the loader
//! refuses what no component can be called. Tags, programs and routines are judged where they are declared.

use twinrung_bytecode::names;
use twinrung_grammar::tree::Span;

use crate::diagnostic::{BAD_NAME, Finding, Findings};
use crate::names::name_fault;
use crate::operand::Operand;
use crate::project::{Project, TagClass};

/// Reports every name that cannot be written.
pub(super) fn check(project: &Project, findings: &mut Findings) {
    let controller = (project.name.as_str(), project.span);
    let tasks = project.tasks.iter().filter(|task| task.class == TagClass::Safety);
    let tasks = tasks.map(|task| (task.name.as_str(), task.span));
    // Of the standard tasks those that EVENT names come into the image.
    let events = project.operands.iter().filter_map(|operand| match operand {
        Operand::EventTask(name) => {
            let span = project.tasks.iter().find(|task| task.name == *name).map_or(project.span, |task| task.span);
            Some((name.as_str(), span))
        }
        _ => None,
    });
    let components = std::iter::once(controller).filter(|(name, _)| !name.is_empty()).chain(tasks);
    for (name, span) in components.chain(events) {
        if let Some(fault) = name_fault(name) {
            findings.push(finding(name, span, fault));
        }
    }
    for module in project.modules.iter().filter(|module| module.safety && !names::is_module_name(&module.name)) {
        findings.push(finding(&module.name, module.span, "a module's name holds letters, digits and underscores only"));
    }
    for line in project.map.iter().filter(|line| !names::is_tag_path(&line.standard)) {
        findings.push(finding(&line.standard, line.span, "the map reads a tag, or a member or element of one"));
    }
}

fn finding(name: &str, span: Span, fault: &str) -> Finding {
    Finding::new(&BAD_NAME, span, format!("`{name}` is no name: {fault}"))
}
