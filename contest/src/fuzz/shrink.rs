//! Makes a case on which evaluators differ as small as it gets: a person has to read it.

use crate::generate::Stimulus;

use super::{Case, Contest, Outcome, replay};

/// The smallest case found on which the evaluators still fail, and what is then to be said about it.
pub fn shrink<C: Contest>(case: Case) -> (Case, String) {
    let Case { mut text, mut stimulus } = case;
    let mut report = String::new();
    if let Outcome::Failed { report: first, steps } = replay::<C>(&text, &stimulus) {
        report = first;
        stimulus.steps.truncate(steps);
    }
    let mut attempt = |text: &mut String, stimulus: &mut Stimulus, smaller: String| {
        let declared = only_declared(stimulus, &smaller);
        if let Outcome::Failed { report: found, steps } = replay::<C>(&smaller, &declared)
            && same_kind(&report, &found)
        {
            report = found;
            *text = smaller;
            *stimulus = declared;
            stimulus.steps.truncate(steps);
            return true;
        }
        false
    };
    // Runs of lines, long ones first, then instructions, until nothing more can go.
    let mut length = 32;
    while length > 0 {
        let mut at = 0;
        while at < text.lines().count() {
            let removed = without_lines(&text, at, length);
            if !attempt(&mut text, &mut stimulus, removed) {
                at += length;
            }
        }
        length /= 2;
    }
    for part in [without_instruction, without_branch] {
        let mut at = 0;
        while let Some(smaller) = part(&text, at) {
            if !attempt(&mut text, &mut stimulus, smaller) {
                at += 1;
            }
        }
    }
    let mut at = 0;
    while at < text.lines().count() {
        let removed = without_lines(&text, at, 1);
        if !attempt(&mut text, &mut stimulus, removed) {
            at += 1;
        }
    }
    let mut at = 0;
    while at < stimulus.steps.len() {
        let mut fewer = stimulus.clone();
        fewer.steps.remove(at);
        let same = text.clone();
        let mut kept = text.clone();
        let mut tried = fewer;
        if attempt(&mut kept, &mut tried, same) {
            stimulus = tried;
        } else {
            at += 1;
        }
    }
    (Case { text, stimulus }, report)
}

/// Whether two reports tell of the same kind of failure; a panic that shrinking caused is none.
fn same_kind(first: &str, second: &str) -> bool {
    let panics = |report: &str| report.starts_with("panic: ");
    if panics(first) { first == second } else { !panics(second) }
}

fn without_lines(text: &str, from: usize, count: usize) -> String {
    let kept = text.lines().enumerate().filter(|(at, _)| *at < from || *at >= from + count);
    kept.map(|(_, line)| format!("{line}\n")).collect()
}

/// The text without the brackets number `at` and all within them; nothing where there are not as many. Every bracket of a
/// rung is tried; taking the subscript of an operand away is refused or fails differently, and is undone then.
fn without_branch(text: &str, at: usize) -> Option<String> {
    let (open, _) = text.match_indices('[').nth(at)?;
    let mut depth = 0;
    let close = text[open..].find(|one| {
        depth += i32::from(one == '[') - i32::from(one == ']');
        depth == 0
    })?;
    Some(format!("{}{}", &text[..open], &text[open + close + 1..]))
}

/// The text without its instruction number `at`; nothing where there are not as many.
fn without_instruction(text: &str, at: usize) -> Option<String> {
    let bytes = text.as_bytes();
    let mut number = 0;
    let mut line_start = 0;
    for line in text.split_inclusive('\n') {
        let body = line.trim_start();
        let begin = line_start + (line.len() - body.len());
        line_start += line.len();
        if !body.starts_with("N: ") {
            continue;
        }
        let end = begin + body.trim_end().len();
        let mut position = begin + 3;
        while position < end {
            let opens = bytes[position].is_ascii_alphabetic();
            if !opens {
                position += 1;
                continue;
            }
            let (mut depth, mut close) = (0, position);
            while close < end {
                match bytes[close] {
                    b'(' => depth += 1,
                    b')' if depth == 1 => break,
                    b')' => depth -= 1,
                    _ => {}
                }
                close += 1;
            }
            if number == at {
                return Some(format!("{}{}", &text[..position], text.get(close + 1..).unwrap_or_default()));
            }
            number += 1;
            position = close + 1;
        }
    }
    None
}

/// The stimulus without tags that the text declares no more.
fn only_declared(stimulus: &Stimulus, text: &str) -> Stimulus {
    let declared = |name: &str| {
        // A tag of a program is `Program:Name.Tag`, and stands in the text as `Tag`.
        let own = name.strip_prefix("Program:").and_then(|rest| rest.split_once('.')).map_or(name, |(_, own)| own);
        let base = own.split(['.', '[']).next().unwrap_or(own);
        text.lines().any(|line| line.trim_start().strip_prefix(base).is_some_and(|rest| rest.starts_with(" : ")))
    };
    let mut kept = stimulus.clone();
    for step in &mut kept.steps {
        step.values.retain(|(name, _)| declared(name));
    }
    kept
}
