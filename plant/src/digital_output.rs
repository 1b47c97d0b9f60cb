//! 1734-OB8S: eight safety outputs. Source: 1734-UM013, Safety Outputs; Figures 18 to 20; Tables 14 and 20.

use crate::device::{self, Device};
use crate::error_latch::ErrorLatch;
use crate::member::{Command, Reading};
use crate::settings::{ModuleSettings, PointSettings};
use crate::stimulus::{Refusal, Stimulus, Terminal};
use crate::wiring::{Field, Node};

/// Safety outputs.
const OUTPUTS: u8 = 8;
/// Period of the test pulses in ms; a pulse lasts 475 µs. 1734-UM013 Figure 18 (typical values).
pub const PULSE_PERIOD_MS: u64 = 575;
/// Outputs pulse one after the other, so many ms apart (decided).
pub const PULSE_OFFSET_MS: u64 = PULSE_PERIOD_MS / OUTPUTS as u64;

/// Why an output shows an error: the codes of 1734-UM013 Table 14. `Configuration invalid` (1) is refused by the compiler, and
/// `Short circuit detected` (3) cannot be told from a short at the output.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum OutputFault {
    /// No error.
    None = 0,
    /// It is on and touches 0 V.
    OverCurrent = 2,
    /// 24 V stand at it while it is off: stuck high, until the module loses power.
    OutputOn = 4,
    /// The other output of the pair has an error.
    Partner = 5,
    /// The outputs of a pair are not commanded alike.
    DualChannelViolation = 8,
    /// 24 V stand at it during its test pulse.
    ShortCircuit = 9,
}

/// One output.
#[derive(Debug, Clone)]
struct Output {
    number: u8,
    used: bool,
    pulses: bool,
    /// Whether it is switched together with its neighbour.
    dual: bool,
    commanded: bool,
    latch: ErrorLatch,
    fault: OutputFault,
    /// It was found stuck high: only a loss of power ends that.
    stuck: bool,
}

impl Output {
    /// As configured: dual where the project does not say (Table 20); a point that is not configured is not used.
    fn new(number: u8, settings: &PointSettings) -> Output {
        let pulses = settings.has("Mode", "SAFETY_PULSE_TEST");
        Output {
            number,
            used: pulses || settings.has("Mode", "SAFETY"),
            pulses,
            dual: !settings.has("Channel", "SINGLE"),
            commanded: false,
            latch: ErrorLatch::new(settings.error_latch_ms()),
            fault: OutputFault::None,
            stuck: false,
        }
    }

    fn power_up(&mut self) {
        self.commanded = false;
        self.latch.power_up();
        self.fault = OutputFault::None;
        self.stuck = false;
    }

    fn found(&mut self, now_ms: u64, fault: OutputFault) {
        self.latch.seen(now_ms);
        // What was found first says most; a partner's error says least.
        if matches!(self.fault, OutputFault::None | OutputFault::Partner) {
            self.fault = fault;
        }
    }
}

/// What one look at an output finds; the default is an output about which there is nothing to say.
#[derive(Debug, Clone, Copy, Default)]
struct Look {
    cause: Option<OutputFault>,
    paired: bool,
    commanded: bool,
    stuck: bool,
}

/// A 1734-OB8S.
pub struct DigitalOutput {
    outputs: Vec<Output>,
    field: Field,
    origin_ms: u64,
}

fn output_node(number: u8) -> Node {
    Node(2 + number)
}

fn node(terminal: Terminal) -> Option<Node> {
    (terminal.letter == 'O' && terminal.number < OUTPUTS).then(|| output_node(terminal.number))
}

impl DigitalOutput {
    /// As a project configures it.
    pub fn new(settings: &ModuleSettings) -> DigitalOutput {
        DigitalOutput {
            outputs: (0..OUTPUTS).map(|number| Output::new(number, &settings.of(Terminal::new('O', number)))).collect(),
            field: Field::new(node),
            origin_ms: 0,
        }
    }

    /// Why an output shows an error.
    pub fn fault(&self, number: u8) -> OutputFault {
        self.outputs.get(usize::from(number)).map_or(OutputFault::None, |output| output.fault)
    }

    fn partner(&self, output: &Output) -> Option<&Output> {
        self.outputs.get(usize::from(output.number ^ 1)).filter(|other| output.dual && other.used && output.used)
    }

    /// Whether an output drives its terminal: it is commanded, it has no error, and the same holds for its partner.
    fn drives(&self, output: &Output) -> bool {
        let may = |one: &Output| one.used && one.commanded && one.fault == OutputFault::None;
        self.field.power && may(output) && self.partner(output).is_none_or(may)
    }

    fn driven(&self, pulsing: Option<u8>) -> u32 {
        let mut driven = if self.field.power { Node::SUPPLY.mask() } else { 0 };
        for output in self.outputs.iter().filter(|output| Some(output.number) != pulsing && self.drives(output)) {
            driven |= output_node(output.number).mask();
        }
        driven
    }

    fn pulse(&self, now_ms: u64) -> Option<u8> {
        let phase = now_ms.saturating_sub(self.origin_ms) % PULSE_PERIOD_MS;
        let slot = u8::try_from(phase / PULSE_OFFSET_MS).ok().filter(|slot| *slot < OUTPUTS)?;
        phase.is_multiple_of(PULSE_OFFSET_MS).then_some(slot)
    }

    /// What is wrong with an output now.
    fn cause(&self, output: &Output, now_ms: u64) -> Option<OutputFault> {
        if !self.field.power || !output.used {
            return None;
        }
        let at = output_node(output.number);
        let (drives, driven) = (self.drives(output), self.driven(None));
        if drives && self.field.wiring.is_grounded(at) {
            return Some(OutputFault::OverCurrent);
        }
        if drives && output.pulses && self.pulse(now_ms) == Some(output.number) {
            let high = self.field.wiring.is_high(at, self.driven(Some(output.number)));
            return high.then_some(OutputFault::ShortCircuit);
        }
        if !drives && self.field.wiring.is_high(at, driven) {
            return Some(OutputFault::OutputOn);
        }
        let differs = self.partner(output).is_some_and(|other| other.commanded != output.commanded);
        differs.then_some(OutputFault::DualChannelViolation)
    }

    /// Looks at every output. A pair has one verdict.
    fn judge(&mut self, now_ms: u64) {
        let mut looks = [Look::default(); OUTPUTS as usize];
        for (look, output) in looks.iter_mut().zip(&self.outputs) {
            let cause = self.cause(output, now_ms);
            let supplied = self.field.wiring.is_high(output_node(output.number), Node::SUPPLY.mask());
            *look = Look {
                cause,
                paired: self.partner(output).is_some(),
                commanded: output.commanded,
                // Stuck high is what the field power holds high, and not what another output of the module drives.
                stuck: output.stuck || cause == Some(OutputFault::OutputOn) && supplied,
            };
        }
        for (at, output) in self.outputs.iter_mut().enumerate() {
            let Some(own) = looks.get(at) else { continue };
            let other = looks.get(at ^ 1).filter(|_| own.paired).copied().unwrap_or_default();
            output.stuck = own.stuck;
            match (own.cause, other.cause) {
                (Some(fault), _) => output.found(now_ms, fault),
                (None, Some(_)) => output.found(now_ms, OutputFault::Partner),
                (None, None) => {
                    let off = !own.commanded && !other.commanded;
                    let held = own.stuck || other.stuck;
                    output.latch.gone(now_ms, off && !held);
                    if !output.latch.is_set() {
                        output.fault = OutputFault::None;
                    }
                }
            }
        }
    }

    fn status(&self, number: u8) -> bool {
        self.field.power && self.fault(number) == OutputFault::None
    }
}

impl Device for DigitalOutput {
    fn accepts(&self, stimulus: &Stimulus) -> Result<(), Refusal> {
        for terminal in device::terminals(stimulus).into_iter().flatten() {
            node(terminal).ok_or(Refusal::NoTerminal(terminal))?;
            if !self.outputs.get(usize::from(terminal.number)).is_some_and(|output| output.used) {
                return Err(Refusal::NotUsed(terminal));
            }
        }
        if let Stimulus::Signal(terminal, _) = stimulus {
            return Err(Refusal::NoDevice(*terminal));
        }
        device::inside_only(stimulus, None)?;
        device::not_itself(stimulus)
    }

    fn apply(&mut self, stimulus: &Stimulus) {
        if self.accepts(stimulus).is_err() {
            return;
        }
        self.field.apply(stimulus);
    }

    fn step(&mut self, now_ms: u64) {
        self.judge(now_ms);
    }

    fn read(&self, reading: Reading) -> i32 {
        let bit = match reading {
            Reading::Status(number) => self.status(number),
            Reading::CombinedStatus => (0..OUTPUTS).all(|number| self.status(number)),
            // The monitor sits at the output circuit: a wire that is broken behind it is not seen.
            Reading::Readback(number) => {
                self.field.wiring.is_high(output_node(number.min(OUTPUTS - 1)), self.driven(None))
            }
            // Marked an error bit by the manual: 1 is the error. (1734-UM013, Values and States of Tags)
            Reading::Power => !self.field.power,
            _ => false,
        };
        i32::from(bit)
    }

    fn command(&mut self, command: Command, on: bool) {
        if let Command::Output(number) = command
            && let Some(output) = self.outputs.get_mut(usize::from(number))
        {
            output.commanded = on;
        }
    }

    fn commanded(&mut self, now_ms: u64) {
        self.judge(now_ms);
    }

    fn output_connection_lost(&mut self, now_ms: u64) {
        self.outputs.iter_mut().for_each(|output| output.commanded = false);
        self.judge(now_ms);
    }

    fn has(&self, terminal: Terminal) -> bool {
        node(terminal).is_some()
    }

    /// What the actuator gets: nothing through a broken wire.
    fn is_high(&self, terminal: Terminal) -> Option<bool> {
        let high = self.field.wiring.is_high(node(terminal)?, self.driven(None));
        Some(high && !self.field.faults.is_open(terminal))
    }

    fn power_up(&mut self, now_ms: u64) {
        self.origin_ms = now_ms;
        self.outputs.iter_mut().for_each(Output::power_up);
    }

    fn letter(&self) -> char {
        'O'
    }
}
