//! A call of a safety application instruction in a small project, and what the compiler refuses of it.

use twinrung_catalog::operand::{Operand, OperandKind};
use twinrung_catalog::{Instruction, Opcode, Relation};
use twinrung_compiler::{Completion, check};
use twinrung_grammar::read;
use twinrung_grammar::tree::Sources;

/// Every safety application instruction.
pub fn instructions() -> impl Iterator<Item = &'static Instruction> {
    Opcode::ALL.iter().map(|opcode| opcode.instruction()).filter(|instruction| instruction.safety.is_some())
}

/// A call under test: its operands, each as it will be written.
#[derive(Clone)]
pub struct Call {
    /// The instruction.
    pub instruction: &'static Instruction,
    /// The operands as text.
    pub operands: Vec<String>,
    /// Catalogue number and revision.
    pub controller: (&'static str, u16),
    /// Period of the task.
    pub period_ms: u32,
    /// Further declarations.
    pub tags: String,
    /// Further rungs.
    pub rungs: String,
}

/// An error: its code, and what it points at.
#[derive(Debug, PartialEq, Eq)]
pub struct Refusal {
    /// The code.
    pub code: &'static str,
    /// The text that it points at.
    pub text: String,
    /// The operand that it points at, counted from 0; `None` where it points elsewhere.
    pub operand: Option<usize>,
}

impl Call {
    /// A call that is accepted: numbers that admit 0 are 0, the others the least; words the first; the rest are tags.
    pub fn of(instruction: &'static Instruction) -> Call {
        let operands = instruction.operands.iter().enumerate().map(|(place, operand)| match operand.kind {
            OperandKind::Choice(list) => list.words[0].0.to_owned(),
            OperandKind::Literal { or_zero: true, .. } => "0".to_owned(),
            OperandKind::Literal { least, .. } => least.to_string(),
            _ => format!("Operand_{place}"),
        });
        Call {
            instruction,
            operands: operands.collect(),
            controller: ("1756-L73S", 20),
            period_ms: 10,
            tags: String::new(),
            rungs: String::new(),
        }
    }

    /// The same with another operand; what its relations ask of others is done.
    pub fn with(&self, place: usize, text: impl Into<String>) -> Call {
        let mut call = self.clone();
        call.operands[place] = text.into();
        for relation in call.instruction.safety.unwrap().relations {
            if let Relation::NotZeroWhen(time, choice, value) = *relation {
                let (time, choice) = (call.place(time), call.place(choice));
                if choice == place && chosen(&call.instruction.operands[choice], &call.operands[choice]) == Some(value)
                {
                    call.operands[time] = least(&call.instruction.operands[time]).to_string();
                }
            }
        }
        call
    }

    /// The place of the operand of this name.
    pub fn place(&self, name: &str) -> usize {
        self.instruction.operands.iter().position(|operand| operand.name == name).unwrap()
    }

    /// Errors of a project with this call, with the operand that each points at.
    pub fn refusals(&self) -> Vec<Refusal> {
        let mut tags = String::new();
        for (place, operand) in self.instruction.operands.iter().enumerate() {
            let type_name = match operand.kind {
                OperandKind::Structure(structure, _) => structure.name,
                OperandKind::SafetyBit { .. } => "BOOL",
                OperandKind::SafetyInteger { .. } => "DINT",
                OperandKind::SafetyReal { .. } => "REAL",
                _ => continue,
            };
            tags.push_str(&format!("Operand_{place} : {type_name} (Class := Safety);\n"));
        }
        let (catalog_number, revision) = self.controller;
        let mut text = format!(
            "CONTROLLER Options (ProcessorType := \"{catalog_number}\", Major := {revision})\nTAG\n{tags}{}END_TAG\n\
             PROGRAM Main (Class := Safety, MAIN := \"Main\")\nROUTINE Main\nN: {}(",
            self.tags, self.instruction.mnemonic
        );
        let mut spans = Vec::new();
        for (place, operand) in self.operands.iter().enumerate() {
            text.push_str(if place > 0 { "," } else { "" });
            spans.push((text.len(), text.len() + operand.len()));
            text.push_str(operand);
        }
        text.push_str(&format!(
            ");\n{}END_ROUTINE\nEND_PROGRAM\nTASK Safety (Type := PERIODIC, Class := Safety, Rate := {period}, \
             Watchdog := {period}, Priority := 5)\nMain;\nEND_TASK\nEND_CONTROLLER\n",
            self.rungs,
            period = self.period_ms
        ));
        let mut sources = Sources::new();
        let reading = read(&mut sources, "options.rll", text.into_bytes());
        let found = check(&reading, &Completion::default()).findings;
        let errors = found.iter().filter(|finding| finding.is_error());
        errors
            .map(|finding| Refusal {
                code: finding.code.id,
                text: sources.text(finding.span).to_owned(),
                operand: spans
                    .iter()
                    .position(|span| *span == (finding.span.start as usize, finding.span.end as usize)),
            })
            .collect()
    }

    /// What is wrong when the call should be accepted.
    pub fn expect_accepted(&self) -> Option<String> {
        let refusals = self.refusals();
        (!refusals.is_empty())
            .then(|| format!("{}({}): {refusals:?}", self.instruction.mnemonic, self.operands.join(",")))
    }

    /// What is wrong when the call should be refused with this code at this operand, and with no other.
    pub fn expect_refused(&self, code: &'static str, operand: usize) -> Option<String> {
        let refusals = self.refusals();
        let as_meant = matches!(&refusals[..], [one] if one.code == code && one.operand == Some(operand));
        let shown = format!("{}({})", self.instruction.mnemonic, self.operands.join(","));
        (!as_meant).then(|| format!("{shown}: expected {code} at operand {operand}, found {refusals:?}"))
    }
}

fn chosen(operand: &Operand, word: &str) -> Option<i32> {
    match operand.kind {
        OperandKind::Choice(list) => list.value(word),
        _ => None,
    }
}

/// The least value of a number in a range.
pub fn least(operand: &Operand) -> i32 {
    match operand.kind {
        OperandKind::Literal { least, .. } => least,
        _ => 0,
    }
}

/// A call for each operand of each instruction, with the operand's place.
pub fn operands() -> impl Iterator<Item = (Call, usize, OperandKind)> {
    instructions().flat_map(|instruction| {
        let kinds = instruction.operands.iter().map(|operand| operand.kind).enumerate();
        kinds.map(move |(place, kind)| (Call::of(instruction), place, kind))
    })
}

/// Fails with the list of what is wrong.
pub fn expect_none(wrong: impl Iterator<Item = String>) {
    let wrong: Vec<String> = wrong.collect();
    assert!(wrong.is_empty(), "{} are wrong: {wrong:#?}", wrong.len());
}
