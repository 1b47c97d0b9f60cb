//! Rungs with a safety application instruction: operands that the stimulus moves as devices move, that other logic writes, or
//! that follow the instruction's own output.

use twinrung_catalog::instructions::ALL;
use twinrung_catalog::{Element, Instruction, OperandKind, PredefinedType};

use super::data::{Kind, Place, Role, Variable};
use super::program::IN_OUT;
use super::safety::{Call, Given, element, value_text};
use super::writer::Writer;
use super::{Actor, Driven};

impl Writer<'_> {
    /// A rung with a safety application instruction, and one for each feedback that follows its output.
    pub fn guard(&mut self, rungs: &mut Vec<String>) {
        let passed = self.passed_backing();
        let fits = |one: &&Instruction| match (one.safety, &passed) {
            (Some(safety), Some((_, backing))) => safety.backing == *backing,
            (safety, _) => safety.is_some(),
        };
        let all: Vec<&'static Instruction> = ALL.iter().copied().filter(fits).collect();
        if all.is_empty() {
            return;
        }
        let instruction = *self.random.of(&all);
        let Some(safety) = instruction.safety else { return };
        let call = Call::random(self.random, instruction);
        let Own { text: backing, base } = match passed {
            Some((name, _)) => Own { base: name.clone(), text: name },
            None => self.backing(safety.backing),
        };
        // Operands that other logic writes, all of them or none: a device is rarely half simulated.
        let shared = self.scope.is_none() || self.random.percent(20);
        let has_output = safety.backing.members.iter().any(|member| member.name == "O1");
        let mut actor = Actor { call: call.clone(), tags: vec![None; call.operands.len()] };
        let mut operands = vec![backing.clone()];
        for (index, given) in call.operands.iter().enumerate() {
            let text = match *given {
                Given::Literal(value) if call.is_real(index) => value_text(call.kind(index), value),
                Given::Literal(value) => value.to_string(),
                Given::Tag if has_output && call.member(index).starts_with("Feedback") && self.random.percent(40) => {
                    let tag = self.declare(call.member(index), Kind::Element(Element::Bool), Role::Owned);
                    let contact = if call.literal("FeedbackType") == Some(1) { "XIC" } else { "XIO" };
                    let between = if self.random.percent(20) { self.input() } else { String::new() };
                    rungs.push(format!("{contact}({backing}.O1){between}OTE({tag})"));
                    tag
                }
                Given::Tag => match shared.then(|| self.shared_operand(call.kind(index), &operands, &base)).flatten() {
                    Some(text) => text,
                    None => {
                        let (tag, element) = self.driven_operand(&call, index);
                        let full = |scope: &String| Driven { name: format!("{scope}{tag}"), element };
                        actor.tags[index] = self.scope.as_ref().map(full);
                        tag
                    }
                },
            };
            operands.push(text);
        }
        let condition = if self.random.percent(30) { self.input() } else { String::new() };
        let after = if self.random.percent(15) { self.output() } else { String::new() };
        let call = format!("{condition}{}({}){after}", instruction.mnemonic, operands.join(","));
        // A feedback may be written before the call or after it: the call sees it in the same scan, or in the next.
        let at = if self.random.percent(50) { rungs.len() } else { 0 };
        rungs.insert(at.max(rungs.len().saturating_sub(1)), call);
        if self.scope.is_some() {
            self.actors.push(actor);
        }
    }

    /// A backing tag that the Add-On Instruction is given, once.
    fn passed_backing(&mut self) -> Option<(String, &'static PredefinedType)> {
        let is_backing = |one: &Variable| matches!(one.kind, Kind::Backing(_)) && one.name.starts_with(IN_OUT);
        let free = |one: &&Variable| is_backing(one) && !self.passed_backings.contains(&one.name);
        let found = self.own.variables.iter().find(free).cloned()?;
        let Kind::Backing(backing) = found.kind else { return None };
        self.passed_backings.push(found.name.clone());
        Some((found.name, backing))
    }

    /// A backing tag that no other call has.
    fn backing(&mut self, backing: &'static PredefinedType) -> Own {
        let kind = Kind::Backing(backing);
        let name = |writer: &mut Self, prefix: &str| {
            writer.fresh += 1;
            format!("{prefix}{}", writer.fresh)
        };
        let holder = self.shared.records.iter().position(|record| record.name == format!("Holder_{}", backing.name));
        match (self.random.below(10), holder) {
            (0, _) => {
                let base = name(self, "Guards");
                let variable = Variable::new(base.clone(), kind).array([3, 0, 0]).role(Role::Owned);
                self.own.add(variable, &self.shared.records);
                Own { text: format!("{base}[{}]", self.random.below(3)), base }
            }
            (1, Some(holder)) => {
                let base = self.declare("Holder", Kind::Record(holder), Role::Owned);
                Own { text: format!("{base}.Held"), base }
            }
            (2, _) if self.scope.is_some() => {
                let base = self.declare("Guard", kind, Role::Owned);
                let text = name(self, "Alias");
                let variable = Variable::new(text.clone(), kind).role(Role::Owned);
                self.own.add(Variable { alias: Some(base.clone()), ..variable }, &self.shared.records);
                Own { text, base }
            }
            _ => {
                let base = self.declare("Guard", kind, Role::Owned);
                Own { text: base.clone(), base }
            }
        }
    }

    /// Data that other logic writes too, reached in any way; none where nothing fits. Channels of one device are different
    /// tags, so it is none of those that stand before.
    fn shared_operand(&mut self, kind: OperandKind, before: &[String], own: &str) -> Option<String> {
        let element = element(kind);
        if element == Element::Bool && self.random.percent(30) {
            return self.bit_of_word(false, own).filter(|text| self.is_apart(text, before));
        }
        // Not the call's own backing tag, which stands first.
        let fits = |place: &Place| {
            let alike = match element {
                Element::Dint => place.kind.is_integer(),
                element => place.kind == Kind::Element(element),
            };
            alike && !place.is_array() && place.base != own
        };
        self.wished_place(fits).map(|named| named.text).filter(|text| self.is_apart(text, before))
    }

    /// Whether an operand is none of those that stand before it, under another name or by another subscript either.
    fn is_apart(&self, text: &str, before: &[String]) -> bool {
        let meant = self.meant(text);
        before.iter().all(|other| self.meant(other) != meant)
    }

    /// An operand with what an alias stands for in the place of the alias, and variable subscripts left out.
    fn meant(&self, text: &str) -> String {
        let end = text.find(['.', '[']).unwrap_or(text.len());
        let (base, rest) = text.split_at(end);
        let mut variables = self.own.variables.iter().chain(&self.outer.variables);
        let target = variables.find(|one| one.name == base).and_then(|one| one.alias.as_deref()).unwrap_or(base);
        let whole = format!("{target}{rest}");
        let constant = |part: &&str| !part.split(']').next().is_some_and(|inner| inner.contains(char::is_alphabetic));
        let (first, others) = whole.split_once('[').unwrap_or((&whole, ""));
        others.split('[').fold(first.to_owned(), |kept, part| {
            let shown = if constant(&part) { part } else { part.split_once(']').map_or("", |(_, after)| after) };
            format!("{kept}[{shown}")
        })
    }

    /// A tag of its own.
    fn driven_operand(&mut self, call: &Call, index: usize) -> (String, Element) {
        let element = match element(call.kind(index)) {
            Element::Dint => {
                *self.random.of(&[Element::Dint, Element::Dint, Element::Dint, Element::Int, Element::Sint])
            }
            element => element,
        };
        let prefix = Some(call.member(index)).filter(|member| !member.is_empty()).unwrap_or("Operand");
        (self.declare(&format!("{prefix}_"), Kind::Element(element), Role::Owned), element)
    }
}

/// A backing tag as a call names it, and the tag that it lies in: no operand of the call may lie there too.
struct Own {
    text: String,
    base: String,
}
