//! The tokens of `.rll` and L5K outside rungs. Lexical errors are tokens too, so that one of them
//! spoils one declaration and nothing else.

use logos::Logos;

/// A token; its text is the file's bytes at its place.
#[derive(Logos, Clone, Copy, PartialEq, Eq, Debug)]
#[logos(skip r"[ \t\r\n\f\u{feff}]+", extras = Absent)]
pub(crate) enum Token {
    #[regex(r"[A-Za-z_][A-Za-z0-9_]*")]
    #[token("$NoName")]
    Word,
    /// Anything that begins with a digit: `-` and the colon aside, numbers of every form, IP
    /// addresses, the end of a type such as `AB:1756_DI:I:0`.
    #[regex(r"[0-9][0-9A-Za-z_.#$]*")]
    #[regex(r"[0-9][0-9_.]*[eE][+-][0-9]+")]
    Number,
    /// `"..."`, with `$` escapes, on one line.
    #[regex(r#""([^"$\n]|\$[^\n])*""#)]
    Quoted,
    /// `'...'`, on one line.
    #[regex(r"'([^'$\n]|\$[^\n])*'")]
    Literal,
    /// `[[[___ ... ___]]]`: XML in an L5K, not looked into.
    #[token("[[[___", raw_block)]
    RawBlock,
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
    #[token(":")]
    Colon,
    #[token(":=")]
    Assign,
    #[token(".")]
    Dot,
    #[token("\\")]
    Backslash,
    #[token("OF", ignore(case))]
    Of,
    #[regex(r"[-+*/=<>%#@~?!&|^{}$]")]
    Symbol,
    #[regex(r"//[^\n]*")]
    #[token("(*", block_comment)]
    #[regex(r"(REMARK|remark),[^\n]*")]
    Comment,
    /// `"` without its other half.
    #[regex(r#""([^"$\n]|\$[^\n])*"#)]
    UnclosedQuoted,
    /// `'` without its other half.
    #[regex(r"'([^'$\n]|\$[^\n])*")]
    UnclosedLiteral,
    /// `(*` without its other half.
    UnclosedComment,
    /// A character that no token begins with.
    Unknown,
}

/// What was looked for and is nowhere in the rest of the file, so that nobody looks for it twice.
#[derive(Clone, Copy, Default, Debug)]
pub(crate) struct Absent {
    pub comment_end: bool,
    raw_block_end: bool,
}

fn block_comment(lexer: &mut logos::Lexer<'_, Token>) -> bool {
    let found = if lexer.extras.comment_end { None } else { find(lexer.remainder(), "*)") };
    lexer.extras.comment_end |= found.is_none();
    lexer.bump(found.unwrap_or(0));
    found.is_some()
}

fn raw_block(lexer: &mut logos::Lexer<'_, Token>) -> bool {
    let found = if lexer.extras.raw_block_end { None } else { find(lexer.remainder(), "___]]]") };
    lexer.extras.raw_block_end |= found.is_none();
    lexer.bump(found.unwrap_or(0));
    found.is_some()
}

/// Where a text ends in another.
fn find(text: &str, wanted: &str) -> Option<usize> {
    memchr::memmem::find(text.as_bytes(), wanted.as_bytes()).map(|at| at + wanted.len())
}

impl Token {
    /// Whether the lexer could not make sense of the text.
    pub(crate) fn is_error(self) -> bool {
        matches!(self, Token::UnclosedQuoted | Token::UnclosedLiteral | Token::UnclosedComment | Token::Unknown)
    }
}
