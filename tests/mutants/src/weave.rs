//! Weaving: each function gets, at its beginning, one changed copy of its body for each of its mutants, which is executed
//! instead of the body where that mutant is switched on.

use std::ops::Range;

use crate::list::Mutant;

/// The environment variable that switches a mutant on, by its number from 1.
pub const SWITCH: &str = "TWINRUNG_MUTANT";

/// What is added to the root of the crate.
pub const SWITCHING: &str = "
#[doc(hidden)]
mod woven {
    extern crate std;

    /// Whether this mutant is switched on.
    pub fn is_on(number: usize) -> bool {
        static CHOSEN: std::sync::OnceLock<usize> = std::sync::OnceLock::new();
        let read = || std::env::var(\"TWINRUNG_MUTANT\").ok().and_then(|number| number.parse().ok()).unwrap_or(0);
        *CHOSEN.get_or_init(read) == number
    }
}
";

/// A file with its mutants in it.
pub struct Woven {
    /// The text.
    pub text: String,
    /// Which lines (from 1) are those of which mutant.
    pub lines: Vec<(Range<usize>, usize)>,
}

/// Why a mutant cannot be woven.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Unwoven {
    /// It lies in a constant, which is computed when it is compiled.
    Constant,
    /// It lies in a function that is executed when it is compiled as well.
    ConstantFunction,
    /// The function says `impl` of what it gives, which must be one type in all its copies.
    HiddenType,
}

/// Whether a mutant can be woven into the text of its file.
///
/// # Errors
///
/// Why not.
pub fn weavable(text: &str, mutant: &Mutant) -> Result<(), Unwoven> {
    let (signature, _) = function(text, mutant).ok_or(Unwoven::Constant)?;
    let words = &text[signature];
    if words.lines().any(|line| !line.trim_start().starts_with("//") && line.contains("const fn")) {
        Err(Unwoven::ConstantFunction)
    } else if words.rsplit_once("->").is_some_and(|(_, given)| given.contains("impl ")) {
        Err(Unwoven::HiddenType)
    } else {
        Ok(())
    }
}

/// Signature and body (without its braces) of the function of a mutant.
fn function(text: &str, mutant: &Mutant) -> Option<(Range<usize>, Range<usize>)> {
    let whole = mutant.function.as_ref()?.span.bytes(text)?;
    let mut at = whole.start;
    // An attribute or a comment before the signature may hold a brace.
    let opening = loop {
        let line_end = text[at..whole.end].find('\n').map_or(whole.end, |length| at + length + 1);
        let line = text[at..line_end].trim_start();
        let brace = text[at..line_end].find('{').filter(|_| !line.starts_with("//") && !line.starts_with("#["));
        match brace {
            Some(brace) => break at + brace,
            None if line_end >= whole.end => return None,
            None => at = line_end,
        }
    };
    let closing = whole.start + text[whole.clone()].rfind('}')?;
    (opening < closing).then_some((whole.start..opening, opening + 1..closing))
}

/// Weaves mutants with their numbers into the text of their file. Those that do not fit their text are left out.
pub fn weave(text: &str, mutants: &[(usize, &Mutant)]) -> Woven {
    let mut copies: Vec<(usize, usize, String)> = Vec::new();
    for (number, mutant) in mutants {
        let (Some((_, body)), Some(span)) = (function(text, mutant), mutant.span.bytes(text)) else { continue };
        if span.start < body.start || span.end > body.end {
            continue;
        }
        let (before, after) = (&text[body.start..span.start], &text[span.end..body.end]);
        let copy =
            format!("\nif crate::woven::is_on({number}) {{ return {{{before} {} {after}\n}}; }}\n", mutant.replacement);
        copies.push((body.start, *number, copy));
    }
    copies.sort_by_key(|(at, number, _)| (*at, *number));
    let mut woven = Woven { text: String::with_capacity(text.len() * 2), lines: Vec::new() };
    let (mut line, mut written) = (1, 0);
    for (at, number, copy) in copies {
        woven.text.push_str(&text[written..at]);
        line += text[written..at].matches('\n').count();
        written = at;
        let length = copy.matches('\n').count();
        woven.lines.push((line + 1..line + length + 1, number));
        woven.text.push_str(&copy);
        line += length;
    }
    woven.text.push_str(&text[written..]);
    woven
}
