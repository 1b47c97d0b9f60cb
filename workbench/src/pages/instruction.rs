//! The page of an instruction.

use twinrung_catalog::{Instruction, OperandKind, Position, Requires, SafetyApplication};
use twinrung_safety_vectors::{Vector, normal_operation};

use super::{Block, Page, Table, Timing, codes, operands, structures};

/// The page of an instruction: what it is for, its operands, what it does, its members, its normal operation and its codes.
pub fn page(instruction: &'static Instruction) -> Page {
    let normal = normal_operation(instruction.opcode).ok().flatten();
    let mut page = Page { title: format!("{}  {}", instruction.mnemonic, instruction.name), blocks: Vec::new() };
    page.paragraph(instruction.summary);
    if let Some(safety) = instruction.safety {
        page.paragraph(safety.purpose);
    }
    page.paragraph(admission(instruction));
    text_form(&mut page, instruction, normal.as_ref());
    if !instruction.operands.is_empty() {
        page.heading("Operands");
        page.blocks.push(Block::Table(operands::table(instruction)));
    }
    if let Some(safety) = instruction.safety {
        backing_rules(&mut page, instruction, safety);
    }
    executions(&mut page, instruction);
    for structure in structures::of(instruction) {
        page.heading(&format!("Members of {}, each with byte or byte.bit of {}", structure.name, structure.bytes));
        page.blocks.push(Block::Table(structures::table(instruction, structure)));
    }
    if let Some(vector) = &normal {
        page.heading("Normal operation");
        page.paragraph(vector.normal);
        page.blocks.push(Block::Timing(Timing::of(vector)));
        page.paragraph(format!(
            "Drawn from vector {} ({}), with the configuration of the example above. A section begins where something \
             changes; it is not to scale. Origin of what is expected there: {}.",
            vector.name, vector.source, vector.mark
        ));
    }
    if let Some(safety) = instruction.safety {
        codes::sections(&mut page, safety);
    }
    sources(&mut page, instruction);
    page
}

fn admission(instruction: &Instruction) -> String {
    let controllers = match instruction.requires {
        Requires::Any => "every safety controller",
        Requires::L7x => "1756-L7xS and later families only",
        Requires::Real => "controllers whose safety tags may be REAL only: 1756-L7xS and later families",
    };
    let also = match instruction.also.is_empty() {
        true => String::new(),
        false => format!(" Also read as {}.", instruction.also.join(", ")),
    };
    format!("Admitted from version {}, on {controllers}.{also}", instruction.first_version)
}

/// The names of the operands where they stand, and a call that compiles.
fn text_form(page: &mut Page, instruction: &Instruction, normal: Option<&Vector>) {
    page.heading("Neutral text");
    let names: Vec<String> = instruction
        .operands
        .iter()
        .map(|operand| if operand.repeats { format!("{},...", operand.name) } else { operand.name.to_owned() })
        .collect();
    page.blocks.push(Block::Verbatim(vec![format!("{}({})", instruction.mnemonic, names.join(","))]));
    if let Some(vector) = normal {
        page.paragraph("For example, with tags named like the members that mirror them:");
        page.blocks.push(Block::Verbatim(vec![example(instruction, vector)]));
    }
}

/// The call of a vector: its configuration, and a tag for each other operand.
pub fn example(instruction: &Instruction, vector: &Vector) -> String {
    let mirrored = instruction.safety.map_or(&[][..], |safety| safety.mirrored);
    let arguments = instruction.operands.iter().skip(1).zip(mirrored).enumerate().map(|(place, (operand, name))| {
        let set = vector.configuration.iter().find(|setting| setting.operand == place).map(|setting| setting.value);
        match (operand.kind, set) {
            (OperandKind::Choice(list), Some(value)) => list.word(value).unwrap_or(name).to_owned(),
            (OperandKind::Literal { .. }, Some(value)) => value.to_string(),
            _ => (*name).to_owned(),
        }
    });
    let arguments: Vec<String> = std::iter::once(format!("My_{}", instruction.mnemonic)).chain(arguments).collect();
    format!("{}({})", instruction.mnemonic, arguments.join(","))
}

fn backing_rules(page: &mut Page, instruction: &Instruction, safety: &SafetyApplication) {
    let mut text = format!(
        "The tag of type {} serves this call alone; nothing else writes its members, and none of them is an operand of \
         the call.",
        safety.backing.name
    );
    for relation in safety.relations {
        text.push(' ');
        text.push_str(&operands::relation_words(instruction, *relation));
    }
    page.paragraph(text);
}

fn executions(page: &mut Page, instruction: &Instruction) {
    let execution = instruction.execution;
    let mut rows = vec![
        ("rung true", execution.on_true),
        ("rung false", execution.on_false),
        ("prescan", execution.prescan),
        ("faults, flags", execution.faults),
    ];
    rows.retain(|(_, text)| !text.is_empty());
    page.heading("Execution");
    page.paragraph(position_words(instruction));
    let rows = rows.into_iter().map(|(when, text)| vec![when.to_owned(), text.to_owned()]).collect();
    page.blocks.push(Block::Table(Table { heads: vec!["when", "what happens"], rows }));
}

fn position_words(instruction: &Instruction) -> &'static str {
    match (instruction.position, instruction.transitional) {
        (Position::Input, false) => "An input: it makes the rung condition for what follows.",
        (Position::Input, true) => {
            "An input: it makes the rung condition for what follows, and acts on a false rung too."
        }
        (Position::Output, false) => "An output: it passes the rung condition on, and acts on a true rung alone.",
        (Position::Output, true) => "An output: it passes the rung condition on, and acts on a false rung too.",
        (Position::Ending, _) => "Ends its path of the rung when it acts: nothing after it is executed.",
        (Position::First, _) => "The first element of its rung.",
    }
}

fn sources(page: &mut Page, instruction: &Instruction) {
    page.heading("Sources");
    let mut text = format!("Certified: {}.", instruction.source);
    if let Some(safety) = instruction.safety {
        text.push_str(&format!(
            " Behaviour: {}. Layout: {}. Origin marks: `recalled` from the maker's manual, which was not at hand, \
             with how sure; `decided` by this project, the safer side taken; anything else names a document.",
            safety.reference, safety.backing.source
        ));
    } else {
        text.push_str(" Behaviour: general-instructions.md A; the requirements stand in docs/spec/execution.md.");
    }
    page.paragraph(text);
}

#[cfg(test)]
mod tests {
    use super::*;
    use twinrung_catalog::instructions;

    #[test]
    fn pages_when_drawn_for_a_terminal_then_no_line_is_wider() {
        for columns in [80, 100] {
            for instruction in instructions::ALL {
                let drawn = page(instruction).terminal(columns);
                let wide: Vec<&str> = drawn.lines().filter(|line| line.chars().count() > columns).collect();
                assert_eq!(wide, Vec::<&str>::new(), "{} at {columns}", instruction.mnemonic);
            }
        }
    }

    #[test]
    fn page_when_the_instruction_is_a_safety_application_then_everything_declared_stands_on_it() {
        for (instruction, safety) in instructions::ALL.iter().filter_map(|one| Some((one, one.safety?))) {
            let drawn = page(instruction).markdown();
            let found = |text: &str| drawn.contains(&super::super::markdown::escaped(text));
            assert!(instruction.operands.iter().all(|operand| found(operand.name)), "{}", instruction.mnemonic);
            assert!(safety.backing.members.iter().all(|member| found(member.name)), "{}", instruction.mnemonic);
            assert!(
                safety.codes.iter().all(|code| found(code.cause) && found(code.remedy)),
                "{}",
                instruction.mnemonic
            );
            assert!(drawn.contains("▁") && drawn.contains("█"), "{} has no diagram", instruction.mnemonic);
        }
    }
}
