//! Input delays: a level counts when it has stood long enough. 1734-UM013 Figures 10 and 11.

/// On-delay and off-delay of an input.
#[derive(Debug, Clone)]
pub struct InputDelay {
    off_on_ms: u64,
    on_off_ms: u64,
    on: bool,
    changed_ms: Option<u64>,
}

impl InputDelay {
    /// Delays in ms; the input begins off.
    pub fn new(off_on_ms: u64, on_off_ms: u64) -> InputDelay {
        InputDelay { off_on_ms, on_off_ms, on: false, changed_ms: None }
    }

    /// Off, with nothing pending.
    pub fn power_up(&mut self) {
        self.on = false;
        self.changed_ms = None;
    }

    /// The level at the terminal at a time in ms; whether the input is on.
    pub fn look(&mut self, now_ms: u64, level: bool) -> bool {
        if level == self.on {
            self.changed_ms = None;
            return self.on;
        }
        let changed_ms = *self.changed_ms.get_or_insert(now_ms);
        let delay_ms = if level { self.off_on_ms } else { self.on_off_ms };
        if now_ms.saturating_sub(changed_ms) >= delay_ms {
            self.on = level;
            self.changed_ms = None;
        }
        self.on
    }
}
