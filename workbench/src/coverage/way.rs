//! The way to what is missing: positions of the other conditions of a rung in which one of them decides.

use twinrung_bytecode::operand::Reference;

use super::decide::{Seen, decided};
use super::shape::{Condition, Element, Rung};

/// Conditions of a rung whose positions are tried: 2 to this power are looked at.
const CONDITIONS_MAX: usize = 14;

/// Something that is on or off, and the conditions that follow it.
struct Variable {
    name: String,
    /// The cell, where it is a bit.
    bit: Option<Reference>,
    /// Positions of the conditions, and whether they pass while it is on.
    conditions: Vec<(usize, bool)>,
}

/// What must be on and off so that a condition decides in a position; says so where nothing does it.
pub fn way(rung: &Rung, position: u32, passes: bool) -> String {
    let variables = variables(rung);
    if variables.len() > CONDITIONS_MAX {
        return "let power reach it and let it alone decide whether power goes on".to_owned();
    }
    let mut tried: Vec<u32> = (0..1_u32 << variables.len()).collect();
    tried.sort_by_key(|mask| mask.count_ones());
    let found = tried.into_iter().find(|mask| decides(rung, &variables, *mask, position, passes));
    match found {
        Some(mask) => {
            let settings =
                variables.iter().enumerate().map(|(index, variable)| setting(variable, (mask >> index) & 1 == 1));
            settings.collect::<Vec<_>>().join(", ")
        }
        None => "no position of the other contacts lets it decide: it is redundant here".to_owned(),
    }
}

fn setting(variable: &Variable, on: bool) -> String {
    match &variable.bit {
        Some(_) => format!("{} is {}", variable.name, if on { "on" } else { "off" }),
        None => format!("{} {}", variable.name, if on { "true" } else { "false" }),
    }
}

fn variables(rung: &Rung) -> Vec<Variable> {
    let mut found: Vec<Variable> = Vec::new();
    for (position, (element, name)) in rung.elements.iter().zip(&rung.names).enumerate() {
        let Element::Condition(condition) = element else { continue };
        match condition {
            Condition::Contact(reference, closed) => {
                let same =
                    found.iter_mut().find(|one| one.bit.as_ref().is_some_and(|bit| bit.access == reference.access));
                match same {
                    Some(variable) => variable.conditions.push((position, *closed)),
                    None => found.push(Variable {
                        name: operand(name).to_owned(),
                        bit: Some(reference.clone()),
                        conditions: vec![(position, *closed)],
                    }),
                }
            }
            _ => found.push(Variable { name: name.clone(), bit: None, conditions: vec![(position, true)] }),
        }
    }
    found
}

/// The first operand of an instruction's text.
fn operand(text: &str) -> &str {
    text.split_once('(').map_or(text, |(_, rest)| rest.strip_suffix(')').unwrap_or(rest))
}

fn decides(rung: &Rung, variables: &[Variable], mask: u32, position: u32, passes: bool) -> bool {
    let mut seen = vec![Seen { reached: None, passes: Some(true) }; rung.elements.len()];
    for (index, variable) in variables.iter().enumerate() {
        let on = (mask >> index) & 1 == 1;
        for (at, passes_when_on) in &variable.conditions {
            seen[*at].passes = Some(on == *passes_when_on);
        }
    }
    if let Some(first) = seen.first_mut() {
        first.reached = Some(true);
    }
    decided(rung, &seen).conditions.contains(&(position, passes))
}
