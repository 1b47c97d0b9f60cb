//! Resolving references: every step of a path against the types that it goes through.

use twinrung_bytecode::image::{TypeKind, TypeReference};
use twinrung_bytecode::layout::elements;
use twinrung_bytecode::limits;
use twinrung_catalog::Element;
use twinrung_grammar::tree::{self, Part, Span, TagReference};

use super::expression::{self, ExpressionKind};
use super::reference::{BitPlace, LocationBase, Reference, Root, Scope, Step, Subscript, Term, Walk};
use crate::diagnostic::{
    BAD_ALIAS, Finding, NOT_SUPPORTED, OPERAND_TYPE, OVER_LIMIT, SUBSCRIPT_RANGE, UNKNOWN_MEMBER, UNKNOWN_TAG,
};
use crate::names::closest;
use crate::project::names_in_scope::{AddOnName, Found};
use crate::project::reading::{Context, Refusal};
use crate::project::{AddOnId, TagClass, TagKind};
use crate::rules;
/// Reads an operand as a reference.
pub(crate) fn reference(
    context: &Context<'_>,
    scope: Scope,
    operand: &tree::Operand,
    writes: bool,
) -> Result<Reference, Refusal> {
    let tag = twinrung_grammar::read_tag(operand).map_err(|error| Refusal::from(&error))?;
    resolve(context, scope, &tag, writes, 0)
}

/// Resolves a tag reference. `depth` counts subscripts within subscripts.
pub(crate) fn resolve(
    context: &Context<'_>,
    scope: Scope,
    tag: &TagReference,
    writes: bool,
    depth: usize,
) -> Result<Reference, Refusal> {
    if let Some(program) = &tag.program {
        let finding = Finding::new(&NOT_SUPPORTED, program.span, "parameters of other programs are not compiled")
            .help("pass the value in a controller-scoped safety tag");
        return Err(finding.into());
    }
    let (root, mut walk) = begin(context, scope, tag, writes)?;
    let mut steps = Vec::with_capacity(tag.parts.len());
    if tag.parts.len() > limits::PATH_STEPS {
        let message = format!("a path has at most {} steps", limits::PATH_STEPS);
        return Err(Finding::new(&OVER_LIMIT, tag.span, message).into());
    }
    for part in &tag.parts {
        step(context, scope, part, &mut walk, &mut steps, depth)?;
    }
    if walk.location.terms.len() > limits::SUBSCRIPT_TERMS {
        let message = format!("a reference has at most {} variable subscripts", limits::SUBSCRIPT_TERMS);
        return Err(Finding::new(&OVER_LIMIT, tag.span, message).into());
    }
    let Walk { type_reference, dimensions, location } = walk;
    Ok(Reference { root, steps, type_reference, dimensions, location })
}

fn begin(context: &Context<'_>, scope: Scope, tag: &TagReference, writes: bool) -> Result<(Root, Walk), Refusal> {
    let name = tag.base.as_str();
    if let Scope::AddOn(add_on) = scope {
        return begin_in_add_on(context, add_on, tag);
    }
    let Some(Found { tag: id, by_slot }) = context.names.find(scope, name) else {
        return Err(unknown_tag(context, scope, tag).into());
    };
    let declared = &context.tags[id.position()];
    if let Some(fault) = &declared.fault {
        return Err(Refusal::Finding(fault.clone()));
    }
    if declared.class == TagClass::Standard {
        return Err(rules::standard_tag::finding(declared, tag, writes).into());
    }
    if by_slot {
        context.note_slot_name(id);
    }
    let walk = match &declared.kind {
        TagKind::Alias(Some(target)) => target.walk.clone(),
        TagKind::Alias(None) => return Err(Refusal::Reported),
        _ => {
            let type_reference = declared.type_reference.ok_or(Refusal::Reported)?;
            Walk::begin(LocationBase::Tag(id), type_reference, declared.dimensions)
        }
    };
    Ok((Root::Tag(id), walk))
}

fn begin_in_add_on(context: &Context<'_>, add_on: AddOnId, tag: &TagReference) -> Result<(Root, Walk), Refusal> {
    match context.names.find_in_add_on(add_on, tag.base.as_str()) {
        Some(AddOnName::Member { member, type_reference, dimensions }) => {
            let type_reference = type_reference.ok_or(Refusal::Reported)?;
            let instance = context.add_ons[usize::from(add_on.0)].instance_type.ok_or(Refusal::Reported)?;
            let place = context.types.layout(instance).members[usize::from(member)];
            let mut walk = Walk::begin(LocationBase::Instance, type_reference, dimensions);
            walk.location.bit_cell = place.bit_cell;
            walk.location.word_cell = place.word_cell;
            Ok((Root::Member(add_on, member), walk))
        }
        Some(AddOnName::InOut { parameter, type_reference, dimensions }) => {
            let type_reference = type_reference.ok_or(Refusal::Reported)?;
            let walk = Walk::begin(LocationBase::InOut(parameter), type_reference, dimensions);
            Ok((Root::InOut(add_on, parameter), walk))
        }
        None => {
            let name = tag.base.as_str();
            let message = format!("`{name}` is neither a parameter nor a local tag of this Add-On Instruction");
            let finding = Finding::new(&UNKNOWN_TAG, tag.base.span, message);
            Err(match context.suggest(|| closest(name, context.names.names_in_add_on(add_on)).map(str::to_owned)) {
                Some(like) => finding.help(format!("did you mean `{like}`?")),
                None => finding.help("pass the data through a parameter"),
            }
            .into())
        }
    }
}

fn unknown_tag(context: &Context<'_>, scope: Scope, tag: &TagReference) -> Finding {
    let name = tag.base.as_str();
    let finding = Finding::new(&UNKNOWN_TAG, tag.base.span, format!("`{name}` is not declared"));
    if let Some((module, "O" | "o")) = name.split_once(':')
        && context.names.find(scope, &format!("{module}:I")).is_some()
    {
        return finding.help(format!("`{module}` takes no data as it is declared; its OutputData says what it takes"));
    }
    match context.suggest(|| closest(name, context.names.names(scope, context.tags)).map(str::to_owned)) {
        Some(like) => finding.help(format!("did you mean `{like}`?")),
        None if name.contains(':') => finding.help(
            "no module in reach has this tag; for a partial export give the file that holds the module with --context",
        ),
        None => finding.help("declare it in the TAG block of the program or of the controller"),
    }
}

fn step(
    context: &Context<'_>,
    scope: Scope,
    part: &Part,
    walk: &mut Walk,
    steps: &mut Vec<Step>,
    depth: usize,
) -> Result<(), Refusal> {
    match part {
        Part::Member(name) => {
            let index = match walk.type_reference {
                TypeReference::Structure(index) if walk.dimensions == [0; 3] && walk.location.bit.is_none() => index,
                _ => {
                    let what = describe(context, walk);
                    let message = format!("{what} has no member `{name}`");
                    return Err(Finding::new(&UNKNOWN_MEMBER, name.span, message).into());
                }
            };
            let Some(position) = context.types.member(index, name.as_str()) else {
                return Err(unknown_member(context, index, name).into());
            };
            if let TypeKind::AddOn(add_on) = context.types.record(index).kind {
                let held = &context.add_ons[usize::from(add_on.0)].parameters;
                if usize::from(position) >= held.iter().filter(|parameter| parameter.member.is_some()).count() {
                    let message = format!(
                        "`{name}` is a local tag of {}, which nobody else sees",
                        context.types.record(index).name
                    );
                    return Err(Finding::new(&UNKNOWN_MEMBER, name.span, message)
                        .help("make it an Output parameter of the Add-On Instruction")
                        .into());
                }
            }
            let member = &context.types.record(index).members[usize::from(position)];
            let place = context.types.layout(index).members[usize::from(position)];
            walk.type_reference = member.type_reference;
            walk.dimensions = member.dimensions;
            walk.location.bit_cell += place.bit_cell;
            walk.location.word_cell += place.word_cell;
            walk.location.count = place.elements;
            steps.push(Step::Member(position));
        }
        Part::Subscripts { subscripts, span } => subscript(context, scope, subscripts, *span, walk, steps, depth)?,
        Part::Bit { number, span } => {
            let bits = integer_bits(context, walk, *span)?;
            if *number >= u32::from(bits) {
                let message = format!("bit {number} is beyond the {bits} bits of the {}", describe(context, walk));
                return Err(Finding::new(&SUBSCRIPT_RANGE, *span, message).into());
            }
            walk.location.bit = Some(BitPlace::Constant(*number as u8));
            walk.location.count = 1;
            steps.push(Step::Bit(*number as u8));
        }
        Part::BitSubscript { index, span } => {
            let bits = integer_bits(context, walk, *span)?;
            let index = expression::expression(context, scope, index, ExpressionKind::Subscript, depth + 1)?;
            match index.constant() {
                Some(number) if (0..i64::from(bits)).contains(&number) => {
                    walk.location.bit = Some(BitPlace::Constant(number as u8));
                    steps.push(Step::Bit(number as u8));
                }
                Some(number) => {
                    let message = format!("bit {number} is beyond the {bits} bits of the {}", describe(context, walk));
                    return Err(Finding::new(&SUBSCRIPT_RANGE, *span, message).into());
                }
                None => {
                    walk.location.bit = Some(BitPlace::Expression);
                    steps.push(Step::BitExpression(Box::new(index)));
                }
            }
            walk.location.count = 1;
        }
    }
    Ok(())
}

fn unknown_member(context: &Context<'_>, index: twinrung_bytecode::index::TypeIndex, name: &tree::Name) -> Finding {
    let record = context.types.record(index);
    let finding = Finding::new(&UNKNOWN_MEMBER, name.span, format!("{} has no member `{name}`", record.name));
    let members = || record.members.iter().map(|member| member.name.as_str());
    match context.suggest(|| closest(name.as_str(), members()).map(str::to_owned)) {
        Some(like) => finding.help(format!("did you mean `{like}`?")),
        None => {
            let some: Vec<&str> = members().take(12).collect();
            let more = if record.members.len() > some.len() { ", ..." } else { "" };
            finding.help(format!("its members are {}{more}", some.join(", ")))
        }
    }
}

fn subscript(
    context: &Context<'_>,
    scope: Scope,
    subscripts: &[tree::Expression],
    span: Span,
    walk: &mut Walk,
    steps: &mut Vec<Step>,
    depth: usize,
) -> Result<(), Refusal> {
    let sizes: Vec<u32> = walk.dimensions.into_iter().take_while(|size| *size > 0).collect();
    if sizes.is_empty() || walk.location.bit.is_some() {
        let message = format!("{} is no array", describe(context, walk));
        return Err(Finding::new(&OPERAND_TYPE, span, message).into());
    }
    if sizes.len() != subscripts.len() {
        let message = format!("the array has {} dimensions and {} subscripts", sizes.len(), subscripts.len());
        return Err(Finding::new(&OPERAND_TYPE, span, message).into());
    }
    let (bits, words) = context.types.cells(walk.type_reference);
    let mut skipped = 0;
    let mut list = Vec::with_capacity(sizes.len());
    for (position, (size, shown)) in sizes.iter().zip(subscripts).enumerate() {
        let stride: u32 = sizes[position + 1..].iter().product();
        let value = expression::expression(context, scope, shown, ExpressionKind::Subscript, depth + 1)?;
        match value.constant() {
            Some(number) if (0..i64::from(*size)).contains(&number) => {
                let number = number as u32;
                skipped += number * stride;
                list.push(Subscript::Constant(number));
            }
            Some(number) => {
                let message = format!("element {number} of an array of {size} elements, which count from 0");
                return Err(Finding::new(&SUBSCRIPT_RANGE, shown.span(), message).into());
            }
            None => {
                let term = Term { length: *size, bit_stride: stride * bits, word_stride: stride * words };
                walk.location.terms.push(term);
                list.push(Subscript::Expression(Box::new(value)));
            }
        }
    }
    walk.location.bit_cell += skipped * bits;
    walk.location.word_cell += skipped * words;
    walk.location.count = elements(walk.dimensions).unwrap_or(1) - skipped;
    walk.dimensions = [0; 3];
    steps.push(Step::Subscript(list));
    Ok(())
}

fn integer_bits(context: &Context<'_>, walk: &Walk, span: Span) -> Result<u8, Refusal> {
    match walk.type_reference {
        TypeReference::Element(element @ (Element::Sint | Element::Int | Element::Dint))
            if walk.dimensions == [0; 3] && walk.location.bit.is_none() =>
        {
            Ok(element.bits())
        }
        _ => {
            let message = format!("{} has no bits that a number selects", describe(context, walk));
            Err(Finding::new(&OPERAND_TYPE, span, message).into())
        }
    }
}

/// The type at the end of a path, for messages.
fn describe(context: &Context<'_>, walk: &Walk) -> String {
    if walk.location.bit.is_some() {
        return "a bit of an integer".to_owned();
    }
    type_text(context, walk.type_reference, walk.dimensions)
}

/// A type as declarations write it: `DINT[10]`.
pub(crate) fn type_text(context: &Context<'_>, type_reference: TypeReference, dimensions: [u32; 3]) -> String {
    let name = context.types.name(type_reference);
    let sizes: Vec<String> = dimensions.iter().take_while(|size| **size > 0).map(u32::to_string).collect();
    if sizes.is_empty() { name.to_owned() } else { format!("{name}[{}]", sizes.join(",")) }
}

/// A reference's type for messages.
pub(crate) fn describe_reference(context: &Context<'_>, reference: &Reference) -> String {
    if reference.location.bit.is_some() {
        return "a bit of an integer".to_owned();
    }
    type_text(context, reference.type_reference, reference.dimensions)
}

/// Resolves what an alias designates.
pub(crate) fn alias_target(
    context: &Context<'_>,
    scope: Scope,
    operand: &tree::Operand,
) -> Result<(Reference, Walk), Refusal> {
    let reference = reference(context, scope, operand, false)?;
    if !reference.is_constant() {
        let message = "an alias designates an element with constant subscripts";
        return Err(Finding::new(&BAD_ALIAS, operand.span, message).into());
    }
    let walk = Walk {
        type_reference: reference.type_reference,
        dimensions: reference.dimensions,
        location: reference.location.clone(),
    };
    Ok((reference, walk))
}
