//! What is skipped: trends, watch lists, other languages, encoded components. An island is found by
//! the word that ends it, without a look at what is in between.

use super::{Reader, declaration, refusal};
use crate::fields::Fields;
use crate::tree::{Attribute, Encoded, ErrorKind, HistoryEntry, Island, Name, Span, Text};

/// The islands: the word that begins one and the word that ends it.
const ISLANDS: &[(&str, &str)] = &[
    ("TREND", "END_TREND"),
    ("QUICK_WATCH", "END_QUICK_WATCH"),
    ("PARAMETER_CONNECTION", "END_PARAMETER_CONNECTION"),
    ("CONFIG", "END_CONFIG"),
    ("AUTHENTICATION_CODE", "END_AUTHENTICATION_CODE"),
    ("CHILD_PROGRAMS", "END_CHILD_PROGRAMS"),
    ("HISTORY_ENTRY", "END_HISTORY_ENTRY"),
    ("LOGIC", "END_LOGIC"),
    ("DATALOG", "END_DATALOG"),
    ("ALARM_DEFINITION", "END_ALARM_DEFINITION"),
    ("ST_ROUTINE", "END_ST_ROUTINE"),
    ("FBD_ROUTINE", "END_FBD_ROUTINE"),
    ("SFC_ROUTINE", "END_SFC_ROUTINE"),
    ("ENCODED_DATA", "END_ENCODED_DATA"),
];

impl Reader<'_> {
    /// Skips an island; nothing when the word begins none, or nothing ends it.
    pub(super) fn island(&mut self, word: &str) -> Option<Island> {
        ISLANDS.iter().find(|(begin, _)| *begin == word)?;
        let token = self.cursor.peek()?;
        let kind = Name::new(word, self.cursor.span(token));
        let start = token.0;
        let name = self.island_name(token.2);
        let trivia = self.cursor.leading();
        if self.skip_island_from(word, token.2).is_none() {
            self.unclosed(kind.span, &format!("END_{word}"));
            self.cursor.next();
        }
        let span = self.cursor.file.locate(start, self.cursor.token_end());
        let text = Text::new(self.cursor.file.slice(start, self.cursor.token_end()), span);
        Some(Island { kind, name, text, trivia, span })
    }

    /// The word after the one that begins an island.
    fn island_name(&self, after: usize) -> Option<Name> {
        let file = self.cursor.file;
        let rest = file.slice(after, file.text.len());
        let blanks = rest.len() - rest.trim_start_matches([' ', '\t']).len();
        let word = &rest[blanks..];
        let length = word.bytes().take_while(|&byte| byte.is_ascii_alphanumeric() || byte == b'_').count();
        let (start, end) = (after + blanks, after + blanks + length);
        (length > 0 && blanks > 0).then(|| Name::new(&word[..length], file.locate(start, end)))
    }

    /// Takes the rest of an island whose head was taken: the text up to the word that ends it.
    pub(super) fn island_body(&mut self, word: &str, head: Span) -> Text {
        let from = self.cursor.token_end();
        // Comments after the head are part of the body.
        self.cursor.forget_comments();
        match self.skip_island_from(word, from) {
            Some(end) => {
                let to = (end.end as usize).saturating_sub("END_".len() + word.len()).max(from);
                let to = to.saturating_sub(self.cursor.file.start as usize);
                let body = self.cursor.file.slice(from, to);
                let blanks = body.len() - body.trim_start().len();
                let start = (from + blanks).min(to);
                Text::new(body.trim(), self.cursor.file.locate(start, to))
            }
            None => {
                self.unclosed(head, &format!("END_{word}"));
                Text::new("", head)
            }
        }
    }

    fn skip_island_from(&mut self, word: &str, from: usize) -> Option<Span> {
        let &(_, end) = ISLANDS.iter().find(|(begin, _)| *begin == word)?;
        if self.absent_ends.contains(&end) {
            return None;
        }
        let file = self.cursor.file;
        let text = file.slice(from, file.text.len());
        let is_word = |byte: Option<&u8>| byte.is_some_and(|&byte| byte.is_ascii_alphanumeric() || byte == b'_');
        let bytes = text.as_bytes();
        let found = memchr::memmem::find_iter(bytes, end.as_bytes()).find(|&at| {
            let before = at.checked_sub(1).and_then(|index| bytes.get(index));
            !is_word(before) && !is_word(bytes.get(at + end.len())) && !begins_with_quote(bytes, at)
        });
        let Some(at) = found else {
            self.absent_ends.push(end);
            return None;
        };
        let end = from + at + end.len();
        self.cursor.skip_to(end);
        Some(file.locate(end, end))
    }

    /// `ENCODED_DATA (EncodedType := ROUTINE, Name := "x", ...) ... END_ENCODED_DATA`
    pub(super) fn encoded(&mut self) -> Encoded {
        let trivia = self.cursor.leading();
        let span = self.cursor.next().map_or(Span::default(), |token| self.cursor.span(token));
        let attributes = self.attributes_without_name();
        let mut fields = Fields::new(attributes, &mut self.cursor.errors);
        let kind = fields.name(&["EncodedType"]).unwrap_or_default();
        let name = fields.name(&["Name"]);
        let attributes = fields.rest();
        let text = self.island_body("ENCODED_DATA", span);
        let whole = span.to(text.span);
        Encoded { kind, name, attributes, text, trivia, span: whole }
    }

    /// `HISTORY_ENTRY (User := "x", Timestamp := "...", ...) END_HISTORY_ENTRY`
    pub(super) fn history_entry(&mut self) -> HistoryEntry {
        let trivia = self.cursor.leading();
        let span = self.cursor.next().map_or(Span::default(), |token| self.cursor.span(token));
        let attributes = self.attributes_without_name();
        let text = self.island_body("HISTORY_ENTRY", span);
        let whole = span.to(text.span);
        HistoryEntry { attributes, text, trivia, span: whole }
    }

    /// The attribute list of a component that has no name; it may have none.
    fn attributes_without_name(&mut self) -> Vec<Attribute> {
        let file = self.cursor.file;
        self.cursor.take_head();
        let attributes = self.cursor.checked_run().and_then(|run| {
            if run.is_empty() {
                return Ok(Vec::new());
            }
            declaration::AttributesParser::new()
                .parse(file, run.iter().copied())
                .map_err(|error| refusal(file, error, ErrorKind::MalformedDeclaration, "an attribute list"))
        });
        attributes.unwrap_or_else(|error| {
            self.cursor.errors.push(error);
            Vec::new()
        })
    }
}

/// Whether the line of a byte begins with `'`, as the lines of structured text in an L5K do.
fn begins_with_quote(bytes: &[u8], at: usize) -> bool {
    let line = memchr::memrchr(b'\n', &bytes[..at]).map_or(0, |newline| newline + 1);
    let first = bytes[line..at].iter().find(|byte| !byte.is_ascii_whitespace());
    first == Some(&b'\'')
}
