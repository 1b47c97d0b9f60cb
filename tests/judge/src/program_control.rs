//! JMP, JSR, RET, TND, MCR, EVENT, GSV, SSV, and calls of Add-On Instructions. general-instructions.md A.8 and A.10.

use std::collections::HashMap;

use twinrung_bytecode::image::Usage;
use twinrung_bytecode::limits;
use twinrung_catalog::{Element as Elementary, Opcode};
use twinrung_compiler::operand::{Operand, SystemInstance};
use twinrung_compiler::project::rung::Branch;
use twinrung_compiler::project::{AddOnId, Element, Instruction, OperandUse, RoutineId, Rung};

use crate::arithmetic::Number;
use crate::evaluator::{End, Exit, Judge};
use crate::memory::{Frame, Instance, Target};
use crate::value::Value;

/// The program attribute that is the channel's own.
const MAJOR_FAULT_RECORD: &str = "MajorFaultRecord";

impl<'p> Judge<'p> {
    pub(crate) fn program_control(
        &mut self,
        frame: &Frame<'p>,
        opcode: Opcode,
        operands: &[OperandUse],
        condition: bool,
    ) -> Result<(), Exit> {
        if frame.prescanning {
            return match opcode {
                Opcode::Jsr => self.prescan_subroutine(frame, operands),
                _ => Ok(()),
            };
        }
        match (opcode, condition) {
            (Opcode::Mcr, false) => self.override_zone = !self.override_zone,
            (Opcode::Jmp, true) => return Err(self.jump(frame, operands)?),
            (Opcode::Tnd, true) => return Err(Exit::Return(Vec::new())),
            (Opcode::Ret, true) => {
                let mut values = Vec::with_capacity(operands.len());
                for operand in operands {
                    values.push(self.passed(frame, *operand)?);
                }
                return Err(Exit::Return(values));
            }
            (Opcode::Jsr, true) => return self.subroutine(frame, operands),
            (Opcode::Event, true) => {
                if let Operand::EventTask(task) = self.operand(frame, operands[0]) {
                    *self.events.entry(task.to_ascii_lowercase().to_string()).or_default() += 1;
                }
            }
            (Opcode::Gsv | Opcode::Ssv, true) => return self.system_value(frame, opcode, operands),
            _ => {}
        }
        Ok(())
    }

    fn jump(&mut self, frame: &Frame<'p>, operands: &[OperandUse]) -> Result<Exit, Exit> {
        let Operand::Text(label) = self.operand(frame, operands[0]) else { panic!("no label") };
        let rungs = &frame.project.routine(RoutineId(frame.routine)).rungs;
        let to = rungs.iter().position(|rung| defines(frame, rung, label)).ok_or(Exit::Fault(42))?;
        if to <= frame.rung as usize {
            let taken = self.backward_jumps.entry((frame.rung, frame.element)).or_default();
            if *taken >= limits::BACKWARD_JUMPS {
                return Err(Exit::Fault(94));
            }
            *taken += 1;
            if self.flags.executed > self.budget_end {
                return Err(Exit::Stop(End::BudgetExceeded));
            }
        }
        Ok(Exit::Jump(to))
    }

    fn prescan_subroutine(&mut self, frame: &Frame<'p>, operands: &[OperandUse]) -> Result<(), Exit> {
        let Operand::Routine(routine) = *self.operand(frame, operands[0]) else { panic!("no routine") };
        if self.prescanned.insert((frame.program, routine.0)) {
            self.routine(frame, routine)?;
        }
        Ok(())
    }

    fn subroutine(&mut self, frame: &Frame<'p>, operands: &[OperandUse]) -> Result<(), Exit> {
        let Operand::Routine(routine) = *self.operand(frame, operands[0]) else { panic!("no routine") };
        let Operand::Integer { value: inputs, .. } = *self.operand(frame, operands[1]) else { panic!("no count") };
        let (inputs, returns) = operands[2..].split_at(inputs as usize);
        let program = &self.project.programs[usize::from(frame.program)];
        let mut values = Vec::with_capacity(inputs.len());
        for operand in inputs {
            values.push(self.passed(frame, *operand)?);
        }
        let mut targets = Vec::with_capacity(returns.len());
        for operand in returns {
            targets.push(self.target(frame, *operand)?);
        }
        if let (true, [only]) = (program.fault == Some(routine), inputs)
            && let Number::Integer(number @ 990..=999) = self.number(frame, *only)?
        {
            return Err(Exit::Fault(number as u16));
        }
        let callee = Frame { routine: routine.0, rung: 0, element: 0, ..frame.clone() };
        if let Some(parameters) = received(&callee, routine) {
            let mut places = Vec::with_capacity(parameters.len());
            for operand in parameters {
                places.push(self.target(&callee, *operand)?);
            }
            for (target, value) in places.iter().zip(values) {
                self.place(target, value);
            }
        }
        if let Some(returned) = self.routine(frame, routine)? {
            for (target, value) in targets.iter().zip(returned) {
                self.place(target, value);
            }
        }
        Ok(())
    }

    /// The value of a parameter that is passed or handed back.
    fn passed(&mut self, frame: &Frame<'p>, operand: OperandUse) -> Result<Value, Exit> {
        match self.operand(frame, operand) {
            Operand::Integer { value, .. } => Ok(Value::Integer(Elementary::Dint, *value)),
            Operand::Real(bits) => Ok(Value::Real(*bits)),
            Operand::Status(_) => Ok(Value::Bit(self.bit(frame, operand)?)),
            _ => {
                let target = self.target(frame, operand)?;
                Ok(if target.bit.is_some() {
                    Value::Bit(self.memory.bit(&target))
                } else {
                    self.memory.get(&target).clone()
                })
            }
        }
    }

    /// Puts a passed value where it belongs, between equal types.
    fn place(&mut self, target: &Target, value: Value) {
        if target.bit.is_some() {
            self.memory.set_bit(target, matches!(value, Value::Bit(true) | Value::Integer(_, 1)));
            return;
        }
        match (self.memory.get_mut(target), value) {
            (Value::Bit(to), Value::Integer(_, number)) => *to = number != 0,
            (Value::Integer(element, to), Value::Integer(_, number)) => *to = crate::memory::narrowed(*element, number),
            // A NaN takes its one form, as wherever a number is stored (REQ-EXEC-003).
            (to, Value::Real(bits)) => *to = Value::Real(crate::arithmetic::canonical(bits)),
            (to, value) => *to = value,
        }
    }

    fn system_value(&mut self, frame: &Frame<'p>, opcode: Opcode, operands: &[OperandUse]) -> Result<(), Exit> {
        let Operand::SystemValue(value) = self.operand(frame, operands[2]) else { panic!("no attribute") };
        let attribute = value.attribute;
        let program = match value.instance {
            SystemInstance::Program(program) => usize::from(program.0),
            _ => usize::from(frame.program),
        };
        let width = attribute.element.bytes() as usize;
        let needed = width * attribute.length as usize;
        let (first, elements, mut bytes) = self.bytes_from(frame, operands[3], needed)?;
        for (index, place) in bytes[..needed].chunks_exact_mut(width).enumerate() {
            if opcode == Opcode::Ssv {
                let mut word = [0; 4];
                word[..width].copy_from_slice(place);
                self.records[program][index] = i32::from_le_bytes(word);
            } else {
                let number = if attribute.name == MAJOR_FAULT_RECORD {
                    self.records[program][index]
                } else {
                    let values = self.system_values.get(&(attribute.number, value.instance));
                    values.and_then(|values| values.get(index)).copied().unwrap_or_default()
                };
                place.copy_from_slice(&number.to_le_bytes()[..width]);
            }
        }
        if opcode == Opcode::Gsv {
            self.put_bytes(frame, operands[3], &first, elements, bytes);
        }
        Ok(())
    }

    /// A call of an Add-On Instruction: REQ-EXEC-030 to REQ-EXEC-033.
    pub(crate) fn add_on(
        &mut self,
        frame: &Frame<'p>,
        id: AddOnId,
        operands: &[OperandUse],
        condition: bool,
    ) -> Result<bool, Exit> {
        let definition = &frame.project.add_ons[usize::from(id.0)];
        let target = self.target(frame, operands[0])?;
        let enable = |name: &str| {
            let parameter = definition.parameters.iter().find(|known| known.name.eq_ignore_ascii_case(name));
            let member = parameter.and_then(|parameter| parameter.member);
            target.part(u32::from(member.unwrap_or_else(|| panic!("no {name}"))))
        };
        let (enable_in, enable_out) = (enable("EnableIn"), enable("EnableOut"));
        let runs = condition && !frame.prescanning;
        let routine = if condition { definition.logic } else { definition.enable_in_false };
        let routine = if frame.prescanning { definition.logic } else { routine };
        if routine.is_some() {
            // Every subscript is looked at before anything is written (REQ-EXEC-004).
            for operand in &operands[1..] {
                if let Operand::Reference(reference) = self.operand(frame, *operand) {
                    self.locate(frame, reference)?;
                }
            }
        }
        self.memory.set_bit(&enable_in, runs);
        self.memory.set_bit(&enable_out, runs);
        let Some(routine) = routine else { return Ok(false) };
        let mut in_out = HashMap::new();
        for (parameter, operand) in definition.arguments().zip(&operands[1..]) {
            if parameter.usage == Usage::InOut {
                let index = definition.parameters.iter().position(|known| known.name == parameter.name);
                let place = self.target(frame, *operand)?;
                in_out.insert(index.unwrap_or_default() as u16, place);
            }
        }
        self.pass_arguments(frame, id, &target, operands, Usage::Input)?;
        let inner =
            Frame { instance: Some(Instance { target: target.clone(), in_out }), in_add_on: true, ..frame.clone() };
        self.routine(&inner, routine)?;
        if let (true, Some(prescan)) = (frame.prescanning, definition.prescan) {
            self.routine(&Frame { prescanning: false, ..inner }, prescan)?;
        }
        self.pass_arguments(frame, id, &target, operands, Usage::Output)?;
        Ok(!frame.prescanning && self.memory.bit(&enable_out))
    }

    fn pass_arguments(
        &mut self,
        frame: &Frame<'p>,
        id: AddOnId,
        instance: &Target,
        operands: &[OperandUse],
        usage: Usage,
    ) -> Result<(), Exit> {
        let definition = &frame.project.add_ons[usize::from(id.0)];
        for (parameter, operand) in definition.arguments().zip(&operands[1..]) {
            let Some(member) = parameter.member.filter(|_| parameter.usage == usage) else { continue };
            let inner = instance.part(u32::from(member));
            let bit = matches!(self.memory.get(&inner), Value::Bit(_));
            match (usage, bit) {
                (Usage::Input, true) => {
                    let value = self.bit(frame, *operand)?;
                    self.memory.set_bit(&inner, value);
                }
                (Usage::Input, false) => {
                    let value = self.number(frame, *operand)?;
                    self.store_and_report(frame, &inner, value);
                }
                (_, true) => {
                    let value = self.memory.bit(&inner);
                    let outer = self.target(frame, *operand)?;
                    self.memory.set_bit(&outer, value);
                }
                (_, false) => {
                    let value = self.number_at(&inner);
                    let outer = self.target(frame, *operand)?;
                    self.store_and_report(frame, &outer, value);
                }
            }
        }
        Ok(())
    }
}

/// Whether a rung begins with this label.
fn defines(frame: &Frame<'_>, rung: &Rung, label: &str) -> bool {
    first_instruction(rung).is_some_and(|first| {
        first.call.opcode() == Some(Opcode::Lbl)
            && matches!(frame.project.operand(first.operands[0].id),
                Operand::Text(text) if text.eq_ignore_ascii_case(label))
    })
}

/// The operands of the SBR with which a routine begins.
fn received<'a>(frame: &Frame<'a>, routine: RoutineId) -> Option<&'a [OperandUse]> {
    let rungs = &frame.project.routine(routine).rungs;
    let first = first_instruction(rungs.first()?)?;
    (first.call.opcode() == Some(Opcode::Sbr)).then_some(&first.operands[..])
}

fn first_instruction(rung: &Rung) -> Option<&Instruction> {
    let mut elements: &[Element] = &rung.elements;
    loop {
        match elements.first()? {
            Element::Instruction(instruction) => return Some(instruction),
            Element::Branch(Branch { legs, .. }) => elements = legs.first()?,
        }
    }
}
