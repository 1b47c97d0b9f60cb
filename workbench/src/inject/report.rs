//! What became of all faults, by class and by mechanism.

use std::collections::BTreeMap;
use std::fmt;

use serde::Serialize;

use super::fault::{Class, Fault, Group};
use super::interval::Coverage;
use super::once::{Mechanism, Outcome};

/// Misses that a class lists; it counts all.
const MISSES_LISTED: usize = 100;

/// What a mechanism found.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
pub struct Found {
    /// Faults.
    pub faults: u64,
    /// Scans until it was found, the fault's own being 1: the most.
    pub scans_max: u32,
}

impl Found {
    fn add(&mut self, other: Found) {
        self.faults += other.faults;
        self.scans_max = self.scans_max.max(other.scans_max);
    }
}

/// What became of the faults of one class.
#[derive(Debug, Clone, Serialize)]
pub struct ClassReport {
    #[serde(skip)]
    class: Class,
    /// The name of the class.
    pub name: String,
    /// Its group.
    pub group: Group,
    /// Places in all scans; a second number of a fault is not counted.
    pub population: u64,
    /// Faults that were injected.
    pub injected: u64,
    /// Faults that no value can show.
    pub impossible: u64,
    /// Outputs right as long as was looked.
    pub masked: u64,
    /// The same, and the bit still wrong.
    pub latent: u64,
    /// Found, with no wrong output before.
    pub detected: u64,
    /// Not found, and outputs were only ever off.
    pub off: u64,
    /// A wrong output was let out.
    pub let_out: u64,
    /// Detected or off, of all that were neither masked nor latent nor impossible.
    pub coverage: Option<Coverage>,
    /// By what they were found.
    pub mechanisms: BTreeMap<Mechanism, Found>,
    /// Faults that let a wrong output out, as `--replay` takes them; at most 100.
    pub misses: Vec<String>,
}

impl ClassReport {
    pub(super) fn new(class: Class, population: u64) -> ClassReport {
        ClassReport {
            class,
            name: class.to_string(),
            group: class.group(),
            population,
            injected: 0,
            impossible: 0,
            masked: 0,
            latent: 0,
            detected: 0,
            off: 0,
            let_out: 0,
            coverage: None,
            mechanisms: BTreeMap::new(),
            misses: Vec::new(),
        }
    }

    pub(super) fn class(&self) -> Class {
        self.class
    }

    pub(super) fn count(&mut self, fault: Fault, outcome: Outcome) {
        self.injected += 1;
        match outcome {
            Outcome::Masked => self.masked += 1,
            Outcome::Latent => self.latent += 1,
            Outcome::Detected(mechanism, scans) => {
                self.detected += 1;
                self.mechanisms.entry(mechanism).or_default().add(Found { faults: 1, scans_max: scans });
            }
            Outcome::Off => self.off += 1,
            Outcome::LetOut(_) => {
                self.let_out += 1;
                if self.misses.len() < MISSES_LISTED {
                    self.misses.push(fault.to_string());
                }
            }
            Outcome::Impossible => self.impossible += 1,
        }
    }

    pub(super) fn add(&mut self, other: ClassReport) {
        self.injected += other.injected;
        self.impossible += other.impossible;
        self.masked += other.masked;
        self.latent += other.latent;
        self.detected += other.detected;
        self.off += other.off;
        self.let_out += other.let_out;
        for (mechanism, found) in other.mechanisms {
            self.mechanisms.entry(mechanism).or_default().add(found);
        }
        self.misses.extend(other.misses);
    }
}

/// Some classes together.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Summary {
    /// The group.
    pub group: Group,
    /// Faults that were injected.
    pub injected: u64,
    /// Faults that a run showed: neither masked nor latent nor impossible.
    pub effective: u64,
    /// A wrong output was let out.
    pub let_out: u64,
    /// The diagnostic coverage of those that a run showed.
    pub coverage: Coverage,
}

/// What became of all faults.
#[derive(Debug, Clone, Serialize)]
pub struct Report {
    /// The seed.
    pub seed: u64,
    /// Scans of the undisturbed run.
    pub scans: u32,
    /// Scans that each fault was followed for.
    pub follow: u32,
    /// Groups.
    pub groups: Vec<Summary>,
    /// Classes.
    pub classes: Vec<ClassReport>,
}

impl Report {
    pub(super) fn new(mut classes: Vec<ClassReport>, seed: u64, scans: u32, follow: u32) -> Report {
        for class in &mut classes {
            class.misses.sort();
            class.misses.truncate(MISSES_LISTED);
            let (good, all) = effective(class);
            class.coverage = (all > 0).then(|| Coverage::of(good, all));
        }
        let mut report = Report { seed, scans, follow, groups: Vec::new(), classes };
        report.groups = [Group::Channel, Group::Shared, Group::Residual]
            .into_iter()
            .filter_map(|group| report.summary(group))
            .collect();
        report
    }

    fn summary(&self, group: Group) -> Option<Summary> {
        let classes = || self.classes.iter().filter(|class| class.group == group);
        classes().next()?;
        let (good, all) = classes().map(effective).fold((0, 0), |(a, b), (c, d)| (a + c, b + d));
        Some(Summary {
            group,
            injected: classes().map(|class| class.injected).sum(),
            effective: all,
            let_out: classes().map(|class| class.let_out).sum(),
            coverage: Coverage::of(good, all),
        })
    }

    /// Faults that let a wrong output out.
    pub fn let_out(&self) -> u64 {
        self.classes.iter().map(|class| class.let_out).sum()
    }

    /// Faults that were injected.
    pub fn injected(&self) -> u64 {
        self.classes.iter().map(|class| class.injected).sum()
    }

    /// What each mechanism found.
    pub fn mechanisms(&self) -> BTreeMap<Mechanism, Found> {
        let mut all: BTreeMap<Mechanism, Found> = BTreeMap::new();
        for (mechanism, found) in self.classes.iter().flat_map(|class| &class.mechanisms) {
            all.entry(*mechanism).or_default().add(*found);
        }
        all
    }
}

/// Those found or off, and those that a run showed.
fn effective(class: &ClassReport) -> (u64, u64) {
    let good = class.detected + class.off;
    (good, good + class.let_out)
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(
            f,
            "{:<34} {:>11} {:>9} {:>9} {:>9} {:>9} {:>7} {:>8}",
            "class", "places", "injected", "masked", "latent", "detected", "off", "let out"
        )?;
        for class in &self.classes {
            if class.population == 0 {
                writeln!(f, "{:<34} {:>11}", class.name, "none")?;
                continue;
            }
            writeln!(
                f,
                "{:<34} {:>11} {:>9} {:>9} {:>9} {:>9} {:>7} {:>8}",
                class.name,
                class.population,
                class.injected,
                class.masked + class.impossible,
                class.latent,
                class.detected,
                class.off,
                class.let_out
            )?;
        }
        writeln!(f, "\n{:<44} {:>9} {:>22}", "found by", "faults", "within scans, at most")?;
        for (mechanism, found) in self.mechanisms() {
            writeln!(f, "{:<44} {:>9} {:>22}", mechanism.words(), found.faults, found.scans_max)?;
        }
        writeln!(f)?;
        for group in &self.groups {
            writeln!(
                f,
                "{}: {} injected, {} shown by the run, {} let a wrong output out; diagnostic coverage {:.4} % (95 %: {:.4} to {:.4} %)",
                group.group.name(),
                group.injected,
                group.effective,
                group.let_out,
                group.coverage.share * 100.0,
                group.coverage.lower * 100.0,
                group.coverage.upper * 100.0
            )?;
        }
        for class in self.classes.iter().filter(|class| class.let_out > 0) {
            writeln!(f, "\n{} of {} let a wrong output out; --replay runs one again:", class.let_out, class.name)?;
            for miss in class.misses.iter().take(10) {
                writeln!(f, "  {miss}")?;
            }
        }
        Ok(())
    }
}
