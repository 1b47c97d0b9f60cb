//! The feedback check of AVC and MVC. `v14-and-metal-form.md` 8 and 9.

use crate::timer::Timer;

/// What a check has found in one scan.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Finding {
    /// Nothing wrong.
    Fine,
    /// The feedback had agreed and differs now.
    Unexpected,
    /// The feedback did not follow within the reaction time.
    TooLate,
}

/// Supervision of one feedback; its default starts anew in the next scan that judges.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Check {
    agreed: bool,
    since: Timer,
}

crate::bits!(Check { agreed, since });

impl Check {
    /// Starts anew: the output changed, or a fault was cleared.
    pub(crate) fn restart(&mut self, now_ms: i64) {
        self.agreed = false;
        self.since.restart(now_ms);
    }

    /// Judges a feedback; `agrees`: it shows the output of the previous scan.
    pub(crate) fn judge(&mut self, agrees: bool, now_ms: i64, reaction_ms: i32) -> Finding {
        self.since.start(now_ms);
        match (self.agreed, agrees) {
            (true, true) => Finding::Fine,
            (true, false) => Finding::Unexpected,
            (false, true) if self.since.exceeded(now_ms, reaction_ms) => Finding::TooLate,
            (false, false) if self.since.reached(now_ms, reaction_ms) => Finding::TooLate,
            (false, _) => {
                self.agreed = agrees;
                Finding::Fine
            }
        }
    }
}
