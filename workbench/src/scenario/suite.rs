//! All scenarios of one project, and what they show together.

use std::path::Path;

use twinrung_bytecode::AdmittedImage;
use twinrung_bytecode::channel::Channel;
use twinrung_bytecode::signature::short_form;
use twinrung_compiler::diagnostic::{Finding, SCENARIO_EXCLUSION};
use twinrung_grammar::tree::Sources;
use twinrung_grammar::tree::scenario::ScenarioFile;

use super::plan::{Exclusion, plan};
use super::report::{CoverageReport, Excluded, FailureReport, ProjectReport, ScenarioReport};
use super::{Played, Scenario, picture, play};
use crate::RunError;
use crate::coverage::{Coverage, Item, Summary};

/// The scenarios of one project.
pub struct Suite<'a> {
    image: &'a AdmittedImage,
    bytes: &'a [u8],
    coverage: Coverage,
    scenarios: Vec<(String, Scenario)>,
    exclusions: Vec<Exclusion>,
    minimum: Option<u8>,
}

impl<'a> Suite<'a> {
    /// No scenario yet.
    pub fn new(image: &'a AdmittedImage, bytes: &'a [u8]) -> Suite<'a> {
        Suite {
            image,
            bytes,
            coverage: Coverage::new(image),
            scenarios: Vec::new(),
            exclusions: Vec::new(),
            minimum: None,
        }
    }

    /// Takes on the scenarios of a file; what is wrong with them. Of several files the highest minimum counts.
    pub fn add(&mut self, path: &Path, file: &ScenarioFile) -> Vec<Finding> {
        let (plan, mut findings) = plan(self.image, file);
        let items = self.coverage.items();
        for exclusion in &plan.exclusions {
            if items.iter().all(|item| item.name != exclusion.item) {
                let finding = Finding::new(
                    &SCENARIO_EXCLUSION,
                    exclusion.span,
                    format!("there is nothing to cover that is called `{}`", exclusion.item),
                );
                findings.push(match closest(&items, &exclusion.item) {
                    Some(name) => finding.help(format!("did you mean `{name}`?")),
                    None => finding.help("copy the name from the list of what is missing"),
                });
            }
        }
        self.minimum = self.minimum.max(plan.minimum);
        self.exclusions.extend(plan.exclusions);
        let name = path.display().to_string();
        self.scenarios.extend(plan.scenarios.into_iter().map(|scenario| (name.clone(), scenario)));
        findings
    }

    /// Demands at least this coverage in percent, whatever the files demand.
    pub fn demand(&mut self, minimum: Option<u8>) {
        self.minimum = minimum.or(self.minimum);
    }

    /// Keeps the scenarios whose name holds a text, case aside. Coverage is then not judged: parts are missing on purpose.
    pub fn filter(&mut self, text: &str) {
        let wanted = text.to_lowercase();
        self.scenarios.retain(|(_, scenario)| scenario.name.to_lowercase().contains(&wanted));
        self.minimum = None;
    }

    /// How many scenarios there are.
    pub fn len(&self) -> usize {
        self.scenarios.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.scenarios.is_empty()
    }

    /// Plays all scenarios; `progress` is told after each how many were played.
    ///
    /// # Errors
    ///
    /// As [`play`].
    pub fn run<A: Channel, B: Channel>(
        mut self,
        project: String,
        sources: &Sources,
        mut progress: impl FnMut(u64),
    ) -> Result<ProjectReport, RunError> {
        let mut reports = Vec::with_capacity(self.scenarios.len());
        for (done, (file, scenario)) in (1..).zip(&self.scenarios) {
            let played = play::<A, B>(self.image, self.bytes, scenario, &mut self.coverage)?;
            reports.push(report::<A, B>(self.image, self.bytes, file, scenario, &played, sources)?);
            progress(done);
        }
        Ok(ProjectReport {
            project,
            signature: short_form(self.image.application_signature()).to_string(),
            passed: reports.iter().all(|report| report.passed),
            scenarios: reports,
            coverage: self.covered(),
        })
    }

    fn covered(&self) -> CoverageReport {
        let mut items = self.coverage.items();
        let mut needless = Vec::new();
        for exclusion in &self.exclusions {
            for item in items.iter_mut().filter(|item| item.name == exclusion.item) {
                if item.reached {
                    needless.push(exclusion.item.clone());
                } else {
                    item.excluded = Some(exclusion.reason.clone());
                }
            }
        }
        let summary = Summary::of(&items);
        let excluded =
            items.iter().filter_map(|item| Some(Excluded { item: item.name.clone(), reason: item.excluded.clone()? }));
        CoverageReport {
            percent: summary.all.percent(),
            minimum: self.minimum,
            enough: self.minimum.is_none_or(|minimum| summary.all.percent() >= minimum),
            excluded: excluded.collect(),
            needless,
            kinds: summary.kinds,
            missing: items.into_iter().filter(Item::is_missing).collect(),
            doubts: self.coverage.doubts(),
        }
    }
}

/// The item whose name begins longest as a text does.
fn closest<'i>(items: &'i [Item], text: &str) -> Option<&'i str> {
    let common = |item: &&Item| item.name.bytes().zip(text.bytes()).take_while(|(a, b)| a == b).count();
    let best = items.iter().max_by_key(common)?;
    (common(&best) * 2 > text.len()).then_some(best.name.as_str())
}

fn report<A: Channel, B: Channel>(
    image: &AdmittedImage,
    bytes: &[u8],
    file: &str,
    scenario: &Scenario,
    played: &Played,
    sources: &Sources,
) -> Result<ScenarioReport, RunError> {
    let failures = played.failures.iter().map(|failure| {
        let picture = picture::<A, B>(image, bytes, scenario, failure)?;
        Ok(FailureReport {
            expected: failure.expected.clone(),
            line: sources.line_column(failure.span).line,
            found: failure.found.clone(),
            at_ms: failure.at_ms,
            decision: picture.decision,
            recording: picture.recording,
        })
    });
    Ok(ScenarioReport {
        name: played.name.clone(),
        file: file.to_owned(),
        line: sources.line_column(played.span).line,
        passed: played.failures.is_empty(),
        scans: played.scans,
        end_ms: played.end_ms,
        expectations: played.expectations,
        stopped: played.stopped.filter(|_| played.failures.iter().any(|failure| failure.expectation.is_none())),
        failures: failures.collect::<Result<_, RunError>>()?,
    })
}
