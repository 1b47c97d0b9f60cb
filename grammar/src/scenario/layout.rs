//! The canonical layout of a scenario file: one statement to a line as the author broke the lines, blanks and indentation
//! made alike. Nothing but white space changes.

use super::token::{Token, tokens};

/// Blanks of one step of indentation.
const STEP: usize = 2;

/// A text in its canonical layout. A line of several statements stays one line; a statement that goes on in the next line is
/// indented further there; at most one empty line stands between two others.
pub fn laid_out(text: &str) -> String {
    let mut out = String::new();
    let mut place = Place::default();
    let mut empty = true;
    for line in text.trim_start_matches('\u{feff}').lines() {
        let (code, comment) = split(line);
        let words: Vec<(usize, Token, usize)> = tokens(code).collect();
        if words.is_empty() && comment.is_empty() {
            if !empty {
                out.push('\n');
            }
            empty = true;
            continue;
        }
        let depth = place.indentation(words.first().map(|word| word.1));
        out.push_str(&" ".repeat(depth * STEP));
        out.push_str(&spaced(code, &words));
        if !comment.is_empty() {
            if !words.is_empty() {
                out.push(' ');
            }
            out.push_str(comment.trim_end());
        }
        out.push('\n');
        empty = false;
        place.pass(&words);
    }
    out.truncate(out.trim_end().len());
    if !out.is_empty() {
        out.push('\n');
    }
    out
}

/// A line's statement and its comment: `//` within quotes begins none.
fn split(line: &str) -> (&str, &str) {
    let mut quoted = false;
    let mut before = ' ';
    for (at, character) in line.char_indices() {
        quoted ^= character == '"';
        if !quoted && character == '/' && before == '/' {
            return line.split_at(at - 1);
        }
        before = character;
    }
    (line, "")
}

/// One blank between two words, none where the author had none that matters: before a comma and around a slash.
fn spaced(code: &str, words: &[(usize, Token, usize)]) -> String {
    let mut out = String::new();
    let mut before: Option<Token> = None;
    for (start, token, end) in words {
        let close = matches!(token, Token::Comma | Token::Slash) || before == Some(Token::Slash);
        if before.is_some() && !close {
            out.push(' ');
        }
        out.push_str(code.get(*start..*end).unwrap_or_default());
        before = Some(*token);
    }
    out
}

/// Where in a file a line stands.
#[derive(Default)]
struct Place {
    in_block: bool,
    in_moment: bool,
}

impl Place {
    fn indentation(&self, first: Option<Token>) -> usize {
        match first {
            Some(Token::Scenario | Token::Setup | Token::Project | Token::Minimum | Token::Exclude | Token::End) => 0,
            Some(Token::At | Token::After | Token::With | Token::Power | Token::Given) => 1,
            Some(Token::When | Token::Hold | Token::Toggle | Token::Mode | Token::Then | Token::Never) | None => {
                usize::from(self.in_block) + usize::from(self.in_moment)
            }
            // A statement goes on.
            Some(_) => usize::from(self.in_block) + usize::from(self.in_moment) + 2,
        }
    }

    fn pass(&mut self, words: &[(usize, Token, usize)]) {
        for (_, token, _) in words {
            match token {
                Token::Scenario | Token::Setup => *self = Place { in_block: true, in_moment: false },
                Token::End => *self = Place::default(),
                Token::At | Token::After => self.in_moment = true,
                _ => {}
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn layout_when_made_of_a_canonical_text_then_nothing_changes() {
        let text = include_str!("every_form.scenario");
        assert_eq!(laid_out(text), text);
    }

    #[test]
    fn layout_when_made_then_only_white_space_differs() {
        let text = "scenario   \"a  b\" // why\n\n\n at 20ms\nwhen A  is 1 ,\nB is 0\n  end";
        let expected = "scenario \"a  b\" // why\n\n  at 20 ms\n    when A is 1,\n        B is 0\nend\n";
        assert_eq!(laid_out(text), expected);
    }
}
