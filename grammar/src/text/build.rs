//! What the grammar of declarations does when it has recognised something.

use lalrpop_util::ParseError;
use logos::Logos;

use super::token::Token;
use crate::excerpt::Excerpt;
use crate::limits::SUBSCRIPTS_MAX;
use crate::reading::escape::unescape_text;
use crate::reading::number::clip;
use crate::tree::{
    Attribute, BitPlace, CompactString, Dimensions, ErrorKind, Name, Operand, OriginMap, ReadError, Spanned, Text,
    Value,
};

type Failure = ParseError<usize, Token, ReadError>;

fn failure(error: ReadError) -> Failure {
    ParseError::User { error }
}

/// The head of a block: its name and attributes.
#[derive(Debug, Default)]
pub(crate) struct Head {
    pub name: Name,
    pub attributes: Vec<Attribute>,
}

/// The declaration of one or several tags, or of a parameter.
#[derive(Debug)]
pub(crate) struct TagDeclaration {
    pub names: Vec<Name>,
    /// Nothing for an alias.
    pub data_type: Option<Name>,
    pub dimensions: Dimensions,
    /// The target of an alias.
    pub target: Option<Operand>,
    pub attributes: Vec<Attribute>,
    pub value: Option<Value>,
    pub forces: Option<Value>,
}

impl TagDeclaration {
    pub(super) fn alias(name: Name, target: Operand, attributes: Vec<Attribute>) -> TagDeclaration {
        TagDeclaration {
            names: vec![name],
            data_type: None,
            dimensions: Dimensions::default(),
            target: Some(target),
            attributes,
            value: None,
            forces: None,
        }
    }
}

/// A member: its name and type.
#[derive(Debug)]
pub(crate) struct TypedName {
    pub name: Name,
    pub data_type: Name,
    pub dimensions: Dimensions,
    pub bit: Option<BitPlace>,
}

/// A line in the body of a module or connection.
#[derive(Debug)]
pub(crate) struct Property {
    pub name: Name,
    pub value: Option<Value>,
}

pub(super) fn name(file: Excerpt<'_>, l: usize, r: usize) -> Name {
    Name::new(file.slice(l, r), file.locate(l, r))
}

/// A literal without its quotes; escapes stay.
pub(super) fn literal(file: Excerpt<'_>, l: usize, r: usize) -> Text {
    let inside = (l + 1).min(r)..r.saturating_sub(1).max(l);
    Text::new(file.slice(inside.start, inside.end), file.locate(inside.start, inside.end))
}

/// One or several quoted texts with blanks between: one text, escapes resolved, its span inside the
/// first and last quotes.
pub(super) fn quoted(file: Excerpt<'_>, l: usize, r: usize) -> Result<Text, Failure> {
    let mut text = String::new();
    let mut rest = file.slice(l, r);
    while let Some(at) = rest.find('"') {
        let inside = &rest[at + 1..];
        let length = closing_quote(inside);
        let Some(piece) = unescape_text(&inside[..length]) else {
            let message = format!("\"{}\" has a `$` escape that does not exist", clip(&inside[..length]));
            let error = ReadError::new(ErrorKind::MalformedEscape, file.locate(l, r), message)
                .with_help("write `$$` for a dollar sign");
            return Err(failure(error));
        };
        text.push_str(&piece);
        rest = inside.get(length + 1..).unwrap_or("");
    }
    Ok(Text::new(text, file.locate((l + 1).min(r), r.saturating_sub(1).max(l))))
}

fn closing_quote(inside: &str) -> usize {
    let bytes = inside.as_bytes();
    let mut at = 0;
    while let Some(&byte) = bytes.get(at) {
        match byte {
            b'"' => return at,
            b'$' => at += 2,
            _ => at += 1,
        }
    }
    inside.len()
}

pub(super) fn dimensions(
    file: Excerpt<'_>,
    sizes: Vec<(usize, usize)>,
    l: usize,
    r: usize,
) -> Result<Dimensions, Failure> {
    let mut list = Vec::new();
    for (start, end) in sizes {
        let text = file.slice(start, end);
        match text.parse::<u32>() {
            Ok(size) => list.push(size),
            Err(_) => {
                let message = format!("`{}` is no array size", clip(text));
                return Err(failure(ReadError::new(ErrorKind::MalformedDeclaration, file.locate(start, end), message)));
            }
        }
    }
    Dimensions::new(&list).ok_or_else(|| {
        let message = format!("an array has at most {SUBSCRIPTS_MAX} dimensions");
        failure(ReadError::new(ErrorKind::TooMany, file.locate(l, r), message))
    })
}

pub(super) fn tag(
    names: Vec<Name>,
    data_type: Name,
    dimensions: Option<Dimensions>,
    attributes: Option<Vec<Attribute>>,
    value: Option<Value>,
    forces: Option<(Name, Value)>,
) -> Result<TagDeclaration, Failure> {
    let forces = match forces {
        Some((key, forces)) if key.is("TagForceData") => Some(forces),
        Some((key, _)) => {
            let message = format!("expected `TagForceData` or `;`, found `{key}`");
            return Err(failure(ReadError::new(ErrorKind::MalformedDeclaration, key.span, message)));
        }
        None => None,
    };
    Ok(TagDeclaration {
        names,
        data_type: Some(data_type),
        dimensions: dimensions.unwrap_or_default(),
        target: None,
        attributes: attributes.unwrap_or_default(),
        value,
        forces,
    })
}

/// A run of tokens as text: blanks, line breaks and comments become one blank.
pub(super) fn run(file: Excerpt<'_>, l: usize, r: usize) -> Text {
    let operand = operand(file, l, r);
    Text { text: operand.text, span: operand.span }
}

/// A run of tokens as an operand: blanks, line breaks and comments become one blank.
pub(super) fn operand(file: Excerpt<'_>, l: usize, r: usize) -> Operand {
    let (raw, span) = (file.slice(l, r), file.locate(l, r));
    let layout = ["\n", "\t", "\r", "  ", "//", "(*"];
    if file.map.is_none() && !layout.iter().any(|piece| raw.contains(piece)) {
        return Operand { text: raw.into(), span, origin: None };
    }
    let mut text = CompactString::default();
    let mut map = Vec::new();
    let mut end = 0;
    for (token, range) in Token::lexer(raw).spanned() {
        if token == Ok(Token::Comment) {
            continue;
        }
        if !text.is_empty() && range.start > end {
            text.push(' ');
        }
        map.push((text.len() as u32, file.locate(l + range.start, l + range.end).start));
        end = range.end;
        text.push_str(&raw[range]);
    }
    Operand { text, span, origin: Some(Box::new(OriginMap::new(map))) }
}

pub(super) fn member(
    file: Excerpt<'_>,
    words: Vec<(Token, usize, usize)>,
    dimensions: Option<Dimensions>,
) -> Result<TypedName, Failure> {
    let dimensions = dimensions.unwrap_or_default();
    let named = |&(_, l, r): &(Token, usize, usize)| name(file, l, r);
    let joined = |list: &[(Token, usize, usize)]| match (list.first(), list.last()) {
        (Some(first), Some(last)) => name(file, first.1, last.2),
        _ => Name::default(),
    };
    match words.as_slice() {
        [bit, member, target, (Token::Colon, ..), number @ (Token::Number, ..)] if named(bit).is("BIT") => {
            let text = file.slice(number.1, number.2);
            let span = file.locate(number.1, number.2);
            let Ok(value) = text.parse::<u32>() else {
                let message = format!("`{}` is no bit number", clip(text));
                return Err(failure(ReadError::new(ErrorKind::MalformedDeclaration, span, message)));
            };
            let place = BitPlace { target: named(target), number: Spanned::new(value, span) };
            Ok(TypedName { name: named(member), data_type: named(bit), dimensions, bit: Some(place) })
        }
        [member @ (Token::Word, ..), (Token::Colon, ..), data_type @ ..]
            if is_type_name(data_type) && !ends_in_two_words(&words) =>
        {
            Ok(TypedName { name: named(member), data_type: joined(data_type), dimensions, bit: None })
        }
        [data_type @ .., member @ (Token::Word, ..)] if is_type_name(data_type) && ends_in_two_words(&words) => {
            Ok(TypedName { name: named(member), data_type: joined(data_type), dimensions, bit: None })
        }
        other => {
            let all = joined(other);
            let error = ReadError::new(
                ErrorKind::MalformedDeclaration,
                all.span,
                format!("`{}` declares no member", clip(&all.text)),
            );
            Err(failure(error.with_help("write `TYPE Name;`, `TYPE Name[4];` or `BIT Name Host : 0;`")))
        }
    }
}

/// A word, or words and numbers with colons between.
fn is_type_name(words: &[(Token, usize, usize)]) -> bool {
    let colon = |word: &(Token, usize, usize)| word.0 == Token::Colon;
    words.len() % 2 == 1 && words.iter().enumerate().all(|(index, word)| colon(word) == (index % 2 == 1))
}

/// `AB:1756_DI:I:0 Name` and `DINT Name`, as against `Name : DINT`.
fn ends_in_two_words(words: &[(Token, usize, usize)]) -> bool {
    matches!(words, [.., (Token::Word | Token::Number, ..), (Token::Word, ..)])
}
