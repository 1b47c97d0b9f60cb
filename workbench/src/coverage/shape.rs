//! The rungs of an image as networks: what stands in series and in parallel, and what each element is to the power that flows.

use twinrung_bytecode::AdmittedImage;
use twinrung_bytecode::code::{Mark, Marks, Operands};
use twinrung_bytecode::image::Owner;
use twinrung_bytecode::index::{AddOnIndex, RoutineIndex};
use twinrung_bytecode::operand::{OperandRecord, Reference};
use twinrung_catalog::{Instruction, Opcode, Position};

/// A rung of the image: the position in the list of all of them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct RungId(pub u32);

/// All rungs of an image, routine by routine.
#[derive(Debug)]
pub struct Program {
    rungs: Vec<Rung>,
    /// Where the rungs of each routine begin; one more at the end.
    first: Vec<u32>,
}

/// A rung.
#[derive(Debug)]
pub struct Rung {
    /// Its routine.
    pub routine: RoutineIndex,
    /// Its number in the routine, from 0.
    pub number: u32,
    /// What stands on it.
    pub series: Vec<Node>,
    /// Its instructions in the order of the code.
    pub elements: Vec<Element>,
    /// Its text.
    pub text: String,
    /// The text of each instruction.
    pub names: Vec<String>,
}

/// Something in series with what stands before and after it.
#[derive(Debug, PartialEq, Eq)]
pub enum Node {
    /// An instruction, by its position on the rung.
    Element(u32),
    /// Legs in parallel.
    Branch(Vec<Vec<Node>>),
}

/// What an instruction is to the power that flows.
#[derive(Debug)]
pub enum Element {
    /// Lets power through or not.
    Condition(Condition),
    /// Acts, and passes power on.
    Output(&'static Instruction, Vec<OperandRecord>),
    /// A call of an Add-On Instruction; its EnableOut says what it passes on. The operands are the instance, then arguments.
    AddOn(AddOnIndex, Vec<OperandRecord>),
}

/// What lets power through or not, and on what that depends.
#[derive(Debug)]
pub enum Condition {
    /// XIC and XIO: a bit, and the value that lets power through.
    Contact(Reference, bool),
    /// ONS, with its storage bit.
    OneShot(Reference),
    /// A comparison of two values, or LIM.
    Comparison(Opcode, Vec<OperandRecord>),
    /// Anything else.
    Other,
}

impl Element {
    /// Whether it lets power through or not.
    pub fn is_condition(&self) -> bool {
        matches!(self, Element::Condition(_))
    }
}

impl Program {
    /// Decodes the rungs of an image.
    pub fn new(image: &AdmittedImage) -> Program {
        let mut program = Program { rungs: Vec::new(), first: vec![0] };
        for (index, routine) in image.image().routines.iter().enumerate() {
            let owner = match routine.owner {
                Owner::AddOn(add_on) => Some(add_on),
                Owner::Program(_) => None,
            };
            let texts = routine.text.lines();
            let rungs = Builder { image, owner, open: Vec::new(), elements: Vec::new() }.rungs(&routine.code);
            for (number, ((series, elements), text)) in rungs.into_iter().zip(texts).enumerate() {
                program.rungs.push(Rung {
                    routine: RoutineIndex(index as u32),
                    number: number as u32,
                    series,
                    names: names(text, elements.len()),
                    elements,
                    text: text.to_owned(),
                });
            }
            program.first.push(program.rungs.len() as u32);
        }
        program
    }

    /// The rung at a place.
    pub fn at(&self, routine: RoutineIndex, number: u32) -> Option<RungId> {
        let (begin, end) = (self.first.get(routine.position())?, self.first.get(routine.position() + 1)?);
        let id = begin.checked_add(number)?;
        (id < *end).then_some(RungId(id))
    }

    /// A rung.
    pub fn rung(&self, id: RungId) -> &Rung {
        &self.rungs[id.0 as usize]
    }

    /// All rungs with their ids.
    pub fn rungs(&self) -> impl Iterator<Item = (RungId, &Rung)> {
        self.rungs.iter().enumerate().map(|(id, rung)| (RungId(id as u32), rung))
    }

    /// How many.
    pub fn len(&self) -> usize {
        self.rungs.len()
    }
}

/// The texts of the instructions of a rung, in order.
fn names(text: &str, count: usize) -> Vec<String> {
    let (sources, rung) = parsed(text);
    let mut names = Vec::with_capacity(count);
    if let Some(rung) = rung {
        collect(&rung.elements, &mut |instruction| names.push(sources.text(instruction.span).to_owned()));
    }
    names.resize(count, String::new());
    names
}

/// The rung of a canonical text, as the drawing of ladder wants it.
pub(crate) fn parsed(text: &str) -> (twinrung_grammar::tree::Sources, Option<twinrung_grammar::tree::Rung>) {
    let mut sources = twinrung_grammar::tree::Sources::new();
    let whole = format!("ROUTINE R\nN: {text}\nEND_ROUTINE\n");
    let reading = twinrung_grammar::read(&mut sources, "rung.rll", whole.into_bytes());
    let rung = reading.file.routines.first().and_then(|routine| routine.rungs().first().cloned());
    (sources, rung)
}

/// Visits the instructions of a rung in the order of the code.
pub(crate) fn collect(
    elements: &[twinrung_grammar::tree::Element],
    visit: &mut impl FnMut(&twinrung_grammar::tree::Instruction),
) {
    for element in elements {
        match element {
            twinrung_grammar::tree::Element::Instruction(instruction) => visit(instruction),
            twinrung_grammar::tree::Element::Branch(branch) => {
                branch.legs.iter().for_each(|leg| collect(&leg.elements, visit));
            }
        }
    }
}

type Decoded = (Vec<Node>, Vec<Element>);

/// Reads marks.
struct Builder<'a> {
    image: &'a AdmittedImage,
    owner: Option<AddOnIndex>,
    /// Series that are not closed, and the legs of their branches.
    open: Vec<(Vec<Node>, Vec<Vec<Node>>)>,
    elements: Vec<Element>,
}

impl Builder<'_> {
    fn rungs(mut self, code: &[u8]) -> Vec<Decoded> {
        let mut rungs = Vec::new();
        let mut series: Vec<Node> = Vec::new();
        for mark in Marks::new(code).map_while(Result::ok) {
            match mark {
                Mark::Rung => series.clear(),
                Mark::EndRung => rungs.push((std::mem::take(&mut series), std::mem::take(&mut self.elements))),
                Mark::Branch => self.open.push((std::mem::take(&mut series), Vec::new())),
                Mark::NextLeg => {
                    if let Some((_, legs)) = self.open.last_mut() {
                        legs.push(std::mem::take(&mut series));
                    }
                }
                Mark::EndBranch => {
                    if let Some((before, mut legs)) = self.open.pop() {
                        legs.push(std::mem::replace(&mut series, before));
                        series.push(Node::Branch(legs));
                    }
                }
                Mark::Instruction(instruction, operands) => {
                    series.push(Node::Element(self.elements.len() as u32));
                    let element = self.instruction(instruction, operands);
                    self.elements.push(element);
                }
                Mark::AddOn(operands) => {
                    series.push(Node::Element(self.elements.len() as u32));
                    let element = self.add_on(operands);
                    self.elements.push(element);
                }
            }
        }
        rungs
    }

    fn records(&self, operands: Operands<'_>) -> Vec<OperandRecord> {
        let table = &self.image.image().operands;
        operands.iter().filter_map(|index| OperandRecord::decode(table.entry(index)?).ok()).collect()
    }

    fn instruction(&self, instruction: &'static Instruction, operands: Operands<'_>) -> Element {
        let mut records = self.records(operands);
        if instruction.position != Position::Input {
            return Element::Output(instruction, records);
        }
        Element::Condition(match (instruction.opcode, records.first()) {
            (Opcode::Xic | Opcode::Xio | Opcode::Ons, Some(OperandRecord::Reference(_))) => {
                let OperandRecord::Reference(reference) = records.swap_remove(0) else {
                    return Element::Condition(Condition::Other);
                };
                match instruction.opcode {
                    Opcode::Ons => Condition::OneShot(reference),
                    opcode => Condition::Contact(reference, opcode == Opcode::Xic),
                }
            }
            (
                opcode @ (Opcode::Equ
                | Opcode::Neq
                | Opcode::Grt
                | Opcode::Geq
                | Opcode::Les
                | Opcode::Leq
                | Opcode::Lim),
                _,
            ) => Condition::Comparison(opcode, records),
            _ => Condition::Other,
        })
    }

    fn add_on(&self, operands: Operands<'_>) -> Element {
        use twinrung_bytecode::image::TypeKind;
        use twinrung_bytecode::operand::AccessType;
        let records = self.records(operands);
        let of_instance = records.first().and_then(|record| match record {
            OperandRecord::Reference(reference) => match reference.access.access_type {
                AccessType::Structure(index) => match self.image.image().types.get(index.position())?.kind {
                    TypeKind::AddOn(add_on) => Some(add_on),
                    _ => None,
                },
                AccessType::Element(_) => None,
            },
            _ => None,
        });
        // The verifier admits no call without an instance.
        Element::AddOn(of_instance.or(self.owner).unwrap_or(AddOnIndex(0)), records)
    }
}
