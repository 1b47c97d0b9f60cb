//! A project of calls, each on a rung of its own.

use std::fmt::Write;

use twinrung_contest::generate::safety::{Call, Given, element, value_text};

/// A project with these calls, each on a rung of its own with a tag of its own for everything.
pub fn program(calls: &[Call]) -> String {
    let (mut tags, mut rungs) = (String::new(), String::new());
    for (number, call) in calls.iter().enumerate() {
        let backing = call.instruction.safety.map_or("", |safety| safety.backing.name);
        let _ = writeln!(tags, "Backing_{number} : {backing} (Class := Safety);");
        let _ = writeln!(tags, "Rung_{number} : BOOL (Class := Safety);");
        let mut operands = vec![format!("Backing_{number}")];
        for (index, given) in call.operands.iter().enumerate() {
            operands.push(match given {
                Given::Literal(value) if call.is_real(index) => value_text(call.kind(index), *value),
                Given::Literal(value) => value.to_string(),
                Given::Tag => {
                    let name = operand_tag(number, index);
                    let _ = writeln!(tags, "{name} : {} (Class := Safety);", element(call.kind(index)).name());
                    name
                }
            });
        }
        let _ = writeln!(rungs, "N: XIC(Rung_{number}){}({});", call.instruction.mnemonic, operands.join(","));
    }
    format!(
        "CONTROLLER Random_Calls (ProcessorType := \"1756-L73S\", Major := 20)\nTAG\n{tags}END_TAG\n\
         PROGRAM Main (Class := Safety, MAIN := \"Main\")\nROUTINE Main\n{rungs}END_ROUTINE\nEND_PROGRAM\n\
         TASK Safety (Type := PERIODIC, Class := Safety, Rate := 1, Watchdog := 1, Priority := 5)\nMain;\n\
         END_TASK\nEND_CONTROLLER\n"
    )
}

/// The tag of an operand of call `number`.
pub fn operand_tag(number: usize, index: usize) -> String {
    format!("Operand_{number}_{index}")
}
