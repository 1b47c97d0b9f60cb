//! The safety tag map, from the controller's SafetyTagMap and from `MappedFrom`.

use twinrung_grammar::tree::{CompactString, Span};

use super::Inputs;
use crate::diagnostic::Findings;
use crate::names::Map;
use crate::operand::Scope;
use crate::project::names_in_scope::{Found, ScopeNames};
use crate::project::{MapLine, Tag, TagId};
use crate::rules::tag_map;

/// The lines of the map that hold.
pub(super) fn build(inputs: &Inputs<'_>, tags: &[Tag], names: &ScopeNames, findings: &mut Findings) -> Vec<MapLine> {
    let mut lines = Vec::new();
    let mut receives: Map<TagId, Span> = Map::default();
    let mut add = |standard: &CompactString, safety: Found, span: Span, findings: &mut Findings| {
        let receiver = &tags[safety.tag.position()];
        let source = names.find(Scope::Controller, standard).map(|found| &tags[found.tag.position()]);
        if let Some(finding) = tag_map::finding(standard, source, receiver, span) {
            findings.push(finding);
            return;
        }
        if let Some(first) = receives.insert(safety.tag, span) {
            findings.push(tag_map::twice(receiver, first, span));
            return;
        }
        let standard = source.map_or_else(|| standard.clone(), |tag| tag.name.clone());
        lines.push(MapLine { standard, safety: safety.tag, span });
    };
    let safety = inputs.file.controller.as_ref().and_then(|controller| controller.safety.as_ref());
    for entry in safety.iter().flat_map(|safety| &safety.tag_map) {
        match names.find(Scope::Controller, entry.safety.as_str()) {
            Some(found) => add(&entry.standard.text, found, entry.span, findings),
            None => findings.push(tag_map::unknown(entry.safety.as_str(), entry.safety.span)),
        }
    }
    for (position, tag) in tags.iter().enumerate() {
        if let Some((standard, span)) = &tag.mapped_from {
            let found = Found { tag: TagId(position as u32), by_slot: false };
            add(standard, found, *span, findings);
        }
    }
    lines
}
