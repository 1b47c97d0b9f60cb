//! What two feedbacks say about two outputs, and the codes that CROUT and the valve instructions share.
//! `muting-and-outputs.md` 6.3, 6.4; `v14-and-metal-form.md` 8, 9.

/// Feedback 1 turned OFF unexpectedly; its neighbours below say what else. Recalled 70 %, after the sourced 16#5003.
const TURNED_OFF: i32 = 0x5000;
/// Feedback 1 and 2 turned ON unexpectedly. muting-and-outputs.md 6.4, doc S11.
const TURNED_ON: i32 = 0x5003;
/// Feedback 1 and 2 did not turn ON within the reaction time. muting-and-outputs.md 6.4, recalled 70 %.
const DID_NOT_TURN_ON: i32 = 0x5006;
/// Feedback 1 and 2 did not turn OFF within the reaction time. muting-and-outputs.md 6.4, recalled 70 %.
const DID_NOT_TURN_OFF: i32 = 0x5009;

/// The channels of which something is true.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Which {
    pub(crate) first: bool,
    pub(crate) second: bool,
}

crate::bits!(Which { first, second });

impl Which {
    pub(crate) fn any(self) -> bool {
        self.first || self.second
    }

    pub(crate) fn both(self) -> bool {
        self.first && self.second
    }

    pub(crate) fn not(self) -> Which {
        Which { first: !self.first, second: !self.second }
    }

    /// Of the three codes "1 and 2", "1", "2" that begin at `base`, the one for these channels.
    fn code(self, base: i32) -> i32 {
        match (self.first, self.second) {
            (true, true) => base,
            (true, false) => base.saturating_add(1),
            _ => base.saturating_add(2),
        }
    }
}

/// The code for channels whose feedback changed by itself; `raw` is the value that they read now.
pub(crate) fn unexpected(which: Which, raw: bool) -> i32 {
    which.code(if raw { TURNED_ON } else { TURNED_OFF })
}

/// The code for channels whose feedback did not follow in time; `raw` is the value at which they stay.
pub(crate) fn did_not_follow(which: Which, raw: bool) -> i32 {
    which.code(if raw { DID_NOT_TURN_OFF } else { DID_NOT_TURN_ON })
}
