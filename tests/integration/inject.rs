//! Campaigns of faults over the samples, bounded and from seeds.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::atomic::AtomicU64;

use twinrung_bytecode::injection::Injectable;
use twinrung_partner::Partner;
use twinrung_primary::Primary;
use twinrung_workbench::inject::{Campaign, Coverage, Fault, Group, Outcome, Plan, Report, Subject, random};

use crate::command::twinrung;
use crate::support::{image_of, project_path, read_whole, stimulus};

/// Scans of an undisturbed run, and scans that a fault is followed for.
const SCANS: u32 = 60;
const FOLLOW: u32 = 20;

fn samples() -> Vec<PathBuf> {
    let folders = fs::read_dir(project_path("samples")).unwrap().map(|entry| entry.unwrap().path());
    let mut folders: Vec<PathBuf> = folders.filter(|folder| folder.join("stimulus.csv").is_file()).collect();
    folders.sort();
    folders
}

fn subject<A: Injectable, B: Injectable>(folder: &Path) -> Subject<A, B> {
    let (image, bytes) = image_of(&read_whole(&folder.join("project.rll")));
    Subject::new(&image, &bytes, &stimulus(&folder.join("stimulus.csv")), &[], SCANS).unwrap()
}

fn report<A, B>(subject: &Subject<A, B>, injections: u64, jobs: usize, group: Group) -> Report
where
    A: Injectable + Send + Sync,
    B: Injectable + Send + Sync,
{
    let plan = Plan { injections, seed: 1, follow: FOLLOW, jobs, groups: vec![group], only: None };
    Campaign::new(subject, plan).run(&AtomicU64::new(0))
}

fn misses(report: &Report) -> Vec<String> {
    report.classes.iter().flat_map(|class| class.misses.clone()).collect()
}

fn estop() -> Subject<Primary, Partner> {
    subject(&project_path("samples/estop-with-contactors"))
}

/// REQ-INJECT-002
#[test]
fn samples_when_one_channel_is_disturbed_then_no_wrong_output_is_let_out() {
    let mut detected = 0;
    for folder in samples() {
        let report = report(&subject::<Primary, Partner>(&folder), 2_000, 1, Group::Channel);
        assert_eq!(misses(&report), Vec::<String>::new(), "{}", folder.display());
        detected += report.groups[0].effective;
    }
    assert!(detected > 5_000, "only {detected} faults were shown by a run");
}

/// REQ-INJECT-003
#[test]
fn samples_when_what_both_channels_share_is_disturbed_then_no_wrong_output_is_let_out() {
    for folder in samples() {
        let report = report(&subject::<Primary, Partner>(&folder), 1_500, 1, Group::Shared);
        assert_eq!(misses(&report), Vec::<String>::new(), "{}", folder.display());
        assert!(report.injected() > 1_000);
    }
}

/// REQ-INJECT-002
#[test]
fn campaign_when_it_has_run_then_every_class_of_faults_in_a_channel_was_injected() {
    let report = report(&estop(), 2_000, 1, Group::Channel);
    let without: Vec<&str> =
        report.classes.iter().filter(|class| class.injected == 0).map(|class| class.name.as_str()).collect();
    assert_eq!(without, Vec::<&str>::new());
}

/// REQ-INJECT-004
#[test]
fn campaign_when_run_with_one_thread_or_three_then_the_report_is_the_same() {
    let subject = estop();
    let text = |jobs| serde_json::to_string(&report(&subject, 1_000, jobs, Group::Channel)).unwrap();
    assert_eq!(text(1), text(3));
}

/// REQ-INJECT-005, REQ-INJECT-006. Two primaries in which the same goes wrong have nothing that a comparison could find.
#[test]
fn campaign_when_both_channels_are_alike_and_disturbed_alike_then_wrong_outputs_are_reported_and_replayed() {
    let alike: Subject<Primary, Primary> = subject(&project_path("samples/estop-with-contactors"));
    let report = report(&alike, 4_000, 1, Group::Residual);
    let found: Vec<Fault> = misses(&report)
        .iter()
        .filter(|miss| miss.contains("channels.program."))
        .map(|miss| miss.parse().unwrap())
        .collect();
    assert!(!found.is_empty(), "{report}");
    let again: Vec<Outcome> = found.iter().map(|fault| alike.replay(*fault, FOLLOW)).collect();
    assert!(again.iter().all(|outcome| matches!(outcome, Outcome::LetOut(_))), "{again:?}");
    let real = estop();
    let apart: Vec<Outcome> = found.iter().map(|fault| real.replay(*fault, FOLLOW)).collect();
    assert!(!apart.iter().any(|outcome| matches!(outcome, Outcome::LetOut(_))), "channels that differ: {apart:?}");
}

/// REQ-INJECT-001, REQ-INJECT-007
#[test]
fn report_when_faults_were_counted_then_each_is_in_one_column_and_the_coverage_is_of_those_that_were_shown() {
    let report = report(&estop(), 2_000, 1, Group::Residual);
    for class in &report.classes {
        let columns = class.masked + class.latent + class.impossible + class.detected + class.off + class.let_out;
        assert_eq!(columns, class.injected, "{}", class.name);
        let shown = class.detected + class.off + class.let_out;
        let expected = (shown > 0).then(|| Coverage::of(class.detected + class.off, shown));
        assert_eq!(class.coverage, expected, "{}", class.name);
    }
    assert!(report.let_out() > 0, "a wire that says the wrong thing is not seen by a controller");
}

/// REQ-INJECT-004
#[test]
fn random_inputs_when_drawn_twice_by_one_seed_then_they_are_the_same() {
    let (image, _) = image_of(&read_whole(&project_path("samples/estop-with-contactors/project.rll")));
    assert_eq!(random(&image, 50, 7), random(&image, 50, 7));
    assert_ne!(random(&image, 50, 7), random(&image, 50, 8));
}

/// REQ-INJECT-005
#[test]
fn command_when_wrong_outputs_were_let_out_then_it_ends_with_one_and_its_misses_are_replayed() {
    let sample = "samples/estop-with-contactors";
    let said = twinrung(&["inject", sample, "--injections", "400", "--group", "residual", "--format", "json"]);
    assert_eq!(said.code, Some(1), "{}", said.err);
    let report: serde_json::Value = serde_json::from_str(&said.out).unwrap();
    let classes = report["classes"].as_array().unwrap();
    let misses = classes.iter().flat_map(|class| class["misses"].as_array().unwrap());
    let miss = misses.map(|miss| miss.as_str().unwrap()).next().unwrap();
    let again = twinrung(&["inject", sample, "--replay", miss]);
    assert_eq!(again.code, Some(1));
    assert!(again.out.contains("a wrong output was let out"), "{}", again.out);
}

#[test]
fn command_when_no_wrong_output_was_let_out_then_it_ends_with_zero_and_says_the_coverage() {
    let sample = "samples/estop-with-contactors";
    let said = twinrung(&["inject", sample, "--injections", "600", "--jobs", "1"]);
    assert_eq!(said.code, Some(0), "{}", said.out);
    assert!(said.out.contains("diagnostic coverage 100.0000 %"), "{}", said.out);
}

#[test]
fn command_when_a_fault_or_a_file_is_none_then_it_says_so_and_ends_with_two() {
    let sample = "samples/estop-with-contactors";
    for arguments in [
        ["inject", sample, "--replay", "17:nothing:1"],
        ["inject", "samples/none", "--seed", "1"],
        ["inject", sample, "--only", "nothing"],
    ] {
        let said = twinrung(&arguments);
        assert_eq!(said.code, Some(2), "{arguments:?} {}", said.out);
        assert!(!said.err.is_empty(), "{arguments:?}");
    }
}
