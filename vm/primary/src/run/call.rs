//! JSR, and calls of Add-On Instructions. general-instructions.md A.8, REQ-EXEC-023, 024, 030 to 032.

use twinrung_bytecode::channel::ScanEnd;
use twinrung_bytecode::observer::Observer;

use super::flow::Next;
use super::{FaultCode, Run};
use crate::machine::Role;
use crate::program::{AddOnCall, NONE, Operand};

impl<O: Observer> Run<'_, O> {
    /// JSR with a true rung, or in prescan.
    pub(super) fn subroutine(&mut self, index: u32, prescan: bool) -> Result<Next, FaultCode> {
        let Some(jsr) = self.program.instructions.get(index as usize).copied() else { return Ok(Next::Out(false)) };
        let Operand::Routine(body) = self.program.operand(jsr.operands, 0) else { return Ok(Next::Out(!prescan)) };
        if prescan {
            if self.visited(body) {
                return Ok(Next::Out(false));
            }
        } else {
            let fault_routine =
                self.program.programs.get(usize::from(self.machine.program)).map_or(NONE, |program| program.fault);
            // Every subscript faults before anything is written (REQ-EXEC-004).
            self.collect_inputs(jsr)?;
            self.select_returns(jsr)?;
            if body == fault_routine
                && let Some(code) = self.user_fault(jsr)
            {
                return Err(code);
            }
            self.pass_inputs(jsr, body)?;
        }
        self.push(body, Role::Subroutine { instruction: index }, prescan)?;
        Ok(Next::Switched)
    }

    fn call(&self, call: u32) -> Option<AddOnCall> {
        self.program.calls.get(call as usize).copied()
    }

    /// A call of an Add-On Instruction.
    pub(super) fn add_on(&mut self, index: u32, input: bool, prescan: bool) -> Result<Next, FaultCode> {
        let Some(call) = self.call(index) else { return Ok(Next::Out(false)) };
        // A subscript beyond its array must fault before anything is written (REQ-EXEC-004).
        if prescan {
            self.check_arguments(call)?;
            self.write_bit(call.enable_in, false);
            self.write_bit(call.enable_out, false);
            self.copy_in(call.inputs)?;
            self.push(call.logic, Role::Logic { call: index }, true)?;
            return Ok(Next::Switched);
        }
        if input {
            self.check_arguments(call)?;
            self.write_bit(call.enable_in, true);
            self.copy_in(call.inputs)?;
            self.write_bit(call.enable_out, true);
            self.push(call.logic, Role::Logic { call: index }, false)?;
            return Ok(Next::Switched);
        }
        if call.enable_in_false == NONE {
            self.write_bit(call.enable_in, false);
            self.write_bit(call.enable_out, false);
            return Ok(Next::Out(false));
        }
        self.check_arguments(call)?;
        self.write_bit(call.enable_in, false);
        self.write_bit(call.enable_out, false);
        self.copy_in(call.inputs)?;
        self.push(call.enable_in_false, Role::EnableInFalse { call: index }, false)?;
        Ok(Next::Switched)
    }

    /// Evaluates the subscripts of the arguments, in the order of the call.
    fn check_arguments(&mut self, call: AddOnCall) -> Result<(), FaultCode> {
        for argument in call.varying.of(&self.program.arguments) {
            self.slot(self.program.operand_at(argument.outside))?;
        }
        Ok(())
    }

    /// Logic or EnableInFalse of a call has ended.
    pub(super) fn after_add_on(&mut self, index: u32) -> Result<(), ScanEnd> {
        let Some(call) = self.call(index) else { return Ok(()) };
        match self.copy_out(call.outputs) {
            Ok(()) => {
                let out = self.machine.bit(call.enable_out);
                self.deliver(out)
            }
            Err(code) => self.fault_caller(code),
        }
    }

    /// Logic has been prescanned: the Prescan routine follows, with true rungs.
    pub(super) fn after_prescanned_logic(&mut self, index: u32) -> Result<(), ScanEnd> {
        let Some(call) = self.call(index) else { return Ok(()) };
        if call.prescan == NONE {
            return self.after_add_on_prescan(index);
        }
        match self.push(call.prescan, Role::Prescan { call: index }, false) {
            Ok(()) => Ok(()),
            Err(code) => self.fault_caller(code),
        }
    }

    /// Prescan of a call has ended.
    pub(super) fn after_add_on_prescan(&mut self, index: u32) -> Result<(), ScanEnd> {
        let Some(call) = self.call(index) else { return Ok(()) };
        match self.copy_out(call.outputs) {
            Ok(()) => self.deliver(false),
            Err(code) => self.fault_caller(code),
        }
    }
}
