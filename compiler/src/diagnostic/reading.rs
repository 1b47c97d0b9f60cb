//! Errors of the grammar as findings.

use twinrung_grammar::tree::{ErrorKind, ReadError};

use super::{
    AMBIGUOUS_RELATION, BROKEN_DATA, BROKEN_DECLARATION, BROKEN_FILE, BROKEN_OPERAND, BROKEN_RUNG, BROKEN_SCENARIO,
    Code, Finding, OVER_LIMIT, UNREADABLE_FILE,
};

/// The finding that reports an error of the grammar.
pub fn reading_finding(error: &ReadError) -> Finding {
    let finding = Finding::new(code(error.kind), error.span, error.message.clone());
    match &error.help {
        Some(help) => finding.help(help.clone()),
        None => finding,
    }
}

fn code(kind: ErrorKind) -> &'static Code {
    match kind {
        ErrorKind::Unreadable | ErrorKind::NotUtf8 | ErrorKind::Empty => &UNREADABLE_FILE,
        ErrorKind::MalformedXml | ErrorKind::NotL5x => &BROKEN_FILE,
        ErrorKind::TooLarge | ErrorKind::TooDeep | ErrorKind::TooMany => &OVER_LIMIT,
        ErrorKind::MalformedRung | ErrorKind::UnknownRungKind => &BROKEN_RUNG,
        ErrorKind::MalformedScenario => &BROKEN_SCENARIO,
        ErrorKind::MalformedTagReference
        | ErrorKind::MalformedExpression
        | ErrorKind::MalformedWords
        | ErrorKind::MalformedNumber => &BROKEN_OPERAND,
        ErrorKind::AmbiguousRelation => &AMBIGUOUS_RELATION,
        ErrorKind::MalformedData | ErrorKind::MalformedEscape => &BROKEN_DATA,
        _ => &BROKEN_DECLARATION,
    }
}
