//! Resolves entries of the operand table: this channel's own reading of `twinrung_bytecode::format`.

use alloc::vec;
use alloc::vec::Vec;

use twinrung_bytecode::format;
use twinrung_bytecode::image::{TypeKind, TypeReference};
use twinrung_bytecode::index::{OperandIndex, TypeIndex};
use twinrung_bytecode::layout;
use twinrung_catalog::Element;

use super::context::{Base, Context, Instance};
use super::cursor::Cursor;
use super::{Loader, Unit};
use crate::ladder::{Argument, Dynamic, Expression, Field, Location, Operation, Span, StructureKind};
use crate::load::LoadError;

/// Operations of all addresses and expressions together: far more than any application has, few enough to hold.
const OPERATIONS: usize = 1 << 23;
/// Values that may be open at once, nested subscripts included.
pub(crate) const VALUES: usize = 512;
/// Addresses that may be open at once.
pub(crate) const ADDRESSES: usize = 32;

/// A reference's access as its bytes have it.
struct Access<'a> {
    path: &'a [u8],
    shape: u8,
    element: Option<Element>,
    type_index: Option<TypeIndex>,
    base: u8,
    parameter: u16,
    bit: u32,
    word: u32,
    count: u32,
    terms: &'a [u8],
    bit_number: u8,
    bit_operand: u32,
    bit_length: u8,
}

/// Bytes of one variable subscript.
const TERM_BYTES: usize = 16;

/// A variable subscript.
struct Term {
    operand: OperandIndex,
    length: u32,
    bits: u32,
    words: u32,
}

fn term(bytes: &[u8]) -> Option<Term> {
    let mut cursor = Cursor::new(bytes);
    Some(Term {
        operand: OperandIndex(cursor.word()?),
        length: cursor.word()?,
        bits: cursor.word()?,
        words: cursor.word()?,
    })
}

fn element(number: u8) -> Option<Element> {
    Element::ALL.into_iter().find(|element| *element as u8 == number)
}

fn access<'a>(cursor: &mut Cursor<'a>) -> Option<Access<'a>> {
    let path_length = cursor.half()?;
    let path = cursor.take(usize::from(path_length))?;
    let shape = cursor.byte()?;
    let element = element(cursor.byte()?);
    let type_index = Some(cursor.half()?).filter(|index| *index != format::NO_INDEX).map(TypeIndex);
    let base = cursor.byte()?;
    let parameter = cursor.half()?;
    let (bit, word, count) = (cursor.word()?, cursor.word()?, cursor.word()?);
    let terms = usize::from(cursor.byte()?);
    let terms = cursor.take(terms.checked_mul(TERM_BYTES)?)?;
    let (bit_number, bit_operand, bit_length) = (cursor.byte()?, cursor.word()?, cursor.byte()?);
    Some(Access {
        path,
        shape,
        element,
        type_index,
        base,
        parameter,
        bit,
        word,
        count,
        terms,
        bit_number,
        bit_operand,
        bit_length,
    })
}

impl Access<'_> {
    fn is_static(&self) -> bool {
        self.terms.is_empty() && (self.shape != format::SHAPE_WORD_BIT || self.bit_number != format::NO_BIT)
    }
}

/// The end of a reference's path.
struct PathEnd {
    /// The last step is a subscript: the reference designates an element.
    is_element: bool,
    /// How many variable subscripts that last step has.
    variable: usize,
    /// Dimensions of the tag, member or parameter that the path reached last.
    dimensions: [u32; 3],
}

fn path_end(unit: Unit<'_>, path: &[u8]) -> Option<PathEnd> {
    let mut cursor = Cursor::new(path);
    let image = unit.image;
    let (mut type_reference, dimensions) = match cursor.byte()? {
        format::ROOT_TAG => {
            let tag = image.tags.get(cursor.word()? as usize)?;
            (tag.type_reference, tag.dimensions)
        }
        format::ROOT_MEMBER => {
            let add_on = image.add_ons.get(usize::from(cursor.half()?))?;
            let record = image.types.get(add_on.instance_type.position())?;
            let member = record.members.get(usize::from(cursor.half()?))?;
            (member.type_reference, member.dimensions)
        }
        format::ROOT_IN_OUT => {
            let add_on = image.add_ons.get(usize::from(cursor.half()?))?;
            let parameter = add_on.parameters.get(usize::from(cursor.half()?))?;
            (parameter.type_reference, parameter.dimensions)
        }
        _ => return None,
    };
    let mut end = PathEnd { is_element: false, variable: 0, dimensions };
    while !cursor.is_empty() {
        match cursor.byte()? {
            format::STEP_MEMBER => {
                let TypeReference::Structure(index) = type_reference else { return None };
                let member = image.types.get(index.position())?.members.get(usize::from(cursor.half()?))?;
                type_reference = member.type_reference;
                end = PathEnd { is_element: false, variable: 0, dimensions: member.dimensions };
            }
            format::STEP_SUBSCRIPT => {
                let count = cursor.byte()?;
                end.is_element = true;
                end.variable = 0;
                for _ in 0..count {
                    let variable = cursor.byte()? == format::SUBSCRIPT_OPERAND;
                    end.variable = end.variable.saturating_add(usize::from(variable));
                    cursor.word()?;
                }
            }
            format::STEP_BIT => {
                cursor.byte()?;
            }
            format::STEP_BIT_OPERAND => {
                cursor.word()?;
            }
            _ => return None,
        }
    }
    Some(end)
}

/// What is still to be emitted, last first.
enum Task {
    Value { operand: OperandIndex, real: bool, subscript: bool },
    Emit(Operation),
}

impl<'a> Loader<'a> {
    fn entry(&self, context: &Context, operand: OperandIndex) -> Option<Cursor<'a>> {
        self.unit(context.library)?.image.operands.entry(operand).map(Cursor::new)
    }

    /// Resolves an operand other than an expression.
    pub(crate) fn argument(&mut self, context: &Context, operand: OperandIndex) -> Result<Argument, LoadError> {
        self.try_argument(context, operand)?.ok_or(LoadError::Operand(operand))
    }

    fn try_argument(&mut self, context: &Context, operand: OperandIndex) -> Result<Option<Argument>, LoadError> {
        let Some(mut cursor) = self.entry(context, operand) else { return Ok(None) };
        let Some(kind) = cursor.byte() else { return Ok(None) };
        Ok(match kind {
            format::INTEGER => {
                cursor.byte();
                cursor.word().map(|value| Argument::Integer(value as i32))
            }
            format::CHOICE => cursor.word().map(|value| Argument::Integer(value as i32)),
            format::ROUTINE => cursor.word().map(|value| Argument::Integer(value as i32)),
            format::REAL => cursor.word().map(Argument::Real),
            format::UNASSIGNED | format::TEXT => Some(Argument::Nothing),
            format::STATUS => match cursor.byte() {
                Some(format::STATUS_FIRST_SCAN) => Some(Argument::At(Location::Bit(self.own.first_scan_bit))),
                other => other.map(Argument::Status),
            },
            format::SYSTEM_VALUE => cursor.half().map(Argument::SystemValue),
            format::EVENT_TASK => cursor.half().map(Argument::EventTask),
            format::REFERENCE => {
                let Some(access) = access(&mut cursor) else { return Ok(None) };
                let unit = match self.unit(context.library) {
                    Some(unit) => unit,
                    None => return Ok(None),
                };
                let Some(location) = place(unit, context, &access) else { return Ok(None) };
                if access.is_static() {
                    Some(Argument::At(location))
                } else {
                    let Some(tasks) = address_tasks(&access, location, 0, 1) else { return Ok(None) };
                    let begin = self.operations.len();
                    if !self.emit(context, tasks)? {
                        return Ok(None);
                    }
                    let dynamic = Dynamic { location, begin: begin as u32, end: self.operations.len() as u32 };
                    self.dynamics.push(dynamic);
                    Some(Argument::Dynamic(self.dynamics.len().wrapping_sub(1) as u32))
                }
            }
            _ => None,
        })
    }

    /// Resolves consecutive elements; `whole` elements of an array that is designated as a whole, else one.
    pub(crate) fn span(
        &mut self,
        context: &Context,
        operand: OperandIndex,
        parameter: bool,
    ) -> Result<Argument, LoadError> {
        self.try_span(context, operand, parameter)?.ok_or(LoadError::Operand(operand))
    }

    fn try_span(
        &mut self,
        context: &Context,
        operand: OperandIndex,
        parameter: bool,
    ) -> Result<Option<Argument>, LoadError> {
        let Some(mut cursor) = self.entry(context, operand) else { return Ok(None) };
        if cursor.byte() != Some(format::REFERENCE) {
            return if parameter { self.try_argument(context, operand) } else { Ok(None) };
        }
        let Some(access) = access(&mut cursor) else { return Ok(None) };
        if parameter && access.shape != format::SHAPE_REGION {
            return self.try_argument(context, operand);
        }
        let Some(unit) = self.unit(context.library) else { return Ok(None) };
        let Some(end) = path_end(unit, access.path) else { return Ok(None) };
        let Some(location) = place(unit, context, &access) else { return Ok(None) };
        let type_reference = match (access.element, access.type_index) {
            (Some(element), _) => TypeReference::Element(element),
            (None, Some(index)) => TypeReference::Structure(index),
            (None, None) => return Ok(None),
        };
        let Some((bits, words)) = layout::cells(unit.layouts, type_reference) else { return Ok(None) };
        let bytes = match type_reference {
            TypeReference::Element(element) => element.bytes(),
            TypeReference::Structure(index) => unit.layouts.get(index.position()).map_or(0, |layout| layout.bytes),
        };
        let stride = bits.max(words).max(1);
        let tasks = if access.is_static() {
            None
        } else {
            let Some(tasks) = address_tasks(&access, location, end.variable, stride) else { return Ok(None) };
            Some(tasks)
        };
        let (first_field, fields) = self.fields_of(context.library, type_reference);
        let start = match tasks {
            None => Argument::At(location),
            Some(tasks) => {
                let begin = self.operations.len();
                if !self.emit(context, tasks)? {
                    return Ok(None);
                }
                let dynamic = Dynamic { location, begin: begin as u32, end: self.operations.len() as u32 };
                self.dynamics.push(dynamic);
                Argument::Dynamic(self.dynamics.len().wrapping_sub(1) as u32)
            }
        };
        self.spans.push(Span {
            start,
            count: if parameter && end.is_element { 1 } else { access.count },
            bytes,
            bits,
            words,
            moves: end.variable > 0,
            first_field,
            fields,
        });
        Ok(Some(Argument::Span(self.spans.len().wrapping_sub(1) as u32)))
    }

    /// The fields of a type's elements, made once.
    fn fields_of(&mut self, library: bool, type_reference: TypeReference) -> (u32, u32) {
        let key = match type_reference {
            TypeReference::Element(element) => (library, true, element as u16),
            TypeReference::Structure(index) => (library, false, index.0),
        };
        if let Some(known) = self.known_fields.get(&key) {
            return *known;
        }
        let first = self.fields.len();
        if let Some(unit) = self.unit(library) {
            let list = layout::fields(&unit.image.types, unit.layouts, type_reference);
            self.fields.extend(list.into_iter().map(|field| Field {
                byte: field.byte,
                bit: field.bit,
                element: field.element,
                cell: field.cell,
            }));
        }
        let known = (first as u32, self.fields.len().wrapping_sub(first) as u32);
        self.known_fields.insert(key, known);
        known
    }

    /// Number of elements of a dimension of the array that a reference lies in.
    pub(crate) fn dimension(&self, context: &Context, operand: OperandIndex, number: i32) -> Result<i32, LoadError> {
        let find = || {
            let mut cursor = self.entry(context, operand)?;
            if cursor.byte()? != format::REFERENCE {
                return None;
            }
            let access = access(&mut cursor)?;
            let end = path_end(self.unit(context.library)?, access.path)?;
            let length = end.dimensions.get(usize::try_from(number).ok()?)?;
            i32::try_from(*length).ok()
        };
        find().ok_or(LoadError::Operand(operand))
    }

    /// Resolves an expression; `destination` says whether its result is stored into a REAL.
    pub(crate) fn expression(
        &mut self,
        context: &Context,
        operand: OperandIndex,
        destination_real: bool,
    ) -> Result<Argument, LoadError> {
        let real = destination_real || self.holds_real(context, operand).ok_or(LoadError::Operand(operand))?;
        let begin = self.operations.len();
        let tasks = vec![Task::Value { operand, real, subscript: false }];
        if !self.emit(context, tasks)? {
            return Err(LoadError::Operand(operand));
        }
        self.expressions.push(Expression { begin: begin as u32, end: self.operations.len() as u32 });
        Ok(Argument::Expression(self.expressions.len().wrapping_sub(1) as u32))
    }

    /// Whether an operand of the expression is REAL.
    fn holds_real(&self, context: &Context, operand: OperandIndex) -> Option<bool> {
        let mut cursor = self.entry(context, operand)?;
        let kind = cursor.byte()?;
        if kind != format::EXPRESSION {
            return self.is_real(context, operand);
        }
        let count = cursor.half()?;
        let mut real = false;
        for _ in 0..count {
            if cursor.byte()? == format::OPERATION_PUSH {
                real |= self.is_real(context, OperandIndex(cursor.word()?))?;
            }
        }
        Some(real)
    }

    fn is_real(&self, context: &Context, operand: OperandIndex) -> Option<bool> {
        let mut cursor = self.entry(context, operand)?;
        Some(match cursor.byte()? {
            format::REAL => true,
            format::REFERENCE => access(&mut cursor)?.element == Some(Element::Real),
            _ => false,
        })
    }

    /// Emits the tasks' operations; false when an operand is malformed.
    fn emit(&mut self, context: &Context, mut tasks: Vec<Task>) -> Result<bool, LoadError> {
        let (mut values, mut addresses) = (0usize, 0usize);
        while let Some(task) = tasks.pop() {
            let operation = match task {
                Task::Emit(operation) => operation,
                Task::Value { operand, real, subscript } => {
                    match self.value_tasks(context, operand, real, subscript, &mut tasks) {
                        Some(Some(operation)) => operation,
                        Some(None) => continue,
                        None => return Ok(false),
                    }
                }
            };
            match operation {
                Operation::Integer(_) | Operation::Real(_) | Operation::Word(..) => values = values.saturating_add(1),
                Operation::Address { .. } => addresses = addresses.saturating_add(1),
                Operation::Subscript { .. } | Operation::BitNumber(_) => values = values.saturating_sub(1),
                Operation::Load(_) => {
                    addresses = addresses.saturating_sub(1);
                    values = values.saturating_add(1);
                }
                Operation::Apply { operator, .. } => {
                    values = values.saturating_sub(usize::from(operator >= format::OPERATION_MULTIPLY));
                }
            }
            if values > VALUES
                || addresses > ADDRESSES
                || self.operations.len() >= OPERATIONS
                || tasks.len() > OPERATIONS
            {
                return Err(LoadError::Operations);
            }
            self.operations.push(operation);
        }
        Ok(true)
    }

    /// One operation for a value that needs no more, or `None` and further tasks; `None` outside when malformed.
    fn value_tasks(
        &self,
        context: &Context,
        operand: OperandIndex,
        real: bool,
        subscript: bool,
        tasks: &mut Vec<Task>,
    ) -> Option<Option<Operation>> {
        let mut cursor = self.entry(context, operand)?;
        match cursor.byte()? {
            format::INTEGER => {
                cursor.byte()?;
                Some(Some(Operation::Integer(cursor.word()? as i32)))
            }
            format::REAL => Some(Some(Operation::Real(cursor.word()?))),
            format::REFERENCE => {
                let access = access(&mut cursor)?;
                let location = place(self.unit(context.library)?, context, &access)?;
                let Location::Word(cell, element) = location else { return None };
                if access.is_static() {
                    return Some(Some(Operation::Word(cell, element)));
                }
                tasks.push(Task::Emit(Operation::Load(element)));
                tasks.extend(address_tasks(&access, location, 0, 1)?);
                Some(None)
            }
            format::EXPRESSION => {
                let count = cursor.half()?;
                let begin = tasks.len();
                for _ in 0..count {
                    tasks.push(match cursor.byte()? {
                        format::OPERATION_PUSH => {
                            Task::Value { operand: OperandIndex(cursor.word()?), real, subscript }
                        }
                        operator => Task::Emit(Operation::Apply { operator, real, subscript }),
                    });
                }
                tasks.get_mut(begin..)?.reverse();
                Some(None)
            }
            _ => None,
        }
    }
}

/// The cells of an access, without its variable subscripts.
fn place(unit: Unit<'_>, context: &Context, access: &Access<'_>) -> Option<Location> {
    let (bit, word) = match access.base {
        format::BASE_ABSOLUTE => (access.bit, access.word),
        format::BASE_INSTANCE => match &context.instance {
            Instance::None => return None,
            Instance::At { bit, word } => (bit.checked_add(access.bit)?, word.checked_add(access.word)?),
            Instance::Scattered { bits, words } => (
                bits.get(access.bit as usize).copied().unwrap_or(0),
                words.get(access.word as usize).copied().unwrap_or(0),
            ),
        },
        format::BASE_IN_OUT => match context.in_outs.get(usize::from(access.parameter)).copied().flatten()? {
            Base::Cells { bit, word } => (bit.checked_add(access.bit)?, word.checked_add(access.word)?),
            Base::WordBit { word, bit, element } => return Some(Location::WordBit(word, bit, element)),
        },
        _ => return None,
    };
    Some(match access.shape {
        format::SHAPE_BIT => Location::Bit(bit),
        format::SHAPE_WORD => Location::Word(word, access.element?),
        format::SHAPE_WORD_BIT => {
            let number = if access.bit_number == format::NO_BIT { 0 } else { access.bit_number };
            Location::WordBit(word, number, access.element?)
        }
        format::SHAPE_REGION => Location::Region { bit, word, kind: structure_kind(unit, access.type_index) },
        _ => return None,
    })
}

fn structure_kind(unit: Unit<'_>, index: Option<TypeIndex>) -> StructureKind {
    let record = index.and_then(|index| unit.image.types.get(index.position()));
    match record.filter(|record| record.kind == TypeKind::Predefined).map(|record| record.name.as_str()) {
        Some("TIMER") => StructureKind::Timer,
        Some("COUNTER") => StructureKind::Counter,
        Some("CONTROL") => StructureKind::Control,
        _ => StructureKind::Other,
    }
}

/// The tasks, last first, that leave the address of a variable access. `innermost` of its subscripts move within the
/// innermost array, whose elements are `stride` cells apart.
fn address_tasks(access: &Access<'_>, location: Location, innermost: usize, stride: u32) -> Option<Vec<Task>> {
    let (bit, word) = match location {
        Location::Bit(bit) => (bit, 0),
        Location::Word(word, _) | Location::WordBit(word, _, _) => (0, word),
        Location::Region { bit, word, .. } => (bit, word),
    };
    let mut tasks = vec![Task::Emit(Operation::Address { bit, word })];
    let terms = access.terms.len() / TERM_BYTES;
    for (index, bytes) in access.terms.chunks_exact(TERM_BYTES).enumerate() {
        let term = term(bytes)?;
        let inner = index.saturating_add(innermost) >= terms;
        let elements = if inner { term.bits.max(term.words).checked_div(stride)? } else { 0 };
        tasks.push(Task::Value { operand: term.operand, real: false, subscript: true });
        tasks.push(Task::Emit(Operation::Subscript {
            length: term.length,
            bits: term.bits,
            words: term.words,
            elements,
        }));
    }
    if access.shape == format::SHAPE_WORD_BIT && access.bit_number == format::NO_BIT {
        tasks.push(Task::Value { operand: OperandIndex(access.bit_operand), real: false, subscript: true });
        tasks.push(Task::Emit(Operation::BitNumber(access.bit_length)));
    }
    tasks.reverse();
    Some(tasks)
}

/// A reference to a structure: its first cells and its type.
pub(crate) struct StructureReference {
    /// First bit cell.
    pub(crate) bit: u32,
    /// First word cell.
    pub(crate) word: u32,
    /// Its type.
    pub(crate) type_index: TypeIndex,
}

impl<'a> Loader<'a> {
    /// Resolves a reference to a structure in a fixed place.
    pub(crate) fn structure(&self, context: &Context, operand: OperandIndex) -> Result<StructureReference, LoadError> {
        let find = || {
            let mut cursor = self.entry(context, operand)?;
            if cursor.byte()? != format::REFERENCE {
                return None;
            }
            let access = access(&mut cursor)?;
            let Location::Region { bit, word, .. } = place(self.unit(context.library)?, context, &access)? else {
                return None;
            };
            let type_index = access.type_index.filter(|_| access.is_static())?;
            Some(StructureReference { bit, word, type_index })
        };
        find().ok_or(LoadError::Operand(operand))
    }

    /// The bytes of a text operand.
    pub(crate) fn text(&self, library: bool, operand: OperandIndex) -> Option<&'a [u8]> {
        let mut cursor = self.unit(library)?.image.operands.entry(operand).map(Cursor::new)?;
        if cursor.byte()? != format::TEXT {
            return None;
        }
        let length = cursor.half()?;
        cursor.take(usize::from(length))
    }
}
