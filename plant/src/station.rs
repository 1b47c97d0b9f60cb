//! A module with its two connections, and all modules of a project together.

use crate::connection::{Connection, Received, Sent, Times};
use crate::device::{Device, model};
use crate::followers::Followers;
use crate::member::{Command, Reading};
use crate::settings::ModuleSettings;
use crate::stimulus::{Refusal, Signal, Stimulus, Terminal};

/// µs of one look at the terminals.
pub(crate) const STEP_US: u64 = 1000;

/// A module, with the connection that its inputs or status come on and the one that commands go out on.
pub struct Station {
    device: Box<dyn Device>,
    readings: Vec<Reading>,
    commands: Vec<Command>,
    present: bool,
    running: bool,
    input: Connection,
    output_limit_us: u64,
    last_output_us: Option<u64>,
    now_us: u64,
}

impl Station {
    /// A module that reports these members and is told these, each in the order of its tag. Nothing for a module that has no
    /// model.
    pub fn new(settings: &ModuleSettings, readings: Vec<Reading>, commands: Vec<Command>) -> Option<Station> {
        let mut device = model(settings)?;
        device.power_up(0);
        let (rpi_us, limit_us) = (settings.input_rpi_us, settings.input_limit_us);
        Some(Station {
            device,
            readings,
            commands,
            present: true,
            running: true,
            input: Connection::new(Times { rpi_us, limit_us, delay_us: 0, first_us: 0 }),
            output_limit_us: settings.output_limit_us,
            last_output_us: None,
            now_us: 0,
        })
    }

    /// Whether something can happen to the module.
    ///
    /// # Errors
    ///
    /// [`Refusal`].
    pub fn accepts(&self, stimulus: &Stimulus) -> Result<(), Refusal> {
        self.device.accepts(stimulus)
    }

    /// The terminal of a point: `0` is `I0` at an input module.
    pub fn point(&self, number: u8) -> Terminal {
        Terminal::new(self.device.letter(), number)
    }

    /// Whether the module has a terminal.
    pub fn has(&self, terminal: Terminal) -> bool {
        self.device.has(terminal)
    }

    /// How often in a ms the module looks at its terminals.
    pub fn looks_each_ms(&self) -> u64 {
        self.device.looks_each_ms()
    }

    /// Whether 24 V reach what is wired to a terminal, or of an input the terminal itself; nothing where there is no such
    /// terminal, or where a number stands at it.
    pub fn is_high(&self, terminal: Terminal) -> Option<bool> {
        self.device.is_high(terminal).map(|high| high && self.present)
    }

    fn apply(&mut self, stimulus: &Stimulus, now_ms: u64) {
        match stimulus {
            Stimulus::Present(true) if !self.present => {
                self.present = true;
                self.last_output_us = None;
                self.device.power_up(now_ms);
            }
            Stimulus::Present(present) => self.present = *present,
            Stimulus::Running(running) => self.running = *running,
            _ => self.device.apply(stimulus),
        }
    }

    fn step(&mut self, now_ms: u64) {
        self.now_us = now_ms * STEP_US;
        if self.present {
            if self.last_output_us.is_some_and(|last| self.now_us - last > self.output_limit_us) {
                self.last_output_us = None;
                self.device.output_connection_lost(now_ms);
            }
            self.device.step(now_ms);
        }
        let Station { device, readings, present, running, .. } = self;
        self.input.pass(self.now_us, || match (present, running) {
            (false, _) => Sent::Nothing,
            (true, false) => Sent::Idle,
            (true, true) => Sent::Run(readings.iter().map(|reading| device.read(*reading)).collect()),
        });
        self.input.at(self.now_us);
    }

    /// What the controller has of the input tag now.
    fn received(&self) -> Received<'_> {
        self.input.held(self.now_us)
    }

    /// The members of the input tag as the controller has them now, in order.
    pub fn values(&self) -> impl Iterator<Item = i32> + '_ {
        let received = self.received();
        self.readings.iter().enumerate().map(move |(position, reading)| match reading {
            Reading::RunMode => i32::from(received.run_mode()),
            Reading::ConnectionFaulted => i32::from(received.connection_faulted()),
            _ => received.value(position),
        })
    }

    /// A packet with commands from the controller arrives: the values of the output tag in order.
    fn receive(&mut self, values: impl Iterator<Item = bool>) {
        if !self.present {
            return;
        }
        self.last_output_us = Some(self.now_us);
        for (command, on) in self.commands.iter().zip(values) {
            // An idle module holds its outputs in the safe state (decided).
            self.device.command(*command, on && self.running);
        }
        self.device.commanded(self.now_us / STEP_US);
    }
}

/// All modules of a project.
#[derive(Default)]
pub struct Plant {
    stations: Vec<Station>,
    followers: Followers,
    next_ms: u64,
}

impl Plant {
    /// Modules at power-up, with nothing closed and nothing broken.
    pub fn new(stations: Vec<Station>) -> Plant {
        Plant { stations, followers: Followers::default(), next_ms: 0 }
    }

    /// The modules, in the order in which they were given.
    pub fn stations(&self) -> &[Station] {
        &self.stations
    }

    /// A packet with commands arrives at a module after its last look at the terminals: the values of its output tag in order.
    pub fn receive(&mut self, position: usize, values: impl Iterator<Item = bool>) {
        if let Some(station) = self.stations.get_mut(position) {
            station.receive(values);
        }
        self.look_at_outputs(self.next_ms.saturating_sub(1));
    }

    /// Something happens to a module at a time in ms: its look at the terminals at that time sees it.
    pub fn apply(&mut self, position: usize, stimulus: &Stimulus, at_ms: u64) {
        while self.next_ms < at_ms {
            self.step();
        }
        let Plant { stations, followers, .. } = self;
        if let Stimulus::Signal(terminal, signal) = stimulus {
            followers.apply(position, *terminal, signal, |module, output| is_high(stations, module, output));
        }
        if let Some(station) = stations.get_mut(position) {
            station.apply(stimulus, at_ms);
        }
    }

    /// Everything up to and including the look at the terminals at a time in ms.
    pub fn through(&mut self, time_ms: u64) {
        while self.next_ms <= time_ms {
            self.step();
        }
    }

    fn step(&mut self) {
        self.look_at_outputs(self.next_ms);
        let Plant { stations, followers, .. } = self;
        for (position, terminal, closed) in followers.moved() {
            if let Some(station) = stations.get_mut(position) {
                station.apply(&Stimulus::Signal(terminal, Signal::Contact(closed)), self.next_ms);
            }
        }
        for station in stations {
            station.step(self.next_ms);
        }
        self.look_at_outputs(self.next_ms);
        self.next_ms += 1;
    }

    /// What follows an output sees it as it stands now.
    fn look_at_outputs(&mut self, now_ms: u64) {
        let Plant { stations, followers, .. } = self;
        followers.look(now_ms, |module, output| is_high(stations, module, output));
    }
}

fn is_high(stations: &[Station], module: usize, output: Terminal) -> bool {
    stations.get(module).and_then(|station| station.is_high(output)).unwrap_or_default()
}
