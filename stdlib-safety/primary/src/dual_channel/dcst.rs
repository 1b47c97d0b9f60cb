//! DCST, Dual Channel Input Stop with Test. `dual-channel-inputs.md` 5.

use super::stop::{Stop, stop_members};
use crate::codes::{self, NONE};
use crate::edge::Edge;
use twinrung_catalog::types::safety::dual_channel::DCI_STOP_TEST;

stop_members! {
    DCI_STOP_TEST;
    inputs { TEST_REQUEST = "TestRequest" }
    outputs { TC = "TC" }
}

/// Memory of a DCST call.
#[derive(Clone, Debug, PartialEq)]
pub struct Dcst {
    stop: Stop,
    request: Edge,
}

crate::bits!(Dcst { stop, request });

impl Default for Dcst {
    fn default() -> Self {
        // A request that is already ON at start demands a test (5.4).
        Dcst { stop: Stop::default(), request: Edge::from_off() }
    }
}

impl Dcst {
    pub(crate) fn prescan(&mut self, members: &mut Members) {
        *self = Dcst::default();
        clear_outputs(members);
    }

    pub(crate) fn scan(&mut self, rung: bool, now_ms: i64, members: &mut Members) {
        let inputs = read(members);
        // Sampled in every scan; a false rung demands nothing (hook T, 5.4).
        let requested = self.request.rises(members[TEST_REQUEST] != 0);
        if !rung {
            self.stop.rung_false(&inputs);
            clear_outputs(members);
            return;
        }
        let found = self.stop.begin(&inputs, now_ms);
        if requested {
            self.stop.demand_test();
        }
        let (diagnostic, test_command) = match found {
            None => (codes::INPUT_STATUS, false),
            Some(mut found) => {
                self.stop.judge(&mut found, &inputs, NONE, true);
                self.stop.decide(&found, &inputs, now_ms, true, false);
                // Decided D22: TC shows every outstanding test, and is off with a fault.
                let test_command = self.stop.test && self.stop.fault == NONE;
                (self.stop.diagnostic(&found, &inputs, true, NONE), test_command)
            }
        };
        write(&self.stop, diagnostic, members);
        members[TC] = i32::from(test_command);
    }
}
