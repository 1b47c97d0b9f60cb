//! A stimulus at work: names and values looked up once, and set when their time has come.

use std::collections::HashMap;
use std::sync::Arc;

use twinrung_bytecode::CellRange;
use twinrung_bytecode::channel::Channel;
use twinrung_bytecode::index::{BitCell, TagIndex, WordCell};
use twinrung_catalog::Element;
use twinrung_controller::Controller;

use crate::names;
use crate::run::RunError;
use crate::signal::{Signal, SignalError, parse_value};
use crate::stimulus::Stimulus;

/// What a stimulus does, with names and values looked up.
#[derive(Debug, Clone, Default)]
pub struct Drive {
    /// Shared by all clones.
    rows: Arc<[(u64, Vec<Driven>)]>,
    next: usize,
    /// Where the rows count from, in ms.
    origin_ms: u64,
    words: HashMap<WordCell, i32>,
}

#[derive(Debug, Clone, Copy)]
enum Driven {
    Bit(BitCell, bool),
    Word(WordCell, i32),
    WordBit(WordCell, u8, bool),
}

/// The cells of a driven signal; which tag they are of makes no difference to freezing and publishing.
pub fn cells(signal: Signal) -> Option<CellRange> {
    let range = |bit_cell, bit_cells, word_cell, word_cells| CellRange {
        tag: TagIndex(u32::MAX),
        bit_cell,
        bit_cells,
        word_cell,
        word_cells,
    };
    match signal {
        Signal::Bit(cell) => Some(range(cell.0, 1, 0, 0)),
        Signal::Word(cell, _) | Signal::WordBit(cell, _) => Some(range(0, 0, cell.0, 1)),
        _ => None,
    }
}

/// The cells of driven signals in the order of the signals, those of BOOLs that follow each other in one range: what is
/// frozen is copied range by range.
pub(crate) fn runs(signals: impl IntoIterator<Item = Signal>) -> Vec<CellRange> {
    let mut runs: Vec<CellRange> = Vec::new();
    for range in signals.into_iter().filter_map(cells) {
        match runs.last_mut() {
            Some(last) if range.word_cells == 0 && last.bit_cell + last.bit_cells == range.bit_cell => {
                last.bit_cells += 1;
            }
            _ => runs.push(range),
        }
    }
    runs
}

impl Drive {
    /// Looks up a stimulus, and has the controller copy what it drives in at the start of each scan.
    ///
    /// # Errors
    ///
    /// A name that is none, or that logic writes; a cell that is no value of its tag.
    pub fn new<A: Channel, B: Channel>(
        controller: &mut Controller<A, B>,
        stimulus: &Stimulus,
    ) -> Result<Drive, RunError> {
        let image = controller.image();
        let signals: Vec<Signal> =
            stimulus.tags.iter().map(|tag| names::driven(image, tag)).collect::<Result<_, _>>()?;
        let mut rows = Vec::with_capacity(stimulus.rows.len());
        for row in &stimulus.rows {
            let mut driven = Vec::new();
            for ((signal, cell), name) in signals.iter().zip(&row.cells).zip(&stimulus.tags) {
                let Some(text) = cell else { continue };
                let element = if let Signal::Word(_, element) = signal { *element } else { Element::Bool };
                let value =
                    parse_value(name, text, element).map_err(|error| RunError::Cell { line: row.line, error })?;
                driven.push(match *signal {
                    Signal::Bit(cell) => Driven::Bit(cell, value == 1),
                    Signal::Word(cell, _) => Driven::Word(cell, value),
                    Signal::WordBit(cell, bit) => Driven::WordBit(cell, bit, value == 1),
                    _ => return Err(SignalError::NotDriven { name: name.clone() }.into()),
                });
            }
            rows.push((row.time_ms, driven));
        }
        for range in signals.into_iter().filter_map(cells) {
            controller.freeze_also(range);
        }
        Ok(Drive { rows: rows.into(), ..Drive::default() })
    }

    /// Begins again with the first row, whose time is counted from `origin_ms` on.
    pub fn again(&mut self, origin_ms: u64) {
        self.next = 0;
        self.origin_ms = origin_ms;
    }

    /// Whether every row has been set.
    pub fn is_over(&self) -> bool {
        self.next >= self.rows.len()
    }

    /// Sets every row whose time has come.
    pub fn until<A: Channel, B: Channel>(&mut self, controller: &mut Controller<A, B>, time_ms: u64) {
        let rows = Arc::clone(&self.rows);
        while let Some((at, driven)) = rows.get(self.next) {
            if self.origin_ms.saturating_add(*at) > time_ms {
                break;
            }
            for change in driven {
                match *change {
                    Driven::Bit(cell, value) => controller.drive_bit(cell, value),
                    Driven::Word(cell, value) => {
                        self.words.insert(cell, value);
                        controller.drive_word(cell, value);
                    }
                    Driven::WordBit(cell, bit, value) => {
                        let initial = controller.word(cell).unwrap_or_default();
                        let word = self.words.entry(cell).or_insert(initial);
                        *word = if value { *word | (1 << bit) } else { *word & !(1 << bit) };
                        controller.drive_word(cell, *word);
                    }
                }
            }
            self.next += 1;
        }
    }
}
