//! The times that seeded defects took to be found, as they are kept in `tests/defects/times.toml`.

use std::collections::BTreeMap;
use std::fmt;

use serde::{Deserialize, Serialize};

use super::floors::DEFECT_HALF_S;

/// What the fuzzer took to find a defect.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Measured {
    /// Whether it found a difference.
    pub found: bool,
    /// Seconds until then, or until it gave up.
    pub seconds: f64,
    /// Programs that had been run by then.
    pub cases: u64,
}

impl Measured {
    /// Whether it was found in so many seconds.
    pub fn is_within(&self, seconds: f64) -> bool {
        self.found && self.seconds <= seconds
    }
}

/// Under what the times were taken.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Conditions {
    /// Threads.
    pub jobs: u32,
    /// Seconds after which a defect counts as missed.
    pub limit_s: u32,
    /// First seed.
    pub seed: u64,
    /// The release that was measured.
    pub version: String,
    /// The compiler that built it.
    pub rustc: String,
    /// The processor.
    pub processor: String,
    /// Processors that the machine offers.
    pub cores: usize,
}

/// Times that are there were taken under other conditions.
#[derive(Debug, Clone, PartialEq)]
pub struct OtherConditions {
    /// Which: `guided` or `plain`.
    pub way: &'static str,
    /// Those that are recorded.
    pub recorded: Conditions,
}

impl fmt::Display for OtherConditions {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Conditions { jobs, limit_s, seed, version, rustc, processor, cores } = &self.recorded;
        write!(
            f,
            "the {} times that are there were taken with --jobs {jobs} --limit {limit_s} --seed {seed}, by version {version}, {rustc}, on \
             {processor}, {cores} processors, and one list has one set of conditions: measure under these, or move the file away and \
             measure the whole list anew",
            self.way
        )
    }
}

impl std::error::Error for OtherConditions {}

/// The name of a way to look for defects.
fn way(plain: bool) -> &'static str {
    if plain { "plain" } else { "guided" }
}

/// What was measured of each defect, by its name.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Times {
    /// With guidance.
    #[serde(default)]
    pub guided: BTreeMap<String, Measured>,
    /// Random programs alone.
    #[serde(default)]
    pub plain: BTreeMap<String, Measured>,
    /// Under what all of each were measured, `guided` and `plain`.
    #[serde(default)]
    pub conditions: BTreeMap<String, Conditions>,
}

impl Times {
    /// Those with guidance, or those without.
    pub fn of(&mut self, plain: bool) -> &mut BTreeMap<String, Measured> {
        if plain { &mut self.plain } else { &mut self.guided }
    }

    /// Whether times that are taken like this stand beside those that are there: one list of times has one set of conditions.
    ///
    /// # Errors
    ///
    /// Those that are there were taken otherwise.
    pub fn admits(&self, plain: bool, jobs: u32, limit_s: u32, seed: u64) -> Result<(), OtherConditions> {
        match self.conditions.get(way(plain)) {
            Some(of) if (of.jobs, of.limit_s, of.seed) != (jobs, limit_s, seed) => {
                Err(OtherConditions { way: way(plain), recorded: of.clone() })
            }
            _ => Ok(()),
        }
    }

    /// Enters what one took, and under what it was measured.
    ///
    /// # Errors
    ///
    /// Those that are there were taken under other conditions; nothing is entered.
    pub fn enter(
        &mut self,
        plain: bool,
        name: &str,
        measured: Measured,
        conditions: Conditions,
    ) -> Result<(), OtherConditions> {
        let recorded = self.conditions.get(way(plain)).cloned().unwrap_or_default();
        let has_others = self.of(plain).keys().any(|known| known != name);
        if has_others && recorded != conditions {
            return Err(OtherConditions { way: way(plain), recorded });
        }
        self.conditions.insert(way(plain).to_owned(), conditions);
        self.of(plain).insert(name.to_owned(), measured);
        Ok(())
    }
}

/// One way to look for them.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct Method {
    /// Defects that were measured.
    pub measured: usize,
    /// Those that were found.
    pub found: usize,
    /// Those that were found within 20 s.
    pub quick: usize,
    /// The median of all that were measured, in seconds; nothing where half of them were not found.
    pub median: Option<f64>,
    /// The longest that one took that was found, in seconds.
    pub longest: Option<f64>,
    /// The median of the programs that were run until a defect was found.
    pub median_programs: Option<u64>,
}

impl Method {
    /// Adds up what was measured.
    pub fn of(measured: impl Iterator<Item = Measured>) -> Method {
        let mut all: Vec<Measured> = measured.collect();
        // What was not found comes behind all that were.
        all.sort_by(|a, b| b.found.cmp(&a.found).then(a.seconds.total_cmp(&b.seconds)));
        let found: Vec<&Measured> = all.iter().filter(|one| one.found).collect();
        let mut programs: Vec<u64> = found.iter().map(|one| one.cases).collect();
        programs.sort_unstable();
        Method {
            measured: all.len(),
            found: found.len(),
            quick: found.iter().filter(|one| one.seconds <= DEFECT_HALF_S).count(),
            median: all.get(all.len() / 2).filter(|one| one.found).map(|one| one.seconds),
            longest: found.last().map(|one| one.seconds),
            median_programs: programs.get(programs.len() / 2).copied(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn median_when_half_was_not_found_then_there_is_none() {
        let one = |found, seconds| Measured { found, seconds, cases: 1 };
        let quick = Method::of([one(true, 2.0), one(true, 1.0), one(false, 300.0)].into_iter());
        assert_eq!((quick.median, quick.longest, quick.found), (Some(2.0), Some(2.0), 2));
        let slow = Method::of([one(true, 2.0), one(false, 300.0)].into_iter());
        assert_eq!((slow.median, slow.measured), (None, 2));
    }
}
