//! A module alone: what happens at its terminals, what it reports, as a trace.

use twinrung_plant::{Command, Device, ModuleSettings, Reading, Signal, Stimulus, Terminal};

/// A terminal by its name.
pub fn at(name: &str) -> Terminal {
    Terminal::parse(name).unwrap()
}

/// A contact closes or opens.
pub fn contact(name: &str, closed: bool) -> Stimulus {
    Stimulus::Signal(at(name), Signal::Contact(closed))
}

/// A sensor gives so many mV, µA or mHz.
pub fn amount(name: &str, amount: i64) -> Stimulus {
    Stimulus::Signal(at(name), Signal::Amount(amount))
}

/// A module in simulated time.
pub struct Bench<D> {
    pub device: D,
    now_ms: u64,
}

impl<D: Device> Bench<D> {
    /// A module after power-up.
    pub fn new(mut device: D) -> Bench<D> {
        device.power_up(0);
        Bench { device, now_ms: 0 }
    }

    /// Something happens at a time in ms: the look at the terminals at that time sees it.
    pub fn at(&mut self, time_ms: u64, stimulus: Stimulus) -> &mut Bench<D> {
        self.before(time_ms);
        self.device.accepts(&stimulus).unwrap();
        self.device.apply(&stimulus);
        self
    }

    /// The controller commands something at a time in ms.
    pub fn command(&mut self, time_ms: u64, commands: &[(Command, bool)]) -> &mut Bench<D> {
        self.before(time_ms);
        for (command, on) in commands {
            self.device.command(*command, *on);
        }
        self.device.commanded(time_ms);
        self
    }

    fn before(&mut self, time_ms: u64) {
        while self.now_ms < time_ms {
            self.device.step(self.now_ms);
            self.now_ms += 1;
        }
    }

    /// What is reported after the look at a time in ms.
    pub fn read(&mut self, time_ms: u64, readings: &[Reading]) -> Vec<i32> {
        self.before(time_ms + 1);
        readings.iter().map(|reading| self.device.read(*reading)).collect()
    }

    /// Changes of one reading up to a time in ms, as `(time, value)`.
    pub fn changes(&mut self, until_ms: u64, reading: Reading) -> Vec<(u64, i32)> {
        let mut found = Vec::new();
        let mut last = None;
        while self.now_ms <= until_ms {
            self.device.step(self.now_ms);
            let value = self.device.read(reading);
            found.extend((last != Some(value)).then_some((self.now_ms, value)));
            last = Some(value);
            self.now_ms += 1;
        }
        found
    }
}

/// Settings of two inputs that are evaluated as a pair, without pulse tests.
pub fn pair(kind: &str, discrepancy_ms: &str) -> ModuleSettings {
    let settings = [("Mode", "SAFETY"), ("Type", kind), ("DiscrepancyTime", discrepancy_ms)];
    ModuleSettings::new("1734-IB8S").point(at("I0"), &settings).point(at("I1"), &settings)
}
