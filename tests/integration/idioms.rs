//! The ladder routines of real exports as safety programs: each is converted (its tags declared Safety, what it uses
//! carried over) and compiled for a 1756-L73S. A routine that is certified through and through compiles and runs alike on
//! primary, partner and judge; any other is refused for an instruction, a type or a rule that has a name.

mod certified;
mod convert;
mod module_tags;
mod run;
mod scaffold;
mod walk;

use std::collections::{BTreeMap, BTreeSet};

use twinrung_grammar::read_path;
use twinrung_grammar::tree::Sources;
use twinrung_trio::Subject;

use self::certified::{Stop, stops};
use self::convert::{Idiom, idioms};
use self::run::Ran;
use crate::corpus::exports;
use crate::support::shared_path;

/// Rules that stop routines of the corpus although all their instructions and types are listed: code, words of the finding,
/// and why the rule is right.
const RULES: &[(&str, &str, &str)] = &[
    (
        "E0302",
        "expected SINT, INT, DINT or REAL, found STRING",
        "compares and moves take numbers; strings came later, to standard logic",
    ),
    (
        "E0302",
        "expected a number or an array of numbers, found",
        "FLL into a structure would copy bytes without regard to its members",
    ),
    ("E0408", "its layout is not published", "Table 7 lists FBD types, but no certified instruction uses one"),
    ("S0105", "not a constant", "footnote 3 of Table 12: what a copy reaches is known before it runs"),
    ("S0107", "the safety task cannot reach", "footnote 4 of Table 12: safety attributes only"),
];

/// Codes that say that an instruction, an operator, a language, a type or a name is not admitted or not there.
const NOT_CERTIFIED: &[&str] = &["S0101", "S0104", "S0109", "S0201", "E0201", "E0203"];

/// What came of a routine.
struct Outcome {
    idiom: Idiom,
    file: String,
    stops: BTreeSet<Stop>,
    /// Findings as `code line:column message`; none when it compiles.
    findings: Vec<String>,
    ran: Ran,
}

impl Outcome {
    fn codes(&self) -> BTreeSet<&str> {
        self.findings.iter().map(|finding| &finding[..5]).collect()
    }

    fn words(&self) -> String {
        let stops: Vec<String> = self.stops.iter().map(Stop::to_string).collect();
        let codes: Vec<&str> = self.codes().into_iter().collect();
        let stubs = if self.idiom.stubs.is_empty() { String::new() } else { format!(", stubs {:?}", self.idiom.stubs) };
        match (self.findings.is_empty(), stops.is_empty()) {
            (true, _) => format!("compiles{stubs}"),
            (false, true) => format!("stopped by a rule: {}", self.findings.join("; ")),
            (false, false) => format!("{} ({}{stubs})", stops.join(", "), codes.join(" ")),
        }
    }
}

fn compile(file: &str, idiom: Idiom, known: &mut BTreeMap<String, (Vec<String>, Ran)>) -> Outcome {
    let (findings, ran) = known.entry(idiom.text.clone()).or_insert_with(|| match Subject::from_text(&idiom.text) {
        Err(findings) => (findings, Ran::default()),
        Ok(subject) => (Vec::new(), run::scans(&subject, &idiom.name)),
    });
    let (findings, ran) = (findings.clone(), *ran);
    Outcome { stops: stops(&idiom), idiom, file: file.to_owned(), findings, ran }
}

fn print(outcomes: &[Outcome]) {
    for one in outcomes {
        println!("{:<45} {:<60} {:>4} rungs: {}", one.file, one.idiom.name, one.idiom.rungs, one.words());
    }
    let mut counts: BTreeMap<String, usize> = BTreeMap::new();
    for one in outcomes {
        one.stops.iter().for_each(|stop| *counts.entry(stop.to_string()).or_default() += 1);
        if one.stops.is_empty() {
            one.codes().iter().for_each(|code| *counts.entry(format!("rule {code}")).or_default() += 1);
        }
    }
    let mut counts: Vec<(String, usize)> = counts.into_iter().collect();
    counts.sort_by_key(|(name, count)| (usize::MAX - count, name.clone()));
    println!("\nwhat stops how many routines:");
    counts.iter().for_each(|(what, count)| println!("{count:>5} {what}"));
    println!("\nrules that stop certified routines, and why:");
    RULES.iter().for_each(|(code, words, why)| println!("      {code} ({words}): {why}"));
    let total = |wanted: fn(&Outcome) -> bool| {
        let chosen = outcomes.iter().filter(|one| wanted(one));
        chosen.fold((0, 0), |(routines, rungs), one| (routines + 1, rungs + one.idiom.rungs))
    };
    println!("\n(routines, rungs): all {:?}", total(|_| true));
    println!("instructions and types certified {:?}", total(|one| one.stops.is_empty()));
    println!("of these compiled and run alike {:?}", total(|one| one.stops.is_empty() && one.findings.is_empty()));
    let sum = |of: fn(&Ran) -> u64| outcomes.iter().map(|one| of(&one.ran)).sum::<u64>();
    let (scans, faulted) = (sum(|ran| ran.scans), sum(|ran| ran.faulted));
    println!(
        "{scans} scans ({faulted} ended with a fault), {} instructions, no difference",
        sum(|ran| ran.instructions)
    );
}

#[test]
fn corpus_routines_when_converted_to_safety_then_the_certified_ones_compile_and_run_alike() {
    let Some(corpus) = shared_path("corpus") else { return };
    let mut outcomes = Vec::new();
    let mut known = BTreeMap::new();
    for path in exports(&corpus) {
        let file = path.strip_prefix(&corpus).unwrap().display().to_string();
        let export = read_path(&mut Sources::new(), &path).file;
        outcomes.extend(idioms(&export).into_iter().map(|idiom| compile(&file, idiom, &mut known)));
    }
    print(&outcomes);
    let is_rule =
        |finding: &String| RULES.iter().any(|(code, words, _)| finding.starts_with(code) && finding.contains(words));
    let is_expected = |one: &&Outcome| match (one.stops.is_empty(), one.findings.is_empty()) {
        (true, _) => one.findings.iter().all(is_rule),
        (false, true) => false,
        (false, false) => one.codes().iter().any(|code| NOT_CERTIFIED.contains(code)),
    };
    let wrong: Vec<String> = outcomes
        .iter()
        .filter(|one| !is_expected(one))
        .map(|one| format!("{} {}: {}", one.file, one.idiom.name, one.words()))
        .collect();
    assert!(wrong.is_empty(), "{wrong:#?}");
}
