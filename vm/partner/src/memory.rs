//! The channel's cells, complemented: a false bit is 0xFF, a true bit 0xFE, a word is stored as `!value`.
//!
//! Banks have a power of two of cells so that a masked index needs no bounds check; the image's cells come first, the
//! channel's private cells behind them.

use alloc::vec;
use alloc::vec::Vec;
use core::ops::Range;

/// Cells of a bank whose indices fit 16 bits.
pub(crate) const SMALL: usize = 1 << 16;
/// Cells of a bank for large applications.
pub(crate) const MEDIUM: usize = 1 << 20;
/// Cells of a bank for whatever an image may hold at most, private cells included.
pub(crate) const LARGE: usize = 1 << 25;

/// A bit cell's byte.
pub(crate) const fn complement(value: bool) -> u8 {
    0xFF ^ value as u8
}

/// Which banks a channel uses.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Size {
    /// 65,536 cells each.
    Small,
    /// 1,048,576 cells each.
    Medium,
    /// 33,554,432 cells each.
    Large,
}

impl Size {
    /// The smallest size that holds so many cells; `None` when there is none.
    pub(crate) const fn holding(cells: usize) -> Option<Size> {
        if cells <= SMALL {
            Some(Size::Small)
        } else if cells <= MEDIUM {
            Some(Size::Medium)
        } else if cells <= LARGE {
            Some(Size::Large)
        } else {
            None
        }
    }

    /// Cells of a bank.
    pub(crate) const fn cells(self) -> usize {
        match self {
            Size::Small => SMALL,
            Size::Medium => MEDIUM,
            Size::Large => LARGE,
        }
    }
}

/// All cells.
#[derive(Debug, Clone)]
pub(crate) struct Memory {
    /// Bit cells, one byte each, complemented.
    pub(crate) bits: Vec<u8>,
    /// Word cells, complemented.
    pub(crate) words: Vec<u32>,
    /// For each word cell that is the PRE of a TIMER its hidden time stamp in ms; for the LEN of a CONTROL the mark
    /// [`FINISHED_FALSE`].
    pub(crate) stamps: Vec<i64>,
    /// Bit cells of the image.
    pub(crate) image_bits: usize,
    /// Word cells of the image.
    pub(crate) image_words: usize,
    /// Word cells in use, private ones included.
    pub(crate) used_words: usize,
}

/// Stamp of a CONTROL whose run was last completed while its rung was false.
pub(crate) const FINISHED_FALSE: i64 = i64::MIN;

impl Memory {
    /// Banks of one size with the first `image_bits` and `image_words` cells belonging to the image.
    pub(crate) fn new(size: Size, image_bits: usize, image_words: usize, used_words: usize) -> Memory {
        Memory {
            bits: vec![0; size.cells()],
            words: vec![0; size.cells()],
            stamps: vec![0; size.cells()],
            image_bits,
            image_words,
            used_words,
        }
    }

    /// A bit cell's value; false out of range.
    pub(crate) fn bit(&self, cell: u32) -> bool {
        self.bits.get(cell as usize).is_some_and(|byte| byte & 1 == 0)
    }

    /// Sets a bit cell; nothing out of range.
    pub(crate) fn set_bit(&mut self, cell: u32, value: bool) {
        if let Some(byte) = self.bits.get_mut(cell as usize) {
            *byte = complement(value);
        }
    }

    /// A word cell's value; 0 out of range.
    pub(crate) fn word(&self, cell: u32) -> i32 {
        self.words.get(cell as usize).map_or(0, |word| !*word as i32)
    }

    /// Sets a word cell; nothing out of range.
    pub(crate) fn set_word(&mut self, cell: u32, value: i32) {
        if let Some(word) = self.words.get_mut(cell as usize) {
            *word = !(value as u32);
        }
    }

    /// The time stamp that belongs to a word cell.
    pub(crate) fn stamp(&self, cell: u32) -> i64 {
        self.stamps.get(cell as usize).copied().unwrap_or(0)
    }

    /// Sets the time stamp that belongs to a word cell.
    pub(crate) fn set_stamp(&mut self, cell: u32, value: i64) {
        if let Some(stamp) = self.stamps.get_mut(cell as usize) {
            *stamp = value;
        }
    }

    /// Sets the time stamps that belong to a range of word cells.
    pub(crate) fn set_stamps(&mut self, cells: Range<usize>, value: i64) {
        self.stamps.get_mut(cells).unwrap_or_default().fill(value);
    }
}
