//! FSBM, Four Sensor Bi-directional Muting. `muting-and-outputs.md` 5.

use super::instruction::muting_instruction;
use super::sequence::{Field, S1_S2_TIME, S2_LC_TIME, Sequence, Stage, is_pair_time, pair_overdue, wrong};
use crate::codes::NONE;
use crate::timer::Timer;
use twinrung_catalog::types::safety::muting::MUTING_FOUR_SENSOR_BIDIR;

muting_instruction! {
    /// Memory of an FSBM call.
    Fsbm, Bidirectional, MUTING_FOUR_SENSOR_BIDIR;
    inputs {
        SENSOR_3 = "Sensor3",
        SENSOR_4 = "Sensor4",
        DIRECTION = "Direction",
        S1_S2 = "S1S2Time",
        S2_LC = "S2LCTime",
        LC_S3 = "LCS3Time",
        S3_S4 = "S3S4Time",
    }
}

/// Fault: LC-S3 Time reached. 2.8, decided.
const LC_S3_TIME: i32 = 0xF05A;
/// Fault: S3-S4 Time reached. 2.8, decided.
const S3_S4_TIME: i32 = 0xF05B;

/// The last position before everything is clear again (5.3).
const LAST: u8 = 9;

/// WAIT, IDLE, or a position of 5.3 with the direction that was set when the sequence began.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum Step {
    #[default]
    Wait,
    Idle,
    Running {
        position: u8,
        forward: bool,
    },
}

crate::bits!(coded Step);

#[cfg(feature = "injection")]
impl crate::injection::Coded for Step {
    /// The variant, the position and the direction.
    type Code = (crate::injection::Few<2>, u8, bool);
    const FIRST: Step = Step::Wait;

    fn code(&self) -> Self::Code {
        let (number, position, forward) = match *self {
            Step::Wait => (0, 0, false),
            Step::Idle => (1, 0, false),
            Step::Running { position, forward } => (2, position, forward),
        };
        (crate::injection::Few(number), position, forward)
    }

    fn of((number, position, forward): Self::Code) -> Option<Step> {
        [Step::Wait, Step::Idle, Step::Running { position, forward }].get(number.0 as usize).copied()
    }
}

/// Step and pair timers.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Bidirectional {
    step: Step,
    s1_s2: Timer,
    s2_lc: Timer,
    lc_s3: Timer,
    s3_s4: Timer,
}

crate::bits!(Bidirectional { step, s1_s2, s2_lc, lc_s3, s3_s4 });

/// Which elements are blocked, and the direction that is set.
pub(crate) struct Blocked {
    s1: bool,
    s2: bool,
    lc: bool,
    s3: bool,
    s4: bool,
    /// 1 = forward, S1 first. 5.1, polarity decided.
    forward: bool,
}

impl Blocked {
    /// The position of 5.3 that this pattern is, seen in a direction; `None` for a pattern that is none.
    fn position(&self, forward: bool) -> Option<u8> {
        let Blocked { s1, s2, lc, s3, s4, .. } = *self;
        let pattern = if forward { [s1, s2, lc, s3, s4] } else { [s4, s3, lc, s2, s1] };
        match pattern {
            [false, false, false, false, false] => Some(0),
            [true, false, false, false, false] => Some(1),
            [true, true, false, false, false] => Some(2),
            [true, true, true, false, false] => Some(3),
            [true, true, true, true, false] => Some(4),
            [true, true, true, true, true] => Some(5),
            [false, true, true, true, true] => Some(6),
            [false, false, true, true, true] => Some(7),
            [false, false, false, true, true] => Some(8),
            [false, false, false, false, true] => Some(LAST),
            _ => None,
        }
    }
}

impl Field for Blocked {
    fn curtain(&self) -> bool {
        self.lc
    }

    fn any_sensor(&self) -> bool {
        self.s1 || self.s2 || self.s3 || self.s4
    }
}

/// The pair times.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Times {
    s1_s2_ms: i32,
    s2_lc_ms: i32,
    lc_s3_ms: i32,
    s3_s4_ms: i32,
}

crate::bits!(Times { s1_s2_ms, s2_lc_ms, lc_s3_ms, s3_s4_ms });

impl Times {
    fn usable(&self) -> bool {
        [self.s1_s2_ms, self.s2_lc_ms, self.lc_s3_ms, self.s3_s4_ms].into_iter().all(is_pair_time)
    }
}

impl Step {
    /// The moves of 5.3; the fault of any other pattern.
    fn next(self, field: &Blocked) -> Result<Step, i32> {
        match self {
            Step::Wait | Step::Idle => match field.position(field.forward) {
                Some(0) => Ok(Step::Idle),
                Some(1) => Ok(Step::Running { position: 1, forward: field.forward }),
                // A demand: the curtain alone. The latch drops, without a fault.
                _ if field.lc && !field.any_sensor() => Ok(Step::Idle),
                _ => Err(wrong(false, field.lc)),
            },
            Step::Running { position, forward } => {
                let back = position.saturating_sub(1);
                let on = if position == LAST { 0 } else { position.saturating_add(1) };
                match field.position(forward) {
                    Some(0) if back == 0 || on == 0 => Ok(Step::Idle),
                    Some(next) if next == position || next == back || next == on => {
                        Ok(Step::Running { position: next, forward })
                    }
                    _ => Err(wrong(self.muted(), field.lc)),
                }
            }
        }
    }

    fn muted(self) -> bool {
        matches!(self, Step::Running { position: 2..=8, .. })
    }
}

impl Sequence for Bidirectional {
    type Field = Blocked;
    type Times = Times;

    fn stage(&self) -> Stage {
        match self.step {
            Step::Wait => Stage::Wait,
            Step::Idle => Stage::Idle,
            Step::Running { .. } => Stage::Running,
        }
    }

    fn muted(&self) -> bool {
        self.step.muted()
    }

    fn idle(&mut self) {
        *self = Bidirectional { step: Step::Idle, ..Bidirectional::default() };
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
        let lc_s3 = pair_overdue(&mut self.lc_s3, field.lc != field.s3, times.lc_s3_ms, now_ms);
        let s3_s4 = pair_overdue(&mut self.s3_s4, field.s3 != field.s4, times.s3_s4_ms, now_ms);
        if s1_s2 {
            S1_S2_TIME
        } else if s2_lc {
            S2_LC_TIME
        } else if lc_s3 {
            LC_S3_TIME
        } else if s3_s4 {
            S3_S4_TIME
        } else {
            NONE
        }
    }
}

fn read_times(members: &Members) -> Times {
    Times { s1_s2_ms: members[S1_S2], s2_lc_ms: members[S2_LC], lc_s3_ms: members[LC_S3], s3_s4_ms: members[S3_S4] }
}

fn read_field(members: &Members) -> Blocked {
    Blocked {
        s1: members[SENSOR_1] == 0,
        s2: members[SENSOR_2] == 0,
        lc: members[LIGHT_CURTAIN] == 0,
        s3: members[SENSOR_3] == 0,
        s4: members[SENSOR_4] == 0,
        forward: members[DIRECTION] != 0,
    }
}
