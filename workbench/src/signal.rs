//! The value that a running controller has for a signal.

use twinrung_bytecode::channel::Channel;
use twinrung_controller::{Controller, Mode};

pub use twinrung_contest::signal::{Signal, SignalError, Value, bit_of, number, parse_value};

/// Reading a signal of a controller.
pub trait ReadSignal {
    /// The value now.
    fn read<A: Channel, B: Channel>(self, controller: &Controller<A, B>) -> Value;
}

impl ReadSignal for Signal {
    fn read<A: Channel, B: Channel>(self, controller: &Controller<A, B>) -> Value {
        match self {
            Signal::Bit(cell) => Value::Bool(controller.bit(cell).unwrap_or_default()),
            Signal::Word(cell, element) => number(controller.word(cell).unwrap_or_default(), element),
            Signal::WordBit(cell, bit) => bit_of(controller.word(cell).unwrap_or_default(), bit),
            Signal::PublishedBit(cell) => Value::Bool(controller.published_bit(cell).unwrap_or_default()),
            Signal::PublishedWord(cell, element) => {
                number(controller.published_word(cell).unwrap_or_default(), element)
            }
            Signal::PublishedWordBit(cell, bit) => bit_of(controller.published_word(cell).unwrap_or_default(), bit),
            Signal::ControllerMode => Value::Integer(i32::from(controller.mode() == Mode::Run)),
            Signal::ControllerFault => Value::Integer(controller.stopped().map_or(0, |reason| {
                let (fault_type, code) = reason.type_and_code();
                i32::from(fault_type) * 1000 + i32::from(code)
            })),
        }
    }
}
