//! Decodes the code of one routine for one call into steps, and hands rungs that have no surprises to the panels.

use alloc::collections::BTreeMap;
use alloc::vec::Vec;

use twinrung_bytecode::index::{OperandIndex, RoutineIndex};
use twinrung_catalog::{Group, Opcode};

use super::code::{Item, Operands, item};
use super::context::{Context, Instance};
use super::cursor::Cursor;
use super::{Job, LoadError, Loader};
use crate::ladder::{Argument, Code, Jump, Location, NONE, Step, Subroutine};
use crate::panel::lower::{Tables, Verdict};

/// A JMP whose target is not known yet.
struct Pending {
    jump: u32,
    /// The rung that holds its label.
    rung: Option<u32>,
}

/// What one body collects while it is decoded.
#[derive(Default)]
struct Progress {
    /// The rung of each label, by its name in lower case.
    labels: BTreeMap<Vec<u8>, u32>,
    /// First step of each rung.
    starts: Vec<u32>,
    /// JMPs to be patched.
    pending: Vec<Pending>,
    /// The open region's step.
    region: Option<usize>,
}

impl<'a> Loader<'a> {
    /// Decodes a body.
    pub(crate) fn body(&mut self, job: &Job) -> Result<(), LoadError> {
        let broken = LoadError::Routine(job.routine);
        let unit = self.unit(job.context.library).ok_or_else(|| broken.clone())?;
        let code: &'a [u8] = &unit.image.routines.get(job.routine.position()).ok_or_else(|| broken.clone())?.code;
        let begin = self.steps.len() as u32;
        let counter = self.counters;
        let mut progress = Progress { labels: self.labels(job, code), ..Progress::default() };
        let mut cursor = Cursor::new(code);
        let mut rung = Vec::new();
        while !cursor.is_empty() {
            rung.clear();
            let number = progress.starts.len() as u32;
            let labelled =
                self.rung(job, number, &mut cursor, &mut rung, &mut progress)?.ok_or_else(|| broken.clone())?;
            self.place_rung(job, number, &rung, labelled, &mut progress);
        }
        self.close_region(&mut progress);
        self.steps.push(Step { code: Code::End, count: 0, element: 0, first: progress.starts.len() as u32 });
        if let Some(body) = self.bodies.get_mut(job.body.0 as usize) {
            body.begin = begin;
            body.counter = counter;
            body.counters = self.counters.wrapping_sub(counter);
        }
        for pending in progress.pending {
            let target = pending.rung.and_then(|rung| progress.starts.get(rung as usize)).copied().unwrap_or(NONE);
            if let Some(jump) = self.jumps.get_mut(pending.jump as usize) {
                jump.target = target;
            }
        }
        Ok(())
    }

    fn labels(&self, job: &Job, code: &'a [u8]) -> BTreeMap<Vec<u8>, u32> {
        let mut labels = BTreeMap::new();
        let mut cursor = Cursor::new(code);
        let mut rung = 0u32;
        while let Some(item) = item(&mut cursor) {
            match item {
                Item::EndRung => rung = rung.wrapping_add(1),
                Item::Instruction(Opcode::Lbl, operands) => {
                    let text = operands.get(0).and_then(|operand| self.text(job.context.library, operand));
                    labels.extend(text.map(|text| (text.to_ascii_lowercase(), rung)));
                }
                _ => {}
            }
        }
        labels
    }

    /// Appends a rung's steps, through the open region where that can take it.
    fn place_rung(&mut self, job: &Job, number: u32, rung: &[Step], labelled: bool, progress: &mut Progress) {
        if labelled {
            self.close_region(progress);
        }
        let zone = job.context.instance == Instance::None
            && self.zones.get(job.context.program.position()).copied().unwrap_or(false);
        let begin = self.steps.len();
        let mut verdict = self.lower(rung, zone);
        if verdict == Verdict::Conflict {
            self.close_region(progress);
            verdict = self.lower(rung, zone);
        }
        let accepted = verdict == Verdict::Accepted;
        if !accepted {
            self.close_region(progress);
        }
        progress.starts.push(begin as u32);
        if accepted && progress.region.is_none() {
            progress.region = Some(begin);
            self.steps.push(Step { code: Code::Region, count: 0, element: 0, first: NONE });
        }
        self.steps.push(Step { code: Code::Rung, count: 0, element: 0, first: number });
        self.steps.extend_from_slice(rung);
    }

    fn lower(&mut self, rung: &[Step], zone: bool) -> Verdict {
        let mut tables = Tables {
            arguments: &self.arguments,
            operations: &self.operations,
            expressions: &self.expressions,
            spans: &self.spans,
            own: self.own,
            bits: &mut self.initial_bits,
            words: &mut self.initial_words,
            constants: &mut self.constants,
        };
        self.lowering.rung(&mut tables, rung, zone)
    }

    fn close_region(&mut self, progress: &mut Progress) {
        let Some(position) = progress.region.take() else { return };
        let end = self.steps.len() as u32;
        let region = self.lowering.close(end, self.initial_bits.len());
        if let Some(step) = self.steps.get_mut(position) {
            step.first = region;
        }
    }

    /// Decodes a rung into steps; whether it begins with a label, or `None` where the code is malformed.
    fn rung(
        &mut self,
        job: &Job,
        number: u32,
        cursor: &mut Cursor<'a>,
        rung: &mut Vec<Step>,
        progress: &mut Progress,
    ) -> Result<Option<bool>, LoadError> {
        if item(cursor) != Some(Item::Rung) {
            return Ok(None);
        }
        let mut element = 0u16;
        let mut labelled = false;
        loop {
            let mark = |code| Step { code, count: 0, element: 0, first: 0 };
            let step = match item(cursor) {
                None | Some(Item::Rung) => return Ok(None),
                Some(Item::EndRung) => return Ok(Some(labelled)),
                Some(Item::Branch) => mark(Code::Branch),
                Some(Item::NextLeg) => mark(Code::NextLeg),
                Some(Item::EndBranch) => mark(Code::EndBranch),
                Some(Item::AddOn(operands)) => {
                    let call = self.add_on_call(&job.context, operands, job.routine)?;
                    Step { code: Code::AddOn, count: 0, element, first: call }
                }
                Some(Item::Instruction(opcode, operands)) => {
                    labelled |= opcode == Opcode::Lbl;
                    self.instruction(job, number, element, opcode, operands, progress)?
                }
            };
            if !matches!(step.code, Code::Branch | Code::NextLeg | Code::EndBranch) {
                element = element.saturating_add(1);
            }
            rung.push(step);
        }
    }

    fn instruction(
        &mut self,
        job: &Job,
        rung: u32,
        element: u16,
        opcode: Opcode,
        operands: Operands<'a>,
        progress: &mut Progress,
    ) -> Result<Step, LoadError> {
        let context = &job.context;
        let broken = LoadError::Routine(job.routine);
        let at = |index: usize| operands.get(index).ok_or_else(|| broken.clone());
        if opcode.instruction().group.is_safety_library() {
            let call = self.safety_call(context, opcode, operands, job.routine)?;
            return Ok(Step { code: Code::Safety, count: 0, element, first: call });
        }
        let code = Code::Instruction(opcode);
        let mut arguments = Vec::with_capacity(operands.len());
        match opcode {
            Opcode::Lbl | Opcode::Sbr => {}
            Opcode::Jmp => {
                let label = self.text(context.library, at(0)?);
                let target = label.and_then(|label| progress.labels.get(&label.to_ascii_lowercase()).copied());
                let counter = match target {
                    Some(target) if target <= rung => {
                        let next = self.counters;
                        self.counters = next.wrapping_add(1);
                        next
                    }
                    _ => NONE,
                };
                let jump = self.jumps.len() as u32;
                self.jumps.push(Jump { target: NONE, rung: target.unwrap_or(NONE), counter });
                progress.pending.push(Pending { jump, rung: target });
                return Ok(Step { code, count: 0, element, first: jump });
            }
            Opcode::Jsr => {
                let first = self.subroutine(context, operands, job.routine)?;
                return Ok(Step { code, count: 0, element, first });
            }
            Opcode::Ret => {
                for operand in operands.iter() {
                    arguments.push(self.span(context, operand, true)?);
                }
            }
            Opcode::Cop => {
                arguments.push(self.span(context, at(0)?, false)?);
                arguments.push(self.span(context, at(1)?, false)?);
                arguments.push(self.argument(context, at(2)?)?);
            }
            Opcode::Fll => {
                arguments.push(self.argument(context, at(0)?)?);
                arguments.push(self.span(context, at(1)?, false)?);
                arguments.push(self.argument(context, at(2)?)?);
            }
            Opcode::Size => {
                let Argument::Integer(number) = self.argument(context, at(1)?)? else { return Err(broken) };
                let length = self.dimension(context, at(0)?, number)?;
                arguments.push(Argument::Integer(length));
                arguments.push(self.argument(context, at(2)?)?);
            }
            Opcode::Gsv | Opcode::Ssv => {
                arguments.push(self.argument(context, at(2)?)?);
                arguments.push(self.span(context, at(3)?, false)?);
            }
            Opcode::Cmp => arguments.push(self.expression(context, at(0)?, false)?),
            Opcode::Cpt => {
                let destination = self.argument(context, at(0)?)?;
                arguments.push(destination);
                let real = self.is_real_destination(destination);
                arguments.push(self.expression(context, at(1)?, real)?);
            }
            Opcode::Fal => {
                arguments.push(self.argument(context, at(0)?)?);
                arguments.push(self.argument(context, at(3)?)?);
                let destination = self.argument(context, at(4)?)?;
                arguments.push(destination);
                let real = self.is_real_destination(destination);
                arguments.push(self.expression(context, at(5)?, real)?);
            }
            Opcode::Fsc => {
                arguments.push(self.argument(context, at(0)?)?);
                arguments.push(self.argument(context, at(3)?)?);
                arguments.push(self.expression(context, at(4)?, false)?);
            }
            _ if opcode.instruction().group == Group::TimerCounter => {
                let structure = self.argument(context, at(0)?)?;
                arguments.push(structure);
                if context.library && opcode != Opcode::Res {
                    self.preset(context, structure, at(1)?, 0)?;
                    self.preset(context, structure, at(2)?, 1)?;
                }
            }
            _ => {
                for operand in operands.iter() {
                    arguments.push(self.argument(context, operand)?);
                }
            }
        }
        let first = self.arguments.len() as u32;
        let count = arguments.len() as u8;
        self.arguments.append(&mut arguments);
        Ok(Step { code, count, element, first })
    }

    /// In the library, whose instances have no tags, a literal Preset or Accum is the member's initial value.
    fn preset(
        &mut self,
        context: &Context,
        structure: Argument,
        operand: OperandIndex,
        member: u32,
    ) -> Result<(), LoadError> {
        let value = self.argument(context, operand)?;
        if let (Argument::At(Location::Region { word, .. }), Argument::Integer(value)) = (structure, value) {
            let cell = word.wrapping_add(member) as usize;
            if let Some(initial) = self.initial_words.get_mut(cell) {
                *initial = value;
            }
        }
        Ok(())
    }

    fn is_real_destination(&self, destination: Argument) -> bool {
        let location = match destination {
            Argument::At(location) => Some(location),
            Argument::Dynamic(index) => self.dynamics.get(index as usize).map(|dynamic| dynamic.location),
            _ => None,
        };
        matches!(location, Some(Location::Word(_, twinrung_catalog::Element::Real)))
    }

    fn subroutine(
        &mut self,
        context: &Context,
        operands: Operands<'a>,
        routine: RoutineIndex,
    ) -> Result<u32, LoadError> {
        let broken = LoadError::Routine(routine);
        let at = |index: usize| operands.get(index).ok_or_else(|| broken.clone());
        let Argument::Integer(target) = self.argument(context, at(0)?)? else { return Err(broken) };
        let target = RoutineIndex(target as u32);
        let count = match operands.get(1) {
            Some(operand) => self.argument(context, operand)?,
            None => Argument::Integer(0),
        };
        let Argument::Integer(count) = count else { return Err(broken) };
        let count = usize::try_from(count).unwrap_or(0);
        let (mut inputs, mut returns) = (Vec::new(), Vec::new());
        for (index, operand) in operands.iter().skip(2).enumerate() {
            let argument = self.span(context, operand, true)?;
            if index < count { inputs.push(argument) } else { returns.push(argument) }
        }
        let mut receivers = Vec::new();
        for operand in self.receivers(target) {
            receivers.push(self.span(context, operand, true)?);
        }
        let fault = self.application.image.programs.get(context.program.position()).and_then(|program| program.fault);
        let body = self.routine_body(context.program, target).ok_or(broken)?;
        self.subroutines.push(Subroutine { body, inputs, receivers, returns, fault_routine: fault == Some(target) });
        Ok(self.subroutines.len().wrapping_sub(1) as u32)
    }

    /// The operands of the SBR that begins a routine.
    fn receivers(&self, routine: RoutineIndex) -> Vec<OperandIndex> {
        let Some(record) = self.application.image.routines.get(routine.position()) else { return Vec::new() };
        let mut cursor = Cursor::new(&record.code);
        match (item(&mut cursor), item(&mut cursor)) {
            (Some(Item::Rung), Some(Item::Instruction(Opcode::Sbr, operands))) => operands.iter().collect(),
            _ => Vec::new(),
        }
    }
}
