//! The core of DCS, DCST, DCSTL and DCSTM. `dual-channel-inputs.md` 4.4.
//!
//! A scan passes through [`Stop::begin`], [`Stop::judge`] and [`Stop::decide`]; between them each instruction does what
//! it has beyond DCS.

use super::dcstm::{NOT_ACTIVE_AFTER_TEST, NOT_SAFE_IN_TEST};
use super::pair::{CYCLE_A, CYCLE_B, Channels, Consistency, DISCREPANCY_A_ACTIVE, DISCREPANCY_B_ACTIVE, Pair};
use crate::codes::{INPUT_STATUS, NONE, RESET_HELD};
use crate::edge::Edge;
use crate::restart::AUTOMATIC_RESTART_MS;
use crate::timer::Timer;

/// Diagnostic: the functional test of the device is outstanding. dual-channel-inputs.md 1.9, recalled-low, use decided D18.
pub(crate) const TEST_OUTSTANDING: i32 = 0x4000;

/// What the family reads in every scan.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Inputs {
    pub(crate) input_type: i32,
    pub(crate) discrepancy_ms: i32,
    /// Restart Type: MANUAL 0, AUTOMATIC 1. dual-channel-inputs.md 1.3.
    pub(crate) restart_automatic: bool,
    /// Cold Start Type: MANUAL 0, AUTOMATIC 1. dual-channel-inputs.md 1.3.
    pub(crate) cold_start_automatic: bool,
    pub(crate) channel_a: bool,
    pub(crate) channel_b: bool,
    pub(crate) input_status: bool,
    pub(crate) reset: bool,
}

/// What one scan has found so far.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Found {
    pub(crate) pair: Consistency,
    pub(crate) channel_fault: i32,
    rise: bool,
    cold_grant: bool,
}

/// Memory of the family; its default is the state after prescan.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Stop {
    pair: Pair,
    reset: Edge,
    /// The latched fault code, 0 without one.
    pub(crate) fault: i32,
    /// Both channels were seen safe since the fault (`cyc`).
    cycled: bool,
    /// Input Status was valid.
    valid: bool,
    /// The cold-start rule is pending.
    cold: bool,
    /// A functional test of the device is outstanding.
    pub(crate) test: bool,
    /// O1 is released; it is on while there is no fault.
    pub(crate) granted: bool,
    automatic: Timer,
    ready_before: bool,
}

crate::bits!(Stop { pair, reset, fault, cycled, valid, cold, test, granted, automatic, ready_before });

impl Default for Stop {
    fn default() -> Self {
        Stop {
            pair: Pair::default(),
            reset: Edge::default(),
            fault: NONE,
            cycled: false,
            valid: false,
            cold: true,
            test: false,
            granted: false,
            automatic: Timer::default(),
            ready_before: false,
        }
    }
}

impl Stop {
    /// Rung false (1.8, decided D13): everything is dropped but a latched fault and an outstanding test, and the
    /// cold-start shortcut is gone.
    pub(crate) fn rung_false(&mut self, inputs: &Inputs) {
        self.drop_grant();
        self.pair = Pair::default();
        self.reset = Edge::default();
        self.cold = false;
        if self.valid && !inputs.input_status {
            self.valid = false;
            self.test |= !inputs.cold_start_automatic;
        }
    }

    /// Input Status, then the pair, then the cold-start rule. `None` while Input Status is OFF: nothing else is
    /// evaluated then (decided D9).
    pub(crate) fn begin(&mut self, inputs: &Inputs, now_ms: i64) -> Option<Found> {
        let rise = self.reset.rises(inputs.reset);
        if !inputs.input_status {
            self.pair = Pair::default();
            self.drop_grant();
            if self.valid {
                self.cold = true;
                if self.fault == NONE {
                    self.fault = INPUT_STATUS;
                }
            }
            self.valid = false;
            return None;
        }
        self.valid = true;
        let channels = Channels::read(inputs.input_type, inputs.channel_a, inputs.channel_b);
        let (pair, channel_fault) = self.pair.evaluate(channels, now_ms, inputs.discrepancy_ms);
        let cold_grant = self.fault == NONE && self.apply_cold_start(inputs);
        if pair == Consistency::Safe {
            self.test = false;
            self.cycled = true;
        }
        Some(Found { pair, channel_fault, rise, cold_grant })
    }

    /// Hook T: a test is demanded, O1 drops (decided D21).
    pub(crate) fn demand_test(&mut self) {
        self.test = true;
        self.granted = false;
    }

    /// Latches the first fault (decided D16): the channels' before `extra`, the instruction's own. Or clears the
    /// latched one by a Reset edge, when `clearable` says that the instruction's own conditions for it hold.
    pub(crate) fn judge(&mut self, found: &mut Found, inputs: &Inputs, extra: i32, clearable: bool) {
        let new_fault = if found.channel_fault == NONE { extra } else { found.channel_fault };
        if self.fault == NONE {
            if new_fault != NONE {
                self.fault = new_fault;
                self.cycled = !demands_cycle(new_fault);
                self.drop_grant();
                found.cold_grant = false;
            }
            return;
        }
        if found.channel_fault != NONE {
            self.cycled = false;
        }
        if found.rise && clearable && self.may_clear(found) {
            self.clear_fault(found, inputs);
        }
    }

    /// Grants O1 or takes it back. `extra_ok` are the instruction's own enabling conditions; `hold` keeps an O1 that is
    /// on while the pair is not active (muting).
    pub(crate) fn decide(&mut self, found: &Found, inputs: &Inputs, now_ms: i64, extra_ok: bool, hold: bool) {
        if self.fault != NONE {
            return;
        }
        if self.ready(found, extra_ok) {
            if !self.granted {
                self.granted = found.cold_grant || self.restarts(found, inputs, now_ms);
            }
            self.ready_before = true;
        } else if self.granted && hold && !self.test {
            self.ready_before = false;
        } else {
            self.drop_grant();
        }
    }

    /// O1.
    pub(crate) fn output(&self) -> bool {
        self.granted && self.fault == NONE
    }

    /// DiagnosticCode while Input Status is valid; `own` is the instruction's diagnostic, shown last and without a fault only.
    pub(crate) fn diagnostic(&self, found: &Found, inputs: &Inputs, extra_ok: bool, own: i32) -> i32 {
        let faulted = self.fault != NONE;
        let waiting = faulted || (!inputs.restart_automatic && self.ready(found, extra_ok) && !self.granted);
        if inputs.reset && waiting {
            RESET_HELD
        } else if faulted {
            NONE
        } else if self.test {
            TEST_OUTSTANDING
        } else {
            own
        }
    }

    fn ready(&self, found: &Found, extra_ok: bool) -> bool {
        found.pair == Consistency::Active && !self.test && extra_ok
    }

    fn restarts(&mut self, found: &Found, inputs: &Inputs, now_ms: i64) -> bool {
        if inputs.restart_automatic {
            self.automatic.start(now_ms);
            self.automatic.reached(now_ms, AUTOMATIC_RESTART_MS)
        } else {
            // Decided D7: the conditions must have held in the previous scan as well.
            found.rise && self.ready_before
        }
    }

    /// `apply_cold()`: whether O1 may turn on at once in this scan (1.7, decided D10).
    fn apply_cold_start(&mut self, inputs: &Inputs) -> bool {
        if !self.cold {
            return false;
        }
        self.cold = false;
        self.test |= !inputs.cold_start_automatic;
        inputs.cold_start_automatic
    }

    fn may_clear(&self, found: &Found) -> bool {
        self.fault == INPUT_STATUS
            || (self.cycled && found.pair != Consistency::Discrepant && found.channel_fault == NONE)
    }

    fn clear_fault(&mut self, found: &mut Found, inputs: &Inputs) {
        let granted_by_cold_start = self.apply_cold_start(inputs);
        found.cold_grant = granted_by_cold_start && self.fault == INPUT_STATUS;
        self.fault = NONE;
        // Decided D8: the edge that clears does not restart.
        found.rise = false;
        if found.pair == Consistency::Safe {
            self.test = false;
        }
    }

    fn drop_grant(&mut self) {
        self.granted = false;
        self.automatic.clear();
        self.ready_before = false;
    }
}

/// Whether both channels must be seen safe after this fault before a Reset clears it (4.4).
fn demands_cycle(fault: i32) -> bool {
    matches!(
        fault,
        DISCREPANCY_A_ACTIVE | DISCREPANCY_B_ACTIVE | CYCLE_A | CYCLE_B | NOT_SAFE_IN_TEST | NOT_ACTIVE_AFTER_TEST
    )
}

/// [`members!`](crate::members::members) with the members that the whole family has, and `read` and `write` for them.
macro_rules! stop_members {
    (
        $backing:path;
        inputs { $($input:ident = $input_name:literal),* $(,)? }
        outputs { $($output:ident = $output_name:literal),* $(,)? }
    ) => {
        crate::members::members! {
            $backing;
            inputs {
                INPUT_TYPE = "InputType",
                DISCREPANCY_TIME = "DiscrepancyTime",
                RESTART_TYPE = "RestartType",
                COLD_START_TYPE = "ColdStartType",
                CHANNEL_A = "ChannelA",
                CHANNEL_B = "ChannelB",
                INPUT_STATUS = "InputStatus",
                RESET = "Reset",
                $($input = $input_name,)*
            }
            outputs {
                O1 = "O1",
                FP = "FP",
                FAULT_CODE = "FaultCode",
                DIAGNOSTIC_CODE = "DiagnosticCode",
                $($output = $output_name,)*
            }
        }

        fn read(members: &Members) -> $crate::dual_channel::stop::Inputs {
            $crate::dual_channel::stop::Inputs {
                input_type: members[INPUT_TYPE],
                discrepancy_ms: members[DISCREPANCY_TIME],
                restart_automatic: members[RESTART_TYPE] != 0,
                cold_start_automatic: members[COLD_START_TYPE] != 0,
                channel_a: members[CHANNEL_A] != 0,
                channel_b: members[CHANNEL_B] != 0,
                input_status: members[INPUT_STATUS] != 0,
                reset: members[RESET] != 0,
            }
        }

        fn write(stop: &$crate::dual_channel::stop::Stop, diagnostic: i32, members: &mut Members) {
            members[O1] = i32::from(stop.output());
            members[FP] = i32::from(stop.fault != $crate::codes::NONE);
            members[FAULT_CODE] = stop.fault;
            members[DIAGNOSTIC_CODE] = diagnostic;
        }
    };
}

pub(crate) use stop_members;
