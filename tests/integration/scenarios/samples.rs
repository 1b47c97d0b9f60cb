//! The scenarios of the samples.

use std::fs;

use twinrung_partner::Partner;
use twinrung_primary::Primary;
use twinrung_workbench::Signal;
use twinrung_workbench::coverage::Coverage;
use twinrung_workbench::generate::Random;
use twinrung_workbench::names;
use twinrung_workbench::scenario::{Action, Change, Scenario, play};

use super::support::{failures, image, missing, report};
use crate::support::{project_path, text};

/// Samples, and those with scenarios.
pub fn all() -> Vec<String> {
    with("project.rll")
}

/// Samples that hold a file.
pub fn with(file: &str) -> Vec<String> {
    let entries = fs::read_dir(project_path("samples")).unwrap().map(|entry| entry.unwrap());
    let mut names: Vec<String> = entries
        .filter(|entry| entry.path().join(file).is_file())
        .map(|entry| entry.file_name().to_string_lossy().into_owned())
        .collect();
    names.sort();
    names
}

/// REQ-TEST-030
#[test]
fn samples_when_their_scenarios_are_played_then_all_are_met_and_nothing_is_missing() {
    let samples = with("project.scenario");
    assert!(samples.len() >= 3, "{samples:?}");
    for sample in samples {
        let folder = project_path("samples").join(&sample);
        let found = report(&text(&folder.join("project.rll")), &text(&folder.join("project.scenario")));
        assert_eq!(failures(&found), [] as [String; 0], "{sample}");
        assert_eq!(missing(&found), [] as [&str; 0], "{sample}");
        assert_eq!((found.coverage.percent, found.coverage.minimum), (100, Some(100)), "{sample}");
        assert_eq!((found.coverage.needless.len(), found.coverage.doubts), (0, (0, 0)), "{sample}");
    }
}

/// Scans of a project whose inputs move at random.
const SCANS: u64 = 400;

/// What the observer left out while the inputs of a project moved at random.
pub fn moved_at_random(project: &str) -> (u64, u64) {
    let loaded = image(project);
    let (image, bytes) = &loaded;
    let period_ms = u64::from(image.image().task.as_ref().unwrap().period_us / 1000);
    let inputs: Vec<(String, Signal)> = image
        .frozen()
        .iter()
        .flat_map(|range| names::values_of(image, range.tag))
        .filter(|(_, signal)| matches!(signal, Signal::Bit(_)))
        .collect();
    let mut random = Random::new(7);
    let mut actions = Vec::new();
    for scan in 0..SCANS {
        for (name, signal) in &inputs {
            let change =
                Change::Drive { name: name.clone(), signal: *signal, content: i32::from(random.below(2) == 1) };
            let action = Action { at_ms: scan * period_ms, change };
            actions.extend((scan == 0 || random.below(8) == 0).then_some(action));
        }
    }
    let scenario = Scenario {
        name: "random".to_owned(),
        span: twinrung_grammar::tree::Span::default(),
        power_up: twinrung_grammar::tree::scenario::Mode::Run,
        actions,
        expectations: Vec::new(),
        sites: std::sync::Arc::default(),
        end_ms: SCANS * period_ms,
    };
    let mut coverage = Coverage::new(image);
    let played = play::<Primary, Partner>(image, bytes, &scenario, &mut coverage).unwrap();
    assert_eq!(played.stopped, None);
    coverage.doubts()
}
