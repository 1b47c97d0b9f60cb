//! The atoms of an operand.

use logos::Logos;

/// An atom. Names carry their colons (`Doors:I`, `Local:2:I`, `S:FS`): the colon belongs to the
/// base of a module tag.
#[derive(Logos, Clone, Copy, PartialEq, Eq, Debug)]
#[logos(skip r"([ \t\r\n\f]|//[^\n]*|\(\*([^*]|\*+[^*)])*\*+\))+")]
pub(crate) enum Token<'a> {
    #[regex(r"[A-Za-z_][A-Za-z0-9_]*(:[A-Za-z0-9_]+)*", |lexer| lexer.slice())]
    Name(&'a str),
    #[regex(r"[0-9][0-9_]*(\.[0-9_]*)?([eE][+-]?[0-9]+)?", |lexer| lexer.slice())]
    #[regex(r"[0-9]+#[0-9A-Za-z_]*", |lexer| lexer.slice())]
    #[regex(r"[0-9]+\.(#[A-Za-z]+|\$)", |lexer| lexer.slice())]
    Number(&'a str),
    #[regex(r"'([^'$]|\$[^\n])*'", |lexer| lexer.slice())]
    Quoted(&'a str),
    #[token("AND", ignore(case))]
    And,
    #[token("OR", ignore(case))]
    Or,
    #[token("XOR", ignore(case))]
    Xor,
    #[token("NOT", ignore(case))]
    Not,
    #[token("MOD", ignore(case))]
    Mod,
    #[token(".")]
    Dot,
    #[token(",")]
    Comma,
    #[token("\\")]
    Backslash,
    #[token("(")]
    Open,
    #[token(")")]
    Close,
    #[token("[")]
    OpenBracket,
    #[token("]")]
    CloseBracket,
    #[token("**")]
    Power,
    #[token("*")]
    Star,
    #[token("/")]
    Slash,
    #[token("+")]
    Plus,
    #[token("-")]
    Minus,
    #[token("<")]
    Less,
    #[token("<=")]
    LessOrEqual,
    #[token(">")]
    Greater,
    #[token(">=")]
    GreaterOrEqual,
    #[token("=")]
    Equal,
    #[token("<>")]
    NotEqual,
}

impl Token<'_> {
    /// Whether an operand of an expression may end here, so that a `-` after it is a subtraction.
    pub(crate) fn ends_operand(self) -> bool {
        matches!(self, Token::Name(_) | Token::Number(_) | Token::Quoted(_) | Token::Close | Token::CloseBracket)
    }

    /// Whether the result is 0 or 1.
    pub(crate) fn is_relation(self) -> bool {
        matches!(
            self,
            Token::Less | Token::LessOrEqual | Token::Greater | Token::GreaterOrEqual | Token::Equal | Token::NotEqual
        )
    }
}
