//! Fault injection: reports of `twinrung inject`, added up over the samples.

use std::collections::BTreeSet;

use serde::Serialize;

use crate::inject::{self, Class, ClassReport, Group, Mechanism, MechanismReport, Recorded, Summary};

use super::{EvidenceError, Origin, Sources};

/// A project into which faults were injected.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Injected {
    /// The report.
    pub file: String,
    /// The project.
    pub project: String,
    /// Its signature, in the short form.
    pub signature: String,
    /// What drove its inputs.
    pub stimulus: String,
    /// The seed of the places.
    pub seed: u64,
    /// Scans of the undisturbed run.
    pub scans: u32,
    /// Scans that each fault was followed for.
    pub follow: u32,
    /// By group.
    pub groups: Vec<Summary>,
}

/// A fault that let a wrong output out.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Miss {
    /// The class.
    pub class: String,
    /// The command that shows it again.
    pub replay: String,
}

/// All reports together.
#[derive(Debug, Clone, Serialize)]
pub struct InjectionEvidence {
    /// Each.
    pub projects: Vec<Injected>,
    /// By group.
    pub groups: Vec<Summary>,
    /// By class.
    pub classes: Vec<ClassReport>,
    /// By mechanism.
    pub mechanisms: Vec<(Mechanism, MechanismReport)>,
    /// Faults that let a wrong output out, as far as the reports list them.
    pub misses: Vec<Miss>,
    /// Classes of faults in a channel or in what both share of which none was injected.
    pub not_injected: Vec<String>,
    /// Samples into which no fault in a channel or in what both share was injected.
    pub not_reported: Vec<String>,
}

impl InjectionEvidence {
    pub(super) fn read(
        sources: &Sources,
        origins: &mut Vec<Origin>,
    ) -> Result<Option<InjectionEvidence>, EvidenceError> {
        let mut read: Vec<(&str, Recorded)> = Vec::with_capacity(sources.inject.len());
        for file in &sources.inject {
            let report: Recorded = serde_json::from_slice(&file.bytes).map_err(|error| {
                file.wrong(format_args!(
                    "no report of `twinrung inject --report` of this release: {error}; run it again"
                ))
            })?;
            if report.schema != inject::SCHEMA {
                let (schema, known) = (report.schema, inject::SCHEMA);
                return Err(
                    file.wrong(format_args!("a report of form {schema}, and this release knows {known}; run it again"))
                );
            }
            if let Some((other, _)) = read.iter().find(|(_, other)| is_again(&report, other)) {
                return Err(file.wrong(format_args!(
                    "faults of the same classes, seed, inputs and project as in {other}, and they would count twice: take one of them away, or run it again with another --seed"
                )));
            }
            origins.push(file.origin(vec![report.provenance.clone()]));
            read.push((&file.name, report));
        }
        Ok((!read.is_empty()).then(|| InjectionEvidence::of(&read, &sources.samples)))
    }

    fn of(read: &[(&str, Recorded)], samples: &[String]) -> InjectionEvidence {
        let classes = inject::together(read.iter().flat_map(|(_, recorded)| &recorded.report.classes));
        let injected: BTreeSet<&str> =
            classes.iter().filter(|class| class.injected > 0).map(|class| class.name.as_str()).collect();
        let wanted = Class::all().into_iter().filter(|class| class.group() != Group::Residual);
        let not_injected =
            wanted.map(|class| class.to_string()).filter(|name| !injected.contains(name.as_str())).collect();
        let is_of = |project: &str, sample: &str| {
            let folder = project.trim_end_matches("/project.rll").trim_end_matches('/');
            folder == sample || folder.ends_with(&format!("/{sample}"))
        };
        let is_injected = |recorded: &Recorded| {
            recorded.report.classes.iter().any(|class| class.group != Group::Residual && class.injected > 0)
        };
        let reported = |sample: &&String| {
            read.iter().any(|(_, recorded)| is_of(&recorded.project, sample) && is_injected(recorded))
        };
        let misses = read.iter().flat_map(|(_, recorded)| {
            recorded.report.classes.iter().flat_map(move |class| {
                class
                    .misses
                    .iter()
                    .map(move |miss| Miss { class: class.name.clone(), replay: format!("{} {miss}", recorded.replay) })
            })
        });
        let projects = read.iter().map(|(file, recorded)| Injected {
            file: (*file).to_owned(),
            project: recorded.project.clone(),
            signature: recorded.signature.clone(),
            stimulus: recorded.stimulus.clone(),
            seed: recorded.report.seed,
            scans: recorded.report.scans,
            follow: recorded.report.follow,
            groups: recorded.report.groups.clone(),
        });
        InjectionEvidence {
            projects: projects.collect(),
            groups: inject::summaries(&classes),
            mechanisms: inject::mechanisms(&classes).into_iter().collect(),
            misses: misses.collect(),
            not_injected,
            not_reported: samples.iter().filter(|sample| !reported(sample)).cloned().collect(),
            classes,
        }
    }

    /// The sum of a group; nothing where none of it was injected.
    pub fn group(&self, group: Group) -> Option<&Summary> {
        self.groups.iter().find(|summary| summary.group == group && summary.injected > 0)
    }

    /// Faults injected in one channel and in what both share.
    pub(super) fn counted(&self) -> u64 {
        let counted = [Group::Channel, Group::Shared].into_iter().filter_map(|group| self.group(group));
        counted.map(|summary| summary.injected).sum()
    }
}

/// Whether two reports hold the same faults: one run under two names, or places drawn from one seed in one class of one run.
fn is_again(one: &Recorded, other: &Recorded) -> bool {
    let key = |of: &Recorded| (of.signature.clone(), of.stimulus.clone(), of.report.seed);
    let injected =
        |of: &Recorded, name: &str| of.report.classes.iter().any(|class| class.name == name && class.injected > 0);
    let has_a_class_in_common =
        one.report.classes.iter().any(|class| class.injected > 0 && injected(other, &class.name));
    (key(one) == key(other) && has_a_class_in_common)
        || one.report == other.report && one.provenance == other.provenance
}
