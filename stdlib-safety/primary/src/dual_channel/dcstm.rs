//! DCSTM, Dual Channel Input Stop with Test and Mute. `dual-channel-inputs.md` 7.

use super::pair::Consistency;
use super::stop::{Found, Inputs, Stop, stop_members};
use crate::codes::{self, NONE};
use crate::edge::Edge;
use crate::timer::Timer;
use twinrung_catalog::types::safety::dual_channel::DCI_STOP_TEST_MUTE;

stop_members! {
    DCI_STOP_TEST_MUTE;
    inputs {
        TEST_TYPE = "TestType",
        TEST_TIME = "TestTime",
        TEST_REQUEST = "TestRequest",
        MUTE = "Mute",
        MUTING_LAMP_STATUS = "MutingLampStatus",
    }
    outputs { TC = "TC", ML = "ML", SS = "SS" }
}

/// Fault: Muting Lamp Status OFF. 1.9, condition doc HELP-DCSTM, number D15.
const MUTING_LAMP: i32 = 0xF020;
/// Fault: automatic test, device not safe within Test Time. 1.9, decided D28.
pub(super) const NOT_SAFE_IN_TEST: i32 = 0xF021;
/// Fault: automatic test, device not active again within Test Time. 1.9, decided D28.
pub(super) const NOT_ACTIVE_AFTER_TEST: i32 = 0xF022;

/// How far the automatic test is (`tph`).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum TestPhase {
    #[default]
    None,
    /// Waiting until the device is safe.
    AwaitSafe,
    /// Waiting until it is active again.
    AwaitActive,
}

crate::bits!(
    enum TestPhase {
        None,
        AwaitSafe,
        AwaitActive,
    }
);

/// Memory of a DCSTM call.
#[derive(Clone, Debug, PartialEq)]
pub struct Dcstm {
    stop: Stop,
    request: Edge,
    mute: Edge,
    muted: bool,
    phase: TestPhase,
    phase_timer: Timer,
}

crate::bits!(Dcstm { stop, request, mute, muted, phase, phase_timer });

impl Default for Dcstm {
    fn default() -> Self {
        Dcstm {
            stop: Stop::default(),
            // A request that is already ON at start demands a test (5.4).
            request: Edge::from_off(),
            mute: Edge::default(),
            muted: false,
            phase: TestPhase::None,
            phase_timer: Timer::default(),
        }
    }
}

/// What the instruction reads beyond the family.
struct Own {
    automatic_test: bool,
    test_ms: i32,
    requested: bool,
    mute: bool,
    mute_rises: bool,
    lamp_good: bool,
}

impl Dcstm {
    pub(crate) fn prescan(&mut self, members: &mut Members) {
        *self = Dcstm::default();
        clear_outputs(members);
    }

    pub(crate) fn scan(&mut self, rung: bool, now_ms: i64, members: &mut Members) {
        let inputs = read(members);
        let requested = self.request.rises(members[TEST_REQUEST] != 0);
        if !rung {
            self.stop.rung_false(&inputs);
            self.mute = Edge::default();
            self.forget_mute_and_test();
            clear_outputs(members);
            return;
        }
        let mute = members[MUTE] != 0;
        let own = Own {
            automatic_test: members[TEST_TYPE] != 0,
            test_ms: members[TEST_TIME],
            requested,
            mute,
            mute_rises: self.mute.rises(mute),
            lamp_good: members[MUTING_LAMP_STATUS] != 0,
        };
        let found = self.stop.begin(&inputs, now_ms);
        if requested {
            self.stop.demand_test();
        }
        let (diagnostic, clear) = match found {
            None => {
                self.forget_mute_and_test();
                (codes::INPUT_STATUS, false)
            }
            Some(found) => {
                // Decided D27: SS = sensing field clear and healthy, irrespective of muting.
                (self.evaluate(found, &inputs, &own, now_ms), found.pair == Consistency::Active)
            }
        };
        let healthy = found.is_some() && self.stop.fault == NONE;
        let test_command = match self.phase {
            TestPhase::None => self.stop.test,
            TestPhase::AwaitSafe => true,
            TestPhase::AwaitActive => false,
        };
        write(&self.stop, diagnostic, members);
        members[TC] = i32::from(healthy && test_command);
        members[ML] = i32::from(self.muted);
        members[SS] = i32::from(healthy && clear);
    }

    /// The scan with Input Status valid; gives the diagnostic.
    fn evaluate(&mut self, mut found: Found, inputs: &Inputs, own: &Own, now_ms: i64) -> i32 {
        let test_fault = self.automatic_test(&found, own, now_ms);
        let extra = if own.lamp_good { test_fault } else { MUTING_LAMP };
        self.stop.judge(&mut found, inputs, extra, own.lamp_good);
        if self.stop.fault == NONE {
            self.follow_mute(&found, own);
        } else {
            self.forget_mute_and_test();
        }
        self.stop.decide(&found, inputs, now_ms, true, self.muted);
        self.muted &= self.stop.output();
        self.stop.diagnostic(&found, inputs, true, NONE)
    }

    /// Decided D29: muting begins with an edge of Mute while O1 is on and the field is clear.
    fn follow_mute(&mut self, found: &Found, own: &Own) {
        if !own.mute || !self.stop.granted {
            self.muted = false;
        } else if own.mute_rises && found.pair == Consistency::Active {
            self.muted = true;
        }
    }

    /// The automatic test; gives its fault. With a latched fault it does not run.
    fn automatic_test(&mut self, found: &Found, own: &Own, now_ms: i64) -> i32 {
        if !own.automatic_test || self.stop.fault != NONE {
            return NONE;
        }
        if own.requested && found.pair == Consistency::Active {
            self.enter(TestPhase::AwaitSafe, now_ms);
            return NONE;
        }
        let too_late = self.phase_timer.reached(now_ms, own.test_ms);
        match (self.phase, found.pair) {
            (TestPhase::AwaitSafe, Consistency::Safe) => self.enter(TestPhase::AwaitActive, now_ms),
            (TestPhase::AwaitSafe, _) if too_late => return NOT_SAFE_IN_TEST,
            (TestPhase::AwaitActive, Consistency::Active) => self.phase = TestPhase::None,
            (TestPhase::AwaitActive, _) if too_late => return NOT_ACTIVE_AFTER_TEST,
            _ => {}
        }
        NONE
    }

    fn enter(&mut self, phase: TestPhase, now_ms: i64) {
        self.phase = phase;
        self.phase_timer.restart(now_ms);
    }

    fn forget_mute_and_test(&mut self) {
        self.muted = false;
        self.phase = TestPhase::None;
    }
}
