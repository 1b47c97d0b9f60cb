//! The observer of one scenario: it follows every cell, and finds out at the end of each rung what decided it.

use std::cell::Cell;

use twinrung_bytecode::CellRange;
use twinrung_bytecode::channel::{Channel, Place};
use twinrung_bytecode::image::Owner;
use twinrung_bytecode::index::{BitCell, WordCell};
use twinrung_bytecode::observer::Observer;
use twinrung_bytecode::operand::OperandRecord;
use twinrung_controller::{Controller, Part, ScanClock};

use super::decide::Seen;
use super::shape::{Condition, Element, RungId};
use super::state::{Cells, Frame, base};
use super::tally::Coverage;
use crate::signal::{Signal, Value};

/// What was last seen of a rung: for each instruction whether power reached it, and whether it passed it on.
pub type Fact = Vec<(bool, bool)>;

/// Watches the primary while a scenario runs.
pub struct Watch<'a> {
    coverage: &'a mut Coverage,
    image_owner: Vec<Owner>,
    /// Whether the scan proper runs: a prescan shows nothing.
    scanning: &'a Cell<bool>,
    cells: Cells,
    /// The inputs as they were frozen for the scan.
    frozen: Vec<Value>,
    open: Vec<Open>,
    writers: Option<Writers>,
}

/// What is kept where somebody wants to know which rung decided a tag.
#[derive(Default)]
struct Writers {
    bits: Vec<Option<RungId>>,
    words: Vec<Option<RungId>>,
    last: Vec<Fact>,
}

/// A rung that is being evaluated.
struct Open {
    rung: RungId,
    routine: u32,
    seen: Vec<Seen>,
    powers: Fact,
    frame: Frame,
    /// What stood in the storage bits when the rung began.
    stored: Vec<(u32, Option<bool>)>,
    next: u32,
}

/// Tells the watch where the prescan ends.
pub struct Begins<'a>(pub &'a Cell<bool>);

impl ScanClock for Begins<'_> {
    fn begin(&mut self) {
        self.0.set(true);
    }

    fn ended(&mut self, _part: Part) {}

    fn expired(&mut self) -> bool {
        false
    }
}

impl<'a> Watch<'a> {
    /// Watches a controller that was powered up just now; `decisions` keeps which rung wrote what.
    pub fn new<A: Channel, B: Channel>(
        coverage: &'a mut Coverage,
        controller: &Controller<A, B>,
        scanning: &'a Cell<bool>,
        decisions: bool,
    ) -> Watch<'a> {
        let cells = Cells::initial(controller.image());
        coverage.powered_up();
        let writers = decisions.then(|| Writers {
            bits: vec![None; cells.bits.len()],
            words: vec![None; cells.words.len()],
            last: vec![Fact::new(); coverage.program().len()],
        });
        let image_owner = controller.image().image().routines.iter().map(|routine| routine.owner).collect();
        Watch { coverage, image_owner, scanning, cells, frozen: Vec::new(), open: Vec::new(), writers }
    }

    /// Inputs are about to be frozen: the cells of these ranges take on what drives them.
    pub fn freeze(&mut self, ranges: &[CellRange], bits: &[bool], words: &[i32]) {
        let cells = &mut self.cells;
        for range in ranges {
            let run = range.bit_cell as usize..(range.bit_cell + range.bit_cells) as usize;
            if let (Some(to), Some(from)) = (cells.bits.get_mut(run.clone()), bits.get(run)) {
                to.copy_from_slice(from);
            }
            let run = range.word_cell as usize..(range.word_cell + range.word_cells) as usize;
            if let (Some(to), Some(from)) = (cells.words.get_mut(run.clone()), words.get(run)) {
                to.copy_from_slice(from);
            }
        }
        self.frozen.clear();
        self.coverage.input_values(cells, &mut self.frozen);
    }

    /// A scan boundary is passed; `executed` where logic ran.
    pub fn scanned<A: Channel, B: Channel>(&mut self, controller: &Controller<A, B>, executed: bool) {
        while let Some(open) = self.open.pop() {
            self.finish(open);
        }
        self.scanning.set(false);
        let missed = self.cells.reconcile(controller);
        if executed {
            self.coverage.inputs(&self.frozen);
            self.coverage.scanned(controller, missed);
        }
    }

    /// The rung that wrote a signal last.
    pub fn writer(&self, signal: Signal) -> Option<RungId> {
        let writers = self.writers.as_ref()?;
        match signal {
            Signal::Bit(cell) | Signal::PublishedBit(cell) => *writers.bits.get(cell.position())?,
            Signal::Word(cell, _)
            | Signal::WordBit(cell, _)
            | Signal::PublishedWord(cell, _)
            | Signal::PublishedWordBit(cell, _) => *writers.words.get(cell.position())?,
            Signal::ControllerMode | Signal::ControllerFault => None,
        }
    }

    /// What was seen of a rung when it was last evaluated.
    pub fn fact(&self, rung: RungId) -> Option<&Fact> {
        self.writers.as_ref()?.last.get(rung.0 as usize)
    }

    /// The coverage.
    pub fn coverage(&self) -> &Coverage {
        self.coverage
    }

    fn finish(&mut self, open: Open) {
        self.coverage.evaluated(open.rung, &open.seen);
        if let Some(last) = self.writers.as_mut().and_then(|writers| writers.last.get_mut(open.rung.0 as usize)) {
            *last = open.powers;
        }
    }

    /// Ends what was evaluated above this routine's rung.
    fn close_above(&mut self, keep: impl Fn(&Open) -> bool) {
        while self.open.last().is_some_and(|open| !keep(open)) {
            if let Some(open) = self.open.pop() {
                self.finish(open);
            }
        }
    }

    /// Where the cells of the instance begin whose routine is entered.
    fn frame(&self, routine: usize) -> Frame {
        if !matches!(self.image_owner.get(routine), Some(Owner::AddOn(_))) {
            return None;
        }
        let caller = self.open.last()?;
        let rung = self.coverage.program().rung(caller.rung);
        let Some(Element::AddOn(_, operands)) = rung.elements.get(caller.next as usize) else { return None };
        let Some(OperandRecord::Reference(instance)) = operands.first() else { return None };
        let (bits, words) = base(&instance.access, caller.frame)?;
        Some((bits + instance.access.bit_cell, words + instance.access.word_cell))
    }
}

impl Observer for Watch<'_> {
    fn rung_entered(&mut self, place: Place) {
        if !self.scanning.get() {
            return;
        }
        let routine = place.routine.0;
        let returned = self.open.iter().any(|open| open.routine == routine);
        let mut frame = None;
        if returned {
            self.close_above(|open| open.routine == routine);
            if let Some(before) = self.open.pop() {
                frame = before.frame;
                self.finish(before);
            }
        }
        let frame = frame.or_else(|| self.frame(place.routine.position()));
        let Some(rung) = self.coverage.program().at(place.routine, place.rung) else { return };
        let elements = &self.coverage.program().rung(rung).elements;
        let stored = elements.iter().enumerate().filter_map(|(position, element)| match element {
            Element::Condition(condition @ Condition::OneShot(_)) => {
                Some((position as u32, self.cells.passes(condition, frame)))
            }
            _ => None,
        });
        let open = Open {
            rung,
            routine,
            seen: vec![Seen { reached: None, passes: None }; elements.len()],
            powers: vec![(false, false); elements.len()],
            frame,
            stored: stored.collect(),
            next: 0,
        };
        self.open.push(open);
    }

    fn element_result(&mut self, place: Place, condition_in: bool, condition_out: bool) {
        if !self.scanning.get() {
            return;
        }
        let Some(rung) = self.coverage.program().at(place.routine, place.rung) else { return };
        self.close_above(|open| open.rung == rung);
        let Some(open) = self.open.last_mut() else { return };
        let position = place.element as usize;
        let passes = match self.coverage.program().rung(rung).elements.get(position) {
            _ if condition_in => Some(condition_out),
            Some(Element::Condition(Condition::OneShot(_))) => {
                open.stored.iter().find(|(at, _)| *at == place.element).and_then(|(_, passes)| *passes)
            }
            Some(Element::Condition(condition)) => self.cells.passes(condition, open.frame),
            _ => None,
        };
        if let (Some(seen), Some(power)) = (open.seen.get_mut(position), open.powers.get_mut(position)) {
            *seen = Seen { reached: Some(condition_in), passes };
            *power = (condition_in, condition_out);
        }
        open.next = place.element + 1;
    }

    fn bit_written(&mut self, cell: BitCell, value: bool) {
        if let Some(held) = self.cells.bits.get_mut(cell.position()) {
            *held = value;
        }
        let rung = self.open.last().map(|open| open.rung);
        if let Some(writer) = self.writers.as_mut().and_then(|writers| writers.bits.get_mut(cell.position())) {
            *writer = rung.or(*writer);
        }
    }

    fn word_written(&mut self, cell: WordCell, value: i32) {
        if let Some(held) = self.cells.words.get_mut(cell.position()) {
            *held = value;
        }
        let rung = self.open.last().map(|open| open.rung);
        if let Some(writer) = self.writers.as_mut().and_then(|writers| writers.words.get_mut(cell.position())) {
            *writer = rung.or(*writer);
        }
    }
}
