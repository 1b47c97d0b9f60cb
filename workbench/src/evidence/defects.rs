//! Seeded defects: mistakes that were put into one channel at a time, and how long the fuzzer took to find each.

use std::collections::{BTreeMap, BTreeSet};

use serde::{Deserialize, Serialize};

use super::floors::{DEFECT_HALF_S, DEFECT_LIMIT_S};
use super::times::{Conditions, Measured, Method, Times};
use super::{EvidenceError, Origin, Sources};

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
            return Err(file.wrong(format_args!(
                "`{name}` is measured and stands in no list of defects: enter it in one, or take its times out"
            )));
        }
        let method = |of: fn(&SeededDefect) -> Option<Measured>| Method::of(defects.iter().filter_map(of));
        Ok(DefectEvidence {
            guided: method(|defect| defect.guided),
            plain: method(|defect| defect.plain),
            conditions: times.conditions,
            defects,
        })
    }

    /// Defects that were found with guidance within so many seconds; nothing where none was measured.
    fn within(&self, seconds: f64) -> Option<usize> {
        let within = self.defects.iter().filter(|defect| defect.guided.is_some_and(|one| one.is_within(seconds)));
        (self.guided.measured > 0).then(|| within.count())
    }

    /// Defects that stand in the lists; nothing where there are no lists.
    pub(super) fn listed(&self) -> Option<f64> {
        (!self.defects.is_empty()).then_some(self.defects.len() as f64)
    }

    /// Defects that were not found in time.
    pub(super) fn missed(&self) -> Option<f64> {
        Some((self.defects.len() - self.within(DEFECT_LIMIT_S)?) as f64)
    }

    /// Defects that were found quickly, in percent.
    pub(super) fn quick(&self) -> Option<f64> {
        Some(100.0 * self.within(DEFECT_HALF_S)? as f64 / self.defects.len() as f64)
    }
}
