//! DCSTL, Dual Channel Input Stop with Test and Lock. `dual-channel-inputs.md` 6.

use super::stop::{Found, Inputs, Stop, stop_members};
use crate::codes::{self, NONE};
use crate::edge::Edge;
use twinrung_catalog::types::safety::dual_channel::DCI_STOP_TEST_LOCK;

stop_members! {
    DCI_STOP_TEST_LOCK;
    inputs {
        TEST_REQUEST = "TestRequest",
        UNLOCK_REQUEST = "UnlockRequest",
        LOCK_FEEDBACK = "LockFeedback",
        HAZARD_STOPPED = "HazardStopped",
    }
    outputs { TC = "TC", ULC = "ULC" }
}

/// Fault: Lock Feedback turned OFF while O1 was on and no unlock was commanded. 1.9, condition decided D24, number D15.
const LOCK_FEEDBACK_LOST: i32 = 0xF010;
/// Diagnostic: unlock requested, hazard not stopped. 1.9, decided.
const HAZARD_NOT_STOPPED: i32 = 0xF111;
/// Diagnostic: Unlock Command on, Lock Feedback still ON. 1.9, decided.
const STILL_LOCKED: i32 = 0xF112;
/// Diagnostic: Lock Feedback OFF. 1.9, decided.
const NOT_LOCKED: i32 = 0xF113;

/// Memory of a DCSTL call. The reference's `lf_prev` and `ulc` need no memory: O1 on in the previous scan means that
/// Lock Feedback was on and the Unlock Command off in it.
#[derive(Clone, Debug, PartialEq)]
pub struct Dcstl {
    stop: Stop,
    request: Edge,
}

crate::bits!(Dcstl { stop, request });

impl Default for Dcstl {
    fn default() -> Self {
        // A request that is already ON at start demands a test (5.4).
        Dcstl { stop: Stop::default(), request: Edge::from_off() }
    }
}

/// The lock's part of a scan.
struct Lock {
    unlock_request: bool,
    feedback: bool,
    hazard_stopped: bool,
}

impl Lock {
    /// `extra_ok`: an unlock request turns O1 off at once, whether or not the hazard has stopped (decided D23).
    fn permits(&self) -> bool {
        self.feedback && !self.unlock_request
    }

    /// Unlock Command. O1 is off in every scan with an unlock request, so it need not be asked again.
    fn unlock_command(&self) -> bool {
        self.unlock_request && self.hazard_stopped
    }

    fn diagnostic(&self) -> i32 {
        if self.unlock_request && !self.hazard_stopped {
            HAZARD_NOT_STOPPED
        } else if self.unlock_command() && self.feedback {
            STILL_LOCKED
        } else if !self.feedback {
            NOT_LOCKED
        } else {
            NONE
        }
    }
}

impl Dcstl {
    pub(crate) fn prescan(&mut self, members: &mut Members) {
        *self = Dcstl::default();
        clear_outputs(members);
    }

    pub(crate) fn scan(&mut self, rung: bool, now_ms: i64, members: &mut Members) {
        let inputs = read(members);
        let requested = self.request.rises(members[TEST_REQUEST] != 0);
        if !rung {
            self.stop.rung_false(&inputs);
            clear_outputs(members);
            return;
        }
        let lock = Lock {
            unlock_request: members[UNLOCK_REQUEST] != 0,
            feedback: members[LOCK_FEEDBACK] != 0,
            hazard_stopped: members[HAZARD_STOPPED] != 0,
        };
        let on_before = self.stop.granted;
        let found = self.stop.begin(&inputs, now_ms);
        if requested {
            self.stop.demand_test();
        }
        let (diagnostic, test_command, unlock_command) = match found {
            None => (codes::INPUT_STATUS, false, false),
            Some(found) => {
                let diagnostic = self.evaluate(found, &inputs, &lock, on_before, now_ms);
                // Decided D25: the Unlock Command stays available with a fault, or the functional test that clears
                // it could never be done.
                (diagnostic, self.stop.test && self.stop.fault == NONE, lock.unlock_command())
            }
        };
        write(&self.stop, diagnostic, members);
        members[TC] = i32::from(test_command);
        members[ULC] = i32::from(unlock_command);
    }

    /// The scan with Input Status valid; gives the diagnostic.
    fn evaluate(&mut self, mut found: Found, inputs: &Inputs, lock: &Lock, on_before: bool, now_ms: i64) -> i32 {
        let lost = if on_before && !lock.feedback { LOCK_FEEDBACK_LOST } else { NONE };
        let clearable = self.stop.fault != LOCK_FEEDBACK_LOST || lock.feedback;
        self.stop.judge(&mut found, inputs, lost, clearable);
        self.stop.decide(&found, inputs, now_ms, lock.permits(), false);
        self.stop.diagnostic(&found, inputs, lock.permits(), lock.diagnostic())
    }
}
