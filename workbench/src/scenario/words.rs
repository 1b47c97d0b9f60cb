//! Conditions and times: their words in a report, and what they come to.

use twinrung_grammar::tree::scenario::{Condition, Never, Relation, Time, TimeUnit};

/// Digits after the point of a time: ms of a minute need no more.
const FRACTION_DIGITS_MAX: usize = 5;

/// A time in ms; nothing where it does not come to whole milliseconds.
pub fn milliseconds(time: &Time, period_ms: u64) -> Option<u64> {
    let factor = match time.unit {
        TimeUnit::Milliseconds => 1,
        TimeUnit::Seconds => 1_000,
        TimeUnit::Minutes => 60_000,
        TimeUnit::Scans => period_ms,
    };
    let (whole, fraction) = time.number.split_once('.').unwrap_or((&time.number, ""));
    if fraction.len() > FRACTION_DIGITS_MAX || (time.unit == TimeUnit::Scans && !fraction.is_empty()) {
        return None;
    }
    let scale = 10_u64.pow(fraction.len() as u32);
    let digits: u64 = format!("{whole}{fraction}").replace('_', "").parse().ok()?;
    let scaled = digits.checked_mul(factor)?;
    scaled.is_multiple_of(scale).then(|| scaled / scale)
}

/// `never` as a report names it.
pub fn never_text(never: &Never) -> String {
    let conditions: Vec<String> = never.conditions.iter().map(condition_text).collect();
    format!("never {}", conditions.join(" and "))
}

/// A condition as a report names it.
pub fn condition_text(condition: &Condition) -> String {
    let relation = match condition.relation {
        Relation::Is => "is",
        Relation::IsNot => "is not",
        Relation::Below => "<",
        Relation::AtMost => "<=",
        Relation::Above => ">",
        Relation::AtLeast => ">=",
    };
    let tolerance = condition.tolerance.as_ref().map_or(String::new(), |literal| format!(" +- {}", literal.text));
    format!("{} {relation} {}{tolerance}", condition.name, condition.value.text)
}

/// A time as a report names it.
pub fn time_text(time: &Time) -> String {
    let unit = match time.unit {
        TimeUnit::Milliseconds => "ms",
        TimeUnit::Seconds => "s",
        TimeUnit::Minutes => "min",
        TimeUnit::Scans if time.number == "1" => "scan",
        TimeUnit::Scans => "scans",
    };
    format!("{} {unit}", time.number)
}

/// `within TIME` as a report names it; nothing without a time.
pub fn within_text(within: Option<&Time>) -> String {
    within.map_or(String::new(), |time| format!(" within {}", time_text(time)))
}
