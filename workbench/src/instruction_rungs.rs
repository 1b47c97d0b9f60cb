//! Projects whose rungs all hold one instruction, made from its declaration in the catalog: what measures an instruction.

use std::fmt::Write as _;

use twinrung_catalog::{Instruction, Opcode, OperandKind};

/// What stands on each rung after its first contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Subject {
    /// Nothing.
    Nothing,
    /// So many contacts in series: of the kind of XIC or XIO.
    Contacts(Opcode, usize),
    /// So many coils side by side.
    Coils(Opcode, usize),
    /// One instruction with operands of its own. File instructions have so many elements.
    One(Opcode, u32),
    /// A call of an Add-On Instruction that does nothing.
    AddOnCall,
    /// A call of a subroutine that does nothing.
    Subroutine,
}

/// Which literals are tried where a range is declared: relations between operands exclude some.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Literals {
    /// The least.
    Least,
    /// The greatest.
    Greatest,
}

/// Period of the safety task in ms.
pub const PERIOD_MS: u64 = 10;

/// The project as `.rll`: rung i is `XIC(Ci)`, the subject, `OTE(Oi)`. `None` for instructions that need a place of their own
/// (jumps, labels, parameters of subroutines, system values).
pub fn project(subject: Subject, rungs: usize, literals: Literals) -> Option<String> {
    let mut tags = String::new();
    let mut code = String::new();
    for rung in 0..rungs {
        let _ = writeln!(tags, "C{rung} : BOOL (Class := Safety);\nO{rung} : BOOL (Class := Safety);");
        let middle = match subject {
            Subject::Nothing => String::new(),
            Subject::Contacts(opcode, count) => {
                let mnemonic = opcode.instruction().mnemonic;
                (0..count).map(|offset| format!("{mnemonic}(C{})", (rung + 7 * (offset + 1)) % rungs)).collect()
            }
            Subject::Coils(opcode, count) => {
                let mnemonic = opcode.instruction().mnemonic;
                let coils: Vec<String> = (0..count)
                    .map(|coil| {
                        let _ = writeln!(tags, "P{rung}_{coil} : BOOL (Class := Safety);");
                        format!("{mnemonic}(P{rung}_{coil})")
                    })
                    .collect();
                format!("[{} ]", coils.join(" ,"))
            }
            Subject::One(opcode, elements) => one(opcode.instruction(), rung, elements, literals, &mut tags)?,
            Subject::AddOnCall => {
                let _ = writeln!(tags, "I{rung} : Idle (Class := Safety);");
                format!("Idle(I{rung})")
            }
            Subject::Subroutine => "JSR(Idle,0)".to_owned(),
        };
        let _ = writeln!(code, "N: XIC(C{rung}){middle}OTE(O{rung});");
    }
    let add_on = if subject == Subject::AddOnCall {
        "ADD_ON_INSTRUCTION_DEFINITION Idle (Class := Safety)\nPARAMETERS\nEND_PARAMETERS\nLOCAL_TAGS\nEND_LOCAL_TAGS\n\
         ROUTINE Logic\nN: NOP();\nEND_ROUTINE\nEND_ADD_ON_INSTRUCTION_DEFINITION\n"
    } else {
        ""
    };
    let routine = if subject == Subject::Subroutine { "ROUTINE Idle\nN: NOP();\nEND_ROUTINE\n" } else { "" };
    Some(format!(
        "CONTROLLER One_Instruction (ProcessorType := \"1756-L73S\", Major := 20)\n{add_on}TAG\n{tags}END_TAG\n\
         PROGRAM P (Class := Safety, MAIN := \"Main\")\nROUTINE Main\n{code}END_ROUTINE\n{routine}END_PROGRAM\n\
         TASK Safety (Type := PERIODIC, Class := Safety, Rate := {PERIOD_MS}, Watchdog := {PERIOD_MS}, Priority := 5)\nP;\n\
         END_TASK\nEND_CONTROLLER\n"
    ))
}

fn one(instruction: &Instruction, rung: usize, elements: u32, literals: Literals, tags: &mut String) -> Option<String> {
    let mut operands = Vec::with_capacity(instruction.operands.len());
    for (position, operand) in instruction.operands.iter().enumerate() {
        let mut tag = |type_name: &str, initial: &str| {
            let name = format!("T{rung}_{position}");
            let _ = writeln!(tags, "{name} : {type_name} (Class := Safety){initial};");
            name
        };
        operands.push(match operand.kind {
            OperandKind::Bit(_) | OperandKind::SafetyBit { .. } => tag("BOOL", ""),
            OperandKind::Number(_) | OperandKind::Integer(_) => tag("DINT", " := 3"),
            OperandKind::SafetyInteger { .. } => tag("DINT", ""),
            OperandKind::SafetyReal { .. } => tag("REAL", ""),
            OperandKind::Structure(predefined, _) => tag(predefined.name, ""),
            OperandKind::Resettable => tag("COUNTER", ""),
            OperandKind::Pseudo("LEN") => elements.to_string(),
            OperandKind::Pseudo("PRE") => "1000".to_owned(),
            OperandKind::Pseudo(_) | OperandKind::Dimension => "0".to_owned(),
            OperandKind::CopySource
            | OperandKind::CopyDestination
            | OperandKind::FillDestination
            | OperandKind::Array => format!("{}[0]", tag("DINT[8]", "")),
            OperandKind::ConstantLength => "4".to_owned(),
            OperandKind::Expression => format!("{} + 1", tag("DINT", " := 3")),
            OperandKind::Condition => format!("{} < 0", tag("DINT", " := 3")),
            OperandKind::FileMode => "ALL".to_owned(),
            OperandKind::ByteOrder => "REVERSE".to_owned(),
            OperandKind::Choice(list) => list.words.first()?.1.to_string(),
            OperandKind::Literal { least, greatest, step, .. } => match literals {
                Literals::Least => (least.div_euclid(step) + i32::from(least.rem_euclid(step) != 0)) * step,
                Literals::Greatest => greatest.div_euclid(step) * step,
            }
            .to_string(),
            OperandKind::Label
            | OperandKind::LabelDefinition
            | OperandKind::Routine
            | OperandKind::InputCount
            | OperandKind::Parameter(_)
            | OperandKind::EventTask
            | OperandKind::SystemClass
            | OperandKind::SystemInstance
            | OperandKind::SystemAttribute
            | OperandKind::SystemData(_) => return None,
        });
    }
    Some(format!("{}({})", instruction.mnemonic, operands.join(",")))
}
