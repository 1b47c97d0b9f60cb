//! What every model of a module can do.

use crate::member::{Command, Reading};
use crate::settings::ModuleSettings;
use crate::stimulus::{Refusal, Signal, Stimulus, Terminal};
use crate::{analog_input, digital_input, digital_output};

/// A model of a module: terminals on one side, members of tags on the other.
pub trait Device {
    /// Whether something can happen to this module.
    ///
    /// # Errors
    ///
    /// [`Refusal`].
    fn accepts(&self, stimulus: &Stimulus) -> Result<(), Refusal>;

    /// Something happens; what is not accepted has no effect.
    fn apply(&mut self, stimulus: &Stimulus);

    /// The module looks at its terminals: once each ms.
    fn step(&mut self, now_ms: u64);

    /// What it reports.
    fn read(&self, reading: Reading) -> i32;

    /// What it is told: on or off.
    fn command(&mut self, command: Command, on: bool);

    /// Commands of one packet are complete: outputs follow at once.
    fn commanded(&mut self, now_ms: u64);

    /// No packet with commands arrives any more.
    fn output_connection_lost(&mut self, now_ms: u64);

    /// Whether the module has a terminal.
    fn has(&self, terminal: Terminal) -> bool;

    /// How often in a ms the module looks at its terminals.
    fn looks_each_ms(&self) -> u64 {
        1
    }

    /// Whether 24 V reach what is wired to a terminal, or of an input the terminal itself; nothing where there is no such
    /// terminal, or where a number stands at it.
    fn is_high(&self, terminal: Terminal) -> Option<bool>;

    /// Power-up: everything that is remembered is forgotten. Devices and wires stay as they are.
    fn power_up(&mut self, now_ms: u64);

    /// The letter of its points: `0` is `I0` at an input module.
    fn letter(&self) -> char;
}

/// The model of a module; nothing for a module that has none.
pub(crate) fn model(settings: &ModuleSettings) -> Option<Box<dyn Device>> {
    match twinrung_catalog::modules::without_series(&settings.catalog_number).to_ascii_uppercase().as_str() {
        "1734-IB8S" => Some(Box::new(digital_input::DigitalInput::new(settings))),
        "1734-OB8S" => Some(Box::new(digital_output::DigitalOutput::new(settings))),
        "1734-IE4S" => Some(Box::new(analog_input::AnalogInput::new(settings))),
        _ => None,
    }
}

/// A stimulus that concerns a terminal, with the terminal that its wire touches.
pub(crate) fn terminals(stimulus: &Stimulus) -> [Option<Terminal>; 2] {
    match stimulus {
        Stimulus::Fault(terminal, crate::Fault::To(other)) | Stimulus::FaultGone(terminal, crate::Fault::To(other)) => {
            [Some(*terminal), Some(*other)]
        }
        Stimulus::Signal(terminal, _)
        | Stimulus::Fault(terminal, _)
        | Stimulus::FaultGone(terminal, _)
        | Stimulus::Repaired(terminal) => [Some(*terminal), None],
        Stimulus::FieldPower(_) | Stimulus::Present(_) | Stimulus::Running(_) => [None, None],
    }
}

/// A wire that touches itself is refused by every module.
pub(crate) fn not_itself(stimulus: &Stimulus) -> Result<(), Refusal> {
    match stimulus {
        Stimulus::Fault(terminal, crate::Fault::To(other)) if terminal == other => Err(Refusal::Itself(*terminal)),
        _ => Ok(()),
    }
}

/// An error inside the module, where no source tells what it does: all but the points with `letter`.
pub(crate) fn inside_only(stimulus: &Stimulus, letter: Option<char>) -> Result<(), Refusal> {
    match stimulus {
        Stimulus::Fault(terminal, crate::Fault::Inside) if Some(terminal.letter) != letter => {
            Err(Refusal::NotInside(*terminal))
        }
        _ => Ok(()),
    }
}

/// A device that is on or off, where it may be one; nothing for contacts that follow an output, which the plant moves.
pub(crate) fn contact(terminal: Terminal, signal: Signal) -> Result<Option<bool>, Refusal> {
    match signal {
        Signal::Contact(closed) => Ok(Some(closed)),
        Signal::Follows(_) => Ok(None),
        Signal::Amount(_) => Err(Refusal::NotAnAmount(terminal)),
    }
}
