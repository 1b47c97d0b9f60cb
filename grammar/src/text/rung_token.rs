//! The tokens of a rung. An instruction with its operands is one token: inside its parentheses the
//! text is split at commas and otherwise left alone, because only the instruction knows what it means.

use std::ops::Range;

use logos::{Lexer, Logos};

use crate::excerpt::Excerpt;
use crate::limits::{BRANCH_DEPTH_MAX, OPERAND_BYTES_MAX, OPERANDS_MAX};
use crate::reading::number::clip;
use crate::tree::{CompactString, ErrorKind, Instruction, Name, Operand, OriginMap, ReadError, Span};

/// What the text of a rung is made of.
#[derive(Logos, Clone, Copy, PartialEq, Eq, Debug)]
#[logos(skip r"[ \t\r\n\f]+")]
enum Atom {
    /// Names, numbers, tag references without subscripts, operators.
    #[regex(r"[A-Za-z0-9_.:\\#$+=<>&|^!%@{}~?-]+")]
    Run,
    #[token("*")]
    #[token("/")]
    Operator,
    #[token("(")]
    Open,
    #[token(")")]
    Close,
    #[token("[")]
    OpenBracket,
    #[token("]")]
    CloseBracket,
    #[token(",")]
    Comma,
    #[token(";")]
    Semicolon,
    #[regex(r"'([^'$\n]|\$[^\n])*'")]
    #[regex(r#""([^"$\n]|\$[^\n])*""#)]
    Quoted,
    #[regex(r"//[^\n]*")]
    #[regex(r"\(\*([^*]|\*+[^*)])*\*+\)")]
    Comment,
    #[regex(r"'([^'$\n]|\$[^\n])*")]
    #[regex(r#""([^"$\n]|\$[^\n])*"#)]
    UnclosedQuote,
    #[regex(r"\(\*([^*]|\*+[^*)])*\**")]
    UnclosedComment,
}

/// What the grammar of rungs sees.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) enum RungToken {
    Instruction(Instruction),
    Open,
    Close,
    Comma,
    Semicolon,
}

/// Without memory to grow in.
pub(crate) fn exact<T>(mut list: Vec<T>) -> Vec<T> {
    list.shrink_to_fit();
    list
}

/// Tokens of one rung; comments go to a list of their own.
pub(crate) struct RungLexer<'a, 'c> {
    rung: Excerpt<'a>,
    lexer: Lexer<'a, Atom>,
    comments: &'c mut Vec<CompactString>,
    depth: usize,
    failed: bool,
}

impl<'a, 'c> RungLexer<'a, 'c> {
    pub(crate) fn new(rung: Excerpt<'a>, comments: &'c mut Vec<CompactString>) -> RungLexer<'a, 'c> {
        RungLexer { rung, lexer: Atom::lexer(rung.text), comments, depth: 0, failed: false }
    }

    fn error(&mut self, kind: ErrorKind, start: usize, end: usize, message: impl Into<String>) -> ReadError {
        self.failed = true;
        ReadError::new(kind, self.rung.locate(start, end), message)
    }

    /// The next atom that is no comment.
    fn atom(&mut self) -> Option<Result<Atom, ()>> {
        loop {
            let atom = self.lexer.next()?;
            if atom == Ok(Atom::Comment) {
                self.comments.push(self.lexer.slice().trim_end().into());
                continue;
            }
            return Some(atom);
        }
    }

    fn lexical_error(&mut self, atom: Result<Atom, ()>) -> ReadError {
        let range = self.lexer.span();
        let text = clip(self.lexer.slice());
        let (kind, message) = match atom {
            Ok(Atom::UnclosedQuote) => {
                (ErrorKind::UnclosedQuote, "a quoted text is not closed on its line".to_string())
            }
            Ok(Atom::UnclosedComment) => (ErrorKind::UnclosedComment, "the comment is not closed by `*)`".to_string()),
            _ => (ErrorKind::UnknownCharacter, format!("`{text}` means nothing in a rung")),
        };
        self.error(kind, range.start, range.end, message)
    }

    /// A mnemonic was read: its operands up to the closing parenthesis.
    fn instruction(&mut self) -> Result<(usize, RungToken, usize), ReadError> {
        let range = self.lexer.span();
        let (start, mnemonic) = (range.start, self.lexer.slice());
        let first = mnemonic.as_bytes().first().copied().unwrap_or(b'?');
        let word = (first.is_ascii_alphabetic() || first == b'_')
            && mnemonic.bytes().all(|byte| byte.is_ascii_alphanumeric() || byte == b'_');
        if !word {
            let message = format!("expected an instruction, found `{}`", clip(mnemonic));
            return Err(self.error(ErrorKind::MalformedRung, start, range.end, message));
        }
        let name = Name::new(mnemonic, self.rung.locate(start, range.end));
        match self.atom() {
            Some(Ok(Atom::Open)) => {}
            Some(Err(()) | Ok(Atom::UnclosedQuote | Atom::UnclosedComment)) => {
                let atom = Err(());
                return Err(self.lexical_error(atom));
            }
            _ => {
                let message = format!("`{}` has no operands: expected `(` after it", clip(mnemonic));
                let error = self.error(ErrorKind::MalformedRung, start, range.end, message);
                return Err(error.with_help(format!("write `{}()` when it takes none", clip(mnemonic))));
            }
        }
        let operands = self.operands(start, mnemonic)?;
        let end = self.lexer.span().end;
        let span = self.rung.locate(start, end);
        Ok((start, RungToken::Instruction(Instruction { mnemonic: name, operands, span }), end))
    }

    fn operands(&mut self, instruction: usize, mnemonic: &str) -> Result<Vec<Operand>, ReadError> {
        // Most instructions have one operand, and a project has very many of them.
        let mut operands = Vec::with_capacity(1);
        let mut gathered = Gathered::at(self.lexer.span().end);
        let mut nesting = 0u32;
        loop {
            let atom = self.lexer.next();
            let range = self.lexer.span();
            match atom {
                Some(Ok(Atom::Close)) if nesting == 0 => {
                    if !operands.is_empty() || gathered.first.is_some() {
                        operands.push(self.operand(&gathered, range.start)?);
                    }
                    return Ok(exact(operands));
                }
                Some(Ok(Atom::Comma)) if nesting == 0 => {
                    operands.push(self.operand(&gathered, range.start)?);
                    if operands.len() >= OPERANDS_MAX {
                        let message = format!("`{}` has more than {OPERANDS_MAX} operands", clip(mnemonic));
                        return Err(self.error(ErrorKind::TooMany, range.start, range.end, message));
                    }
                    gathered = Gathered::at(range.end);
                }
                Some(Ok(Atom::Comment)) => {
                    self.comments.push(self.lexer.slice().trim_end().into());
                }
                Some(Ok(Atom::Open | Atom::OpenBracket)) => {
                    nesting += 1;
                    gathered.add(range);
                }
                Some(Ok(Atom::Close | Atom::CloseBracket)) if nesting > 0 => {
                    nesting -= 1;
                    gathered.add(range);
                }
                Some(Ok(Atom::Run | Atom::Operator | Atom::Quoted | Atom::Comma)) => gathered.add(range),
                Some(atom @ (Err(()) | Ok(Atom::UnclosedQuote | Atom::UnclosedComment))) => {
                    return Err(self.lexical_error(atom));
                }
                Some(Ok(_)) | None => {
                    let end = instruction + mnemonic.len();
                    let message = format!("the parenthesis after `{}` is not closed", clip(mnemonic));
                    return Err(self.error(ErrorKind::MalformedRung, instruction, end, message));
                }
            }
        }
    }

    fn operand(&mut self, gathered: &Gathered, end: usize) -> Result<Operand, ReadError> {
        let Some(first) = &gathered.first else {
            // Nothing between the commas: the place between them.
            let span = self.rung.locate(gathered.start, end.max(gathered.start));
            let span = if span.is_empty() { span } else { Span { end: span.start, ..span } };
            return Ok(Operand { text: CompactString::default(), span, origin: None });
        };
        let (start, end) = (first.start, gathered.others.last().unwrap_or(first).end);
        if end - start > OPERAND_BYTES_MAX {
            let message = format!("an operand of {} bytes; at most {OPERAND_BYTES_MAX}", end - start);
            return Err(self.error(ErrorKind::TooMany, start, end, message));
        }
        let span = self.rung.locate(start, end);
        if gathered.others.is_empty() && self.rung.map.is_none() {
            return Ok(Operand { text: self.rung.text[start..end].into(), span, origin: None });
        }
        Ok(self.joined(gathered, span))
    }

    /// An operand in several pieces: one blank between any two.
    fn joined(&self, gathered: &Gathered, span: Span) -> Operand {
        let mut text = CompactString::default();
        let mut map = Vec::new();
        let mut plain = self.rung.map.is_none();
        for piece in gathered.pieces() {
            if !text.is_empty() {
                text.push(' ');
            }
            let place = self.rung.locate(piece.start, piece.end);
            plain &= place.start == span.start + text.len() as u32;
            map.push((text.len() as u32, place.start));
            if let Some(entities) = self.rung.map {
                // A resolved entity inside a piece shifts what follows it.
                for offset in 1..piece.len() {
                    let file = entities.locate(piece.start + offset);
                    if let Some(&(at, start)) = map.last()
                        && file != start + (text.len() as u32 + offset as u32 - at)
                    {
                        map.push((text.len() as u32 + offset as u32, file));
                    }
                }
            }
            text.push_str(&self.rung.text[piece.clone()]);
        }
        Operand { text, span, origin: (!plain).then(|| Box::new(OriginMap::new(map))) }
    }
}

/// The text of one operand: runs of bytes without a blank or comment between.
struct Gathered {
    start: usize,
    first: Option<Range<usize>>,
    others: Vec<Range<usize>>,
}

impl Gathered {
    fn at(start: usize) -> Gathered {
        Gathered { start, first: None, others: Vec::new() }
    }

    fn add(&mut self, range: Range<usize>) {
        match self.others.last_mut().or(self.first.as_mut()) {
            Some(last) if last.end == range.start => last.end = range.end,
            Some(_) => self.others.push(range),
            None => self.first = Some(range),
        }
    }

    fn pieces(&self) -> impl Iterator<Item = &Range<usize>> {
        self.first.iter().chain(&self.others)
    }
}

impl Iterator for RungLexer<'_, '_> {
    type Item = Result<(usize, RungToken, usize), ReadError>;

    fn next(&mut self) -> Option<Self::Item> {
        if self.failed {
            return None;
        }
        let atom = self.atom()?;
        let range = self.lexer.span();
        let token = match atom {
            Ok(Atom::Run) => return Some(self.instruction()),
            Ok(Atom::OpenBracket) => {
                self.depth += 1;
                if self.depth > BRANCH_DEPTH_MAX {
                    let message = format!("branches nested deeper than {BRANCH_DEPTH_MAX}");
                    return Some(Err(self.error(ErrorKind::TooDeep, range.start, range.end, message)));
                }
                RungToken::Open
            }
            Ok(Atom::CloseBracket) => {
                self.depth = self.depth.saturating_sub(1);
                RungToken::Close
            }
            Ok(Atom::Comma) => RungToken::Comma,
            Ok(Atom::Semicolon) => RungToken::Semicolon,
            Ok(Atom::Open | Atom::Close | Atom::Operator | Atom::Quoted) => {
                let message = format!("expected an instruction, a branch or `;`, found `{}`", clip(self.lexer.slice()));
                return Some(Err(self.error(ErrorKind::MalformedRung, range.start, range.end, message)));
            }
            other => return Some(Err(self.lexical_error(other))),
        };
        Some(Ok((range.start, token, range.end)))
    }
}
