//! Resolves entries of the operand table: this channel's own reading of `twinrung_bytecode::format`.

use alloc::vec;
use alloc::vec::Vec;

use twinrung_bytecode::format;
use twinrung_bytecode::image::TypeReference;
use twinrung_bytecode::index::{OperandIndex, TypeIndex};
use twinrung_bytecode::layout;
use twinrung_catalog::Element;

use super::Loader;
use super::access::{Access, TERM_BYTES, access, path_end, place, term};
use super::context::Context;
use super::cursor::Cursor;
use crate::ladder::{Argument, Dynamic, Expression, Field, Location, Operation, Span};
use crate::load::LoadError;

/// Operations of all addresses and expressions together: far more than any application has, few enough to hold.
const OPERATIONS: usize = 1 << 23;
/// Values that may be open at once, nested subscripts included.
pub(crate) const VALUES: usize = 512;
/// Addresses that may be open at once.
pub(crate) const ADDRESSES: usize = 32;

/// What is still to be emitted, last first.
enum Task {
    Value { operand: OperandIndex, real: bool },
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
        let is_array = !end.is_element && end.dimensions.iter().any(|length| *length > 0);
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
            // The count reaches to the end of the array that the element lies in, through an alias too.
            count: if parameter && !is_array { 1 } else { access.count },
            element: access.element,
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
        let tasks = vec![Task::Value { operand, real }];
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
                Task::Value { operand, real } => match self.value_tasks(context, operand, real, &mut tasks) {
                    Some(Some(operation)) => operation,
                    Some(None) => continue,
                    None => return Ok(false),
                },
            };
            match operation {
                Operation::Integer(_) | Operation::Real(_) | Operation::Word(..) => values = values.saturating_add(1),
                Operation::Pattern => {}
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
                // Where the values that are open begin; what AND, XOR and OR take on their left becomes a pattern
                // before their right side is evaluated.
                let mut open: Vec<usize> = Vec::new();
                let mut patterns: Vec<usize> = Vec::new();
                for index in 0..usize::from(count) {
                    tasks.push(match cursor.byte()? {
                        format::OPERATION_PUSH => {
                            open.push(index);
                            Task::Value { operand: OperandIndex(cursor.word()?), real }
                        }
                        operator => {
                            if operator >= format::OPERATION_MULTIPLY {
                                let right = open.pop()?;
                                if matches!(
                                    operator,
                                    format::OPERATION_AND | format::OPERATION_XOR | format::OPERATION_OR
                                ) {
                                    patterns.push(right);
                                }
                            }
                            Task::Emit(Operation::Apply { operator, real })
                        }
                    });
                }
                patterns.sort_unstable_by(|left, right| right.cmp(left));
                for place in patterns {
                    tasks.insert(begin.checked_add(place)?, Task::Emit(Operation::Pattern));
                }
                tasks.get_mut(begin..)?.reverse();
                Some(None)
            }
            _ => None,
        }
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
        tasks.push(Task::Value { operand: term.operand, real: false });
        tasks.push(Task::Emit(Operation::Subscript {
            length: term.length,
            bits: term.bits,
            words: term.words,
            elements,
        }));
    }
    if access.shape == format::SHAPE_WORD_BIT && access.bit_number == format::NO_BIT {
        tasks.push(Task::Value { operand: OperandIndex(access.bit_operand), real: false });
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
