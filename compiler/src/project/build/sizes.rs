//! Counts that an image limits and that no declaration is too many for by itself.

use twinrung_bytecode::limits;
use twinrung_grammar::tree::Span;

use crate::diagnostic::{Finding, Findings, OVER_LIMIT};
use crate::project::{Project, TagClass};

/// Reports each count beyond its limit at the first declaration that is too many.
pub(super) fn check(project: &Project, findings: &mut Findings) {
    let tags = project.tags.iter().filter(|tag| tag.class == TagClass::Safety).map(|tag| tag.span);
    beyond(tags, limits::TAGS, "safety tags", findings);
    let modules = project.modules.iter().filter(|module| module.safety).map(|module| module.span);
    beyond(modules, limits::MODULES, "safety modules", findings);
    beyond(project.map.iter().map(|line| line.span), limits::MAP_LINES, "lines of the tag map", findings);
    if project.event_tasks.len() > limits::EVENT_TASKS {
        let message = format!("there are more than {} event tasks", limits::EVENT_TASKS);
        findings.push(Finding::new(&OVER_LIMIT, project.span, message));
    }
    let of_tags = project.tags.iter().map(|tag| (tag.attributes.len(), tag.span));
    let of_add_ons = project.add_ons.iter().map(|add_on| (add_on.attributes.len(), add_on.span));
    for (_, span) in of_tags.chain(of_add_ons).filter(|(count, _)| *count > limits::ATTRIBUTES) {
        let message = format!("a declaration has at most {} settings", limits::ATTRIBUTES);
        findings.push(Finding::new(&OVER_LIMIT, span, message));
    }
}

fn beyond(places: impl Iterator<Item = Span>, limit: usize, what: &str, findings: &mut Findings) {
    if let Some(place) = places.into_iter().nth(limit) {
        findings.push(Finding::new(&OVER_LIMIT, place, format!("there are more than {limit} {what}")));
    }
}
