//! The three evaluators side by side.

use twinrung_bytecode::CellRange;
use twinrung_bytecode::channel::{Channel, Representation, ScanEnd, ScanInputs};
use twinrung_bytecode::image::TagKind;
use twinrung_bytecode::index::{BitCell, EventTaskIndex, ProgramIndex, TagIndex, WordCell};
use twinrung_bytecode::layout;
use twinrung_bytecode::observer::Silent;
use twinrung_catalog::Element;
use twinrung_compiler::project::TagId;
use twinrung_judge::{End, Judge};
use twinrung_partner::Partner;
use twinrung_primary::Primary;
use twinrung_workbench::{Signal, Value, names};

use crate::disagreement::{Disagreement, LISTED};
use crate::subject::{Subject, library};

/// How a scan ended, all three agreeing.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ended {
    /// All programs ran.
    Completed,
    /// A major fault 4/code that nothing cleared.
    Fault(u16),
    /// The budget ran out.
    BudgetExceeded,
}

/// Three evaluators of one subject.
pub struct Trio<'s> {
    subject: &'s Subject,
    primary: Primary,
    partner: Partner,
    judge: Judge<'s>,
    tags: Vec<(TagId, CellRange)>,
    system_values: Vec<i32>,
    scans: u64,
    /// Instructions that a scan may execute.
    pub budget: u64,
}

impl<'s> Trio<'s> {
    /// Loads a subject into all three. Nothing is prescanned yet.
    pub fn new(subject: &'s Subject) -> Trio<'s> {
        let mut judge = Judge::new(&subject.project, library());
        let tags = tags(subject);
        let records = subject.image.image();
        for (tag, range) in &tags {
            let bits = &records.initial_bits[range.bit_cell as usize..][..range.bit_cells as usize];
            let words = &records.initial_words[range.word_cell as usize..][..range.word_cells as usize];
            judge.set_tag(*tag, bits, words);
        }
        judge.number_as(numbers_of_programs(subject), numbers_of_routines(subject));
        let values = records.system_values.iter().map(|value| value.first as usize + 11).max().unwrap_or(0);
        Trio {
            primary: Primary::load(&subject.image).unwrap_or_else(|error| panic!("primary: {error}")),
            partner: Partner::load(&subject.image).unwrap_or_else(|error| panic!("partner: {error}")),
            subject,
            judge,
            tags,
            system_values: vec![0; values],
            scans: 0,
            budget: 10_000_000,
        }
    }

    /// Sets one value in all three, by its full name.
    pub fn set(&mut self, name: &str, value: Value) {
        let signal = names::signal(&self.subject.image, name).unwrap_or_else(|error| panic!("{error}"));
        match (signal, value) {
            (Signal::Bit(cell), value) => self.set_bit(cell, value.is_true()),
            (Signal::Word(cell, Element::Real), Value::Real(value)) => self.set_word(cell, value.to_bits() as i32),
            (Signal::Word(cell, _), Value::Integer(value)) => self.set_word(cell, value),
            (signal, value) => panic!("{name}: {value:?} is no value of {signal:?}"),
        }
    }

    /// Every single value of every tag, with its full name.
    pub fn signals(&self) -> Vec<(String, Signal)> {
        let values = |(_, range): &(TagId, CellRange)| names::values_of(&self.subject.image, range.tag);
        self.tags.iter().flat_map(values).collect()
    }

    /// Sets a bit cell in all three.
    pub fn set_bit(&mut self, cell: BitCell, value: bool) {
        self.primary.set_bit(cell, value);
        self.partner.set_bit(cell, value);
        self.copy_to_judge(|range| (range.bit_cell..range.bit_cell + range.bit_cells).contains(&cell.0));
    }

    /// Sets a word cell in all three.
    pub fn set_word(&mut self, cell: WordCell, value: i32) {
        self.primary.set_word(cell, value);
        self.partner.set_word(cell, value);
        self.copy_to_judge(|range| (range.word_cell..range.word_cell + range.word_cells).contains(&cell.0));
    }

    fn copy_to_judge(&mut self, holds: impl Fn(&CellRange) -> bool) {
        for (tag, range) in self.tags.iter().filter(|(_, range)| holds(range)) {
            let bits = plain_bits(&self.primary)[range.bit_cell as usize..][..range.bit_cells as usize].to_vec();
            let words = plain_words(&self.primary)[range.word_cell as usize..][..range.word_cells as usize].to_vec();
            self.judge.set_tag(*tag, &bits, &words);
        }
    }

    /// A value, by its full name.
    pub fn value(&self, name: &str) -> Value {
        let signal = names::signal(&self.subject.image, name).unwrap_or_else(|error| panic!("{error}"));
        match signal {
            Signal::Bit(cell) => Value::Bool(plain_bits(&self.primary)[cell.position()] == 1),
            Signal::Word(cell, Element::Real) => {
                Value::Real(f32::from_bits(plain_words(&self.primary)[cell.position()] as u32))
            }
            Signal::Word(cell, _) => Value::Integer(plain_words(&self.primary)[cell.position()]),
            Signal::WordBit(cell, bit) => Value::Bool((plain_words(&self.primary)[cell.position()] >> bit) & 1 == 1),
            other => panic!("{other:?} is a value of the controller"),
        }
    }

    /// Scans so far.
    pub fn scans(&self) -> u64 {
        self.scans
    }

    /// Instructions that one evaluator has executed so far.
    pub fn executed(&self) -> u64 {
        self.primary.status().executed
    }

    /// Status of the channels, after they were found equal.
    pub fn status(&self) -> twinrung_bytecode::channel::Status {
        self.primary.status()
    }

    /// How often EVENT triggered a task in the last scan, after the three were found equal. Panics when no EVENT names it.
    pub fn events(&self, task: &str) -> u32 {
        let tasks = &self.subject.image.image().event_tasks;
        let index = tasks.iter().position(|name| name.eq_ignore_ascii_case(task));
        let index = index.unwrap_or_else(|| panic!("no EVENT names the task `{task}`"));
        self.primary.events(EventTaskIndex(index as u16))
    }

    /// Prescans all three.
    ///
    /// # Errors
    ///
    /// What they disagree in.
    pub fn prescan(&mut self, now_ms: i64) -> Result<Ended, Disagreement> {
        let inputs = ScanInputs { now_ms, budget: self.budget, system_values: &self.system_values };
        let ends = (self.primary.prescan(inputs, &mut Silent), self.partner.prescan(inputs, &mut Silent));
        let judged = self.judge.prescan(now_ms, self.budget);
        self.compare(None, ends, judged)
    }

    /// One scan of all three.
    ///
    /// # Errors
    ///
    /// What they disagree in.
    pub fn scan(&mut self, now_ms: i64) -> Result<Ended, Disagreement> {
        let inputs = ScanInputs { now_ms, budget: self.budget, system_values: &self.system_values };
        let ends = (self.primary.scan(inputs, &mut Silent), self.partner.scan(inputs, &mut Silent));
        let judged = self.judge.scan(now_ms, self.budget);
        self.scans += 1;
        self.compare(Some(self.scans - 1), ends, judged)
    }

    fn compare(&self, scan: Option<u64>, ends: (ScanEnd, ScanEnd), judged: End) -> Result<Ended, Disagreement> {
        let mut values = Vec::new();
        let mut note = |name: String, found: [String; 3]| {
            if found[0] != found[1] || found[1] != found[2] {
                values.push((name, found));
            }
        };
        note("end".to_owned(), [end_words(ends.0), end_words(ends.1), judged_words(judged)]);
        let status = [status_words(&self.primary), status_words(&self.partner), self.judge_status_words()];
        note("status".to_owned(), status);
        for program in 0..self.subject.image.image().programs.len() {
            let index = ProgramIndex(program as u16);
            let found = [
                format!("{:?}", self.primary.fault_record(index).unwrap_or_default()),
                format!("{:?}", self.partner.fault_record(index).unwrap_or_default()),
                format!("{:?}", self.judge.fault_record(program)),
            ];
            note(format!("fault record of program {program}"), found);
        }
        for (task, name) in self.subject.image.image().event_tasks.iter().enumerate() {
            let index = EventTaskIndex(task as u16);
            let found = [self.primary.events(index), self.partner.events(index), self.judge.events(name)];
            note(format!("events of {name}"), found.map(|count| count.to_string()));
        }
        self.compare_tags(&mut values);
        values.truncate(LISTED);
        if values.is_empty() {
            return Ok(match ends.0 {
                ScanEnd::Completed => Ended::Completed,
                ScanEnd::MajorFault(fault) => Ended::Fault(fault.code),
                ScanEnd::BudgetExceeded => Ended::BudgetExceeded,
            });
        }
        Err(Disagreement { scan, values })
    }

    fn compare_tags(&self, values: &mut Vec<(String, [String; 3])>) {
        let (bits, words) = (plain_bits(&self.primary), plain_words(&self.primary));
        let (other_bits, other_words) = (plain_bits(&self.partner), plain_words(&self.partner));
        for (tag, range) in &self.tags {
            let Some((judged_bits, judged_words)) = self.judge.tag(*tag) else { continue };
            let at = range.bit_cell as usize..(range.bit_cell + range.bit_cells) as usize;
            let same_bits = bits[at.clone()] == judged_bits && other_bits[at.clone()] == judged_bits;
            let word_at = range.word_cell as usize..(range.word_cell + range.word_cells) as usize;
            let same_words = words[word_at.clone()] == judged_words && other_words[word_at.clone()] == judged_words;
            if same_bits && same_words {
                continue;
            }
            for (name, signal) in names::values_of(&self.subject.image, range.tag) {
                let found = match signal {
                    Signal::Bit(cell) => {
                        let offset = cell.position() - at.start;
                        [bits[cell.position()], other_bits[cell.position()], judged_bits[offset]].map(i32::from)
                    }
                    Signal::Word(cell, _) => {
                        let offset = cell.position() - word_at.start;
                        [words[cell.position()], other_words[cell.position()], judged_words[offset]]
                    }
                    _ => continue,
                };
                if found[0] != found[1] || found[1] != found[2] {
                    values.push((name, found.map(|value| format!("{value} (16#{value:08x})"))));
                }
                if values.len() >= LISTED {
                    return;
                }
            }
        }
    }

    fn judge_status_words(&self) -> String {
        let flags = self.judge.flags();
        words_of_status(
            [flags.first_scan, flags.overflow, flags.zero, flags.negative, flags.carry, flags.minor_fault],
            [u64::from(flags.minor_faults), flags.executed, u64::from(flags.cleared_faults)],
        )
    }
}

fn status_words(channel: &impl Channel) -> String {
    let status = channel.status();
    words_of_status(
        [status.first_scan, status.overflow, status.zero, status.negative, status.carry, status.minor_fault],
        [u64::from(status.minor_faults), status.executed, u64::from(status.cleared_faults)],
    )
}

fn words_of_status(flags: [bool; 6], counts: [u64; 3]) -> String {
    let flags: Vec<&str> = ["FS", "V", "Z", "N", "C", "MINOR"]
        .into_iter()
        .zip(flags)
        .filter(|(_, on)| *on)
        .map(|(name, _)| name)
        .collect();
    let [minor, executed, cleared] = counts;
    format!("[{}] minor {minor} executed {executed} cleared {cleared}", flags.join(" "))
}

fn end_words(end: ScanEnd) -> String {
    match end {
        ScanEnd::Completed => "completed".to_owned(),
        ScanEnd::BudgetExceeded => "budget exceeded".to_owned(),
        ScanEnd::MajorFault(fault) => fault_words(
            fault.code,
            [u32::from(fault.place.program.0), fault.place.routine.0, fault.place.rung, fault.place.element],
        ),
    }
}

fn judged_words(end: End) -> String {
    match end {
        End::Completed => "completed".to_owned(),
        End::BudgetExceeded => "budget exceeded".to_owned(),
        End::MajorFault(fault) => fault_words(fault.code, fault.place),
    }
}

fn fault_words(code: u16, place: [u32; 4]) -> String {
    let [program, routine, rung, element] = place;
    format!("fault 4/{code} at program {program}, routine {routine}, rung {rung}, element {element}")
}

fn plain_bits<C: Channel>(channel: &C) -> Vec<u8> {
    match C::REPRESENTATION {
        Representation::Plain => channel.bits().to_vec(),
        Representation::Complemented => channel.bits().iter().map(|byte| !byte).collect(),
    }
}

fn plain_words<C: Channel>(channel: &C) -> Vec<i32> {
    match C::REPRESENTATION {
        Representation::Plain => channel.words().iter().map(|word| *word as i32).collect(),
        Representation::Complemented => channel.words().iter().map(|word| !*word as i32).collect(),
    }
}

/// Which tag of the checked project holds which cells.
fn tags(subject: &Subject) -> Vec<(TagId, CellRange)> {
    let records = subject.image.image();
    let plain = records.tags.iter().enumerate().filter(|(_, record)| !matches!(record.kind, TagKind::Alias(_)));
    plain
        .map(|(index, record)| {
            let (bits, words) = layout::cells(subject.image.layouts(), record.type_reference).unwrap_or_default();
            let elements = layout::elements(record.dimensions).unwrap_or_default();
            let range = CellRange {
                tag: TagIndex(index as u32),
                bit_cell: record.bit_cell,
                bit_cells: bits * elements,
                word_cell: record.word_cell,
                word_cells: words * elements,
            };
            (subject.tags[index], range)
        })
        .collect()
}

/// The number in the image of each program of the project.
fn numbers_of_programs(subject: &Subject) -> Vec<u32> {
    let records = &subject.image.image().programs;
    let number = |name: &str| records.iter().position(|record| record.name.eq_ignore_ascii_case(name));
    subject.project.programs.iter().map(|program| number(&program.name).unwrap_or_default() as u32).collect()
}

/// The number in the image of each routine of the project.
fn numbers_of_routines(subject: &Subject) -> Vec<u32> {
    let mut numbers = vec![0; subject.project.routines.len()];
    for (index, routine) in subject.routines.iter().enumerate() {
        numbers[routine.position()] = index as u32;
    }
    numbers
}
