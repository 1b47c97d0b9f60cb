//! Calls of safety application instructions: mirrors the operands, runs the library, writes the members back.
//! REQ-EXEC-060 to 062.

use twinrung_bytecode::observer::Observer;
use twinrung_catalog::{Element, Instruction as Declaration, Member, MemberRole};

use super::{FaultCode, Run};
use crate::machine::Keeper;
use crate::number::{Number, stored_real};
use crate::program::{Instruction, SafetyCall};

/// Members of the largest backing type, with room to spare; the loader refuses what has more.
pub(crate) const MEMBERS: usize = 96;
/// Operands after the backing tag.
const OPERANDS: usize = 48;

impl<O: Observer> Run<'_, O> {
    /// One execution, or the prescan, of a safety application instruction.
    pub(super) fn safety(&mut self, instruction: Instruction, input: bool, prescan: bool) -> Result<(), FaultCode> {
        let Some(call) = self.program.safety_calls.get(instruction.extra as usize).copied() else { return Ok(()) };
        let declaration: &Declaration = call.opcode.instruction();
        let Some(application) = declaration.safety else { return Ok(()) };
        let mut operands = [0i32; OPERANDS];
        let count = (instruction.operands.count as usize).saturating_sub(1).min(OPERANDS);
        for (index, value) in operands.iter_mut().take(count).enumerate() {
            let operand = self.program.operand(instruction.operands, index.saturating_add(1));
            *value = match self.number(operand)? {
                Number::Integer(value) => value,
                // Mirroring stores the operand, so a NaN takes its one form (REQ-EXEC-003).
                Number::Real(value) => stored_real(value) as i32,
            };
        }
        let mut members = [0i32; MEMBERS];
        let declared = application.backing.members;
        let total = declared.len().min(MEMBERS);
        self.read_members(call, declared, &mut members);
        for (name, value) in application.mirrored.iter().zip(operands) {
            let Some((position, member)) = application.backing.member(name) else { continue };
            if prescan && member.role != MemberRole::Configuration {
                continue;
            }
            if let Some(slot) = members.get_mut(position) {
                *slot = if member.element == Element::Bool { i32::from(value != 0) } else { value };
            }
        }
        for name in ["EnableIn", "EnableOut"] {
            let position = application.backing.member(name).map(|(position, _)| position);
            if let Some(slot) = position.and_then(|position| members.get_mut(position)) {
                *slot = i32::from(input && !prescan);
            }
        }
        let now = self.inputs.now_ms;
        if let (Some(Keeper { state, prescanned, .. }), Some(operands), Some(members)) =
            (self.machine.keeper(call.state), operands.get(..count), members.get_mut(..total))
        {
            // What no prescan has reached begins as if one just had.
            if prescan || !*prescanned {
                state.prescan(operands, members);
                *prescanned = true;
            }
            if !prescan {
                state.scan(input, now, operands, members);
            }
        }
        self.write_members(call, declared, &members);
        Ok(())
    }

    fn read_members(&self, call: SafetyCall, declared: &[Member], members: &mut [i32]) {
        let (mut bit, mut word) = (call.bit, call.word);
        for (member, value) in declared.iter().zip(members) {
            let count = member.length.max(1);
            if member.element == Element::Bool {
                *value = i32::from(self.machine.bit(bit));
                bit = bit.saturating_add(count);
            } else {
                *value = self.machine.word(word);
                word = word.saturating_add(count);
            }
        }
    }

    fn write_members(&mut self, call: SafetyCall, declared: &[Member], members: &[i32]) {
        let (mut bit, mut word) = (call.bit, call.word);
        for (member, value) in declared.iter().zip(members) {
            let count = member.length.max(1);
            if member.element == Element::Bool {
                self.write_bit(bit, *value != 0);
                bit = bit.saturating_add(count);
            } else {
                self.write_word(word, *value as u32);
                word = word.saturating_add(count);
            }
        }
    }
}
