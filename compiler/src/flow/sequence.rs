//! The sequence by which an operator terminal changes a parameter (1756-RM093, Changing Parameters in SIL-rated Systems):
//! the value arrives in two tags, the two are compared, the value is compared with both ends of its range, and the
//! operator acknowledges it after both were read back. Recognized where the value is moved on.

use twinrung_catalog::Opcode;
use twinrung_grammar::tree::Span;

use crate::names::{Map, Set};
use crate::operand::{Operand, Reference, Shape};
use crate::project::{Element, Instruction, OperandUse, Project, Rung, TagId, TagKind};
use crate::rules::usage::{self, Cell};

/// What is known of the rungs that move mapped numbers.
#[derive(Default)]
pub(crate) struct Sequences {
    accepted: Set<Span>,
    /// What is missing, by the operand that is moved.
    missing: Map<Span, Vec<&'static str>>,
}

/// Bits that stand for the condition of their rung are looked through so deep.
const DEPTH: usize = 4;

struct Reader<'a> {
    project: &'a Project,
    /// Mapped tags with their standard tags.
    mapped: Map<TagId, &'a str>,
    /// Where a bit is written, when that is one coil or one-shot.
    coils: Map<(TagId, Cell), Option<(&'a Rung, &'a Instruction)>>,
}

/// So many instructions are looked through before one MOV.
const LOOKED_THROUGH: usize = 512;

/// What stands before an instruction.
#[derive(Default)]
struct Conditions<'a> {
    list: Vec<&'a Instruction>,
    one_shot: bool,
    looked_through: usize,
}

impl Sequences {
    /// Looks at every MOV of a mapped number.
    pub fn of(project: &Project) -> Sequences {
        let mut sequences = Sequences::default();
        let mapped: Map<TagId, &str> = project.map.iter().map(|line| (line.safety, line.standard.as_str())).collect();
        if mapped.is_empty() || !project.opcodes.any(&[Opcode::Mov]) {
            return sequences;
        }
        let mut reader = Reader { project, mapped, coils: Map::default() };
        let mut moves = Vec::new();
        usage::rungs(project, &mut |_, _, rung| {
            rung.visit(&mut |instruction| match instruction.call.opcode() {
                Some(Opcode::Mov) if instruction.operands.first().is_some_and(|one| reader.is_mapped(one)) => {
                    moves.push((rung, instruction));
                }
                Some(Opcode::Ote) => reader.coil(rung, instruction, 0),
                Some(Opcode::Osr) => reader.coil(rung, instruction, 1),
                _ => {}
            });
        });
        reader.forget_other_writers();
        for (rung, instruction) in moves {
            let missing = reader.missing(rung, instruction);
            if missing.is_empty() {
                sequences.accepted.insert(instruction.span);
            } else if let Some(first) = instruction.operands.first() {
                sequences.missing.insert(first.span, missing);
            }
        }
        sequences
    }

    /// Whether an instruction moves a value on at the end of the whole sequence.
    pub fn accepts(&self, instruction: &Instruction) -> bool {
        self.accepted.contains(&instruction.span)
    }

    /// What the sequence lacks where this operand is moved on.
    pub fn missing(&self, operand: Span) -> Option<&[&'static str]> {
        self.missing.get(&operand).map(Vec::as_slice)
    }
}

impl<'a> Reader<'a> {
    fn reference(&self, one: &OperandUse) -> Option<&'a Reference> {
        self.project.operand(one.id).reference()
    }

    fn tag(&self, one: &OperandUse) -> Option<TagId> {
        self.reference(one)?.base_tag()
    }

    fn is_mapped(&self, one: &OperandUse) -> bool {
        self.tag(one).is_some_and(|tag| self.mapped.contains_key(&tag))
            && self.reference(one).is_some_and(|reference| reference.shape() == Shape::Word && reference.is_constant())
    }

    fn coil(&mut self, rung: &'a Rung, instruction: &'a Instruction, at: usize) {
        let Some(reference) = instruction.operands.get(at).and_then(|one| self.reference(one)) else { return };
        if let (Some(tag), Some(cell)) = (reference.base_tag(), usage::cell(reference)) {
            self.coils.entry((tag, cell)).and_modify(|known| *known = None).or_insert(Some((rung, instruction)));
        }
    }

    /// A bit that something else writes too, a latch among others, does not stand for the condition of one rung.
    fn forget_other_writers(&mut self) {
        let project = self.project;
        let coils = &mut self.coils;
        let mut somewhere: Set<TagId> = Set::default();
        let mut numbers: Set<(TagId, u32)> = Set::default();
        usage::accesses(project, &mut |access| {
            if !access.writes {
                return;
            }
            let opcode = access.instruction.call.opcode();
            let own = matches!((opcode, access.operand), (Some(Opcode::Ote), 0) | (Some(Opcode::Osr), 1));
            let Some(tag) = access.reference.base_tag() else { return };
            match usage::cell(access.reference) {
                Some(_) if own => {}
                // All bits of it.
                Some(Cell::Word(word)) => {
                    numbers.insert((tag, word));
                }
                Some(cell) => {
                    coils.insert((tag, cell), None);
                }
                // Which of its cells is not known.
                None => {
                    somewhere.insert(tag);
                }
            }
        });
        coils.retain(|(tag, cell), _| {
            let overwritten = matches!(cell, Cell::WordBit(word, _) if numbers.contains(&(*tag, *word)));
            !overwritten && !somewhere.contains(tag)
        });
    }

    fn conditions(&self, rung: &'a Rung, instruction: &'a Instruction, depth: usize, out: &mut Conditions<'a>) {
        let mut list = Vec::new();
        before(&rung.elements, instruction, &mut list);
        let begin = out.list.len();
        out.looked_through += list.len();
        for one in list {
            match one.call.opcode() {
                Some(Opcode::Ons) => out.one_shot |= self.acknowledged(&out.list[begin..]),
                Some(Opcode::Xic) => {
                    let key = one
                        .operands
                        .first()
                        .and_then(|one| self.reference(one))
                        .and_then(|reference| Some((reference.base_tag()?, usage::cell(reference)?)));
                    match key.and_then(|key| self.coils.get(&key)) {
                        Some(Some((rung, coil)))
                            if depth < DEPTH
                                && out.looked_through < LOOKED_THROUGH
                                && !std::ptr::eq(*coil, instruction) =>
                        {
                            let before = out.list.len();
                            self.conditions(rung, coil, depth + 1, out);
                            if coil.call.opcode() == Some(Opcode::Osr) {
                                out.one_shot |= self.acknowledged(&out.list[before..]);
                            }
                        }
                        _ => out.list.push(one),
                    }
                }
                _ => out.list.push(one),
            }
        }
    }

    fn missing(&self, rung: &'a Rung, instruction: &'a Instruction) -> Vec<&'static str> {
        let mut conditions = Conditions::default();
        self.conditions(rung, instruction, 0, &mut conditions);
        let Some(value) = instruction.operands.first().and_then(|one| self.reference(one)) else { return Vec::new() };
        let mut missing = Vec::new();
        let other = self.compared_with(value, &conditions);
        match other {
            None => missing.push("compare it with a second tag that the terminal writes (EQU)"),
            Some(other) if self.standard(value) == self.standard(other) => {
                missing.push("let the second tag come from another standard tag");
            }
            Some(_) => {}
        }
        let (low, high) = self.bounds(value, other, &conditions);
        if !low {
            missing.push("compare it with its least value (LIM or GEQ)");
        }
        if !high {
            missing.push("compare it with its greatest value (LIM or LEQ)");
        }
        if !conditions.list.iter().any(|one| self.acknowledges(one)) {
            missing.push("let the operator acknowledge it after both tags were read back (XIC of a bit that the terminal writes)");
        } else if !conditions.one_shot {
            missing.push("take the acknowledgement by its own rising edge: XIC of it and ONS first on the rung, the comparisons after");
        }
        missing
    }

    fn standard(&self, reference: &Reference) -> Option<&'a str> {
        self.mapped.get(&reference.base_tag()?).copied()
    }

    /// The other mapped number that the value is compared with.
    fn compared_with(&self, value: &Reference, conditions: &Conditions<'a>) -> Option<&'a Reference> {
        conditions.list.iter().filter(|one| one.call.opcode() == Some(Opcode::Equ)).find_map(|one| {
            let [left, right] = &*one.operands else { return None };
            if !self.is_mapped(left) || !self.is_mapped(right) {
                return None;
            }
            let (left, right) = (self.reference(left)?, self.reference(right)?);
            if same(left, value) && !same(right, value) {
                Some(right)
            } else if same(right, value) && !same(left, value) {
                Some(left)
            } else {
                None
            }
        })
    }

    fn bounds(&self, value: &Reference, other: Option<&Reference>, conditions: &Conditions<'a>) -> (bool, bool) {
        let is_value = |one: &OperandUse| {
            self.reference(one)
                .is_some_and(|reference| same(reference, value) || other.is_some_and(|other| same(reference, other)))
        };
        let is_bound = |one: &OperandUse| match self.project.operand(one.id) {
            Operand::Integer { .. } | Operand::Real(_) => true,
            Operand::Reference(reference) => !reference.base_tag().is_some_and(|tag| self.mapped.contains_key(&tag)),
            _ => false,
        };
        let mut found = (false, false);
        for one in &conditions.list {
            match (one.call.opcode(), &*one.operands) {
                (Some(Opcode::Lim), [low, test, high]) if is_value(test) && !self.admits_outside(low, high) => {
                    found.0 |= is_bound(low);
                    found.1 |= is_bound(high);
                }
                (Some(Opcode::Geq | Opcode::Grt), [left, right]) => {
                    found.0 |= is_value(left) && is_bound(right);
                    found.1 |= is_bound(left) && is_value(right);
                }
                (Some(Opcode::Leq | Opcode::Les), [left, right]) => {
                    found.1 |= is_value(left) && is_bound(right);
                    found.0 |= is_bound(left) && is_value(right);
                }
                _ => {}
            }
        }
        found
    }

    /// Whether a LIM with these bounds passes what lies outside them: its low limit is above its high one
    /// (general-instructions.md A.4). Of bounds that are tags that is not known.
    fn admits_outside(&self, low: &OperandUse, high: &OperandUse) -> bool {
        let literal = |one: &OperandUse| match self.project.operand(one.id) {
            Operand::Integer { value, .. } => Some(f64::from(*value)),
            Operand::Real(bits) => Some(f64::from(f32::from_bits(*bits))),
            _ => None,
        };
        literal(low).zip(literal(high)).is_some_and(|(low, high)| low > high)
    }

    /// Whether a one-shot behind these conditions is the edge of the acknowledgement, and of nothing else: behind a
    /// comparison it would also rise when the values become equal while the acknowledgement is held.
    fn acknowledged(&self, before: &[&Instruction]) -> bool {
        before.iter().all(|one| matches!(one.call.opcode(), Some(Opcode::Xic | Opcode::Xio)))
            && before.iter().any(|one| self.acknowledges(one))
    }

    /// A contact of a bit that somebody outside writes.
    fn acknowledges(&self, one: &Instruction) -> bool {
        one.call.opcode() == Some(Opcode::Xic)
            && one.operands.first().and_then(|one| self.tag(one)).is_some_and(|tag| {
                self.mapped.contains_key(&tag)
                    || matches!(self.project.tag(tag).kind, TagKind::ModuleInput(_) | TagKind::Consumed)
            })
    }
}

fn same(left: &Reference, right: &Reference) -> bool {
    left.is_same_data(right)
}

/// Conditions in series before an instruction, on the one path that leads to it. Whether it was found.
fn before<'a>(elements: &'a [Element], wanted: &Instruction, list: &mut Vec<&'a Instruction>) -> bool {
    let known = list.len();
    for element in elements {
        match element {
            Element::Instruction(one) if std::ptr::eq(one, wanted) => return true,
            Element::Instruction(one) => list.push(one),
            Element::Branch(branch) => {
                for leg in &branch.legs {
                    if before(leg, wanted, list) {
                        return true;
                    }
                }
            }
        }
    }
    list.truncate(known);
    false
}
