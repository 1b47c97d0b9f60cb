//! CSM, Camshaft Monitor. `v14-and-metal-form.md` 7.

use super::latch::{FaultLatch, Status};
use crate::codes::NONE;
use crate::edge::Edge;
use crate::members::members;
use crate::timer::Timer;
use core::ops::RangeInclusive;
use twinrung_catalog::types::safety::press::CAMSHAFT_MONITOR;

members! {
    CAMSHAFT_MONITOR;
    inputs {
        MECHANICAL_DELAY_TIME = "MechanicalDelayTime",
        MAX_PULSE_PERIOD = "MaxPulsePeriod",
        MOTION_REQUEST = "MotionRequest",
        CHANNEL_A = "ChannelA",
        CHANNEL_B = "ChannelB",
        INPUT_STATUS = "InputStatus",
        RESET = "Reset",
    }
    outputs {
        O1 = "O1",
        FP = "FP",
        MEASURED_START_TIME = "MeasuredStartTime",
        MEASURED_STOP_TIME = "MeasuredStopTime",
        FAULT_CODE = "FaultCode",
        DIAGNOSTIC_CODE = "DiagnosticCode",
    }
}

/// Mechanical Delay Time and Max Pulse Period. 7, range decided.
const RANGE_MS: RangeInclusive<i32> = 1..=5000;

/// Fault: a time is out of range. 7, decided.
const OUT_OF_RANGE: i32 = 0xF301;
/// Fault: motion without request. 7, decided.
const NOT_REQUESTED: i32 = 0xF302;
/// Faults: no pulse of A, of B, of both within Mechanical Delay Time after the request. 7, decided.
const NO_START: PerChannel = PerChannel { a: 0xF303, b: 0xF304, both: 0xF305 };
/// Faults: pulses of A, of B, of both lost while running. 7, decided.
const PULSES_LOST: PerChannel = PerChannel { a: 0xF306, b: 0xF307, both: 0xF308 };
/// Fault: still moving Mechanical Delay Time after the request ended. 7, decided.
const STOP_TOO_SLOW: i32 = 0xF309;
/// Diagnostic: the request was already on at start. 7, decided.
const REQUEST_ON_AT_START: i32 = 0xF30A;

/// The codes of one cause for the channels that show it.
struct PerChannel {
    a: i32,
    b: i32,
    both: i32,
}

impl PerChannel {
    fn code(&self, a: bool, b: bool) -> i32 {
        match (a, b) {
            (true, true) => self.both,
            (true, false) => self.a,
            (false, true) => self.b,
            (false, false) => NONE,
        }
    }
}

/// The states of 7; FAULT is the latch's.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum Phase {
    #[default]
    Stopped,
    Starting,
    Running,
    Stopping,
}

crate::bits!(
    enum Phase {
        Stopped,
        Starting,
        Running,
        Stopping,
    }
);

/// One pulse train.
#[derive(Clone, Debug, Default, PartialEq)]
struct Train {
    /// The channel in the previous scan; `None` before the first one with Input Status.
    level: Option<bool>,
    /// Has pulsed since the request.
    seen: bool,
    last_pulse: Timer,
}

crate::bits!(Train { level, seen, last_pulse });

/// What a scan shows of one pulse train.
#[derive(Clone, Copy)]
struct Change {
    pulse: bool,
    activity: bool,
}

impl Train {
    fn sample(&mut self, level: bool) -> Change {
        let before = self.level.replace(level);
        let activity = before.is_some_and(|before| before != level);
        Change { pulse: activity && level, activity }
    }

    /// A pulse while starting or running: whether it was missing for longer than `period_ms` before.
    fn follow(&mut self, pulse: bool, now_ms: i64, period_ms: i32) -> bool {
        let lost = if pulse {
            self.last_pulse.exceeded(now_ms, period_ms)
        } else {
            self.last_pulse.reached(now_ms, period_ms)
        };
        if pulse {
            self.last_pulse.restart(now_ms);
        }
        lost
    }

    fn begin(&mut self) {
        self.seen = false;
        self.last_pulse.clear();
    }
}

/// Memory of a CSM call.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Csm {
    latch: FaultLatch,
    phase: Phase,
    request: Edge,
    a: Train,
    b: Train,
    /// Since the last activity of either channel, or since the first scan that could see one.
    still: Timer,
    /// `t0`: since the request began or ended.
    since: Timer,
    start_ms: i32,
    stop_ms: i32,
}

crate::bits!(Csm { latch, phase, request, a, b, still, since, start_ms, stop_ms });

/// What a scan reads.
struct Inputs {
    delay_ms: i32,
    period_ms: i32,
    request: bool,
    request_rises: bool,
    a: Change,
    b: Change,
    quiet: bool,
}

impl Csm {
    pub(crate) fn prescan(&mut self, members: &mut Members) {
        *self = Csm::default();
        clear_outputs(members);
    }

    pub(crate) fn scan(&mut self, rung: bool, now_ms: i64, members: &mut Members) {
        if !rung {
            // A false rung is as prescan, a latched fault included (1.3).
            self.prescan(members);
            return;
        }
        let status = Status { input: members[INPUT_STATUS] != 0, output: true, reset: members[RESET] != 0 };
        let lost = self.latch.begin(&status);
        let inputs = self.read(members, status.input, now_ms);
        let in_range = RANGE_MS.contains(&inputs.delay_ms) && RANGE_MS.contains(&inputs.period_ms);
        let new_fault = if lost != NONE {
            lost
        } else if !in_range {
            OUT_OF_RANGE
        } else if status.input && self.latch.fault == NONE {
            self.step(&inputs, now_ms)
        } else {
            NONE
        };
        let cause_gone = !inputs.request && inputs.quiet && status.input && in_range;
        self.latch.settle(new_fault, cause_gone);
        if self.latch.fault != NONE {
            self.phase = Phase::Stopped;
        }
        let moves = match self.phase {
            Phase::Stopped => false,
            Phase::Running => true,
            // Shown early and taken back late.
            Phase::Starting | Phase::Stopping => !inputs.quiet,
        };
        let waits = self.phase == Phase::Stopped && inputs.request;
        let own = if waits { REQUEST_ON_AT_START } else { NONE };
        members[O1] = i32::from(moves);
        members[FP] = i32::from(self.latch.fault != NONE);
        members[MEASURED_START_TIME] = self.start_ms;
        members[MEASURED_STOP_TIME] = self.stop_ms;
        members[FAULT_CODE] = self.latch.fault;
        members[DIAGNOSTIC_CODE] = self.latch.diagnostic(&status, cause_gone, own);
    }

    fn read(&mut self, members: &Members, valid: bool, now_ms: i64) -> Inputs {
        let request = members[MOTION_REQUEST] != 0;
        let request_rises = self.request.rises(request);
        let period_ms = members[MAX_PULSE_PERIOD];
        if !valid {
            // The first scan with Input Status sees no edges.
            self.a.level = None;
            self.b.level = None;
            self.still.clear();
        }
        let still = Change { pulse: false, activity: false };
        let a = if valid { self.a.sample(members[CHANNEL_A] != 0) } else { still };
        let b = if valid { self.b.sample(members[CHANNEL_B] != 0) } else { still };
        if a.activity || b.activity {
            self.still.restart(now_ms);
        } else if valid {
            self.still.start(now_ms);
        }
        let quiet = self.still.reached(now_ms, period_ms);
        Inputs { delay_ms: members[MECHANICAL_DELAY_TIME], period_ms, request, request_rises, a, b, quiet }
    }

    /// One scan of the table of 7; gives a fault or 0.
    fn step(&mut self, inputs: &Inputs, now_ms: i64) -> i32 {
        let before = self.phase;
        let fault = match before {
            Phase::Stopped => self.stopped(inputs),
            Phase::Starting => self.starting(inputs, now_ms),
            Phase::Running => self.running(inputs, now_ms),
            Phase::Stopping => self.stopping(inputs, now_ms),
        };
        if fault != NONE {
            return fault;
        }
        match self.phase {
            // The rows of STOPPING in their order: a request that comes in the scan of rest must be given again.
            Phase::Stopped | Phase::Stopping if inputs.request_rises && self.phase == before => {
                self.phase = Phase::Starting;
                self.since.restart(now_ms);
                self.a.begin();
                self.b.begin();
            }
            Phase::Starting | Phase::Running if !inputs.request => {
                self.phase = Phase::Stopping;
                self.since.restart(now_ms);
            }
            _ => {}
        }
        NONE
    }

    /// A pulse in the scan of the request is ignored.
    fn stopped(&self, inputs: &Inputs) -> i32 {
        if (inputs.a.pulse || inputs.b.pulse) && !inputs.request_rises { NOT_REQUESTED } else { NONE }
    }

    fn starting(&mut self, inputs: &Inputs, now_ms: i64) -> i32 {
        let in_time = !self.since.exceeded(now_ms, inputs.delay_ms);
        self.a.follow(inputs.a.pulse, now_ms, inputs.period_ms);
        self.b.follow(inputs.b.pulse, now_ms, inputs.period_ms);
        self.a.seen |= inputs.a.pulse && in_time;
        self.b.seen |= inputs.b.pulse && in_time;
        if self.a.seen && self.b.seen {
            self.phase = Phase::Running;
            self.start_ms = whole_ms(self.since.elapsed_ms(now_ms));
        } else if self.since.reached(now_ms, inputs.delay_ms) {
            return NO_START.code(!self.a.seen, !self.b.seen);
        }
        NONE
    }

    fn running(&mut self, inputs: &Inputs, now_ms: i64) -> i32 {
        let a_lost = self.a.follow(inputs.a.pulse, now_ms, inputs.period_ms);
        let b_lost = self.b.follow(inputs.b.pulse, now_ms, inputs.period_ms);
        PULSES_LOST.code(a_lost, b_lost)
    }

    fn stopping(&mut self, inputs: &Inputs, now_ms: i64) -> i32 {
        if inputs.quiet {
            self.phase = Phase::Stopped;
            let since_request_ms = self.since.elapsed_ms(now_ms).unwrap_or(0);
            let still_ms = self.still.elapsed_ms(now_ms).unwrap_or(0);
            self.stop_ms = whole_ms(Some(since_request_ms.saturating_sub(still_ms).max(0)));
        } else if (inputs.a.activity || inputs.b.activity) && self.since.exceeded(now_ms, inputs.delay_ms) {
            return STOP_TOO_SLOW;
        }
        NONE
    }
}

fn whole_ms(elapsed_ms: Option<i64>) -> i32 {
    i32::try_from(elapsed_ms.unwrap_or(0)).unwrap_or(i32::MAX)
}
