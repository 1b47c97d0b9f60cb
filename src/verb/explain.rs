//! `twinrung explain`: the page of a code, an instruction, or a code of an instruction.

use std::fmt::Write as _;
use std::io::{self, Write};
use std::process::ExitCode;

use clap::Args;
use twinrung_catalog::{Access, Code, CodeWord, Instruction, Operand, OperandKind, Position, Requires};
use twinrung_compiler::diagnostic;

/// Arguments of `explain`.
#[derive(Debug, Args)]
#[command(
    after_help = "Examples:\n  twinrung explain S0001\n  twinrung explain DCS\n  twinrung explain 16#4001 --for DCS"
)]
pub struct Explain {
    /// A finding's code (S0101), a mnemonic (DCS), or the fault or diagnostic code that an instruction shows (16#4001)
    what: String,
    /// The instruction that shows the fault or diagnostic code
    #[arg(long = "for", value_name = "MNEMONIC")]
    instruction: Option<String>,
}

/// Prints the page.
pub fn run(arguments: &Explain) -> io::Result<ExitCode> {
    let page = match &arguments.instruction {
        Some(mnemonic) => shown_code(&arguments.what, mnemonic),
        None => finding_code(&arguments.what)
            .or_else(|| Instruction::by_mnemonic(&arguments.what).map(instruction_page))
            .ok_or_else(|| unknown(&arguments.what)),
    };
    match page {
        Ok(page) => {
            io::stdout().write_all(page.as_bytes())?;
            Ok(ExitCode::SUCCESS)
        }
        Err(message) => {
            eprintln!("{message}");
            Ok(ExitCode::from(2))
        }
    }
}

fn unknown(what: &str) -> String {
    let number = number(what).is_some();
    let hint = if number {
        "a number is keyed by its instruction: add --for MNEMONIC"
    } else {
        "give a code such as S0101, or a certified instruction such as DCS"
    };
    format!("nothing is known as `{what}`; {hint}")
}

fn finding_code(what: &str) -> Option<String> {
    let code = diagnostic::by_id(&what.to_ascii_uppercase())?;
    let mut page = format!("{}  {}\n\n{}\n\nSource: {}\n", code.id, code.title, code.explanation, code.citation);
    if !code.bad.is_empty() {
        let _ = write!(page, "\nRefused or reported:\n\n{}\n", indented(&code.bad_text()));
    }
    if !code.good.is_empty() {
        let _ = write!(page, "\nAccepted:\n\n{}\n", indented(code.good));
    }
    Some(page)
}

fn indented(text: &str) -> String {
    text.trim_matches('\n').lines().map(|line| format!("    {line}")).collect::<Vec<_>>().join("\n")
}

/// A number as codes are written: 16#4001, 0x4001 or decimal.
fn number(text: &str) -> Option<i32> {
    let hexadecimal = text.strip_prefix("16#").or_else(|| text.strip_prefix("0x"));
    match hexadecimal {
        Some(digits) => i32::from_str_radix(&digits.replace('_', ""), 16).ok(),
        None => text.parse().ok(),
    }
}

fn shown_code(what: &str, mnemonic: &str) -> Result<String, String> {
    let instruction =
        Instruction::by_mnemonic(mnemonic).ok_or_else(|| format!("`{mnemonic}` is not a certified instruction"))?;
    let safety = instruction.safety.ok_or_else(|| format!("{mnemonic} shows no fault or diagnostic codes"))?;
    let value = number(what).ok_or_else(|| format!("`{what}` is not a number; write 16#4001 or 16385"))?;
    let codes: Vec<&Code> = safety.codes.iter().filter(|code| code.value == value).collect();
    if codes.is_empty() {
        return Err(format!("{} declares no code {value} (16#{value:04X})", instruction.mnemonic));
    }
    let mut page = String::new();
    for code in codes {
        let _ = writeln!(page, "{} {}", instruction.mnemonic, code_line(code));
        let _ = writeln!(
            page,
            "  what happened: {}\n  what to do:    {}\n  origin:        {}",
            code.cause, code.remedy, code.origin
        );
    }
    Ok(page)
}

fn code_line(code: &Code) -> String {
    match code.word {
        CodeWord::Fault => format!("FaultCode 16#{:04X} ({})", code.value, code.value),
        CodeWord::Diagnostic => format!("DiagnosticCode 16#{:04X} ({})", code.value, code.value),
        CodeWord::Flag(member) => format!("{member} = 1"),
    }
}

/// The page of an instruction.
pub fn instruction_page(instruction: &Instruction) -> String {
    let mut page = String::new();
    let operands: Vec<&str> = instruction.operands.iter().map(|operand| operand.name).collect();
    let _ = writeln!(page, "{}  {}", instruction.mnemonic, instruction.name);
    let _ = writeln!(page, "\n{}", instruction.summary);
    if let Some(safety) = instruction.safety {
        let _ = writeln!(page, "\n{}", safety.purpose);
    }
    let _ = writeln!(page, "\n  {}({})", instruction.mnemonic, operands.join(", "));
    let _ = writeln!(page, "\nOn a rung: {}.", position_words(instruction));
    let _ = writeln!(
        page,
        "Admitted: from version {}{} ({}).",
        instruction.first_version,
        match instruction.requires {
            Requires::Any => ", every safety controller",
            Requires::L7x => ", 1756-L7xS and later families only",
            Requires::Real => ", where safety REAL is allowed",
        },
        instruction.source
    );
    if !instruction.also.is_empty() {
        let _ = writeln!(page, "Also read as: {}.", instruction.also.join(", "));
    }
    if !instruction.operands.is_empty() {
        let _ = writeln!(page, "\nOperands");
        for operand in instruction.operands {
            let _ = writeln!(page, "  {:<28} {}", operand.name, operand_words(operand));
        }
    }
    if let Some(safety) = instruction.safety {
        let _ = writeln!(page, "\nMembers of {}", safety.backing.name);
        for member in safety.backing.members {
            let _ = writeln!(page, "  {:<28} {:<5} {}", member.name, member.element.name(), member.meaning);
        }
        let _ = writeln!(page, "\nCodes");
        for code in safety.codes {
            let _ = writeln!(
                page,
                "  {}\n      {}\n      -> {}  [{}]",
                code_line(code),
                code.cause,
                code.remedy,
                code.origin
            );
        }
        let _ = writeln!(page, "\nSpecified in {}.", safety.reference);
    }
    page
}

fn position_words(instruction: &Instruction) -> &'static str {
    match (instruction.position, instruction.transitional) {
        (Position::Input, false) => "an input; with a false rung it is false and does not look at its operands",
        (Position::Input, true) => "an input; it also acts on a false rung",
        (Position::Output, false) => "an output; it passes the rung condition on, and does nothing on a false rung",
        (Position::Output, true) => "an output; it passes the rung condition on, and also acts on a false rung",
        (Position::Ending, _) => "an output that ends its path when the rung is true",
        (Position::First, _) => "the first element of its rung",
    }
}

fn operand_words(operand: &Operand) -> String {
    let access = |access: Access| match access {
        Access::Read => "read",
        Access::Write => "written",
        Access::ReadWrite => "read and written",
    };
    let words = match operand.kind {
        OperandKind::Bit(how) => format!("BOOL or bit of an integer, {}", access(how)),
        OperandKind::Number(how) => format!("SINT, INT, DINT or REAL, {}", access(how)),
        OperandKind::Integer(how) => format!("SINT, INT or DINT, {}", access(how)),
        OperandKind::Structure(structure, _) => format!("{} tag", structure.name),
        OperandKind::Pseudo(member) => format!("`?`, or a number that initialises {member}"),
        OperandKind::Choice(list) => {
            let words: Vec<String> = list.words.iter().map(|(word, value)| format!("{word} ({value})")).collect();
            words.join(" | ")
        }
        OperandKind::Literal { or_zero, least, greatest, step, unit } => {
            let zero = if or_zero { "0, or " } else { "" };
            let multiples = if step > 1 { format!(", in steps of {step}") } else { String::new() };
            format!("{zero}{least} to {greatest} {unit}{multiples}").trim_end().to_owned()
        }
        OperandKind::SafetyBit { immediate: true } => "BOOL tag, or 0 or 1".to_owned(),
        OperandKind::SafetyBit { immediate: false } => "BOOL tag".to_owned(),
        OperandKind::SafetyInteger { immediate: Some((least, greatest)), unit } => {
            format!("DINT tag, or {least} to {greatest} {unit}").trim_end().to_owned()
        }
        OperandKind::SafetyInteger { immediate: None, .. } => "DINT tag".to_owned(),
        OperandKind::SafetyReal { immediate: true, .. } => "REAL tag or number".to_owned(),
        OperandKind::SafetyReal { immediate: false, .. } => "REAL tag".to_owned(),
        OperandKind::CopySource => "tag, or element of an array, to copy from".to_owned(),
        OperandKind::CopyDestination => "tag, or element of an array, to copy to".to_owned(),
        OperandKind::FillDestination => "number tag, the first of those that are filled".to_owned(),
        OperandKind::Array => "array, or an element of one".to_owned(),
        OperandKind::SystemData(how) => format!("tag of the attribute's size, {}", access(how)),
        OperandKind::Resettable => "TIMER, COUNTER or CONTROL tag".to_owned(),
        OperandKind::ConstantLength => "positive number (a constant)".to_owned(),
        OperandKind::Expression => "expression".to_owned(),
        OperandKind::Condition => "expression, used as true or false".to_owned(),
        OperandKind::FileMode => "ALL, INC or a number of elements per scan".to_owned(),
        OperandKind::ByteOrder => "REVERSE, WORD or HIGH/LOW".to_owned(),
        OperandKind::Dimension => "0, 1 or 2".to_owned(),
        OperandKind::Label | OperandKind::LabelDefinition => "label".to_owned(),
        OperandKind::Routine => "routine of the same program".to_owned(),
        OperandKind::InputCount => "number".to_owned(),
        OperandKind::Parameter(how) => format!("BOOL, number or structure, {}", access(how)),
        OperandKind::EventTask => "event task of class Standard".to_owned(),
        OperandKind::SystemClass => "object class".to_owned(),
        OperandKind::SystemInstance => "object name, or nothing".to_owned(),
        OperandKind::SystemAttribute => "attribute".to_owned(),
    };
    if operand.repeats { format!("{words}; any number of them") } else { words }
}
