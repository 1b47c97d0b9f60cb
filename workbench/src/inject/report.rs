//! What became of all faults, by class and by mechanism.

use std::collections::BTreeMap;
use std::fmt;

use serde::{Deserialize, Serialize};

use super::fault::{Class, Fault, Group};
use super::interval::Coverage;
use super::once::{Mechanism, Outcome};

/// Misses that a class lists; it counts all.
const MISSES_LISTED: usize = 100;

/// What a mechanism found.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct MechanismReport {
    /// Faults.
    pub faults: u64,
    /// Scans until it was found, the fault's own being 1: the most.
    pub scans_max: u32,
    /// Faults that it found in their own scan, in the one after it, and so on.
    pub by_scan: Vec<u64>,
}

impl MechanismReport {
    fn found(&mut self, scans: u32) {
        self.faults += 1;
        self.scans_max = self.scans_max.max(scans);
        let at = scans.saturating_sub(1) as usize;
        if self.by_scan.len() <= at {
            self.by_scan.resize(at + 1, 0);
        }
        self.by_scan[at] += 1;
    }

    fn add(&mut self, other: &MechanismReport) {
        self.faults += other.faults;
        self.scans_max = self.scans_max.max(other.scans_max);
        if self.by_scan.len() < other.by_scan.len() {
            self.by_scan.resize(other.by_scan.len(), 0);
        }
        self.by_scan.iter_mut().zip(&other.by_scan).for_each(|(sum, one)| *sum += one);
    }

    /// Scans within which so many of a hundred were found.
    pub fn within(&self, percent: u64) -> usize {
        let mut so_far = 0;
        let enough = |found: &u64| {
            so_far += found;
            so_far * 100 >= self.faults * percent
        };
        self.by_scan.iter().position(enough).map_or(0, |at| at + 1)
    }
}

/// What became of the faults of one class.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ClassReport {
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
    pub mechanisms: BTreeMap<Mechanism, MechanismReport>,
    /// Faults that let a wrong output out, as `--replay` takes them; at most 100.
    pub misses: Vec<String>,
}

impl ClassReport {
    pub(super) fn new(class: Class, population: u64) -> ClassReport {
        ClassReport {
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

    pub(super) fn count(&mut self, fault: Fault, outcome: Outcome) {
        self.injected += 1;
        match outcome {
            Outcome::Masked => self.masked += 1,
            Outcome::Latent => self.latent += 1,
            Outcome::Detected(mechanism, scans) => {
                self.detected += 1;
                self.mechanisms.entry(mechanism).or_default().found(scans);
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

    /// Adds what was counted elsewhere of the same places.
    pub(super) fn add(&mut self, other: ClassReport) {
        self.injected += other.injected;
        self.impossible += other.impossible;
        self.masked += other.masked;
        self.latent += other.latent;
        self.detected += other.detected;
        self.off += other.off;
        self.let_out += other.let_out;
        for (mechanism, found) in &other.mechanisms {
            self.mechanisms.entry(*mechanism).or_default().add(found);
        }
        self.misses.extend(other.misses);
    }
}

/// Some classes together.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
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
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
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
            class.cover();
        }
        let groups = summaries(&classes);
        Report { seed, scans, follow, groups, classes }
    }

    /// Faults that let a wrong output out.
    pub fn let_out(&self) -> u64 {
        self.classes.iter().map(|class| class.let_out).sum()
    }

    /// Faults that were injected.
    pub fn injected(&self) -> u64 {
        self.classes.iter().map(|class| class.injected).sum()
    }
}

impl ClassReport {
    /// Those found or off, and those that a run showed.
    fn effective(&self) -> (u64, u64) {
        let good = self.detected + self.off;
        (good, good + self.let_out)
    }

    fn cover(&mut self) {
        let (good, all) = self.effective();
        self.coverage = (all > 0).then(|| Coverage::of(good, all));
    }
}

/// Classes by their groups.
pub fn summaries(classes: &[ClassReport]) -> Vec<Summary> {
    let summary = |group: Group| {
        let of = || classes.iter().filter(|class| class.group == group);
        of().next()?;
        let (good, all) = of().map(ClassReport::effective).fold((0, 0), |(a, b), (c, d)| (a + c, b + d));
        Some(Summary {
            group,
            injected: of().map(|class| class.injected).sum(),
            effective: all,
            let_out: of().map(|class| class.let_out).sum(),
            coverage: Coverage::of(good, all),
        })
    };
    [Group::Channel, Group::Shared, Group::Residual].into_iter().filter_map(summary).collect()
}

/// What each mechanism found.
pub fn mechanisms(classes: &[ClassReport]) -> BTreeMap<Mechanism, MechanismReport> {
    let mut all: BTreeMap<Mechanism, MechanismReport> = BTreeMap::new();
    for (mechanism, found) in classes.iter().flat_map(|class| &class.mechanisms) {
        all.entry(*mechanism).or_default().add(found);
    }
    all
}

/// The classes of several projects, those of one name together: other places, so they add up, too.
pub fn together<'c>(classes: impl IntoIterator<Item = &'c ClassReport>) -> Vec<ClassReport> {
    let mut sums: Vec<ClassReport> = Vec::new();
    for class in classes {
        match sums.iter_mut().find(|sum| sum.name == class.name) {
            Some(sum) => {
                sum.population += class.population;
                sum.add(class.clone());
            }
            None => sums.push(class.clone()),
        }
    }
    sums.iter_mut().for_each(ClassReport::cover);
    sums
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
        for (mechanism, found) in mechanisms(&self.classes) {
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
