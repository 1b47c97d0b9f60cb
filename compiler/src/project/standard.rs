//! Standard programs: read for what they write, and not executed.

use twinrung_catalog::{Instruction as Declaration, OperandKind};
use twinrung_grammar::tree::{self, CompactString, Span};

use super::names_in_scope::ScopeNames;
use super::{Tag, TagClass, TagId};
use crate::names::{Map, fold};

/// A standard routine writes a safety tag.
#[derive(Debug, Clone)]
pub struct StandardWrite {
    /// The safety tag.
    pub tag: TagId,
    /// The operand that writes it.
    pub span: Span,
    /// The instruction's mnemonic.
    pub mnemonic: CompactString,
}

/// Which operands of frequent standard instructions are written, where the catalog has no declaration
/// (RM003 operand tables): BTD, CPS, FRD, TOD, DEG, RAD, SIN and the like write their last but for BTD's length.
const DESTINATIONS: [(&str, usize); 26] = [
    ("BTD", 2),
    ("CPS", 1),
    ("FRD", 1),
    ("TOD", 1),
    ("DEG", 1),
    ("RAD", 1),
    ("SIN", 1),
    ("COS", 1),
    ("TAN", 1),
    ("ASN", 1),
    ("ACS", 1),
    ("ATN", 1),
    ("LN", 1),
    ("LOG", 1),
    ("XPY", 2),
    ("TRN", 1),
    ("AVE", 2),
    ("STD", 2),
    ("BSL", 0),
    ("BSR", 0),
    ("FFL", 1),
    ("FFU", 1),
    ("LFL", 1),
    ("LFU", 1),
    ("DTR", 2),
    ("SQI", 2),
];

/// Everything that one standard program writes of safety data.
pub(crate) fn writes(
    program: &tree::Program,
    position: usize,
    names: &ScopeNames,
    tags: &[Tag],
    mnemonics: &Map<CompactString, &'static Declaration>,
    add_ons: &Map<CompactString, Vec<bool>>,
    out: &mut Vec<StandardWrite>,
) {
    let mut pending: Vec<&[tree::Element]> =
        program.routines.iter().flat_map(|routine| routine.rungs()).map(|rung| rung.elements.as_slice()).collect();
    while let Some(series) = pending.pop() {
        for element in series {
            match element {
                tree::Element::Branch(branch) => pending.extend(branch.legs.iter().map(|leg| leg.elements.as_slice())),
                tree::Element::Instruction(instruction) => {
                    let folded = fold(instruction.mnemonic.as_str());
                    let declaration = mnemonics.get(&folded).copied();
                    let by_add_on = add_ons.get(&folded);
                    for (at, operand) in instruction.operands.iter().enumerate() {
                        let written = match (declaration, by_add_on) {
                            (Some(declaration), _) => {
                                declaration.operand(at).is_some_and(|one| is_written(one.kind, at, instruction))
                            }
                            (None, Some(writes)) => at == 0 || writes.get(at - 1).copied().unwrap_or(false),
                            (None, None) => DESTINATIONS
                                .iter()
                                .any(|(name, position)| *position == at && instruction.mnemonic.is(name)),
                        };
                        if !written {
                            continue;
                        }
                        let end = operand.text.find(['.', '[']).unwrap_or(operand.text.len());
                        let Some(found) = names.find_in_standard(position, operand.text[..end].trim()) else {
                            continue;
                        };
                        let tag = &tags[found.tag.position()];
                        // An alias whose target is out of reach may be anything.
                        if tag.class == TagClass::Safety && tag.fault.is_none() {
                            out.push(StandardWrite {
                                tag: found.tag,
                                span: operand.span,
                                mnemonic: instruction.mnemonic.text.clone(),
                            });
                        }
                    }
                }
            }
        }
    }
}

fn is_written(kind: OperandKind, at: usize, instruction: &tree::Instruction) -> bool {
    match kind {
        OperandKind::Bit(access)
        | OperandKind::Number(access)
        | OperandKind::Integer(access)
        | OperandKind::Structure(_, access)
        | OperandKind::SystemData(access) => access.writes(),
        OperandKind::Resettable | OperandKind::CopyDestination | OperandKind::FillDestination => true,
        OperandKind::Parameter(access) => {
            // Of a JSR the returns are written: those after the counted inputs.
            let inputs = instruction.operands.get(1).and_then(|count| count.text.parse::<usize>().ok());
            if instruction.mnemonic.is("JSR") { inputs.is_some_and(|inputs| at >= 2 + inputs) } else { access.writes() }
        }
        _ => false,
    }
}
