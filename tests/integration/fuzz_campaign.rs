//! Campaigns: what they reach, what guides them, what they keep, and what they add up to.

use std::fs;
use std::time::Duration;

use twinrung_partner::Partner;
use twinrung_primary::Primary;
use twinrung_workbench::fuzz::{Campaign, Pairs, Plan, Point, Report, Told};
use twinrung_workbench::generate::{self, Genome, Size};

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
    let campaign = plan(16_000).run::<Both>(|_| ());
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
    let guided = Plan { guided: true, jobs: 1, earlier, ..plan(120) };
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
    let took = Duration::from_secs(2);
    let reports = [1, 500].map(|seed| {
        let plan = Plan { seed, ..plan(30) };
        Report::new(&plan.run::<Both>(|_| ()), &plan, took)
    });
    let mut sum = reports[0].clone();
    sum.add(&reports[1]);
    assert_eq!((sum.programs, sum.scans), (60, reports[0].scans + reports[1].scans));
    assert_eq!((sum.seconds, sum.thread_seconds, sum.seeds.as_slice()), (4.0, 8.0, &[1, 500][..]));
    let least = reports.iter().map(|report| report.points_missing.len()).min().unwrap();
    assert!(sum.points_missing.len() < least, "{} of {least}", sum.points_missing.len());
}
