//! Reading a vector file.

use crate::error::{VectorError, VectorErrorKind as Kind};
use crate::value;
use crate::vector::{Expectation, Setting, Step, Vector};
use alloc::vec::Vec;
use twinrung_catalog::operand::OperandKind;
use twinrung_catalog::{MemberRole, Opcode, SafetyApplication};

/// Reads the vectors of an instruction out of the text of its file.
///
/// # Errors
///
/// The first line that cannot be read, with its number and the reason.
pub fn parse(opcode: Opcode, text: &'static str) -> Result<Vec<Vector>, VectorError> {
    let Some(declaration) = opcode.instruction().safety else {
        return Err(VectorError { opcode, line: 0, kind: Kind::NoVectors });
    };
    let mut reader = Reader { opcode, declaration, open: None, done: Vec::new() };
    let mut last = 0;
    for (number, line) in (1..).zip(text.lines()) {
        last = number;
        reader.line(line.trim()).map_err(|kind| VectorError { opcode, line: number, kind })?;
    }
    match reader.open {
        None => Ok(reader.done),
        Some(_) => Err(VectorError { opcode, line: last, kind: Kind::Incomplete }),
    }
}

struct Reader {
    opcode: Opcode,
    declaration: &'static SafetyApplication,
    open: Option<Vector>,
    done: Vec<Vector>,
}

impl Reader {
    fn line(&mut self, line: &'static str) -> Result<(), Kind> {
        if line.is_empty() || line.starts_with(';') {
            return Ok(());
        }
        let (word, rest) = line.split_once(char::is_whitespace).unwrap_or((line, ""));
        let rest = rest.trim();
        if word == "vector" {
            return self.begin(rest);
        }
        let (opcode, declaration) = (self.opcode, self.declaration);
        let vector = self.open.as_mut().ok_or(Kind::OutOfPlace)?;
        if word.starts_with(|first: char| first.is_ascii_digit()) {
            let at_ms = word.parse().map_err(|_| Kind::BadNumber)?;
            if rest == "end" {
                check_time(vector, at_ms, true)?;
                vector.end_ms = at_ms;
                return self.finish();
            }
            check_time(vector, at_ms, false)?;
            vector.steps.push(step(opcode, declaration, at_ms, rest)?);
            return Ok(());
        }
        if !vector.steps.is_empty() {
            return Err(Kind::OutOfPlace);
        }
        match word {
            "shows" => vector.shows = rest,
            "source" => vector.source = rest,
            "mark" => vector.mark = rest,
            "normal" => vector.normal = rest,
            "period" => vector.periods_ms = periods(rest)?,
            "config" => {
                for item in rest.split_whitespace() {
                    vector.configuration.push(setting(opcode, declaration, item)?);
                }
            }
            _ => return Err(Kind::UnknownLine),
        }
        Ok(())
    }

    fn begin(&mut self, name: &'static str) -> Result<(), Kind> {
        if self.open.is_some() || name.is_empty() {
            return Err(Kind::Incomplete);
        }
        self.open = Some(Vector {
            opcode: self.opcode,
            name,
            shows: "",
            source: "",
            mark: "",
            normal: "",
            periods_ms: Vec::new(),
            configuration: Vec::new(),
            steps: Vec::new(),
            end_ms: 0,
        });
        Ok(())
    }

    fn finish(&mut self) -> Result<(), Kind> {
        let vector = self.open.take().ok_or(Kind::OutOfPlace)?;
        let begins = vector.steps.first().is_some_and(|first| first.at_ms == 0);
        if !begins || vector.periods_ms.is_empty() || vector.source.is_empty() || vector.mark.is_empty() {
            return Err(Kind::Incomplete);
        }
        self.done.push(vector);
        Ok(())
    }
}

/// A step comes after the one before it, the end not before the last step; both fall on a scan at every period.
fn check_time(vector: &Vector, at_ms: u32, end: bool) -> Result<(), Kind> {
    let rises = vector.steps.last().is_none_or(|before| before.at_ms < at_ms || end && before.at_ms == at_ms);
    let scanned = vector.periods_ms.iter().all(|period| at_ms.checked_rem(*period) == Some(0));
    if rises && scanned { Ok(()) } else { Err(Kind::BadTime) }
}

fn periods(text: &str) -> Result<Vec<u32>, Kind> {
    text.split_whitespace().map(|word| word.parse().ok().filter(|period| *period > 0).ok_or(Kind::BadNumber)).collect()
}

fn step(opcode: Opcode, declaration: &'static SafetyApplication, at_ms: u32, text: &'static str) -> Result<Step, Kind> {
    let (changes, expectations) = text.split_once("->").unwrap_or((text, ""));
    let mut step = Step { at_ms, leap_ms: 0, prescan: false, rung: None, inputs: Vec::new(), expected: Vec::new() };
    for item in changes.split_whitespace() {
        match item {
            "prescan" => step.prescan = true,
            "rung=0" => step.rung = Some(false),
            "rung=1" => step.rung = Some(true),
            _ => match item.strip_prefix("leap=") {
                Some(leap) => step.leap_ms = leap.parse().map_err(|_| Kind::BadNumber)?,
                None => step.inputs.push(setting(opcode, declaration, item)?),
            },
        }
    }
    for item in expectations.split_whitespace() {
        step.expected.push(expectation(declaration, item)?);
    }
    Ok(step)
}

fn setting(opcode: Opcode, declaration: &'static SafetyApplication, item: &str) -> Result<Setting, Kind> {
    let (name, text) = item.split_once('=').ok_or(Kind::BadItem)?;
    let (operand, name) = declaration
        .mirrored
        .iter()
        .enumerate()
        .find(|(_, mirrored)| **mirrored == name)
        .map(|(operand, mirrored)| (operand, *mirrored))
        .ok_or(Kind::UnknownOperand)?;
    let (_, member) = declaration.backing.member(name).ok_or(Kind::UnknownOperand)?;
    let choice = match opcode.instruction().operands.iter().skip(1).nth(operand).map(|operand| operand.kind) {
        Some(OperandKind::Choice(list)) => Some(list),
        _ => None,
    };
    let value = value::read(text, member.element, choice).ok_or(Kind::BadValue)?;
    Ok(Setting { operand, name, value })
}

fn expectation(declaration: &'static SafetyApplication, item: &str) -> Result<Expectation, Kind> {
    let (name, text) = item.split_once('=').ok_or(Kind::BadItem)?;
    let (member, declared) = declaration
        .backing
        .members
        .iter()
        .enumerate()
        .find(|(_, member)| member.name == name && member.role == MemberRole::Output)
        .ok_or(Kind::UnknownMember)?;
    let value = value::read(text, declared.element, None).ok_or(Kind::BadValue)?;
    Ok(Expectation { member, name: declared.name, value })
}
