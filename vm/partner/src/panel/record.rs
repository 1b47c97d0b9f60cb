//! The records of a region, in pools by kind. Cells are 16-bit numbers where the banks are small, else 32-bit ones.

use alloc::vec::Vec;

use super::function::Function;
use crate::ladder::Step;
use crate::memory::Size;

/// A cell's number.
pub(crate) trait Index: Copy {
    /// The number as a position.
    fn at(self) -> usize;
    /// From a wide number; the low bits.
    fn narrow(wide: u32) -> Self;
}

impl Index for u16 {
    fn at(self) -> usize {
        usize::from(self)
    }

    fn narrow(wide: u32) -> u16 {
        wide as u16
    }
}

impl Index for u32 {
    fn at(self) -> usize {
        self as usize
    }

    fn narrow(wide: u32) -> u32 {
        wide
    }
}

/// A network of up to so many contacts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Panel<I, T, const CONTACTS: usize> {
    /// Conduction, by the sum of the weighted bytes modulo the bits of the table; complemented.
    pub(crate) table: T,
    /// The contacts' cells; unused ones repeat another.
    pub(crate) inputs: [I; CONTACTS],
    /// The cell that receives the result.
    pub(crate) output: I,
}

/// A network of up to four contacts.
pub(crate) type FourContacts<I> = Panel<I, u32, 4>;

/// A network of up to six contacts.
pub(crate) type SixContacts<I> = Panel<I, u64, 6>;

impl<T, const CONTACTS: usize> Panel<u32, T, CONTACTS> {
    /// A network with this table.
    pub(crate) fn new(table: T, function: &Function, output: u32) -> Self {
        // A network without contacts looks at its own output: its table is the same wherever it is looked up.
        Panel { table, inputs: function.panel_inputs(output), output }
    }

    fn for_small_banks(self) -> Panel<u16, T, CONTACTS> {
        Panel { table: self.table, inputs: self.inputs.map(u16::narrow), output: u16::narrow(self.output) }
    }
}

/// An integer comparison.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Compare<I> {
    /// Left word.
    pub(crate) left: I,
    /// Right word.
    pub(crate) right: I,
    /// Receives the result.
    pub(crate) output: I,
    /// Bit 0: true when less; bit 1: when equal; bit 2: when greater.
    pub(crate) accept: u8,
}

/// A bit out of a word.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Extract<I> {
    /// The word.
    pub(crate) word: I,
    /// Receives the bit.
    pub(crate) output: I,
    /// Bit number.
    pub(crate) bit: u8,
}

/// A bit into a word.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Insert<I> {
    /// The rung condition.
    pub(crate) condition: I,
    /// The word.
    pub(crate) word: I,
    /// Bit number.
    pub(crate) bit: u8,
    /// Unused bits above the word's type.
    pub(crate) above: u8,
    /// The bit while the condition is true.
    pub(crate) when_true: bool,
    /// Whether a false condition clears the bit (else it stays).
    pub(crate) clears: bool,
}

/// A timer: EN, TT and DN are consecutive bits, PRE and ACC consecutive words.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Timer<I> {
    /// The rung condition.
    pub(crate) condition: I,
    /// EN.
    pub(crate) bit: I,
    /// PRE.
    pub(crate) word: I,
}

/// An integer move.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Move<I> {
    /// Place in the region's order of instructions, from 1.
    pub(crate) sequence: u32,
    /// The rung condition.
    pub(crate) condition: I,
    /// Source word.
    pub(crate) source: I,
    /// Destination word.
    pub(crate) destination: I,
    /// Unused bits above the destination's type.
    pub(crate) above: u8,
}

/// An integer sum or difference.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Sum<I> {
    /// Place in the region's order of instructions, from 1.
    pub(crate) sequence: u32,
    /// The rung condition.
    pub(crate) condition: I,
    /// Left word.
    pub(crate) left: I,
    /// Right word.
    pub(crate) right: I,
    /// Destination word.
    pub(crate) destination: I,
    /// Unused bits above the destination's type.
    pub(crate) above: u8,
    /// Whether the right side is subtracted.
    pub(crate) subtract: bool,
}

/// Any other instruction.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Other {
    /// Place in the region's order of instructions, from 1.
    pub(crate) sequence: u32,
    /// The rung condition.
    pub(crate) condition: u32,
    /// Receives the condition after it.
    pub(crate) output: u32,
    /// The instruction.
    pub(crate) step: Step,
}

/// Records by kind.
#[derive(Debug, Clone)]
pub(crate) struct Pools<I> {
    /// Networks of up to four contacts.
    pub(crate) four_contacts: Vec<FourContacts<I>>,
    /// Networks of five or six.
    pub(crate) six_contacts: Vec<SixContacts<I>>,
    /// Comparisons.
    pub(crate) compares: Vec<Compare<I>>,
    /// Bits out of words.
    pub(crate) extracts: Vec<Extract<I>>,
    /// Bits into words.
    pub(crate) inserts: Vec<Insert<I>>,
    /// Timers of all three kinds.
    pub(crate) timers: Vec<Timer<I>>,
    /// Moves.
    pub(crate) moves: Vec<Move<I>>,
    /// Sums.
    pub(crate) sums: Vec<Sum<I>>,
    /// Others.
    pub(crate) others: Vec<Other>,
}

impl<I> Default for Pools<I> {
    fn default() -> Pools<I> {
        Pools {
            four_contacts: Vec::new(),
            six_contacts: Vec::new(),
            compares: Vec::new(),
            extracts: Vec::new(),
            inserts: Vec::new(),
            timers: Vec::new(),
            moves: Vec::new(),
            sums: Vec::new(),
            others: Vec::new(),
        }
    }
}

/// The records in the form that fits the banks.
#[derive(Debug, Clone)]
pub(crate) enum Records {
    /// For small banks.
    Small(Pools<u16>),
    /// For medium banks.
    Medium(Pools<u32>),
    /// For large banks.
    Large(Pools<u32>),
}

impl Records {
    /// The records for banks of this size.
    pub(crate) fn new(wide: Pools<u32>, size: Size) -> Records {
        match size {
            Size::Small => Records::Small(wide.for_small_banks()),
            Size::Medium => Records::Medium(wide),
            Size::Large => Records::Large(wide),
        }
    }
}

impl Pools<u32> {
    fn for_small_banks(self) -> Pools<u16> {
        let cell = u16::narrow;
        Pools {
            four_contacts: self.four_contacts.into_iter().map(Panel::for_small_banks).collect(),
            six_contacts: self.six_contacts.into_iter().map(Panel::for_small_banks).collect(),
            compares: self
                .compares
                .into_iter()
                .map(|from| Compare {
                    left: cell(from.left),
                    right: cell(from.right),
                    output: cell(from.output),
                    accept: from.accept,
                })
                .collect(),
            extracts: self
                .extracts
                .into_iter()
                .map(|from| Extract { word: cell(from.word), output: cell(from.output), bit: from.bit })
                .collect(),
            inserts: self
                .inserts
                .into_iter()
                .map(|from| Insert {
                    condition: cell(from.condition),
                    word: cell(from.word),
                    bit: from.bit,
                    above: from.above,
                    when_true: from.when_true,
                    clears: from.clears,
                })
                .collect(),
            timers: self
                .timers
                .into_iter()
                .map(|from| Timer { condition: cell(from.condition), bit: cell(from.bit), word: cell(from.word) })
                .collect(),
            moves: self
                .moves
                .into_iter()
                .map(|from| Move {
                    sequence: from.sequence,
                    condition: cell(from.condition),
                    source: cell(from.source),
                    destination: cell(from.destination),
                    above: from.above,
                })
                .collect(),
            sums: self
                .sums
                .into_iter()
                .map(|from| Sum {
                    sequence: from.sequence,
                    condition: cell(from.condition),
                    left: cell(from.left),
                    right: cell(from.right),
                    destination: cell(from.destination),
                    above: from.above,
                    subtract: from.subtract,
                })
                .collect(),
            others: self.others,
        }
    }
}
