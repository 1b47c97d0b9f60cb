//! Operands of Add-On Instruction calls.

use twinrung_bytecode::image::{TypeReference, Usage};
use twinrung_catalog::Element;
use twinrung_grammar::tree::{self, Span};

use super::fit::{check, is_bit, is_word, literal_operand, reference_operand, wrong_type};
use super::reference::Shape;
use super::resolve::type_text;
use crate::diagnostic::{Finding, OPERAND_TYPE};
use crate::project::reading::{Refusal, RungReader};
use crate::project::{AddOnId, OperandId};
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
