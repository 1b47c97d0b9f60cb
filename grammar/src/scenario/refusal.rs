//! What is said where a statement of a scenario file cannot be read.

use lalrpop_util::ParseError;

use super::token::Token;
use crate::excerpt::Excerpt;
use crate::reading::number::clip;
use crate::tree::{ErrorKind, ReadError};

/// What the parser expects, and how a person is told. The first group of which anything is expected is named.
const EXPECTED: &[(&[&str], &str)] = &[
    (&["shorted"], "`is VALUE`, `shorted to`, `open`, `repaired`, `follows` or `fails`"),
    (&["lost"], "`is VALUE`, `terminal NUMBER`, or what happens to the module: power lost, lost, idle"),
    (&["on"], "a value: on, off, or a number"),
    (&["ms"], "a unit of time: ms, s, min or scans"),
    (&["stays"], "`is VALUE`, a comparison, or `stays VALUE for TIME`"),
    (&["<"], "`is VALUE` or a comparison: < <= > >="),
    (&["is"], "`is`"),
    (&["fault"], "a check: `NAME is VALUE`, `NAME stays VALUE for TIME` or `fault TYPE/CODE`"),
    (&["name"], "the name of a tag"),
    (&["terminal"], "`24 V`, `0 V` or `terminal NUMBER`"),
    (&["because"], "`because` and a reason in quotes"),
    (&["quoted"], "a text in quotes"),
    (&["%"], "`%`"),
    (&["coverage"], "`coverage`"),
    (&["/"], "`/` and the fault code"),
    (&["number"], "a number"),
    (&["every"], "`every TIME`"),
    (&["before"], "`before TIME`"),
    (&["run"], "`run` or `program`"),
    (&["up"], "`up in run` or `up in program`"),
    (&["in"], "`in run` or `in program`"),
    (&["end"], "a line of the block (with, given, at, after, when, hold, toggle, mode, then, never) or `end`"),
    (&["for"], "`for TIME`"),
    (&["scenario"], "`scenario`, `setup`, `project`, `minimum`, `never` or `exclude`"),
];

/// A way out for what people write from habit.
fn help(token: Option<Token>, wanted: &str) -> Option<&'static str> {
    match token {
        Some(Token::Equal) => Some("a value is written `NAME is VALUE`, another one `NAME is not VALUE`"),
        Some(Token::Comma) if wanted.starts_with('`') => Some("conditions of `never` are joined with `and`"),
        Some(Token::And) => Some(
            "settings and checks are joined with commas, only the conditions of `never` and contacts in series with `and`",
        ),
        None => Some("a block ends with `end`"),
        Some(_) if wanted.starts_with("the name") => {
            Some("words of the format are written in small letters; write a tag of the same name with a capital")
        }
        Some(_) if wanted.starts_with("a unit") => Some("write 200 ms, 1.5 s, 2 min or 3 scans"),
        _ => None,
    }
}

/// The error of the parser as one for a person.
pub(crate) fn refusal(file: Excerpt<'_>, error: ParseError<usize, Token, ReadError>) -> ReadError {
    let kind = ErrorKind::MalformedScenario;
    let (start, token, end, expected) = match error {
        ParseError::User { error } => return error,
        ParseError::UnrecognizedToken { token: (start, token, end), expected } => (start, Some(token), end, expected),
        ParseError::ExtraToken { token: (start, token, end) } => (start, Some(token), end, Vec::new()),
        ParseError::UnrecognizedEof { location, expected } => (location, None, location, expected),
        ParseError::InvalidToken { location } => (location, None, location, Vec::new()),
    };
    let place = file.locate(start, end);
    let wanted = wanted(&expected);
    let message = match token {
        Some(Token::UnclosedQuoted) => "a quoted text is not closed on its line".to_owned(),
        Some(Token::Unknown) => format!("`{}` means nothing here", clip(file.slice(start, end))),
        Some(_) => format!("`{}` does not belong here; expected {wanted}", clip(file.slice(start, end))),
        None => format!("the file breaks off; expected {wanted}"),
    };
    let error = ReadError::new(kind, place, message);
    match help(token, wanted) {
        Some(help) => error.with_help(help),
        None => error,
    }
}

fn wanted(expected: &[String]) -> &'static str {
    let has = |word: &str| expected.iter().any(|one| one.trim_matches('"') == word);
    EXPECTED.iter().find(|(words, _)| words.iter().any(|word| has(word))).map_or("something else", |(_, text)| text)
}
