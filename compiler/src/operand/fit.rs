//! Reading an operand as its declaration says.

use twinrung_bytecode::image::TypeReference;
use twinrung_bytecode::{format, limits};
use twinrung_catalog::{Access, Element, OperandKind};
use twinrung_grammar::tree::{self, Span};

use super::expression::{self, ExpressionKind};
use super::reference::{Reference, Shape};
use super::resolve::{self, describe_reference};
use super::special::{choice, constant_length, pseudo, routine, system_data};
use super::{Literal, Operand, literal_of, system};
use crate::diagnostic::{
    BROKEN_OPERAND, Finding, OPERAND_TYPE, UNKNOWN_CHOICE, UNKNOWN_EVENT_TASK, UNKNOWN_LABEL, VALUE_RANGE,
};
use crate::names::{closest, fold};
use crate::project::reading::{Refusal, RungReader};
use crate::project::{OperandId, OperandUse};

/// Reads one operand; `before` holds those before it in the same instruction.
pub(crate) fn operand(
    reader: &mut RungReader<'_, '_>,
    kind: OperandKind,
    name: &'static str,
    shown: &tree::Operand,
    before: &[OperandUse],
) -> Result<OperandId, Refusal> {
    let scope = reader.scope;
    let simple = |reader: &mut RungReader<'_, '_>, operand: Operand| Ok(reader.operands.add(operand));
    match kind {
        OperandKind::Bit(access) => {
            if access == Access::Read
                && let Some(keyword) = status_keyword(&shown.text)
            {
                return simple(reader, Operand::Status(keyword));
            }
            let id = reference_operand(reader, shown, access.writes())?;
            check(reader, id, name, shown.span, "a BOOL or a bit of an integer", is_bit)
        }
        OperandKind::Number(access) => {
            if access == Access::Read
                && let Some(id) = literal_operand(reader, shown)?
            {
                return Ok(id);
            }
            let id = reference_operand(reader, shown, access.writes())?;
            check(reader, id, name, shown.span, "SINT, INT, DINT or REAL", is_word)
        }
        OperandKind::Integer(access) => {
            if access == Access::Read
                && let Some(id) = literal_operand(reader, shown)?
            {
                return integer_literal(reader, id, shown.span, name);
            }
            let id = reference_operand(reader, shown, access.writes())?;
            check(reader, id, name, shown.span, "SINT, INT or DINT", is_integer)
        }
        OperandKind::Structure(wanted, access) => {
            let id = reference_operand(reader, shown, access.writes())?;
            let reference = reader.reference(id);
            let fits = reference.is_some_and(|reference| {
                reference.dimensions == [0; 3]
                    && reader
                        .context
                        .types
                        .predefined(reference.type_reference)
                        .is_some_and(|known| known.name == wanted.name)
            });
            if fits {
                Ok(id)
            } else {
                Err(wrong_type(reader, id, name, shown.span, &format!("a tag of type {}", wanted.name)))
            }
        }
        OperandKind::Resettable => {
            let id = reference_operand(reader, shown, true)?;
            let fits = reader.reference(id).is_some_and(|reference| {
                reference.dimensions == [0; 3]
                    && reader
                        .context
                        .types
                        .predefined(reference.type_reference)
                        .is_some_and(|known| matches!(known.name, "TIMER" | "COUNTER" | "CONTROL"))
            });
            if fits { Ok(id) } else { Err(wrong_type(reader, id, name, shown.span, "a TIMER, COUNTER or CONTROL")) }
        }
        OperandKind::Pseudo(member) => pseudo(reader, member, shown),
        OperandKind::CopySource | OperandKind::CopyDestination => {
            let id = reference_operand(reader, shown, kind == OperandKind::CopyDestination)?;
            let fits = |reference: &Reference| {
                matches!(reference.shape(), Shape::Word | Shape::Region)
                    && reference.type_reference != TypeReference::Element(Element::Bool)
            };
            check(reader, id, name, shown.span, "a number, a structure, or an array of either", fits)
        }
        OperandKind::FillDestination => {
            let id = reference_operand(reader, shown, true)?;
            let fits = |reference: &Reference| match reference.type_reference {
                TypeReference::Element(element) => {
                    element != Element::Bool && matches!(reference.shape(), Shape::Word | Shape::Region)
                }
                TypeReference::Structure(_) => false,
            };
            check(reader, id, name, shown.span, "a number or an array of numbers", fits)
        }
        OperandKind::ConstantLength => constant_length(reader, shown),
        OperandKind::Expression => {
            let expression = expression::read(reader.context, scope, shown, ExpressionKind::Value)?;
            simple(reader, Operand::Expression(expression))
        }
        OperandKind::Condition => {
            let expression = expression::read(reader.context, scope, shown, ExpressionKind::Condition)?;
            simple(reader, Operand::Expression(expression))
        }
        OperandKind::FileMode => {
            let mode = if shown.text.eq_ignore_ascii_case("ALL") {
                0
            } else if shown.text.eq_ignore_ascii_case("INC") {
                -1
            } else {
                match shown.text.parse::<i32>() {
                    Ok(number) if number > 0 => number,
                    _ => {
                        let message = format!("{name} is ALL, INC or a positive number, not `{}`", shown.text);
                        return Err(Finding::new(&UNKNOWN_CHOICE, shown.span, message).into());
                    }
                }
            };
            simple(reader, Operand::Choice(mode))
        }
        OperandKind::ByteOrder => {
            let order = match shown.text.to_ascii_uppercase().as_str() {
                "REVERSE" => 0,
                "WORD" => 1,
                "HIGH/LOW" | "HIGHLOW" | "HIGH_LOW" => 2,
                _ => {
                    let message = format!("{name} is REVERSE, WORD or HIGH/LOW, not `{}`", shown.text);
                    return Err(Finding::new(&UNKNOWN_CHOICE, shown.span, message).into());
                }
            };
            simple(reader, Operand::Choice(order))
        }
        OperandKind::Array => {
            let id = reference_operand(reader, shown, false)?;
            let array = |reference: &Reference| {
                reference.dimensions != [0; 3] || matches!(reference.steps.last(), Some(super::Step::Subscript(_)))
            };
            check(reader, id, name, shown.span, "an array or an element of one", array)
        }
        OperandKind::Dimension => {
            let id = integer_only(reader, shown, name)?;
            in_range(reader, id, 0, 2, shown.span, name)
        }
        OperandKind::Label | OperandKind::LabelDefinition => {
            if let Some(fault) = crate::names::name_fault(&shown.text) {
                let message = format!("`{}` is no label: {fault}", shown.text);
                return Err(Finding::new(&BROKEN_OPERAND, shown.span, message).into());
            }
            let known = reader.labels.get(&fold(&shown.text)).map(|(spelled, _)| spelled.clone());
            match known {
                Some(spelled) => simple(reader, Operand::Text(spelled)),
                // A label that is not the first of its rung is reported as such.
                None if kind == OperandKind::LabelDefinition => simple(reader, Operand::Text(shown.text.clone())),
                None => {
                    let message = format!("the routine has no label `{}`", shown.text);
                    let finding = Finding::new(&UNKNOWN_LABEL, shown.span, message);
                    let names = reader.labels.values().map(|(spelled, _)| spelled.as_str());
                    Err(match closest(&shown.text, names) {
                        Some(like) => finding.help(format!("did you mean `{like}`?")),
                        None => finding.help("begin the rung that is meant with LBL"),
                    }
                    .into())
                }
            }
        }
        OperandKind::Routine => routine(reader, shown),
        OperandKind::InputCount => {
            let id = integer_only(reader, shown, name)?;
            in_range(reader, id, 0, limits::JSR_PARAMETERS as i32, shown.span, name)
        }
        OperandKind::Parameter(access) => {
            if access == Access::Read
                && let Some(id) = literal_operand(reader, shown)?
            {
                return Ok(id);
            }
            let id = reference_operand(reader, shown, access.writes())?;
            check(reader, id, name, shown.span, "a BOOL, a number or a structure", |_| true)
        }
        OperandKind::EventTask => {
            let found = reader.context.event_tasks.iter().find(|task| task.eq_ignore_ascii_case(&shown.text));
            match found.cloned() {
                Some(task) => simple(reader, Operand::EventTask(task)),
                None => {
                    let message = format!("no standard task of type EVENT is named `{}`", shown.text);
                    Err(Finding::new(&UNKNOWN_EVENT_TASK, shown.span, message)
                        .help("declare the task, or name one that exists")
                        .into())
                }
            }
        }
        OperandKind::SystemClass => {
            let class = system::class(shown)?;
            simple(reader, class)
        }
        OperandKind::SystemInstance => {
            let class = reader.text_of(before, 0);
            let instance = system::instance(reader.context, scope, &class, shown)?;
            simple(reader, instance)
        }
        OperandKind::SystemAttribute => {
            let (class, instance) = (reader.text_of(before, 0), reader.text_of(before, 1));
            let value = system::attribute(reader.context, scope, &class, &instance, shown, reader.sets_system_value)?;
            simple(reader, value)
        }
        OperandKind::SystemData(access) => system_data(reader, access, name, shown, before),
        OperandKind::Choice(list) => choice(reader, list, shown),
        OperandKind::Literal { or_zero, least, greatest, step, unit } => {
            let id = integer_only(reader, shown, name)?;
            let value = reader.integer(id);
            let fits = value.is_some_and(|value| {
                (or_zero && value == 0) || ((least..=greatest).contains(&value) && value.rem_euclid(step.max(1)) == 0)
            });
            if fits {
                return Ok(id);
            }
            let zero = if or_zero { "0 or " } else { "" };
            let steps = if step > 1 { format!(" in steps of {step}") } else { String::new() };
            let unit = if unit.is_empty() { String::new() } else { format!(" {unit}") };
            let message = format!("{name} is {}: it must be {zero}{least} to {greatest}{unit}{steps}", shown.text);
            Err(Finding::new(&VALUE_RANGE, shown.span, message).help("write a value in that range; `twinrung explain` of the instruction lists the range of every operand").into())
        }
        OperandKind::SafetyBit { immediate } => {
            if let Some(id) = literal_operand(reader, shown)? {
                if immediate && matches!(reader.integer(id), Some(0 | 1)) {
                    return Ok(id);
                }
                let wanted = if immediate { "a BOOL tag, 0 or 1" } else { "a BOOL tag" };
                let message = format!("{name} takes {wanted}, not {}", shown.text);
                return Err(Finding::new(&OPERAND_TYPE, shown.span, message).into());
            }
            let id = reference_operand(reader, shown, false)?;
            check(reader, id, name, shown.span, "a BOOL or a bit of an integer", is_bit)
        }
        OperandKind::SafetyInteger { immediate, unit } => {
            if let Some(id) = literal_operand(reader, shown)? {
                let value = reader.integer(id);
                return match (immediate, value) {
                    (Some((least, greatest)), Some(value)) if (least..=greatest).contains(&value) => Ok(id),
                    (Some((least, greatest)), _) => {
                        let unit = if unit.is_empty() { String::new() } else { format!(" {unit}") };
                        let message = format!("{name} is {}: it must be {least} to {greatest}{unit}", shown.text);
                        Err(Finding::new(&VALUE_RANGE, shown.span, message).into())
                    }
                    (None, _) => {
                        let message = format!("{name} takes a tag, not {}", shown.text);
                        Err(Finding::new(&OPERAND_TYPE, shown.span, message).into())
                    }
                };
            }
            let id = reference_operand(reader, shown, false)?;
            check(reader, id, name, shown.span, "SINT, INT or DINT", is_integer)
        }
        OperandKind::SafetyReal { immediate, not_negative } => {
            if let Some(id) = literal_operand(reader, shown)? {
                let value = match reader.operands.table[id.position()] {
                    Operand::Real(bits) => f32::from_bits(bits),
                    Operand::Integer { value, .. } => value as f32,
                    _ => 0.0,
                };
                if !immediate {
                    let message = format!("{name} takes a tag, not {}", shown.text);
                    return Err(Finding::new(&OPERAND_TYPE, shown.span, message).into());
                }
                if not_negative && value < 0.0 {
                    let message = format!("{name} is {}: it must not be negative", shown.text);
                    return Err(Finding::new(&VALUE_RANGE, shown.span, message).into());
                }
                return Ok(reader.operands.add(Operand::Real(value.to_bits())));
            }
            let id = reference_operand(reader, shown, false)?;
            let real =
                |reference: &Reference| reference.shape() == Shape::Word && reference.element() == Some(Element::Real);
            check(reader, id, name, shown.span, "REAL", real)
        }
    }
}

impl RungReader<'_, '_> {
    pub(super) fn reference(&self, id: OperandId) -> Option<&Reference> {
        self.operands.table.get(id.position()).and_then(Operand::reference)
    }

    pub(super) fn integer(&self, id: OperandId) -> Option<i32> {
        match self.operands.table.get(id.position()) {
            Some(Operand::Integer { value, .. }) => Some(*value),
            _ => None,
        }
    }

    fn text_of(&self, before: &[OperandUse], position: usize) -> tree::CompactString {
        match before.get(position).map(|one| &self.operands.table[one.id.position()]) {
            Some(Operand::Text(text)) => text.clone(),
            _ => tree::CompactString::default(),
        }
    }
}

/// The operand as a reference: from the texts that were read before, or resolved.
pub(super) fn reference_operand(
    reader: &mut RungReader<'_, '_>,
    shown: &tree::Operand,
    writes: bool,
) -> Result<OperandId, Refusal> {
    if let Some(id) = reader.operands.known_reference(&shown.text) {
        return Ok(id);
    }
    if let Some(keyword) = status_keyword(&shown.text) {
        let message = format!("{} can only be examined", format::STATUS_KEYWORDS[usize::from(keyword)]);
        return Err(Finding::new(&OPERAND_TYPE, shown.span, message).into());
    }
    let reference = resolve::reference(reader.context, reader.scope, shown, writes)?;
    Ok(reader.operands.add_reference(&shown.text, reference))
}

/// The operand as a literal, when it begins like one.
pub(super) fn literal_operand(
    reader: &mut RungReader<'_, '_>,
    shown: &tree::Operand,
) -> Result<Option<OperandId>, Refusal> {
    let begins = shown.text.as_bytes().first();
    if !begins.is_some_and(|byte| byte.is_ascii_digit() || matches!(byte, b'-' | b'+' | b'\'' | b'.')) {
        return Ok(None);
    }
    if let Some(id) = reader.operands.known_literal(&shown.text) {
        return Ok(Some(id));
    }
    let immediate = twinrung_grammar::read_immediate(shown).map_err(|error| Refusal::from(&error))?;
    let operand = match literal_of(&immediate)? {
        Literal::Integer { value, radix } => Operand::Integer { value, radix },
        Literal::Real(bits) => {
            reader.context.require_real(shown.span)?;
            Operand::Real(bits)
        }
    };
    Ok(Some(reader.operands.add_literal(&shown.text, operand)))
}

fn integer_literal(reader: &RungReader<'_, '_>, id: OperandId, span: Span, name: &str) -> Result<OperandId, Refusal> {
    match reader.integer(id) {
        Some(_) => Ok(id),
        None => Err(Finding::new(&OPERAND_TYPE, span, format!("{name} takes an integer")).into()),
    }
}

pub(super) fn integer_only(
    reader: &mut RungReader<'_, '_>,
    shown: &tree::Operand,
    name: &str,
) -> Result<OperandId, Refusal> {
    match literal_operand(reader, shown)? {
        Some(id) => integer_literal(reader, id, shown.span, name),
        None => {
            let message = format!("{name} takes an integer literal, not `{}`", shown.text);
            Err(Finding::new(&OPERAND_TYPE, shown.span, message).into())
        }
    }
}

fn in_range(
    reader: &RungReader<'_, '_>,
    id: OperandId,
    least: i32,
    greatest: i32,
    span: Span,
    name: &str,
) -> Result<OperandId, Refusal> {
    match reader.integer(id) {
        Some(value) if (least..=greatest).contains(&value) => Ok(id),
        _ => Err(Finding::new(&VALUE_RANGE, span, format!("{name} must be {least} to {greatest}")).into()),
    }
}

pub(super) fn check(
    reader: &RungReader<'_, '_>,
    id: OperandId,
    name: &str,
    span: Span,
    wanted: &str,
    fits: impl Fn(&Reference) -> bool,
) -> Result<OperandId, Refusal> {
    if reader.reference(id).is_some_and(fits) { Ok(id) } else { Err(wrong_type(reader, id, name, span, wanted)) }
}

pub(super) fn wrong_type(reader: &RungReader<'_, '_>, id: OperandId, name: &str, span: Span, wanted: &str) -> Refusal {
    let found = match reader.reference(id) {
        Some(reference) => describe_reference(reader.context, reference),
        None => "something else".to_owned(),
    };
    let finding = Finding::new(&OPERAND_TYPE, span, format!("{name}: expected {wanted}, found {found}"));
    let whole_array = reader.reference(id).is_some_and(|reference| reference.dimensions != [0; 3]);
    if whole_array { finding.help("select an element with a subscript").into() } else { finding.into() }
}

pub(super) fn is_bit(reference: &Reference) -> bool {
    matches!(reference.shape(), Shape::Bit | Shape::WordBit)
}

pub(super) fn is_word(reference: &Reference) -> bool {
    reference.shape() == Shape::Word
}

fn is_integer(reference: &Reference) -> bool {
    reference.shape() == Shape::Word && reference.element() != Some(Element::Real)
}

pub(super) fn status_keyword(text: &str) -> Option<u8> {
    if text.as_bytes().get(1).is_none_or(|byte| *byte != b':') {
        return None;
    }
    format::STATUS_KEYWORDS.iter().position(|keyword| keyword.eq_ignore_ascii_case(text)).map(|at| at as u8)
}
