//! Campaigns: what they reach, what guides them, what they keep, and what they add up to.

use std::fs;
use std::time::Duration;

use twinrung_partner::Partner;
use twinrung_primary::Primary;
use twinrung_workbench::fuzz::{Campaign, Pairs, Plan, Point, Report, Told};
use twinrung_workbench::generate::{self, Genome, Size};
use twinrung_workbench::provenance::Provenance;

use crate::command::twinrung;
use crate::wrong_partner::{Defect, WrongPartner};

type Both = Pairs<Primary, Partner>;

/// Longer than any of these campaigns takes: their programs are counted.
const LONG: Duration = Duration::from_secs(3_600);

fn plan(programs: u64) -> Plan {
    Plan {
        time: LONG,
        seed: 1,
        programs,
        scans: None,
        rungs: None,
        jobs: 2,
        differences: usize::MAX,
        as_found: true,
        guided: false,
        earlier: Vec::new(),
    }
}

/// REQ-FUZZ-004
#[test]
fn campaign_when_bounded_and_seeded_then_nothing_is_missing_that_is_not_argued_to_be_out_of_reach() {
    let campaign = plan(12_000).run::<Both>(|_| ());
    let coverage = &campaign.total.executions.coverage;
    let shown = |points: Vec<Point>| points.iter().map(ToString::to_string).collect::<Vec<String>>();
    assert_eq!(shown(coverage.missing()), Vec::<String>::new(), "not reached");
    assert_eq!(
        shown(coverage.against_the_table()),
        Vec::<String>::new(),
        "reached, though it is said to be out of reach"
    );
    assert!(campaign.refused * 20 < campaign.programs, "more than 5 % are refused: {:?}", campaign.reasons);
}

/// A status bit of the partner's clock is stuck: nothing is later than it was at first.
struct StandingClock;

impl Defect for StandingClock {
    fn clock(_: i64, _: bool) -> i64 {
        0
    }
}

/// REQ-FUZZ-005
#[test]
fn guided_campaign_when_one_channel_has_a_defect_then_it_ends_with_the_difference() {
    let guided = Plan { guided: true, jobs: 1, differences: 1, ..plan(2_000) };
    let campaign = guided.run::<Pairs<Primary, WrongPartner<StandingClock>>>(|_| ());
    assert_eq!(campaign.failures.len(), 1);
    assert!(campaign.programs < 2_000, "it ran to its end: {campaign}");
}

fn kept(earlier: Vec<Genome>) -> (Campaign, Vec<Genome>) {
    let mut kept = Vec::new();
    let guided = Plan { guided: true, jobs: 1, earlier, ..plan(200) };
    let campaign = guided.run::<Both>(|told| {
        if let Told::Kept(genome) = told {
            kept.push(genome.clone());
        }
    });
    (campaign, kept)
}

/// REQ-FUZZ-005
#[test]
fn guided_campaign_when_run_twice_on_one_thread_then_it_keeps_the_same_and_what_it_kept_is_new_again_at_first() {
    let (first, second) = (kept(Vec::new()), kept(Vec::new()));
    assert!(!first.1.is_empty());
    assert_eq!(first.1, second.1);
    let again = kept(first.1.iter().take(10).cloned().collect());
    assert_eq!(again.1.first(), first.1.first(), "the first that is run again reaches what nobody had reached");
}

/// REQ-FUZZ-002
#[test]
fn genome_when_completed_then_it_gives_the_same_program_and_inputs_whatever_its_seed() {
    for seed in 0..40 {
        let (program, inputs, whole) = generate::of_genome(&Genome::of_seed(seed), Size::TINY, 30);
        let (again, moved, same) = generate::of_genome(&Genome { seed: seed + 1_000, ..whole.clone() }, Size::TINY, 30);
        // A NaN is equal to nothing, so the inputs are compared as text.
        assert_eq!((&program, format!("{inputs:?}")), (&again, format!("{moved:?}")), "seed {seed}");
        assert_eq!((&whole.program, &whole.inputs), (&same.program, &same.inputs), "seed {seed}");
    }
}

/// REQ-FUZZ-005
#[test]
fn command_when_given_a_corpus_then_it_writes_what_reached_something_new_and_reads_it_again() {
    let folder = tempfile::tempdir().unwrap();
    let corpus = folder.path().join("corpus");
    let shown = corpus.to_str().unwrap();
    let run = || twinrung(&["fuzz", "--programs", "40", "--jobs", "1", "--time", "10m", "--corpus", shown]);
    let first = run();
    assert_eq!(first.code, Some(0), "{}{}", first.out, first.err);
    let written = fs::read_dir(&corpus).unwrap().count();
    assert!(written > 0);
    assert_eq!(run().code, Some(0));
    fs::write(corpus.join("broken.json"), "{}").unwrap();
    let broken = run();
    assert_eq!(broken.code, Some(2), "{}", broken.out);
    assert!(broken.err.contains("broken.json"), "{}", broken.err);
}

/// REQ-FUZZ-006
#[test]
fn command_when_its_programs_are_beyond_a_limit_then_that_is_no_difference() {
    let said =
        twinrung(&["fuzz", "--rungs", "2000", "--programs", "2", "--scans", "1", "--jobs", "1", "--time", "10m"]);
    assert_ne!(said.code, Some(1), "{}{}", said.out, said.err);
    assert!(!said.out.contains("panic"), "{}", said.out);
    let beyond = twinrung(&["fuzz", "--rungs", "2001"]);
    assert_eq!(beyond.code, Some(2));
    assert!(beyond.err.contains("2001 is not in 1..=2000"), "{}", beyond.err);
}

/// REQ-FUZZ-003
#[test]
fn reports_when_added_then_counts_add_up_and_only_what_none_has_reached_is_missing() {
    let provenance = Provenance { jobs: 2, seconds: 2.0, ..Provenance::default() };
    let reports = [1, 500].map(|seed| {
        let plan = Plan { seed, ..plan(30) };
        Report::new(&plan.run::<Both>(|_| ()), &plan, false, provenance.clone())
    });
    let mut sum = reports[0].clone();
    sum.add(&reports[1]);
    assert_eq!((sum.programs, sum.scans), (60, reports[0].scans + reports[1].scans));
    assert_eq!((sum.seconds, sum.thread_seconds, sum.seeds.as_slice()), (4.0, 8.0, &[1, 500][..]));
    let least = reports.iter().map(|report| report.points_missing.len()).min().unwrap();
    assert!(sum.points_missing.len() < least, "{} of {least}", sum.points_missing.len());
    assert_eq!(sum.runs.iter().map(|run| (run.seed, run.programs)).collect::<Vec<_>>(), [(1, 30), (500, 30)]);
}

/// REQ-FUZZ-003. A point that one table argues away and the other demands is not reached because one does not miss it.
#[test]
fn reports_when_added_that_knew_different_tables_then_what_the_larger_misses_is_missing() {
    let of = |reachable: usize, missing: &[&str]| {
        let report = Report::new(&Campaign::default(), &plan(1), false, Provenance::default());
        let points_missing = missing.iter().map(|point| (*point).to_owned()).collect();
        Report { points_reachable: reachable, points_missing, ..report }
    };
    let sum = |mut one: Report, other: &Report| {
        one.add(other);
        (one.points_reachable, one.points_missing)
    };
    let (small, large) = (of(9, &["a"]), of(10, &["a", "b"]));
    assert_eq!(sum(small.clone(), &large), (10, vec!["a".to_owned(), "b".to_owned()]));
    assert_eq!(sum(large, &small), (10, vec!["a".to_owned(), "b".to_owned()]));
}

/// REQ-FUZZ-003
#[test]
fn command_when_its_report_is_there_already_then_it_adds_to_it_and_one_that_it_cannot_read_it_leaves() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("report.json");
    let run = || {
        let shown = path.to_str().unwrap();
        twinrung(&["fuzz", "--programs", "3", "--scans", "3", "--jobs", "1", "--time", "10m", "--report", shown])
    };
    assert_eq!((run().code, run().code), (Some(0), Some(0)));
    let report: Report = serde_json::from_slice(&fs::read(&path).unwrap()).unwrap();
    assert_eq!((report.programs, report.seeds.len(), report.runs.len()), (6, 2, 2));
    let provenance = &report.runs[0].provenance;
    assert_eq!((provenance.jobs, provenance.version.as_str()), (1, env!("CARGO_PKG_VERSION")));
    let later = serde_json::to_string(&Report { schema: 999, ..report }).unwrap();
    for text in ["{}", &later] {
        fs::write(&path, text).unwrap();
        let said = run();
        assert_eq!((said.code, fs::read_to_string(&path).unwrap().as_str()), (Some(2), text), "{}", said.err);
        assert!(said.err.contains("report.json: "), "{}", said.err);
    }
}
