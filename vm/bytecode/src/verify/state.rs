//! What the check of the code gathers: the cells that logic writes, calls of backing tags, subroutines, lengths.

use alloc::collections::BTreeSet;
use alloc::rc::Rc;
use alloc::vec::Vec;

use super::place::Place;
use super::tables::Tables;
use crate::admitted::CellSet;
use crate::error::{ImageError, Site};
use crate::image::{AddOnRecord, TagKind, TypeReference};
use crate::index::TypeIndex;
use crate::layout;
use crate::limits;
use crate::operand::{Base, Shape};

/// A backing tag, or an instance that holds some, as one call uses it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Use {
    /// `None` = the image's own cells; `Some(None)` = the instance; otherwise an InOut parameter.
    base: Option<Option<u16>>,
    bit_cell: u32,
    word_cell: u32,
    type_index: TypeIndex,
}

/// What is known of an Add-On Instruction once its routines are checked.
#[derive(Debug, Clone, Default)]
pub(super) struct Summary {
    /// For each parameter whether the logic writes it; read for InOut parameters.
    pub(super) writes: Vec<bool>,
    /// Parameters that have an argument, in declared order.
    pub(super) arguments: Vec<u16>,
    /// Backing tags that its calls use.
    uses: BTreeSet<Use>,
    /// Whether one of them lies in its instance.
    uses_instance: bool,
    /// Those that lie in its InOut parameters, with the parameter.
    uses_in_out: Vec<(u16, Use)>,
    /// Instructions of its routines, calls replaced by what they run.
    pub(super) length: u64,
    /// Add-On Instructions within it.
    pub(super) depth: usize,
}

impl Summary {
    pub(super) fn new(record: &AddOnRecord) -> Summary {
        let with_argument = record.parameters.iter().enumerate().filter(|(_, parameter)| parameter.argument);
        Summary {
            writes: alloc::vec![false; record.parameters.len()],
            arguments: with_argument.map(|(index, _)| index as u16).collect(),
            ..Summary::default()
        }
    }
}

/// What is gathered for one owner: an Add-On Instruction, or all programs together.
pub(super) struct State {
    pub(super) summaries: Vec<Rc<Summary>>,
    /// Of the Add-On Instruction that is being checked; of the programs otherwise.
    pub(super) current: Summary,
    /// Uses so far, over all owners.
    uses: usize,
    bits: Vec<(u32, u32)>,
    words: Vec<(u32, u32)>,
    /// Words of CONTROL structures that file instructions work with.
    control_words: Vec<(u32, u32)>,
}

impl State {
    pub(super) fn new() -> State {
        State {
            summaries: Vec::new(),
            current: Summary::default(),
            uses: 0,
            bits: Vec::new(),
            words: Vec::new(),
            control_words: Vec::new(),
        }
    }

    /// Logic writes `elements` elements from a place on.
    pub(super) fn write(
        &mut self,
        tables: &Tables<'_>,
        at: Site,
        place: &Place,
        elements: u32,
    ) -> Result<(), ImageError> {
        if place.within_backing {
            return Err(ImageError::WriteBacking { at });
        }
        match place.base {
            Base::Absolute => {}
            // The call marks the whole instance.
            Base::Instance => return Ok(()),
            Base::InOut(parameter) => {
                if let Some(writes) = self.current.writes.get_mut(usize::from(parameter)) {
                    *writes = true;
                }
                return Ok(());
            }
        }
        if let Some(tag) = place.tag
            && let Some(record) = tables.image.tags.get(tag.position())
        {
            if record.constant || place.constant {
                return Err(ImageError::WriteConstant { at, tag });
            }
            if record.kind == TagKind::Consumed {
                return Err(ImageError::WriteConsumed { at, tag });
            }
            if tables.mapped.get(tag.position()) == Some(&true) {
                return Err(ImageError::WriteMapped { at, tag });
            }
        }
        let (bits, words) = match place.shape() {
            Shape::WordBit(_) => (0, 1),
            _ => layout::cells(tables.layouts, place.type_reference).unwrap_or((0, 0)),
        };
        let range = |begin: u32, span: u32, each: u32| {
            (begin, begin.saturating_add(span).saturating_add(each.saturating_mul(elements)))
        };
        if bits > 0 {
            self.bits.push(range(place.bit_cell, place.bit_span, bits));
        }
        if words > 0 {
            self.words.push(range(place.word_cell, place.word_span, words));
        }
        Ok(())
    }

    /// FAL, FSC or RES works with a structure: of a CONTROL it changes POS and the bits, and never LEN.
    pub(super) fn write_control(&mut self, tables: &Tables<'_>, at: Site, place: &Place) -> Result<(), ImageError> {
        let before = self.words.len();
        self.write(tables, at, place, 1)?;
        self.control_words.append(&mut self.words.split_off(before));
        Ok(())
    }

    /// A call uses a backing tag, or an instance that holds one: no other may.
    pub(super) fn use_backing(&mut self, at: Site, place: &Place) -> Result<(), ImageError> {
        if place.variable {
            return Err(ImageError::BackingVariable { at });
        }
        let TypeReference::Structure(type_index) = place.type_reference else { return Ok(()) };
        let base = match place.base {
            Base::Absolute => None,
            Base::Instance => Some(None),
            Base::InOut(parameter) => Some(Some(parameter)),
        };
        self.insert(at, Use { base, bit_cell: place.bit_cell, word_cell: place.word_cell, type_index })
    }

    fn insert(&mut self, at: Site, used: Use) -> Result<(), ImageError> {
        self.uses = self.uses.saturating_add(1);
        if self.uses > limits::BACKING_CALLS {
            return Err(ImageError::BackingCount);
        }
        if !self.current.uses.insert(used) {
            return Err(ImageError::BackingTwice { at });
        }
        match used.base {
            None => {}
            Some(None) => self.current.uses_instance = true,
            Some(Some(parameter)) => self.current.uses_in_out.push((parameter, used)),
        }
        Ok(())
    }

    /// A call of an Add-On Instruction uses what its logic uses: its instance, and backing tags in InOut arguments.
    pub(super) fn use_callee(
        &mut self,
        at: Site,
        callee: &Summary,
        instance: &Place,
        in_out: &[(u16, Place)],
    ) -> Result<(), ImageError> {
        if callee.uses_instance {
            self.use_backing(at, instance)?;
        }
        for (parameter, used) in &callee.uses_in_out {
            let Ok(position) = in_out.binary_search_by_key(parameter, |(passed, _)| *passed) else { continue };
            let Some((_, argument)) = in_out.get(position) else { continue };
            let place = Place {
                type_reference: TypeReference::Structure(used.type_index),
                bit_cell: argument.bit_cell.saturating_add(used.bit_cell),
                word_cell: argument.word_cell.saturating_add(used.word_cell),
                ..*argument
            };
            self.use_backing(at, &place)?;
        }
        Ok(())
    }

    /// The cells that programs write, and the words among them that are written other than by [`State::write_control`].
    pub(super) fn writes(mut self, bit_cells: usize, word_cells: usize) -> (CellSet, Vec<bool>) {
        let by_others = marked(self.words.clone(), word_cells);
        self.words.append(&mut self.control_words);
        (CellSet { bits: marked(self.bits, bit_cells), words: marked(self.words, word_cells) }, by_others)
    }
}

fn marked(mut ranges: Vec<(u32, u32)>, cells: usize) -> Vec<bool> {
    ranges.sort_unstable();
    let mut marked = alloc::vec![false; cells];
    let mut done = 0usize;
    for (begin, end) in ranges {
        let begin = (begin as usize).max(done);
        let end = (end as usize).min(cells);
        if let Some(range) = marked.get_mut(begin..end) {
            range.fill(true);
        }
        done = done.max(end);
    }
    marked
}
