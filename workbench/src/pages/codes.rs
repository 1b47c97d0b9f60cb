//! Fault and diagnostic codes: the lists of a page, and the page of one code.

use twinrung_catalog::{Code, CodeWord, Instruction, SafetyApplication, instructions};

use super::{Block, Page, Table};

/// Adds a section for each word that shows codes.
pub(super) fn sections(page: &mut Page, safety: &SafetyApplication) {
    let of = |wanted: fn(CodeWord) -> bool| -> Vec<&'static Code> {
        safety.codes.iter().filter(|code| wanted(code.word)).collect()
    };
    let lists = [
        ("Fault codes", of(|word| word == CodeWord::Fault)),
        ("Diagnostic codes", of(|word| word == CodeWord::Diagnostic)),
        ("Fault and prompt flags", of(|word| matches!(word, CodeWord::Flag(_)))),
    ];
    for (heading, codes) in lists.into_iter().filter(|(_, codes)| !codes.is_empty()) {
        page.heading(heading);
        let rows = codes.into_iter().map(row).collect();
        page.blocks.push(Block::Entries(Table { heads: HEADS.to_vec(), rows }));
    }
}

const HEADS: [&str; 4] = ["code", "cause", "remedy", "origin"];

fn row(code: &Code) -> Vec<String> {
    [&shown(code), code.cause, code.remedy, code.origin].map(str::to_owned).to_vec()
}

/// `FaultCode 16#4001 (16385)`, or the flag.
fn shown(code: &Code) -> String {
    match code.word {
        CodeWord::Fault => format!("FaultCode 16#{:04X} ({})", code.value, code.value),
        CodeWord::Diagnostic => format!("DiagnosticCode 16#{:04X} ({})", code.value, code.value),
        CodeWord::Flag(member) => format!("{member} = 1"),
    }
}

/// A number as codes are written: 16#4001, 0x4001 or decimal.
pub fn number(text: &str) -> Option<i32> {
    let hexadecimal = text.get(..3).filter(|begin| *begin == "16#").and(text.get(3..));
    let hexadecimal = hexadecimal.or_else(|| text.strip_prefix("0x")).or_else(|| text.strip_prefix("0X"));
    match hexadecimal {
        Some(digits) => i32::from_str_radix(&digits.replace('_', ""), 16).ok(),
        None => text.parse().ok(),
    }
}

fn matches(code: &Code, what: &str) -> bool {
    match code.word {
        CodeWord::Flag(member) => member.eq_ignore_ascii_case(what),
        _ => number(what) == Some(code.value),
    }
}

/// The page of a code, or of a fault flag, that an instruction shows; `what` is a number or the flag's name.
///
/// # Errors
///
/// A sentence that says what is not known, and what is.
pub fn of_instruction(what: &str, mnemonic: &str) -> Result<Page, String> {
    let instruction =
        Instruction::by_mnemonic(mnemonic).ok_or_else(|| format!("`{mnemonic}` is not a certified instruction"))?;
    let mnemonic = instruction.mnemonic;
    let safety = instruction.safety.ok_or_else(|| format!("{mnemonic} shows no fault or diagnostic codes"))?;
    let codes: Vec<&Code> = safety.codes.iter().filter(|code| matches(code, what)).collect();
    if codes.is_empty() {
        let known: Vec<String> = safety.codes.iter().map(shown).collect();
        return Err(format!("{mnemonic} shows no code `{what}`; it shows:\n  {}", known.join("\n  ")));
    }
    let mut page = Page { title: format!("{mnemonic}  {}", instruction.name), blocks: Vec::new() };
    let rows = codes.into_iter().map(row).collect();
    page.blocks.push(Block::Entries(Table { heads: HEADS.to_vec(), rows }));
    page.paragraph(format!("`explain {mnemonic}` prints the whole page. Specified in {}.", safety.reference));
    Ok(page)
}

/// What a number means in each instruction that shows it; `None` where none does.
pub fn of_every_instruction(what: &str) -> Option<Page> {
    let mut rows: Vec<Vec<String>> = Vec::new();
    for instruction in instructions::ALL {
        let codes = instruction.safety.map_or(&[][..], |safety| safety.codes);
        for code in codes.iter().filter(|code| number(what).is_some() && matches(code, what)) {
            let cells = row(code);
            match rows.iter_mut().find(|known| known[1..] == cells[1..] && known[0].ends_with(&cells[0])) {
                Some(known) => known[0] = known[0].replacen(": ", &format!(", {}: ", instruction.mnemonic), 1),
                None => {
                    let first = format!("{}: {}", instruction.mnemonic, cells[0]);
                    rows.push(std::iter::once(first).chain(cells.into_iter().skip(1)).collect());
                }
            }
        }
    }
    if rows.is_empty() {
        return None;
    }
    let title = format!("{what}: a code means what its instruction says");
    let mut page = Page { title, blocks: vec![Block::Entries(Table { heads: HEADS.to_vec(), rows })] };
    page.paragraph("Add --for MNEMONIC to see the code of one instruction.");
    Some(page)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_when_written_as_codes_are_then_they_are_read() {
        assert_eq!(["16#4001", "0x4001", "16385", "16#40_01"].map(number), [Some(0x4001); 4]);
        assert_eq!(["16#", "II", "16#xyz"].map(number), [None; 3]);
    }

    #[test]
    fn code_when_the_instruction_shows_it_then_cause_and_remedy_are_told() {
        let page = of_instruction("16#4001", "dcs").unwrap().terminal(80);
        assert!(page.contains("FaultCode 16#4001 (16385)") && page.contains("remedy  Check the wiring"), "{page}");
        let flag = of_instruction("ii", "DIN").unwrap().terminal(80);
        assert!(flag.contains("II = 1") && flag.contains("disagreed for 500 ms"), "{flag}");
    }

    #[test]
    fn code_when_the_instruction_does_not_show_it_then_those_that_it_shows_are_listed() {
        let refusal = of_instruction("16#9999", "CROUT").unwrap_err();
        assert!(
            refusal.contains("CROUT shows no code `16#9999`") && refusal.contains("FaultCode 16#0020"),
            "{refusal}"
        );
        assert!(of_instruction("1", "XIC").unwrap_err().contains("no fault or diagnostic codes"));
        assert!(of_instruction("1", "SQI").unwrap_err().contains("not a certified instruction"));
    }

    #[test]
    fn code_when_no_instruction_is_named_then_equal_meanings_are_told_once() {
        let page = of_every_instruction("16#4001").unwrap().terminal(80);
        assert!(page.contains("DCS, DCST, DCSTL, DCSTM"), "{page}");
        assert!(of_every_instruction("16#7FFF").is_none());
    }
}
