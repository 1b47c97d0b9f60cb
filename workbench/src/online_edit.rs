//! What an online edit changes, beyond what the controller itself asks of it.

use twinrung_bytecode::image::{Image, Owner};

/// Calls of safety application instructions in a routine's canonical text.
fn safety_calls(text: &str) -> Vec<&str> {
    let mut calls = Vec::new();
    for instruction in twinrung_catalog::instructions::ALL.iter().filter(|one| one.group.is_safety_library()) {
        for (at, _) in text.match_indices(instruction.mnemonic) {
            let rest = text.get(at..).unwrap_or_default();
            let before = text.get(..at).and_then(|before| before.chars().next_back());
            let is_word = before.is_some_and(|one| one.is_ascii_alphanumeric() || one == '_' || one == '.');
            if is_word || !rest.get(instruction.mnemonic.len()..).is_some_and(|rest| rest.starts_with('(')) {
                continue;
            }
            let mut depth = 0_usize;
            let end = rest.char_indices().find(|(_, character)| {
                match character {
                    '(' => depth += 1,
                    ')' => depth = depth.saturating_sub(1),
                    _ => return false,
                }
                depth == 0
            });
            calls.extend(end.and_then(|(end, _)| rest.get(..=end)));
        }
    }
    calls.sort_unstable();
    calls
}

/// A call of a safety application instruction that an online edit would add, remove or change. Its configuration takes effect
/// only with a change from Program to Run (dual-channel-inputs.md 1.2): such a change is a download (decided).
pub fn changed_safety_call(before: &Image, after: &Image) -> Option<String> {
    let texts = |image: &Image| -> Vec<String> {
        let of_programs = image.routines.iter().filter(|routine| matches!(routine.owner, Owner::Program(_)));
        of_programs.map(|routine| routine.text.clone()).collect()
    };
    let (before, after) = (texts(before), texts(after));
    let calls = |texts: &[String]| -> Vec<String> {
        let mut calls: Vec<String> = texts.iter().flat_map(|text| safety_calls(text)).map(str::to_owned).collect();
        calls.sort_unstable();
        calls
    };
    let (before, after) = (calls(&before), calls(&after));
    let alone = |these: &[String], others: &[String]| these.iter().find(|one| !others.contains(one)).cloned();
    alone(&after, &before).or_else(|| alone(&before, &after)).or_else(|| {
        // The same calls, another number of times.
        (before.len() != after.len()).then(|| after.first().or(before.first()).cloned()).flatten()
    })
}

#[cfg(test)]
mod tests {
    use super::safety_calls;

    #[test]
    fn calls_when_a_text_has_some_then_each_is_found_with_its_operands() {
        let text = "XIC(Go)DCS(EStop,E-STOP,EQUIVALENT - ACTIVE HIGH,500,MANUAL,MANUAL,A,B,Levels[(1+2)],Reset);\nXIC(MyDCS)OTE(Run);\n";
        let call = "DCS(EStop,E-STOP,EQUIVALENT - ACTIVE HIGH,500,MANUAL,MANUAL,A,B,Levels[(1+2)],Reset)";
        assert_eq!(safety_calls(text), [call]);
    }
}
