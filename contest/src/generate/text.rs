//! Declarations as text.

use std::collections::HashSet;
use std::fmt::Write;

use super::data::{Kind, Record, Variable};
use super::writer::AddOn;

/// The name of a type.
pub fn type_name(kind: Kind, records: &[Record], add_ons: &[AddOn]) -> String {
    match kind {
        Kind::Element(element) => element.name().to_owned(),
        Kind::Timer => "TIMER".to_owned(),
        Kind::Counter => "COUNTER".to_owned(),
        Kind::Control => "CONTROL".to_owned(),
        Kind::Record(index) => records[index].name.clone(),
        Kind::Instance(index) => add_ons[index].name.clone(),
        Kind::Backing(backing) => backing.name.to_owned(),
    }
}

/// The sizes of an array in brackets, or nothing.
pub fn sizes_text(dimensions: [u32; 3]) -> String {
    let sizes: Vec<String> = dimensions.iter().take_while(|size| **size > 0).map(u32::to_string).collect();
    if sizes.is_empty() { String::new() } else { format!("[{}]", sizes.join(",")) }
}

/// One line for each tag.
pub fn tags(text: &mut String, variables: &[Variable], records: &[Record], add_ons: &[AddOn], attributes: &str) {
    for one in variables {
        let line = match &one.alias {
            Some(target) => format!("{} OF {target};", one.name),
            None => {
                let initial = one.initial.as_ref().map(|value| format!(" := {value}")).unwrap_or_default();
                let (kind, sizes) = (type_name(one.kind, records, add_ons), sizes_text(one.dimensions));
                format!("{} : {kind}{sizes}{attributes}{initial};", one.name)
            }
        };
        line_of(text, 4, &line);
    }
}

/// A routine.
pub fn routine(text: &mut String, name: &str, rungs: &[String]) {
    line_of(text, 4, &format!("ROUTINE {name}"));
    for rung in rungs {
        line_of(text, 6, &format!("N: {rung};"));
    }
    line_of(text, 4, "END_ROUTINE");
}

/// A data type: BOOLs are packed into hidden SINTs, eight at a time.
pub fn record(text: &mut String, record: &Record, records: &[Record]) {
    line_of(text, 2, &format!("DATATYPE {} (FamilyType := NoFamily)", record.name));
    let (mut packed, mut hosts) = (8, 0);
    for member in &record.members {
        if member.kind.is_bit() && member.length == 0 {
            if packed == 8 {
                hosts += 1;
                packed = 0;
                line_of(text, 4, &format!("SINT ZZZZZZZZZZ{}{hosts} (Hidden := 1);", record.name));
            }
            line_of(text, 4, &format!("BIT {} ZZZZZZZZZZ{}{hosts} : {packed};", member.name, record.name));
            packed += 1;
        } else {
            packed = 8;
            let sizes = sizes_text([member.length, 0, 0]);
            line_of(text, 4, &format!("{} {}{sizes};", type_name(member.kind, records, &[]), member.name));
        }
    }
    line_of(text, 2, "END_DATATYPE");
}

/// The words of a text that can be names.
pub fn words(text: &str) -> HashSet<&str> {
    text.split(|one: char| !one.is_ascii_alphanumeric() && one != '_').collect()
}

/// An indented line.
pub fn line_of(text: &mut String, indent: usize, line: &str) {
    // Writing to a String does not fail.
    let _ = writeln!(text, "{:indent$}{line}", "");
}
