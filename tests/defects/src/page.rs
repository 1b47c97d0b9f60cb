//! The times that were measured, and the page that shows them.

use std::collections::BTreeMap;
use std::fmt::Write;

use serde::{Deserialize, Serialize};

use crate::{Channel, Conditions, Defect, Measured};

/// What was measured of each defect, by its name.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct Times {
    /// With guidance.
    #[serde(default)]
    pub guided: BTreeMap<String, Measured>,
    /// Random programs alone.
    #[serde(default)]
    pub plain: BTreeMap<String, Measured>,
    /// Under what the last of each was measured, `guided` and `plain`.
    #[serde(default)]
    pub conditions: BTreeMap<String, Conditions>,
}

impl Times {
    /// Those with guidance, or those without.
    pub fn of(&mut self, plain: bool) -> &mut BTreeMap<String, Measured> {
        if plain { &mut self.plain } else { &mut self.guided }
    }

    /// Says under what one was measured.
    pub fn measured_under(&mut self, plain: bool, conditions: Conditions) {
        self.conditions.insert(if plain { "plain" } else { "guided" }.to_owned(), conditions);
    }
}

/// The page of all defects.
pub fn page(lists: &[(Channel, Vec<Defect>)], times: &Times) -> String {
    let mut text = String::from(
        "# Seeded defects\n\n\
         Each line is a mistake that a programmer could have made, put into one channel alone, and how long `twinrung fuzz` took\n\
         from its start to the first difference, on two threads, with the programs that it had run by then. Guided is the\n\
         fuzzer as it is; plain is random generation alone (`--plain`). A run ends after 300 s.\n\n\
         Written by `cargo run --release -p twinrung-defects`; `--only NAME` measures one again, `--plain` the right columns.\n",
    );
    for (which, found) in [("Guided", &times.guided), ("Plain", &times.plain)] {
        // Writing to a String does not fail.
        let _ = writeln!(text, "\n{which}: {}", summary(lists, found));
    }
    for (channel, defects) in lists {
        let _ = writeln!(
            text,
            "\n## In the {}\n\n| defect | the mistake | guided s | programs | plain s | programs |\n|---|---|---|---|---|---|",
            channel.name()
        );
        for defect in defects {
            let [guided, plain] = [&times.guided, &times.plain].map(|times| cells(times.get(&defect.name)));
            let why = defect.why.replace('|', "\\|");
            let _ = writeln!(text, "| {} | {why} | {guided} | {plain} |", defect.name);
        }
    }
    text
}

fn cells(measured: Option<&Measured>) -> String {
    match measured {
        None => " | ".to_owned(),
        Some(Measured { found: true, seconds, cases }) => format!("{seconds:.1} | {cases}"),
        Some(Measured { found: false, seconds, cases }) => format!("not in {seconds:.0} | {cases}"),
    }
}

fn summary(lists: &[(Channel, Vec<Defect>)], times: &BTreeMap<String, Measured>) -> String {
    let listed: Vec<&Defect> = lists.iter().flat_map(|(_, defects)| defects).collect();
    let measured: Vec<&Measured> = listed.iter().filter_map(|defect| times.get(&defect.name)).collect();
    let mut seconds: Vec<f64> = measured.iter().filter(|one| one.found).map(|one| one.seconds).collect();
    seconds.sort_by(f64::total_cmp);
    let within = seconds.iter().filter(|seconds| **seconds <= 20.0).count();
    let median = seconds.get(seconds.len() / 2).map_or("no".to_owned(), |seconds| format!("{seconds:.1} s"));
    let longest = seconds.last().map_or("no".to_owned(), |seconds| format!("{seconds:.1} s"));
    format!(
        "of {} defects {} measured, {} found, {within} within 20 s; median {median}, longest {longest}.",
        listed.len(),
        measured.len(),
        seconds.len()
    )
}
