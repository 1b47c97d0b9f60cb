//! Operands of a kind of their own: pseudo-operands, lengths, routines, words, system data.

use twinrung_bytecode::image::TypeReference;
use twinrung_bytecode::limits;
use twinrung_catalog::{Access, ChoiceList, Element};
use twinrung_grammar::tree;

use super::fit::{check, literal_operand, reference_operand};
use super::reference::{Reference, Shape};
use super::{Operand, Scope};
use crate::diagnostic::{Finding, OPERAND_TYPE, SUBSCRIPT_RANGE, UNKNOWN_CHOICE, UNKNOWN_ROUTINE, VALUE_RANGE};
use crate::names::{closest, fold};
use crate::project::reading::{Refusal, RungReader};
use crate::project::{OperandId, OperandUse};
use crate::rules;
pub(super) fn pseudo(
    reader: &mut RungReader<'_, '_>,
    member: &str,
    shown: &tree::Operand,
) -> Result<OperandId, Refusal> {
    if shown.is_unassigned() || shown.is_empty() {
        return Ok(reader.operands.add_literal(&"?".into(), Operand::Unassigned));
    }
    let Some(id) = literal_operand(reader, shown)? else {
        let message = format!("{member} is part of the tag: its place takes a number or `?`, not `{}`", shown.text);
        return Err(Finding::new(&OPERAND_TYPE, shown.span, message)
            .help(format!("move the value to the tag's {member} with MOV, and write `?` here"))
            .into());
    };
    match reader.integer(id) {
        Some(value) if value < 0 => {
            let message = format!("{member} is {value}: it must not be negative");
            Err(Finding::new(&VALUE_RANGE, shown.span, message).into())
        }
        Some(_) => Ok(id),
        None => Err(Finding::new(&OPERAND_TYPE, shown.span, format!("{member} takes an integer")).into()),
    }
}

pub(super) fn constant_length(reader: &mut RungReader<'_, '_>, shown: &tree::Operand) -> Result<OperandId, Refusal> {
    match literal_operand(reader, shown)? {
        Some(id) if reader.integer(id).is_some_and(|value| value >= 1) => Ok(id),
        Some(_) => {
            let message = format!("the length is {}: it must be a positive number of elements", shown.text);
            Err(Finding::new(&VALUE_RANGE, shown.span, message).into())
        }
        None => Err(rules::copy_length_constant::finding(shown).into()),
    }
}

pub(super) fn routine(reader: &mut RungReader<'_, '_>, shown: &tree::Operand) -> Result<OperandId, Refusal> {
    let Scope::Program(program) = reader.scope else {
        let message = "an Add-On Instruction cannot call a routine";
        return Err(Finding::new(&crate::diagnostic::ADD_ON_SHAPE, shown.span, message)
            .help("call another Add-On Instruction")
            .into());
    };
    let names = &reader.context.routine_names.programs[program.position()];
    if let Some((routine, _)) = names.get(&fold(&shown.text)) {
        return Ok(reader.operands.add(Operand::Routine(*routine)));
    }
    let message = format!("the program has no routine `{}`", shown.text);
    let finding = Finding::new(&UNKNOWN_ROUTINE, shown.span, message);
    let like = reader
        .context
        .suggest(|| closest(&shown.text, names.values().map(|(_, name)| name.as_str())).map(str::to_owned));
    Err(match like {
        Some(like) => finding.help(format!("did you mean `{like}`?")),
        None => finding.help("JSR calls a ladder routine of the same program"),
    }
    .into())
}

pub(super) fn choice(
    reader: &mut RungReader<'_, '_>,
    list: &'static ChoiceList,
    shown: &tree::Operand,
) -> Result<OperandId, Refusal> {
    let unquoted = shown.text.trim_matches(|c| c == '\'' || c == '"');
    let value = list
        .value(unquoted)
        .or_else(|| twinrung_grammar::read_words(shown).ok().and_then(|words| list.value(&words.text)));
    if let Some(value) = value {
        return Ok(reader.operands.add(Operand::Choice(value)));
    }
    let message = format!("{} is not `{}`", list.name, shown.text);
    let finding = Finding::new(&UNKNOWN_CHOICE, shown.span, message);
    let like = closest(&unquoted.to_ascii_uppercase(), list.words.iter().map(|(word, _)| *word));
    Err(match like {
        Some(like) => finding.help(format!("did you mean `{like}`?")),
        None => {
            let mut words: Vec<&str> = Vec::new();
            let mut seen = Vec::new();
            for (word, value) in list.words {
                if !seen.contains(value) {
                    seen.push(*value);
                    words.push(word);
                }
            }
            finding.help(format!("one of: {}", words.join("; ")))
        }
    }
    .into())
}

/// GSV destination and SSV source: as many bytes of integers or structures as the attribute has.
pub(super) fn system_data(
    reader: &mut RungReader<'_, '_>,
    access: Access,
    name: &str,
    shown: &tree::Operand,
    before: &[OperandUse],
) -> Result<OperandId, Refusal> {
    let id = reference_operand(reader, shown, access.writes())?;
    let attribute = match before.get(2).map(|one| &reader.operands.table[one.id.position()]) {
        Some(Operand::SystemValue(value)) => value.attribute,
        _ => return Err(Refusal::Reported),
    };
    let element_bytes = |reference: &Reference| match (reference.shape(), reference.type_reference) {
        (Shape::Word | Shape::Region, TypeReference::Element(element)) => {
            matches!(element, Element::Sint | Element::Int | Element::Dint).then(|| element.bytes())
        }
        (Shape::Region, TypeReference::Structure(index)) => {
            let layout = reader.context.types.layout(index);
            let is_copied = !layout.holds_backing && (1..=limits::COPY_BYTES).contains(&layout.bytes);
            is_copied.then_some(layout.bytes)
        }
        _ => None,
    };
    let wanted = "an integer, an array of integers or a structure without backing tags";
    check(reader, id, name, shown.span, wanted, |reference| element_bytes(reference).is_some())?;
    let bytes = reader
        .reference(id)
        .map_or(0, |reference| element_bytes(reference).unwrap_or_default().saturating_mul(reference.location.count));
    let needed = attribute.element.bytes() * attribute.length;
    if bytes < needed {
        let message = format!("{} has {needed} bytes; there are {bytes} from here on", attribute.name);
        return Err(Finding::new(&SUBSCRIPT_RANGE, shown.span, message).into());
    }
    Ok(id)
}
