//! Suppressions: a warning that somebody accepts, for a reason that every report shows.
//!
//! `allow W0101: why` stands in a comment of the source, in a rung comment or in a description, so that it survives in
//! an L5X too. It covers the rung or the declaration that the text belongs to, and of a program, a routine or an Add-On
//! Instruction the declaration alone, never the rungs in it. Only warnings can be suppressed. A suppression that covers
//! nothing is a warning itself.

mod places;

use twinrung_grammar::tree::{File, Span};

use crate::diagnostic::{BAD_SUPPRESSION, Finding, Findings, Severity, UNUSED_SUPPRESSION, by_id};

/// The word before the codes.
const WORD: &str = "allow";

/// One code that is accepted at one place.
#[derive(Debug)]
struct Suppression {
    /// What it covers.
    covers: Span,
    /// Where it is written, or what it is written beside.
    written: Span,
    code: String,
    reason: String,
    used: bool,
}

/// Marks the warnings that suppressions cover, and reports suppressions that are malformed or cover nothing.
pub(crate) fn apply(file: &File, contexts: &[File], findings: &mut Findings) {
    let mut list: Vec<Suppression> = Vec::new();
    places::visit(file, &mut |covers, written, text| read(covers, written, text, &mut list, Some(&mut *findings)));
    let own = list.len();
    for context in contexts {
        places::visit(context, &mut |covers, written, text| read(covers, written, text, &mut list, None));
    }
    if list.is_empty() {
        return;
    }
    // Places do not overlap, so the last one that begins before a finding is the one that may hold it.
    let mut order: Vec<usize> = (0..list.len()).collect();
    order.sort_by_key(|at| (list[*at].covers.source, list[*at].covers.start));
    findings.suppress(|finding| {
        let place = (finding.span.source, finding.span.start);
        let end = order.partition_point(|at| (list[*at].covers.source, list[*at].covers.start) <= place);
        let mut reason = None;
        let mut covering = None;
        for at in order[..end].iter().rev() {
            let one = &mut list[*at];
            let inside = one.covers.source == finding.span.source && finding.span.start <= one.covers.end;
            if !inside || covering.is_some_and(|covering| covering != one.covers) {
                break;
            }
            covering = Some(one.covers);
            if one.code == finding.code.id {
                one.used = true;
                reason = Some(one.reason.clone());
            }
        }
        reason
    });
    // With an error some rules did not see everything, and beyond the limit findings are not kept.
    if findings.has_errors() || findings.is_cut() {
        return;
    }
    for unused in list.iter().take(own).filter(|one| !one.used) {
        let message = format!("nothing here gives {}, which is suppressed", unused.code);
        findings.push(Finding::new(&UNUSED_SUPPRESSION, unused.written, message).help("delete the suppression"));
    }
}

/// Reads the suppressions of a comment; without `findings` what is malformed is left to another run.
fn read(covers: Span, written: Span, text: &str, list: &mut Vec<Suppression>, mut findings: Option<&mut Findings>) {
    let text = text.trim_start_matches("//").trim_start_matches("(*").trim_end_matches("*)");
    for line in text.lines() {
        let Some((codes, reason)) = split(line) else { continue };
        for code in codes {
            match fault(&code, reason) {
                None => list.push(Suppression { covers, written, code, reason: reason.to_owned(), used: false }),
                Some((message, help)) => {
                    if let Some(findings) = findings.as_deref_mut() {
                        findings.push(Finding::new(&BAD_SUPPRESSION, written, message).help(help));
                    }
                }
            }
        }
    }
}

/// The codes and the reason of a line that is a suppression; nothing for a line that merely begins with the word.
fn split(line: &str) -> Option<(Vec<String>, &str)> {
    let line = line.trim();
    let rest = line.get(..WORD.len()).filter(|head| head.eq_ignore_ascii_case(WORD)).and(line.get(WORD.len()..))?;
    if !rest.starts_with(char::is_whitespace) {
        return None;
    }
    let (codes, reason) = rest.split_once(':').unwrap_or((rest, ""));
    let codes: Vec<String> = codes.split(',').map(|code| code.trim().to_ascii_uppercase()).collect();
    let is_code = |code: &String| {
        let digits = code.get(1..).unwrap_or("");
        code.starts_with(|first: char| first.is_ascii_uppercase())
            && digits.len() == 4
            && digits.bytes().all(|digit| digit.is_ascii_digit())
    };
    codes.iter().all(is_code).then_some((codes, reason.trim()))
}

/// Why a suppression is not admitted, and the way out.
fn fault(code: &str, reason: &str) -> Option<(String, String)> {
    let Some(known) = by_id(code) else {
        return Some((format!("there is no code {code} to suppress"), "name the code of a warning".to_owned()));
    };
    if known.severity == Severity::Error {
        let message = format!("{code} is an error and cannot be suppressed");
        return Some((message, format!("mend what {code} reports; only warnings can be suppressed")));
    }
    if *known == UNUSED_SUPPRESSION {
        return Some((format!("{code} cannot be suppressed"), "delete the suppression that covers nothing".to_owned()));
    }
    if reason.is_empty() {
        let message = format!("the suppression of {code} gives no reason");
        return Some((message, format!("write why it is acceptable: {WORD} {code}: the reason")));
    }
    None
}
