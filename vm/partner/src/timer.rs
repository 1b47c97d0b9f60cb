//! TON, TOF and RTO without branches. general-instructions.md A.2.
//!
//! They are inlined into the loops over records, so that a timer's members stay in registers.

/// A timer's members and its hidden time stamp.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct TimerState {
    /// EN.
    pub(crate) enabled: bool,
    /// TT.
    pub(crate) timing: bool,
    /// DN.
    pub(crate) done: bool,
    /// PRE in ms.
    pub(crate) preset: i32,
    /// ACC in ms.
    pub(crate) accumulated: i32,
    /// Hidden time stamp in ms.
    pub(crate) last_time: i64,
}

/// `yes` or `no` without a branch.
pub(crate) const fn select(condition: bool, yes: i32, no: i32) -> i32 {
    no ^ ((yes ^ no) & (condition as i32).wrapping_neg())
}

const fn select_time(condition: bool, yes: i64, no: i64) -> i64 {
    no ^ ((yes ^ no) & (condition as i64).wrapping_neg())
}

/// ACC with the time since the last stamp; it stays at the greatest DINT.
#[inline(always)]
fn stepped(state: &TimerState, now_ms: i64) -> i32 {
    let passed = now_ms.saturating_sub(state.last_time);
    let sum = i64::from(state.accumulated).saturating_add(passed);
    sum.clamp(i64::from(i32::MIN), i64::from(i32::MAX)) as i32
}

/// TON.
#[inline(always)]
pub(crate) fn on_delay(state: TimerState, input: bool, now_ms: i64) -> TimerState {
    let counting = input & !state.done & state.enabled;
    let stepped = stepped(&state, now_ms);
    let done = input & (state.done | (counting & (stepped >= state.preset)));
    TimerState {
        enabled: input,
        timing: input & !done,
        done,
        preset: state.preset,
        accumulated: select(input, select(counting, stepped, state.accumulated), 0),
        last_time: select_time(input, now_ms, state.last_time),
    }
}

/// RTO.
#[inline(always)]
pub(crate) fn retentive(state: TimerState, input: bool, now_ms: i64) -> TimerState {
    let counting = input & !state.done & state.enabled;
    let stepped = stepped(&state, now_ms);
    let done = state.done | (counting & (stepped >= state.preset));
    TimerState {
        enabled: input,
        timing: input & !done,
        done,
        preset: state.preset,
        accumulated: select(counting, stepped, state.accumulated),
        last_time: select_time(input, now_ms, state.last_time),
    }
}

/// TOF.
#[inline(always)]
pub(crate) fn off_delay(state: TimerState, input: bool, now_ms: i64) -> TimerState {
    let counting = !input & state.done & !state.enabled;
    let stepped = stepped(&state, now_ms);
    let done = input | (state.done & !(counting & (stepped >= state.preset)));
    TimerState {
        enabled: input,
        timing: !input & done,
        done,
        preset: state.preset,
        accumulated: select(input, 0, select(counting, stepped, state.accumulated)),
        last_time: select_time(!input & state.done, now_ms, state.last_time),
    }
}

#[cfg(test)]
mod tests {
    use alloc::vec::Vec;

    use super::*;

    fn timer(preset: i32) -> TimerState {
        TimerState { enabled: false, timing: false, done: false, preset, accumulated: 0, last_time: 0 }
    }

    fn trace(
        function: fn(TimerState, bool, i64) -> TimerState,
        mut state: TimerState,
        inputs: &[(i64, bool)],
    ) -> Vec<(bool, bool, bool, i32)> {
        inputs
            .iter()
            .map(|(now, input)| {
                state = function(state, *input, *now);
                (state.enabled, state.timing, state.done, state.accumulated)
            })
            .collect()
    }

    #[test]
    fn on_delay_when_first_true_scan_then_no_time_is_added() {
        let rows = trace(on_delay, timer(20), &[(100, true), (110, true), (120, true), (130, true), (140, false)]);
        assert_eq!(
            rows,
            [
                (true, true, false, 0),
                (true, true, false, 10),
                (true, false, true, 20),
                (true, false, true, 20),
                (false, false, false, 0)
            ]
        );
    }

    #[test]
    fn on_delay_when_preset_zero_then_done_at_the_second_true_scan() {
        let rows = trace(on_delay, timer(0), &[(0, true), (0, true)]);
        assert_eq!(rows, [(true, true, false, 0), (true, false, true, 0)]);
    }

    #[test]
    fn on_delay_when_accumulated_would_exceed_the_greatest_dint_then_done_at_it() {
        let state = TimerState { enabled: true, accumulated: i32::MAX - 5, preset: i32::MAX, ..timer(0) };
        let after = on_delay(state, true, 10);
        assert_eq!((after.accumulated, after.done, after.timing), (i32::MAX, true, false));
    }

    #[test]
    fn on_delay_when_done_was_set_by_logic_then_the_pause_is_not_counted() {
        let state = TimerState { enabled: true, done: true, accumulated: 5, last_time: 100, ..timer(50) };
        let paused = on_delay(state, true, 200);
        let resumed = on_delay(TimerState { done: false, ..paused }, true, 210);
        assert_eq!(resumed.accumulated, 15);
    }

    #[test]
    fn retentive_when_false_then_accumulated_and_done_stay() {
        let rows = trace(retentive, timer(20), &[(0, true), (10, true), (20, false), (500, true), (510, true)]);
        assert_eq!(
            rows,
            [
                (true, true, false, 0),
                (true, true, false, 10),
                (false, false, false, 10),
                (true, true, false, 10),
                (true, false, true, 20)
            ]
        );
    }

    #[test]
    fn off_delay_when_rung_falls_then_done_stays_for_the_preset() {
        let inputs = [(0, true), (10, false), (20, false), (30, false), (40, false)];
        let rows = trace(off_delay, timer(20), &inputs);
        assert_eq!(
            rows,
            [
                (true, false, true, 0),
                (false, true, true, 0),
                (false, true, true, 10),
                (false, false, false, 20),
                (false, false, false, 20)
            ]
        );
    }

    #[test]
    fn off_delay_when_never_true_then_it_does_not_time() {
        let state = TimerState { accumulated: 20, ..timer(20) };
        assert_eq!(off_delay(state, false, 10), state);
    }
}
