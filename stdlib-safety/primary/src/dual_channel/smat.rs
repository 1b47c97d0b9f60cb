//! SMAT, Safety Mat. `dual-channel-inputs.md` 9.

use crate::codes::{self, NONE, RESET_HELD};
use crate::edge::Edge;
use crate::members::members;
use crate::restart::AUTOMATIC_RESTART_MS;
use crate::timer::Timer;
use twinrung_catalog::types::safety::dual_channel::SAFETY_MAT;

members! {
    SAFETY_MAT;
    inputs {
        RESTART_TYPE = "RestartType",
        SHORT_CIRCUIT_DETECT_DELAY_TIME = "ShortCircuitDetectDelayTime",
        CHANNEL_A = "ChannelA",
        CHANNEL_B = "ChannelB",
        INPUT_STATUS = "InputStatus",
        RESET = "Reset",
    }
    outputs {
        O1 = "O1",
        SRCA = "SRCA",
        SRCB = "SRCB",
        FP = "FP",
        FAULT_CODE = "FaultCode",
        DIAGNOSTIC_CODE = "DiagnosticCode",
    }
}

/// How long a source stays on. 9.4, decided D35.
const DWELL_MS: i32 = 100;
/// Healthy source steps in a row that verify the circuits: one of each source. 9.4, decided D35.
const VERIFIED: u8 = 2;

/// Fault: Channel A shorted to power. 9.5, class study ST-SMAT, number D15.
const A_TO_POWER: i32 = 0xF040;
/// Fault: Channel B shorted to power. 9.5, number D15.
const B_TO_POWER: i32 = 0xF041;
/// Fault: both shorted to power. 9.5, number D15.
const BOTH_TO_POWER: i32 = 0xF042;
/// Fault: A shorted to power, B open or to ground. 9.5, number D15.
const A_TO_POWER_B_OPEN: i32 = 0xF043;
/// Fault: B shorted to power, A open or to ground. 9.5, number D15.
const B_TO_POWER_A_OPEN: i32 = 0xF044;
/// Fault: A open or shorted to ground. 9.5, number D15.
const A_OPEN: i32 = 0xF045;
/// Fault: B open or shorted to ground. 9.5, number D15.
const B_OPEN: i32 = 0xF046;
/// Diagnostic: mat occupied, or plates shorted together. 1.9, decided.
const OCCUPIED: i32 = 0xF140;
/// Diagnostic: circuit verification not complete. 1.9, decided.
const NOT_VERIFIED: i32 = 0xF141;

/// The four steps of the source scheme, in order.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum Step {
    /// Z1: both sources off, source A next.
    #[default]
    OffBeforeA,
    /// SA: source A on.
    SourceA,
    /// Z2: both sources off, source B next.
    OffBeforeB,
    /// SB: source B on.
    SourceB,
}

crate::bits!(
    enum Step {
        OffBeforeA,
        SourceA,
        OffBeforeB,
        SourceB,
    }
);

impl Step {
    fn next(self) -> Step {
        match self {
            Step::OffBeforeA => Step::SourceA,
            Step::SourceA => Step::OffBeforeB,
            Step::OffBeforeB => Step::SourceB,
            Step::SourceB => Step::OffBeforeA,
        }
    }
}

/// What `begin()` of the reference sets up; its default is the state after it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Verification {
    step: Step,
    /// Since when this step lasts; does not run before the first scan.
    in_step: Timer,
    /// The driven channel answered in this step.
    confirmed: bool,
    /// Since when the driven channel is missing.
    lost: Timer,
    /// Healthy source steps in a row.
    clean: u8,
    occupied: bool,
    granted: bool,
    automatic: Timer,
    ready_before: bool,
}

crate::bits!(Verification { step, in_step, confirmed, lost, clean, occupied, granted, automatic, ready_before });

/// Memory of an SMAT call.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Smat {
    verification: Verification,
    fault: i32,
    reset: Edge,
    valid: bool,
}

crate::bits!(Smat { verification, fault, reset, valid });

/// What a scan reads.
struct Inputs {
    automatic: bool,
    delay_ms: i32,
    a: bool,
    b: bool,
    reset: bool,
}

impl Smat {
    pub(crate) fn prescan(&mut self, members: &mut Members) {
        *self = Smat::default();
        clear_outputs(members);
    }

    pub(crate) fn scan(&mut self, rung: bool, now_ms: i64, members: &mut Members) {
        let input_status = members[INPUT_STATUS] != 0;
        if !rung {
            self.verification = Verification::default();
            self.reset = Edge::default();
            self.valid &= input_status;
            clear_outputs(members);
            return;
        }
        let inputs = Inputs {
            automatic: members[RESTART_TYPE] != 0,
            delay_ms: members[SHORT_CIRCUIT_DETECT_DELAY_TIME],
            a: members[CHANNEL_A] != 0,
            b: members[CHANNEL_B] != 0,
            reset: members[RESET] != 0,
        };
        let rise = self.reset.rises(inputs.reset);
        let diagnostic = if input_status {
            self.valid = true;
            self.evaluate(&inputs, rise, now_ms);
            self.diagnostic(&inputs)
        } else {
            self.verification = Verification::default();
            if self.valid && self.fault == NONE {
                self.fault = codes::INPUT_STATUS;
            }
            self.valid = false;
            codes::INPUT_STATUS
        };
        let Verification { step, granted, .. } = self.verification;
        members[O1] = i32::from(granted);
        members[SRCA] = i32::from(step == Step::SourceA);
        members[SRCB] = i32::from(step == Step::SourceB);
        members[FP] = i32::from(self.fault != NONE);
        members[FAULT_CODE] = self.fault;
        members[DIAGNOSTIC_CODE] = diagnostic;
    }

    /// The scan with Input Status valid.
    fn evaluate(&mut self, inputs: &Inputs, rise: bool, now_ms: i64) {
        if self.fault != NONE {
            // Decided D36: Reset is always accepted and the verification restarts; the edge does not restart O1 (D8).
            if !rise {
                return;
            }
            self.fault = NONE;
        }
        let fault = self.verification.judge(inputs, now_ms);
        if fault == NONE {
            self.verification.decide(inputs, rise, now_ms);
        } else {
            self.fault = fault;
            self.verification = Verification::default();
        }
    }

    fn diagnostic(&self, inputs: &Inputs) -> i32 {
        let verification = &self.verification;
        if self.fault != NONE {
            return if inputs.reset { RESET_HELD } else { NONE };
        }
        if verification.occupied {
            OCCUPIED
        } else if verification.clean < VERIFIED {
            NOT_VERIFIED
        } else if !inputs.automatic && !verification.granted && inputs.reset {
            RESET_HELD
        } else {
            NONE
        }
    }
}

impl Verification {
    /// Judges the inputs against the sources commanded at the end of the previous scan; gives a fault or 0.
    fn judge(&mut self, inputs: &Inputs, now_ms: i64) -> i32 {
        if !self.in_step.runs() {
            // First scan: the sources were off or unknown.
            self.in_step.restart(now_ms);
            return NONE;
        }
        let Inputs { delay_ms, a, b, .. } = *inputs;
        match self.step {
            Step::OffBeforeA | Step::OffBeforeB => self.judge_off(a, b, delay_ms, now_ms),
            Step::SourceA => self.judge_source(a, b, delay_ms, [A_OPEN, B_TO_POWER_A_OPEN], now_ms),
            Step::SourceB => self.judge_source(b, a, delay_ms, [B_OPEN, A_TO_POWER_B_OPEN], now_ms),
        }
    }

    /// Both sources off: both channels must read 0.
    fn judge_off(&mut self, a: bool, b: bool, delay_ms: i32, now_ms: i64) -> i32 {
        let fault = match (a, b) {
            (false, false) => {
                self.advance(now_ms);
                return NONE;
            }
            (true, false) => A_TO_POWER,
            (false, true) => B_TO_POWER,
            (true, true) => BOTH_TO_POWER,
        };
        if self.in_step.reached(now_ms, delay_ms) { fault } else { NONE }
    }

    /// One source on: its channel must read 1, the other one 0. `missing` are the codes for the missing channel, with
    /// the other channel at 0 and at 1.
    fn judge_source(&mut self, own: bool, other: bool, delay_ms: i32, missing: [i32; 2], now_ms: i64) -> i32 {
        if own {
            self.confirmed = true;
            self.lost.clear();
            if other {
                self.occupied = true;
                self.clean = 0;
            }
            if self.in_step.reached(now_ms, DWELL_MS) {
                if !other {
                    self.clean = self.clean.saturating_add(1).min(VERIFIED);
                }
                self.occupied &= self.clean < VERIFIED;
                self.advance(now_ms);
            }
            return NONE;
        }
        if self.confirmed {
            self.clean = 0;
            self.lost.start(now_ms);
        } else {
            self.lost = self.in_step;
        }
        let [alone, with_other] = missing;
        match (self.lost.reached(now_ms, delay_ms), other) {
            (false, _) => NONE,
            (true, false) => alone,
            (true, true) => with_other,
        }
    }

    fn advance(&mut self, now_ms: i64) {
        self.step = self.step.next();
        self.in_step.restart(now_ms);
        self.confirmed = false;
        self.lost.clear();
    }

    /// Grants O1 or takes it back.
    fn decide(&mut self, inputs: &Inputs, rise: bool, now_ms: i64) {
        let ready = self.clean == VERIFIED && !self.occupied;
        self.automatic.follow(ready, now_ms);
        let restarts = if inputs.automatic {
            self.automatic.reached(now_ms, AUTOMATIC_RESTART_MS)
        } else {
            rise && self.ready_before
        };
        self.granted = ready && (self.granted || restarts);
        self.ready_before = ready;
    }
}
