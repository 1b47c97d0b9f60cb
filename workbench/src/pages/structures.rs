//! The members of a structure in layout order.

use twinrung_catalog::{Element, Instruction, Member, MemberRole, OperandKind, PredefinedType};

use super::Table;

/// The structures that an instruction's operands are tags of, each once.
pub(super) fn of(instruction: &Instruction) -> Vec<&'static PredefinedType> {
    let mut found: Vec<&'static PredefinedType> = Vec::new();
    for operand in instruction.operands {
        if let OperandKind::Structure(structure, _) = operand.kind
            && !found.iter().any(|known| known.name == structure.name)
        {
            found.push(structure);
        }
    }
    found
}

/// Place, name, type, and what the member is for.
pub(super) fn table(instruction: &Instruction, structure: &PredefinedType) -> Table {
    let row = |member: &Member| {
        vec![place(member), member.name.to_owned(), type_text(member), role_words(instruction, member)]
    };
    Table { heads: vec!["at", "member", "type", "what it is"], rows: structure.members.iter().map(row).collect() }
}

/// Byte from the start of the structure; for a BOOL the byte of its word and the bit in it.
fn place(member: &Member) -> String {
    match member.element {
        Element::Bool => format!("{}.{}", member.byte, member.bit),
        _ => member.byte.to_string(),
    }
}

fn type_text(member: &Member) -> String {
    match member.length {
        0 => member.element.name().to_owned(),
        length => format!("{}[{length}]", member.element.name()),
    }
}

fn role_words(instruction: &Instruction, member: &Member) -> String {
    let role = match member.role {
        MemberRole::Data => return member.meaning.to_owned(),
        MemberRole::Internal => return format!("internal: {}; logic may not name it", member.meaning),
        MemberRole::Output => "output",
        MemberRole::Configuration => "configuration",
        MemberRole::Input => "input",
    };
    match mirrored_operand(instruction, member.name) {
        Some(operand) => format!("{role}: operand {operand}"),
        None if member.meaning.is_empty() => role.to_owned(),
        None => format!("{role}: {}", member.meaning),
    }
}

fn mirrored_operand(instruction: &Instruction, name: &str) -> Option<&'static str> {
    let place = instruction.safety?.mirrored.iter().position(|mirrored| *mirrored == name)?;
    instruction.operands.get(place + 1).map(|operand| operand.name)
}
