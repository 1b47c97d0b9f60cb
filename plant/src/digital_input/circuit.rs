//! Input circuits: an input alone, or a pair that the module evaluates.

use super::delay::InputDelay;
use super::pair::Pair;
use crate::error_latch::ErrorLatch;
use crate::settings::{ModuleSettings, PointSettings};
use crate::stimulus::Terminal;

/// Why an input circuit shows an error: the codes of 1734-UM013 Table 12.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum InputFault {
    /// No error.
    None = 0,
    /// A pulse test without a test source.
    Configuration = 1,
    /// The input was on during the test pulse of its source.
    TestSignal = 2,
    /// The circuit of the module itself is at fault.
    Inside = 3,
    /// The channels of a pair differed for too long.
    Discrepancy = 4,
    /// The other input of the pair has an error.
    Partner = 5,
}

/// What a point is for. 1734-UM013 Table 18.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Mode {
    NotUsed,
    PulseTest,
    /// `SAFETY` and `STANDARD`: looked at, and not tested.
    Plain,
}

/// One input: from the terminal to a level that counts.
#[derive(Debug, Clone)]
pub struct Input {
    mode: Mode,
    /// The test output that the device at it gets its 24 V from.
    pub source: Option<u8>,
    delay: InputDelay,
    /// Whether its last pulse test failed.
    pub test_failed: bool,
    /// Whether the circuit of the module itself is at fault.
    pub failed_inside: bool,
    /// Whether it is on, delays included.
    on: bool,
}

impl Input {
    /// As configured; a point that is not configured is not used.
    pub fn new(settings: &PointSettings) -> Input {
        let mode = match settings.word("Mode").unwrap_or_default().to_ascii_uppercase().as_str() {
            "SAFETY_PULSE_TEST" => Mode::PulseTest,
            "SAFETY" | "STANDARD" => Mode::Plain,
            _ => Mode::NotUsed,
        };
        let source = settings
            .word("TestSource")
            .and_then(Terminal::parse)
            .filter(|source| source.letter == 'T' && source.number < super::TESTS);
        Input {
            mode,
            source: source.map(|source| source.number),
            delay: InputDelay::new(settings.milliseconds("OffOn", 0), settings.milliseconds("OnOff", 0)),
            test_failed: false,
            failed_inside: false,
            on: false,
        }
    }

    /// Whether a device is connected.
    pub fn is_used(&self) -> bool {
        self.mode != Mode::NotUsed
    }

    /// Whether test pulses of its source are looked for.
    pub fn is_pulse_tested(&self) -> bool {
        self.mode == Mode::PulseTest
    }

    /// The level at the terminal; an input that is not used stays off.
    pub fn look(&mut self, now_ms: u64, level: bool) {
        self.on = self.delay.look(now_ms, level && self.is_used());
    }

    /// As new.
    pub fn power_up(&mut self) {
        self.delay.power_up();
        self.test_failed = false;
        self.on = false;
    }

    fn fault(&self) -> InputFault {
        match self.mode {
            Mode::PulseTest if self.source.is_none() => InputFault::Configuration,
            _ if self.failed_inside => InputFault::Inside,
            _ if self.test_failed => InputFault::TestSignal,
            _ => InputFault::None,
        }
    }
}

/// What is evaluated together.
#[derive(Debug, Clone)]
pub struct Circuit {
    first: u8,
    /// The evaluation of a pair; nothing for an input alone.
    pair: Option<Pair>,
    latch: ErrorLatch,
    faults: [InputFault; 2],
    data: [bool; 2],
}

/// The circuits of a module: a pair where its even point is evaluated as one, single inputs otherwise.
pub fn circuits(settings: &ModuleSettings) -> Vec<Circuit> {
    let mut circuits = Vec::new();
    for first in (0..super::INPUTS).step_by(2) {
        let (even, odd) = (settings.of(Terminal::new('I', first)), settings.of(Terminal::new('I', first + 1)));
        match Pair::new(&even) {
            Some(pair) => {
                circuits.push(Circuit::new(first, Some(pair), even.error_latch_ms().max(odd.error_latch_ms())))
            }
            None => {
                circuits.push(Circuit::new(first, None, even.error_latch_ms()));
                circuits.push(Circuit::new(first + 1, None, odd.error_latch_ms()));
            }
        }
    }
    circuits
}

impl Circuit {
    fn new(first: u8, pair: Option<Pair>, latch_ms: u64) -> Circuit {
        let mut circuit =
            Circuit { first, pair, latch: ErrorLatch::new(latch_ms), faults: [InputFault::None; 2], data: [false; 2] };
        circuit.power_up();
        circuit
    }

    /// As new: in the safe state.
    pub fn power_up(&mut self) {
        self.latch.power_up();
        self.faults = [InputFault::None; 2];
        if let Some(pair) = &mut self.pair {
            pair.power_up();
        }
        self.data = self.shown(false);
    }

    fn position(&self, number: u8) -> Option<usize> {
        let count = if self.pair.is_some() { 2 } else { 1 };
        number.checked_sub(self.first).map(usize::from).filter(|position| *position < count)
    }

    /// The error of an input, where the circuit has it.
    pub fn fault_of(&self, number: u8) -> Option<InputFault> {
        self.position(number).and_then(|position| self.faults.get(position)).copied()
    }

    /// The data of an input, where the circuit has it: the safe state where it is not `valid`.
    pub fn data_of(&self, number: u8, valid: bool) -> Option<bool> {
        let data = if valid { self.data } else { self.shown(false) };
        self.position(number).and_then(|position| data.get(position)).copied()
    }

    /// There is no field power: nothing is evaluated, and an error that is shown stays.
    pub fn rest(&mut self) {
        if let Some(pair) = &mut self.pair {
            pair.power_up();
        }
        self.data = self.shown(false);
    }

    /// Evaluates the inputs of the module. An error goes when its cause is gone, the inputs are in the safe state, and the error
    /// latch time has run out: all three at one time. (1734-UM013, Safety Input Fault Recovery; at one time: decided)
    pub fn step(&mut self, now_ms: u64, inputs: &[Input]) {
        let first = usize::from(self.first);
        let Some(one) = inputs.get(first) else { return };
        let other = inputs.get(first + 1).filter(|_| self.pair.is_some());
        let [mut own, mut partner] = [one.fault(), other.map_or(InputFault::None, Input::fault)];
        let (active, safe) = match (&mut self.pair, other) {
            (Some(pair), Some(other)) => {
                pair.look(now_ms, one.on, other.on);
                if pair.is_discrepant_too_long(now_ms) && own == InputFault::None && partner == InputFault::None {
                    (own, partner) = (InputFault::Discrepancy, InputFault::Discrepancy);
                }
                (pair.is_active(), pair.is_safe())
            }
            _ => (one.on, !one.on),
        };
        if own == InputFault::None && partner == InputFault::None {
            self.latch.gone(now_ms, safe);
            if !self.latch.is_set() {
                self.faults = [InputFault::None; 2];
            }
        } else {
            self.latch.seen(now_ms);
            let beside = |fault: InputFault| if fault == InputFault::None { InputFault::Partner } else { fault };
            self.faults = if other.is_some() { [beside(own), beside(partner)] } else { [own, InputFault::None] };
        }
        self.data = self.shown(active && !self.latch.is_set());
    }

    /// The data of both inputs: the even one says whether the circuit is active, the odd one the same, or the opposite of a
    /// complementary pair. (1734-UM013 Table 3)
    fn shown(&self, active: bool) -> [bool; 2] {
        let complementary = self.pair.as_ref().is_some_and(Pair::is_complementary);
        [active, active != complementary]
    }
}
