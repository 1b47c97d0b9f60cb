//! CTU, CTD and RES. general-instructions.md A.3.

use twinrung_catalog::Opcode;
use twinrung_catalog::PredefinedType;
use twinrung_catalog::types::base::{CONTROL, COUNTER, TIMER};

use crate::evaluator::Judge;
use crate::memory::{Frame, Target, member};

impl Judge<'_> {
    pub(crate) fn counter(&mut self, frame: &Frame<'_>, opcode: Opcode, target: &Target, condition: bool) {
        let part = |name| target.part(member(&COUNTER, name));
        let up = opcode == Opcode::Ctu;
        let edge = part(if up { "CU" } else { "CD" });
        if frame.prescanning {
            self.memory.set_bit(&edge, true);
            return;
        }
        if !condition {
            self.memory.set_bit(&edge, false);
        } else if !self.memory.bit(&edge) {
            self.memory.set_bit(&edge, true);
            let accumulated = self.memory.integer(&part("ACC"));
            let (last, wrapped) = if up { (i32::MAX, i32::MIN) } else { (i32::MIN, i32::MAX) };
            if accumulated == last {
                self.memory.set_integer(&part("ACC"), wrapped);
                let (own, other) = if up { ("OV", "UN") } else { ("UN", "OV") };
                if !self.memory.bit(&part(other)) {
                    self.memory.set_bit(&part(own), true);
                    return;
                }
                self.memory.set_bit(&part("OV"), false);
                self.memory.set_bit(&part("UN"), false);
            } else {
                self.memory.set_integer(&part("ACC"), if up { accumulated + 1 } else { accumulated - 1 });
            }
        }
        if !self.memory.bit(&part("OV")) && !self.memory.bit(&part("UN")) {
            let done = self.memory.integer(&part("ACC")) >= self.memory.integer(&part("PRE"));
            self.memory.set_bit(&part("DN"), done);
        }
    }

    pub(crate) fn reset(&mut self, target: &Target, structure: &'static PredefinedType) {
        for (index, declared) in structure.members.iter().enumerate() {
            let part = target.part(index as u32);
            match declared.name {
                "PRE" | "LEN" => {}
                "ACC" | "POS" => self.memory.set_integer(&part, 0),
                _ => self.memory.set_bit(&part, false),
            }
        }
    }

    /// Which of the three structures a RES resets: they differ in the number of their members.
    pub(crate) fn resettable(&self, target: &Target) -> &'static PredefinedType {
        let crate::value::Value::Structure(parts) = self.memory.get(target) else { panic!("not a structure") };
        [&TIMER, &COUNTER, &CONTROL]
            .into_iter()
            .find(|structure| structure.members.len() == parts.len())
            .unwrap_or_else(|| panic!("RES of something else"))
    }
}
