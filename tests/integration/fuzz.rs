//! `twinrung fuzz`: it finds what was put in, makes it small, and what it writes shows it again.

use std::fs;

use twinrung_primary::Primary;
use twinrung_workbench::fuzz::{Case, Contest, Failure, Outcome, Pairs, Ran, Subject, ran, replay};
use twinrung_workbench::generate::{self, Genome, Size};

use crate::command::twinrung;
use crate::wrong_partner::{Defect, WrongPartner};

/// A clock that counts in steps of 2 ms.
struct CoarseClock;

impl Defect for CoarseClock {
    fn clock(now_ms: i64, _: bool) -> i64 {
        now_ms & !1
    }
}

type Coarse = Pairs<Primary, WrongPartner<CoarseClock>>;

/// The same clock, but only while nobody listens to the channel, or only while somebody does.
struct CoarseWhile<const OBSERVED: bool>;

impl<const OBSERVED: bool> Defect for CoarseWhile<OBSERVED> {
    fn clock(now_ms: i64, observed: bool) -> i64 {
        if observed == OBSERVED { now_ms & !1 } else { now_ms }
    }
}

/// The first program on which a coarse clock shows.
fn found() -> Box<Failure> {
    found_by::<Coarse>()
}

fn found_by<C: Contest>() -> Box<Failure> {
    let failed = |seed| match ran::<C>(seed, &Genome::of_seed(seed), Size::SMALL, 60) {
        Ran::Failed(failure) => Some(failure),
        Ran::Agreed(_) | Ran::Refused { .. } => None,
    };
    let mut failure = (1..100).find_map(failed).expect("a coarse clock shows in a timer");
    failure.shrink::<C>();
    failure
}

/// REQ-FUZZ-001
#[test]
fn campaign_when_one_channel_has_a_defect_then_it_is_found_and_made_small() {
    let failure = found();
    let whole = generate::program(failure.number, Size::SMALL).text;
    assert!(failure.case.text.lines().count() * 3 < whole.lines().count(), "{failure}");
    assert!(failure.smallest.contains("the channels differ in"), "{failure}");
}

/// REQ-FUZZ-001. A channel may execute on another way when nobody listens; both ways of both channels are compared.
#[test]
fn campaign_when_a_defect_shows_only_with_or_only_without_an_observer_then_it_is_found_in_either_channel() {
    found_by::<Pairs<WrongPartner<CoarseWhile<true>>, Primary>>();
    found_by::<Pairs<WrongPartner<CoarseWhile<false>>, Primary>>();
    found_by::<Pairs<Primary, WrongPartner<CoarseWhile<true>>>>();
    found_by::<Pairs<Primary, WrongPartner<CoarseWhile<false>>>>();
}

/// REQ-FUZZ-002
#[test]
fn case_when_written_and_read_again_then_it_shows_the_same_difference() {
    let failure = found();
    let subject = Subject::from_text(&failure.case.text).unwrap();
    let read = Case::read(failure.case.text.clone(), &failure.case.to_csv(), &subject.image).unwrap();
    let Outcome::Failed { report, .. } = replay::<Coarse>(&read.text, &read.stimulus) else { panic!("it is gone") };
    assert_eq!(report, failure.smallest);
}

/// REQ-FUZZ-002
#[test]
fn case_when_of_any_program_then_its_inputs_read_back_as_they_were_written() {
    for seed in 0..20 {
        let generated = generate::program(seed, Size::SMALL);
        let Ok(subject) = Subject::from_text(&generated.text) else { continue };
        let stimulus = generate::stimulus(seed, &generated, 40);
        let written = Case { text: generated.text, stimulus }.to_csv();
        let read = Case::read(String::new(), &written, &subject.image).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(read.to_csv(), written, "seed {seed}");
    }
}

/// REQ-FUZZ-003
#[test]
fn command_when_the_channels_agree_then_it_says_what_was_run_and_what_was_reached() {
    let folder = tempfile::tempdir().unwrap();
    let report = folder.path().join("report.json");
    let shown = report.to_str().unwrap();
    let said =
        twinrung(&["fuzz", "--programs", "24", "--scans", "40", "--jobs", "2", "--time", "10m", "--report", shown]);
    assert_eq!(said.code, Some(0), "{}{}", said.out, said.err);
    assert!(said.out.starts_with("24 programs, "), "{}", said.out);
    assert!(said.out.contains(" 0 failures; on purpose ") && said.out.contains("\nreached: "), "{}", said.out);
    let report: serde_json::Value = serde_json::from_slice(&fs::read(report).unwrap()).unwrap();
    assert_eq!((&report["programs"], &report["differences"]), (&24.into(), &serde_json::json!([])));
}

/// REQ-FUZZ-003
#[test]
fn command_when_given_a_case_then_it_runs_it_or_says_what_is_wrong_with_it() {
    let folder = tempfile::tempdir().unwrap();
    let generated = generate::program(3, Size::SMALL);
    let stimulus = generate::stimulus(3, &generated, 20);
    let case = Case { text: generated.text, stimulus };
    let path = folder.path().join("case.rll");
    fs::write(&path, &case.text).unwrap();
    let shown = path.to_str().unwrap();
    let missing = twinrung(&["fuzz", "--replay", shown]);
    assert_eq!(missing.code, Some(2), "{}", missing.err);
    assert!(missing.err.contains("case.csv"), "{}", missing.err);
    fs::write(path.with_extension("csv"), case.to_csv()).unwrap();
    let said = twinrung(&["fuzz", "--replay", shown]);
    assert_eq!((said.code, said.out.contains("21 steps, no difference")), (Some(0), true), "{}{}", said.out, said.err);
    fs::write(path.with_extension("csv"), "ms,step,budget,system_values\n0,jump,100,\n").unwrap();
    let broken = twinrung(&["fuzz", "--replay", shown]);
    assert_eq!(broken.code, Some(2));
    assert!(broken.err.contains("line 2: `jump` is neither scan nor prescan"), "{}", broken.err);
    fs::write(path.with_extension("csv"), "ms,step,budget,system_values\n0,scan,100,\n10,scan,200,\n").unwrap();
    let blurred = twinrung(&["fuzz", "--replay", shown]);
    assert!(blurred.err.contains("line 3: every step of a case has one budget"), "{}", blurred.err);
}
