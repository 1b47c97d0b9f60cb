//! What was shown so far, item by item.

use std::collections::HashSet;

use serde::Serialize;
use twinrung_bytecode::AdmittedImage;
use twinrung_bytecode::channel::Channel;
use twinrung_bytecode::image::{Owner, TagKind};
use twinrung_bytecode::index::TagIndex;
use twinrung_catalog::Element;
use twinrung_controller::Controller;

use super::codes::{CodeOfCall, codes};
use super::decide::{Seen, decided};
use super::item::{Item, Kind};
use super::reads::Reads;
use super::shape::{self, Program, Rung, RungId};
use super::state::Cells;
use super::way::way;
use crate::names;
use crate::signal::{ReadSignal, Signal, Value};

/// Evaluations of one rung that are remembered, so that none is looked at twice.
const REMEMBERED_MAX: usize = 1 << 20;

/// What scenarios have shown of one image.
pub struct Coverage {
    program: Program,
    /// `Program/Routine` of each routine.
    routines: Vec<String>,
    inputs: Vec<Toggled>,
    outputs: Vec<Toggled>,
    /// For each rung whether it was false and whether it was true.
    ends: Vec<[bool; 2]>,
    /// For each rung, each element, whether it decided open and closed.
    decided: Vec<Vec<[bool; 2]>>,
    codes: Vec<CodeOfCall>,
    remembered: HashSet<(RungId, Box<[Seen]>)>,
    missed_writes: u64,
    inconsistent: u64,
}

/// Something that should change both ways.
struct Toggled {
    name: String,
    signal: Signal,
    before: Option<f64>,
    up: bool,
    down: bool,
}

impl Toggled {
    fn see(&mut self, value: Value) {
        let now = match value {
            Value::Bool(value) => f64::from(u8::from(value)),
            Value::Integer(value) => f64::from(value),
            Value::Real(value) => f64::from(value),
        };
        if let Some(before) = self.before {
            self.up |= now > before;
            self.down |= now < before;
        }
        self.before = Some(now);
    }

    fn items(&self, kind: Kind, way: impl Fn(&str, &str) -> String) -> [Item; 2] {
        let words = if matches!(self.signal, Signal::Bit(_) | Signal::PublishedBit(_)) {
            ["on", "off"]
        } else {
            ["up", "down"]
        };
        let word = if kind == Kind::Input { "input" } else { "output" };
        [(words[0], self.up), (words[1], self.down)].map(|(direction, reached)| Item {
            kind,
            name: format!("{word} {} to {direction}", self.name),
            reached,
            way: way(&self.name, direction),
            excluded: None,
        })
    }
}

/// Items of one kind.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
pub struct Share {
    /// Items.
    pub total: usize,
    /// Items that were shown.
    pub reached: usize,
    /// Items that were not, and are excluded with a reason.
    pub excluded: usize,
}

impl Share {
    /// Percent of what is to be shown, rounded down, so that 100 means all.
    pub fn percent(&self) -> u8 {
        (self.reached * 100).checked_div(self.total - self.excluded).map_or(100, |percent| percent as u8)
    }

    fn add(&mut self, item: &Item) {
        self.total += 1;
        self.reached += usize::from(item.reached);
        self.excluded += usize::from(!item.reached && item.excluded.is_some());
    }
}

/// Shares by kind.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Summary {
    /// Of each kind, in their order.
    pub kinds: Vec<(Kind, Share)>,
    /// All together.
    pub all: Share,
}

impl Summary {
    /// Counts items.
    pub fn of(items: &[Item]) -> Summary {
        let mut summary =
            Summary { kinds: Kind::ALL.map(|kind| (kind, Share::default())).to_vec(), all: Share::default() };
        for item in items {
            summary.all.add(item);
            if let Some((_, share)) = summary.kinds.iter_mut().find(|(kind, _)| *kind == item.kind) {
                share.add(item);
            }
        }
        summary
    }
}

impl Coverage {
    /// Nothing shown yet.
    pub fn new(image: &AdmittedImage) -> Coverage {
        let program = Program::new(image);
        let ends = vec![[false; 2]; program.len()];
        let decided = program.rungs().map(|(_, rung)| vec![[false; 2]; rung.elements.len()]).collect();
        let records = image.image();
        let routines = records.routines.iter().map(|routine| {
            let owner = match routine.owner {
                Owner::Program(index) => records.programs.get(index.position()).map(|program| program.name.as_str()),
                Owner::AddOn(index) => records.add_ons.get(index.position()).map(|add_on| add_on.name.as_str()),
            };
            format!("{}/{}", owner.unwrap_or("?"), routine.name)
        });
        Coverage {
            codes: codes(image, &program),
            routines: routines.collect(),
            inputs: inputs(image),
            outputs: outputs(image),
            program,
            ends,
            decided,
            remembered: HashSet::new(),
            missed_writes: 0,
            inconsistent: 0,
        }
    }

    pub(crate) fn program(&self) -> &Program {
        &self.program
    }

    /// `Program/Routine` of a rung.
    pub fn routine_name(&self, rung: &Rung) -> &str {
        self.routines.get(rung.routine.position()).map_or("?", String::as_str)
    }

    /// Cells that changed in a scan without a word of the observer, and evaluations of rungs that do not agree with their
    /// wires. Both are 0 while the observer tells everything.
    pub fn doubts(&self) -> (u64, u64) {
        (self.missed_writes, self.inconsistent)
    }

    pub(super) fn powered_up(&mut self) {
        self.inputs.iter_mut().chain(&mut self.outputs).for_each(|one| one.before = None);
    }

    /// The values of the inputs in these cells, in the order of the inputs.
    pub(super) fn input_values(&self, cells: &Cells, values: &mut Vec<Value>) {
        values.extend(self.inputs.iter().map(|input| match input.signal {
            Signal::Bit(cell) => Value::Bool(cells.bits.get(cell.position()).copied().unwrap_or_default()),
            Signal::Word(cell, element) => {
                let word = cells.words.get(cell.position()).copied().unwrap_or_default();
                if element == Element::Real { Value::Real(f32::from_bits(word as u32)) } else { Value::Integer(word) }
            }
            // Inputs are whole cells.
            _ => Value::Integer(0),
        }));
    }

    pub(super) fn inputs(&mut self, values: &[Value]) {
        self.inputs.iter_mut().zip(values).for_each(|(input, value)| input.see(*value));
    }

    pub(super) fn scanned<A: Channel, B: Channel>(&mut self, controller: &Controller<A, B>, missed_writes: u64) {
        self.missed_writes += missed_writes;
        self.outputs.iter_mut().for_each(|output| output.see(output.signal.read(controller)));
        for code in self.codes.iter_mut().filter(|code| !code.reached) {
            code.reached = code.signal.read(controller) == code.value;
        }
    }

    pub(super) fn evaluated(&mut self, id: RungId, seen: &[Seen]) {
        let key = (id, Box::from(seen));
        if self.remembered.contains(&key) {
            return;
        }
        let found = decided(self.program.rung(id), seen);
        self.inconsistent += u64::from(!found.consistent);
        if let (Some(end), true) = (found.end, found.consistent) {
            self.ends[id.0 as usize][usize::from(end)] = true;
        }
        for (position, passes) in found.conditions {
            self.decided[id.0 as usize][position as usize][usize::from(passes)] = true;
        }
        if self.remembered.len() < REMEMBERED_MAX {
            self.remembered.insert(key);
        }
    }

    /// Everything there is to cover, and whether it was.
    pub fn items(&self) -> Vec<Item> {
        let mut items = Vec::new();
        for input in &self.inputs {
            items.extend(input.items(Kind::Input, |name, direction| match direction {
                "on" | "off" => format!("`when {name} is {direction}`, after a scan in which it was not"),
                _ => format!("drive {name} {direction} from one scan to a later one"),
            }));
        }
        for output in &self.outputs {
            items.extend(output.items(Kind::Output, |name, direction| format!("let logic switch {name} {direction}")));
        }
        for (id, rung) in self.program.rungs() {
            self.rung_items(id, rung, &mut items);
        }
        for (id, rung) in self.program.rungs() {
            self.contact_items(id, rung, &mut items);
        }
        items.extend(self.codes.iter().map(|code| Item {
            kind: Kind::Code,
            name: code.name.clone(),
            reached: code.reached,
            way: code.cause.to_owned(),
            excluded: None,
        }));
        items
    }

    fn rung_items(&self, id: RungId, rung: &Rung, items: &mut Vec<Item>) {
        let place = format!("{} {}", self.routine_name(rung), rung.number);
        // A rung without a condition is never false.
        let ends: &[bool] =
            if rung.elements.iter().any(shape::Element::is_condition) { &[true, false] } else { &[true] };
        items.extend(ends.iter().map(|end| Item {
            kind: Kind::Rung,
            name: format!("rung {place} {end}"),
            reached: self.ends[id.0 as usize][usize::from(*end)],
            way: format!("evaluate {} with power {} its end", rung.text, if *end { "at" } else { "missing at" }),
            excluded: None,
        }));
    }

    fn contact_items(&self, id: RungId, rung: &Rung, items: &mut Vec<Item>) {
        for (position, (element, text)) in rung.elements.iter().zip(&rung.names).enumerate() {
            if !element.is_condition() {
                continue;
            }
            let before = rung.names[..position].iter().filter(|other| *other == text).count();
            let again = if before == 0 { String::new() } else { format!(" #{}", before + 1) };
            for (passes, word) in [(true, "closed"), (false, "open")] {
                let reached = self.decided[id.0 as usize][position][usize::from(passes)];
                items.push(Item {
                    kind: Kind::Contact,
                    name: format!("contact {} {} {text}{again} {word}", self.routine_name(rung), rung.number),
                    reached,
                    way: if reached { String::new() } else { way(rung, position as u32, passes) },
                    excluded: None,
                });
            }
        }
    }
}

/// Frozen values that logic looks at, under the name that logic uses.
fn inputs(image: &AdmittedImage) -> Vec<Toggled> {
    let reads = Reads::new(image);
    let aliases = aliases(image);
    let frozen = image.frozen().iter().flat_map(|range| names::values_of(image, range.tag));
    frozen
        .filter(|(_, signal)| match signal {
            Signal::Bit(cell) => reads.has_bit(cell.0),
            Signal::Word(cell, _) => reads.has_word(cell.0),
            _ => false,
        })
        .map(|(name, signal)| toggled(&aliases, name, signal))
        .collect()
}

/// Published values that logic writes, under the name that logic uses.
fn outputs(image: &AdmittedImage) -> Vec<Toggled> {
    let writes = image.program_writes();
    let aliases = aliases(image);
    let published = image.published().iter().flat_map(|range| names::values_of(image, range.tag));
    published
        .filter(|(_, signal)| match signal {
            Signal::Bit(cell) => writes.has_bit(*cell),
            Signal::Word(cell, _) => writes.has_word(*cell),
            _ => false,
        })
        .map(|(name, signal)| {
            let named = toggled(&aliases, name, signal);
            Toggled { signal: signal.published(), ..named }
        })
        .collect()
}

fn toggled(aliases: &[(String, Signal)], name: String, signal: Signal) -> Toggled {
    let alias = aliases.iter().find(|(_, other)| *other == signal).map(|(alias, _)| alias.clone());
    Toggled { name: alias.unwrap_or(name), signal, before: None, up: false, down: false }
}

/// Aliases of single values.
fn aliases(image: &AdmittedImage) -> Vec<(String, Signal)> {
    let tags = image.image().tags.iter().enumerate();
    tags.filter(|(_, tag)| matches!(tag.kind, TagKind::Alias(_)))
        .filter_map(|(index, _)| match names::values_of(image, TagIndex(index as u32)).as_slice() {
            [one] => Some(one.clone()),
            _ => None,
        })
        .collect()
}
