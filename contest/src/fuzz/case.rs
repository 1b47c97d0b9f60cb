//! A case on disk: the program as `.rll`, its inputs as CSV, both for a person to read and for `--replay` to run again.
//!
//! The CSV has a line for each step: `ms` its time, `step` whether it is a scan or a prescan, `budget` the instructions that it
//! may execute, `system_values` the seed of what GSV reads from there on, then one column for each tag. An empty cell leaves
//! the tag as it was. A REAL stands as its bits, `16#7fc00000`, since not every NaN has another spelling.

use std::fmt;

use twinrung_bytecode::AdmittedImage;
use twinrung_catalog::Element;

use crate::generate::{Step, Stimulus};
use crate::names;
use crate::signal::{Signal, Value, parse_value};

/// A program and its inputs.
#[derive(Debug, Clone, PartialEq)]
pub struct Case {
    /// The project as `.rll`.
    pub text: String,
    /// The steps.
    pub stimulus: Stimulus,
}

/// Why the inputs of a case cannot be read.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CaseError {
    /// Line in the file, from 1.
    pub line: u64,
    /// What is wrong there.
    pub message: String,
}

impl fmt::Display for CaseError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "line {}: {}", self.line, self.message)
    }
}

impl std::error::Error for CaseError {}

/// The columns before the tags.
const COLUMNS: [&str; 4] = ["ms", "step", "budget", "system_values"];

impl Case {
    /// The inputs as CSV.
    pub fn to_csv(&self) -> String {
        let mut tags: Vec<&str> = Vec::new();
        for (name, _) in self.stimulus.steps.iter().flat_map(|step| &step.values) {
            if !tags.contains(&name.as_str()) {
                tags.push(name);
            }
        }
        let mut text = COLUMNS.iter().chain(&tags).map(|name| quoted(name)).collect::<Vec<_>>().join(",");
        text.push('\n');
        for step in &self.stimulus.steps {
            let kind = if step.prescan { "prescan" } else { "scan" };
            let system = step.system_values.map_or(String::new(), |seed| seed.to_string());
            text.push_str(&format!("{},{kind},{},{system}", step.now_ms, self.stimulus.budget));
            for tag in &tags {
                let value = step.values.iter().find(|(name, _)| name == tag);
                text.push(',');
                text.push_str(&value.map_or(String::new(), |(_, value)| shown(*value)));
            }
            text.push('\n');
        }
        text
    }

    /// Reads the inputs of a program.
    ///
    /// # Errors
    ///
    /// The first line that is not as [`Case::to_csv`] writes it, or that names no tag of the program.
    pub fn read(text: String, csv: &str, image: &AdmittedImage) -> Result<Case, CaseError> {
        let wrong = |line: u64, message: String| CaseError { line, message };
        let mut reader = csv::ReaderBuilder::new().from_reader(csv.as_bytes());
        let header = reader.headers().map_err(|error| wrong(1, error.to_string()))?.clone();
        if header.iter().take(COLUMNS.len()).ne(COLUMNS) {
            return Err(wrong(1, format!("the first columns are {}", COLUMNS.join(", "))));
        }
        let mut signals: Vec<(String, Signal)> = Vec::new();
        for name in header.iter().skip(COLUMNS.len()) {
            let signal = names::signal(image, name).map_err(|error| wrong(1, error.to_string()))?;
            signals.push((name.to_owned(), signal));
        }
        let mut stimulus = Stimulus { budget: 0, steps: Vec::new() };
        for record in reader.records() {
            let place = |error: &csv::Error| error.position().map_or(0, csv::Position::line);
            let record = record.map_err(|error| wrong(place(&error), error.to_string()))?;
            let line = record.position().map_or(0, csv::Position::line);
            let found = record.get(0).unwrap_or_default();
            let now_ms: i64 = found.parse().map_err(|_| wrong(line, format!("`{found}` is no time in ms")))?;
            let prescan = match record.get(1) {
                Some("scan") => false,
                Some("prescan") => true,
                other => {
                    return Err(wrong(line, format!("`{}` is neither scan nor prescan", other.unwrap_or_default())));
                }
            };
            let budget = record.get(2).unwrap_or_default();
            let budget: u64 =
                budget.parse().map_err(|_| wrong(line, format!("`{budget}` is no number of instructions")))?;
            if !stimulus.steps.is_empty() && budget != stimulus.budget {
                return Err(wrong(line, "every step of a case has one budget".to_owned()));
            }
            stimulus.budget = budget;
            let system = record.get(3).unwrap_or_default();
            let system_values = match system {
                "" => None,
                text => Some(text.parse().map_err(|_| wrong(line, format!("`{text}` is no seed of system values")))?),
            };
            let mut values = Vec::new();
            for ((name, signal), cell) in signals.iter().zip(record.iter().skip(COLUMNS.len())) {
                if !cell.is_empty() {
                    let value = read_value(name, *signal, cell).map_err(|message| wrong(line, message))?;
                    values.push((name.clone(), value));
                }
            }
            stimulus.steps.push(Step { now_ms, prescan, values, system_values });
        }
        Ok(Case { text, stimulus })
    }
}

/// A name with a comma in it, of an element of an array with several dimensions, stands in quotes.
fn quoted(name: &str) -> String {
    if name.contains(',') { format!("\"{name}\"") } else { name.to_owned() }
}

fn shown(value: Value) -> String {
    match value {
        Value::Real(value) => format!("16#{:08x}", value.to_bits()),
        other => other.to_string(),
    }
}

fn read_value(name: &str, signal: Signal, cell: &str) -> Result<Value, String> {
    let integer = |element| parse_value(name, cell, element).map_err(|error| error.to_string());
    match signal {
        Signal::Bit(_) => Ok(Value::Bool(integer(Element::Bool)? == 1)),
        Signal::Word(_, Element::Real) => {
            let bits = cell.strip_prefix("16#").and_then(|digits| u32::from_str_radix(digits, 16).ok());
            bits.map(|bits| Value::Real(f32::from_bits(bits)))
                .ok_or_else(|| format!("`{cell}` is not the bits of a REAL, 16#7fc00000"))
        }
        Signal::Word(_, element) => Ok(Value::Integer(integer(element)?)),
        _ => Err(format!("`{name}` is no whole tag")),
    }
}
