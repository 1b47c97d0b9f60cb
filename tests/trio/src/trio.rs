//! The three evaluators side by side.

use twinrung_bytecode::CellRange;
use twinrung_bytecode::channel::{Channel, ScanInputs, Status};
use twinrung_bytecode::image::TagKind;
use twinrung_bytecode::index::{BitCell, EventTaskIndex, TagIndex, WordCell};
use twinrung_bytecode::layout;
use twinrung_bytecode::observer::Silent;
use twinrung_catalog::Element;
use twinrung_compiler::operand::SystemInstance;
use twinrung_compiler::project::{ProgramId, TagId};
use twinrung_contest::cells::{self, plain_bits, plain_words};
use twinrung_contest::fuzz::{Contest, Ended, Evaluators, Executions, Subject, SystemSample, system_samples};
use twinrung_contest::generate::Random;
use twinrung_contest::{Signal, Value, names};
use twinrung_judge::Judge;
use twinrung_partner::Partner;
use twinrung_primary::Primary;

use crate::disagreement::Disagreement;
use crate::library::library;

/// Three evaluators of one subject.
pub struct Trio<'s> {
    pub(crate) subject: &'s Subject,
    pub(crate) primary: Primary,
    pub(crate) partner: Partner,
    pub(crate) judge: Judge<'s>,
    pub(crate) tags: Vec<(TagId, CellRange)>,
    /// A second primary that reports what it does, where somebody counts.
    pub(crate) observed: Option<Primary>,
    /// What it reported.
    executions: Executions,
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
        Trio {
            primary: Primary::load(&subject.image).unwrap_or_else(|error| panic!("primary: {error}")),
            partner: Partner::load(&subject.image).unwrap_or_else(|error| panic!("partner: {error}")),
            subject,
            judge,
            tags,
            observed: None,
            executions: Executions::default(),
            system_values: vec![0; records.system_values_length()],
            scans: 0,
            budget: 10_000_000,
        }
    }

    /// Counts what is executed from here on: a second primary runs with an observer, and is compared with the first, which
    /// runs without.
    pub fn count_executions(&mut self) {
        let primary = Primary::load(&self.subject.image).unwrap_or_else(|error| panic!("primary: {error}"));
        self.observed = Some(primary);
        self.executions = Executions::new(self.subject);
    }

    /// What was executed since the counting began.
    pub fn executions(&self) -> &Executions {
        &self.executions
    }

    /// Sets one value in all three, by its full name.
    pub fn set(&mut self, name: &str, value: Value) {
        let signal = self.signal(name);
        self.set_signals(&[(signal, value)]);
    }

    /// What a full name stands for: to be looked up once.
    pub fn signal(&self, name: &str) -> Signal {
        names::signal(&self.subject.image, name).unwrap_or_else(|error| panic!("{error}"))
    }

    /// Sets values in all three.
    pub fn set_signals(&mut self, values: &[(Signal, Value)]) {
        let mut moved = Vec::with_capacity(values.len());
        for (signal, value) in values {
            match (*signal, *value) {
                (Signal::Bit(cell), value) => self.write_bit(cell, value.is_true()),
                (Signal::Word(cell, Element::Real), Value::Real(value)) => self.write(cell, value.to_bits() as i32),
                (Signal::Word(cell, _), Value::Integer(value)) => self.write(cell, value),
                (signal, value) => panic!("{value:?} is no value of {signal:?}"),
            }
            moved.push(*signal);
        }
        self.copy_to_judge(&moved);
    }

    fn write(&mut self, cell: WordCell, value: i32) {
        self.primary.set_word(cell, value);
        self.partner.set_word(cell, value);
        if let Some(observed) = &mut self.observed {
            observed.set_word(cell, value);
        }
    }

    fn write_bit(&mut self, cell: BitCell, value: bool) {
        self.primary.set_bit(cell, value);
        self.partner.set_bit(cell, value);
        if let Some(observed) = &mut self.observed {
            observed.set_bit(cell, value);
        }
    }

    /// Every single value of every tag, with its full name.
    pub fn signals(&self) -> Vec<(String, Signal)> {
        let values = |(_, range): &(TagId, CellRange)| names::values_of(&self.subject.image, range.tag);
        self.tags.iter().flat_map(values).collect()
    }

    /// Sets a bit cell in all three.
    pub fn set_bit(&mut self, cell: BitCell, value: bool) {
        self.write_bit(cell, value);
        self.copy_to_judge(&[Signal::Bit(cell)]);
    }

    /// Sets a word cell in all three.
    pub fn set_word(&mut self, cell: WordCell, value: i32) {
        self.write(cell, value);
        self.copy_to_judge(&[Signal::Word(cell, Element::Dint)]);
    }

    /// Gives the judge the tags in which values were set, each once.
    fn copy_to_judge(&mut self, moved: &[Signal]) {
        let mut positions: Vec<usize> = moved.iter().filter_map(|signal| self.tag_of(*signal)).collect();
        positions.sort_unstable();
        positions.dedup();
        for position in positions {
            let (tag, range) = &self.tags[position];
            self.judge.set_tag(*tag, &plain_bits(&self.primary, range), &plain_words(&self.primary, range));
        }
    }

    fn tag_of(&self, signal: Signal) -> Option<usize> {
        let holds = |range: &CellRange| match signal {
            Signal::Bit(cell) => (range.bit_cell..range.bit_cell + range.bit_cells).contains(&cell.0),
            Signal::Word(cell, _) | Signal::WordBit(cell, _) => {
                (range.word_cell..range.word_cell + range.word_cells).contains(&cell.0)
            }
            _ => false,
        };
        self.tags.iter().position(|(_, range)| holds(range))
    }

    /// Sets what GSV reads in all three, to any values that the attributes' types hold.
    pub fn set_system_values(&mut self, random: &mut Random) {
        for SystemSample { attribute, record, values } in system_samples(&self.subject.image, random) {
            let first = record.first as usize;
            self.system_values[first..first + values.len()].copy_from_slice(&values);
            let instance = match attribute.class {
                "TASK" => SystemInstance::Task,
                "PROGRAM" => SystemInstance::Program(self.program_id(record.instance)),
                "ROUTINE" => SystemInstance::Routine(self.subject.routines[record.instance as usize]),
                _ => SystemInstance::Controller,
            };
            self.judge.set_system_value(attribute.number, instance, values);
        }
    }

    /// The program of the project that has this number in the image.
    fn program_id(&self, number: u32) -> ProgramId {
        let at = numbers_of_programs(self.subject).iter().position(|one| *one == number);
        ProgramId(at.unwrap_or_default() as u16)
    }

    /// A value, by its full name.
    pub fn value(&self, name: &str) -> Value {
        let signal = self.signal(name);
        let held = cells::read(&self.primary, signal);
        match signal {
            Signal::Word(_, Element::Real) => Value::Real(f32::from_bits(held as u32)),
            Signal::Word(..) => Value::Integer(held),
            _ => Value::Bool(held == 1),
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
    pub fn status(&self) -> Status {
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
        if let Some(observed) = &mut self.observed {
            observed.prescan(inputs, &mut self.executions);
        }
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
        if let Some(observed) = &mut self.observed {
            observed.scan(inputs, &mut self.executions);
        }
        let judged = self.judge.scan(now_ms, self.budget);
        self.scans += 1;
        self.compare(Some(self.scans - 1), ends, judged)
    }
}

/// The contest of primary, partner and judge.
#[derive(Debug, Clone, Copy)]
pub struct Trios;

impl Contest for Trios {
    type Evaluators<'s> = Trio<'s>;

    fn load(subject: &Subject, budget: u64) -> Trio<'_> {
        let mut trio = Trio::new(subject);
        trio.budget = budget;
        trio.count_executions();
        trio
    }
}

impl Evaluators for Trio<'_> {
    fn set(&mut self, values: &[(Signal, Value)]) {
        self.executions.set(values);
        self.set_signals(values);
    }

    fn set_system_values(&mut self, random: &mut Random) {
        Trio::set_system_values(self, random);
    }

    fn prescan(&mut self, now_ms: i64) -> Result<Ended, String> {
        Trio::prescan(self, now_ms).map_err(|disagreement| disagreement.to_string())
    }

    fn scan(&mut self, now_ms: i64) -> Result<Ended, String> {
        Trio::scan(self, now_ms).map_err(|disagreement| disagreement.to_string())
    }

    fn executed(&self) -> u64 {
        Trio::executed(self)
    }

    fn cleared_faults(&self) -> u64 {
        u64::from(self.status().cleared_faults)
    }

    fn executions(&self) -> &Executions {
        Trio::executions(self)
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
