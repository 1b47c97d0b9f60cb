//! Reading an operand as its declaration says.

use twinrung_bytecode::image::{TypeReference, Usage};
use twinrung_bytecode::{format, limits};
use twinrung_catalog::{Access, ChoiceList, Element, OperandKind};
use twinrung_grammar::tree::{self, Span};

use super::expression::{self, ExpressionKind};
use super::reference::{self, Reference, Shape, describe_reference, type_text};
use super::{Literal, Operand, Scope, literal_of, system};
use crate::diagnostic::{
    BROKEN_OPERAND, Finding, OPERAND_TYPE, SUBSCRIPT_RANGE, UNKNOWN_CHOICE, UNKNOWN_EVENT_TASK, UNKNOWN_LABEL,
    UNKNOWN_ROUTINE, VALUE_RANGE,
};
use crate::names::{closest, fold};
use crate::project::reading::{Refusal, RungReader};
use crate::project::{AddOnId, OperandId, OperandUse};
use crate::rules;

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
            Err(Finding::new(&VALUE_RANGE, shown.span, message).help("write a value in that range").into())
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

/// Reads the tag of an Add-On Instruction call.
pub(crate) fn read_instance(
    reader: &mut RungReader<'_, '_>,
    add_on: AddOnId,
    shown: &tree::Operand,
) -> Result<OperandId, Refusal> {
    let id = reference_operand(reader, shown, true)?;
    let declared = &reader.context.add_ons[add_on.position()];
    let Some(instance_type) = declared.instance_type else { return Err(Refusal::Reported) };
    let Some(reference) = reader.reference(id) else { return Err(Refusal::Reported) };
    let fits = reference.type_reference == TypeReference::Structure(instance_type) && reference.dimensions == [0; 3];
    if !fits {
        return Err(wrong_type(reader, id, "the instance", shown.span, &format!("a tag of type {}", declared.name)));
    }
    if !reference.is_constant() {
        return Err(variable(shown.span, "the instance of an Add-On Instruction"));
    }
    Ok(id)
}

/// Reads an argument of an Add-On Instruction call.
pub(crate) fn read_argument(
    reader: &mut RungReader<'_, '_>,
    add_on: AddOnId,
    parameter: usize,
    shown: &tree::Operand,
) -> Result<OperandId, Refusal> {
    let parameter = &reader.context.add_ons[add_on.position()].parameters[parameter];
    let wanted = parameter.type_reference.ok_or(Refusal::Reported)?;
    let name = parameter.name.as_str();
    if parameter.usage == Usage::InOut {
        let id = reference_operand(reader, shown, !parameter.constant)?;
        let Some(reference) = reader.reference(id) else { return Err(Refusal::Reported) };
        let fits = reference.type_reference == wanted
            && array_fits(parameter.dimensions, reference.dimensions)
            && reference.shape() != Shape::WordBit;
        if !fits {
            let text = type_text(reader.context, wanted, parameter.dimensions);
            return Err(wrong_type(reader, id, name, shown.span, &format!("data of type {text}")));
        }
        if !reference.is_constant() {
            return Err(variable(shown.span, "an InOut argument"));
        }
        return Ok(id);
    }
    let reads = parameter.usage == Usage::Input;
    if reads && let Some(id) = literal_operand(reader, shown)? {
        if wanted == TypeReference::Element(Element::Bool) && !matches!(reader.integer(id), Some(0 | 1)) {
            let message = format!("{name} is a BOOL: {} is neither 0 nor 1", shown.text);
            return Err(Finding::new(&OPERAND_TYPE, shown.span, message).into());
        }
        return Ok(id);
    }
    let id = reference_operand(reader, shown, !reads)?;
    match wanted {
        TypeReference::Element(Element::Bool) => {
            check(reader, id, name, shown.span, "a BOOL or a bit of an integer", is_bit)
        }
        _ => check(reader, id, name, shown.span, "SINT, INT, DINT or REAL", is_word),
    }
}

/// An array may be longer than the parameter in its first dimension.
fn array_fits(parameter: [u32; 3], argument: [u32; 3]) -> bool {
    let ([wanted, ..], [given, ..]) = (parameter, argument);
    parameter[1..] == argument[1..] && (given == wanted || (wanted > 0 && given > wanted))
}

fn variable(span: Span, what: &str) -> Refusal {
    Finding::new(&OPERAND_TYPE, span, format!("{what} has a variable subscript"))
        .help("write a constant subscript: which data an Add-On Instruction works on must not change while it runs")
        .into()
}

impl RungReader<'_, '_> {
    fn reference(&self, id: OperandId) -> Option<&Reference> {
        self.operands.table.get(id.position()).and_then(Operand::reference)
    }

    fn integer(&self, id: OperandId) -> Option<i32> {
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
fn reference_operand(
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
    let reference = reference::reference(reader.context, reader.scope, shown, writes)?;
    Ok(reader.operands.add_reference(&shown.text, reference))
}

/// The operand as a literal, when it begins like one.
fn literal_operand(reader: &mut RungReader<'_, '_>, shown: &tree::Operand) -> Result<Option<OperandId>, Refusal> {
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

fn integer_only(reader: &mut RungReader<'_, '_>, shown: &tree::Operand, name: &str) -> Result<OperandId, Refusal> {
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

fn check(
    reader: &RungReader<'_, '_>,
    id: OperandId,
    name: &str,
    span: Span,
    wanted: &str,
    fits: impl Fn(&Reference) -> bool,
) -> Result<OperandId, Refusal> {
    if reader.reference(id).is_some_and(fits) { Ok(id) } else { Err(wrong_type(reader, id, name, span, wanted)) }
}

fn wrong_type(reader: &RungReader<'_, '_>, id: OperandId, name: &str, span: Span, wanted: &str) -> Refusal {
    let found = match reader.reference(id) {
        Some(reference) => describe_reference(reader.context, reference),
        None => "something else".to_owned(),
    };
    let finding = Finding::new(&OPERAND_TYPE, span, format!("{name}: expected {wanted}, found {found}"));
    let whole_array = reader.reference(id).is_some_and(|reference| reference.dimensions != [0; 3]);
    if whole_array { finding.help("select an element with a subscript").into() } else { finding.into() }
}

fn is_bit(reference: &Reference) -> bool {
    matches!(reference.shape(), Shape::Bit | Shape::WordBit)
}

fn is_word(reference: &Reference) -> bool {
    reference.shape() == Shape::Word
}

fn is_integer(reference: &Reference) -> bool {
    reference.shape() == Shape::Word && reference.element() != Some(Element::Real)
}

fn status_keyword(text: &str) -> Option<u8> {
    if text.as_bytes().get(1).is_none_or(|byte| *byte != b':') {
        return None;
    }
    format::STATUS_KEYWORDS.iter().position(|keyword| keyword.eq_ignore_ascii_case(text)).map(|at| at as u8)
}

fn pseudo(reader: &mut RungReader<'_, '_>, member: &str, shown: &tree::Operand) -> Result<OperandId, Refusal> {
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

fn constant_length(reader: &mut RungReader<'_, '_>, shown: &tree::Operand) -> Result<OperandId, Refusal> {
    match literal_operand(reader, shown)? {
        Some(id) if reader.integer(id).is_some_and(|value| value >= 1) => Ok(id),
        Some(_) => {
            let message = format!("the length is {}: it must be a positive number of elements", shown.text);
            Err(Finding::new(&VALUE_RANGE, shown.span, message).into())
        }
        None => Err(rules::copy_length_constant::finding(shown).into()),
    }
}

fn routine(reader: &mut RungReader<'_, '_>, shown: &tree::Operand) -> Result<OperandId, Refusal> {
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

fn choice(
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

/// GSV destination and SSV source: enough data of the attribute's kind from its start.
fn system_data(
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
    let wanted = if attribute.length == 1 {
        attribute.element.name().to_owned()
    } else {
        format!("{} {} from its start", attribute.length, attribute.element.name())
    };
    let fits = |reference: &Reference| {
        let element = match (reference.shape(), reference.type_reference) {
            (Shape::Word | Shape::Region, TypeReference::Element(element)) => element,
            _ => return false,
        };
        element == attribute.element
    };
    check(reader, id, name, shown.span, &wanted, fits)?;
    let count = reader.reference(id).map_or(0, |reference| reference.location.count);
    if count < attribute.length {
        let message = format!("{} needs {wanted}; there are {count}", attribute.name);
        return Err(Finding::new(&SUBSCRIPT_RANGE, shown.span, message).into());
    }
    Ok(id)
}
