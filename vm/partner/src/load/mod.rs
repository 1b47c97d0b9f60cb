//! Turns an admitted image into the channel's own form. The only part that allocates.

mod access;
mod body;
mod call;
mod code;
mod context;
mod cursor;
mod error;
mod library;
mod operand;
mod safety;

use alloc::collections::{BTreeMap, VecDeque};
use alloc::rc::Rc;
use alloc::vec;
use alloc::vec::Vec;

use twinrung_bytecode::image::Image;
use twinrung_bytecode::index::{ProgramIndex, RoutineIndex};
use twinrung_bytecode::layout::TypeLayout;
use twinrung_catalog::instructions::system::ATTRIBUTES;

pub(crate) use code::needs_library;
pub use error::LoadError;
pub(crate) use library::Library;
pub(crate) use operand::{ADDRESSES, VALUES};

use crate::ladder::{
    Argument, Body, BodyIndex, Call, Dynamic, Expression, Field, Jump, Ladder, NONE, Operation, OwnCells, Program,
    Span, Step, Subroutine, SystemValue,
};
use crate::memory::Size;
use crate::panel::lower::Lowering;
use context::{Context, Instance};

/// An image and the layouts of its types.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Unit<'a> {
    /// The records.
    pub(crate) image: &'a Image,
    /// The layouts.
    pub(crate) layouts: &'a [TypeLayout],
}

/// A body that is still to be decoded.
pub(crate) struct Job {
    body: BodyIndex,
    routine: RoutineIndex,
    context: Rc<Context>,
}

/// Everything that loading collects.
pub(crate) struct Loader<'a> {
    application: Unit<'a>,
    library: Option<Unit<'a>>,
    own: OwnCells,
    initial_bits: Vec<bool>,
    initial_words: Vec<i32>,
    constants: BTreeMap<i32, u32>,
    steps: Vec<Step>,
    arguments: Vec<Argument>,
    dynamics: Vec<Dynamic>,
    spans: Vec<Span>,
    fields: Vec<Field>,
    known_fields: BTreeMap<(bool, bool, u16), (u32, u32)>,
    operations: Vec<Operation>,
    expressions: Vec<Expression>,
    bodies: Vec<Body>,
    calls: Vec<Call>,
    jumps: Vec<Jump>,
    /// Counters of backward jumps so far.
    counters: u32,
    subroutines: Vec<Subroutine>,
    /// The body of each routine of a program.
    routine_bodies: Vec<Option<BodyIndex>>,
    /// For each program whether an MCR stands in it.
    zones: Vec<bool>,
    jobs: VecDeque<Job>,
    lowering: Lowering,
}

/// Loads an application; `library` is the ladder of the safety application instructions.
pub(crate) fn load(application: Unit<'_>, library: Option<Unit<'_>>) -> Result<(Ladder, Size), LoadError> {
    let image = application.image;
    let mut loader = Loader {
        application,
        library,
        own: OwnCells::default(),
        initial_bits: image.initial_bits.iter().map(|bit| *bit != 0).collect(),
        initial_words: image.initial_words.clone(),
        constants: BTreeMap::new(),
        steps: Vec::new(),
        arguments: Vec::new(),
        dynamics: Vec::new(),
        spans: Vec::new(),
        fields: Vec::new(),
        known_fields: BTreeMap::new(),
        operations: Vec::new(),
        expressions: Vec::new(),
        bodies: Vec::new(),
        calls: Vec::new(),
        jumps: Vec::new(),
        counters: 0,
        subroutines: Vec::new(),
        routine_bodies: vec![None; image.routines.len()],
        zones: code::zones(image),
        jobs: VecDeque::new(),
        lowering: Lowering::default(),
    };
    loader.own = OwnCells {
        true_bit: loader.private_bit(true),
        false_bit: loader.private_bit(false),
        override_bit: loader.private_bit(false),
        first_scan_bit: loader.private_bit(false),
    };
    let programs = loader.programs();
    while let Some(job) = loader.jobs.pop_front() {
        loader.body(&job)?;
    }
    loader.finish(programs)
}

impl<'a> Loader<'a> {
    fn unit(&self, library: bool) -> Option<Unit<'a>> {
        if library { self.library } else { Some(self.application) }
    }

    /// A bit cell of the channel's own.
    pub(crate) fn private_bit(&mut self, value: bool) -> u32 {
        self.initial_bits.push(value);
        self.initial_bits.len().wrapping_sub(1) as u32
    }

    fn programs(&mut self) -> Vec<Program> {
        let mut programs = Vec::new();
        for (index, record) in self.application.image.programs.iter().enumerate() {
            let program = ProgramIndex(index as u16);
            let main = record.main.and_then(|routine| self.routine_body(program, routine));
            let fault = record.fault.and_then(|routine| self.routine_body(program, routine));
            programs.push(Program { main, fault, disabled: record.disabled });
        }
        programs
    }

    /// The body of a routine of a program, decoded once.
    fn routine_body(&mut self, program: ProgramIndex, routine: RoutineIndex) -> Option<BodyIndex> {
        if let Some(known) = self.routine_bodies.get(routine.position())? {
            return Some(*known);
        }
        let context = Context { library: false, program, instance: Instance::None, in_outs: Vec::new() };
        let body = self.queue(routine, Rc::new(context));
        if let Some(known) = self.routine_bodies.get_mut(routine.position()) {
            *known = Some(body);
        }
        Some(body)
    }

    /// A new body, to be decoded later.
    fn queue(&mut self, routine: RoutineIndex, context: Rc<Context>) -> BodyIndex {
        let body = BodyIndex(self.bodies.len() as u32);
        let add_on = context.instance != Instance::None;
        self.bodies.push(Body { routine, begin: NONE, add_on, counter: 0, counters: 0 });
        self.jobs.push_back(Job { body, routine, context });
        body
    }

    fn finish(self, programs: Vec<Program>) -> Result<(Ladder, Size), LoadError> {
        let image = self.application.image;
        let cells = self.initial_bits.len().max(self.initial_words.len());
        let size = Size::holding(cells).ok_or(LoadError::Cells(cells))?;
        let system_values = image
            .system_values
            .iter()
            .map(|record| {
                let attribute = ATTRIBUTES.iter().find(|attribute| attribute.number == record.attribute);
                let is_record = attribute.is_some_and(|attribute| attribute.name == "MajorFaultRecord");
                SystemValue {
                    first: record.first,
                    length: attribute.map_or(0, |attribute| attribute.length),
                    width: attribute.map_or(0, |attribute| attribute.element.bytes()),
                    record_of: record.program.filter(|_| is_record),
                }
            })
            .collect();
        let ladder = Ladder {
            steps: self.steps,
            arguments: self.arguments,
            dynamics: self.dynamics,
            spans: self.spans,
            fields: self.fields,
            operations: self.operations,
            expressions: self.expressions,
            bodies: self.bodies,
            calls: self.calls,
            jumps: self.jumps,
            counters: self.counters,
            subroutines: self.subroutines,
            system_values,
            programs,
            schedule: image.task.as_ref().map(|task| task.schedule.clone()).unwrap_or_default(),
            panels: self.lowering.finish(size),
            own: self.own,
            initial_bits: self.initial_bits,
            initial_words: self.initial_words,
        };
        Ok((ladder, size))
    }
}
