//! Literals in the places of Preset, Accum, Length and Position. neutral-text-and-l5x.md C.2.

use twinrung_catalog::OperandKind;
use twinrung_grammar::tree::Span;

use crate::diagnostic::{Finding, Findings};
use crate::names::Map;
use crate::operand::{LocationBase, Operand, Reference};
use crate::project::{AddOnId, Call, Project, RoutineOwner, TagId};

rule! {
    /// A literal that cannot initialise its tag.
    "E0310", Error, "one structure gets two initial values",
    "A literal in the place of Preset, Accum, Length or Position initialises the member of the tag; `?` leaves it as declared. Two instructions on one tag must not give it different values, and a structure that a variable subscript or an InOut parameter selects cannot be initialised. Write the same value, or `?`.",
    "neutral-text-and-l5x.md C.2 (decided)",
    good: sample!("    A, B : BOOL (Class := Safety);\n    T : TIMER (Class := Safety);\n", "      N: XIC(A)TON(T,500,0);\n      N: XIC(B)TON(T,?,?);\n"),
    bad: sample!("    A, B : BOOL (Class := Safety);\n    T : TIMER (Class := Safety);\n", "      N: XIC(A)TON(T,500,0);\n      N: XIC(B)TON(T,<<600>>,0);\n")
}

/// What a literal initialises.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum PresetBase {
    /// A tag.
    Tag(TagId),
    /// Every instance of an Add-On Instruction.
    AddOn(AddOnId),
}

/// A literal and the word cell that it initialises.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Preset {
    /// What the cell counts from.
    pub base: PresetBase,
    /// The cell.
    pub word_cell: u32,
    /// The value.
    pub value: i32,
    /// Where the literal stands.
    pub span: Span,
}

/// The literals of a project.
pub(crate) fn all(project: &Project) -> Vec<Preset> {
    let mut list = Vec::new();
    visit(project, &mut |preset| list.extend(preset.ok()));
    list
}

/// Every literal: its cell, or the place of one that has none.
fn visit(project: &Project, visitor: &mut impl FnMut(Result<Preset, Span>)) {
    for routine in &project.routines {
        for rung in &routine.rungs {
            rung.visit(&mut |instruction| {
                let Call::Catalog(declaration) = instruction.call else { return };
                for (declared, shown) in declaration.operands.iter().zip(&instruction.operands) {
                    let OperandKind::Pseudo(member) = declared.kind else { continue };
                    let Operand::Integer { value, .. } = *project.operand(shown.id) else { continue };
                    let structure = instruction.operands.first().map(|one| project.operand(one.id));
                    let Some(structure) = structure.and_then(Operand::reference) else { continue };
                    let owner = match routine.owner {
                        RoutineOwner::AddOn(add_on) => Some(add_on),
                        RoutineOwner::Program(_) => None,
                    };
                    visitor(match cell(project, structure, member, owner) {
                        Some((base, word_cell)) => Ok(Preset { base, word_cell, value, span: shown.span }),
                        None => Err(shown.span),
                    });
                }
            });
        }
    }
}

fn cell(project: &Project, structure: &Reference, member: &str, owner: Option<AddOnId>) -> Option<(PresetBase, u32)> {
    let twinrung_bytecode::image::TypeReference::Structure(index) = structure.type_reference else { return None };
    let position = project.types.member(index, member)?;
    let place = project.types.layout(index).members.get(usize::from(position))?;
    let base = match (structure.location.base, owner) {
        (LocationBase::Tag(tag), _) => PresetBase::Tag(tag),
        (LocationBase::Instance, Some(add_on)) => PresetBase::AddOn(add_on),
        (LocationBase::Instance, None) | (LocationBase::InOut(_), _) => return None,
    };
    structure.is_constant().then_some((base, structure.location.word_cell + place.word_cell))
}

/// Literals that contradict each other or that initialise nothing.
pub(crate) fn check(project: &Project, findings: &mut Findings) {
    let mut seen: Map<(PresetBase, u32), (i32, Span)> = Map::default();
    visit(project, &mut |preset| match preset {
        Err(span) => {
            let message = "which structure this value initialises is not known before the program runs";
            findings.push(Finding::new(&CODE, span, message).help("write `?` here, and give the tag its value where it is declared"));
        }
        Ok(preset) => {
            let first = *seen.entry((preset.base, preset.word_cell)).or_insert((preset.value, preset.span));
            if first.0 != preset.value {
                let message = format!("the tag begins with {} here and with {} elsewhere", preset.value, first.0);
                let finding = Finding::new(&CODE, preset.span, message).label(first.1, "the other value");
                findings.push(finding.help("write the same value, or `?` in one of them"));
            }
        }
    });
}
