//! The tokens of a file in order, with comments gathered on the way, and the two ways of taking a
//! run of them: a head and a statement.

use logos::Logos;

use super::token::Token;
use crate::budget::Budget;
use crate::errors::Errors;
use crate::excerpt::Excerpt;
use crate::limits::VALUE_DEPTH_MAX;
use crate::reading::number::clip;
use crate::tree::{CompactString, ErrorKind, ReadError, Span, Trivia};

/// A token with its place.
pub(crate) type Placed = (usize, Token, usize);

/// A comment that waits for the declaration it belongs to.
struct Waiting {
    text: CompactString,
    /// Where it begins.
    start: usize,
    /// On the line on which the token before it ends.
    trails: bool,
}

/// A position in a file.
pub(crate) struct Cursor<'a> {
    pub(crate) file: Excerpt<'a>,
    pub(crate) errors: Errors,
    budget: Budget,
    /// The budget is spent: there are no more tokens.
    exhausted: bool,
    lexer: logos::Lexer<'a, Token>,
    /// Added to the lexer's offsets: it starts anew after each rung.
    lexer_start: usize,
    peeked: Option<Placed>,
    /// The end of the last token taken.
    token_end: usize,
    /// The end of the last token or comment.
    last_end: usize,
    /// Whether the last comment trailed, so that one after it on its line does too.
    trailing: bool,
    waiting: Vec<Waiting>,
    /// The run taken last; kept for its memory.
    run: Vec<Placed>,
}

/// How a run of tokens ended.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Ended {
    /// As it should.
    Well,
    /// Before a word that begins or ends a block, or at the end of the file.
    Early,
}

impl<'a> Cursor<'a> {
    pub(crate) fn new(file: Excerpt<'a>) -> Cursor<'a> {
        Cursor {
            file,
            errors: Errors::default(),
            budget: Budget::default(),
            exhausted: false,
            lexer: Token::lexer(file.text),
            lexer_start: 0,
            peeked: None,
            token_end: 0,
            last_end: 0,
            trailing: true,
            waiting: Vec::new(),
            run: Vec::new(),
        }
    }

    /// The token after the last one taken; comments before it are put aside.
    pub(crate) fn peek(&mut self) -> Option<Placed> {
        if self.peeked.is_none() {
            self.peeked = self.scan();
        }
        self.peeked
    }

    /// Takes a token.
    pub(crate) fn next(&mut self) -> Option<Placed> {
        let token = self.peek()?;
        self.peeked = None;
        self.last_end = token.2;
        self.token_end = token.2;
        self.trailing = true;
        Some(token)
    }

    fn scan(&mut self) -> Option<Placed> {
        if self.exhausted {
            return None;
        }
        loop {
            let token = self.lexer.next()?;
            let range = self.lexer.span();
            let (start, end) = (range.start + self.lexer_start, range.end + self.lexer_start);
            match token {
                Ok(Token::Comment) => self.comment(start, end),
                Ok(token) => return Some((start, token, end)),
                // What is unclosed ends with its line, so that it does not swallow the file.
                Err(()) if self.file.slice(start, end) == "(*" => {
                    let end = self.line_end(start);
                    self.restart(end);
                    return Some((start, Token::UnclosedComment, end));
                }
                Err(()) => return Some((start, Token::Unknown, end)),
            }
        }
    }

    /// The end of the line that holds a byte.
    pub(crate) fn line_end(&self, offset: usize) -> usize {
        let rest = self.file.text.get(offset..).unwrap_or("");
        offset + memchr::memchr(b'\n', rest.as_bytes()).unwrap_or(rest.len())
    }

    /// Counts what a piece of tree takes; when nothing is left, the file ends here.
    pub(crate) fn spend(&mut self, bytes: usize, place: Span) {
        if let Err(error) = self.budget.spend(bytes, place)
            && !self.exhausted
        {
            self.errors.push(error);
            self.exhausted = true;
            self.peeked = None;
        }
    }

    fn comment(&mut self, start: usize, end: usize) {
        let text = self.file.slice(start, end).trim_end();
        let trails = self.trailing && !self.file.slice(self.last_end, start).contains('\n') && self.last_end > 0;
        self.trailing = trails;
        self.waiting.push(Waiting { text: text.into(), start, trails });
        self.last_end = start + text.len();
    }

    /// Goes on at a byte of the file.
    pub(crate) fn restart(&mut self, offset: usize) {
        let rest = self.file.text.get(offset..).unwrap_or("");
        self.lexer = Token::lexer_with_extras(rest, self.lexer.extras);
        self.lexer_start = offset;
        self.peeked = None;
    }

    /// Goes on after a piece of the file that was read in another way, and that ended there.
    pub(crate) fn skip_to(&mut self, offset: usize) {
        self.restart(offset);
        self.last_end = offset;
        self.token_end = offset;
        self.trailing = true;
    }

    /// Keeps comments that were found in a piece read in another way; they go before what it declares.
    pub(crate) fn keep_comments(&mut self, comments: Vec<CompactString>) {
        self.waiting.extend(comments.into_iter().map(|text| Waiting { text, start: 0, trails: false }));
    }

    /// Where the last token ended.
    pub(crate) fn token_end(&self) -> usize {
        self.token_end
    }

    pub(crate) fn slice(&self, token: Placed) -> &'a str {
        self.file.slice(token.0, token.2)
    }

    pub(crate) fn span(&self, token: Placed) -> Span {
        self.file.locate(token.0, token.2)
    }

    /// The next token, when it is a word.
    pub(crate) fn peek_word(&mut self) -> Option<&'a str> {
        match self.peek() {
            Some(token @ (_, Token::Word | Token::Of, _)) => Some(self.slice(token)),
            _ => None,
        }
    }

    /// Takes the next token when it is this one.
    pub(crate) fn take(&mut self, token: Token) -> bool {
        let found = self.peek().is_some_and(|(_, next, _)| next == token);
        if found {
            self.next();
        }
        found
    }

    /// Drops comments that were met in a piece that is kept as it stands.
    pub(crate) fn forget_comments(&mut self) {
        self.waiting.clear();
        self.peeked = None;
    }

    /// Whether no comment ends in the rest of the file.
    pub(crate) fn comment_end_is_absent(&mut self) -> &mut bool {
        &mut self.lexer.extras.comment_end
    }

    /// Comments that stand before the next declaration.
    pub(crate) fn leading(&mut self) -> Trivia {
        self.peek();
        let mut trivia = Trivia::none();
        for comment in self.waiting.drain(..) {
            trivia.push_leading(comment.text);
        }
        trivia
    }

    /// Comments that were met inside a declaration go before it; those behind it on its last line
    /// stay behind it.
    pub(crate) fn trailing(&mut self, trivia: &mut Trivia) {
        self.peek();
        let inside = self.waiting.iter().take_while(|comment| comment.start < self.token_end).count();
        for comment in self.waiting.drain(..inside) {
            trivia.push_leading(comment.text);
        }
        let trails = self.waiting.iter().take_while(|comment| comment.trails).count();
        for comment in self.waiting.drain(..trails) {
            trivia.push_trailing(comment.text);
        }
    }

    /// Comments before the end of a block.
    pub(crate) fn closing(&mut self, trivia: &mut Trivia) {
        self.peek();
        for comment in self.waiting.drain(..) {
            trivia.push_closing(comment.text);
        }
    }

    /// Takes a name and, when there is one, the attribute list after it.
    pub(crate) fn take_head(&mut self) -> (&[Placed], Ended) {
        self.run.clear();
        while let Some(token @ (_, Token::Word | Token::Colon | Token::Of, _)) = self.peek() {
            // `ROUTINE Main N: ...`: the name is one word, or two with a colon between.
            let wants_word = self.run.len().is_multiple_of(2);
            if wants_word != (token.1 != Token::Colon) || self.run.len() >= 3 || self.ends_run(token) {
                break;
            }
            self.push();
        }
        let ended = self.take_list();
        (&self.run, ended)
    }

    /// Takes an attribute list when there is one.
    fn take_list(&mut self) -> Ended {
        if self.peek().is_none_or(|(_, token, _)| token != Token::Open) {
            return Ended::Well;
        }
        let mut depth = 0usize;
        while let Some(token) = self.peek() {
            match token.1 {
                Token::Open => depth += 1,
                Token::Close => depth -= 1,
                Token::Semicolon => return Ended::Early,
                _ if self.ends_run(token) => return Ended::Early,
                _ => {}
            }
            self.push();
            if depth == 0 {
                return Ended::Well;
            }
        }
        Ended::Early
    }

    /// Takes tokens up to a semicolon, which is taken but not part of the run.
    pub(crate) fn take_statement(&mut self) -> (&[Placed], Ended) {
        self.run.clear();
        while let Some(token) = self.peek() {
            if token.1 == Token::Semicolon {
                self.next();
                return (&self.run, Ended::Well);
            }
            if self.ends_run(token) {
                return (&self.run, Ended::Early);
            }
            self.push();
            // A block of XML in an L5K has no semicolon after it.
            if token.1 == Token::RawBlock {
                self.take(Token::Semicolon);
                return (&self.run, Ended::Well);
            }
        }
        (&self.run, Ended::Early)
    }

    fn push(&mut self) {
        if let Some(token) = self.next() {
            self.run.push(token);
        }
    }

    /// Whether a token cannot belong to the statement before it: a word that begins or ends a block
    /// and is the first of its line.
    fn ends_run(&self, token: Placed) -> bool {
        if token.1 != Token::Word {
            return false;
        }
        let word = self.slice(token);
        let begins_line = || self.file.slice(0, token.0).trim_end_matches([' ', '\t']).ends_with('\n');
        word.starts_with("END_") || (is_block_word(word) && begins_line())
    }

    /// The run taken last, checked for lexical errors and depth.
    pub(crate) fn checked_run(&self) -> Result<&[Placed], ReadError> {
        let mut depth = 0usize;
        for &token in &self.run {
            if token.1.is_error() {
                return Err(self.lexical_error(token));
            }
            match token.1 {
                Token::OpenBracket | Token::Open => depth += 1,
                Token::CloseBracket | Token::Close => depth = depth.saturating_sub(1),
                _ => {}
            }
            if depth > VALUE_DEPTH_MAX {
                let message = format!("nested deeper than {VALUE_DEPTH_MAX}");
                return Err(ReadError::new(ErrorKind::TooDeep, self.span(token), message));
            }
        }
        Ok(&self.run)
    }

    /// The place of the run taken last.
    pub(crate) fn run_span(&self) -> Span {
        match (self.run.first(), self.run.last()) {
            (Some(first), Some(last)) => self.file.locate(first.0, last.2),
            _ => self.file.locate(self.last_end, self.last_end),
        }
    }

    /// What is wrong with a token that is an error.
    pub(crate) fn lexical_error(&self, token: Placed) -> ReadError {
        let (kind, message) = match token.1 {
            Token::UnclosedQuoted => (ErrorKind::UnclosedQuote, "the `\"` is not closed on its line".to_string()),
            Token::UnclosedLiteral => (ErrorKind::UnclosedQuote, "the `'` is not closed on its line".to_string()),
            Token::UnclosedComment => (ErrorKind::UnclosedComment, "the comment is not closed by `*)`".to_string()),
            _ => (ErrorKind::UnknownCharacter, format!("`{}` means nothing here", clip(self.slice(token)))),
        };
        ReadError::new(kind, self.span(token), message)
    }
}

/// The words that begin a block.
pub(crate) fn is_block_word(word: &str) -> bool {
    matches!(
        word,
        "CONTROLLER"
            | "DATATYPE"
            | "MODULE"
            | "CONNECTION"
            | "ADD_ON_INSTRUCTION_DEFINITION"
            | "PARAMETERS"
            | "LOCAL_TAGS"
            | "TAG"
            | "PROGRAM"
            | "ROUTINE"
            | "ST_ROUTINE"
            | "FBD_ROUTINE"
            | "SFC_ROUTINE"
            | "TASK"
            | "TREND"
            | "QUICK_WATCH"
            | "PARAMETER_CONNECTION"
            | "CONFIG"
            | "ENCODED_DATA"
            | "CHILD_PROGRAMS"
    )
}

impl Cursor<'_> {
    /// The first token of the run taken last.
    pub(crate) fn run_first(&self) -> Option<Placed> {
        self.run.first().copied()
    }

    /// The kind of the last token of the run taken last.
    pub(crate) fn run_last(&self) -> Option<Token> {
        self.run.last().map(|&(_, token, _)| token)
    }
}
