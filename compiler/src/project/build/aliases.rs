//! Aliases: resolved along their chains, each once.

use twinrung_grammar::tree;

use crate::diagnostic::{BAD_ALIAS, Finding, Findings, OVER_LIMIT};
use crate::names::{Map, Set};
use crate::operand::{Scope, alias_target};
use crate::project::names_in_scope::ScopeNames;
use crate::project::reading::{Context, Refusal, RoutineNames};
use crate::project::tag::AliasTarget;
use crate::project::tags::settle_alias;
use crate::project::{AddOn, Profile, Tag, TagClass, TagId, TagScope, Types};
use crate::rules;

/// Aliases that lead to each other: walkers of a chain may recurse this deep.
const CHAIN_MAX: usize = 32;

/// What aliases are resolved against.
pub(super) struct Surroundings<'a> {
    pub types: &'a Types,
    pub names: &'a ScopeNames,
    pub add_ons: &'a [AddOn],
    pub profile: Option<&'a Profile>,
    pub routine_names: &'a RoutineNames,
}

fn scope_of(tag: &Tag) -> Scope {
    match tag.scope {
        TagScope::Program(program) => Scope::Program(program),
        TagScope::Controller | TagScope::StandardProgram(_) => Scope::Controller,
    }
}

/// The tag that an alias's operand begins with.
fn begins_with(surroundings: &Surroundings<'_>, tag: &Tag, operand: &tree::Operand) -> Option<TagId> {
    let end = operand.text.find(['.', '[']).unwrap_or(operand.text.len());
    let name = operand.text[..end].trim();
    let found = match tag.scope {
        TagScope::StandardProgram(program) => surroundings.names.find_in_standard(program as usize, name),
        _ => surroundings.names.find(scope_of(tag), name),
    };
    found.map(|found| found.tag)
}

/// Resolves every alias. Those that lead nowhere keep the reason for whoever uses them.
pub(super) fn resolve(
    pending: &[(TagId, &tree::Operand)],
    tags: &mut [Tag],
    surroundings: &Surroundings<'_>,
    slot_names: &mut Set<TagId>,
    findings: &mut Findings,
) {
    let operands: Map<TagId, &tree::Operand> = pending.iter().copied().collect();
    let mut done: Set<TagId> = Set::default();
    let mut depths: Map<TagId, usize> = Map::default();
    for (first, _) in pending {
        // The chain from this alias to the first tag that is none, or is resolved.
        let mut chain: Vec<TagId> = Vec::new();
        let mut in_chain: Set<TagId> = Set::default();
        let mut next = Some(*first);
        while let Some(id) = next {
            let Some(operand) = operands.get(&id).filter(|_| !done.contains(&id)) else { break };
            if !in_chain.insert(id) {
                let message = format!("the alias `{}` leads back to itself", tags[id.position()].name);
                findings.push(Finding::new(&BAD_ALIAS, operand.span, message).help("name a tag that is no alias"));
                // Reported: nobody who uses one of them says more about it.
                for id in chain.drain(..) {
                    tags[id.position()].class = TagClass::Safety;
                    done.insert(id);
                }
                break;
            }
            chain.push(id);
            next = begins_with(surroundings, &tags[id.position()], operand);
        }
        for id in chain.into_iter().rev() {
            if done.insert(id)
                && let Some(operand) = operands.get(&id)
            {
                let target = begins_with(surroundings, &tags[id.position()], operand);
                let depth = target.and_then(|target| depths.get(&target)).map_or(1, |depth| depth + 1);
                depths.insert(id, depth);
                if depth > CHAIN_MAX {
                    let message = format!("more than {CHAIN_MAX} aliases lead to each other");
                    findings.push(Finding::new(&OVER_LIMIT, operand.span, message));
                    tags[id.position()].class = TagClass::Safety;
                    continue;
                }
                resolve_one(id, operand, tags, surroundings, slot_names, findings);
            }
        }
    }
}

fn resolve_one(
    id: TagId,
    operand: &tree::Operand,
    tags: &mut [Tag],
    surroundings: &Surroundings<'_>,
    slot_names: &mut Set<TagId>,
    findings: &mut Findings,
) {
    let tag = &tags[id.position()];
    let target_id = begins_with(surroundings, tag, operand);
    let target_class = target_id.map(|target| tags[target.position()].class);
    match (tag.explicit_class, target_class) {
        (Some((own, span)), Some(target)) if own != target => {
            let target = target_id.map(|target| &tags[target.position()]);
            findings.push(rules::alias_across_classes::finding(tag, own, span, target, operand.span));
            tags[id.position()].class = TagClass::Safety;
            return;
        }
        _ => {}
    }
    match target_class {
        Some(TagClass::Standard) => {
            tags[id.position()].class = TagClass::Standard;
            return;
        }
        Some(TagClass::Safety) | None => {}
    }
    let event_tasks = [];
    let outcome = {
        let context = Context::new(
            surroundings.types,
            tags,
            surroundings.names,
            surroundings.add_ons,
            surroundings.profile,
            surroundings.routine_names,
            &event_tasks,
            &event_tasks,
        );
        let outcome = alias_target(&context, scope_of(tag), operand);
        slot_names.extend(context.into_slot_names());
        outcome
    };
    let explicit_safety = tag.explicit_class.is_some_and(|(class, _)| class == TagClass::Safety);
    let in_safety_program = matches!(tag.scope, TagScope::Program(_));
    let tag = &mut tags[id.position()];
    // A standard tag whose target is out of reach is nobody's business here, unless safety logic uses it.
    tag.class = TagClass::Safety;
    match outcome {
        Ok((reference, walk)) => settle_alias(tag, AliasTarget { reference, walk }),
        Err(Refusal::Reported) => {}
        Err(Refusal::Finding(finding)) if explicit_safety || in_safety_program => findings.push(*finding),
        Err(Refusal::Finding(finding)) => tag.fault = Some(finding),
    }
}
