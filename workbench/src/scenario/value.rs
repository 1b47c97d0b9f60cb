//! Values as a scenario writes them, and how they are compared with what the controller shows.

use twinrung_bytecode::AdmittedImage;
use twinrung_catalog::Element;
use twinrung_compiler::diagnostic::{Finding, SCENARIO_NAME, SCENARIO_VALUE};
use twinrung_grammar::tree::scenario::{self, Condition, Literal, Relation};
use twinrung_plant::Terminal;

use crate::names;
use crate::signal::{Signal, Value};
use crate::site::Site;

use super::blocks::terminals;

/// Something to look at after a scan, and what it should be.
#[derive(Debug, Clone)]
pub struct Check {
    /// Its name as written.
    pub name: String,
    /// Where it is.
    pub place: Place,
    relation: Relation,
    wanted: Value,
    tolerance: f32,
}

/// Where something is that is looked at.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Place {
    /// In the controller.
    Signal(Signal),
    /// At a terminal of a module, by its position: whether 24 V stand there.
    Terminal(usize, Terminal),
}

impl Check {
    /// Looks a condition up. What a module or another controller receives is looked at as it is published.
    pub(super) fn new(image: &AdmittedImage, sites: &[Site], condition: &Condition) -> Result<Check, Box<Finding>> {
        match &condition.terminal {
            Some(place) => Check::at_terminal(sites, place, condition),
            None => Check::of_signal(image, condition).map_err(Box::new),
        }
    }

    fn at_terminal(sites: &[Site], place: &scenario::Terminal, condition: &Condition) -> Result<Check, Box<Finding>> {
        let (position, station) = terminals::module(sites, &place.module)?;
        let terminal = terminals::looked_at(&station, place)?;
        let name = condition.name.as_str();
        if let Some(literal) = &condition.tolerance {
            let message = format!("`{name}` is on or off, which has no tolerance");
            return Err(Box::new(Finding::new(&SCENARIO_VALUE, literal.span, message)));
        }
        Ok(Check {
            name: name.to_owned(),
            place: Place::Terminal(position, terminal),
            relation: condition.relation,
            wanted: value(name, &condition.value, Element::Bool)?,
            tolerance: 0.0,
        })
    }

    fn of_signal(image: &AdmittedImage, condition: &Condition) -> Result<Check, Finding> {
        let name = condition.name.as_str();
        let signal = names::signal(image, name)
            .map_err(|error| Finding::new(&SCENARIO_NAME, condition.name.span, error.to_string()))?;
        let signal = if is_published(image, signal) { signal.published() } else { signal };
        let element = element(signal);
        let wanted = value(name, &condition.value, element)?;
        let tolerance = match &condition.tolerance {
            None => 0.0,
            Some(literal) if element == Element::Real => match value(name, literal, element)? {
                Value::Real(tolerance) if tolerance >= 0.0 => tolerance,
                _ => return Err(Finding::new(&SCENARIO_VALUE, literal.span, "a tolerance is 0 or more")),
            },
            Some(literal) => {
                let message = format!("`{name}` is a {}, which has no tolerance", element.name());
                return Err(Finding::new(&SCENARIO_VALUE, literal.span, message)
                    .help("give a range: `NAME >= VALUE, NAME <= VALUE`"));
            }
        };
        let place = Place::Signal(signal);
        Ok(Check { name: name.to_owned(), place, relation: condition.relation, wanted, tolerance })
    }

    /// Whether a value is what is wanted. NaN is nothing that can be wanted, and only `is not` holds for it.
    pub fn holds(&self, found: Value) -> bool {
        let (found, wanted) = (plain(found), plain(self.wanted));
        let tolerance = f64::from(self.tolerance);
        match self.relation {
            Relation::Is => found == wanted || (found - wanted).abs() <= tolerance,
            Relation::IsNot => !(found == wanted || (found - wanted).abs() <= tolerance),
            Relation::Below => found < wanted,
            Relation::AtMost => found <= wanted,
            Relation::Above => found > wanted,
            Relation::AtLeast => found >= wanted,
        }
    }

    /// A value of what is looked at, as a scenario would write it.
    pub fn shown(&self, value: Value) -> String {
        shown(&self.name, value)
    }
}

/// A value as a scenario would write it: codes in base 16.
pub(crate) fn shown(name: &str, value: Value) -> String {
    match value {
        Value::Bool(value) => (if value { "on" } else { "off" }).to_owned(),
        Value::Integer(value) if is_code(name) && value != 0 => format!("16#{value:04X}"),
        other => other.to_string(),
    }
}

fn is_code(name: &str) -> bool {
    let last = name.rsplit('.').next().unwrap_or(name);
    last.eq_ignore_ascii_case("FaultCode") || last.eq_ignore_ascii_case("DiagnosticCode")
}

fn plain(value: Value) -> f64 {
    match value {
        Value::Bool(value) => f64::from(u8::from(value)),
        Value::Integer(value) => f64::from(value),
        Value::Real(value) => f64::from(value),
    }
}

/// The elementary type of a signal; that of a bit is BOOL.
pub(super) fn element(signal: Signal) -> Element {
    match signal {
        Signal::Word(_, element) | Signal::PublishedWord(_, element) => element,
        Signal::ControllerMode | Signal::ControllerFault => Element::Dint,
        _ => Element::Bool,
    }
}

/// Whether the machine sees this value.
pub(crate) fn is_published(image: &AdmittedImage, signal: Signal) -> bool {
    image.published().iter().any(|range| match signal {
        Signal::Bit(cell) => (range.bit_cell..range.bit_cell + range.bit_cells).contains(&cell.0),
        Signal::Word(cell, _) | Signal::WordBit(cell, _) => {
            (range.word_cell..range.word_cell + range.word_cells).contains(&cell.0)
        }
        _ => false,
    })
}

/// Reads a value as its type wants it.
pub(super) fn value(name: &str, literal: &Literal, element: Element) -> Result<Value, Finding> {
    let text = literal.text.as_str();
    let wrong = |why: String| Finding::new(&SCENARIO_VALUE, literal.span, why);
    let no_value = || wrong(format!("`{text}` is not a value of `{name}`, which is a {}", element.name()));
    let value = match element {
        Element::Bool => match text {
            "on" | "1" => Value::Bool(true),
            "off" | "0" => Value::Bool(false),
            _ => return Err(no_value().help("a BOOL is on or off")),
        },
        Element::Real => {
            let number: f32 = text.replace('_', "").parse().map_err(|_| no_value().help("write a REAL as 12.5"))?;
            Value::Real(number)
        }
        Element::Sint | Element::Int | Element::Dint => {
            let bits = u32::from(element.bits());
            let number = integer(text).ok_or_else(no_value)?;
            let (least, greatest) = (-(1_i64 << (bits - 1)), (1_i64 << (bits - 1)) - 1);
            // A number of another base is a pattern of bits, as the manuals print codes.
            let pattern_max = if text.contains('#') { (1_i64 << bits) - 1 } else { greatest };
            if number < least || number > pattern_max {
                let range = format!("a {} is {least} to {greatest}", element.name());
                return Err(no_value().help(range));
            }
            Value::Integer((if number > greatest { number - (1_i64 << bits) } else { number }) as i32)
        }
    };
    Ok(value)
}

fn integer(text: &str) -> Option<i64> {
    let plain = text.replace('_', "");
    match plain.split_once('#') {
        Some((base, digits)) => i64::from_str_radix(digits, base.parse().ok()?).ok(),
        None => plain.parse().ok(),
    }
}

/// What a cell holds for a value.
pub(super) fn content(value: Value) -> i32 {
    crate::cells::held(value)
}
