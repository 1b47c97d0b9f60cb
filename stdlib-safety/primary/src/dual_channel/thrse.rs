//! THRSe, Two-Hand Run Station Enhanced. `dual-channel-inputs.md` 10.

use crate::codes::{self, NONE, NOT_ARMED, RESET_HELD};
use crate::edge::Edge;
use crate::members::members;
use crate::timer::Timer;
use twinrung_catalog::types::safety::dual_channel::THRS_ENHANCED;

members! {
    THRS_ENHANCED;
    inputs {
        DISCREPANCY_TIME = "DiscrepancyTime",
        ENABLE = "Enable",
        DISCONNECTED = "Disconnected",
        RIGHT_NO = "RightButtonNormallyOpen",
        RIGHT_NC = "RightButtonNormallyClosed",
        LEFT_NO = "LeftButtonNormallyOpen",
        LEFT_NC = "LeftButtonNormallyClosed",
        INPUT_STATUS = "InputStatus",
        RESET = "Reset",
    }
    outputs {
        O1 = "O1",
        BR = "BR",
        SB = "SB",
        FP = "FP",
        FAULT_CODE = "FaultCode",
        DIAGNOSTIC_CODE = "DiagnosticCode",
    }
}

/// Longest time between the two hands; exactly this is accepted. 10.1, doc HELP-THRSE.
const BETWEEN_HANDS_MS: i32 = 500;

/// Fault: right contacts both OFF. 10.5, decided D15.
const RIGHT_BOTH_OFF: i32 = 0xF030;
/// Fault: right contacts both ON. 10.5, decided D15.
const RIGHT_BOTH_ON: i32 = 0xF031;
/// Fault: left contacts both OFF. 10.5, decided D15.
const LEFT_BOTH_OFF: i32 = 0xF032;
/// Fault: left contacts both ON. 10.5, decided D15.
const LEFT_BOTH_ON: i32 = 0xF033;
/// Fault: Disconnected with contacts not all OFF. 10.5, decided D15.
const DISCONNECTED_NOT_OFF: i32 = 0xF034;
/// Diagnostic: second button later than 500 ms. 1.9, decided.
const SECOND_HAND_LATE: i32 = 0xF131;

/// One button with a normally open and a normally closed contact.
#[derive(Clone, Copy)]
struct Button {
    open: bool,
    closed: bool,
}

impl Button {
    fn pressed(self) -> bool {
        self.open && !self.closed
    }

    fn released(self) -> bool {
        !self.open && self.closed
    }

    fn discrepant(self) -> bool {
        self.open == self.closed
    }

    fn both_off(self) -> bool {
        !self.open && !self.closed
    }
}

/// What a scan reads.
struct Inputs {
    discrepancy_ms: i32,
    enable: bool,
    disconnected: bool,
    right: Button,
    left: Button,
    input_status: bool,
    reset: bool,
}

impl Inputs {
    fn all_off(&self) -> bool {
        self.right.both_off() && self.left.both_off()
    }

    fn both_released(&self) -> bool {
        self.right.released() && self.left.released()
    }

    fn both_pressed(&self) -> bool {
        self.right.pressed() && self.left.pressed()
    }
}

/// What the hands have done so far.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Hands {
    /// Both buttons were released; the next press may start.
    armed: bool,
    /// O1 is on.
    granted: bool,
    /// The second hand came too late (`tie`).
    late: bool,
    /// Since when a button is pressed (`tf`).
    first_press: Timer,
}

crate::bits!(Hands { armed, granted, late, first_press });

/// Memory of a THRSe call.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Thrse {
    hands: Hands,
    right: Timer,
    left: Timer,
    disconnection: Timer,
    fault: i32,
    valid: bool,
    reset: Edge,
}

crate::bits!(Thrse { hands, right, left, disconnection, fault, valid, reset });

impl Thrse {
    pub(crate) fn prescan(&mut self, members: &mut Members) {
        *self = Thrse::default();
        clear_outputs(members);
    }

    pub(crate) fn scan(&mut self, rung: bool, now_ms: i64, members: &mut Members) {
        let inputs = read(members);
        if !rung {
            self.forget();
            self.reset = Edge::default();
            self.valid &= inputs.input_status;
            clear_outputs(members);
            return;
        }
        let rise = self.reset.rises(inputs.reset);
        if inputs.input_status {
            self.valid = true;
            let new_fault = self.supervise(&inputs, now_ms);
            self.judge(&inputs, new_fault, rise);
            if self.fault == NONE {
                self.follow_hands(&inputs, now_ms);
            }
        } else {
            self.forget();
            if self.valid && self.fault == NONE {
                self.fault = codes::INPUT_STATUS;
            }
            self.valid = false;
        }
        let healthy = inputs.input_status && self.fault == NONE;
        let connected = healthy && !inputs.disconnected;
        members[O1] = i32::from(self.hands.granted);
        members[BR] = i32::from(connected && inputs.enable && inputs.both_released());
        members[SB] = i32::from(healthy && inputs.disconnected && inputs.all_off());
        members[FP] = i32::from(self.fault != NONE);
        members[FAULT_CODE] = self.fault;
        members[DIAGNOSTIC_CODE] = self.diagnostic(&inputs);
    }

    /// Contacts of a connected station must differ, those of a disconnected one must be OFF; gives a new fault or 0.
    /// Decided D38: also while not enabled.
    fn supervise(&mut self, inputs: &Inputs, now_ms: i64) -> i32 {
        let connected = !inputs.disconnected;
        self.disconnection.follow(inputs.disconnected && !inputs.all_off(), now_ms);
        self.right.follow(connected && inputs.right.discrepant(), now_ms);
        self.left.follow(connected && inputs.left.discrepant(), now_ms);
        if self.disconnection.reached(now_ms, inputs.discrepancy_ms) {
            DISCONNECTED_NOT_OFF
        } else if self.right.reached(now_ms, inputs.discrepancy_ms) {
            if inputs.right.open { RIGHT_BOTH_ON } else { RIGHT_BOTH_OFF }
        } else if self.left.reached(now_ms, inputs.discrepancy_ms) {
            if inputs.left.open { LEFT_BOTH_ON } else { LEFT_BOTH_OFF }
        } else {
            NONE
        }
    }

    fn judge(&mut self, inputs: &Inputs, new_fault: i32, rise: bool) {
        if self.fault == NONE {
            if new_fault != NONE {
                self.fault = new_fault;
                self.hands = Hands::default();
            }
            return;
        }
        let at_rest = if inputs.disconnected { inputs.all_off() } else { inputs.both_released() };
        if rise && new_fault == NONE && (self.fault == codes::INPUT_STATUS || at_rest) {
            self.fault = NONE;
        }
    }

    fn follow_hands(&mut self, inputs: &Inputs, now_ms: i64) {
        if inputs.disconnected || !inputs.enable {
            self.hands = Hands::default();
            return;
        }
        if inputs.both_released() {
            self.hands = Hands { armed: true, ..Hands::default() };
            return;
        }
        let hands = &mut self.hands;
        if inputs.right.pressed() || inputs.left.pressed() {
            hands.first_press.start(now_ms);
        }
        hands.granted &= inputs.both_pressed();
        if hands.armed && hands.first_press.exceeded(now_ms, BETWEEN_HANDS_MS) {
            // Decided D37: too late is no fault; both must be released.
            hands.armed = false;
            hands.late = true;
        } else if hands.armed && inputs.both_pressed() {
            hands.granted = true;
            hands.armed = false;
        }
    }

    fn diagnostic(&self, inputs: &Inputs) -> i32 {
        if !inputs.input_status {
            codes::INPUT_STATUS
        } else if self.fault != NONE {
            if inputs.reset { RESET_HELD } else { NONE }
        } else if self.hands.late {
            SECOND_HAND_LATE
        } else if inputs.enable && !inputs.disconnected && !self.hands.granted && !self.hands.armed {
            NOT_ARMED
        } else {
            NONE
        }
    }

    /// What a false rung and a lost Input Status drop; a latched fault is kept.
    fn forget(&mut self) {
        self.hands = Hands::default();
        self.right.clear();
        self.left.clear();
        self.disconnection.clear();
    }
}

fn read(members: &Members) -> Inputs {
    Inputs {
        discrepancy_ms: members[DISCREPANCY_TIME],
        enable: members[ENABLE] != 0,
        disconnected: members[DISCONNECTED] != 0,
        right: Button { open: members[RIGHT_NO] != 0, closed: members[RIGHT_NC] != 0 },
        left: Button { open: members[LEFT_NO] != 0, closed: members[LEFT_NC] != 0 },
        input_status: members[INPUT_STATUS] != 0,
        reset: members[RESET] != 0,
    }
}
