//! Values in a channel's cells, however the channel represents them.

use crate::signal::{Signal, Value};
use twinrung_bytecode::CellRange;
use twinrung_bytecode::channel::{Channel, Representation};

/// The value of a bit cell that holds this byte: 0 or 1.
pub fn plain_bit<C: Channel>(byte: u8) -> u8 {
    if C::REPRESENTATION == Representation::Plain { byte } else { !byte }
}

/// The value of a word cell that holds this word.
pub fn plain_word<C: Channel>(word: u32) -> i32 {
    (if C::REPRESENTATION == Representation::Plain { word } else { !word }) as i32
}

/// The bits of a tag.
pub fn plain_bits<C: Channel>(channel: &C, range: &CellRange) -> Vec<u8> {
    let bits = &channel.bits()[range.bit_cell as usize..][..range.bit_cells as usize];
    bits.iter().copied().map(plain_bit::<C>).collect()
}

/// The words of a tag.
pub fn plain_words<C: Channel>(channel: &C, range: &CellRange) -> Vec<i32> {
    let words = &channel.words()[range.word_cell as usize..][..range.word_cells as usize];
    words.iter().copied().map(plain_word::<C>).collect()
}

/// What a cell holds for a value: a REAL as its bits, a BOOL as 0 or 1.
pub fn held(value: Value) -> i32 {
    match value {
        Value::Real(value) => value.to_bits() as i32,
        Value::Integer(value) => value,
        Value::Bool(value) => i32::from(value),
    }
}

/// What stands in a cell; a REAL as its bits. Panics where the signal is none of the channel's cells.
pub fn read<C: Channel>(channel: &C, signal: Signal) -> i32 {
    match signal {
        Signal::Bit(cell) => i32::from(plain_bit::<C>(channel.bits()[cell.position()])),
        Signal::Word(cell, _) => plain_word::<C>(channel.words()[cell.position()]),
        Signal::WordBit(cell, bit) => (plain_word::<C>(channel.words()[cell.position()]) >> bit) & 1,
        other => panic!("{other:?} is a value of the controller"),
    }
}

/// Sets a whole cell. Panics where the signal is none.
pub fn write<C: Channel>(channel: &mut C, signal: Signal, value: i32) {
    match signal {
        Signal::Bit(cell) => channel.set_bit(cell, value != 0),
        Signal::Word(cell, _) => channel.set_word(cell, value),
        other => panic!("{other:?} is no whole cell"),
    }
}
