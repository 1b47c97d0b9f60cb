//! The evidence, read from small reports that stay as they are.

use std::fs;
use std::path::PathBuf;

use twinrung_workbench::evidence::{Evidence, EvidenceError, FLOORS, File, Sources, State, page};
use twinrung_workbench::fuzz::{Coverage, Report};
use twinrung_workbench::provenance::Provenance;

fn path(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/evidence").join(name)
}

/// A file of this test, as it would stand in a project.
fn file(name: &str, bytes: Vec<u8>) -> File {
    File { name: name.to_owned(), bytes }
}

fn read(place: &str, name: &str) -> File {
    file(place, fs::read(path(name)).unwrap())
}

/// A report of a campaign that knew the points that this release knows.
fn campaign(place: &str, name: &str) -> File {
    let report: Report = serde_json::from_slice(&fs::read(path(name)).unwrap()).unwrap();
    let report = Report { points_reachable: Coverage::reachable(), ..report };
    file(place, serde_json::to_vec(&report).unwrap())
}

fn sources() -> Sources {
    let account = "[[difference]]\nwhat = \"Motor\"\nfound_by = \"twinrung fuzz\"\nwrong = \"partner\"\nmended = \"motor.table\"\n\
                   report = \"evidence/fuzz/a.json\"\nprogram = 398\n";
    Sources {
        fuzz: vec![campaign("evidence/fuzz/a.json", "fuzz.json"), campaign("evidence/fuzz/b.json", "fuzz-form-1.json")],
        inject: vec![
            read("evidence/inject/press.json", "inject.json"),
            read("evidence/inject/again.json", "inject.json"),
        ],
        differences: Some(file("evidence/differences.toml", account.into())),
        defects: vec![read("tests/defects/primary.toml", "primary.toml")],
        times: Some(read("tests/defects/times.toml", "times.toml")),
        mutants: vec![read("tests/mutants/controller.toml", "controller.toml")],
        independence: Some(read("docs/independence.md", "independence.md")),
        samples: vec!["samples/press".to_owned(), "samples/gate".to_owned()],
    }
}

fn evidence() -> Evidence {
    Evidence::read(&sources()).unwrap()
}

/// What was found for a floor.
fn found(evidence: &Evidence, id: &str) -> (Option<f64>, State) {
    let judged = evidence.floors.iter().find(|judged| judged.id == id).unwrap();
    (judged.value, judged.state)
}

fn refused(sources: &Sources) -> EvidenceError {
    Evidence::read(sources).unwrap_err()
}

/// The page without what depends on the catalog, and without the hashes of files that depend on it.
fn stable(page: &str) -> String {
    let (before, rest) = page.split_once("<h3>What was reached</h3>").unwrap();
    let (_, behind) = rest.split_once("<h3>Differences found").unwrap();
    let (behind, _) = behind.split_once("<h2>Where the figures come from</h2>").unwrap();
    format!("{before}<h3>Differences found{behind}")
}

/// REQ-EVIDENCE-001, REQ-EVIDENCE-007
#[test]
fn page_when_written_from_small_reports_then_it_is_what_was_reviewed() {
    let here = Provenance { version: "0.1.0".to_owned(), ..Provenance::default() };
    let page = page(&evidence(), &here);
    for outside in ["http", "src=", "@import", "url("] {
        assert!(!page.contains(outside), "the page needs nothing from elsewhere: {outside}");
    }
    assert!(page.contains("A &lt;fast&gt; one") && page.contains("twinrung fuzz --time 2h"));
    let stable = stable(&page);
    let reviewed = path("page.html");
    let bless = std::env::var_os("BLESS").map(|_| fs::write(&reviewed, &stable).unwrap());
    let expected = fs::read_to_string(&reviewed).unwrap();
    assert!(stable == expected, "not what was reviewed; BLESS=1 writes {} anew {bless:?}", reviewed.display());
}

/// REQ-EVIDENCE-002
#[test]
fn evidence_when_nothing_was_measured_then_no_floor_is_met_and_the_page_says_so_of_each_part() {
    let nothing = Evidence::read(&Sources::default()).unwrap();
    assert!(!nothing.is_met);
    assert!(nothing.floors.iter().all(|judged| judged.state == State::NotMeasured), "{:#?}", nothing.floors);
    let page = page(&nothing, &Provenance::default());
    assert_eq!(page.matches(">NOT MEASURED<").count() + page.matches(">NOT MEASURED\n").count(), FLOORS.len());
    for said in [
        "Not measured: there is no report of `twinrung fuzz --report`",
        "guided: not measured.",
        "Not measured: there is no report of `twinrung inject --report`",
        "vm/partner: not measured.",
        "docs/independence.md cannot be found",
    ] {
        assert!(page.contains(said), "{said}");
    }
}

/// REQ-EVIDENCE-002
#[test]
fn evidence_when_written_as_json_then_each_floor_stands_there_with_what_was_found() {
    let json = serde_json::to_value(evidence()).unwrap();
    assert_eq!((&json["schema"], &json["is_met"]), (&1.into(), &false.into()));
    let floors = json["floors"].as_array().unwrap();
    assert_eq!(floors.len(), FLOORS.len());
    let seconds = floors.iter().find(|floor| floor["id"] == "campaign.seconds").unwrap();
    assert_eq!((&seconds["value"], &seconds["state"]), (&10_800.0.into(), &"met".into()));
}

/// REQ-EVIDENCE-003
#[test]
fn campaigns_when_added_up_then_times_and_points_are_those_of_all() {
    let evidence = evidence();
    assert_eq!(found(&evidence, "campaign.seconds"), (Some(10_800.0), State::Met));
    assert_eq!(found(&evidence, "campaign.missing"), (Some(1.0), State::Below));
    let campaign = evidence.campaign.as_ref().unwrap();
    assert_eq!(
        (campaign.processor_seconds, campaign.processor_recorded.reached, campaign.processor_recorded.of),
        (9000.0, 1, 2)
    );
    let xic = campaign.coverage.iter().find(|one| one.mnemonic == "XIC").unwrap();
    assert_eq!(xic.outcomes.of - xic.outcomes.reached, 1);
}

/// REQ-EVIDENCE-003
#[test]
fn campaign_when_it_knew_another_table_then_the_points_that_one_alone_knows_are_missing() {
    let sources = Sources { fuzz: vec![read("evidence/fuzz/a.json", "fuzz.json")], ..sources() };
    let missing = Coverage::reachable() as f64 + 1.0;
    assert_eq!(found(&Evidence::read(&sources).unwrap(), "campaign.missing"), (Some(missing), State::Below));
}

/// REQ-EVIDENCE-003
#[test]
fn difference_when_a_report_names_it_and_nobody_has_accounted_for_it_then_it_is_open() {
    assert_eq!(found(&evidence(), "campaign.open"), (Some(0.0), State::Met));
    let open = Evidence::read(&Sources { differences: None, ..sources() }).unwrap();
    assert_eq!(found(&open, "campaign.open"), (Some(1.0), State::Below));
    assert!(page(&open, &Provenance::default()).contains("1 differences are OPEN"));
}

/// REQ-EVIDENCE-004
#[test]
fn defects_when_one_was_not_measured_then_it_counts_as_missed() {
    let evidence = evidence();
    assert_eq!(found(&evidence, "defects.listed"), (Some(3.0), State::Below));
    assert_eq!(found(&evidence, "defects.missed"), (Some(1.0), State::Below));
    assert_eq!(found(&evidence, "defects.quick").0.unwrap().round(), 33.0);
    assert_eq!((evidence.defects.plain.found, evidence.defects.plain.median), (0, None));
}

/// REQ-EVIDENCE-005
#[test]
fn injections_when_added_up_then_the_interval_is_that_of_the_sum_and_each_miss_has_its_command() {
    let evidence = evidence();
    let injection = evidence.injection.as_ref().unwrap();
    let class = injection.classes.iter().find(|class| class.name == "primary.cells.flip").unwrap();
    assert_eq!((class.population, class.injected, class.detected), (18_000, 2000, 1600));
    let lower = class.coverage.unwrap().lower;
    assert!((lower - 0.025_f64.powf(1.0 / 1600.0)).abs() < 1e-6, "{lower}");
    assert_eq!(injection.mechanisms[0].1.by_scan, [1400, 120, 80]);
    assert_eq!(
        injection.misses[0].replay,
        "twinrung inject samples/press --seed 7 --follow 50 --replay 17:wire.flip:3"
    );
    assert_eq!(found(&evidence, "injection.injected"), (Some(2000.0), State::Below));
    assert_eq!(found(&evidence, "injection.channel"), (Some(0.0), State::Met));
    assert_eq!(found(&evidence, "injection.shared"), (None, State::NotMeasured));
    assert_eq!(found(&evidence, "injection.samples"), (Some(1.0), State::Below));
    assert_eq!(found(&evidence, "injection.residual"), (Some(400.0), State::Met));
    assert!(found(&evidence, "injection.classes").0 > Some(50.0));
}

/// REQ-EVIDENCE-006
#[test]
fn mutants_when_a_survivor_has_no_reason_or_a_crate_no_result_then_that_is_below_the_floor() {
    let evidence = evidence();
    let score = &evidence.mutants[0];
    assert!((score.first.share - 160.0 / 170.0).abs() < 1e-9 && (score.now.share - 168.0 / 170.0).abs() < 1e-9);
    assert!(score.now.lower < score.now.share && score.now.share < score.now.upper);
    assert_eq!(found(&evidence, "mutants.controller").1, State::Met);
    assert_eq!(found(&evidence, "mutants.partner"), (None, State::NotMeasured));
    assert_eq!(found(&evidence, "mutants.sample"), (Some(3.0), State::Below));
    assert_eq!(found(&evidence, "mutants.survivors"), (Some(1.0), State::Below));
}

/// REQ-EVIDENCE-007
#[test]
fn review_when_it_says_of_something_shared_nothing_that_covers_it_then_that_is_below_the_floor() {
    let evidence = evidence();
    assert_eq!(found(&evidence, "independence.uncovered"), (Some(1.0), State::Below));
    assert!(found(&evidence, "independence.unnamed").0 > Some(0.0));
    let clock = &evidence.independence.as_ref().unwrap().areas[0];
    assert_eq!((clock.name.as_str(), clock.not_covered.as_str()), ("The clock", "a drift, both alike."));
}

/// REQ-EVIDENCE-008
#[test]
fn report_when_it_is_none_or_of_another_form_then_it_is_refused_by_name_with_the_way_out() {
    let with = |text: &str, name: &str| vec![file(name, text.into())];
    let text = |name: &str| fs::read_to_string(path(name)).unwrap();
    let later = text("fuzz.json").replace("\"schema\": 2", "\"schema\": 99");
    let older = text("inject.json").replace("\"schema\": 2,", "");
    let wrong_sum = text("controller.toml").replace("tried = 200", "tried = 300");
    let unknown = text("times.toml").replace("guided.late-timer", "guided.no-such-defect");
    let cases = [
        (Sources { fuzz: with("{}", "a"), ..sources() }, "no report of `twinrung fuzz --report`"),
        (Sources { fuzz: with(&later, "a"), ..sources() }, "a report of form 99, and this release knows 2"),
        (Sources { inject: with(&older, "a"), ..sources() }, "missing field `schema`"),
        (Sources { mutants: with("[run]\ncrate = 1", "a"), ..sources() }, "crate"),
        (Sources { mutants: with(&wrong_sum, "a"), ..sources() }, "are not the 300 that were tried"),
        (
            Sources { times: Some(file("a", unknown.into())), ..sources() },
            "`no-such-defect` is measured and stands in no list",
        ),
        (Sources { differences: Some(file("a", vec![0xFF])), ..sources() }, "utf-8"),
    ];
    for (sources, said) in cases {
        let error = refused(&sources);
        assert!(error.file == "a" && error.message.contains(said), "{error}");
    }
}

/// REQ-EVIDENCE-008
#[test]
fn page_when_an_older_report_recorded_no_processor_time_then_it_says_not_recorded() {
    let page = page(&evidence(), &Provenance::default());
    assert!(page.contains("2 h 30 min in 1 of 2 campaigns, not recorded in the others"));
    assert!(page.contains("1 campaigns were run by a release that recorded neither its build nor the machine."));
}
