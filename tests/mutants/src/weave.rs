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
    /// It lies in no function: a constant is computed when it is compiled.
    Constant,
    /// It lies in a function that is executed when it is compiled as well.
    ConstantFunction,
    /// The function says `impl` of what it gives, which must be one type in all its copies.
    HiddenType,
    /// It lies in what stands before the body of its function, or not in its text at all.
    Outside,
}

/// Whether a mutant can be woven into the text of its file.
///
/// # Errors
///
/// Why not.
pub fn weavable(text: &str, mutant: &Mutant) -> Result<(), Unwoven> {
    let (signature, body) = function(text, mutant).ok_or(Unwoven::Constant)?;
    let words = &text[signature];
    if words.lines().any(|line| !line.trim_start().starts_with("//") && line.contains("const fn")) {
        Err(Unwoven::ConstantFunction)
    } else if words.rsplit_once("->").is_some_and(|(_, given)| given.contains("impl ")) {
        Err(Unwoven::HiddenType)
    } else if mutant.span.bytes(text).is_none_or(|span| span.start < body.start || span.end > body.end) {
        Err(Unwoven::Outside)
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

/// Weaves mutants with their numbers into the text of their file. Each is [`weavable`].
pub fn weave(text: &str, mutants: &[(usize, &Mutant)]) -> Woven {
    let mut copies: Vec<(usize, usize, String)> = Vec::new();
    for (number, mutant) in mutants {
        let (Some((_, body)), Some(span)) = (function(text, mutant), mutant.span.bytes(text)) else { continue };
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::list::{Function, Place, Span};

    const TEXT: &str = "/// One.\nfn one(a: u8) -> bool {\n    a < 2\n}\n\nfn two() -> u8 { 3 }\n";

    /// From the first text to before the second, both found in the text behind the first.
    fn span(text: &str, from: &str, length: usize) -> Span {
        let at = text.find(from).unwrap();
        Span { start: Place::of(text, at), end: Place::of(text, at + length) }
    }

    /// The mutant that replaces `from` in the function of this text.
    fn mutant(text: &str, function: &str, from: &str, replacement: &str) -> Mutant {
        Mutant {
            name: from.to_owned(),
            file: "a.rs".to_owned(),
            function: (!function.is_empty()).then(|| Function { span: span(text, function, function.len()) }),
            span: span(text, from, from.len()),
            replacement: replacement.to_owned(),
        }
    }

    const ONE: &str = "/// One.\nfn one(a: u8) -> bool {\n    a < 2\n}";

    #[test]
    fn function_when_woven_then_it_begins_with_its_changed_copies_and_their_lines_are_told() {
        let (less, three) = (mutant(TEXT, ONE, "<", ">"), mutant(TEXT, "fn two() -> u8 { 3 }", "3", "0"));
        assert_eq!([&less, &three].map(|mutant| weavable(TEXT, mutant)), [Ok(()), Ok(())]);
        let woven = weave(TEXT, &[(1, &less), (2, &three)]);
        let expected = "/// One.\nfn one(a: u8) -> bool {\nif crate::woven::is_on(1) { return {\n    a  >  2\n\n}; }\n\n    a < 2\n}\n\n\
                        fn two() -> u8 {\nif crate::woven::is_on(2) { return {  0  \n}; }\n 3 }\n";
        assert_eq!(woven.text, expected);
        let lines: Vec<&str> = woven.text.lines().collect();
        assert!(
            lines[woven.lines[0].0.start - 1].contains("is_on(1)")
                && lines[woven.lines[1].0.start - 1].contains("is_on(2)")
        );
        assert_eq!(woven.lines, [(3..8, 1), (12..15, 2)]);
    }

    #[test]
    fn mutant_when_it_cannot_be_switched_then_it_is_said_why() {
        let judged = |text: &str, function: &str, from: &str| weavable(text, &mutant(text, function, from, "0"));
        assert_eq!(judged("const A: u8 = 3;\n", "", "3"), Err(Unwoven::Constant));
        assert_eq!(
            judged("const fn a() -> u8 { 3 }\n", "const fn a() -> u8 { 3 }", "3"),
            Err(Unwoven::ConstantFunction)
        );
        let hidden = "fn a() -> impl Iterator<Item = u8> { one(3) }";
        assert_eq!(judged(hidden, hidden, "3"), Err(Unwoven::HiddenType));
        let sized = "fn a(of: [u8; 3]) -> u8 { of[0] }";
        assert_eq!(judged(sized, sized, "3"), Err(Unwoven::Outside));
        let commented = "// const fn was too slow\nfn a() -> u8 { 3 }";
        assert_eq!(judged(commented, commented, "3"), Ok(()));
    }

    #[test]
    fn place_when_the_text_has_characters_of_several_bytes_then_its_column_counts_characters() {
        let text = "ä\nlet ü = \"€\"; x\n";
        let byte = |line, column| Place { line, column }.byte(text);
        assert_eq!(byte(2, 5).map(|at| &text[at..at + 2]), Some("ü"));
        assert_eq!(byte(2, 14).map(|at| &text[at..at + 1]), Some("x"));
        assert_eq!([byte(1, 1), byte(1, 2), byte(2, 1)], [Some(0), Some(2), Some(3)]);
        assert_eq!(Place::of(text, text.find('x').unwrap()), Place { line: 2, column: 14 });
        assert_eq!([byte(0, 1), byte(1, 0), byte(2, 99), byte(9, 1)], [None; 4]);
    }
}
