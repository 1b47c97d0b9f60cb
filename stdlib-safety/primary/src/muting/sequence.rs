//! What the core asks of an instruction: its elements, and its sequence of steps. `muting-and-outputs.md` 2.3, 2.7.

use crate::timer::Timer;
use core::ops::RangeInclusive;

/// Fault: sensors changed in a wrong order. 2.8, decided.
const WRONG_ORDER: i32 = 0xF052;
/// Fault: curtain blocked during a sequence although it was not muted. 2.8, decided.
const CURTAIN_NOT_MUTED: i32 = 0xF053;
/// Fault: a sensor changed wrongly while muted with the curtain blocked. 2.8, decided.
const SENSOR_UNDER_LOAD: i32 = 0xF054;
/// Fault of TSAM and FSBM: S1-S2 Time reached. 2.8, decided.
pub(crate) const S1_S2_TIME: i32 = 0xF058;
/// Fault of TSAM and FSBM: S2-LC Time reached. 2.8, decided.
pub(crate) const S2_LC_TIME: i32 = 0xF059;

/// Times between two elements in ms, beside 0 = no limit. 2.2, recalled 60 %.
const PAIR_RANGE_MS: RangeInclusive<i32> = 5..=180_000;

/// Whether a time between two elements is 0 or in its range (2.2).
pub(crate) fn is_pair_time(time_ms: i32) -> bool {
    time_ms == 0 || PAIR_RANGE_MS.contains(&time_ms)
}

/// Where a sequence is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Stage {
    /// Not armed: everything must be seen clear once.
    Wait,
    /// Everything was clear; material may come.
    Idle,
    /// Material is in the sensors.
    Running,
}

/// What one instruction has of its own.
pub(crate) trait Sequence: Default {
    /// The blocked elements of one scan.
    type Field: Field;
    /// The times that bind the sequence, as they were at prescan.
    type Times;

    /// Where the sequence is.
    fn stage(&self) -> Stage;
    /// Whether the curtain is muted in this step.
    fn muted(&self) -> bool;
    /// Back to WAIT, all timers cleared.
    fn wait(&mut self) {
        *self = Self::default();
    }
    /// To IDLE, all timers cleared.
    fn idle(&mut self);
    /// One scan of the step table from IDLE or a running step, never from WAIT; gives a fault or 0.
    fn step(&mut self, field: &Self::Field, times: &Self::Times, now_ms: i64) -> i32;
    /// The pair timers of a running sequence; gives a fault or 0.
    fn overdue(&mut self, field: &Self::Field, times: &Self::Times, now_ms: i64) -> i32;
}

/// The elements that can be blocked.
pub(crate) trait Field {
    /// Whether the light curtain is blocked.
    fn curtain(&self) -> bool;
    /// Whether a sensor is blocked.
    fn any_sensor(&self) -> bool;
}

/// The fault of a pattern that the step table does not allow (3.3, 5.3).
pub(crate) fn wrong(muted: bool, curtain: bool) -> i32 {
    match (muted, curtain) {
        (true, true) => SENSOR_UNDER_LOAD,
        (false, true) => CURTAIN_NOT_MUTED,
        (_, false) => WRONG_ORDER,
    }
}

/// A pair timer (2.7): runs while its two elements differ, 0 disables it.
pub(crate) fn pair_overdue(timer: &mut Timer, differ: bool, limit_ms: i32, now_ms: i64) -> bool {
    timer.follow(differ, now_ms);
    limit_ms != 0 && timer.reached(now_ms, limit_ms)
}
