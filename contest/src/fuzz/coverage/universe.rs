//! Everything that can be reached, from the catalog's one declaration: each instruction, each operand, each form that its kind
//! admits, each class of values that it reads, each outcome.

use std::collections::BTreeMap;
use std::fmt;
use std::num::NonZeroU32;
use std::sync::OnceLock;

use twinrung_bytecode::format;
use twinrung_bytecode::image::Image;
use twinrung_bytecode::index::OperandIndex;
use twinrung_bytecode::operand::OperandRecord;
use twinrung_catalog::instructions::system::ATTRIBUTES;
use twinrung_catalog::{Access, Element, Instruction, Opcode, OperandKind, Position};

use super::class::Class;
use super::form::{self, Extent, Form};

/// One thing that an execution can reach.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct Point {
    /// The instruction.
    pub opcode: Opcode,
    /// What of it.
    pub what: What,
}

/// What of an instruction.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum What {
    /// It was evaluated with this rung condition before it, and this one behind it.
    Outcome(bool, bool),
    /// The operand at a position, from 0, had this form, and the rung was true.
    Operand(u8, Form),
    /// The operand at a position, from 0, was a value of this class.
    Value(u8, Class),
}

/// All points, numbered.
#[derive(Debug)]
pub struct Universe {
    points: Vec<Point>,
    numbers: BTreeMap<Point, u32>,
    /// For each opcode, position and class the number of the point, since these are looked up all the time.
    values: Vec<Option<NonZeroU32>>,
    /// For each opcode the numbers of its outcomes.
    outcomes: Vec<[Option<u32>; 3]>,
}

/// More operands than any instruction has.
const POSITIONS: usize = 32;
const CLASSES: usize = Class::NotANumber as usize + 1;

impl Universe {
    /// The one there is.
    pub fn get() -> &'static Universe {
        static UNIVERSE: OnceLock<Universe> = OnceLock::new();
        UNIVERSE.get_or_init(|| {
            let mut points: Vec<Point> = Opcode::ALL.iter().flat_map(|opcode| of(opcode.instruction())).collect();
            points.sort_unstable();
            points.dedup();
            let numbers: BTreeMap<Point, u32> =
                points.iter().enumerate().map(|(number, point)| (*point, number as u32)).collect();
            let mut values = vec![None; 256 * POSITIONS * CLASSES];
            let mut outcomes = vec![[None; 3]; 256];
            for (point, number) in &numbers {
                match point.what {
                    What::Value(position, class) => {
                        values[value_index(point.opcode, position, class)] = NonZeroU32::new(number + 1);
                    }
                    What::Outcome(before, behind) => {
                        outcomes[point.opcode as usize][outcome_index(before, behind)] = Some(*number);
                    }
                    What::Operand(..) => {}
                }
            }
            Universe { points, numbers, values, outcomes }
        })
    }

    /// All points, by number.
    pub fn points(&self) -> &[Point] {
        &self.points
    }

    /// The number of a point; none where the declaration does not admit it.
    pub fn number(&self, opcode: Opcode, what: What) -> Option<u32> {
        match what {
            What::Value(position, class) => {
                self.values.get(value_index(opcode, position, class))?.map(|number| number.get() - 1)
            }
            What::Outcome(before, behind) => self.outcomes[opcode as usize][outcome_index(before, behind)],
            What::Operand(..) => self.numbers.get(&Point { opcode, what }).copied(),
        }
    }
}

fn value_index(opcode: Opcode, position: u8, class: Class) -> usize {
    (opcode as usize * POSITIONS + usize::from(position)) * CLASSES + class as usize
}

fn outcome_index(before: bool, behind: bool) -> usize {
    if before { 1 + usize::from(behind) } else { 0 }
}

fn of(instruction: &'static Instruction) -> Vec<Point> {
    let mut all = vec![What::Outcome(false, false), What::Outcome(true, true)];
    if instruction.position == Position::Input {
        all.push(What::Outcome(true, false));
    }
    for (position, operand) in instruction.operands.iter().enumerate() {
        let position = position as u8;
        all.extend(admitted(instruction, operand.kind).into_iter().map(|form| What::Operand(position, form)));
        all.extend(read_classes(operand.kind).into_iter().map(|class| What::Value(position, class)));
    }
    all.into_iter().map(|what| Point { opcode: instruction.opcode, what }).collect()
}

/// The classes of values that an operand can be read with.
fn read_classes(kind: OperandKind) -> Vec<Class> {
    match kind {
        OperandKind::Number(Access::Read | Access::ReadWrite) => [Class::INTEGERS, Class::REALS].concat(),
        OperandKind::Integer(Access::Read | Access::ReadWrite) | OperandKind::SafetyInteger { .. } => {
            Class::INTEGERS.to_vec()
        }
        OperandKind::SafetyReal { .. } => Class::REALS.to_vec(),
        _ => Vec::new(),
    }
}

/// How data can be reached.
const REACHED: &[Form] = &[
    Form::Tag,
    Form::Member,
    Form::Element,
    Form::ElementByTag,
    Form::ElementByExpression,
    Form::Alias,
    Form::InOut,
    Form::Instance,
];
const INTEGERS: &[Form] = &[Form::Of(Element::Sint), Form::Of(Element::Int), Form::Of(Element::Dint)];
const BITS: &[Form] = &[
    Form::Of(Element::Bool),
    Form::BitOf(Element::Sint),
    Form::BitOf(Element::Int),
    Form::BitOf(Element::Dint),
    Form::BitByTag,
];
const REAL: &[Form] = &[Form::Of(Element::Real)];
const LITERALS: &[Form] = &[Form::Integer, Form::Real];

/// The forms that a kind of operand admits.
fn admitted(instruction: &Instruction, kind: OperandKind) -> Vec<Form> {
    let reads = |access: Access| access == Access::Read;
    let words = |values: &[i32]| values.iter().map(|value| Form::Word(*value)).collect::<Vec<Form>>();
    match kind {
        OperandKind::Bit(access) => {
            let status = (0..format::STATUS_KEYWORDS.len() as u8).map(Form::Status).filter(|_| reads(access));
            [REACHED, BITS].concat().into_iter().chain(status).collect()
        }
        OperandKind::Number(access) => [REACHED, INTEGERS, REAL, if reads(access) { LITERALS } else { &[] }].concat(),
        OperandKind::Integer(access) => {
            [REACHED, INTEGERS, if reads(access) { &[Form::Integer] } else { &[] }].concat()
        }
        OperandKind::Structure(..) | OperandKind::Resettable => REACHED.to_vec(),
        OperandKind::Pseudo(_) => vec![Form::Unassigned, Form::Integer],
        OperandKind::CopySource | OperandKind::CopyDestination => {
            [REACHED, INTEGERS, REAL, &[Form::Structure, Form::WholeArray]].concat()
        }
        OperandKind::FillDestination => [REACHED, INTEGERS, REAL, &[Form::WholeArray]].concat(),
        OperandKind::ConstantLength | OperandKind::InputCount => vec![Form::Integer],
        OperandKind::Expression => [REACHED, INTEGERS, REAL, LITERALS, &operators(format::OPERATION_OR)].concat(),
        OperandKind::Condition => [REACHED, INTEGERS, REAL, LITERALS, &operators(format::OPERATION_NOT_EQUAL)].concat(),
        OperandKind::FileMode => words(&[0, -1, 1]),
        OperandKind::ByteOrder | OperandKind::Dimension => words(&[0, 1, 2]),
        OperandKind::Array => [REACHED, INTEGERS, REAL, &[Form::Structure, Form::WholeArray]].concat(),
        OperandKind::Label | OperandKind::LabelDefinition | OperandKind::SystemClass => vec![Form::Name],
        OperandKind::Routine => vec![Form::Routine],
        OperandKind::Parameter(access) => {
            let literals = if access == Access::Write { &[][..] } else { LITERALS };
            [REACHED, INTEGERS, REAL, &[Form::Of(Element::Bool), Form::Structure], literals].concat()
        }
        OperandKind::EventTask => vec![Form::EventTask],
        OperandKind::SystemInstance => vec![Form::Name],
        OperandKind::SystemAttribute => {
            let sets = instruction.opcode == Opcode::Ssv;
            let reachable = ATTRIBUTES.iter().filter(|attribute| attribute.writable || !sets);
            reachable.map(|attribute| Form::Attribute(attribute.number)).collect()
        }
        OperandKind::SystemData(_) => [REACHED, INTEGERS, REAL, &[Form::Structure, Form::WholeArray]].concat(),
        OperandKind::Choice(list) => words(&list.words.iter().map(|(_, value)| *value).collect::<Vec<i32>>()),
        OperandKind::Literal { or_zero, least, greatest, .. } => {
            let zero = or_zero && least > 0;
            let between = greatest > least.saturating_add(1);
            let all =
                [(zero, Extent::Zero), (true, Extent::Least), (between, Extent::Between), (true, Extent::Greatest)];
            all.into_iter().filter(|(is, _)| *is).map(|(_, extent)| Form::Literal(extent)).collect()
        }
        OperandKind::SafetyBit { immediate } => {
            let literals = [Form::Word(0), Form::Word(1)];
            [REACHED, BITS, if immediate { &literals } else { &[] }].concat()
        }
        OperandKind::SafetyInteger { immediate, .. } => {
            let literals = [Extent::Least, Extent::Between, Extent::Greatest].map(Form::Literal);
            [REACHED, INTEGERS, if immediate.is_some() { &literals } else { &[] }].concat()
        }
        OperandKind::SafetyReal { immediate, .. } => {
            [REACHED, REAL, if immediate { &[Form::Real] } else { &[] }].concat()
        }
    }
}

/// The operators from the first to this one.
fn operators(last: u8) -> Vec<Form> {
    let known = |one: &u8| !(format::OPERATION_SQUARE_ROOT + 1..format::OPERATION_MULTIPLY).contains(one);
    (format::OPERATION_NEGATE..=last).filter(known).map(Form::Operator).collect()
}

/// The forms of an operand of an image, as far as its kind tells them apart.
pub fn forms(image: &Image, kind: OperandKind, index: OperandIndex) -> Vec<Form> {
    let mut forms = Vec::new();
    let Some(operand) = form::operand(image, index) else { return forms };
    match (operand, kind) {
        (OperandRecord::Reference(reference), _) => form::of_reference(image, &reference, &mut forms),
        (OperandRecord::Expression(operations), _) => form::of_expression(image, &operations, &mut forms),
        (OperandRecord::Choice(value), OperandKind::FileMode) => forms.push(Form::Word(value.min(1))),
        (OperandRecord::Integer { value, .. }, OperandKind::Dimension | OperandKind::SafetyBit { .. })
        | (OperandRecord::Choice(value), _) => forms.push(Form::Word(value)),
        (OperandRecord::Integer { value, .. }, OperandKind::Literal { least, greatest, .. })
        | (
            OperandRecord::Integer { value, .. },
            OperandKind::SafetyInteger { immediate: Some((least, greatest)), .. },
        ) => forms.push(Form::Literal(Extent::of(value, least, greatest))),
        (OperandRecord::Integer { .. }, _) => forms.push(Form::Integer),
        (OperandRecord::Real(_), _) => forms.push(Form::Real),
        (OperandRecord::Unassigned, _) => forms.push(Form::Unassigned),
        (OperandRecord::Text(_), _) => forms.push(Form::Name),
        (OperandRecord::Routine(_), _) => forms.push(Form::Routine),
        (OperandRecord::Status(keyword), _) => forms.push(Form::Status(keyword)),
        (OperandRecord::SystemValue(value), _) => {
            let record = image.system_values.get(value.position());
            forms.extend(record.map(|record| Form::Attribute(record.attribute)));
        }
        (OperandRecord::EventTask(_), _) => forms.push(Form::EventTask),
    }
    forms
}

impl fmt::Display for Point {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let instruction = self.opcode.instruction();
        let name = |position: u8| instruction.operands.get(usize::from(position)).map_or("?", |operand| operand.name);
        let truth = |is: bool| if is { "true" } else { "false" };
        write!(f, "{}", instruction.mnemonic)?;
        match self.what {
            What::Outcome(false, _) => write!(f, " on a false rung"),
            What::Outcome(true, _) if instruction.position != Position::Input => write!(f, " on a true rung"),
            What::Outcome(true, out) => write!(f, " {}", truth(out)),
            What::Operand(position, Form::Operator(operator)) => {
                write!(f, " {} operator {}", name(position), operator_words(operator))
            }
            What::Operand(position, Form::Word(value)) => {
                let word = match instruction.operands.get(usize::from(position)).map(|operand| operand.kind) {
                    Some(OperandKind::Choice(list)) => list.word(value),
                    _ => None,
                };
                write!(f, " {} {}", name(position), word.map_or_else(|| value.to_string(), str::to_owned))
            }
            What::Operand(position, form) => write!(f, " {} {form:?}", name(position)),
            What::Value(position, class) => write!(f, " {} value {class:?}", name(position)),
        }
    }
}

fn operator_words(operator: u8) -> &'static str {
    match operator {
        format::OPERATION_NEGATE => "negative",
        format::OPERATION_NOT => "NOT",
        format::OPERATION_ABSOLUTE => "ABS",
        format::OPERATION_SQUARE_ROOT => "SQR",
        format::OPERATION_MULTIPLY => "*",
        format::OPERATION_DIVIDE => "/",
        format::OPERATION_MODULO => "MOD",
        format::OPERATION_ADD => "+",
        format::OPERATION_SUBTRACT => "-",
        format::OPERATION_AND => "AND",
        format::OPERATION_XOR => "XOR",
        format::OPERATION_OR => "OR",
        format::OPERATION_LESS => "<",
        format::OPERATION_LESS_OR_EQUAL => "<=",
        format::OPERATION_GREATER => ">",
        format::OPERATION_GREATER_OR_EQUAL => ">=",
        format::OPERATION_EQUAL => "=",
        format::OPERATION_NOT_EQUAL => "<>",
        _ => "?",
    }
}
