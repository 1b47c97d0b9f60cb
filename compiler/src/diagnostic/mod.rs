//! What a check has to say: findings with a code, a place and a way out; and the one table of all codes.

mod codes;
mod reading;
mod remedy;
mod rungs;
mod table;

pub use codes::*;
pub use reading::reading_finding;
pub use rungs::{PlacedRung, RungIndex};
pub use table::{ALL, by_id};

use twinrung_grammar::tree::Span;

/// How much a finding weighs.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Severity {
    /// No image can be made.
    Error,
    /// An image can be made; somebody should look.
    Warning,
    /// Worth knowing.
    Note,
}

/// One entry of the code table.
#[derive(Debug, PartialEq, Eq)]
pub struct Code {
    /// `S....` what the safety rules refuse, `E....` what cannot be read or resolved, `W....` warnings, `D....` a defect
    /// of this tool.
    pub id: &'static str,
    /// How much it weighs.
    pub severity: Severity,
    /// The rule in a few words.
    pub title: &'static str,
    /// What is refused, why, and the way out.
    pub explanation: &'static str,
    /// Where the rule comes from.
    pub citation: &'static str,
    /// A complete project that keeps the rule; may be empty where a rule concerns no source text.
    pub good: &'static str,
    /// The same, breaking it. `<<` and `>>` enclose what the finding points at; [`Code::bad_text`] leaves them out.
    pub bad: &'static str,
}

impl Code {
    /// The bad sample without its marks.
    pub fn bad_text(&self) -> String {
        self.bad.replace("<<", "").replace(">>", "")
    }
}

/// A place that has to do with a finding.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Label {
    /// Where.
    pub span: Span,
    /// What it has to do with it.
    pub text: String,
}

/// Which rung a finding is about.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct RungPlace {
    /// `Program/Routine` or the Add-On Instruction's `Name/Routine`.
    pub routine: String,
    /// The rung, from 0.
    pub rung: u32,
    /// The whole rung's text.
    pub span: Span,
}

/// Something that a check found.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Finding {
    /// The entry of the code table.
    pub code: &'static Code,
    /// How much it weighs.
    pub severity: Severity,
    /// What is wrong, in one sentence.
    pub message: String,
    /// What the finding points at.
    pub span: Span,
    /// Related places.
    pub labels: Vec<Label>,
    /// The way out.
    pub help: Option<String>,
    /// The rung that it is about.
    pub rung: Option<Box<RungPlace>>,
    /// Why somebody accepts it, where a suppression covers it. It is listed in every report and weighs nothing.
    pub accepted: Option<Box<str>>,
}

impl Finding {
    /// A finding at a place.
    pub fn new(code: &'static Code, span: Span, message: impl Into<String>) -> Finding {
        Finding {
            code,
            severity: code.severity,
            message: message.into(),
            span,
            labels: Vec::new(),
            help: None,
            rung: None,
            accepted: None,
        }
    }

    /// The same with a way out.
    #[must_use]
    pub fn help(mut self, help: impl Into<String>) -> Finding {
        self.help = Some(help.into());
        self
    }

    /// The same with a related place.
    #[must_use]
    pub fn label(mut self, span: Span, text: impl Into<String>) -> Finding {
        self.labels.push(Label { span, text: text.into() });
        self
    }

    /// Whether it keeps an image from being made.
    pub fn is_error(&self) -> bool {
        self.severity == Severity::Error
    }
}

/// Findings of one run that are kept; after that one says that there are more.
const FINDINGS_MAX: usize = 1_000;

/// Gathers findings.
#[derive(Debug, Default)]
pub struct Findings {
    list: Vec<Finding>,
    errors: usize,
    left_out: usize,
}

impl Findings {
    /// Adds one.
    pub fn push(&mut self, mut finding: Finding) {
        if finding.help.is_none() {
            finding.help = remedy::remedy(finding.code.id).map(str::to_owned);
        }
        self.errors += usize::from(finding.is_error());
        if self.list.len() < FINDINGS_MAX {
            self.list.push(finding);
        } else {
            self.left_out += 1;
        }
    }

    /// Says of every finding on which rung it is.
    pub fn place(&mut self, rungs: &RungIndex<'_>) {
        self.list.iter_mut().for_each(|finding| rungs.place(finding));
    }

    /// Leaves out the findings for which `keep` is false.
    pub fn retain(&mut self, keep: impl FnMut(&Finding) -> bool) {
        self.list.retain(keep);
    }

    /// Asks of each warning and note whether a suppression covers it, and keeps the reason.
    pub fn suppress(&mut self, mut reason: impl FnMut(&Finding) -> Option<String>) {
        for finding in self.list.iter_mut().filter(|finding| !finding.is_error()) {
            finding.accepted = reason(finding).map(String::into_boxed_str);
        }
    }

    /// Whether some were left out for their number.
    pub fn is_cut(&self) -> bool {
        self.left_out > 0
    }

    /// Whether an error is among them.
    pub fn has_errors(&self) -> bool {
        self.errors > 0
    }

    /// How many there are so far.
    pub fn len(&self) -> usize {
        self.list.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.list.is_empty()
    }

    /// The list, ordered by place, each finding once.
    pub fn into_list(mut self) -> Vec<Finding> {
        self.list.sort_by(|a, b| {
            (a.span.source, a.span.start, a.severity, a.code.id, a.span.end).cmp(&(
                b.span.source,
                b.span.start,
                b.severity,
                b.code.id,
                b.span.end,
            ))
        });
        self.list.dedup();
        if let (true, Some(last)) = (self.left_out > 0, self.list.last()) {
            let message = format!("{} more findings are not listed", self.left_out);
            let finding = Finding::new(&TOO_MANY_FINDINGS, last.span, message);
            self.list.push(finding);
        }
        self.list
    }
}
