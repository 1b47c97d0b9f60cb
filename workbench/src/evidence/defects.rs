//! Seeded defects: mistakes that were put into one channel at a time, and how long the fuzzer took to find each.

use std::collections::{BTreeMap, BTreeSet};

use serde::{Deserialize, Serialize};

use super::floors::{DEFECT_HALF_S, DEFECT_LIMIT_S};
use super::{EvidenceError, Origin, Sources};

/// What the fuzzer took to find a defect.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Measured {
    /// Whether it found a difference.
    pub found: bool,
    /// Seconds until then, or until it gave up.
    pub seconds: f64,
    /// Programs that had been run by then.
    pub cases: u64,
}

impl Measured {
    fn is_within(&self, seconds: f64) -> bool {
        self.found && self.seconds <= seconds
    }
}

/// Under what the times were taken.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
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

/// A mistake of the lists.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SeededDefect {
    /// Its name.
    pub name: String,
    /// The file that lists it, without its ending: the channel that it is put into.
    pub channel: String,
    /// The mistake.
    pub why: String,
    /// With guidance.
    pub guided: Option<Measured>,
    /// Random programs alone.
    pub plain: Option<Measured>,
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

/// All seeded defects.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct DefectEvidence {
    /// Each.
    pub defects: Vec<SeededDefect>,
    /// With guidance.
    pub guided: Method,
    /// Random programs alone.
    pub plain: Method,
    /// Under what each was measured, `guided` and `plain`, where that was recorded.
    pub conditions: BTreeMap<String, Conditions>,
}

#[derive(Deserialize)]
struct List {
    #[serde(default)]
    defect: Vec<Listed>,
}

#[derive(Deserialize)]
struct Listed {
    name: String,
    #[serde(default)]
    why: String,
}

#[derive(Default, Deserialize)]
#[serde(deny_unknown_fields)]
struct Times {
    #[serde(default)]
    guided: BTreeMap<String, Measured>,
    #[serde(default)]
    plain: BTreeMap<String, Measured>,
    #[serde(default)]
    conditions: BTreeMap<String, Conditions>,
}

impl DefectEvidence {
    pub(super) fn read(sources: &Sources, origins: &mut Vec<Origin>) -> Result<DefectEvidence, EvidenceError> {
        let times: Times = match &sources.times {
            Some(file) => {
                origins.push(file.origin(Vec::new()));
                file.toml()?
            }
            None => Times::default(),
        };
        let mut defects = Vec::new();
        for file in &sources.defects {
            let list: List = file.toml()?;
            origins.push(file.origin(Vec::new()));
            let channel = file.name.rsplit('/').next().unwrap_or_default().trim_end_matches(".toml").to_owned();
            defects.extend(list.defect.into_iter().map(|listed| SeededDefect {
                channel: channel.clone(),
                guided: times.guided.get(&listed.name).copied(),
                plain: times.plain.get(&listed.name).copied(),
                name: listed.name,
                why: listed.why,
            }));
        }
        let known: BTreeSet<&str> = defects.iter().map(|defect| defect.name.as_str()).collect();
        if let (Some(file), Some(name)) =
            (&sources.times, times.guided.keys().chain(times.plain.keys()).find(|name| !known.contains(name.as_str())))
        {
            return Err(file.wrong(format_args!("`{name}` is measured and stands in no list of defects")));
        }
        let method = |of: fn(&SeededDefect) -> Option<Measured>| Method::of(defects.iter().filter_map(of));
        Ok(DefectEvidence {
            guided: method(|defect| defect.guided),
            plain: method(|defect| defect.plain),
            conditions: times.conditions,
            defects,
        })
    }

    pub(super) fn value(&self, figure: &str) -> Option<f64> {
        let listed = self.defects.len();
        let within = |seconds| {
            self.defects.iter().filter(|defect| defect.guided.is_some_and(|one| one.is_within(seconds))).count()
        };
        match figure {
            "listed" => (listed > 0).then_some(listed as f64),
            _ if self.guided.measured == 0 => None,
            "missed" => Some((listed - within(DEFECT_LIMIT_S)) as f64),
            "quick" => Some(100.0 * within(DEFECT_HALF_S) as f64 / listed as f64),
            _ => None,
        }
    }
}

impl Method {
    fn of(measured: impl Iterator<Item = Measured>) -> Method {
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
