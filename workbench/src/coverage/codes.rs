//! The fault codes of the safety application instructions that a program calls.

use twinrung_bytecode::AdmittedImage;
use twinrung_bytecode::image::Owner;
use twinrung_catalog::code::CodeWord;

use super::shape::{Element, Program};
use crate::names;
use crate::signal::{Signal, Value};

/// One code of one call.
#[derive(Debug)]
pub struct CodeOfCall {
    /// `EStop.FaultCode 16#4000`, or the flag that stands in its place.
    pub name: String,
    /// Where it is shown.
    pub signal: Signal,
    /// The value that shows it.
    pub value: Value,
    /// What makes it come.
    pub cause: &'static str,
    /// Whether it was shown.
    pub reached: bool,
}

/// The codes of all calls in programs. A call inside an Add-On Instruction belongs to the test of that instruction.
pub fn codes(image: &AdmittedImage, program: &Program) -> Vec<CodeOfCall> {
    let mut found: Vec<CodeOfCall> = Vec::new();
    for (_, rung) in program.rungs() {
        let routine = &image.image().routines[rung.routine.position()];
        let Owner::Program(owner) = routine.owner else { continue };
        let scope = image.image().programs.get(owner.position()).map_or("", |program| program.name.as_str());
        for (element, text) in rung.elements.iter().zip(&rung.names) {
            let Element::Output(instruction, _) = element else { continue };
            let Some(safety) = instruction.safety else { continue };
            let tag = text.split_once('(').map_or("", |(_, rest)| rest.split([',', ')']).next().unwrap_or("")).trim();
            for code in safety.codes {
                let (member, value) = match code.word {
                    CodeWord::Fault => ("FaultCode", Value::Integer(code.value)),
                    CodeWord::Flag(member) => (member, Value::Bool(true)),
                    CodeWord::Diagnostic => continue,
                };
                let own = format!("Program:{scope}.{tag}.{member}");
                let shared = format!("{tag}.{member}");
                let signal = names::signal(image, &own).map(|signal| (own, signal));
                let Ok((place, signal)) =
                    signal.or_else(|_| names::signal(image, &shared).map(|signal| (shared, signal)))
                else {
                    continue;
                };
                let name = match code.word {
                    CodeWord::Fault => format!("code {place} 16#{:04X}", code.value),
                    _ => format!("code {place}"),
                };
                if found.iter().all(|other| other.name != name) {
                    found.push(CodeOfCall { name, signal, value, cause: code.cause, reached: false });
                }
            }
        }
    }
    found
}
