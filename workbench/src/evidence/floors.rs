//! The least that a release has to show, as data: what is measured, the floor, and where the floor comes from.

use serde::Serialize;

use crate::bench::count;
use crate::html::duration;
use crate::inject::Group;

use super::{Evidence, mutants};

/// How a number is counted.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Unit {
    /// Things.
    Count,
    /// Seconds.
    Seconds,
    /// Hundredths.
    Percent,
}

impl Unit {
    fn shown(self, value: f64) -> String {
        match self {
            Unit::Count => count(value as u64),
            Unit::Seconds => duration(value),
            Unit::Percent => format!("{value:.1} %"),
        }
    }
}

/// What a number must be.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Bound {
    /// So much, or more.
    AtLeast(f64, Unit),
    /// None.
    None,
}

/// One floor.
#[derive(Debug, Clone, Copy)]
pub struct Floor {
    /// Its name, for machines.
    pub id: &'static str,
    /// What is measured.
    pub what: &'static str,
    /// What it must be.
    pub bound: Bound,
    /// Where that comes from.
    pub source: &'static str,
    /// What was found of it; nothing where nobody has measured it.
    pub value: fn(&Evidence) -> Option<f64>,
}

/// The crates whose tests are judged by mutants, with the floors of each.
pub const MUTATED: [&str; 4] = ["vm/primary", "vm/partner", "vm/controller", "compiler"];

/// Share of mutants that tests have to notice, in percent.
pub const MUTATION_SCORE: f64 = 90.0;
/// Viable mutants that a sample has to hold; where a crate has fewer, all.
pub const MUTATION_SAMPLE: u64 = 120;
/// Seconds within which the fuzzer has to find a seeded defect.
pub const DEFECT_LIMIT_S: f64 = 300.0;
/// Seconds within which it has to find half of them.
pub const DEFECT_HALF_S: f64 = 20.0;

const CAMPAIGN: &str = "REQ-EVIDENCE-003 (decided)";
const DEFECTS: &str = "REQ-EVIDENCE-004 (decided)";
const INJECTION: &str = "REQ-EVIDENCE-005 (decided); DESIGN 8";
const MUTANTS: &str = "REQ-EVIDENCE-006 (decided)";
const INDEPENDENCE: &str = "REQ-EVIDENCE-007 (decided)";

const fn floor(
    id: &'static str,
    what: &'static str,
    bound: Bound,
    source: &'static str,
    value: fn(&Evidence) -> Option<f64>,
) -> Floor {
    Floor { id, what, bound, source, value }
}

const fn at_least(number: f64, unit: Unit) -> Bound {
    Bound::AtLeast(number, unit)
}

/// All floors, in the order of the page.
pub static FLOORS: &[Floor] = &[
    floor(
        "campaign.processor",
        "differential campaign, processor time",
        at_least(10_800.0, Unit::Seconds),
        CAMPAIGN,
        |all| Some(all.campaign.as_ref()?.processor_seconds),
    ),
    floor("campaign.missing", "points of coverage that were not reached", Bound::None, CAMPAIGN, |all| {
        Some(all.campaign.as_ref()?.missing() as f64)
    }),
    floor("campaign.open", "differences that are not mended, or not accounted for", Bound::None, CAMPAIGN, |all| {
        all.campaign.as_ref().map(|_| all.open() as f64)
    }),
    floor("defects.listed", "seeded defects", at_least(60.0, Unit::Count), DEFECTS, |all| all.defects.listed()),
    floor("defects.missed", "seeded defects not found within 300 s, or not measured", Bound::None, DEFECTS, |all| {
        all.defects.missed()
    }),
    floor("defects.quick", "seeded defects found within 20 s", at_least(50.0, Unit::Percent), DEFECTS, |all| {
        all.defects.quick()
    }),
    floor(
        "injection.injected",
        "faults injected in one channel and in what both share",
        at_least(1_000_000.0, Unit::Count),
        INJECTION,
        |all| Some(all.injection.as_ref()?.counted() as f64),
    ),
    floor("injection.samples", "samples into which nothing was injected", Bound::None, INJECTION, |all| {
        Some(all.injection.as_ref()?.not_reported.len() as f64)
    }),
    floor("injection.classes", "classes of such faults of which none was injected", Bound::None, INJECTION, |all| {
        Some(all.injection.as_ref()?.not_injected.len() as f64)
    }),
    floor("injection.channel", "wrong outputs let out by a fault in one channel", Bound::None, INJECTION, |all| {
        all.let_out(Group::Channel)
    }),
    floor("injection.shared", "wrong outputs let out by a fault in what both share", Bound::None, INJECTION, |all| {
        all.let_out(Group::Shared)
    }),
    floor(
        "injection.residual",
        "residual faults injected, to see that a miss is seen",
        at_least(1.0, Unit::Count),
        INJECTION,
        |all| Some(all.injection.as_ref()?.group(Group::Residual)?.injected as f64),
    ),
    floor("mutants.primary", "mutation score of vm/primary", at_least(MUTATION_SCORE, Unit::Percent), MUTANTS, |all| {
        mutants::percent(&all.mutants, "vm/primary")
    }),
    floor("mutants.partner", "mutation score of vm/partner", at_least(MUTATION_SCORE, Unit::Percent), MUTANTS, |all| {
        mutants::percent(&all.mutants, "vm/partner")
    }),
    floor(
        "mutants.controller",
        "mutation score of vm/controller",
        at_least(MUTATION_SCORE, Unit::Percent),
        MUTANTS,
        |all| mutants::percent(&all.mutants, "vm/controller"),
    ),
    floor("mutants.compiler", "mutation score of compiler", at_least(MUTATION_SCORE, Unit::Percent), MUTANTS, |all| {
        mutants::percent(&all.mutants, "compiler")
    }),
    floor("mutants.sample", "crates of these of which too few mutants were tried", Bound::None, MUTANTS, |all| {
        mutants::too_small(&all.mutants)
    }),
    floor("mutants.survivors", "surviving mutants without a reason", Bound::None, MUTANTS, |all| {
        mutants::without_a_reason(&all.mutants)
    }),
    floor(
        "independence.uncovered",
        "things that both channels share and nothing is said to cover",
        Bound::None,
        INDEPENDENCE,
        |all| all.independence.as_ref()?.uncovered(),
    ),
    floor(
        "independence.unnamed",
        "residual classes of faults that docs/independence.md does not name",
        Bound::None,
        INDEPENDENCE,
        |all| Some(all.independence.as_ref()?.unnamed.len() as f64),
    ),
];

/// How a floor was met.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum State {
    /// As demanded.
    Met,
    /// Less, or more where there must be none.
    Below,
    /// Nobody has measured it.
    NotMeasured,
}

/// A floor, and what was found.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Judged {
    /// Its name, for machines.
    pub id: &'static str,
    /// What is measured.
    pub what: &'static str,
    /// What is demanded, in words.
    pub demanded: String,
    /// What was found, as a number; seconds, or percent, or things.
    pub value: Option<f64>,
    /// What was found, in words.
    pub found: String,
    /// Whether that is enough.
    pub state: State,
    /// Where the floor comes from.
    pub source: &'static str,
}

impl Floor {
    /// Judges what was found; nothing where nobody has measured it.
    pub fn judge(&self, value: Option<f64>) -> Judged {
        let unit = match self.bound {
            Bound::AtLeast(_, unit) => unit,
            Bound::None => Unit::Count,
        };
        let (demanded, is_met) = match self.bound {
            Bound::AtLeast(least, unit) => {
                (format!("at least {}", unit.shown(least)), value.is_some_and(|value| value >= least))
            }
            Bound::None => ("none".to_owned(), value == Some(0.0)),
        };
        let (state, found) = match (value, self.bound) {
            (None, _) => (State::NotMeasured, "not measured".to_owned()),
            (Some(value), _) if is_met => (State::Met, unit.shown(value)),
            (Some(value), Bound::None) => (State::Below, format!("{}, where there must be none", unit.shown(value))),
            (Some(value), Bound::AtLeast(least, unit)) => {
                (State::Below, format!("{}, below the floor of {}", unit.shown(value), unit.shown(least)))
            }
        };
        Judged { id: self.id, what: self.what, demanded, value, found, state, source: self.source }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn floors_when_listed_then_each_has_a_name_of_its_own_and_a_source() {
        let names: std::collections::BTreeSet<&str> = FLOORS.iter().map(|floor| floor.id).collect();
        assert_eq!(names.len(), FLOORS.len());
        assert!(FLOORS.iter().all(|floor| floor.source.starts_with("REQ-EVIDENCE-")));
    }

    /// REQ-EVIDENCE-002
    #[test]
    fn floor_when_what_was_found_is_at_it_above_below_or_absent_then_it_is_judged_so() {
        let least = floor("id", "what", at_least(60.0, Unit::Count), MUTANTS, |_| None);
        let none = floor("id", "what", Bound::None, MUTANTS, |_| None);
        let state = |floor: &Floor, value| floor.judge(value).state;
        assert_eq!(
            [Some(60.0), Some(59.9), None].map(|value| state(&least, value)),
            [State::Met, State::Below, State::NotMeasured]
        );
        assert_eq!(
            [Some(0.0), Some(1.0), None].map(|value| state(&none, value)),
            [State::Met, State::Below, State::NotMeasured]
        );
        assert_eq!(least.judge(Some(9.0)).found, "9, below the floor of 60");
    }
}
