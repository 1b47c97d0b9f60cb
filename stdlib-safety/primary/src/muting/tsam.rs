//! TSAM, Two Sensor Asymmetrical Muting. `muting-and-outputs.md` 3.

use super::instruction::muting_instruction;
use super::sequence::{Field, S1_S2_TIME, S2_LC_TIME, Sequence, Stage, is_pair_time, pair_overdue, wrong};
use crate::codes::NONE;
use crate::timer::Timer;
use twinrung_catalog::types::safety::muting::MUTING_TWO_SENSOR_ASYM;

muting_instruction! {
    /// Memory of a TSAM call.
    Tsam, Asymmetrical, MUTING_TWO_SENSOR_ASYM;
    inputs { S1_S2 = "S1S2Time", S2_LC = "S2LCTime" }
}

/// The steps of 3.3: first in, last out.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum Step {
    #[default]
    Wait,
    Idle,
    Sensor1In,
    MutedIn,
    MutedCurtain,
    MutedOut,
    Sensor1Out,
}

crate::bits!(
    enum Step {
        Wait,
        Idle,
        Sensor1In,
        MutedIn,
        MutedCurtain,
        MutedOut,
        Sensor1Out,
    }
);

/// Step and pair timers.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Asymmetrical {
    step: Step,
    s1_s2: Timer,
    s2_lc: Timer,
}

crate::bits!(Asymmetrical { step, s1_s2, s2_lc });

/// Which elements are blocked.
pub(crate) struct Blocked {
    s1: bool,
    s2: bool,
    lc: bool,
}

impl Field for Blocked {
    fn curtain(&self) -> bool {
        self.lc
    }

    fn any_sensor(&self) -> bool {
        self.s1 || self.s2
    }
}

/// The pair times.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Times {
    s1_s2_ms: i32,
    s2_lc_ms: i32,
}

crate::bits!(Times { s1_s2_ms, s2_lc_ms });

impl Times {
    fn usable(&self) -> bool {
        is_pair_time(self.s1_s2_ms) && is_pair_time(self.s2_lc_ms)
    }
}

impl Step {
    /// The table of 3.3; the fault of a pattern that it does not allow.
    fn next(self, &Blocked { s1, s2, lc }: &Blocked) -> Result<Step, i32> {
        let step = match (self, s1, s2, lc) {
            (_, false, false, false) if self != Step::MutedCurtain => Step::Idle,
            // A demand: the curtain alone. The latch drops, without a fault.
            (Step::Idle, false, false, true) => Step::Idle,
            (Step::Idle | Step::Sensor1In, true, false, false) => Step::Sensor1In,
            (Step::Sensor1In | Step::MutedIn, true, true, false) => Step::MutedIn,
            (Step::MutedIn | Step::MutedCurtain | Step::MutedOut, true, true, true) => Step::MutedCurtain,
            (Step::MutedCurtain | Step::MutedOut, true, true, false) => Step::MutedOut,
            (Step::MutedIn | Step::MutedOut | Step::Sensor1Out, true, false, false) => Step::Sensor1Out,
            _ => return Err(wrong(self.muted(), lc)),
        };
        Ok(step)
    }

    fn muted(self) -> bool {
        matches!(self, Step::MutedIn | Step::MutedCurtain | Step::MutedOut)
    }
}

impl Sequence for Asymmetrical {
    type Field = Blocked;
    type Times = Times;

    fn stage(&self) -> Stage {
        match self.step {
            Step::Wait => Stage::Wait,
            Step::Idle => Stage::Idle,
            _ => Stage::Running,
        }
    }

    fn muted(&self) -> bool {
        self.step.muted()
    }

    fn idle(&mut self) {
        *self = Asymmetrical { step: Step::Idle, ..Asymmetrical::default() };
    }

    fn step(&mut self, field: &Blocked, _times: &Times, _now_ms: i64) -> i32 {
        match self.step.next(field) {
            Ok(Step::Idle) => self.idle(),
            Ok(step) => self.step = step,
            Err(fault) => return fault,
        }
        NONE
    }

    fn overdue(&mut self, field: &Blocked, times: &Times, now_ms: i64) -> i32 {
        let s1_s2 = pair_overdue(&mut self.s1_s2, field.s1 != field.s2, times.s1_s2_ms, now_ms);
        let s2_lc = pair_overdue(&mut self.s2_lc, field.s2 != field.lc, times.s2_lc_ms, now_ms);
        match (s1_s2, s2_lc) {
            (true, _) => S1_S2_TIME,
            (false, true) => S2_LC_TIME,
            (false, false) => NONE,
        }
    }
}

fn read_times(members: &Members) -> Times {
    Times { s1_s2_ms: members[S1_S2], s2_lc_ms: members[S2_LC] }
}

fn read_field(members: &Members) -> Blocked {
    Blocked { s1: members[SENSOR_1] == 0, s2: members[SENSOR_2] == 0, lc: members[LIGHT_CURTAIN] == 0 }
}
