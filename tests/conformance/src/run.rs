//! Runs a case on all three evaluators and compares each row.

use std::panic::{AssertUnwindSafe, catch_unwind};

use twinrung_contest::{Value, names};
use twinrung_trio::{Disagreement, Ended, Subject, Trio};

use super::source;
use super::table::{Case, End, Row, Table};
use super::value::{read, same, shown};

/// Everything that is wrong with a case, each as `FILE:LINE: case: what`.
pub fn failures(table: &Table, case: &Case) -> Vec<String> {
    let ran = catch_unwind(AssertUnwindSafe(|| run(case)));
    let found = ran.unwrap_or_else(|cause| vec![(case.line, format!("panic: {}", words_of(cause.as_ref())))]);
    found.into_iter().map(|(line, what)| format!("{}:{line}: {}: {what}", table.file, case.name)).collect()
}

fn words_of(cause: &(dyn std::any::Any + Send)) -> String {
    let text = cause.downcast_ref::<String>().cloned();
    text.or_else(|| cause.downcast_ref::<&str>().map(|text| (*text).to_owned())).unwrap_or_default()
}

fn run(case: &Case) -> Vec<(usize, String)> {
    let text = source::text(case);
    let subject = match (Subject::from_text(&text), &case.refused) {
        (Ok(subject), None) => subject,
        (Ok(_), Some(code)) => return vec![(case.line, format!("expected to be refused with {code}, found admitted"))],
        (Err(findings), Some(code)) if findings.iter().any(|finding| finding.starts_with(code.as_str())) => {
            return Vec::new();
        }
        (Err(findings), expected) => {
            let expected = expected.as_ref().map(|code| format!("refused with {code}"));
            let expected = expected.unwrap_or_else(|| "admitted".to_owned());
            return vec![(case.line, format!("expected {expected}, found refused:\n    {}", findings.join("\n    ")))];
        }
    };
    let missing: Vec<_> = case
        .inputs
        .iter()
        .chain(case.outputs.iter().filter(|name| !is_status(name)))
        .filter_map(|name| names::signal(&subject.image, name).err())
        .map(|error| (case.line, error.to_string()))
        .collect();
    if missing.is_empty() { Runner { case, trio: Trio::new(&subject) }.rows() } else { missing }
}

struct Runner<'s> {
    case: &'s Case,
    trio: Trio<'s>,
}

impl Runner<'_> {
    fn rows(mut self) -> Vec<(usize, String)> {
        let case = self.case;
        if let Some(budget) = case.budget {
            self.trio.budget = budget;
        }
        // The primary once more in the order of the text, as it runs for an observer.
        self.trio.count_executions();
        let mut wrong = Vec::new();
        let first = case.rows.first().filter(|row| !row.prescan);
        if let Some(Err(disagreement)) = first.map(|row| self.trio.prescan(row.time)) {
            return vec![(case.line, disagreement.to_string())];
        }
        for row in &case.rows {
            let found = self.row(row);
            let disagrees = found.is_err();
            wrong.extend(found.unwrap_or_else(|text| vec![text]).into_iter().map(|text| (row.line, text)));
            if disagrees {
                break;
            }
        }
        wrong
    }

    /// Runs a row; an `Err` where the evaluators disagree.
    fn row(&mut self, row: &Row) -> Result<Vec<String>, String> {
        for (name, text) in self.case.inputs.iter().zip(&row.inputs) {
            let Some(text) = text else { continue };
            let value = read(text, self.trio.value(name)).map_err(|error| format!("{name}: {error}"))?;
            self.trio.set(name, value);
        }
        let before = self.trio.executed();
        let ended = if row.prescan { self.trio.prescan(row.time) } else { self.trio.scan(row.time) };
        let executed = self.trio.executed() - before;
        let mut wrong = Vec::new();
        match &ended {
            Ok(ended) if end_of(*ended) == row.end => {}
            Ok(ended) => wrong.push(format!("expected {}, found {}", row.end, end_of(*ended))),
            Err(_) => {}
        }
        for (name, text) in self.case.outputs.iter().zip(&row.outputs) {
            let Some(text) = text else { continue };
            let found = self.found(name, executed);
            match read(text, found) {
                Ok(expected) if same(expected, found) => {}
                Ok(expected) => wrong.push(format!("{name}: expected {}, found {}", shown(expected), shown(found))),
                Err(error) => wrong.push(format!("{name}: {error}")),
            }
        }
        ended.map(|_| wrong).map_err(|disagreement| self.words(row, &disagreement))
    }

    /// What the evaluators hold where they disagree, with what the row expects.
    fn words(&self, row: &Row, disagreement: &Disagreement) -> String {
        let pairs = self.case.outputs.iter().zip(&row.outputs);
        let expected: Vec<String> =
            pairs.filter_map(|(name, value)| value.as_ref().map(|value| format!("{name} = {value}"))).collect();
        format!("{disagreement}  expected: {}, {}", row.end, expected.join(", "))
    }

    fn found(&self, name: &str, executed: u64) -> Value {
        let status = self.trio.status();
        let count = |count: u64| Value::Integer(i32::try_from(count).unwrap_or(i32::MAX));
        match name {
            "S:FS" => Value::Bool(status.first_scan),
            "S:V" => Value::Bool(status.overflow),
            "S:Z" => Value::Bool(status.zero),
            "S:N" => Value::Bool(status.negative),
            "S:C" => Value::Bool(status.carry),
            "S:MINOR" => Value::Bool(status.minor_fault),
            "minor" => count(u64::from(status.minor_faults)),
            "cleared" => count(u64::from(status.cleared_faults)),
            "executed" => count(executed),
            name => match name.strip_prefix("events:") {
                Some(task) => count(u64::from(self.trio.events(task))),
                None => self.trio.value(name),
            },
        }
    }
}

fn is_status(name: &str) -> bool {
    name.starts_with("S:") || name.starts_with("events:") || matches!(name, "minor" | "cleared" | "executed")
}

fn end_of(ended: Ended) -> End {
    match ended {
        Ended::Completed => End::Completed,
        Ended::Fault(code) => End::Fault(code),
        Ended::BudgetExceeded => End::Budget,
    }
}
