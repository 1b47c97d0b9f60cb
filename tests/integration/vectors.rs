//! Every vector of every safety application instruction, on primary, partner and judge at once: compiled from ladder text, run
//! scan by scan, each expected member looked at after each scan.

use std::collections::HashMap;
use std::fmt::Write as _;

use twinrung_catalog::operand::OperandKind;
use twinrung_catalog::{Element, Instruction, Opcode};
use twinrung_safety_vectors::{Replay, Vector, for_instruction};
use twinrung_trio::{Subject, Trio};
use twinrung_workbench::Value;

/// Differences that are listed; more of them say nothing new.
const LISTED: usize = 10;

/// The name of the tag that stands for an operand, where it is driven from outside.
fn driven(kind: OperandKind, index: usize) -> Option<(String, &'static str)> {
    let type_name = match kind {
        OperandKind::SafetyBit { .. } => "BOOL",
        OperandKind::SafetyInteger { .. } => "DINT",
        OperandKind::SafetyReal { .. } => "REAL",
        _ => return None,
    };
    Some((format!("Operand_{index}"), type_name))
}

/// The operands that are driven from outside: tag, type, and place after the backing tag.
pub fn driven_operands(instruction: &Instruction) -> Vec<(String, Element, usize)> {
    let operands = instruction.operands.iter().enumerate().skip(1);
    operands
        .filter_map(|(index, operand)| {
            let (name, type_name) = driven(operand.kind, index)?;
            Some((name, Element::by_name(type_name)?, index - 1))
        })
        .collect()
}

/// The configuration operands of a vector, one place for each operand after the backing tag.
pub fn configuration(vector: &Vector) -> Vec<i32> {
    let mut configuration = vec![0; vector.opcode.instruction().operands.len() - 1];
    vector.configuration.iter().for_each(|setting| configuration[setting.operand] = setting.value);
    configuration
}

/// The members whose values a vector knows in the scan that a replay has reached.
pub fn expected_members(instruction: &Instruction, replay: &Replay<'_>) -> Vec<(String, Value)> {
    let members = instruction.safety.unwrap().backing.members;
    let known = members.iter().zip(replay.expected());
    known
        .filter_map(|(member, raw)| Some((format!("Backing.{}", member.name), value(member.element, (*raw)?))))
        .collect()
}

/// A project that calls an instruction. Its period is the shortest that a vector has: what passes between scans is the test's affair.
pub fn program(instruction: &Instruction, configuration: &[i32]) -> String {
    let backing = instruction.safety.unwrap().backing.name;
    let mut tags = format!("Backing : {backing} (Class := Safety);\nRung : BOOL (Class := Safety);\n");
    let mut operands = vec!["Backing".to_owned()];
    for (index, operand) in instruction.operands.iter().enumerate().skip(1) {
        match driven(operand.kind, index) {
            Some((name, type_name)) => {
                let _ = writeln!(tags, "{name} : {type_name} (Class := Safety);");
                operands.push(name);
            }
            None => operands.push(configuration[index - 1].to_string()),
        }
    }
    format!(
        "CONTROLLER Vectors (ProcessorType := \"1756-L73S\", Major := 20)\nTAG\n{tags}END_TAG\n\
         PROGRAM Main (Class := Safety, MAIN := \"Main\")\nROUTINE Main\nN: XIC(Rung){}({});\nEND_ROUTINE\nEND_PROGRAM\n\
         TASK Safety (Type := PERIODIC, Class := Safety, Rate := 1, Watchdog := 1, Priority := 5)\nMain;\n\
         END_TASK\nEND_CONTROLLER\n",
        instruction.mnemonic,
        operands.join(",")
    )
}

/// A raw value as a member of this type shows it.
pub fn value(element: Element, raw: i32) -> Value {
    match element {
        Element::Bool => Value::Bool(raw != 0),
        Element::Real => Value::Real(f32::from_bits(raw as u32)),
        _ => Value::Integer(raw),
    }
}

/// Whether two values are the same to the bit.
pub fn same(expected: Value, found: Value) -> bool {
    match (expected, found) {
        (Value::Real(expected), Value::Real(found)) => found.to_bits() == expected.to_bits(),
        (expected, found) => found == expected,
    }
}

fn replay(subject: &Subject, vector: &Vector, period_ms: u32) -> Result<u32, String> {
    let instruction = vector.opcode.instruction();
    let mut trio = Trio::new(subject);
    let mut replay = vector.replay(period_ms);
    let mut scans = 0;
    while let Some(scan) = replay.next_scan() {
        for (name, element, place) in driven_operands(instruction) {
            trio.set(&name, value(element, replay.operands()[place]));
        }
        trio.set("Rung", Value::Bool(scan.rung));
        if scan.prescan {
            trio.prescan(scan.now_ms).map_err(|error| error.to_string())?;
        }
        trio.scan(scan.now_ms).map_err(|error| format!("at {} ms: {error}", scan.now_ms))?;
        scans += 1;
        for (name, expected) in expected_members(instruction, &replay) {
            let found = trio.value(&name);
            if !same(expected, found) {
                return Err(format!("at {} ms: {name} is {found}, expected {expected}", scan.now_ms));
            }
        }
    }
    Ok(scans)
}

fn expect_vectors(opcodes: &[Opcode]) {
    let mut wrong = Vec::new();
    for opcode in opcodes {
        let instruction = opcode.instruction();
        let vectors = for_instruction(*opcode).unwrap();
        let mut subjects: HashMap<Vec<i32>, Subject> = HashMap::new();
        let (mut runs, mut scans) = (0, 0);
        for vector in vectors.iter().filter(|vector| vector.is_admissible()) {
            for period_ms in vector.periods_ms.iter().copied() {
                let configuration = configuration(vector);
                let subject = subjects.entry(configuration.clone()).or_insert_with(|| {
                    let text = program(instruction, &configuration);
                    Subject::from_text(&text).unwrap_or_else(|errors| panic!("{errors:#?}\n{text}"))
                });
                match replay(subject, vector, period_ms) {
                    Ok(count) => scans += count,
                    Err(error) => {
                        wrong.push(format!("{} {} ({period_ms} ms): {error}", instruction.mnemonic, vector.name))
                    }
                }
                runs += 1;
            }
        }
        println!("{:<6} {:>4} vectors, {runs:>4} runs, {scans:>6} scans", instruction.mnemonic, vectors.len());
    }
    let count = wrong.len();
    wrong.truncate(LISTED);
    assert!(wrong.is_empty(), "{count} runs differ: {wrong:#?}");
}

#[test]
fn dcs_and_crout_when_their_vectors_are_run_then_primary_partner_and_judge_give_them() {
    expect_vectors(&[Opcode::Dcs, Opcode::Crout]);
}

#[test]
fn safety_application_instructions_when_their_vectors_are_run_then_primary_partner_and_judge_give_them() {
    let others: Vec<Opcode> = Opcode::ALL
        .iter()
        .copied()
        .filter(|opcode| opcode.instruction().safety.is_some() && !matches!(opcode, Opcode::Dcs | Opcode::Crout))
        .collect();
    expect_vectors(&others);
}
