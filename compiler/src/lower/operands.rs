//! The operand table: each entry once, subscripts before what uses them.

use twinrung_bytecode::format;
use twinrung_bytecode::image::{Image, OperandTable, SystemValueRecord, TypeReference};
use twinrung_bytecode::index::{EventTaskIndex, OperandIndex, SystemValueIndex};
use twinrung_bytecode::operand as record;
use twinrung_bytecode::operand::OperandRecord;

use super::order::Order;
use crate::names::Map;
use crate::operand::{
    BinaryOperator, BitPlace, Expression, LocationBase, Operand, Reference, Root, Shape, Step, Subscript,
    SystemInstance, SystemValue, UnaryOperator,
};
use crate::project::{OperandId, Project, TagId};

/// Makes the operand table.
pub(super) struct Interner<'a> {
    project: &'a Project,
    order: &'a Order,
    /// First bit and word cell of each tag of the project.
    cells: Vec<(u32, u32)>,
    known: Map<Box<[u8]>, u32>,
    by_id: Vec<Option<OperandIndex>>,
    tables: Tables,
    next_value: u32,
    values: Map<(u8, u32), u16>,
    tasks: Map<String, u16>,
    buffer: Vec<u8>,
}

/// What the interner leaves behind.
pub(super) struct Tables {
    pub operands: OperandTable,
    pub system_values: Vec<SystemValueRecord>,
    pub event_tasks: Vec<String>,
}

impl<'a> Interner<'a> {
    /// Tags of the image have their cells already.
    pub fn new(project: &'a Project, order: &'a Order, image: &Image) -> Interner<'a> {
        let mut cells = vec![(0, 0); project.tags.len()];
        for (id, tag) in order.tags.iter().zip(&image.tags) {
            cells[id.position()] = (tag.bit_cell, tag.word_cell);
        }
        let operands = OperandTable { offsets: vec![0], bytes: Vec::new() };
        Interner {
            project,
            order,
            cells,
            known: Map::default(),
            by_id: vec![None; project.operands.len()],
            tables: Tables { operands, system_values: Vec::new(), event_tasks: Vec::new() },
            next_value: 0,
            values: Map::default(),
            tasks: Map::default(),
            buffer: Vec::new(),
        }
    }

    /// The entries of the project's operands so far.
    pub fn by_id(&self) -> &[Option<OperandIndex>] {
        &self.by_id
    }

    pub fn finish(self) -> Tables {
        self.tables
    }

    /// The entry of an operand of the project.
    pub fn id(&mut self, id: OperandId) -> OperandIndex {
        if let Some(known) = self.by_id[id.position()] {
            return known;
        }
        let project = self.project;
        let index = self.operand(project.operand(id));
        self.by_id[id.position()] = Some(index);
        index
    }

    /// The entry of an operand.
    pub fn operand(&mut self, operand: &Operand) -> OperandIndex {
        let record = match operand {
            Operand::Integer { value, radix } => OperandRecord::Integer { radix: *radix, value: *value },
            Operand::Real(bits) => OperandRecord::Real(*bits),
            Operand::Choice(value) => OperandRecord::Choice(*value),
            Operand::Unassigned => OperandRecord::Unassigned,
            Operand::Text(text) => OperandRecord::Text(text.to_string()),
            Operand::Routine(routine) => OperandRecord::Routine(self.order.routine(*routine)),
            Operand::Status(keyword) => OperandRecord::Status(*keyword),
            Operand::SystemValue(value) => OperandRecord::SystemValue(self.system_value(value)),
            Operand::EventTask(task) => OperandRecord::EventTask(self.event_task(task)),
            Operand::Expression(expression) => self.expression(expression),
            Operand::Reference(reference) => OperandRecord::Reference(self.reference(reference)),
        };
        self.intern(&record)
    }

    fn intern(&mut self, record: &OperandRecord) -> OperandIndex {
        self.buffer.clear();
        record.encode(&mut self.buffer);
        if let Some(known) = self.known.get(self.buffer.as_slice()) {
            return OperandIndex(*known);
        }
        let table = &mut self.tables.operands;
        let index = (table.offsets.len() - 1) as u32;
        table.bytes.extend_from_slice(&self.buffer);
        table.offsets.push(table.bytes.len() as u32);
        self.known.insert(self.buffer.as_slice().into(), index);
        OperandIndex(index)
    }

    fn system_value(&mut self, value: &SystemValue) -> SystemValueIndex {
        let (instance, program) = match value.instance {
            SystemInstance::Task | SystemInstance::Controller => (0, None),
            SystemInstance::Program(program) => {
                let program = self.order.program(program);
                (u32::from(program.0), Some(program))
            }
            SystemInstance::Routine(routine) => (self.order.routine(routine).0, None),
        };
        let attribute = value.attribute.number;
        if let Some(known) = self.values.get(&(attribute, instance)) {
            return SystemValueIndex(*known);
        }
        let index = self.tables.system_values.len() as u16;
        self.tables.system_values.push(SystemValueRecord { attribute, instance, first: self.next_value, program });
        self.next_value += value.attribute.length;
        self.values.insert((attribute, instance), index);
        SystemValueIndex(index)
    }

    fn event_task(&mut self, task: &str) -> EventTaskIndex {
        if let Some(known) = self.tasks.get(task) {
            return EventTaskIndex(*known);
        }
        let index = self.tables.event_tasks.len() as u16;
        self.tables.event_tasks.push(task.to_owned());
        self.tasks.insert(task.to_owned(), index);
        EventTaskIndex(index)
    }

    fn expression(&mut self, expression: &Expression) -> OperandRecord {
        let mut operations = Vec::new();
        self.postfix(expression, &mut operations);
        OperandRecord::Expression(operations)
    }

    /// Bounded by the limits on expressions, which the reading applies.
    fn postfix(&mut self, expression: &Expression, out: &mut Vec<record::Operation>) {
        match expression {
            Expression::Integer { value, radix } => {
                let index = self.intern(&OperandRecord::Integer { radix: *radix, value: *value });
                out.push(record::Operation::Push(index));
            }
            Expression::Real(bits) => {
                let index = self.intern(&OperandRecord::Real(*bits));
                out.push(record::Operation::Push(index));
            }
            Expression::Reference(reference) => {
                let lowered = OperandRecord::Reference(self.reference(reference));
                let index = self.intern(&lowered);
                out.push(record::Operation::Push(index));
            }
            Expression::Unary(operator, operand) => {
                self.postfix(operand, out);
                out.push(record::Operation::Apply(unary(*operator)));
            }
            Expression::Binary(operator, left, right) => {
                self.postfix(left, out);
                self.postfix(right, out);
                out.push(record::Operation::Apply(binary(*operator)));
            }
        }
    }

    /// A subscript or bit number: a reference stands as itself, anything else as an expression.
    fn subscript(&mut self, expression: &Expression) -> OperandIndex {
        let lowered = match expression {
            Expression::Reference(reference) => OperandRecord::Reference(self.reference(reference)),
            other => self.expression(other),
        };
        self.intern(&lowered)
    }

    fn reference(&mut self, reference: &Reference) -> record::Reference {
        let location = &reference.location;
        let mut steps = Vec::with_capacity(reference.steps.len());
        let mut variable = Vec::new();
        let mut bit_operand = None;
        for step in &reference.steps {
            steps.push(match step {
                Step::Member(member) => record::Step::Member(*member),
                Step::Subscript(list) => record::Step::Subscript(
                    list.iter()
                        .map(|subscript| match subscript {
                            Subscript::Constant(number) => record::Subscript::Constant(*number),
                            Subscript::Expression(expression) => {
                                let operand = self.subscript(expression);
                                variable.push(operand);
                                record::Subscript::Operand(operand)
                            }
                        })
                        .collect(),
                ),
                Step::Bit(bit) => record::Step::Bit(*bit),
                Step::BitExpression(expression) => {
                    let operand = self.subscript(expression);
                    bit_operand = Some(operand);
                    record::Step::BitOperand(operand)
                }
            });
        }
        let (base, first) = match location.base {
            LocationBase::Tag(tag) => (record::Base::Absolute, self.cells_of(tag)),
            LocationBase::Instance => (record::Base::Instance, (0, 0)),
            LocationBase::InOut(parameter) => (record::Base::InOut(parameter), (0, 0)),
        };
        let length = match reference.type_reference {
            TypeReference::Element(element) => element.bits(),
            TypeReference::Structure(_) => 0,
        };
        let shape = match (reference.shape(), location.bit, bit_operand) {
            (Shape::WordBit, Some(BitPlace::Constant(bit)), _) => {
                record::Shape::WordBit(record::BitNumber::Constant { bit, length })
            }
            (Shape::WordBit, _, Some(operand)) => {
                record::Shape::WordBit(record::BitNumber::Operand { operand, length })
            }
            (Shape::Bit, ..) => record::Shape::Bit,
            (Shape::Word, ..) => record::Shape::Word,
            (Shape::Region | Shape::WordBit, ..) => record::Shape::Region,
        };
        let terms = location.terms.iter().zip(variable).map(|(term, operand)| record::Term {
            operand,
            length: term.length,
            bit_stride: term.bit_stride,
            word_stride: term.word_stride,
        });
        record::Reference {
            root: match reference.root {
                Root::Tag(tag) => record::Root::Tag(self.order.tag(tag)),
                Root::Member(add_on, member) => record::Root::Member(self.order.add_on(add_on), member),
                Root::InOut(add_on, parameter) => record::Root::InOut(self.order.add_on(add_on), parameter),
            },
            steps,
            access: record::Access {
                shape,
                access_type: match self.order.type_reference(reference.type_reference) {
                    TypeReference::Element(element) => record::AccessType::Element(element),
                    TypeReference::Structure(index) => record::AccessType::Structure(index),
                },
                base,
                bit_cell: first.0 + location.bit_cell,
                word_cell: first.1 + location.word_cell,
                count: location.count,
                terms: terms.collect(),
            },
        }
    }

    fn cells_of(&self, tag: TagId) -> (u32, u32) {
        self.cells.get(tag.position()).copied().unwrap_or_default()
    }
}

fn unary(operator: UnaryOperator) -> u8 {
    match operator {
        UnaryOperator::Negate => format::OPERATION_NEGATE,
        UnaryOperator::Not => format::OPERATION_NOT,
        UnaryOperator::Absolute => format::OPERATION_ABSOLUTE,
        UnaryOperator::SquareRoot => format::OPERATION_SQUARE_ROOT,
    }
}

fn binary(operator: BinaryOperator) -> u8 {
    match operator {
        BinaryOperator::Multiply => format::OPERATION_MULTIPLY,
        BinaryOperator::Divide => format::OPERATION_DIVIDE,
        BinaryOperator::Modulo => format::OPERATION_MODULO,
        BinaryOperator::Add => format::OPERATION_ADD,
        BinaryOperator::Subtract => format::OPERATION_SUBTRACT,
        BinaryOperator::And => format::OPERATION_AND,
        BinaryOperator::Xor => format::OPERATION_XOR,
        BinaryOperator::Or => format::OPERATION_OR,
        BinaryOperator::Less => format::OPERATION_LESS,
        BinaryOperator::LessOrEqual => format::OPERATION_LESS_OR_EQUAL,
        BinaryOperator::Greater => format::OPERATION_GREATER,
        BinaryOperator::GreaterOrEqual => format::OPERATION_GREATER_OR_EQUAL,
        BinaryOperator::Equal => format::OPERATION_EQUAL,
        BinaryOperator::NotEqual => format::OPERATION_NOT_EQUAL,
    }
}
