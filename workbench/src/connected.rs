//! What a value is connected to, and what it means to force it or to inhibit its module.

use std::fmt;

use twinrung_bytecode::AdmittedImage;
use twinrung_bytecode::CellRange;
use twinrung_bytecode::image::TagKind;
use twinrung_bytecode::index::TagIndex;
use twinrung_catalog::Element;

use crate::hold::{Held, Hold};
use crate::names;
use crate::signal::{Signal, SignalError, parse_value};

/// What a value is connected to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Connection {
    /// It comes from a module or a producer.
    Input,
    /// It goes to a module or to consumers.
    Output,
    /// It comes from a standard tag.
    Mapped,
    /// It is data of the safety task.
    None,
}

/// Why a value cannot be forced.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum ForceError {
    /// Its name or its value.
    Signal(SignalError),
    /// It is no data of an I/O, produced or consumed tag.
    NotConnected {
        /// The name as written.
        name: String,
    },
}

impl fmt::Display for ForceError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            ForceError::Signal(error) => write!(f, "{error}"),
            ForceError::NotConnected { name } => {
                write!(f, "`{name}` is not forced: only data of I/O, produced and consumed safety tags is")
            }
        }
    }
}

impl std::error::Error for ForceError {}

fn holds_signal(range: &CellRange, signal: Signal) -> bool {
    let within = |cell: u32, first: u32, count: u32| cell.checked_sub(first).is_some_and(|offset| offset < count);
    match signal {
        Signal::Bit(cell) => within(cell.0, range.bit_cell, range.bit_cells),
        Signal::Word(cell, _) | Signal::WordBit(cell, _) => within(cell.0, range.word_cell, range.word_cells),
        _ => false,
    }
}

/// What a value is connected to.
pub fn connection(image: &AdmittedImage, signal: Signal) -> Connection {
    let kind = |range: &CellRange| image.image().tags.get(range.tag.position()).map(|tag| tag.kind);
    if let Some(range) = image.frozen().iter().find(|range| holds_signal(range, signal)) {
        return match kind(range) {
            Some(TagKind::ModuleInput | TagKind::Consumed) => Connection::Input,
            _ => Connection::Mapped,
        };
    }
    match image.published().iter().find(|range| holds_signal(range, signal)).and_then(kind) {
        Some(TagKind::ModuleOutput | TagKind::Produced) => Connection::Output,
        _ => Connection::None,
    }
}

fn held(signal: Signal, value: i32) -> Option<Held> {
    match signal {
        Signal::Bit(cell) => Some(Held::Bit(cell, value == 1)),
        Signal::Word(cell, _) => Some(Held::Word(cell, value)),
        Signal::WordBit(cell, bit) => Some(Held::WordBit(cell, bit, value == 1)),
        _ => None,
    }
}

/// What a force on a value holds (1756-RM093 Force Data: all data of I/O, produced and consumed safety tags).
///
/// # Errors
///
/// [`ForceError`].
pub fn force(image: &AdmittedImage, name: &str, value: &str) -> Result<Hold, ForceError> {
    let signal = names::signal(image, name).map_err(ForceError::Signal)?;
    let element = if let Signal::Word(_, element) = signal { element } else { Element::Bool };
    let not_connected = || ForceError::NotConnected { name: name.to_owned() };
    let side = match connection(image, signal) {
        Connection::Input => Hold::Input,
        Connection::Output => Hold::Output,
        Connection::Mapped | Connection::None => return Err(not_connected()),
    };
    let value = parse_value(name, value, element).map_err(ForceError::Signal)?;
    held(signal, value).map(side).ok_or_else(not_connected)
}

/// The names that a stimulus drives which are safety data of the task itself: driving them is data manipulation.
pub fn safety_data<'a>(image: &AdmittedImage, names: &'a [String]) -> Vec<&'a str> {
    let is_data =
        |name: &&String| names::driven(image, name).is_ok_and(|signal| connection(image, signal) == Connection::None);
    names.iter().filter(is_data).map(String::as_str).collect()
}

/// What holds while the connection of a module is inhibited: data is 0, RunMode is 0, ConnectionFaulted is 1, outputs are off.
/// `None` where no safety tag is of this module. (1756-RM093 Table 9; neutral-text-and-l5x.md D.3, decided)
pub fn inhibited(image: &AdmittedImage, module: &str) -> Option<Vec<Hold>> {
    let mut holds = Vec::new();
    for (index, tag) in image.image().tags.iter().enumerate() {
        let of_module = tag.name.rsplit_once(':').is_some_and(|(owner, _)| owner.eq_ignore_ascii_case(module));
        let side = match tag.kind {
            TagKind::ModuleInput if of_module => Hold::Input,
            TagKind::ModuleOutput if of_module => Hold::Output,
            _ => continue,
        };
        for (name, signal) in names::values_of(image, TagIndex(index as u32)) {
            let faulted =
                name.rsplit('.').next().is_some_and(|member| member.eq_ignore_ascii_case("ConnectionFaulted"));
            holds.extend(held(signal, i32::from(faulted)).map(side));
        }
    }
    Some(holds).filter(|holds| !holds.is_empty())
}
