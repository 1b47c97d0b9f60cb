//! TSSM, Two Sensor Symmetrical Muting. `muting-and-outputs.md` 4.

use super::instruction::muting_instruction;
use super::sequence::{Field, Sequence, Stage, is_pair_time, pair_overdue, wrong};
use crate::codes::NONE;
use crate::timer::Timer;
use core::ops::RangeInclusive;
use twinrung_catalog::types::safety::muting::MUTING_TWO_SENSOR_SYM;

muting_instruction! {
    /// Memory of a TSSM call.
    Tssm, Symmetrical, MUTING_TWO_SENSOR_SYM;
    inputs {
        DISCREPANCY_TIME = "S1S2DiscrepancyTime",
        MINIMUM_TIME = "S1S2LCMinimumTime",
        MAXIMUM_TIME = "S1S2LCMaximumTime",
    }
}

/// Fault: S1S2 Discrepancy Time reached. 2.8, decided.
const DISCREPANCY: i32 = 0xF05C;
/// Fault: S1S2-LC Minimum Time violated. 2.8, decided.
const TOO_EARLY: i32 = 0xF05D;
/// Fault: S1S2-LC Maximum Time reached. 2.8, decided.
const TOO_LATE: i32 = 0xF05E;

/// S1S2-LC Minimum Time in ms. 4.1, recalled 50 %.
const MINIMUM_RANGE_MS: RangeInclusive<i32> = 0..=180_000;

/// One of the two sensors.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Sensor {
    One,
    Two,
}

/// The sensors that are blocked (`n` of 4.3, with which one).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Sensors {
    None,
    Only(Sensor),
    Both,
}

/// The steps of 4.3.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum Step {
    #[default]
    Wait,
    Idle,
    OneIn(Sensor),
    MutedIn,
    MutedCurtain,
    MutedOut,
    OneOut(Sensor),
}

crate::bits!(coded Step);

#[cfg(feature = "injection")]
impl crate::injection::Coded for Step {
    /// The step, and whether its sensor is the second one.
    type Code = (crate::injection::Few<3>, bool);
    const FIRST: Step = Step::Wait;

    fn code(&self) -> Self::Code {
        let (number, second) = match *self {
            Step::Wait => (0, false),
            Step::Idle => (1, false),
            Step::OneIn(sensor) => (2, sensor == Sensor::Two),
            Step::MutedIn => (3, false),
            Step::MutedCurtain => (4, false),
            Step::MutedOut => (5, false),
            Step::OneOut(sensor) => (6, sensor == Sensor::Two),
        };
        (crate::injection::Few(number), second)
    }

    fn of((number, second): Self::Code) -> Option<Step> {
        let sensor = if second { Sensor::Two } else { Sensor::One };
        let steps = [
            Step::Wait,
            Step::Idle,
            Step::OneIn(sensor),
            Step::MutedIn,
            Step::MutedCurtain,
            Step::MutedOut,
            Step::OneOut(sensor),
        ];
        steps.get(number.0 as usize).copied()
    }
}

/// Step and timers.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Symmetrical {
    step: Step,
    discrepancy: Timer,
    /// `tsl`: since both sensors became blocked, or since the curtain cleared.
    settled: Timer,
}

crate::bits!(Symmetrical { step, discrepancy, settled });

/// Which elements are blocked.
pub(crate) struct Blocked {
    sensors: Sensors,
    lc: bool,
}

impl Field for Blocked {
    fn curtain(&self) -> bool {
        self.lc
    }

    fn any_sensor(&self) -> bool {
        self.sensors != Sensors::None
    }
}

/// The times between the elements.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Times {
    discrepancy_ms: i32,
    minimum_ms: i32,
    maximum_ms: i32,
}

crate::bits!(Times { discrepancy_ms, minimum_ms, maximum_ms });

impl Times {
    fn usable(&self) -> bool {
        is_pair_time(self.discrepancy_ms)
            && MINIMUM_RANGE_MS.contains(&self.minimum_ms)
            && is_pair_time(self.maximum_ms)
            && (self.maximum_ms == 0 || self.minimum_ms < self.maximum_ms)
    }
}

impl Step {
    /// The table of 4.3; the fault of a pattern that it does not allow. `early`: the minimum time is not over.
    fn next(self, &Blocked { sensors, lc }: &Blocked, early: bool) -> Result<Step, i32> {
        use Sensors::{Both, None, Only};
        let step = match (self, sensors, lc) {
            (Step::Idle, None, _) => Step::Idle,
            (Step::Idle, Only(sensor), false) => Step::OneIn(sensor),
            (Step::Idle | Step::OneIn(_), Both, false) => Step::MutedIn,

            (Step::OneIn(_) | Step::OneOut(_) | Step::MutedIn, None, false) => Step::Idle,
            (Step::OneIn(first), Only(sensor), false) if first == sensor => self,
            (Step::OneOut(last), Only(sensor), false) if last == sensor => self,

            (Step::MutedIn, Both, false) => Step::MutedIn,
            (Step::MutedIn, Only(sensor), false) => Step::OneOut(sensor),
            (Step::MutedIn, Both, true) if early => return Err(TOO_EARLY),
            (Step::MutedIn | Step::MutedCurtain | Step::MutedOut, Both, true) => Step::MutedCurtain,

            (Step::MutedCurtain | Step::MutedOut, Both, false) => Step::MutedOut,
            (Step::MutedCurtain | Step::MutedOut, _, false) if early => return Err(TOO_EARLY),
            (Step::MutedCurtain | Step::MutedOut, Only(sensor), false) => Step::OneOut(sensor),
            (Step::MutedCurtain | Step::MutedOut, None, false) => Step::Idle,

            _ => return Err(wrong(self.muted(), lc)),
        };
        Ok(step)
    }

    fn muted(self) -> bool {
        matches!(self, Step::MutedIn | Step::MutedCurtain | Step::MutedOut)
    }

    /// The steps in which `tsl` counts.
    fn settles(self) -> bool {
        matches!(self, Step::MutedIn | Step::MutedOut)
    }
}

impl Sequence for Symmetrical {
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
        *self = Symmetrical { step: Step::Idle, ..Symmetrical::default() };
    }

    fn step(&mut self, field: &Blocked, times: &Times, now_ms: i64) -> i32 {
        // From the curtain step the sensors clear in the same scan as the curtain: no time has passed.
        let elapsed_ms = self.settled.elapsed_ms(now_ms).unwrap_or(0);
        let early = elapsed_ms < i64::from(times.minimum_ms);
        match self.step.next(field, early) {
            Ok(Step::Idle) => self.idle(),
            Ok(step) => {
                self.step = step;
                self.settled.follow(step.settles(), now_ms);
            }
            Err(fault) => return fault,
        }
        NONE
    }

    fn overdue(&mut self, field: &Blocked, times: &Times, now_ms: i64) -> i32 {
        let one = matches!(field.sensors, Sensors::Only(_));
        if pair_overdue(&mut self.discrepancy, one, times.discrepancy_ms, now_ms) {
            DISCREPANCY
        } else if times.maximum_ms != 0 && self.settled.reached(now_ms, times.maximum_ms) {
            TOO_LATE
        } else {
            NONE
        }
    }
}

fn read_times(members: &Members) -> Times {
    Times {
        discrepancy_ms: members[DISCREPANCY_TIME],
        minimum_ms: members[MINIMUM_TIME],
        maximum_ms: members[MAXIMUM_TIME],
    }
}

fn read_field(members: &Members) -> Blocked {
    let sensors = match (members[SENSOR_1] == 0, members[SENSOR_2] == 0) {
        (false, false) => Sensors::None,
        (true, false) => Sensors::Only(Sensor::One),
        (false, true) => Sensors::Only(Sensor::Two),
        (true, true) => Sensors::Both,
    };
    Blocked { sensors, lc: members[LIGHT_CURTAIN] == 0 }
}
