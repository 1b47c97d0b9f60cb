//! The instructions of an image, as an observer needs them: what each is, what its operands show, where what it reads lies.

use twinrung_bytecode::AdmittedImage;
use twinrung_bytecode::channel::Place;
use twinrung_bytecode::code::{Mark, Marks, Operands};
use twinrung_bytecode::image::{Image, TypeKind};
use twinrung_bytecode::layout::TypeLayout;
use twinrung_bytecode::operand::{Access, AccessType, Base, OperandRecord, Shape};
use twinrung_catalog::{Element as ElementType, Instruction, MemberRole, Opcode, OperandKind, PredefinedType};

use super::coverage::{Universe, What, forms, operand};

/// All instructions of an image: for each routine, each rung, in the order of the code.
#[derive(Debug, Clone, Default)]
pub struct Listing {
    routines: Vec<Vec<Vec<Option<Element>>>>,
}

/// An instruction.
#[derive(Debug, Clone)]
pub struct Element {
    /// What it is; none for the call of an Add-On Instruction.
    pub opcode: Option<Opcode>,
    /// The points that its operands show, until they have been counted once.
    pub points: Vec<u32>,
    /// The numbers that it reads.
    pub reads: Vec<Read>,
    /// The structure that it keeps.
    pub state: Option<State>,
}

/// A number that an instruction reads.
#[derive(Debug, Clone)]
pub struct Read {
    /// Which operand.
    pub position: u8,
    /// Its type.
    pub element: ElementType,
    /// Where it is.
    pub source: Source,
}

/// Where a number is.
#[derive(Debug, Clone)]
pub enum Source {
    /// In the code.
    Literal(i32),
    /// In a word cell, behind variable subscripts.
    Cell {
        /// The cell without them.
        cell: u32,
        /// They.
        terms: Vec<Term>,
    },
}

/// A subscript that a tag holds.
#[derive(Debug, Clone, Copy)]
pub struct Term {
    /// The word cell of the tag.
    pub cell: u32,
    /// It must be below this.
    pub length: u32,
    /// Word cells from one element to the next.
    pub stride: u32,
}

/// The cells of a structure that tell its state: status bits and, of a safety instruction, its outputs and codes.
#[derive(Debug, Clone, Default)]
pub struct State {
    /// Bit cells.
    pub bits: Vec<u32>,
    /// Word cells.
    pub words: Vec<u32>,
    /// The state that was seen last.
    pub last: u64,
}

impl Listing {
    /// The instructions of an image.
    pub fn of(admitted: &AdmittedImage) -> Listing {
        let image = admitted.image();
        let routine = |code: &[u8]| {
            let mut rungs: Vec<Vec<Option<Element>>> = Vec::new();
            // An admitted image holds no mark that cannot be read.
            for mark in Marks::new(code).flatten() {
                let element = match mark {
                    Mark::Rung => {
                        rungs.push(Vec::new());
                        continue;
                    }
                    Mark::Instruction(instruction, operands) => element(admitted, instruction, operands),
                    Mark::AddOn(_) => Element { opcode: None, points: Vec::new(), reads: Vec::new(), state: None },
                    Mark::EndRung | Mark::Branch | Mark::NextLeg | Mark::EndBranch => continue,
                };
                if let Some(rung) = rungs.last_mut() {
                    rung.push(Some(element));
                }
            }
            rungs
        };
        Listing { routines: image.routines.iter().map(|record| routine(&record.code)).collect() }
    }

    /// Takes an instruction out, until it is put back.
    pub fn take(&mut self, place: Place) -> Option<Element> {
        self.place(place)?.take()
    }

    /// Puts an instruction back.
    pub fn put_back(&mut self, place: Place, element: Element) {
        if let Some(empty) = self.place(place) {
            *empty = Some(element);
        }
    }

    fn place(&mut self, place: Place) -> Option<&mut Option<Element>> {
        let rung = self.routines.get_mut(place.routine.position())?.get_mut(place.rung as usize)?;
        rung.get_mut(place.element as usize)
    }
}

fn element(admitted: &AdmittedImage, instruction: &'static Instruction, operands: Operands<'_>) -> Element {
    let image = admitted.image();
    let mut element = Element { opcode: Some(instruction.opcode), points: Vec::new(), reads: Vec::new(), state: None };
    for (at, index) in operands.iter().enumerate() {
        let Some(declared) = instruction.operand(at) else { continue };
        // A repeated operand is one position.
        let position = at.min(instruction.operands.len().saturating_sub(1)) as u8;
        let number = |form| Universe::get().number(instruction.opcode, What::Operand(position, form));
        element.points.extend(forms(image, declared.kind, index).into_iter().filter_map(number));
        let Some(record) = operand(image, index) else { continue };
        element.reads.extend(read(image, declared.kind, &record).map(|(kind, source)| Read {
            position,
            element: kind,
            source,
        }));
        if let (OperandKind::Structure(..) | OperandKind::Resettable, OperandRecord::Reference(reference)) =
            (declared.kind, &record)
        {
            element.state = state(admitted, &reference.access);
        }
    }
    element
}

/// A number that an operand of a kind gives.
fn read(image: &Image, kind: OperandKind, record: &OperandRecord) -> Option<(ElementType, Source)> {
    use twinrung_catalog::Access as Use;
    let reads = match kind {
        OperandKind::Number(access) | OperandKind::Integer(access) => access != Use::Write,
        OperandKind::SafetyInteger { .. } | OperandKind::SafetyReal { .. } => true,
        _ => false,
    };
    match record {
        _ if !reads => None,
        OperandRecord::Integer { value, .. } => Some((ElementType::Dint, Source::Literal(*value))),
        OperandRecord::Real(bits) => Some((ElementType::Real, Source::Literal(*bits as i32))),
        OperandRecord::Reference(reference) => {
            let access = &reference.access;
            let (Base::Absolute, Shape::Word, AccessType::Element(element)) =
                (access.base, access.shape, access.access_type)
            else {
                return None;
            };
            let term = |term: &twinrung_bytecode::operand::Term| match operand(image, term.operand)? {
                OperandRecord::Reference(index) if index.access.base == Base::Absolute => {
                    let plain = index.access.shape == Shape::Word && index.access.terms.is_empty();
                    let (cell, length) = (index.access.word_cell, term.length);
                    plain.then_some(Term { cell, length, stride: term.word_stride })
                }
                _ => None,
            };
            let terms = access.terms.iter().map(term).collect::<Option<Vec<Term>>>()?;
            Some((element, Source::Cell { cell: access.word_cell, terms }))
        }
        _ => None,
    }
}

/// The state that a structure shows: all bits of a base structure; the outputs of a backing tag.
fn state(admitted: &AdmittedImage, access: &Access) -> Option<State> {
    let (Base::Absolute, Shape::Region, AccessType::Structure(index)) = (access.base, access.shape, access.access_type)
    else {
        return None;
    };
    if !access.terms.is_empty() {
        return None;
    }
    let record = admitted.image().types.get(index.position())?;
    let layout: &TypeLayout = admitted.layouts().get(index.position())?;
    let known = (record.kind == TypeKind::Predefined).then(|| PredefinedType::by_name(&record.name)).flatten()?;
    let mut state = State::default();
    for (member, place) in known.members.iter().zip(&layout.members) {
        let tells = match member.role {
            MemberRole::Output => true,
            MemberRole::Data => member.element == ElementType::Bool,
            _ => false,
        };
        match member.element {
            _ if !tells || member.length > 0 || member.name == "EnableOut" => {}
            ElementType::Bool => state.bits.push(access.bit_cell + place.bit_cell),
            _ if member.name.ends_with("Code") => state.words.push(access.word_cell + place.word_cell),
            _ => {}
        }
    }
    Some(state)
}
