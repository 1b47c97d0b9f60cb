//! The page of a finding's code, and the table of all of them.

use std::fmt::Write;

use twinrung_compiler::diagnostic::{self, Code, Severity};

use super::{Block, Page, markdown::escaped};

/// The page of a finding's code (`S0101`); `None` where there is none of that name.
pub fn page(id: &str) -> Option<Page> {
    let code = diagnostic::by_id(&id.to_ascii_uppercase())?;
    let mut page = Page { title: format!("{}  {}", code.id, code.title), blocks: Vec::new() };
    page.paragraph(code.explanation);
    if !code.citation.is_empty() {
        page.paragraph(format!("Source: {}", code.citation));
    }
    for (heading, sample) in [("Refused or reported", code.bad_text()), ("Accepted", code.good.to_owned())] {
        if !sample.is_empty() {
            page.heading(heading);
            page.blocks.push(Block::Verbatim(sample.trim_matches('\n').lines().map(str::to_owned).collect()));
        }
    }
    Some(page)
}

/// `docs/rules.md`: every code with its weight, its title and where it comes from.
pub fn rules_table() -> String {
    let mut out = String::from(
        "# The rules\n\nWhat `twinrung check` reports, by code. `twinrung explain CODE` says why, and shows a program that \
         keeps the rule and one that breaks it. This page is made from the compiler's table of codes, and a test \
         compares the two.\n",
    );
    for (letter, heading) in FAMILIES {
        let codes: Vec<&Code> = diagnostic::ALL.iter().copied().filter(|code| code.id.starts_with(letter)).collect();
        if codes.is_empty() {
            continue;
        }
        let _ = write!(out, "\n## {heading}\n\n| code | weight | rule | source |\n|---|---|---|---|\n");
        for code in codes {
            let cells = [code.title, code.citation].map(escaped);
            let _ = writeln!(out, "| {} | {} | {} | {} |", code.id, weight(code.severity), cells[0], cells[1]);
        }
    }
    out
}

/// What the first letter of a code says.
const FAMILIES: [(char, &str); 4] = [
    ('S', "What the safety rules refuse"),
    ('E', "What cannot be read or resolved"),
    ('W', "Warnings"),
    ('D', "Defects of this tool"),
];

fn weight(severity: Severity) -> &'static str {
    match severity {
        Severity::Error => "error",
        Severity::Warning => "warning",
        Severity::Note => "note",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rules_table_when_made_then_every_code_has_a_row() {
        let table = rules_table();
        let missing: Vec<&str> =
            diagnostic::ALL.iter().map(|code| code.id).filter(|id| !table.contains(&format!("| {id} |"))).collect();
        assert_eq!(missing, Vec::<&str>::new());
    }

    #[test]
    fn finding_page_when_asked_for_then_samples_stand_on_it_without_marks() {
        let drawn = page("s0101").unwrap().terminal(100);
        assert!(drawn.contains("ACCEPTED") && !drawn.contains("<<"), "{drawn}");
        assert!(page("S9999").is_none());
    }
}
