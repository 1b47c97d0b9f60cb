//! What `check` says, in every form: text, JSON and SARIF as they were reviewed and committed, and exit codes.

use std::fs;
use std::path::Path;

use crate::command::{expect, twinrung};
use crate::support::{project_path, text};

fn codes(json: &str) -> Vec<String> {
    let json: serde_json::Value = serde_json::from_str(json).unwrap();
    let findings = json["findings"].as_array().unwrap();
    findings.iter().map(|finding| finding["code"].as_str().unwrap().to_owned()).collect()
}

/// The refused samples.
fn refused() -> Vec<String> {
    let entries = fs::read_dir(project_path("samples/refused")).unwrap().map(|entry| entry.unwrap().path());
    let mut names: Vec<String> = entries
        .filter(|path| path.extension().is_some_and(|ending| ending == "rll"))
        .map(|path| format!("samples/refused/{}", path.file_name().unwrap().to_string_lossy()))
        .collect();
    names.sort();
    names
}

#[test]
fn refused_samples_when_checked_then_each_is_explained_as_reviewed() {
    for path in refused() {
        let said = twinrung(&["check", &path]);
        assert_eq!((said.code, said.err.as_str()), (Some(1), ""), "{path}");
        let name = Path::new(&path).file_stem().unwrap().to_string_lossy().into_owned();
        expect(&format!("refused/{name}.txt"), &said.out);
    }
}

/// REQ-CHECK-002
#[test]
fn findings_when_several_then_listed_in_order_and_none_is_caused_by_another() {
    let said = twinrung(&["check", "tests/verdict/several.rll"]);
    expect("several.txt", &said.out);
    let said = twinrung(&["check", "tests/verdict/several.rll", "--format", "json"]);
    assert_eq!(codes(&said.out), ["E0203", "E0201", "S0301", "W0101", "E0301", "E0104", "S0101"]);
}

/// REQ-CHECK-006
#[test]
fn findings_when_in_an_export_then_the_rung_and_the_other_writer_are_drawn() {
    let said = twinrung(&["check", "tests/verdict/two-writers.L5X"]);
    expect("two-writers.txt", &said.out);
}

/// REQ-CHECK-003
#[test]
fn findings_when_asked_for_as_json_then_one_object_as_promised() {
    let said = twinrung(&["check", "tests/verdict/two-writers.L5X", "--format", "json"]);
    expect("two-writers.json", &said.out);
    let said = twinrung(&["check", "tests/verdict/suppressed.rll", "--format", "json"]);
    expect("suppressed.json", &said.out);
}

/// REQ-CHECK-005
#[test]
fn suppressions_when_with_a_reason_then_the_warning_is_listed_apart_and_an_unused_one_is_reported() {
    let said = twinrung(&["check", "tests/verdict/suppressed.rll"]);
    expect("suppressed.txt", &said.out);
}

/// REQ-CHECK-005
#[test]
fn suppressions_when_without_a_reason_of_no_code_or_of_an_error_then_refused() {
    let said = twinrung(&["check", "tests/verdict/not-suppressed.rll", "--format", "json"]);
    assert_eq!(codes(&said.out), ["E0411", "W0101", "E0411", "E0411", "S0301"]);
}

/// REQ-CHECK-004: `tests/sarif` holds these logs to the schema.
#[test]
fn sarif_when_written_then_as_reviewed_and_it_says_what_json_says() {
    let own = ["several", "two-writers", "suppressed", "not-suppressed"];
    for (name, ending) in own.into_iter().zip(["rll", "L5X", "rll", "rll"]) {
        let path = format!("tests/verdict/{name}.{ending}");
        let said = twinrung(&["check", &path, "--format", "sarif"]);
        expect(&format!("{name}.sarif"), &said.out);
        let log: serde_json::Value = serde_json::from_str(&said.out).unwrap();
        let results = log["runs"][0]["results"].as_array().unwrap();
        let open = results.iter().filter(|result| result["suppressions"].as_array().unwrap().is_empty());
        let rules: Vec<String> = open.map(|result| result["ruleId"].as_str().unwrap().to_owned()).collect();
        assert_eq!(rules, codes(&twinrung(&["check", &path, "--format", "json"]).out), "{path}");
    }
    expect("clean.sarif", &twinrung(&["check", "samples/add-on-instruction/project.rll", "--format", "sarif"]).out);
}

/// REQ-CHECK-001
#[test]
fn exit_codes_when_clean_found_or_unreadable_then_0_1_and_2() {
    let code = |arguments: &[&str]| twinrung(arguments).code;
    let folder = tempfile::tempdir().unwrap();
    let broken = folder.path().join("broken.L5X");
    fs::write(&broken, "<RSLogix5000Content><Controller>").unwrap();
    let warned = "tests/verdict/suppressed.rll";
    assert_eq!(code(&["check", "samples/qualified-standard-data/project.rll"]), Some(0));
    assert_eq!(code(&["check", warned]), Some(0));
    assert_eq!(code(&["check", warned, "--deny", "warnings"]), Some(1));
    assert_eq!(code(&["check", "tests/verdict/several.rll"]), Some(1));
    assert_eq!(code(&["check", "tests/verdict/nothing-here.rll"]), Some(2));
    assert_eq!(code(&["check", broken.to_str().unwrap()]), Some(2));
    assert_eq!(code(&["check", "README.md", "--format", "xml"]), Some(2));
}

/// REQ-CHECK-007. A verdict may be the last thing that is asked before a download: a failed build leaves the image of yesterday.
#[test]
fn images_when_the_project_is_refused_then_what_was_there_stays_and_nothing_else_appears() {
    let folder = tempfile::tempdir().unwrap();
    let image = folder.path().join("project.image");
    fs::write(&image, "yesterday").unwrap();
    let said = twinrung(&["build", "tests/verdict/several.rll", "-o", image.to_str().unwrap()]);
    assert_eq!(said.code, Some(1));
    assert_eq!(text(&image), "yesterday");
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
}

/// REQ-CHECK-007
#[test]
fn images_when_they_cannot_be_written_then_nothing_is_left_behind() {
    let folder = tempfile::tempdir().unwrap();
    let taken = folder.path().join("taken");
    fs::create_dir(&taken).unwrap();
    fs::write(taken.join("file"), "kept").unwrap();
    let said = twinrung(&["build", "samples/add-on-instruction/project.rll", "-o", taken.to_str().unwrap()]);
    assert_eq!(said.code, Some(2), "{}", said.out);
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
    let nowhere = folder.path().join("no/such/folder/project.image");
    assert_eq!(
        twinrung(&["build", "samples/add-on-instruction/project.rll", "-o", nowhere.to_str().unwrap()]).code,
        Some(2)
    );
}

/// REQ-CHECK-007
#[cfg(unix)]
#[test]
fn images_when_written_through_a_link_then_its_target_holds_them_and_the_link_stays() {
    let folder = tempfile::tempdir().unwrap();
    let (target, link) = (folder.path().join("target.image"), folder.path().join("link.image"));
    fs::write(&target, "yesterday").unwrap();
    std::os::unix::fs::symlink(&target, &link).unwrap();
    let said = twinrung(&["build", "samples/add-on-instruction/project.rll", "-o", link.to_str().unwrap()]);
    assert_eq!(said.code, Some(0), "{}", said.err);
    assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
    assert!(fs::metadata(&target).unwrap().len() > 1000);
}

/// REQ-CHECK-007. A device that a file replaces is gone for every program of the machine.
#[cfg(unix)]
#[test]
fn images_when_written_to_what_is_no_file_then_it_is_not_replaced() {
    let folder = tempfile::tempdir().unwrap();
    let socket = folder.path().join("socket");
    let _listener = std::os::unix::net::UnixListener::bind(&socket).unwrap();
    let said = twinrung(&["build", "samples/add-on-instruction/project.rll", "-o", socket.to_str().unwrap()]);
    assert_eq!(said.code, Some(2), "{}", said.out);
    assert!(!fs::metadata(&socket).unwrap().is_file());
}
