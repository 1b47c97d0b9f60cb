//! The evidence, read from small reports that stay as they are.

use std::fs;
use std::path::PathBuf;

use twinrung_workbench::evidence::{Evidence, EvidenceError, FLOORS, File, Sources, State, page};
use twinrung_workbench::fuzz::{Coverage, DifferenceFound, Report};
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
    let table = Some(Report::table_here().to_owned());
    let report = Report { table, points_reachable: Coverage::reachable(), ..report };
    file(place, serde_json::to_vec(&report).unwrap())
}

/// The report of a run into the same sample whose places were drawn from another seed.
fn again(place: &str) -> File {
    let text = fs::read_to_string(path("inject.json")).unwrap();
    file(place, text.replace("\"seed\": 7,", "\"seed\": 8,").into())
}

fn sources() -> Sources {
    let account = "[[difference]]\nwhat = \"Motor\"\nfound_by = \"twinrung fuzz\"\nwrong = \"partner\"\nmended = \"counted\"\n\
                   kept_by = [\"motor.table: one\"]\nreport = \"evidence/fuzz/a.json\"\nseed = 1\nprogram = 398\n\
                   text = \"the channels differ in Motor\"\n";
    Sources {
        fuzz: vec![campaign("evidence/fuzz/a.json", "fuzz.json"), campaign("evidence/fuzz/b.json", "fuzz-form-1.json")],
        inject: vec![read("evidence/inject/press.json", "inject.json"), again("evidence/inject/again.json")],
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
    let time = floors.iter().find(|floor| floor["id"] == "campaign.processor").unwrap();
    assert_eq!((&time["value"], &time["state"]), (&9_000.0.into(), &"below".into()));
}

/// REQ-EVIDENCE-003
#[test]
fn campaigns_when_added_up_then_times_and_points_are_those_of_all() {
    let evidence = evidence();
    assert_eq!(found(&evidence, "campaign.processor"), (Some(9_000.0), State::Below));
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

/// REQ-EVIDENCE-003. As many points are not the same points.
#[test]
fn campaign_when_it_knew_as_many_other_points_then_all_of_this_release_are_missing() {
    let report: Report = serde_json::from_slice(&fs::read(path("fuzz.json")).unwrap()).unwrap();
    let of = |table: Option<&str>| {
        let table = table.map(str::to_owned);
        let report =
            Report { table, points_reachable: Coverage::reachable(), points_missing: Vec::new(), ..report.clone() };
        let fuzz = vec![file("a", serde_json::to_vec(&report).unwrap())];
        let evidence = Evidence::read(&Sources { fuzz, ..sources() }).unwrap();
        let written = page(&evidence, &Provenance::default());
        (
            found(&evidence, "campaign.missing"),
            written.contains("points of another table"),
            written.contains("was not recorded in all"),
        )
    };
    let all = Coverage::reachable() as f64;
    assert_eq!(of(Some("00")), ((Some(all), State::Below), true, false));
    assert_eq!(of(Some(Report::table_here())), ((Some(0.0), State::Met), false, false));
    assert_eq!(of(None), ((Some(0.0), State::Met), false, true));
}

/// REQ-EVIDENCE-003
#[test]
fn difference_when_a_report_names_it_and_nobody_has_accounted_for_it_then_it_is_open() {
    assert_eq!(found(&evidence(), "campaign.open"), (Some(0.0), State::Met));
    let open = Evidence::read(&Sources { differences: None, ..sources() }).unwrap();
    assert_eq!(found(&open, "campaign.open"), (Some(1.0), State::Below));
    assert!(page(&open, &Provenance::default()).contains("1 differences are OPEN"));
}

/// REQ-EVIDENCE-003. Campaigns add up in one file, and each counts its programs from its seed; a program may differ in more than one way.
#[test]
fn differences_when_they_have_a_file_and_a_program_in_common_then_an_entry_accounts_for_its_own_alone() {
    let report: Report = serde_json::from_slice(&fs::read(path("fuzz.json")).unwrap()).unwrap();
    let differing = |seed: u64, text: &str| {
        let one = report.differences[0].clone();
        DifferenceFound { seed: Some(seed), difference: text.to_owned(), ..one }
    };
    let motor = "the channels differ in Motor";
    let differences = vec![
        differing(1, motor),
        differing(2, motor),
        differing(1, "the channels differ in Pump"),
        differing(1, motor),
    ];
    let report = Report { seeds: vec![1, 2, 1], differences, ..report };
    let fuzz = vec![file("evidence/fuzz/a.json", serde_json::to_vec(&report).unwrap())];
    let evidence = Evidence::read(&Sources { fuzz, ..sources() }).unwrap();
    assert_eq!(found(&evidence, "campaign.open"), (Some(3.0), State::Below));
    let open: Vec<_> =
        evidence.differences.iter().filter(|one| one.is_open()).map(|one| (one.seed, one.what.as_str())).collect();
    assert_eq!(open, [(Some(2), motor), (Some(1), "the channels differ in Pump"), (Some(1), motor)]);
}

/// REQ-EVIDENCE-003
#[test]
fn difference_when_no_test_is_named_that_keeps_it_mended_then_it_is_open() {
    let account = sources().differences.unwrap();
    let account = String::from_utf8(account.bytes).unwrap().replace("kept_by = [\"motor.table: one\"]\n", "");
    let differences = Some(file("evidence/differences.toml", account.into()));
    let evidence = Evidence::read(&Sources { differences, ..sources() }).unwrap();
    assert_eq!(found(&evidence, "campaign.open"), (Some(1.0), State::Below));
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
    let page = page(&evidence, &Provenance::default());
    assert!(
        page.contains("<li class=\"not\">Small changes of the source that the tests notice: "),
        "the floors are not met"
    );
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
    let changed = |changes: &[(&str, &str)]| {
        let text = changes.iter().fold(text("controller.toml"), |text, (from, to)| text.replace(from, to));
        Sources { mutants: with(&text, "a"), ..sources() }
    };
    let none = [("of = 400", "of = 0"), ("tried = 200", "tried = 0"), ("caught = 150", "caught = 0")];
    let none = [&none[..], &[("timeout = 10", "timeout = 0"), ("unviable = 30", "unviable = 0")]].concat();
    let none = [&none[..], &[("missed_first = 10", "missed_first = 0"), ("missed = 2", "missed = 0")]].concat();
    let name = |bytes: &[u8], name: &str| file(name, bytes.to_vec());
    let campaigns = sources().fuzz;
    let injections = sources().inject;
    let twice = "take one of them away";
    let cases = [
        (Sources { fuzz: with("{}", "a"), ..sources() }, "no report of `twinrung fuzz --report`"),
        (Sources { fuzz: with(&later, "a"), ..sources() }, "a report of form 99, and this release knows 3"),
        (Sources { fuzz: vec![campaigns[0].clone(), name(&campaigns[0].bytes, "a")], ..sources() }, twice),
        (Sources { fuzz: vec![campaigns[1].clone(), name(&campaigns[1].bytes, "a")], ..sources() }, twice),
        (Sources { inject: vec![injections[0].clone(), name(&injections[0].bytes, "a")], ..sources() }, twice),
        (Sources { inject: with(&older, "a"), ..sources() }, "missing field `schema`"),
        (Sources { mutants: with("[run]\ncrate = 1", "a"), ..sources() }, "crate"),
        (Sources { mutants: with(&wrong_sum, "a"), ..sources() }, "are not the 300 that were tried"),
        (Sources { mutants: with(&wrong_sum, "a"), ..sources() }, "they make tried"),
        (changed(&[("of = 400", "of = 199")]), "200 were tried of 199: `of` counts all mutants"),
        (changed(&none), "no mutant compiled, and none is no result: try more, or take the file away"),
        (
            changed(&[
                ("caught = 150", "caught = 151"),
                ("missed = 2", "missed = 1"),
                ("missed_first = 10", "missed_first = 9"),
            ]),
            "2 survivors are named and 1 were missed: take out",
        ),
        (
            changed(&[
                ("caught = 150", "caught = 9223372036854775807"),
                ("timeout = 10", "timeout = 9223372036854775807"),
            ]),
            "are not the 200 that were tried",
        ),
        (
            Sources { times: Some(file("a", unknown.into())), ..sources() },
            "`no-such-defect` is measured and stands in no list of defects: enter it in one, or take its times out",
        ),
        (Sources { differences: Some(file("a", vec![0xFF])), ..sources() }, "; save it as UTF-8"),
        (
            Sources { differences: Some(file("a", "[".into())), ..sources() },
            "put the line right, or take the file away",
        ),
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

/// REQ-EVIDENCE-005. A report of residual faults alone, or of none, says nothing of a sample.
#[test]
fn sample_when_only_residual_faults_or_none_were_injected_then_nothing_was_injected_into_it() {
    let samples = |changes: [(&str, &str); 2]| {
        let text = fs::read_to_string(path("inject.json")).unwrap();
        let text = changes.iter().fold(text, |text, (from, to)| text.replace(from, to));
        let sources = Sources { inject: vec![file("a", text.into())], ..sources() };
        found(&Evidence::read(&sources).unwrap(), "injection.samples").0
    };
    let nothing = ("\"injected\": 1000", "\"injected\": 0");
    assert_eq!(samples([("", ""), ("", "")]), Some(1.0));
    assert_eq!(samples([nothing, ("", "")]), Some(2.0));
    assert_eq!(samples([nothing, ("\"group\": \"channel\"", "\"group\": \"residual\"")]), Some(2.0));
}

/// REQ-EVIDENCE-005
#[test]
fn fault_when_it_let_a_wrong_output_out_then_its_group_is_below_and_the_command_stands_on_the_page() {
    for (group, id) in [("channel", "injection.channel"), ("shared", "injection.shared")] {
        let text = fs::read_to_string(path("inject.json")).unwrap();
        let text = text.replace("\"group\": \"channel\"", &format!("\"group\": \"{group}\""));
        let text = text
            .replace("\"let_out\": 0", "\"let_out\": 1")
            .replace("\"misses\": []", "\"misses\": [\"5:primary.cells.flip:9\"]");
        let sources = Sources { inject: vec![file("a", text.into())], ..sources() };
        let evidence = Evidence::read(&sources).unwrap();
        assert_eq!(found(&evidence, id), (Some(1.0), State::Below));
        let page = page(&evidence, &Provenance::default());
        let command = "twinrung inject samples/press --seed 7 --follow 50 --replay 5:primary.cells.flip:9";
        assert!(page.contains(&format!("Group {group}: the controller has to find these.")) && page.contains(command));
    }
}

/// REQ-EVIDENCE-006
#[test]
fn sample_of_mutants_when_120_compile_then_it_is_enough_and_119_are_not() {
    let sample = |caught: u64| {
        let text = format!(
            "[run]\ncrate = \"vm/controller\"\nof = 400\ntried = {}\ncaught = {caught}\nunviable = 5\nmissed_first = 0\nmissed = 0\n",
            caught + 5
        );
        let mutants = vec![file("a", text.into())];
        found(&Evidence::read(&Sources { mutants, ..sources() }).unwrap(), "mutants.sample").0
    };
    assert_eq!((sample(119), sample(120)), (Some(4.0), Some(3.0)));
}

/// REQ-EVIDENCE-007
#[test]
fn review_when_it_leaves_a_part_out_then_the_page_says_so() {
    let page = page(&evidence(), &Provenance::default());
    assert_eq!(page.matches("<td class=\"not\">NOTHING IS SAID").count(), 3, "of the weather, in each column");
}

/// REQ-EVIDENCE-001
#[test]
fn measurement_when_another_build_made_it_or_its_commit_is_not_known_then_the_page_says_so() {
    let warned = |made: Option<&str>, here: Option<&str>| {
        let commit = |commit: Option<&str>| commit.map(str::to_owned);
        let mut evidence = evidence();
        for made_by in evidence.origins.iter_mut().flat_map(|origin| &mut origin.measurements) {
            *made_by = Provenance { version: "0.1.0".to_owned(), commit: commit(made), ..Provenance::default() };
        }
        let here = Provenance { version: "0.1.0".to_owned(), commit: commit(here), ..Provenance::default() };
        page(&evidence, &here).contains("Measured by builds that are not, or are not known to be")
    };
    assert_eq!(
        [warned(Some("aa"), Some("aa")), warned(Some("aa"), Some("bb")), warned(None, None)],
        [false, true, true]
    );
}

/// REQ-EVIDENCE-003. A file that the page sends a reader to is there.
#[test]
fn page_when_it_names_a_source_file_then_that_is_there() {
    let page = page(&evidence(), &Provenance::default());
    let root = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("..");
    let named: Vec<&str> = page
        .split([' ', ',', ';', '<', '>', '"'])
        .map(|word| word.trim_end_matches('.'))
        .filter(|word| word.ends_with(".rs"))
        .collect();
    assert!(named.len() >= 2, "{named:?}");
    let missing: Vec<&&str> = named.iter().filter(|name| !root.join(name).is_file()).collect();
    assert!(missing.is_empty(), "{missing:?}");
}
