//! 1734-IB8S: eight safety inputs and four test outputs. Source: 1734-UM013, Safety Inputs; Tables 3, 4, 12, 13, 18, 19.

mod circuit;
mod delay;
mod lamp;
mod pair;
mod test_output;

pub use circuit::InputFault;
use circuit::{Circuit, Input};
use lamp::MutingLamp;
pub use test_output::TestFault;
use test_output::{TestMode, TestOutput};

use crate::device::{self, Device};
use crate::error_latch::ErrorLatch;
use crate::member::{Command, Reading};
use crate::settings::{ERROR_LATCH_MS, ModuleSettings};
use crate::stimulus::{Refusal, Stimulus, Terminal};
use crate::wiring::{Field, Node};

/// Safety inputs.
const INPUTS: u8 = 8;
/// Test outputs.
const TESTS: u8 = 4;
/// Period of the test pulses in ms; a pulse lasts 525 µs. 1734-UM013 Figure 5 (typical values).
pub const PULSE_PERIOD_MS: u64 = 144;
/// Test outputs pulse one after the other, so that each can be told from the others: so many ms apart (decided).
pub const PULSE_OFFSET_MS: u64 = PULSE_PERIOD_MS / TESTS as u64;

/// A 1734-IB8S.
pub struct DigitalInput {
    inputs: Vec<Input>,
    circuits: Vec<Circuit>,
    tests: Vec<TestOutput>,
    /// Devices: whether the contact between an input and its source is closed.
    closed: [bool; INPUTS as usize],
    field: Field,
    /// When power-up was, in ms: pulses and lamp tests are counted from it.
    origin_ms: u64,
    /// The error of the field power. No input circuit had one, so that the inputs come back without being cycled (decided: what
    /// comes back by itself shows whether the logic restarts by itself).
    power: ErrorLatch,
}

fn input_node(number: u8) -> Node {
    Node(2 + number)
}

fn test_node(number: u8) -> Node {
    Node(2 + INPUTS + number)
}

fn node(terminal: Terminal) -> Option<Node> {
    match terminal.letter {
        'I' if terminal.number < INPUTS => Some(input_node(terminal.number)),
        'T' if terminal.number < TESTS => Some(test_node(terminal.number)),
        _ => None,
    }
}

impl DigitalInput {
    /// As a project configures it.
    pub fn new(settings: &ModuleSettings) -> DigitalInput {
        let inputs: Vec<Input> =
            (0..INPUTS).map(|number| Input::new(&settings.of(Terminal::new('I', number)))).collect();
        let latch_ms = settings
            .points
            .iter()
            .filter(|(terminal, _)| terminal.letter == 'I')
            .map(|(terminal, _)| settings.of(*terminal).error_latch_ms())
            .max()
            .unwrap_or(ERROR_LATCH_MS);
        DigitalInput {
            inputs,
            circuits: circuit::circuits(settings),
            tests: (0..TESTS)
                .map(|number| TestOutput::new(number, &settings.of(Terminal::new('T', number)), latch_ms))
                .collect(),
            closed: [false; INPUTS as usize],
            field: Field::new(node),
            origin_ms: 0,
            power: ErrorLatch::new(latch_ms),
        }
    }

    /// Why a circuit shows an error. (1734-UM013 Table 12)
    pub fn input_fault(&self, number: u8) -> InputFault {
        let found = self.circuits.iter().find_map(|circuit| circuit.fault_of(number));
        found.unwrap_or(InputFault::None)
    }

    /// Why a test output shows an error. (1734-UM013 Table 13)
    pub fn test_fault(&self, number: u8) -> TestFault {
        self.tests.get(usize::from(number)).map_or(TestFault::None, TestOutput::fault)
    }

    /// Joins what the contacts that are closed join, after what the faults of wires do.
    fn join_contacts(&mut self) {
        for (number, (input, closed)) in (0..).zip(self.inputs.iter().zip(self.closed)) {
            if closed && !self.field.faults.is_open(Terminal::new('I', number)) {
                // A device without a test source switches 24 V of the field power.
                let source = match input.source {
                    Some(test) if self.field.faults.is_open(Terminal::new('T', test)) => continue,
                    Some(test) => test_node(test),
                    None => Node::SUPPLY,
                };
                self.field.wiring.join(input_node(number), source);
            }
        }
    }

    /// The nodes that are driven while one test output, or none, is in its pulse.
    fn driven(&self, pulsing: Option<u8>) -> u32 {
        if !self.field.power {
            return 0;
        }
        let tests = self.tests.iter().filter(|test| test.is_on() && !(test.pulses() && Some(test.number) == pulsing));
        tests.fold(Node::SUPPLY.mask(), |driven, test| driven | test_node(test.number).mask())
    }

    /// The test output whose pulse is now.
    fn pulse(&self, now_ms: u64) -> Option<u8> {
        let phase = now_ms.saturating_sub(self.origin_ms) % PULSE_PERIOD_MS;
        let slot = phase.is_multiple_of(PULSE_OFFSET_MS).then_some(phase / PULSE_OFFSET_MS);
        slot.and_then(|slot| u8::try_from(slot).ok()).filter(|slot| *slot < TESTS)
    }

    /// Compares what is there during the pulse of a test output with what should be: nothing.
    fn judge_pulse(&mut self, test: u8, now_ms: u64) {
        let driven = self.driven(Some(test));
        for (number, input) in (0..).zip(&mut self.inputs) {
            if input.is_pulse_tested() && input.source == Some(test) {
                input.test_failed = self.field.wiring.is_high(input_node(number), driven);
            }
        }
        let joined = self.field.wiring.joined(test_node(test));
        let high = self.field.wiring.is_high(test_node(test), driven);
        if let Some(output) = self.tests.get_mut(usize::from(test)).filter(|output| output.pulses()) {
            let supply = joined & Node::SUPPLY.mask() != 0;
            output.judge_pulse(now_ms, high.then_some(if supply { TestFault::OutputOn } else { TestFault::Cross }));
        }
    }

    fn status(&self, number: u8) -> bool {
        self.field.power && !self.power.is_set() && self.input_fault(number) == InputFault::None
    }

    /// Without field power, and as long as that is latched, all data is in the safe state. (1756-RM093, De-energize to Trip
    /// System)
    fn data(&self, number: u8) -> bool {
        let powered = self.field.power && !self.power.is_set();
        let found = self.circuits.iter().find_map(|circuit| circuit.data_of(number, powered));
        found.unwrap_or(false)
    }
}

impl Device for DigitalInput {
    fn accepts(&self, stimulus: &Stimulus) -> Result<(), Refusal> {
        for terminal in device::terminals(stimulus).into_iter().flatten() {
            node(terminal).ok_or(Refusal::NoTerminal(terminal))?;
            let used = match terminal.letter {
                'I' => self.inputs.get(usize::from(terminal.number)).is_some_and(Input::is_used),
                _ => self.tests.get(usize::from(terminal.number)).is_some_and(|test| test.mode != TestMode::NotUsed),
            };
            if !used {
                return Err(Refusal::NotUsed(terminal));
            }
        }
        if let Stimulus::Signal(terminal, signal) = stimulus {
            device::contact(*terminal, *signal)?;
            if terminal.letter != 'I' {
                return Err(Refusal::NoDevice(*terminal));
            }
        }
        device::inside_only(stimulus, Some('I'))?;
        device::not_itself(stimulus)
    }

    fn apply(&mut self, stimulus: &Stimulus) {
        if self.accepts(stimulus).is_err() {
            return;
        }
        if let Stimulus::Signal(terminal, signal) = stimulus
            && let (Ok(Some(closed)), Some(own)) =
                (device::contact(*terminal, *signal), self.closed.get_mut(usize::from(terminal.number)))
        {
            *own = closed;
        }
        self.field.apply(stimulus);
        self.join_contacts();
    }

    fn step(&mut self, now_ms: u64) {
        match self.field.power {
            false => self.power.seen(now_ms),
            true => self.power.gone(now_ms, true),
        }
        if !self.field.power {
            self.inputs.iter_mut().for_each(Input::power_up);
        }
        let driven = self.driven(None);
        for test in &mut self.tests {
            let at = test_node(test.number);
            let grounded = self.field.wiring.is_grounded(at);
            let supplied = self.field.wiring.joined(at) & Node::SUPPLY.mask() != 0;
            test.step(now_ms, self.field.power, grounded, supplied);
            let broken = self.field.faults.is_open(Terminal::new('T', test.number)) || grounded;
            let on = test.is_on();
            if let Some(lamp) = &mut test.lamp {
                match self.field.power {
                    true => lamp.step(now_ms.saturating_sub(self.origin_ms), on, broken),
                    false => lamp.rest(),
                }
            }
        }
        if let Some(test) = self.pulse(now_ms).filter(|_| self.field.power) {
            self.judge_pulse(test, now_ms);
        }
        for (number, input) in (0..).zip(&mut self.inputs) {
            input.failed_inside = self.field.faults.is_inside(Terminal::new('I', number));
            input.look(now_ms, self.field.wiring.is_high(input_node(number), driven));
        }
        for circuit in &mut self.circuits {
            match self.field.power {
                true => circuit.step(now_ms, &self.inputs),
                false => circuit.rest(),
            }
        }
    }

    fn read(&self, reading: Reading) -> i32 {
        let bit = match reading {
            Reading::Data(number) => self.data(number),
            Reading::Status(number) => self.status(number),
            Reading::CombinedStatus => (0..INPUTS).all(|number| self.status(number)),
            // Marked an error bit by the manual: 1 is the error. (1734-UM013, Values and States of Tags)
            Reading::Power => !self.field.power,
            Reading::Muting(number) => {
                let lamp = self.tests.get(usize::from(number)).and_then(|test| test.lamp.as_ref());
                self.field.power && lamp.is_none_or(MutingLamp::status)
            }
            Reading::TestStatus(number) => self.field.power && self.test_fault(number) == TestFault::None,
            _ => false,
        };
        i32::from(bit)
    }

    fn command(&mut self, command: Command, on: bool) {
        if let Command::Test(number) = command
            && let Some(test) = self.tests.get_mut(usize::from(number))
        {
            test.commanded = on;
        }
    }

    fn commanded(&mut self, _now_ms: u64) {}

    fn output_connection_lost(&mut self, _now_ms: u64) {
        for test in self.tests.iter_mut().filter(|test| !test.holds_last) {
            test.commanded = false;
        }
    }

    fn has(&self, terminal: Terminal) -> bool {
        node(terminal).is_some()
    }

    fn is_high(&self, terminal: Terminal) -> Option<bool> {
        let high = self.field.wiring.is_high(node(terminal)?, self.driven(None));
        // What is wired to a test output gets nothing through a broken wire.
        Some(high && !(terminal.letter == 'T' && self.field.faults.is_open(terminal)))
    }

    fn power_up(&mut self, now_ms: u64) {
        self.origin_ms = now_ms;
        self.power.power_up();
        self.inputs.iter_mut().for_each(Input::power_up);
        self.circuits.iter_mut().for_each(Circuit::power_up);
        self.tests.iter_mut().for_each(TestOutput::power_up);
    }

    fn letter(&self) -> char {
        'I'
    }
}
