//! The tokens of a scenario file. Lexical errors are tokens too, so that one of them spoils one line and nothing else.

use logos::Logos;

/// A token; its text is the file's bytes at its place. Words of the format are written in small letters; a tag of the same
/// name is written with a capital (names are compared without regard to case).
#[derive(Logos, Clone, Copy, PartialEq, Eq, Debug)]
#[logos(skip r"[ \t\r\n\f\u{feff}]+")]
#[logos(skip r"//[^\n]*")]
pub(crate) enum Token {
    #[token("project")]
    Project,
    #[token("minimum")]
    Minimum,
    #[token("coverage")]
    Coverage,
    #[token("exclude")]
    Exclude,
    #[token("because")]
    Because,
    #[token("setup")]
    Setup,
    #[token("scenario")]
    Scenario,
    #[token("end")]
    End,
    #[token("with")]
    With,
    #[token("power")]
    Power,
    #[token("up")]
    Up,
    #[token("in")]
    In,
    #[token("run")]
    Run,
    #[token("program")]
    Program,
    #[token("mode")]
    Mode,
    #[token("given")]
    Given,
    #[token("at")]
    At,
    #[token("after")]
    After,
    #[token("when")]
    When,
    #[token("hold")]
    Hold,
    #[token("for")]
    For,
    #[token("toggle")]
    Toggle,
    #[token("every")]
    Every,
    #[token("then")]
    Then,
    #[token("is")]
    Is,
    #[token("stays")]
    Stays,
    #[token("not")]
    Not,
    #[token("before")]
    Before,
    #[token("within")]
    Within,
    #[token("fault")]
    Fault,
    #[token("never")]
    Never,
    #[token("and")]
    And,
    #[token("on")]
    On,
    #[token("off")]
    Off,
    #[token("ms")]
    Milliseconds,
    #[token("s")]
    Seconds,
    #[token("min")]
    Minutes,
    #[token("scan")]
    #[token("scans")]
    Scans,
    #[token("terminal")]
    Terminal,
    #[token("shorted")]
    Shorted,
    #[token("to")]
    To,
    #[token("open")]
    Open,
    #[token("follows")]
    Follows,
    #[token("fails")]
    Fails,
    #[token("repaired")]
    Repaired,
    #[token("lost")]
    Lost,
    #[token("restored")]
    Restored,
    #[token("idle")]
    Idle,
    #[token("running")]
    Running,
    /// A tag, a member, an element, a bit, a published value, a value of the controller.
    #[regex(r"[A-Za-z_][A-Za-z0-9_]*(:[A-Za-z0-9_]+)*(\.[A-Za-z0-9_]+|\[[0-9]+(,[ ]*[0-9]+)*\])*", priority = 1)]
    Name,
    /// A number of any base.
    #[regex(r"-?[0-9][0-9_]*(\.[0-9]+)?([eE][+-]?[0-9]+)?")]
    #[regex(r"(2|8|16)#[0-9A-Fa-f_]+")]
    Number,
    /// `"..."` on one line; nothing in it is an escape.
    #[regex(r#""[^"\n]*""#)]
    Quoted,
    #[token(",")]
    Comma,
    #[token("%")]
    Percent,
    #[token("/")]
    Slash,
    #[token("<")]
    Below,
    #[token("<=")]
    AtMost,
    #[token(">")]
    Above,
    #[token(">=")]
    AtLeast,
    #[token("+-")]
    #[token("±")]
    Tolerance,
    /// What people write for `is`; refused with a word about it.
    #[token("=")]
    #[token(":=")]
    #[token("==")]
    #[token("<>")]
    Equal,
    /// `"` without its other half.
    #[regex(r#""[^"\n]*"#)]
    UnclosedQuoted,
    /// What no token begins with.
    Unknown,
}

/// The tokens of a text with their places.
pub(crate) fn tokens(text: &str) -> impl Iterator<Item = (usize, Token, usize)> + '_ {
    Token::lexer(text).spanned().map(|(token, range)| (range.start, token.unwrap_or(Token::Unknown), range.end))
}
