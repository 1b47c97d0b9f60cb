//! TON, TOF, RTO. general-instructions.md A.2.

use twinrung_catalog::Opcode;
use twinrung_catalog::types::base::TIMER;

use crate::evaluator::{Exit, Judge};
use crate::memory::{Frame, Target, member};

struct Timer {
    preset: Target,
    accumulated: Target,
    enabled: Target,
    timing: Target,
    done: Target,
    whole: Target,
}

impl Timer {
    fn of(target: Target) -> Timer {
        let part = |name| target.part(member(&TIMER, name));
        Timer {
            preset: part("PRE"),
            accumulated: part("ACC"),
            enabled: part("EN"),
            timing: part("TT"),
            done: part("DN"),
            whole: target,
        }
    }
}

impl Judge<'_> {
    pub(crate) fn timer(
        &mut self,
        frame: &Frame<'_>,
        opcode: Opcode,
        target: Target,
        condition: bool,
    ) -> Result<(), Exit> {
        let timer = Timer::of(target);
        if frame.prescanning {
            self.set_all(&timer, false, false, false);
            match opcode {
                Opcode::Ton => self.memory.set_integer(&timer.accumulated, 0),
                Opcode::Tof => {
                    let preset = self.memory.integer(&timer.preset);
                    self.memory.set_integer(&timer.accumulated, preset);
                }
                _ => {}
            }
            return Ok(());
        }
        let runs = if opcode == Opcode::Tof { !condition } else { condition };
        if runs && (self.memory.integer(&timer.preset) < 0 || self.memory.integer(&timer.accumulated) < 0) {
            return Err(Exit::Fault(34));
        }
        match (opcode, condition) {
            (Opcode::Tof, true) => {
                self.set_all(&timer, true, false, true);
                self.memory.set_integer(&timer.accumulated, 0);
            }
            (Opcode::Tof, false) => {
                if self.memory.bit(&timer.done) {
                    let begins = self.memory.bit(&timer.enabled);
                    self.memory.set_bit(&timer.timing, true);
                    if self.stepped(&timer, begins) {
                        self.memory.set_bit(&timer.done, false);
                        self.memory.set_bit(&timer.timing, false);
                    }
                } else {
                    self.memory.set_bit(&timer.timing, false);
                }
                self.memory.set_bit(&timer.enabled, false);
            }
            (_, true) => {
                if self.memory.bit(&timer.done) {
                    self.memory.set_bit(&timer.timing, false);
                    // Paused: the pause is not counted (2.7, decided in A.2).
                    self.memory.last_time.insert(timer.whole.clone(), self.now_ms);
                } else {
                    let begins = !self.memory.bit(&timer.enabled);
                    self.memory.set_bit(&timer.timing, true);
                    if self.stepped(&timer, begins) {
                        self.memory.set_bit(&timer.done, true);
                        self.memory.set_bit(&timer.timing, false);
                    }
                }
                self.memory.set_bit(&timer.enabled, true);
            }
            (Opcode::Ton, false) => {
                self.set_all(&timer, false, false, false);
                self.memory.set_integer(&timer.accumulated, 0);
            }
            (_, false) => {
                self.memory.set_bit(&timer.enabled, false);
                self.memory.set_bit(&timer.timing, false);
            }
        }
        Ok(())
    }

    /// Adds the time since the last step; whether the preset is reached. The execution that begins adds nothing.
    fn stepped(&mut self, timer: &Timer, begins: bool) -> bool {
        let last = self.memory.last_time.insert(timer.whole.clone(), self.now_ms);
        if begins {
            return false;
        }
        let passed = self.now_ms - last.unwrap_or(self.prescan_ms);
        let sum = i64::from(self.memory.integer(&timer.accumulated)) + passed;
        let rolled_over = sum > i64::from(i32::MAX);
        self.memory.set_integer(&timer.accumulated, if rolled_over { i32::MAX } else { sum as i32 });
        rolled_over || self.memory.integer(&timer.accumulated) >= self.memory.integer(&timer.preset)
    }

    fn set_all(&mut self, timer: &Timer, enabled: bool, timing: bool, done: bool) {
        self.memory.set_bit(&timer.enabled, enabled);
        self.memory.set_bit(&timer.timing, timing);
        self.memory.set_bit(&timer.done, done);
    }
}
