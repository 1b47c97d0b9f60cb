//! What every rule's test does with the samples of its entry.

use twinrung_grammar::tree::{Sources, Span};

use crate::diagnostic::{Code, Finding, Severity};
use crate::{Completion, check};

/// The findings of a text.
pub(crate) fn findings(text: &str) -> (Sources, Vec<Finding>) {
    let mut sources = Sources::new();
    let reading = twinrung_grammar::read(&mut sources, "sample.rll", text.as_bytes().to_vec());
    let checked = check(&reading, &Completion::default());
    (sources, checked.findings)
}

fn show(sources: &Sources, findings: &[Finding]) -> String {
    findings
        .iter()
        .map(|finding| {
            let place = sources.line_column(finding.span);
            format!("{} {}:{} {}\n", finding.code.id, place.line, place.column, finding.message)
        })
        .collect()
}

/// The bad sample breaks this rule at the marked place and no other rule; the good one breaks none.
pub(crate) fn holds(code: &'static Code) {
    let (sources, good) = findings(code.good);
    let in_good: Vec<&Finding> =
        good.iter().filter(|finding| finding.severity == Severity::Error || finding.code == code).collect();
    assert!(in_good.is_empty(), "the good sample of {}:\n{}", code.id, show(&sources, &good));

    let text = code.bad_text();
    let (sources, bad) = findings(&text);
    let marks = marks(code.bad);
    let own: Vec<&Finding> = bad.iter().filter(|finding| finding.code == code).collect();
    let others: Vec<&Finding> =
        bad.iter().filter(|finding| finding.severity == Severity::Error && finding.code != code).collect();
    assert!(others.is_empty(), "the bad sample of {} breaks other rules:\n{}", code.id, show(&sources, &bad));
    let places: Vec<&str> = own.iter().map(|finding| sources.text(finding.span)).collect();
    let expected: Vec<&str> = marks.iter().map(|(begin, end)| &text[*begin..*end]).collect();
    let begins: Vec<usize> = own.iter().map(|finding: &&Finding| start(finding.span)).collect();
    let expected_begins: Vec<usize> = marks.iter().map(|(begin, _)| *begin).collect();
    assert_eq!((places, begins), (expected, expected_begins), "{}:\n{}", code.id, show(&sources, &bad));
    assert!(own.iter().all(|finding| finding.help.is_some()), "{} has no way out", code.id);
}

fn start(span: Span) -> usize {
    span.start as usize
}

/// The marked places, as byte ranges of the text without marks.
fn marks(marked: &str) -> Vec<(usize, usize)> {
    let mut list = Vec::new();
    let mut removed = 0;
    for (position, _) in marked.match_indices("<<") {
        let begin = position - removed;
        let end = marked[position..].find(">>").map(|length| position + length - removed - 2);
        list.push((begin, end.expect("a mark is closed")));
        removed += 4;
    }
    list
}
