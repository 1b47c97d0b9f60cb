//! The evaluator: programs, routines, rungs, faults.

use std::collections::{HashMap, HashSet};

use twinrung_compiler::CheckedProject;
use twinrung_compiler::operand::{Operand, SystemInstance};
use twinrung_compiler::project::rung::Branch;
use twinrung_compiler::project::{Call, Element, Instruction, OperandUse, Project, RoutineId, Rung, TagId};

use crate::memory::{Base, Frame, Memory, Target};
use crate::value::Value;

/// The status flags and counts that drive logic or are compared.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Flags {
    /// S:FS
    pub first_scan: bool,
    /// S:V
    pub overflow: bool,
    /// S:Z
    pub zero: bool,
    /// S:N
    pub negative: bool,
    /// S:C
    pub carry: bool,
    /// S:MINOR
    pub minor_fault: bool,
    /// Minor faults since the last prescan.
    pub minor_faults: u32,
    /// Instructions executed.
    pub executed: u64,
    /// Recoverable faults cleared since the last prescan.
    pub cleared_faults: u32,
}

/// A major fault that ended a scan, in numbers of the checked project.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Fault {
    /// The code of type 4.
    pub code: u16,
    /// Program, routine, rung and element.
    pub place: [u32; 4],
}

/// How an execution ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum End {
    /// All programs ran.
    Completed,
    /// A fault that nothing cleared.
    MajorFault(Fault),
    /// More instructions than the budget.
    BudgetExceeded,
}

/// Why a rung or a routine is left.
#[derive(Debug, Clone)]
pub(crate) enum Exit {
    /// A fault of the instruction at hand.
    Fault(u16),
    /// The execution ends.
    Stop(End),
    /// The routine goes on at this rung.
    Jump(usize),
    /// The routine ends, with what RET hands back.
    Return(Vec<Value>),
}

/// What is being executed for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Pass {
    Prescan,
    Scan,
}

/// The third evaluator.
pub struct Judge<'p> {
    pub(crate) project: &'p Project,
    pub(crate) library: &'p Project,
    pub(crate) memory: Memory,
    pub(crate) flags: Flags,
    pub(crate) now_ms: i64,
    pub(crate) prescan_ms: i64,
    pub(crate) pass: Pass,
    pub(crate) system_values: HashMap<(u8, SystemInstance), Vec<i32>>,
    pub(crate) events: HashMap<String, u32>,
    pub(crate) records: Vec<[i32; 11]>,
    pub(crate) override_zone: bool,
    pub(crate) budget_end: u64,
    pub(crate) backward_jumps: HashMap<(u32, u32), u32>,
    pub(crate) prescanned: HashSet<(u16, u32)>,
    /// CONTROL structures whose run was completed on a false rung.
    pub(crate) completed_on_false: HashSet<Target>,
    pub(crate) library_instances: HashMap<Target, usize>,
    /// Of them, those that a prescan has reached.
    pub(crate) library_prescanned: HashSet<Target>,
    /// Numbers of programs and routines in fault records.
    numbers: (Vec<u32>, Vec<u32>),
    /// Whether something has overflowed since a subscript began to be computed.
    pub(crate) subscript_overflow: bool,
    /// Whether the next scan is the first after a prescan.
    first_scan_armed: bool,
    faulted: bool,
    in_fault_routine: bool,
}

/// Bit and word values of a tag.
type Cells = (Vec<u8>, Vec<i32>);

impl<'p> Judge<'p> {
    /// A judge over a checked project and the ladder half of the safety library. Every tag is 0 until it is set.
    pub fn new(project: &'p CheckedProject, library: &'p CheckedProject) -> Judge<'p> {
        let mut memory = Memory::default();
        for (index, tag) in project.tags.iter().enumerate() {
            if let (false, Some(type_reference)) = (tag.is_alias(), tag.type_reference) {
                memory.tags.insert(TagId(index as u32), Value::zero(&project.types, type_reference, tag.dimensions));
            }
        }
        Judge {
            project,
            library,
            memory,
            flags: Flags::default(),
            now_ms: 0,
            prescan_ms: 0,
            pass: Pass::Prescan,
            system_values: HashMap::new(),
            events: HashMap::new(),
            records: vec![[0; 11]; project.programs.len()],
            override_zone: false,
            budget_end: u64::MAX,
            backward_jumps: HashMap::new(),
            prescanned: HashSet::new(),
            completed_on_false: HashSet::new(),
            library_instances: HashMap::new(),
            library_prescanned: HashSet::new(),
            numbers: (Vec::new(), Vec::new()),
            subscript_overflow: false,
            first_scan_armed: false,
            faulted: false,
            in_fault_routine: false,
        }
    }

    /// Sets a whole tag from the cells of an image, in the order in which cells are assigned.
    pub fn set_tag(&mut self, tag: TagId, bits: &[u8], words: &[i32]) {
        if let Some(value) = self.memory.tags.get_mut(&tag) {
            value.fill(&mut bits.iter().copied(), &mut words.iter().copied());
        }
    }

    /// A whole tag in the order in which cells are assigned; nothing for an alias or a standard tag.
    pub fn tag(&self, tag: TagId) -> Option<Cells> {
        let mut cells = (Vec::new(), Vec::new());
        self.memory.tags.get(&tag)?.flatten(&mut cells.0, &mut cells.1);
        Some(cells)
    }

    /// Whether a whole tag holds these cells, in the order in which cells are assigned; true for an alias or a standard tag.
    pub fn holds(&self, tag: TagId, bits: &[u8], words: &[i32]) -> bool {
        let value = self.memory.tags.get(&tag);
        value.is_none_or(|value| value.holds(&mut bits.iter().copied(), &mut words.iter().copied()))
    }

    /// Gives programs and routines the numbers that an image has for them: a fault record holds numbers.
    pub fn number_as(&mut self, programs: Vec<u32>, routines: Vec<u32>) {
        self.numbers = (programs, routines);
    }

    /// Sets the values that GSV reads of an attribute (its number in the catalog).
    pub fn set_system_value(&mut self, attribute: u8, instance: SystemInstance, values: Vec<i32>) {
        self.system_values.insert((attribute, instance), values);
    }

    /// The flags after the last execution.
    pub fn flags(&self) -> Flags {
        self.flags
    }

    /// The MajorFaultRecord of a program.
    pub fn fault_record(&self, program: usize) -> [i32; 11] {
        self.records[program]
    }

    /// How often EVENT triggered a task in the last scan.
    pub fn events(&self, task: &str) -> u32 {
        self.events.get(&task.to_ascii_lowercase()).copied().unwrap_or_default()
    }

    /// Program to Run: REQ-EXEC-024.
    pub fn prescan(&mut self, now_ms: i64, budget: u64) -> End {
        self.begin(Pass::Prescan, now_ms, budget);
        self.flags = Flags { executed: self.flags.executed, ..Flags::default() };
        self.records.fill([0; 11]);
        // Timers of the library forget with the prescan of their instruction.
        self.memory.last_time.retain(|timer, _| matches!(timer.base, Base::Library(_)));
        self.prescan_ms = now_ms;
        self.completed_on_false.clear();
        self.prescanned.clear();
        self.first_scan_armed = true;
        self.programs()
    }

    /// One execution of the safety task.
    pub fn scan(&mut self, now_ms: i64, budget: u64) -> End {
        let first_scan = std::mem::take(&mut self.first_scan_armed);
        self.begin(Pass::Scan, now_ms, budget);
        self.flags = Flags {
            first_scan,
            minor_fault: self.flags.minor_fault,
            minor_faults: self.flags.minor_faults,
            executed: self.flags.executed,
            cleared_faults: self.flags.cleared_faults,
            ..Flags::default()
        };
        self.programs()
    }

    fn begin(&mut self, pass: Pass, now_ms: i64, budget: u64) {
        self.pass = pass;
        self.now_ms = now_ms;
        self.budget_end = self.flags.executed.saturating_add(budget);
        self.events.clear();
        self.faulted = false;
        self.in_fault_routine = false;
    }

    fn programs(&mut self) -> End {
        let project = self.project;
        let task = project.safety_task.map(|index| &project.tasks[index]);
        for scheduled in task.iter().flat_map(|task| &task.schedule) {
            let Some(id) = scheduled.program else { continue };
            let program = &project.programs[id.position()];
            if program.disabled {
                continue;
            }
            self.override_zone = false;
            let routines = match self.pass {
                Pass::Prescan => [program.main, program.fault],
                Pass::Scan => [program.main, None],
            };
            for routine in routines.into_iter().flatten() {
                let frame = Frame {
                    project,
                    program: id.0,
                    routine: routine.0,
                    rung: 0,
                    element: 0,
                    instance: None,
                    counts: true,
                    in_add_on: false,
                    prescanning: self.pass == Pass::Prescan,
                };
                if self.pass == Pass::Prescan && !self.prescanned.insert((id.0, routine.0)) {
                    continue;
                }
                if let Err(Exit::Stop(end)) = self.routine(&frame, routine) {
                    return end;
                }
            }
        }
        if self.flags.executed > self.budget_end { End::BudgetExceeded } else { End::Completed }
    }

    /// Runs a routine; what RET hands back, when one ended it. It counts its backward jumps for itself (REQ-EXEC-016).
    pub(crate) fn routine(&mut self, caller: &Frame<'p>, id: RoutineId) -> Result<Option<Vec<Value>>, Exit> {
        let outer = std::mem::take(&mut self.backward_jumps);
        let ended = self.rungs(caller, id);
        self.backward_jumps = outer;
        ended
    }

    fn rungs(&mut self, caller: &Frame<'p>, id: RoutineId) -> Result<Option<Vec<Value>>, Exit> {
        let routine = caller.project.routine(id);
        let mut frame = Frame { routine: id.0, ..caller.clone() };
        let mut at = 0;
        while let Some(rung) = routine.rungs.get(at) {
            frame.rung = at as u32;
            at += 1;
            match self.rung(&mut frame, rung) {
                Ok(()) => {}
                Err(Exit::Jump(to)) => at = to,
                Err(Exit::Return(values)) => return Ok(Some(values)),
                Err(other) => return Err(other),
            }
        }
        Ok(None)
    }

    fn rung(&mut self, frame: &mut Frame<'p>, rung: &Rung) -> Result<(), Exit> {
        let zone = self.override_zone && !frame.in_add_on && !frame.prescanning;
        let condition = !frame.prescanning && !zone;
        let mut dead = false;
        self.series(frame, &rung.elements, condition, &mut dead).map(|_| ())
    }

    /// `dead`: a fault on this rung was cleared; what follows on the rung is false.
    fn series(
        &mut self,
        frame: &mut Frame<'p>,
        elements: &[Element],
        condition: bool,
        dead: &mut bool,
    ) -> Result<bool, Exit> {
        let mut condition = condition;
        for element in elements {
            condition = match element {
                Element::Instruction(instruction) => self.guarded(frame, instruction, condition, dead)?,
                Element::Branch(branch) => self.branch(frame, branch, condition, dead)?,
            };
        }
        Ok(condition)
    }

    fn branch(
        &mut self,
        frame: &mut Frame<'p>,
        branch: &Branch,
        condition: bool,
        dead: &mut bool,
    ) -> Result<bool, Exit> {
        let mut any = false;
        for leg in &branch.legs {
            any |= self.series(frame, leg, condition && !*dead, dead)?;
        }
        Ok(any && !*dead)
    }

    /// One instruction, with what happens when it faults.
    fn guarded(
        &mut self,
        frame: &mut Frame<'p>,
        instruction: &Instruction,
        condition: bool,
        dead: &mut bool,
    ) -> Result<bool, Exit> {
        frame.element = instruction.element;
        if frame.counts {
            self.flags.executed += 1;
        }
        let outcome = match instruction.call {
            Call::Catalog(declaration) => self.instruction(frame, declaration, &instruction.operands, condition),
            Call::AddOn(add_on) => self.add_on(frame, add_on, &instruction.operands, condition),
        };
        match outcome {
            Err(Exit::Fault(code)) => {
                self.fault(frame, code)?;
                *dead = true;
                Ok(false)
            }
            other => other.map(|out| out && !*dead),
        }
    }

    /// REQ-EXEC-050 to REQ-EXEC-052.
    fn fault(&mut self, frame: &Frame<'p>, code: u16) -> Result<(), Exit> {
        let program = usize::from(frame.program);
        let number = |numbers: &[u32], index: u32| numbers.get(index as usize).copied().unwrap_or(index);
        let place = [
            number(&self.numbers.0, u32::from(frame.program)),
            number(&self.numbers.1, frame.routine),
            frame.rung,
            frame.element,
        ];
        let record = &mut self.records[program];
        *record = [0; 11];
        record[0] = self.now_ms as i32;
        record[1] = (self.now_ms >> 32) as i32;
        record[2] = 4 | (i32::from(code) << 16);
        for (slot, number) in record[3..7].iter_mut().zip(place) {
            *slot = number as i32;
        }
        let stop = Exit::Stop(End::MajorFault(Fault { code, place }));
        let handler = self.project.programs[program].fault;
        let Some(handler) = handler.filter(|_| !self.faulted && !self.in_fault_routine && self.pass == Pass::Scan)
        else {
            return Err(stop);
        };
        self.faulted = true;
        self.in_fault_routine = true;
        let zone = std::mem::take(&mut self.override_zone);
        let frame = Frame { project: self.project, instance: None, in_add_on: false, counts: true, ..frame.clone() };
        self.routine(&frame, handler)?;
        self.override_zone = zone;
        self.in_fault_routine = false;
        if self.records[program][2] != 0 {
            return Err(stop);
        }
        self.flags.cleared_faults += 1;
        Ok(())
    }

    /// S:V becomes set; a change logs a minor fault 4/4.
    pub(crate) fn overflow(&mut self, frame: &Frame<'_>) {
        self.subscript_overflow = true;
        if frame.counts && !self.flags.overflow {
            self.flags.overflow = true;
            self.flags.minor_fault = true;
            self.flags.minor_faults += 1;
        }
    }

    /// What an instruction that affects the flags does first.
    pub(crate) fn clear_flags(&mut self, frame: &Frame<'_>) {
        if frame.counts {
            self.flags.overflow = false;
            self.flags.zero = false;
            self.flags.negative = false;
            self.flags.carry = false;
        }
    }

    pub(crate) fn operand<'a>(&self, frame: &Frame<'a>, operand: OperandUse) -> &'a Operand {
        frame.project.operand(operand.id)
    }

    pub(crate) fn target(&mut self, frame: &Frame<'_>, operand: OperandUse) -> Result<Target, Exit> {
        let reference = frame.project.operand(operand.id).reference();
        self.locate(frame, reference.unwrap_or_else(|| panic!("not a reference")))
    }

    /// The private instance of a library Add-On Instruction for a backing tag.
    pub(crate) fn library_instance(&mut self, backing: &Target, zero: impl FnOnce() -> Value) -> Target {
        let next = self.memory.library.len();
        let index = *self.library_instances.entry(backing.clone()).or_insert(next);
        if index == next {
            self.memory.library.push(zero());
        }
        Target { base: Base::Library(index), path: Vec::new(), bit: None }
    }
}
