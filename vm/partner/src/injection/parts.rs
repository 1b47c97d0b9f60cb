//! Bits of values that are no integers: each value as a few numbered parts, and back where the parts are a value.

use twinrung_bytecode::index::ProgramIndex;
use twinrung_bytecode::injection::Field;
use twinrung_catalog::{Element, Opcode};

use crate::ladder::{self, Argument, BodyIndex, Code, Location, Operation, Step, StructureKind};
use crate::panel::Kind;
use crate::walk::value::Value;

/// The parts of a value; those that it does not use are 0.
pub(super) type Numbers = [u32; 6];

/// A value that is made of parts.
pub(super) trait Parts: Sized {
    /// Bits of each part.
    const WIDTHS: Numbers;

    /// Its parts.
    fn parts(&self) -> Numbers;

    /// The value with these parts, if there is one.
    fn with(parts: Numbers) -> Option<Self>;
}

/// Bits of all parts together.
const fn width(widths: Numbers) -> u32 {
    let [a, b, c, d, e, f] = widths;
    a.wrapping_add(b).wrapping_add(c).wrapping_add(d).wrapping_add(e).wrapping_add(f)
}

/// The part that holds a bit, and the bit's mask there.
fn place(widths: Numbers, mut bit: u32) -> Option<(usize, u32)> {
    for (part, width) in widths.into_iter().enumerate() {
        match bit.checked_sub(width) {
            None => return Some((part, 1u32.wrapping_shl(bit))),
            Some(rest) => bit = rest,
        }
    }
    None
}

/// A value as a field of fixed width.
pub(super) struct Packed<'a, T>(pub(super) &'a mut T);

impl<T: Parts> Field for Packed<'_, T> {
    const BITS: u32 = width(T::WIDTHS);

    fn bit(&self, bit: u32) -> bool {
        let parts = self.0.parts();
        place(T::WIDTHS, bit).is_some_and(|(part, mask)| parts.get(part).is_some_and(|part| part & mask != 0))
    }

    fn flip(&mut self, bit: u32) -> bool {
        let mut parts = self.0.parts();
        let Some((part, mask)) = place(T::WIDTHS, bit) else { return false };
        if let Some(part) = parts.get_mut(part) {
            *part ^= mask;
        }
        // A part that the value does not use reads 0 again.
        let Some(value) = T::with(parts).filter(|value| value.parts() == parts) else { return false };
        *self.0 = value;
        true
    }
}

/// Makes values of the channel's own types fields by themselves.
macro_rules! fields {
    ($($type:ty),*) => {$(
        impl Field for $type {
            const BITS: u32 = width(<$type as Parts>::WIDTHS);

            fn bit(&self, bit: u32) -> bool {
                Packed(&mut { *self }).bit(bit)
            }

            fn flip(&mut self, bit: u32) -> bool {
                Packed(self).flip(bit)
            }
        }
    )*};
}

fields!(Step, Argument, Location, Operation, ladder::Field, Kind, Value);

fn element_number(element: Element) -> u32 {
    element as u32
}

fn element(number: u32) -> Option<Element> {
    Element::ALL.get(number as usize).copied()
}

const STRUCTURES: [StructureKind; 4] =
    [StructureKind::Timer, StructureKind::Counter, StructureKind::Control, StructureKind::Other];

/// An instruction is its number; any other step has bit 8 and its place here.
const OTHER_CODES: [Code; 8] =
    [Code::Region, Code::Rung, Code::Branch, Code::NextLeg, Code::EndBranch, Code::AddOn, Code::Safety, Code::End];
const OTHER: u32 = 0x100;

fn code_number(code: Code) -> u32 {
    match code {
        Code::Instruction(opcode) => u32::from(opcode as u8),
        other => OTHER | OTHER_CODES.iter().position(|code| *code == other).map_or(0, |place| place as u32),
    }
}

fn code(number: u32) -> Option<Code> {
    match number.checked_sub(OTHER) {
        Some(place) => OTHER_CODES.get(place as usize).copied(),
        None => Opcode::from_number(number as u8).map(Code::Instruction),
    }
}

impl Parts for Step {
    const WIDTHS: Numbers = [9, 8, 16, 32, 0, 0];

    fn parts(&self) -> Numbers {
        [code_number(self.code), u32::from(self.count), u32::from(self.element), self.first, 0, 0]
    }

    fn with([number, count, element, first, ..]: Numbers) -> Option<Step> {
        Some(Step { code: code(number)?, count: count as u8, element: element as u16, first })
    }
}

impl Parts for Location {
    const WIDTHS: Numbers = [2, 32, 32, 8, 3, 0];

    fn parts(&self) -> Numbers {
        match *self {
            Location::Bit(cell) => [0, cell, 0, 0, 0, 0],
            Location::Word(cell, element) => [1, cell, 0, 0, element_number(element), 0],
            Location::WordBit(cell, bit, element) => [2, cell, 0, u32::from(bit), element_number(element), 0],
            Location::Region { bit, word, kind } => {
                let kind = STRUCTURES.iter().position(|known| *known == kind).unwrap_or(0);
                [3, bit, word, 0, kind as u32, 0]
            }
        }
    }

    fn with([tag, first, second, bit, last, _]: Numbers) -> Option<Location> {
        Some(match tag {
            0 => Location::Bit(first),
            1 => Location::Word(first, element(last)?),
            2 => Location::WordBit(first, bit as u8, element(last)?),
            _ => Location::Region { bit: first, word: second, kind: *STRUCTURES.get(last as usize)? },
        })
    }
}

impl Parts for Argument {
    /// Tag; then the parts of a location, whose own tag is the last here.
    const WIDTHS: Numbers = [4, 32, 32, 8, 3, 2];

    fn parts(&self) -> Numbers {
        let number = |tag: u32, value: u32| [tag, value, 0, 0, 0, 0];
        match *self {
            Argument::Nothing => number(0, 0),
            Argument::Integer(value) => number(1, value as u32),
            Argument::Real(bits) => number(2, bits),
            Argument::At(location) => {
                let [tag, first, second, bit, last, _] = location.parts();
                [3, first, second, bit, last, tag]
            }
            Argument::Dynamic(entry) => number(4, entry),
            Argument::Status(keyword) => number(5, u32::from(keyword)),
            Argument::Span(entry) => number(6, entry),
            Argument::Expression(entry) => number(7, entry),
            Argument::SystemValue(entry) => number(8, u32::from(entry)),
            Argument::EventTask(entry) => number(9, u32::from(entry)),
        }
    }

    fn with([tag, first, second, bit, last, of_location]: Numbers) -> Option<Argument> {
        Some(match tag {
            0 => Argument::Nothing,
            1 => Argument::Integer(first as i32),
            2 => Argument::Real(first),
            3 => Argument::At(Location::with([of_location, first, second, bit, last, 0])?),
            4 => Argument::Dynamic(first),
            5 => Argument::Status(first as u8),
            6 => Argument::Span(first),
            7 => Argument::Expression(first),
            8 => Argument::SystemValue(first as u16),
            9 => Argument::EventTask(first as u16),
            _ => return None,
        })
    }
}

impl Parts for Operation {
    /// Tag, which also holds the type of a word; then numbers.
    const WIDTHS: Numbers = [6, 32, 32, 32, 32, 0];

    fn parts(&self) -> Numbers {
        let typed = |tag: u32, element: Element| tag | (element_number(element) << 3);
        match *self {
            Operation::Integer(value) => [0, value as u32, 0, 0, 0, 0],
            Operation::Real(bits) => [1, bits, 0, 0, 0, 0],
            Operation::Word(cell, element) => [typed(2, element), cell, 0, 0, 0, 0],
            Operation::Address { bit, word } => [3, bit, word, 0, 0, 0],
            Operation::Subscript { length, bits, words, elements } => [4, length, bits, words, elements, 0],
            Operation::BitNumber(length) => [5, u32::from(length), 0, 0, 0, 0],
            Operation::Load(element) => [typed(6, element), 0, 0, 0, 0, 0],
            Operation::Pattern => [7, 0, 0, 0, 0, 0],
            Operation::Apply { operator, real } => [7 | 1 << 3, u32::from(operator), u32::from(real), 0, 0, 0],
        }
    }

    fn with([tag, first, second, third, fourth, _]: Numbers) -> Option<Operation> {
        let above = tag >> 3;
        Some(match (tag & 7, above) {
            (0, 0) => Operation::Integer(first as i32),
            (1, 0) => Operation::Real(first),
            (2, _) => Operation::Word(first, element(above)?),
            (3, 0) => Operation::Address { bit: first, word: second },
            (4, 0) => Operation::Subscript { length: first, bits: second, words: third, elements: fourth },
            (5, 0) => Operation::BitNumber(first as u8),
            (6, _) => Operation::Load(element(above)?),
            (7, 0) => Operation::Pattern,
            (7, 1) => Operation::Apply { operator: first as u8, real: second & 1 != 0 },
            _ => return None,
        })
    }
}

impl Parts for ladder::Field {
    const WIDTHS: Numbers = [32, 8, 3, 32, 0, 0];

    fn parts(&self) -> Numbers {
        [self.byte, u32::from(self.bit), element_number(self.element), self.cell, 0, 0]
    }

    fn with([byte, bit, number, cell, ..]: Numbers) -> Option<ladder::Field> {
        Some(ladder::Field { byte, bit: bit as u8, element: element(number)?, cell })
    }
}

impl Parts for Value {
    const WIDTHS: Numbers = [3, 32, 0, 0, 0, 0];

    fn parts(&self) -> Numbers {
        [element_number(self.element), self.bits as u32, 0, 0, 0, 0]
    }

    fn with([number, bits, ..]: Numbers) -> Option<Value> {
        Some(Value { element: element(number)?, bits: bits as i32 })
    }
}

impl Parts for Kind {
    const WIDTHS: Numbers = [4, 0, 0, 0, 0, 0];

    fn parts(&self) -> Numbers {
        [*self as u32, 0, 0, 0, 0, 0]
    }

    fn with([number, ..]: Numbers) -> Option<Kind> {
        Kind::ALL.get(number as usize).copied()
    }
}

impl Parts for Element {
    const WIDTHS: Numbers = [3, 0, 0, 0, 0, 0];

    fn parts(&self) -> Numbers {
        [element_number(*self), 0, 0, 0, 0, 0]
    }

    fn with([number, ..]: Numbers) -> Option<Element> {
        element(number)
    }
}

impl Parts for BodyIndex {
    const WIDTHS: Numbers = [32, 0, 0, 0, 0, 0];

    fn parts(&self) -> Numbers {
        [self.0, 0, 0, 0, 0, 0]
    }

    fn with([number, ..]: Numbers) -> Option<BodyIndex> {
        Some(BodyIndex(number))
    }
}

impl Parts for ProgramIndex {
    const WIDTHS: Numbers = [16, 0, 0, 0, 0, 0];

    fn parts(&self) -> Numbers {
        [u32::from(self.0), 0, 0, 0, 0, 0]
    }

    fn with([number, ..]: Numbers) -> Option<ProgramIndex> {
        Some(ProgramIndex(number as u16))
    }
}

/// A value of one part that may be absent: behind it a bit says that it is there. A value that appears is that of number 0.
impl<T: Parts> Parts for Option<T> {
    const WIDTHS: Numbers = {
        let [width, ..] = T::WIDTHS;
        [width, 1, 0, 0, 0, 0]
    };

    fn parts(&self) -> Numbers {
        match self {
            Some(value) => {
                let [number, ..] = value.parts();
                [number, 1, 0, 0, 0, 0]
            }
            None => [0; 6],
        }
    }

    fn with([number, there, ..]: Numbers) -> Option<Option<T>> {
        match there {
            0 => Some(None),
            _ => T::with([number, 0, 0, 0, 0, 0]).map(Some),
        }
    }
}

#[cfg(test)]
mod tests {
    use alloc::vec::Vec;

    use super::*;

    /// Every bit of a value: read, turned round where there is such a value, and turned back.
    fn turned<T: Parts + PartialEq + Clone + core::fmt::Debug>(value: T) -> usize {
        let bits = <Packed<'_, T> as Field>::BITS;
        let mut held = value.clone();
        let done: Vec<u32> = (0..bits)
            .filter(|bit| {
                let before = Packed(&mut held).bit(*bit);
                let done = Packed(&mut held).flip(*bit);
                assert_eq!(Packed(&mut held).bit(*bit), before ^ done, "{value:?} {bit}");
                assert_eq!(held != value, done, "{value:?} {bit}");
                assert_eq!(Packed(&mut held).flip(*bit), done);
                assert_eq!(held, value);
                done
            })
            .collect();
        done.len()
    }

    #[test]
    fn value_when_a_bit_is_turned_round_then_it_is_another_value_or_stays() {
        // Of the code of XIC (1) seven other numbers may be instructions; count, element and first take every value.
        assert!(turned(Step { code: Code::Instruction(Opcode::Xic), count: 1, element: 2, first: 3 }) > 56);
        assert!(turned(Step { code: Code::Rung, count: 0, element: 0, first: 9 }) >= 56 + 3);
        assert_eq!(turned(Kind::FourContacts), 4);
        assert_eq!(turned(Element::Bool), 3);
        assert_eq!(turned(Some(BodyIndex(7))), 32);
        assert_eq!(turned(None::<BodyIndex>), 1);
        assert_eq!(turned(Some(BodyIndex(0))), 33);
        for argument in [Argument::Nothing, Argument::Integer(-1), Argument::Real(0), Argument::Status(3)] {
            turned(argument);
        }
        for kind in STRUCTURES {
            assert!(turned(Argument::At(Location::Region { bit: 5, word: 6, kind })) >= 66);
        }
        for element in Element::ALL {
            assert!(turned(Location::WordBit(1, 31, element)) >= 40);
            turned(Operation::Word(4, element));
            turned(Operation::Load(element));
        }
        assert_eq!(turned(Operation::Subscript { length: 3, bits: 1, words: 2, elements: 1 }), 128);
        turned(Operation::Apply { operator: 4, real: true });
    }
}
