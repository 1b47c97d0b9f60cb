//! The rungs of a routine.

use lalrpop_util::ParseError;

use super::rung_token::{RungLexer, RungToken};
use super::token::Token;
use super::{Reader, rung};
use crate::budget::BYTES_FOR_EACH;
use crate::excerpt::Excerpt;
use crate::reading::number::clip;
use crate::tree::{
    CompactString, Element, ErrorKind, Instruction, ReadError, Rung, RungKind, Span, Spanned, Text, Trivia,
};

/// What a rung without elements takes in the tree.
const RUNG_BYTES: usize = 100;

/// The kinds of rung as they are written. They differ in case.
const KINDS: &[(&str, RungKind)] = &[
    ("N", RungKind::Normal),
    ("I", RungKind::Insert),
    ("D", RungKind::Delete),
    ("IR", RungKind::InsertReplace),
    ("rR", RungKind::PendingReplaceOfInsertReplace),
    ("R", RungKind::Replace),
    ("rI", RungKind::PendingReplaceOfInsert),
    ("rN", RungKind::PendingReplaceOfNormal),
    ("e", RungKind::PendingInsert),
    ("er", RungKind::PendingReplace),
    ("d", RungKind::PendingDelete),
    ("dN", RungKind::PendingDeleteOfNormal),
    ("dD", RungKind::PendingDeleteOfDelete),
    ("dI", RungKind::PendingDeleteOfInsert),
    ("dIR", RungKind::PendingDeleteOfInsertReplace),
];

/// The kind that a rung's letters stand for.
pub(crate) fn rung_kind(letters: &str) -> Option<RungKind> {
    KINDS.iter().find(|(name, _)| *name == letters).map(|&(_, kind)| kind)
}

impl RungKind {
    /// The letters before the colon.
    pub fn letters(self) -> &'static str {
        KINDS.iter().find(|(_, kind)| *kind == self).map_or("N", |&(letters, _)| letters)
    }
}

/// Reads the neutral text of one rung, `;` included.
pub(crate) fn parse_rung(excerpt: Excerpt<'_>, comments: &mut Vec<CompactString>) -> Result<Vec<Element>, ReadError> {
    let lexer = RungLexer::new(excerpt, comments);
    rung::RungParser::new().parse(excerpt, lexer).map_err(|error| refusal(excerpt, error))
}

fn refusal(excerpt: Excerpt<'_>, error: ParseError<usize, RungToken, ReadError>) -> ReadError {
    let kind = ErrorKind::MalformedRung;
    match error {
        ParseError::User { error } => error,
        ParseError::ExtraToken { token: (start, token, end) }
        | ParseError::UnrecognizedToken { token: (start, token, end), .. } => {
            let found = clip(excerpt.slice(start, end));
            let message = match token {
                RungToken::Close => "a `]` without its `[`".to_string(),
                RungToken::Comma => "a `,` outside a branch: legs stand between `[` and `]`".to_string(),
                RungToken::Semicolon => "a branch is not closed by `]`".to_string(),
                RungToken::Open | RungToken::Instruction(Instruction { .. }) => {
                    format!("`{found}` stands behind the `;` that ends the rung")
                }
            };
            ReadError::new(kind, excerpt.locate(start, end), message)
        }
        ParseError::UnrecognizedEof { location, .. } | ParseError::InvalidToken { location } => {
            let place = excerpt.locate(location.saturating_sub(1), location);
            ReadError::new(kind, place, "the rung does not end with `;`").with_help("write `;` after its last element")
        }
    }
}

/// The piece of the file that a rung's text takes.
struct Extent {
    /// After the `;`, or where the rung breaks off.
    end: usize,
    /// Where a next rung seems to begin before the `;`.
    next_rung: Option<usize>,
}

impl Reader<'_> {
    /// The rungs up to the end of the routine.
    pub(super) fn rungs(&mut self, head: Span) -> Vec<Rung> {
        let mut rungs = Vec::new();
        let mut comment: Option<Box<Text>> = None;
        let mut trivia = Trivia::none();
        while let super::Next::Word(word) = self.next_in_block(head) {
            let Some(token) = self.cursor.peek() else { break };
            for line in self.cursor.leading().leading() {
                trivia.push_leading(line.clone());
            }
            self.cursor.next();
            if !self.cursor.take(Token::Colon) {
                self.not_a_rung(token);
                continue;
            }
            if word == "RC" {
                comment = self.rung_comment();
                continue;
            }
            let kind = rung_kind(word).unwrap_or_else(|| {
                let message = format!("there is no rung kind `{}`", clip(word));
                let error = ReadError::new(ErrorKind::UnknownRungKind, self.cursor.span(token), message);
                self.cursor.errors.push(error.with_help("write `N:` before a rung, `RC:` before its comment"));
                RungKind::Normal
            });
            let kind = Spanned::new(kind, self.cursor.span(token));
            let mut rung = self.rung(kind, comment.take(), std::mem::take(&mut trivia));
            self.cursor.trailing(&mut rung.trivia);
            rungs.push(rung);
        }
        if let Some(comment) = comment {
            let message = "a rung comment without a rung after it";
            self.cursor.errors.add(ErrorKind::MalformedRung, comment.span, message);
        }
        // Comments behind the last rung were taken as leading ones of a rung that did not come.
        let lost = trivia.leading().to_vec();
        self.cursor.keep_comments(lost);
        rungs
    }

    fn not_a_rung(&mut self, token: super::Placed) {
        let word = clip(self.cursor.slice(token));
        let message = format!("expected a rung (`N: ...;`) or `END_ROUTINE`, found `{word}`");
        let mut error = ReadError::new(ErrorKind::MalformedRung, self.cursor.span(token), message);
        if self.cursor.peek().is_some_and(|(_, next, _)| next == Token::Open) {
            error = error.with_help(format!("a rung begins with `N:`, here `N: {word}(...)`"));
        }
        self.cursor.errors.push(error);
        let extent = self.extent(token.2);
        self.cursor.skip_to(extent.next_rung.unwrap_or(extent.end));
    }

    /// `RC: "line" "line";`
    fn rung_comment(&mut self) -> Option<Box<Text>> {
        let expected = "the comment in double quotes, and `;`";
        let (attribute, span) = self.statement(expected, |file, run| {
            super::declaration::RungCommentParser::new().parse(file, run.iter().copied())
        })?;
        Some(Box::new(Text { text: attribute.text, span }))
    }

    fn rung(&mut self, kind: Spanned<RungKind>, comment: Option<Box<Text>>, trivia: Trivia) -> Rung {
        let file = self.cursor.file;
        let start = self.cursor.token_end();
        let mut extent = self.extent(start);
        let mut comments = Vec::new();
        let mut parsed = parse_rung(piece(file, start, extent.end), &mut comments);
        if let (Err(_), Some(next)) = (&parsed, extent.next_rung) {
            // Its `;` is missing, and the text runs on into the next rung.
            comments.clear();
            extent.end = next;
            parsed = parse_rung(piece(file, start, next), &mut comments);
        }
        let text = file.slice(start, extent.end);
        let blanks = text.len() - text.trim_start().len();
        let span = file.locate(start + blanks, start + text.trim_end().len().max(blanks));
        self.cursor.spend(RUNG_BYTES + text.len() * BYTES_FOR_EACH, span);
        self.cursor.skip_to(start + text.trim_end().len());
        self.cursor.keep_comments(comments);
        let broken = parsed.is_err();
        let elements = parsed.unwrap_or_else(|error| {
            self.cursor.errors.push(error);
            Vec::new()
        });
        Rung { number: None, kind, comment, elements, broken, trivia, span }
    }

    /// Finds the `;` that ends a rung: outside quotes and comments, and before the next rung but one.
    fn extent(&mut self, start: usize) -> Extent {
        let file = self.cursor.file;
        let text = file.slice(start, file.text.len());
        let bytes = text.as_bytes();
        let mut at = 0;
        let mut next_rung = None;
        while let Some(found) = bytes.get(at..).and_then(|rest| rest.iter().position(|byte| b";'\"/(\n".contains(byte)))
        {
            at += found;
            match bytes[at] {
                b';' => return Extent { end: start + at + 1, next_rung },
                quote @ (b'\'' | b'"') => at = after_quote(bytes, at, quote),
                b'/' if bytes.get(at + 1) == Some(&b'/') => {
                    at += memchr::memchr(b'\n', &bytes[at..]).unwrap_or(bytes.len() - at);
                }
                b'(' if bytes.get(at + 1) == Some(&b'*') => {
                    let absent = self.cursor.comment_end_is_absent();
                    let end = if *absent { None } else { memchr::memmem::find(&bytes[at + 2..], b"*)") };
                    *absent |= end.is_none();
                    at += end.map_or(2, |end| end + 4);
                }
                b'\n' => {
                    at += 1;
                    if begins_rung(&text[at..]) {
                        if let Some(first) = next_rung {
                            return Extent { end: first, next_rung: Some(first) };
                        }
                        next_rung = Some(start + at);
                    } else if text[at..].trim_start_matches([' ', '\t']).starts_with("END_") {
                        return Extent { end: next_rung.unwrap_or(start + at), next_rung };
                    }
                }
                _ => at += 1,
            }
        }
        Extent { end: file.text.len(), next_rung }
    }
}

fn piece(file: Excerpt<'_>, start: usize, end: usize) -> Excerpt<'_> {
    Excerpt { text: file.slice(start, end), source: file.source, start: file.start + start as u32, map: None }
}

/// After a quoted text; after its line when it is not closed.
fn after_quote(bytes: &[u8], start: usize, quote: u8) -> usize {
    let mut at = start + 1;
    while let Some(&byte) = bytes.get(at) {
        match byte {
            b'\n' => return at,
            b'$' => at += 2,
            _ if byte == quote => return at + 1,
            _ => at += 1,
        }
    }
    bytes.len()
}

/// Whether a line begins with `N:`, `RC:` or the like.
fn begins_rung(line: &str) -> bool {
    let line = line.trim_start_matches([' ', '\t']);
    let letters = line.bytes().take_while(u8::is_ascii_alphabetic).count();
    let (word, rest) = line.split_at(letters);
    let colon = rest.trim_start_matches([' ', '\t']).strip_prefix(':');
    (word == "RC" || rung_kind(word).is_some()) && colon.is_some_and(|rest| !rest.starts_with('='))
}
