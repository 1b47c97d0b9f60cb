//! What DCA and DCAF share: everything but the arithmetic. `muting-and-outputs.md` 8.4, 8.5.

use crate::codes::{INPUT_STATUS, NONE, RESET_HELD};
use crate::edge::Edge;
use crate::restart::AUTOMATIC_RESTART_MS;
use crate::timer::Timer;

/// Fault: the channels differed by more than Tolerance for Discrepancy Time. 8.5, number decided, cause recalled 85 %.
const DISCREPANCY: i32 = 0xF070;
/// Fault: Tolerance or limits not usable. 8.5, decided.
const NOT_USABLE: i32 = 0xF071;
/// Fault: a channel is not a finite number. 8.5, decided.
const NOT_FINITE: i32 = 0xF072;
/// Diagnostic: a channel is above the high limit. 8.5, decided.
const ABOVE: i32 = 0xF170;
/// Diagnostic: a channel is below the low limit. 8.5, decided.
const BELOW: i32 = 0xF171;
/// Diagnostic: deviation above Tolerance now. 8.5, decided.
const DEVIATION: i32 = 0xF172;
/// Diagnostic: press Reset, restart or fault. 8.5, decided.
const PRESS_RESET: i32 = 0xF173;
/// Diagnostic: press Reset, cold start. 8.5, decided.
const PRESS_RESET_COLD: i32 = 0xF174;

/// The member `Revision`. 8.2, decided.
pub(crate) const REVISION: i32 = 1;

/// What the arithmetic of one scan says (8.1, 8.3).
#[derive(Clone, Copy, Debug)]
pub(crate) struct Reading {
    /// Tolerance and limits can be used.
    pub(crate) usable: bool,
    /// Both channels are finite numbers.
    pub(crate) finite: bool,
    /// Both channels are within the limits.
    pub(crate) in_range: bool,
    /// The channels differ by at most Tolerance.
    pub(crate) agree: bool,
    /// HTP.
    pub(crate) above: bool,
    /// LTP.
    pub(crate) below: bool,
}

/// What both read beside the values.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Inputs {
    pub(crate) restart_automatic: bool,
    pub(crate) cold_start_automatic: bool,
    pub(crate) discrepancy_ms: i32,
    pub(crate) input_status: bool,
    pub(crate) reset: bool,
}

/// Memory of both; its default is the state after prescan.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct AnalogPair {
    /// O1.
    pub(crate) on: bool,
    /// The latched fault code, 0 without one.
    pub(crate) fault: i32,
    cold: bool,
    discrepancy: Timer,
    on_delay: Timer,
    reset: Edge,
    input_status_before: bool,
}

crate::bits!(AnalogPair { on, fault, cold, discrepancy, on_delay, reset, input_status_before });

impl Default for AnalogPair {
    fn default() -> Self {
        AnalogPair {
            on: false,
            fault: NONE,
            cold: true,
            discrepancy: Timer::default(),
            on_delay: Timer::default(),
            reset: Edge::default(),
            input_status_before: false,
        }
    }
}

impl AnalogPair {
    /// As after prescan, but a latched fault is kept and there is no cold-start shortcut on return (1.3, 8.4).
    pub(crate) fn rung_false(&mut self, inputs: &Inputs) {
        *self = AnalogPair { fault: self.fault, cold: !inputs.cold_start_automatic, ..AnalogPair::default() };
    }

    /// One scan with a true rung, steps 1 to 7 of 8.4; gives DiagnosticCode.
    pub(crate) fn scan(&mut self, inputs: &Inputs, reading: &Reading, now_ms: i64) -> i32 {
        let rise = self.reset.rises(inputs.reset);
        let new_fault = self.detect(inputs, reading, now_ms);
        let consumed = if self.fault == NONE {
            self.fault = new_fault;
            false
        } else {
            rise && self.clear_fault(inputs, reading)
        };
        let ok = inputs.input_status && self.fault == NONE && reading.in_range && reading.agree;
        if self.cold && inputs.cold_start_automatic && inputs.input_status && self.fault == NONE {
            // This scan only; otherwise the chance is gone and Restart Type rules.
            self.on |= ok;
            self.cold = false;
        }
        let needs_reset = self.cold || !inputs.restart_automatic;
        if !ok {
            self.on = false;
            self.on_delay.clear();
        } else if !self.on {
            self.on_delay.start(now_ms);
            self.on = if needs_reset {
                // The conditions held in an earlier scan as well.
                rise && !consumed && self.on_delay.exceeded(now_ms, 0)
            } else {
                self.on_delay.reached(now_ms, AUTOMATIC_RESTART_MS)
            };
        }
        self.cold &= !self.on;
        let awaited = self.fault != NONE || (ok && !self.on && needs_reset);
        self.diagnostic(inputs, reading, awaited, consumed)
    }

    /// The member `O1OnTime`: elapsed part of the on-delay, all of it while O1 is on (8.2, decided).
    pub(crate) fn on_time_ms(&self, now_ms: i64) -> i32 {
        if self.on {
            return AUTOMATIC_RESTART_MS;
        }
        let elapsed_ms = self.on_delay.elapsed_ms(now_ms).unwrap_or(0);
        i32::try_from(elapsed_ms).unwrap_or(AUTOMATIC_RESTART_MS).min(AUTOMATIC_RESTART_MS)
    }

    /// Step 1: this scan's fault or 0.
    fn detect(&mut self, inputs: &Inputs, reading: &Reading, now_ms: i64) -> i32 {
        let lost = self.input_status_before && !inputs.input_status;
        self.input_status_before = inputs.input_status;
        self.discrepancy.follow(inputs.input_status && !reading.agree, now_ms);
        self.cold |= !inputs.input_status;
        if !reading.usable {
            NOT_USABLE
        } else if lost {
            INPUT_STATUS
        } else if inputs.input_status && !reading.finite {
            NOT_FINITE
        } else if self.discrepancy.reached(now_ms, inputs.discrepancy_ms) {
            DISCREPANCY
        } else {
            NONE
        }
    }

    /// Step 3: whether the Reset edge was consumed.
    fn clear_fault(&mut self, inputs: &Inputs, reading: &Reading) -> bool {
        let cause_gone =
            inputs.input_status && reading.finite && reading.usable && (reading.agree || self.fault != DISCREPANCY);
        if cause_gone {
            self.cold |= self.fault == INPUT_STATUS;
            self.fault = NONE;
        }
        cause_gone
    }

    fn diagnostic(&self, inputs: &Inputs, reading: &Reading, awaited: bool, consumed: bool) -> i32 {
        if !inputs.input_status {
            INPUT_STATUS
        } else if awaited && inputs.reset && !consumed {
            RESET_HELD
        } else if reading.above {
            ABOVE
        } else if reading.below {
            BELOW
        } else if !reading.agree {
            DEVIATION
        } else if awaited && self.cold && self.fault == NONE {
            PRESS_RESET_COLD
        } else if awaited {
            PRESS_RESET
        } else {
            NONE
        }
    }
}

/// The members that both instructions have, with `read` and `write` for them, and the memory of a call.
macro_rules! analog_instruction {
    ($(#[$doc:meta])* $name:ident, $backing:path) => {
        crate::members::members! {
            $backing;
            inputs {
                RESTART_TYPE = "RestartType",
                COLD_START_TYPE = "ColdStartType",
                DISCREPANCY_TIME = "DiscrepancyTime",
                TOLERANCE = "Tolerance",
                HIGH_LIMIT = "HighLimit",
                LOW_LIMIT = "LowLimit",
                CHANNEL_A = "ChannelA",
                CHANNEL_B = "ChannelB",
                INPUT_STATUS = "InputStatus",
                RESET = "Reset",
            }
            outputs {
                O1 = "O1",
                FP = "FP",
                HTP = "HTP",
                LTP = "LTP",
                O1_ON_TIME = "O1OnTime",
                FAULT_CODE = "FaultCode",
                DIAGNOSTIC_CODE = "DiagnosticCode",
                REVISION = "Revision",
            }
        }

        $(#[$doc])*
        #[derive(Clone, Debug, Default, PartialEq)]
        pub struct $name {
            pair: $crate::analog::pair::AnalogPair,
        }

        $crate::bits!($name { pair });

        impl $name {
            pub(crate) fn prescan(&mut self, members: &mut Members) {
                *self = $name::default();
                self.rest(members);
            }

            pub(crate) fn scan(&mut self, rung: bool, now_ms: i64, members: &mut Members) {
                let inputs = $crate::analog::pair::Inputs {
                    restart_automatic: members[RESTART_TYPE] != 0,
                    cold_start_automatic: members[COLD_START_TYPE] != 0,
                    discrepancy_ms: members[DISCREPANCY_TIME],
                    input_status: members[INPUT_STATUS] != 0,
                    reset: members[RESET] != 0,
                };
                if !rung {
                    self.pair.rung_false(&inputs);
                    self.rest(members);
                    return;
                }
                let reading = reading(members);
                let diagnostic = self.pair.scan(&inputs, &reading, now_ms);
                members[O1] = i32::from(self.pair.on);
                members[FP] = i32::from(self.pair.fault != $crate::codes::NONE);
                members[HTP] = i32::from(reading.above);
                members[LTP] = i32::from(reading.below);
                members[O1_ON_TIME] = self.pair.on_time_ms(now_ms);
                members[FAULT_CODE] = self.pair.fault;
                members[DIAGNOSTIC_CODE] = diagnostic;
                members[REVISION] = $crate::analog::pair::REVISION;
            }

            /// What prescan and a false rung show.
            fn rest(&self, members: &mut Members) {
                clear_outputs(members);
                members[REVISION] = $crate::analog::pair::REVISION;
            }
        }
    };
}

pub(crate) use analog_instruction;
