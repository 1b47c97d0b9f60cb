//! THRS, Two-Hand Run Station. `v14-and-metal-form.md` 3.3.

use crate::edge::Edge;
use crate::members::members;
use crate::timer::{Limit, Timer};
use twinrung_catalog::types::safety::version_14::TWO_HAND_RUN_STATION;

members! {
    TWO_HAND_RUN_STATION;
    inputs {
        ACTIVE_PIN_TYPE = "ActivePinType",
        ACTIVE_PIN = "ActivePin",
        RIGHT_NO = "RightButtonNormallyOpen",
        RIGHT_NC = "RightButtonNormallyClosed",
        LEFT_NO = "LeftButtonNormallyOpen",
        LEFT_NC = "LeftButtonNormallyClosed",
        FAULT_RESET = "FaultReset",
    }
    outputs {
        BP = "BP",
        SA = "SA",
        BT = "BT",
        CB = "CB",
        SAF = "SAF",
        RBF = "RBF",
        LBF = "LBF",
        FP = "FP",
    }
}

/// How long a button's contacts may be mixed. 3.3, recalled 60 %, the shorter candidate decided.
const MIXED_MS: i32 = 250;
/// How long an unplugged station may show a contact. 3.3, decided.
const UNPLUGGED_MS: i32 = 500;
/// Longest time between the two hands; exactly this is in time. 3.3, recalled 90 %.
const BETWEEN_HANDS_MS: i32 = 500;

/// One button: pressed, released or mixed.
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

    fn mixed(self) -> bool {
        self.open == self.closed
    }

    fn any(self) -> bool {
        self.open || self.closed
    }
}

/// What the hands have done so far.
#[derive(Clone, Debug, Default, PartialEq)]
struct Hands {
    /// Both were released; the next press may start.
    ready: bool,
    /// BP.
    pressed: bool,
    /// BT.
    tied_down: bool,
    /// CB.
    cycle: bool,
    press: Timer,
}

crate::bits!(Hands { ready, pressed, tied_down, cycle, press });

/// Memory of a THRS call.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Thrs {
    hands: Hands,
    right_mixed: Limit,
    left_mixed: Limit,
    unplugged: Limit,
    right_fault: bool,
    left_fault: bool,
    station_fault: bool,
    reset: Edge,
}

crate::bits!(Thrs { hands, right_mixed, left_mixed, unplugged, right_fault, left_fault, station_fault, reset });

impl Thrs {
    pub(crate) fn prescan(&mut self, members: &mut Members) {
        *self = Thrs::default();
        clear_outputs(members);
    }

    pub(crate) fn scan(&mut self, rung: bool, now_ms: i64, members: &mut Members) {
        if !rung {
            // A false rung is as prescan, a latched fault included (1.3).
            self.prescan(members);
            return;
        }
        let pin_enabled = members[ACTIVE_PIN_TYPE] != 0;
        let pin = members[ACTIVE_PIN] != 0;
        let connected = !pin_enabled || pin;
        let right = Button { open: members[RIGHT_NO] != 0, closed: members[RIGHT_NC] != 0 };
        let left = Button { open: members[LEFT_NO] != 0, closed: members[LEFT_NC] != 0 };
        let reset = self.reset.rises(members[FAULT_RESET] != 0);
        self.supervise(connected, right, left, reset, now_ms);
        let fault = self.station_fault || self.right_fault || self.left_fault;
        if fault || !connected {
            self.hands = Hands::default();
        } else {
            self.hands.follow(right, left, now_ms);
        }
        members[BP] = i32::from(self.hands.pressed);
        members[SA] = i32::from(pin_enabled && pin);
        members[BT] = i32::from(self.hands.tied_down);
        members[CB] = i32::from(self.hands.cycle);
        members[SAF] = i32::from(self.station_fault);
        members[RBF] = i32::from(self.right_fault);
        members[LBF] = i32::from(self.left_fault);
        members[FP] = i32::from(fault);
    }

    /// The three latched faults.
    fn supervise(&mut self, connected: bool, right: Button, left: Button, reset: bool, now_ms: i64) {
        let right_mixed = connected && right.mixed();
        let left_mixed = connected && left.mixed();
        let shows_contact = !connected && (right.any() || left.any());
        let latch = |limit: &mut Limit, fault: &mut bool, wrong: bool, limit_ms: i32| {
            let detected = limit.breaks(wrong, now_ms, limit_ms);
            *fault = detected || (*fault && (wrong || !reset));
        };
        latch(&mut self.right_mixed, &mut self.right_fault, right_mixed, MIXED_MS);
        latch(&mut self.left_mixed, &mut self.left_fault, left_mixed, MIXED_MS);
        latch(&mut self.unplugged, &mut self.station_fault, shows_contact, UNPLUGGED_MS);
    }
}

impl Hands {
    /// Connected and without a fault.
    fn follow(&mut self, right: Button, left: Button, now_ms: i64) {
        if right.released() && left.released() {
            *self = Hands { ready: true, ..Hands::default() };
            return;
        }
        self.press.follow(self.ready, now_ms);
        if right.pressed() && left.pressed() {
            if self.ready {
                let late = self.press.exceeded(now_ms, BETWEEN_HANDS_MS);
                self.tied_down = late;
                self.pressed = !late;
                self.ready = false;
            } else if !self.pressed && !self.tied_down {
                self.cycle = true;
            }
            return;
        }
        self.pressed = false;
        if self.press.reached(now_ms, BETWEEN_HANDS_MS) {
            self.tied_down = true;
            self.ready = false;
        }
        // A hand that left BP, or one that began without a common release.
        self.cycle |= !self.ready && !self.tied_down;
    }
}
