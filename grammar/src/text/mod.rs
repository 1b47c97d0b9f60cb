//! `.rll` and L5K: one grammar.
//!
//! A file is read block by block. The driver here knows which block ends where; what stands inside
//! one statement is the business of the LALRPOP grammars. So an error is confined to its statement,
//! or to its rung, and a file reports all of its errors.

mod add_ons;
pub(crate) mod build;
mod cursor;
mod islands;
mod modules;
mod programs;
pub(crate) mod rung_token;
mod rungs;
mod tags;
pub(crate) mod token;
mod types;

use lalrpop_util::{ParseError, lalrpop_mod};

pub(crate) use rungs::{parse_rung, rung_kind};

use crate::budget::BYTES_FOR_EACH;
use crate::components;
use crate::errors::Errors;
use crate::excerpt::Excerpt;
use crate::fields::Fields;
use crate::reading::number::clip;
use crate::tree::{ErrorKind, File, FileForm, Name, ReadError, SourceId, Span, Trivia, Value};
use build::Head;
use cursor::{Cursor, Ended, Placed, is_block_word};
use token::Token;

lalrpop_mod!(
    #[allow(clippy::all, unused_qualifications, missing_docs)]
    declaration,
    "/text/declaration.rs"
);
lalrpop_mod!(
    #[allow(clippy::all, unused_qualifications, missing_docs)]
    rung,
    "/text/rung.rs"
);

/// Reads a whole `.rll` or L5K.
pub(crate) fn read_text(source: SourceId, text: &str) -> (File, Errors) {
    let mut reader = Reader {
        cursor: Cursor::new(Excerpt { text, source, start: 0, map: None }),
        file: File { sources: vec![source], form: FileForm::Text, ..File::default() },
        open: Vec::new(),
        absent_ends: Vec::new(),
    };
    reader.whole();
    (reader.file, reader.cursor.errors)
}

/// Reads the text of a value: `0`, `[1,[2,3],'text']`.
pub(crate) fn read_value(excerpt: Excerpt<'_>) -> Result<Value, ReadError> {
    let mut cursor = Cursor::new(excerpt);
    cursor.take_statement();
    let run = cursor.checked_run()?;
    declaration::ValueParser::new()
        .parse(excerpt, run.iter().copied())
        .map_err(|error| refusal(excerpt, error, ErrorKind::MalformedData, "a value"))
}

/// The state of reading a file.
struct Reader<'a> {
    cursor: Cursor<'a>,
    file: File,
    /// The blocks that are open, by the word that ends them.
    open: Vec<&'static str>,
    /// Ends of islands that are nowhere in the rest of the file.
    absent_ends: Vec<&'static str>,
}

/// What a block takes in the tree, at most: a module has many fields.
const HEAD_BYTES: usize = 1_000;

/// What a block goes on with.
enum Next<'a> {
    /// A word, not yet taken.
    Word(&'a str),
    /// The block's own end was taken, or its end is missing.
    End,
}

impl<'a> Reader<'a> {
    fn whole(&mut self) {
        while let Some(token) = self.cursor.peek() {
            match self.cursor.peek_word() {
                Some("IE_VER") => self.version(),
                Some("CONTROLLER") => self.controller(),
                Some(word) if word.starts_with("END_") => self.stray(token),
                Some(word) => self.component(word, token),
                None if token.1 == Token::Semicolon => {
                    self.cursor.next();
                }
                None => self.unexpected(token, "a declaration"),
            }
        }
        self.cursor.closing(&mut self.file.trivia);
    }

    /// `IE_VER := 2.11;`
    fn version(&mut self) {
        let mut trivia = self.cursor.leading();
        self.cursor.next();
        let offset = self.cursor.token_end();
        self.cursor.take_statement();
        let span = self.cursor.run_span();
        let text = self.cursor.file.slice(offset, self.cursor.token_end());
        let text = text.trim().trim_start_matches(":=").trim_end_matches(';').trim();
        self.file.ie_version = Some(crate::tree::Text::new(text, span));
        self.cursor.trailing(&mut trivia);
        self.file.trivia = trivia;
    }

    fn controller(&mut self) {
        let (head, span, mut trivia) = self.head("END_CONTROLLER");
        let controller = components::controller(head.name, Fields::new(head.attributes, &mut self.cursor.errors), span);
        if let Some(first) = &self.file.controller {
            let message = format!("a second controller: `{}` is already declared", first.name);
            self.cursor.errors.add(ErrorKind::TwoControllers, span, message);
        }
        while let Next::Word(word) = self.next_in_block(span) {
            if let Some(token) = self.cursor.peek() {
                self.component(word, token);
            }
        }
        self.close(&mut trivia);
        if self.file.controller.is_none() {
            self.file.controller = Some(Box::new(crate::tree::Controller { trivia, ..controller }));
        }
    }

    /// A component of a controller; a file may also begin at one.
    fn component(&mut self, word: &str, token: Placed) {
        match word {
            "DATATYPE" => self.data_type(),
            "MODULE" => self.module(),
            "ADD_ON_INSTRUCTION_DEFINITION" => self.add_on_instruction(),
            "TAG" => {
                let tags = self.tags("END_TAG");
                self.file.tags.extend(tags);
            }
            "PROGRAM" => self.program(),
            "TASK" => self.task(),
            "ROUTINE" | "ST_ROUTINE" | "FBD_ROUTINE" | "SFC_ROUTINE" => {
                let routine = self.routine(word);
                self.file.routines.extend(routine);
            }
            "ENCODED_DATA" => {
                let encoded = self.encoded();
                self.file.encoded.push(encoded);
            }
            _ => match self.island(word) {
                Some(island) => self.file.islands.push(island),
                None => self.unknown_declaration(word, token),
            },
        }
    }

    /// Takes the word that begins a block and its head. The block is open until [`Self::end_block`].
    fn head(&mut self, end: &'static str) -> (Head, Span, Trivia) {
        let mut trivia = self.cursor.leading();
        let keyword = self.cursor.next();
        let begin = keyword.map_or(0, |(start, ..)| start);
        let what = keyword.map_or("", |token| self.cursor.slice(token));
        let (_, ended) = self.cursor.take_head();
        let span = self.cursor.file.locate(begin, self.cursor.token_end());
        if ended == Ended::Early {
            self.cursor.errors.add(ErrorKind::MalformedDeclaration, span, "the attribute list is not closed by `)`");
        }
        self.cursor.spend(HEAD_BYTES + span.len() as usize * BYTES_FOR_EACH, span);
        let file = self.cursor.file;
        let parsed = self.cursor.checked_run().and_then(|run| match run {
            [] => Err(ReadError::new(ErrorKind::MalformedDeclaration, span, format!("`{what}` has no name"))),
            run => declaration::HeadParser::new()
                .parse(file, run.iter().copied())
                .map_err(|error| refusal(file, error, ErrorKind::MalformedDeclaration, "a name and attributes")),
        });
        let head = match parsed {
            Ok(head) => head,
            Err(error) => {
                if ended == Ended::Well {
                    self.cursor.errors.push(error);
                }
                Head { name: self.name_of_run(), attributes: Vec::new() }
            }
        };
        self.cursor.take(Token::Semicolon);
        self.cursor.trailing(&mut trivia);
        self.open.push(end);
        (head, span, trivia)
    }

    /// The name that a broken head begins with.
    fn name_of_run(&self) -> Name {
        match self.cursor.run_first() {
            Some(token @ (_, Token::Word, _)) => Name::new(self.cursor.slice(token), self.cursor.span(token)),
            _ => Name::default(),
        }
    }

    fn end_block(&mut self) {
        self.open.pop();
    }

    /// Looks at what comes next in the block opened last; reports and passes over what cannot stand
    /// in any block. `head` is the block's head, for the error about a missing end.
    fn next_in_block(&mut self, head: Span) -> Next<'a> {
        let end = self.open.last().copied().unwrap_or("");
        loop {
            let Some(token) = self.cursor.peek() else {
                self.unclosed(head, end);
                return Next::End;
            };
            match self.cursor.peek_word() {
                Some(word) if word == end => return Next::End,
                Some(word) if word.starts_with("END_") => {
                    if self.open.contains(&word) {
                        self.unclosed(head, end);
                        return Next::End;
                    }
                    self.stray(token);
                }
                Some(word)
                    if is_block_word(word) && !may_hold(end, word) && is_followed_by_word(self.cursor.file, token) =>
                {
                    self.unclosed(head, end);
                    return Next::End;
                }
                Some(word) => return Next::Word(word),
                None if token.1 == Token::Semicolon => {
                    self.cursor.next();
                }
                None => self.unexpected(token, &format!("a declaration or `{end}`")),
            }
        }
    }

    /// Takes the end of the block opened last when it stands there, its comments before it.
    fn close(&mut self, trivia: &mut Trivia) -> Span {
        self.cursor.closing(trivia);
        let end = self.open.pop().unwrap_or("");
        if self.cursor.peek_word() == Some(end) {
            self.cursor.next();
        }
        self.cursor.file.locate(self.cursor.token_end(), self.cursor.token_end())
    }

    fn unclosed(&mut self, head: Span, end: &str) {
        let error = ReadError::new(ErrorKind::UnclosedBlock, head, format!("this block has no `{end}`"));
        self.cursor.errors.push(error.with_help(format!("write `{end}` after its last declaration")));
    }

    fn stray(&mut self, token: Placed) {
        let word = self.cursor.slice(token);
        let message = format!("`{}` ends no block that is open here", clip(word));
        self.cursor.errors.add(ErrorKind::StrayEnd, self.cursor.span(token), message);
        self.cursor.next();
    }

    /// Reports a token that cannot stand where it does, and goes on at the next word.
    fn unexpected(&mut self, token: Placed, expected: &str) {
        let error = if token.1.is_error() {
            self.cursor.lexical_error(token)
        } else {
            let message = format!("expected {expected}, found `{}`", clip(self.cursor.slice(token)));
            ReadError::new(ErrorKind::UnknownDeclaration, self.cursor.span(token), message)
        };
        self.cursor.errors.push(error);
        self.cursor.next();
        while let Some((_, next, _)) = self.cursor.peek() {
            if matches!(next, Token::Word | Token::Semicolon) {
                break;
            }
            self.cursor.next();
        }
    }

    fn unknown_declaration(&mut self, word: &str, token: Placed) {
        let message = format!("no declaration begins with `{}`", clip(word));
        let mut error = ReadError::new(ErrorKind::UnknownDeclaration, self.cursor.span(token), message);
        if is_block_word(&word.to_ascii_uppercase()) {
            error = error.with_help(format!("write it in capitals: `{}`", word.to_ascii_uppercase()));
        }
        self.cursor.errors.push(error);
        self.cursor.next();
        // What follows is of unknown shape: go on at the next word that begins or ends a block.
        while let Some(token) = self.cursor.peek() {
            let word = self.cursor.peek_word().unwrap_or("");
            if word.starts_with("END_") || is_block_word(word) {
                let unknown_end = word.starts_with("END_") && !self.open.contains(&word);
                if unknown_end {
                    self.cursor.next();
                }
                break;
            }
            if token.1 == Token::Semicolon {
                self.cursor.next();
                break;
            }
            self.cursor.next();
        }
    }

    /// Takes a statement and parses it; an error is reported and the statement passed over.
    fn statement<T>(
        &mut self,
        expected: &str,
        parse: impl Fn(Excerpt<'a>, &[Placed]) -> Result<T, ParseError<usize, Token, ReadError>>,
    ) -> Option<(T, Span)> {
        let (run, ended) = self.cursor.take_statement();
        if run.is_empty() {
            if ended == Ended::Early
                && let Some(token) = self.cursor.next()
            {
                // A word that begins a block stands where a statement should: it is not ours.
                self.unexpected_taken(token, expected);
            }
            return None;
        }
        let span = self.cursor.run_span();
        self.cursor.spend(span.len() as usize * BYTES_FOR_EACH, span);
        let file = self.cursor.file;
        let parsed = self.cursor.checked_run().and_then(|run| {
            parse(file, run).map_err(|error| refusal(file, error, ErrorKind::MalformedDeclaration, expected))
        });
        match parsed {
            Ok(value) => {
                if ended == Ended::Early && self.cursor.run_last() != Some(Token::RawBlock) {
                    let end = Span { start: span.end, ..span };
                    self.cursor.errors.add(ErrorKind::MalformedDeclaration, end, "a `;` is missing here");
                }
                Some((value, span))
            }
            Err(error) => {
                self.cursor.errors.push(error);
                None
            }
        }
    }

    fn unexpected_taken(&mut self, token: Placed, expected: &str) {
        let message = format!("expected {expected}, found `{}`", clip(self.cursor.slice(token)));
        self.cursor.errors.add(ErrorKind::UnknownDeclaration, self.cursor.span(token), message);
    }
}

/// Which blocks stand in which, by the word that ends the outer one. Any other block that begins in it
/// shows that its end is missing.
fn may_hold(end: &str, word: &str) -> bool {
    match end {
        "END_CONTROLLER" => word != "CONTROLLER",
        "END_PROGRAM" => {
            matches!(
                word,
                "TAG" | "ROUTINE" | "ST_ROUTINE" | "FBD_ROUTINE" | "SFC_ROUTINE" | "ENCODED_DATA" | "CHILD_PROGRAMS"
            )
        }
        "END_ADD_ON_INSTRUCTION_DEFINITION" => {
            matches!(
                word,
                "PARAMETERS" | "LOCAL_TAGS" | "ROUTINE" | "ST_ROUTINE" | "FBD_ROUTINE" | "SFC_ROUTINE" | "ENCODED_DATA"
            )
        }
        "END_MODULE" => word == "CONNECTION",
        _ => false,
    }
}

/// Whether a word is followed by another one, as the word that begins a block is.
fn is_followed_by_word(file: Excerpt<'_>, token: Placed) -> bool {
    let rest = file.slice(token.2, file.text.len()).trim_start_matches([' ', '\t', '\r', '\n']);
    rest.starts_with(|character: char| character.is_ascii_alphabetic() || character == '_')
}

/// What a parser of statements could not go on with.
fn refusal(
    file: Excerpt<'_>,
    error: ParseError<usize, Token, ReadError>,
    kind: ErrorKind,
    expected: &str,
) -> ReadError {
    match error {
        ParseError::User { error } => error,
        ParseError::UnrecognizedToken { token: (start, _, end), .. }
        | ParseError::ExtraToken { token: (start, _, end) } => {
            let message = format!("`{}` does not belong here; expected {expected}", clip(file.slice(start, end)));
            ReadError::new(kind, file.locate(start, end), message)
        }
        ParseError::UnrecognizedEof { location, .. } | ParseError::InvalidToken { location } => {
            ReadError::new(kind, file.locate(location, location), format!("breaks off; expected {expected}"))
        }
    }
}
