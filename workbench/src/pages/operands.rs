//! What may stand in an operand's place, in words.

use twinrung_catalog::{Access, ChoiceList, Instruction, Operand, OperandKind, Relation};

use super::Table;

/// The operands in neutral-text order: place, name, what may stand there and what it means.
pub(super) fn table(instruction: &Instruction) -> Table {
    let rows = instruction.operands.iter().enumerate().map(|(place, operand)| {
        let mut words = takes(operand);
        if let Some(meaning) = meaning(instruction, place) {
            words = format!("{words}; {meaning}");
        }
        vec![(place + 1).to_string(), operand.name.to_owned(), words]
    });
    Table { heads: vec!["", "operand", "what may stand there"], rows: rows.collect() }
}

/// What the mirrored member says of itself. The words of a choice say it better.
fn meaning(instruction: &Instruction, place: usize) -> Option<&'static str> {
    let safety = instruction.safety?;
    let name = safety.mirrored.get(place.checked_sub(1)?)?;
    let operand = instruction.operands.get(place)?;
    let (_, member) = safety.backing.member(name)?;
    let said = matches!(operand.kind, OperandKind::Choice(_)) || member.meaning.is_empty();
    (!said).then_some(member.meaning)
}

/// What may stand in the operand's place.
fn takes(operand: &Operand) -> String {
    let words = kind_words(operand.kind);
    if operand.repeats { format!("{words}; any number of them") } else { words }
}

fn kind_words(kind: OperandKind) -> String {
    match kind {
        OperandKind::Choice(list) => choice_words(list),
        OperandKind::Literal { or_zero, least, greatest, step, unit } => {
            let zero = if or_zero && least > 0 { "0, or " } else { "" };
            let multiples = if step > 1 { format!(" in steps of {step}") } else { String::new() };
            format!("number: {zero}{least} to {greatest} {unit}{multiples}").trim_end().to_owned()
        }
        OperandKind::Structure(structure, _) => format!("tag of type {}", structure.name),
        OperandKind::SafetyInteger { immediate: Some((least, greatest)), unit } => {
            format!("DINT tag, or a number: {least} to {greatest} {unit}").trim_end().to_owned()
        }
        OperandKind::Pseudo(member) => format!("`?`, or a number that initialises {member}"),
        OperandKind::Bit(how) => format!("BOOL or bit of an integer, {}", access_word(how)),
        OperandKind::Number(how) => format!("SINT, INT, DINT or REAL, {}", access_words(how)),
        OperandKind::Integer(how) => format!("SINT, INT or DINT, {}", access_words(how)),
        OperandKind::SystemData(how) => format!("tag with room for the attribute, {}", access_word(how)),
        OperandKind::Parameter(how) => format!("BOOL, number or structure, {}", access_word(how)),
        kind => plain_words(kind).to_owned(),
    }
}

fn plain_words(kind: OperandKind) -> &'static str {
    match kind {
        OperandKind::SafetyBit { immediate: true } => "BOOL tag, or 0 or 1",
        OperandKind::SafetyBit { immediate: false } => "BOOL tag",
        OperandKind::SafetyInteger { .. } => "DINT tag",
        OperandKind::SafetyReal { immediate: true, not_negative: true } => "REAL tag, or a number not below 0",
        OperandKind::SafetyReal { immediate: true, not_negative: false } => "REAL tag, or a number",
        OperandKind::SafetyReal { immediate: false, .. } => "REAL tag",
        OperandKind::CopySource => "number, structure or array to copy from, or an element of one",
        OperandKind::CopyDestination => "number, structure or array to copy to, or an element of one",
        OperandKind::FillDestination => "number tag or element: the first of those that are filled",
        OperandKind::Array => "array, or an element of one",
        OperandKind::Resettable => "TIMER, COUNTER or CONTROL tag",
        OperandKind::ConstantLength => "number above 0 (a constant)",
        OperandKind::Expression => "expression",
        OperandKind::Condition => "expression, used as true or false",
        OperandKind::FileMode => "ALL, INC, or a number of elements for each scan",
        OperandKind::ByteOrder => "REVERSE, WORD or HIGH/LOW",
        OperandKind::Dimension => "0, 1 or 2",
        OperandKind::Label => "label of the same routine",
        OperandKind::LabelDefinition => "name of the label",
        OperandKind::Routine => "routine of the same program",
        OperandKind::InputCount => "number of the operands that follow which are inputs",
        OperandKind::EventTask => "event task of class Standard",
        OperandKind::SystemClass => "object class",
        OperandKind::SystemInstance => "object name, THIS, or nothing",
        OperandKind::SystemAttribute => "attribute of the class",
        _ => "see the summary",
    }
}

fn access_word(access: Access) -> &'static str {
    match access {
        Access::Read => "read",
        Access::Write => "written",
        Access::ReadWrite => "read and written",
    }
}

/// The same of numbers: where they are only read, a literal may stand.
fn access_words(access: Access) -> &'static str {
    match access {
        Access::Read => "read; or a number",
        access => access_word(access),
    }
}

/// Each value with the word that is printed, then the spellings that are read too.
fn choice_words(list: &ChoiceList) -> String {
    let printed = |(word, value): &(&str, i32)| list.word(*value) == Some(*word);
    let words: Vec<String> =
        list.words.iter().filter(|pair| printed(pair)).map(|(word, value)| format!("{word} ({value})")).collect();
    let also: Vec<&str> = list.words.iter().filter(|pair| !printed(pair)).map(|(word, _)| *word).collect();
    match also.is_empty() {
        true => words.join(", "),
        false => format!("{}; also read: {}", words.join(", "), also.join(", ")),
    }
}

/// The rules that bind operands of one call together.
pub(super) fn relation_words(instruction: &Instruction, relation: Relation) -> String {
    match relation {
        Relation::DifferentTags(a, b) => format!("{a} and {b} must be different tags."),
        Relation::NotZeroWhen(literal, choice, value) => {
            let operand = instruction.operands.iter().find(|operand| operand.name == choice);
            let word = match operand.map(|operand| operand.kind) {
                Some(OperandKind::Choice(list)) => list.word(value).unwrap_or_default(),
                _ => "",
            };
            format!("{literal} must not be 0 when {choice} is {word}.")
        }
        Relation::BelowUnlessZero(a, b) => format!("{a} must be below {b}, unless {b} is 0."),
        Relation::NotAbove(a, b) => format!("{a} must not be above {b}, where both are numbers."),
        Relation::PeriodAtMost(ms) => format!("The period of the safety task must be at most {ms} ms."),
    }
}
