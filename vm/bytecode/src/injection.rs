//! What fault injection asks of a channel: a list of the bits that it holds. Nothing of this is called in a scan.
//!
//! A channel implements [`Injectable`] under its cargo feature `injection`, by naming each of its fields once. What disturbs
//! an execution while it runs (a rung skipped, a condition turned round) is asked of the observer:
//! [`crate::observer::Observer::rung_upset`] and the methods beside it.
//!
//! Safe Rust cannot hold every pattern of bits: a pointer, the length of a vector or the tag of an enumeration is out of
//! reach. A channel lists an enumeration as so many bits as number its variants; a flip that gives none of them changes
//! nothing and says [`Flip::NoSuchValue`]. The campaign counts these apart.

use crate::channel::Channel;

/// The memories of a channel. Each bit that a channel holds is in one of them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Memory {
    /// What `load` made and no execution writes: the decoded program, its operands, constants and tables, the budget's
    /// counts, initial values.
    Program,
    /// The cells that the comparison sees, [`Channel::bits`] and [`Channel::words`], with every bit of their bytes.
    Cells,
    /// All else: private state of instructions, hidden time stamps, statuses and counts, fault records, stacks and other
    /// intermediate values that are still there when an execution has ended.
    State,
}

impl Memory {
    /// All memories.
    pub const ALL: [Memory; 3] = [Memory::Program, Memory::Cells, Memory::State];
}

/// What became of a bit.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Flip {
    /// It has the other value now.
    Done,
    /// The field has no value with that bit turned round; nothing was changed.
    NoSuchValue,
    /// The memory has no such bit; nothing was changed.
    OutOfRange,
}

/// A field with a fixed number of bits.
pub trait Field {
    /// How many.
    const BITS: u32;

    /// The value of a bit, counted from 0 below [`Field::BITS`].
    fn bit(&self, bit: u32) -> bool;

    /// Turns a bit round; false, and nothing is changed, where the field has no such value.
    fn flip(&mut self, bit: u32) -> bool;
}

macro_rules! integer_fields {
    ($($integer:ty),*) => {$(
        impl Field for $integer {
            const BITS: u32 = <$integer>::BITS;

            fn bit(&self, bit: u32) -> bool {
                self.checked_shr(bit).is_some_and(|shifted| shifted & 1 == 1)
            }

            fn flip(&mut self, bit: u32) -> bool {
                let mask: Option<$integer> = (1 as $integer).checked_shl(bit);
                *self ^= mask.unwrap_or_default();
                mask.is_some()
            }
        }
    )*};
}

integer_fields!(u8, u16, u32, u64, usize, i8, i16, i32, i64);

impl Field for bool {
    const BITS: u32 = 1;

    fn bit(&self, _bit: u32) -> bool {
        *self
    }

    fn flip(&mut self, _bit: u32) -> bool {
        *self = !*self;
        true
    }
}

impl Field for f32 {
    const BITS: u32 = u32::BITS;

    fn bit(&self, bit: u32) -> bool {
        self.to_bits().bit(bit)
    }

    fn flip(&mut self, bit: u32) -> bool {
        let mut bits = self.to_bits();
        let done = bits.flip(bit);
        *self = f32::from_bits(bits);
        done
    }
}

/// A part of a channel that finds its bits itself: records in a row, or a memory whose type is declared in another crate.
pub trait Part {
    /// How many bits.
    fn bits(&self) -> u64;

    /// The value of a bit, counted from 0 below [`Part::bits`].
    fn bit(&self, bit: u64) -> bool;

    /// Turns a bit round; false, and nothing is changed, where the part has no such value.
    fn flip(&mut self, bit: u64) -> bool;
}

/// Walks over the fields of a channel: counts their bits, and reads or turns round the one that was asked for.
#[derive(Debug)]
pub struct BitVisitor {
    wanted: Option<u64>,
    turn: bool,
    passed: u64,
    found: Option<(bool, Flip)>,
}

impl BitVisitor {
    /// Counts.
    pub const fn count() -> BitVisitor {
        BitVisitor { wanted: None, turn: false, passed: 0, found: None }
    }

    /// Reads a bit.
    pub const fn read(bit: u64) -> BitVisitor {
        BitVisitor { wanted: Some(bit), turn: false, passed: 0, found: None }
    }

    /// Turns a bit round.
    pub const fn turn(bit: u64) -> BitVisitor {
        BitVisitor { wanted: Some(bit), turn: true, passed: 0, found: None }
    }

    /// Bits of the fields that were visited.
    pub const fn passed(&self) -> u64 {
        self.passed
    }

    /// The value that the bit had; `None` where no field had it.
    pub fn value(&self) -> Option<bool> {
        self.found.map(|(value, _)| value)
    }

    /// What became of the bit.
    pub fn outcome(&self) -> Flip {
        self.found.map_or(Flip::OutOfRange, |(_, flip)| flip)
    }

    /// A field.
    pub fn field<T: Field>(&mut self, field: &mut T) {
        self.fields(core::slice::from_mut(field));
    }

    /// Fields in a row: one step, however many they are.
    pub fn fields<T: Field>(&mut self, fields: &mut [T]) {
        let bits = u64::from(T::BITS).saturating_mul(fields.len() as u64);
        let offset = self.wanted.and_then(|wanted| wanted.checked_sub(self.passed)).filter(|offset| *offset < bits);
        self.passed = self.passed.saturating_add(bits);
        let Some(offset) = offset else { return };
        let (Some(index), Some(bit)) = (offset.checked_div(T::BITS.into()), offset.checked_rem(T::BITS.into())) else {
            return;
        };
        let Some(field) = fields.get_mut(index as usize) else { return };
        let value = field.bit(bit as u32);
        let flip = match self.turn {
            true if field.flip(bit as u32) => Flip::Done,
            true => Flip::NoSuchValue,
            false => Flip::Done,
        };
        self.found = Some((value, flip));
    }

    /// A part that finds its bits itself: one step, however many they are.
    pub fn part<T: Part>(&mut self, part: &mut T) {
        let bits = part.bits();
        let bit = self.wanted.and_then(|wanted| wanted.checked_sub(self.passed)).filter(|bit| *bit < bits);
        self.passed = self.passed.saturating_add(bits);
        let Some(bit) = bit else { return };
        let value = part.bit(bit);
        let flip = if !self.turn || part.flip(bit) { Flip::Done } else { Flip::NoSuchValue };
        self.found = Some((value, flip));
    }
}

/// A channel whose bits can be turned round. A clone of it is a checkpoint: it behaves as the original would.
///
/// What an implementation owes:
/// - every bit that can change what a later execution does, says or compares is in one of the memories;
/// - the order of the fields depends on the image alone, so that a place means the same in every run;
/// - with any bits turned round an execution does not panic, and it ends: what a loop runs to is bounded by the budget, or
///   by something that no flip reaches. It may do anything else: that is what is being injected.
pub trait Injectable: Channel + Clone {
    /// Shows every field of a memory to the visitor, always in the same order.
    fn visit_bits(&mut self, memory: Memory, visitor: &mut BitVisitor);

    /// The size of a memory in bits.
    fn memory_bits(&mut self, memory: Memory) -> u64 {
        let mut visitor = BitVisitor::count();
        self.visit_bits(memory, &mut visitor);
        visitor.passed
    }

    /// The value of a bit; `None` where the memory has no such bit.
    fn read_bit(&mut self, memory: Memory, bit: u64) -> Option<bool> {
        let mut visitor = BitVisitor::read(bit);
        self.visit_bits(memory, &mut visitor);
        visitor.value()
    }

    /// Turns a bit round.
    fn flip_bit(&mut self, memory: Memory, bit: u64) -> Flip {
        let mut visitor = BitVisitor::turn(bit);
        self.visit_bits(memory, &mut visitor);
        visitor.outcome()
    }

    /// Gives a bit a value: a bit that is stuck gets it before every execution.
    fn force_bit(&mut self, memory: Memory, bit: u64, value: bool) -> Flip {
        match self.read_bit(memory, bit) {
            Some(held) if held == value => Flip::Done,
            Some(_) => self.flip_bit(memory, bit),
            None => Flip::OutOfRange,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    type Fields = ([i32; 3], u8);

    fn visited(fields: &mut Fields, mut visitor: BitVisitor) -> BitVisitor {
        visitor.fields(&mut fields.0);
        visitor.field(&mut fields.1);
        visitor
    }

    #[test]
    fn bits_when_counted_then_every_field_counts_once() {
        assert_eq!(visited(&mut ([0; 3], 0), BitVisitor::count()).passed(), 3 * 32 + 8);
    }

    /// Two bits, of which the second cannot be turned round.
    struct Pair([bool; 2]);

    impl Part for Pair {
        fn bits(&self) -> u64 {
            2
        }

        fn bit(&self, bit: u64) -> bool {
            self.0[bit as usize]
        }

        fn flip(&mut self, bit: u64) -> bool {
            self.0[0] ^= bit == 0;
            bit == 0
        }
    }

    fn shown(pair: &mut Pair, wanted: u64) -> BitVisitor {
        let mut visitor = BitVisitor::turn(wanted);
        visitor.field(&mut 0u8);
        visitor.part(pair);
        visitor
    }

    #[test]
    fn part_when_a_bit_is_flipped_then_it_finds_it_itself() {
        let mut pair = Pair([false, true]);
        assert_eq!(shown(&mut pair, 8).found, Some((false, Flip::Done)));
        assert_eq!(shown(&mut pair, 9).found, Some((true, Flip::NoSuchValue)));
        assert_eq!(shown(&mut pair, 10).found, None);
        assert_eq!((pair.0, shown(&mut pair, 10).passed), ([true, true], 10));
    }

    #[test]
    fn bit_when_flipped_then_it_alone_has_changed() {
        let mut fields = ([0; 3], 0);
        assert_eq!(visited(&mut fields, BitVisitor::turn(32 + 31)).outcome(), Flip::Done);
        assert_eq!(fields, ([0, i32::MIN, 0], 0));
        assert_eq!(visited(&mut fields, BitVisitor::turn(3 * 32 + 7)).outcome(), Flip::Done);
        assert_eq!(fields, ([0, i32::MIN, 0], 0x80));
    }

    #[test]
    fn bit_when_read_then_nothing_has_changed() {
        let mut fields = ([0, 1, 0], 0);
        assert_eq!(visited(&mut fields, BitVisitor::read(32)).value(), Some(true));
        assert_eq!(fields, ([0, 1, 0], 0));
    }

    #[test]
    fn bit_when_behind_the_last_then_there_is_none() {
        assert_eq!(visited(&mut ([0; 3], 0), BitVisitor::turn(3 * 32 + 8)).outcome(), Flip::OutOfRange);
    }
}
