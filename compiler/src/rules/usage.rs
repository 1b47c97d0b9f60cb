//! Who reads and writes what: every operand of every instruction as data that is read or written.

use twinrung_bytecode::image::{TypeReference, Usage as Direction};
use twinrung_catalog::{Access, Opcode, OperandKind};
use twinrung_grammar::tree::Span;

use crate::operand::{BitPlace, LocationBase, Operand, Reference, Shape};
use crate::project::{AddOnId, Call, Instruction, Place, Project, RoutineId, RoutineOwner, Rung};

/// One access to data.
#[derive(Debug)]
pub struct DataAccess<'a> {
    /// The instruction.
    pub instruction: &'a Instruction,
    /// Where it stands.
    pub place: Place,
    /// The Add-On Instruction whose routine this is.
    pub owner: Option<AddOnId>,
    /// Which operand.
    pub operand: usize,
    /// Where that operand stands.
    pub span: Span,
    /// What is accessed.
    pub reference: &'a Reference,
    /// Whether its value is looked at.
    pub reads: bool,
    /// Whether it can be written.
    pub writes: bool,
}

/// One operand of a safety application instruction.
pub(crate) struct SafetyOperand<'a> {
    /// The instruction.
    pub instruction: &'a Instruction,
    /// Its mnemonic.
    pub mnemonic: &'static str,
    /// The operand's name.
    pub name: &'static str,
    /// Whether it is a channel of a pair that the instruction evaluates.
    pub channel: bool,
    /// What stands there.
    pub operand: &'a Operand,
    /// Where.
    pub span: Span,
}

/// A cell, by what it counts from: comparable within one owner.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) enum Cell {
    /// A BOOL.
    Bit(u32),
    /// A word.
    Word(u32),
    /// A bit of a word.
    WordBit(u32, u8),
}

/// Base and Add-On Instruction: what two cells must share to be the same data.
pub(crate) type CellKey = (LocationBase, Option<AddOnId>, Cell);

impl DataAccess<'_> {
    /// The single cell that is accessed; nothing for a region, or where a variable subscript selects.
    pub(crate) fn cell(&self) -> Option<CellKey> {
        cell(self.reference).map(|cell| (self.reference.location.base, self.owner, cell))
    }
}

/// The single cell that a reference reaches.
pub(crate) fn cell(reference: &Reference) -> Option<Cell> {
    let location = &reference.location;
    if !location.terms.is_empty() {
        return None;
    }
    match (reference.shape(), location.bit) {
        (Shape::Bit, _) => Some(Cell::Bit(location.bit_cell)),
        (Shape::Word, _) => Some(Cell::Word(location.word_cell)),
        (Shape::WordBit, Some(BitPlace::Constant(bit))) => Some(Cell::WordBit(location.word_cell, bit)),
        _ => None,
    }
}

/// Visits every rung of every routine.
pub(crate) fn rungs<'a>(project: &'a Project, visitor: &mut impl FnMut(RoutineId, u32, &'a Rung)) {
    for (at, routine) in project.routines.iter().enumerate() {
        for (number, rung) in routine.rungs.iter().enumerate() {
            visitor(RoutineId(at as u32), number as u32, rung);
        }
    }
}

/// Visits every instruction with its place.
pub(crate) fn instructions<'a>(project: &'a Project, visitor: &mut impl FnMut(Place, &'a Instruction)) {
    rungs(project, &mut |routine, number, rung| {
        rung.visit(&mut |instruction| {
            visitor(Place { routine, rung: number, element: instruction.element }, instruction)
        });
    });
}

/// Visits every operand of every safety application instruction, with its declaration and whether it is a channel of a
/// pair that the instruction evaluates.
pub(crate) fn safety_operands<'a>(project: &'a Project, visitor: &mut impl FnMut(&SafetyOperand<'a>)) {
    if !project.opcodes.any_safety() {
        return;
    }
    instructions(project, &mut |_, instruction| {
        let Call::Catalog(declaration) = instruction.call else { return };
        let Some(safety) = declaration.safety else { return };
        for (at, one) in instruction.operands.iter().enumerate() {
            let Some(declared) = declaration.operand(at) else { continue };
            let (name, channel) = (declared.name, safety.channels.contains(&declared.name));
            visitor(&SafetyOperand {
                instruction,
                mnemonic: declaration.mnemonic,
                name,
                channel,
                operand: project.operand(one.id),
                span: one.span,
            });
        }
    });
}

/// Visits the data of every channel of a pair that a safety application instruction evaluates.
pub(crate) fn channels<'a>(project: &'a Project, visitor: &mut impl FnMut(&SafetyOperand<'a>, &'a Reference)) {
    safety_operands(project, &mut |one| {
        if let (true, Operand::Reference(reference)) = (one.channel, one.operand) {
            visitor(one, reference);
        }
    });
}

/// Visits every access to data, those of subscripts and expressions included.
pub fn accesses<'a>(project: &'a Project, visitor: &mut impl FnMut(&DataAccess<'a>)) {
    let in_out = InOutWrites::of(project);
    instructions(project, &mut |place, instruction| {
        let owner = match project.routine(place.routine).owner {
            RoutineOwner::AddOn(add_on) => Some(add_on),
            RoutineOwner::Program(_) => None,
        };
        for (at, one) in instruction.operands.iter().enumerate() {
            let own = access(project, &in_out, instruction, at);
            let mut give = |reference: &'a Reference, access: Access| {
                let (reads, writes) = (access != Access::Write, access.writes());
                visitor(&DataAccess {
                    instruction,
                    place,
                    owner,
                    operand: at,
                    span: one.span,
                    reference,
                    reads,
                    writes,
                });
            };
            match project.operand(one.id) {
                Operand::Reference(reference) => {
                    within(reference, &mut |inner| give(inner, Access::Read));
                    give(reference, own);
                }
                Operand::Expression(expression) => of_expression(expression, &mut |inner| give(inner, Access::Read)),
                _ => {}
            }
        }
    });
}

/// References of a reference's subscripts and bit number.
fn within<'a>(reference: &'a Reference, visitor: &mut dyn FnMut(&'a Reference)) {
    for step in &reference.steps {
        match step {
            crate::operand::Step::Subscript(subscripts) => {
                for subscript in subscripts {
                    if let crate::operand::Subscript::Expression(expression) = subscript {
                        of_expression(expression, visitor);
                    }
                }
            }
            crate::operand::Step::BitExpression(expression) => of_expression(expression, visitor),
            crate::operand::Step::Member(_) | crate::operand::Step::Bit(_) => {}
        }
    }
}

fn of_expression<'a>(expression: &'a crate::operand::Expression, visitor: &mut dyn FnMut(&'a Reference)) {
    use crate::operand::Expression;
    match expression {
        Expression::Integer { .. } | Expression::Real(_) => {}
        Expression::Reference(reference) => {
            within(reference, visitor);
            visitor(reference);
        }
        Expression::Unary(_, operand) => of_expression(operand, visitor),
        Expression::Binary(_, left, right) => {
            of_expression(left, visitor);
            of_expression(right, visitor);
        }
    }
}

/// For each Add-On Instruction which of its parameters its logic writes; counts for InOut parameters.
pub(crate) struct InOutWrites {
    by_add_on: Vec<Vec<bool>>,
}

impl InOutWrites {
    /// Least fixed point over the calls of Add-On Instructions within each other.
    pub fn of(project: &Project) -> InOutWrites {
        let mut found =
            InOutWrites { by_add_on: project.add_ons.iter().map(|one| vec![false; one.parameters.len()]).collect() };
        if !project.add_ons.iter().any(|one| one.parameters.iter().any(|one| one.usage == Direction::InOut)) {
            return found;
        }
        loop {
            let mut added = Vec::new();
            for routine in &project.routines {
                let RoutineOwner::AddOn(owner) = routine.owner else { continue };
                for rung in &routine.rungs {
                    rung.visit(&mut |instruction| {
                        for (at, one) in instruction.operands.iter().enumerate() {
                            let Operand::Reference(reference) = project.operand(one.id) else { continue };
                            let LocationBase::InOut(parameter) = reference.location.base else { continue };
                            let writes = access(project, &found, instruction, at).writes();
                            if writes && !found.by_add_on[owner.position()][usize::from(parameter)] {
                                added.push((owner, parameter));
                            }
                        }
                    });
                }
            }
            if added.is_empty() {
                return found;
            }
            for (owner, parameter) in added {
                found.by_add_on[owner.position()][usize::from(parameter)] = true;
            }
        }
    }
}

/// What an instruction can do with its operand.
fn access(project: &Project, in_out: &InOutWrites, instruction: &Instruction, at: usize) -> Access {
    let declaration = match instruction.call {
        Call::Catalog(declaration) => declaration,
        Call::AddOn(add_on) => {
            if at == 0 {
                return Access::ReadWrite;
            }
            let mut parameters = project.add_on(add_on).parameters.iter().enumerate().filter(|(_, one)| one.argument);
            return parameters.nth(at - 1).map_or(Access::ReadWrite, |(position, parameter)| match parameter.usage {
                Direction::Input => Access::Read,
                Direction::Output => Access::Write,
                Direction::InOut if in_out.by_add_on[add_on.position()][position] => Access::ReadWrite,
                Direction::InOut => Access::Read,
            });
        }
    };
    let Some(declared) = declaration.operand(at) else { return Access::Read };
    match declared.kind {
        OperandKind::Bit(access)
        | OperandKind::Number(access)
        | OperandKind::Integer(access)
        | OperandKind::Structure(_, access)
        | OperandKind::SystemData(access) => access,
        OperandKind::Resettable | OperandKind::CopyDestination | OperandKind::FillDestination => Access::Write,
        OperandKind::Parameter(_) if declaration.opcode == Opcode::Jsr => {
            let inputs = match instruction.operands.get(1).map(|one| project.operand(one.id)) {
                Some(Operand::Integer { value, .. }) => usize::try_from(*value).unwrap_or(0),
                _ => 0,
            };
            if at >= 2 + inputs { Access::Write } else { Access::Read }
        }
        OperandKind::Parameter(access) => access,
        _ => Access::Read,
    }
}

/// The name of a reference as the text writes it, without the values of variable subscripts.
pub(crate) fn name_of(project: &Project, reference: &Reference) -> String {
    use crate::operand::{Root, Step, Subscript};
    let (mut text, mut type_reference) = match reference.root {
        Root::Tag(tag) => {
            let tag = project.tag(tag);
            (tag.image_name().to_owned(), tag.type_reference)
        }
        Root::Member(add_on, member) => {
            let index = project.add_on(add_on).instance_type;
            let member = index.and_then(|index| project.types.record(index).members.get(usize::from(member)));
            (member.map_or_else(String::new, |one| one.name.clone()), member.map(|one| one.type_reference))
        }
        Root::InOut(add_on, parameter) => {
            let parameter = &project.add_on(add_on).parameters[usize::from(parameter)];
            (parameter.name.to_string(), parameter.type_reference)
        }
    };
    for step in &reference.steps {
        match step {
            Step::Member(member) => {
                let Some(TypeReference::Structure(index)) = type_reference else { return text };
                let Some(member) = project.types.record(index).members.get(usize::from(*member)) else { return text };
                text.push('.');
                text.push_str(&member.name);
                type_reference = Some(member.type_reference);
            }
            Step::Subscript(list) => {
                let list: Vec<String> = list
                    .iter()
                    .map(|one| match one {
                        Subscript::Constant(number) => number.to_string(),
                        Subscript::Expression(_) => "...".to_owned(),
                    })
                    .collect();
                text.push_str(&format!("[{}]", list.join(",")));
            }
            Step::Bit(bit) => text.push_str(&format!(".{bit}")),
            Step::BitExpression(_) => text.push_str(".[...]"),
        }
    }
    text
}

/// The name of the last member of a path, that of an alias's target where the alias itself is meant.
pub(crate) fn last_member(project: &Project, reference: &Reference) -> String {
    use crate::operand::Root;
    if let (true, Root::Tag(tag)) = (reference.steps.is_empty(), reference.root)
        && let crate::project::TagKind::Alias(Some(target)) = &project.tag(tag).kind
    {
        return last_member(project, &target.reference);
    }
    let name = name_of(project, reference);
    name.rsplit('.').next().unwrap_or_default().to_owned()
}

/// The types that a path goes through, its root's first, the type at its end last; for an alias those of its target
/// come before.
pub(crate) fn types_on_path(project: &Project, reference: &Reference) -> Vec<TypeReference> {
    use crate::operand::{Root, Step};
    let mut list = Vec::new();
    let mut current = match reference.root {
        Root::Tag(tag) => {
            let tag = project.tag(tag);
            if let crate::project::TagKind::Alias(Some(target)) = &tag.kind {
                // Bounded: an alias was resolved after those in its chain.
                list = types_on_path(project, &target.reference);
                list.pop();
            }
            tag.type_reference
        }
        Root::Member(add_on, member) => project
            .add_on(add_on)
            .instance_type
            .and_then(|index| project.types.record(index).members.get(usize::from(member)))
            .map(|member| member.type_reference),
        Root::InOut(add_on, parameter) => project.add_on(add_on).parameters[usize::from(parameter)].type_reference,
    };
    list.extend(current);
    for step in &reference.steps {
        if let (Step::Member(member), Some(TypeReference::Structure(index))) = (step, current) {
            current = project.types.record(index).members.get(usize::from(*member)).map(|one| one.type_reference);
            list.extend(current);
        }
    }
    list
}

/// Whether a type is, or holds, the backing structure of a safety application instruction.
pub(crate) fn holds_safety_backing(project: &Project, reference: TypeReference) -> bool {
    let TypeReference::Structure(index) = reference else { return false };
    if !project.types.layout(index).holds_backing {
        return false;
    }
    if project.types.predefined(reference).is_some_and(|known| known.backs_one_call) {
        return true;
    }
    project.types.record(index).members.iter().any(|member| holds_safety_backing(project, member.type_reference))
}
