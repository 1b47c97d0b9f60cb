//! Decodes an image into the program and lays out the banks. The only part of this channel that allocates.

pub(crate) mod body;
pub(crate) mod copy;
pub(crate) mod formula;
pub(crate) mod operand;
pub(crate) mod reader;

use alloc::collections::{BTreeMap, VecDeque};
use alloc::vec;
use alloc::vec::Vec;

use twinrung_bytecode::image::{Image, Owner};
use twinrung_bytecode::layout::TypeLayout;
use twinrung_bytecode::limits;
use twinrung_catalog::Opcode;
use twinrung_catalog::instructions::system::ATTRIBUTES;

use crate::error::LoadError;
use crate::lower;
use crate::program::{Body, Content, NONE, Program, ProgramEntry, Range, SystemValue};
use operand::Binding;

/// Name of the attribute that is a program's fault record.
const MAJOR_FAULT_RECORD: &str = "MajorFaultRecord";

/// What loading leaves: the program, and what the machine is made of.
pub(crate) struct Loaded {
    pub(crate) program: Program,
    /// Size of the bit bank, a power of two.
    pub(crate) bit_bank: usize,
    /// Constants behind the word cells of the image.
    pub(crate) constants: Vec<i32>,
    /// The instruction of each safety call's state.
    pub(crate) safety_states: Vec<Opcode>,
}

/// The state of loading.
pub(crate) struct Loader<'a> {
    pub(crate) image: &'a Image,
    pub(crate) layouts: &'a [TypeLayout],
    pub(crate) program: Program,
    /// Entries of the operand table that are decoded already.
    pub(crate) known_operands: Vec<u32>,
    /// The body of each routine that belongs to a program.
    bodies_of_routines: Vec<u32>,
    /// Bodies that are yet to be built.
    pending: VecDeque<Pending>,
    /// Field tables by content.
    pub(crate) known_fields: BTreeMap<Content, Range>,
    /// State of the safety library by backing tag.
    pub(crate) known_states: BTreeMap<(u32, u32), u32>,
    pub(crate) safety_states: Vec<Opcode>,
    /// Instructions of all bodies so far.
    pub(crate) expanded: usize,
}

struct Pending {
    body: u32,
    binding: Binding,
}

/// Decodes and lowers an image.
pub(crate) fn load(image: &Image, layouts: &[TypeLayout]) -> Result<Loaded, LoadError> {
    let mut loader = Loader {
        image,
        layouts,
        program: Program::default(),
        known_operands: vec![NONE; image.operands.len()],
        bodies_of_routines: vec![NONE; image.routines.len()],
        pending: VecDeque::new(),
        known_fields: BTreeMap::new(),
        known_states: BTreeMap::new(),
        safety_states: Vec::new(),
        expanded: 0,
    };
    loader.programs()?;
    loader.system_values()?;
    while let Some(Pending { body, binding }) = loader.pending.pop_front() {
        loader.build_body(body, &binding)?;
    }
    let Loader { mut program, safety_states, .. } = loader;
    program.bit_cells =
        u32::try_from(image.initial_bits.len()).map_err(|_| LoadError::TooLarge("the bit cells of the image"))?;
    program.word_cells =
        u32::try_from(image.initial_words.len()).map_err(|_| LoadError::TooLarge("the word cells of the image"))?;
    let banks = lower::lower(&mut program)?;
    Ok(Loaded { program, bit_bank: banks.bits, constants: banks.constants, safety_states })
}

impl Loader<'_> {
    fn programs(&mut self) -> Result<(), LoadError> {
        for record in &self.image.programs {
            let main = record.main.map_or(Ok(NONE), |routine| self.routine_body(routine.0))?;
            let fault = record.fault.map_or(Ok(NONE), |routine| self.routine_body(routine.0))?;
            self.program.programs.push(ProgramEntry { main, fault, disabled: record.disabled });
        }
        let schedule = self.image.task.as_ref().map(|task| task.schedule.as_slice()).unwrap_or_default();
        self.program.schedule = schedule.iter().map(|index| index.0).collect();
        Ok(())
    }

    fn system_values(&mut self) -> Result<(), LoadError> {
        for record in &self.image.system_values {
            let attribute = ATTRIBUTES
                .iter()
                .find(|attribute| attribute.number == record.attribute)
                .ok_or(LoadError::Malformed("the attribute of a system value"))?;
            let record_of = (attribute.name == MAJOR_FAULT_RECORD).then(|| {
                let instance = u16::try_from(record.instance).unwrap_or(u16::MAX);
                record.program.map_or(instance, |program| program.0)
            });
            self.program.system_values.push(SystemValue {
                record_of,
                first: record.first,
                length: attribute.length,
                element_bytes: attribute.element.bytes(),
            });
        }
        Ok(())
    }

    /// The body of a routine that belongs to a program.
    pub(crate) fn routine_body(&mut self, routine: u32) -> Result<u32, LoadError> {
        const MALFORMED: LoadError = LoadError::Malformed("the index of a routine");
        let known = *self.bodies_of_routines.get(routine as usize).ok_or(MALFORMED)?;
        if known != NONE {
            return Ok(known);
        }
        let record = self.image.routines.get(routine as usize).ok_or(MALFORMED)?;
        if !matches!(record.owner, Owner::Program(_)) {
            return Err(LoadError::Malformed("a JSR into an Add-On Instruction"));
        }
        let body = self.new_body(routine, Binding::default(), true, true)?;
        if let Some(slot) = self.bodies_of_routines.get_mut(routine as usize) {
            *slot = body;
        }
        Ok(body)
    }

    /// A body that is built later.
    pub(crate) fn new_body(
        &mut self,
        routine: u32,
        binding: Binding,
        of_program: bool,
        stepped: bool,
    ) -> Result<u32, LoadError> {
        if self.program.bodies.len() >= limits::EXPANDED_INSTRUCTIONS {
            return Err(LoadError::TooLarge("the bodies of Add-On Instructions"));
        }
        let body = self.program.bodies.len() as u32;
        self.program.bodies.push(Body {
            routine,
            codes: Range::default(),
            steps: Range::default(),
            of_program,
            stepped,
            parameters: NONE,
            jumps: Range::default(),
        });
        self.pending.push_back(Pending { body, binding });
        Ok(body)
    }
}
