//! Finds places that depend on subscripts, and evaluates expressions, on two bounded stacks.

use twinrung_bytecode::format;
use twinrung_bytecode::observer::Observer;
use twinrung_catalog::Element;

use super::Walker;
use super::arithmetic::{self, Outcome};
use super::fault::{Fault, SUBSCRIPT};
use super::value::Value;
use crate::ladder::{Argument, Expression, Location, Operation};
use crate::state::Bound;

/// A place on the way.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) struct Address {
    pub(crate) bit: u32,
    pub(crate) word: u32,
    /// Elements of the innermost array before it, as far as variable subscripts say.
    pub(crate) elements: u32,
    pub(crate) number: u8,
}

/// Depths of the two stacks.
#[derive(Default)]
struct Depth {
    values: usize,
    addresses: usize,
}

/// A place, and how many elements of its innermost array variable subscripts skip.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Found {
    /// The place.
    pub(crate) location: Location,
    /// Elements before it.
    pub(crate) skipped: u32,
}

impl<O: Observer> Walker<'_, O> {
    /// Finds an argument's place. Anything but data stands nowhere: a gap in admission that no write can come from.
    pub(crate) fn find(&mut self, argument: Argument) -> Result<Found, Fault> {
        match argument {
            Argument::At(location) => Ok(Found { location, skipped: 0 }),
            Argument::Dynamic(index) => {
                let Some(dynamic) = self.ladder.dynamics.get(index as usize).copied() else {
                    return Err(SUBSCRIPT);
                };
                let mut depth = Depth::default();
                self.operate(Expression { begin: dynamic.begin, end: dynamic.end }, &mut depth)?;
                let address = self.state.addresses.first().copied().unwrap_or_default();
                let location = match dynamic.location {
                    Location::Bit(_) => Location::Bit(address.bit),
                    Location::Word(_, element) => Location::Word(address.word, element),
                    Location::WordBit(_, _, element) => {
                        let number = match self.last_is_bit_number(dynamic.end) {
                            true => address.number,
                            false => constant_number(dynamic.location),
                        };
                        Location::WordBit(address.word, number, element)
                    }
                    Location::Region { kind, .. } => Location::Region { bit: address.bit, word: address.word, kind },
                };
                Ok(Found { location, skipped: address.elements })
            }
            _ => Ok(Found { location: Location::Bit(u32::MAX), skipped: 0 }),
        }
    }

    fn last_is_bit_number(&self, end: u32) -> bool {
        let last = self.ladder.operations.get((end as usize).wrapping_sub(1));
        matches!(last, Some(Operation::BitNumber(_)))
    }

    /// An argument's place; the first subscript out of range is the fault.
    pub(crate) fn locate(&mut self, argument: Argument) -> Result<Location, Fault> {
        self.find(argument).map(|found| found.location)
    }

    /// An argument with its place, which for a span is its first element's.
    pub(crate) fn bind(&mut self, argument: Argument) -> Result<Bound, Fault> {
        let start = match argument {
            Argument::Span(index) => self.ladder.spans.get(index as usize).map_or(argument, |span| span.start),
            other => other,
        };
        Ok(Bound { argument, location: self.locate(start)? })
    }

    /// The value of a number operand.
    pub(crate) fn number(&mut self, argument: Argument) -> Result<Value, Fault> {
        match argument {
            Argument::Integer(value) => Ok(Value::dint(value)),
            Argument::Real(bits) => Ok(Value { element: Element::Real, bits: bits as i32 }),
            other => {
                let location = self.locate(other)?;
                Ok(self.value_at(location))
            }
        }
    }

    /// The value of a word.
    pub(crate) fn value_at(&self, location: Location) -> Value {
        match location {
            Location::Word(cell, element) => Value { element, bits: self.state.memory.word(cell) },
            _ => Value::dint(0),
        }
    }

    /// The value of an expression.
    pub(crate) fn evaluate(&mut self, argument: Argument) -> Result<Value, Fault> {
        let Argument::Expression(index) = argument else { return self.number(argument) };
        let Some(expression) = self.ladder.expressions.get(index as usize).copied() else {
            return Ok(Value::dint(0));
        };
        let mut depth = Depth::default();
        self.operate(expression, &mut depth)?;
        Ok(self.pop(&mut depth))
    }

    fn push(&mut self, depth: &mut Depth, value: Value) {
        if let Some(place) = self.state.values.get_mut(depth.values) {
            *place = value;
            depth.values = depth.values.wrapping_add(1);
        }
    }

    fn pop(&mut self, depth: &mut Depth) -> Value {
        depth.values = depth.values.saturating_sub(1);
        self.state.values.get(depth.values).copied().unwrap_or_default()
    }

    fn topmost(&mut self, depth: &Depth) -> Option<&mut Address> {
        self.state.addresses.get_mut(depth.addresses.checked_sub(1)?)
    }

    fn operate(&mut self, expression: Expression, depth: &mut Depth) -> Result<(), Fault> {
        let ladder = self.ladder;
        let range = expression.begin as usize..expression.end as usize;
        for operation in ladder.operations.get(range).unwrap_or(&[]) {
            match *operation {
                Operation::Integer(value) => self.push(depth, Value::dint(value)),
                Operation::Real(bits) => self.push(depth, Value { element: Element::Real, bits: bits as i32 }),
                Operation::Word(cell, element) => {
                    let value = self.value_at(Location::Word(cell, element));
                    self.push(depth, value);
                }
                Operation::Address { bit, word } => {
                    if let Some(place) = self.state.addresses.get_mut(depth.addresses) {
                        *place = Address { bit, word, elements: 0, number: 0 };
                        depth.addresses = depth.addresses.wrapping_add(1);
                    }
                }
                Operation::Subscript { length, bits, words, elements } => {
                    let value = u32::try_from(self.pop(depth).bits).unwrap_or(u32::MAX);
                    if value >= length {
                        return Err(SUBSCRIPT);
                    }
                    if let Some(address) = self.topmost(depth) {
                        address.bit = address.bit.wrapping_add(value.wrapping_mul(bits));
                        address.word = address.word.wrapping_add(value.wrapping_mul(words));
                        address.elements = address.elements.wrapping_add(value.wrapping_mul(elements));
                    }
                }
                Operation::BitNumber(length) => {
                    let value = self.pop(depth).bits;
                    let number = u8::try_from(value).unwrap_or(u8::MAX);
                    if number >= length {
                        return Err(SUBSCRIPT);
                    }
                    if let Some(address) = self.topmost(depth) {
                        address.number = number;
                    }
                }
                Operation::Load(element) => {
                    let word = self.topmost(depth).map_or(u32::MAX, |address| address.word);
                    depth.addresses = depth.addresses.saturating_sub(1);
                    let value = self.value_at(Location::Word(word, element));
                    self.push(depth, value);
                }
                Operation::Pattern => {
                    let Outcome { value, overflow } = arithmetic::pattern(self.pop(depth));
                    if overflow {
                        self.state.set_overflow();
                    }
                    self.push(depth, value);
                }
                Operation::Apply { operator, real } => {
                    let right = self.pop(depth);
                    let outcome = if operator < format::OPERATION_MULTIPLY {
                        arithmetic::unary(operator, right, real)
                    } else {
                        let left = self.pop(depth);
                        arithmetic::binary(operator, left, right, real)
                    };
                    let Outcome { value, overflow } = outcome;
                    if overflow {
                        self.state.set_overflow();
                        // An address is open while its subscripts and bit number are evaluated; they are invalid then.
                        if depth.addresses > 0 {
                            return Err(SUBSCRIPT);
                        }
                    }
                    self.push(depth, value);
                }
            }
        }
        Ok(())
    }
}

fn constant_number(location: Location) -> u8 {
    match location {
        Location::WordBit(_, number, _) => number,
        _ => 0,
    }
}
