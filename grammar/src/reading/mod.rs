//! What an operand can be read as. The instruction's declaration says which reading to ask for.

pub(crate) mod build;
pub(crate) mod escape;
pub(crate) mod number;
pub(crate) mod token;

mod precedence;

use lalrpop_util::{ParseError, lalrpop_mod};
use logos::Logos;

use crate::limits::OPERAND_BYTES_MAX;
use crate::tree::{
    CompactString, ErrorKind, Expression, Immediate, Name, Operand, Part, ReadError, TagReference, Text, Words,
};
use number::{clip, parse_number};
use token::Token;

lalrpop_mod!(
    #[allow(clippy::all, unused_qualifications, missing_docs)]
    operand,
    "/reading/operand.rs"
);

/// Reads an operand as a tag reference.
///
/// # Errors
/// When it is anything else: an immediate value, an expression, `?`, nothing.
pub fn read_tag(operand: &Operand) -> Result<TagReference, ReadError> {
    if let Some(tag) = plain_tag(operand) {
        return Ok(tag);
    }
    let kind = ErrorKind::MalformedTagReference;
    let tokens = tokens(operand, kind)?;
    precedence::check(operand, &tokens)?;
    operand::TagParser::new()
        .parse(operand, tokens.iter().copied())
        .map_err(|error| refusal(operand, error, kind, "a tag"))
}

/// Reads an operand as an expression: an immediate value or a tag is one too.
///
/// # Errors
/// When it is no expression, is nested too deeply, or mixes a relation with operators that two
/// published tables of precedence rank differently ([`ErrorKind::AmbiguousRelation`]).
pub fn read_expression(operand: &Operand) -> Result<Expression, ReadError> {
    if let Some(tag) = plain_tag(operand) {
        return Ok(Expression::Tag(tag));
    }
    let kind = ErrorKind::MalformedExpression;
    let tokens = tokens(operand, kind)?;
    precedence::check(operand, &tokens)?;
    operand::OrParser::new()
        .parse(operand, tokens.iter().copied())
        .map_err(|error| refusal(operand, error, kind, "an expression"))
}

/// Reads an operand as an immediate value.
///
/// # Errors
/// When it is a tag, an expression, `?`, nothing, or a number that does not exist.
pub fn read_immediate(operand: &Operand) -> Result<Immediate, ReadError> {
    immediate(&operand.text, operand.locate(0, operand.text.len()))
}

/// Reads the text of a value as an immediate value.
///
/// # Errors
/// When it is no number of any form.
pub fn read_number(text: &Text) -> Result<Immediate, ReadError> {
    immediate(&text.text, text.span)
}

fn immediate(text: &CompactString, span: crate::tree::Span) -> Result<Immediate, ReadError> {
    match parse_number(text) {
        Ok(number) => Ok(Immediate { number, text: text.clone(), span }),
        Err(fault) => Err(ReadError::new(fault.kind(), span, fault.message(text))),
    }
}

/// Reads an operand as option words: `EQUIVALENT - ACTIVE HIGH`, also in quotes. A single number is
/// one too (`0`): try [`read_immediate`] first where integers are admitted.
///
/// # Errors
/// When it holds anything but letters, digits, blanks, hyphens, underscores and periods, or nothing.
pub fn read_words(operand: &Operand) -> Result<Words, ReadError> {
    let text = operand.text.trim();
    let quoted = text.strip_prefix('\'').and_then(|rest| rest.strip_suffix('\''));
    let quoted = quoted.or_else(|| text.strip_prefix('"').and_then(|rest| rest.strip_suffix('"')));
    let inner = quoted.unwrap_or(text);
    let admitted = |byte: u8| byte.is_ascii_alphanumeric() || matches!(byte, b' ' | b'\t' | b'-' | b'_' | b'.');
    let mut words = CompactString::default();
    for word in inner.split_ascii_whitespace() {
        if !words.is_empty() {
            words.push(' ');
        }
        words.push_str(word);
    }
    words.make_ascii_uppercase();
    let span = operand.locate(0, operand.text.len());
    if words.is_empty() {
        return Err(ReadError::new(ErrorKind::MalformedWords, span, "an option word is missing"));
    }
    if !words.bytes().all(admitted) {
        let message = format!("`{}` is no option word", clip(inner));
        return Err(ReadError::new(ErrorKind::MalformedWords, span, message));
    }
    Ok(Words { text: words, span })
}

/// The characters that a string of data (`'AB$00'`, quotes or not) stands for, as bytes.
///
/// # Errors
/// When a `$` escape does not exist.
pub fn unescape(text: &Text) -> Result<Vec<u8>, ReadError> {
    let inner = text.text.strip_prefix('\'').and_then(|rest| rest.strip_suffix('\'')).unwrap_or(&text.text);
    escape::unescape_bytes(inner).ok_or_else(|| {
        ReadError::new(
            ErrorKind::MalformedEscape,
            text.span,
            format!("'{}' has a `$` escape that does not exist", clip(inner)),
        )
    })
}

/// The common case, `Name.Member.5`, without tokens: most operands are one.
fn plain_tag(operand: &Operand) -> Option<TagReference> {
    let text = operand.text.as_str();
    let begins_name = |part: &str| part.as_bytes().first().is_some_and(|&b| b.is_ascii_alphabetic() || b == b'_');
    let mut offset = 0;
    let mut base = None;
    let mut parts = Vec::new();
    for part in text.split('.') {
        let span = operand.locate(offset, offset + part.len());
        let is_base = base.is_none();
        let word = |byte: u8| byte.is_ascii_alphanumeric() || byte == b'_' || (byte == b':' && is_base);
        if part.is_empty() || !part.bytes().all(word) {
            return None;
        }
        if is_base {
            let plain = begins_name(part) && !part.ends_with(':') && !part.contains("::");
            if !plain || is_keyword(part) {
                return None;
            }
            base = Some(Name::new(part, span));
        } else if begins_name(part) {
            parts.push(Part::Member(Name::new(part, span)));
        } else if part.bytes().all(|byte| byte.is_ascii_digit()) {
            parts.push(Part::Bit { number: part.parse().ok()?, span });
        } else {
            return None;
        }
        offset += part.len() + 1;
    }
    Some(TagReference { program: None, base: base?, parts, span: operand.locate(0, text.len()) })
}

fn is_keyword(text: &str) -> bool {
    ["AND", "OR", "XOR", "NOT", "MOD"].iter().any(|keyword| text.eq_ignore_ascii_case(keyword))
}

type Spanned<'a> = (usize, Token<'a>, usize);

fn tokens(operand: &Operand, kind: ErrorKind) -> Result<Vec<Spanned<'_>>, ReadError> {
    if operand.text.len() > OPERAND_BYTES_MAX {
        let message = format!("an operand of {} bytes; at most {OPERAND_BYTES_MAX}", operand.text.len());
        return Err(ReadError::new(ErrorKind::TooMany, operand.span, message));
    }
    let mut list = Vec::new();
    for (token, range) in Token::lexer(&operand.text).spanned() {
        match token {
            Ok(token) => list.push((range.start, token, range.end)),
            Err(()) => {
                let span = operand.locate(range.start, range.end);
                return Err(unknown_atom(&operand.text[range], span, kind));
            }
        }
    }
    Ok(list)
}

fn unknown_atom(text: &str, span: crate::tree::Span, kind: ErrorKind) -> ReadError {
    match text.chars().next() {
        Some('?') => ReadError::new(kind, span, "an operand is missing: `?` stands in its place")
            .with_help("enter a tag or a value where the `?` is"),
        Some('\'') => ReadError::new(ErrorKind::UnclosedQuote, span, "a quoted text is not closed"),
        Some('&' | '|' | '!' | '^') => {
            ReadError::new(kind, span, format!("the operator `{}` exists only in newer controllers", clip(text)))
                .with_help("write AND, OR, XOR or NOT")
        }
        _ => ReadError::new(ErrorKind::UnknownCharacter, span, format!("`{}` means nothing here", clip(text))),
    }
}

fn refusal(
    operand: &Operand,
    error: ParseError<usize, Token<'_>, ReadError>,
    kind: ErrorKind,
    wanted: &str,
) -> ReadError {
    match error {
        ParseError::User { error } => error,
        ParseError::UnrecognizedToken { token: (start, _, end), .. }
        | ParseError::ExtraToken { token: (start, _, end) } => {
            let found = clip(&operand.text[start..end]);
            let message = if start == 0 {
                format!("expected {wanted}, found `{found}`")
            } else {
                format!("`{found}` cannot follow here; expected {wanted}")
            };
            ReadError::new(kind, operand.locate(start, end), message)
        }
        ParseError::UnrecognizedEof { location, .. } | ParseError::InvalidToken { location } => {
            if operand.is_empty() {
                return ReadError::new(kind, operand.span, format!("expected {wanted}, found nothing"));
            }
            let message = format!("`{}` breaks off; expected {wanted}", clip(&operand.text));
            ReadError::new(kind, operand.locate(location, location), message)
        }
    }
}
