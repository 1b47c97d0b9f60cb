//! The signatures of safety Add-On Instructions: what they cover, how they seal, and what is compared.

use std::fs;
use std::path::PathBuf;

use tempfile::TempDir;

use crate::command::{Said, twinrung};
use crate::support::project_path;

const SAMPLE: &str = "samples/add-on-instruction/project.rll";
const NAME: &str = "Monitored_Valve";
const CLOCK: &str = "2026-11-22T18:00:00Z";

/// A copy of the sample that may be changed.
struct Copy {
    home: TempDir,
}

impl Copy {
    fn new() -> Copy {
        let copy = Copy { home: tempfile::tempdir().unwrap() };
        fs::copy(project_path(SAMPLE), copy.path()).unwrap();
        copy
    }

    /// A copy whose instruction is sealed.
    fn sealed() -> Copy {
        let copy = Copy::new();
        copy.done(&["generate", NAME, "--clock", CLOCK]);
        copy
    }

    fn path(&self) -> PathBuf {
        self.home.path().join("project.rll")
    }

    fn ask(&self, action: &[&str]) -> Said {
        let path = self.path();
        let arguments: Vec<&str> =
            ["signature", path.to_str().unwrap()].into_iter().chain(action.iter().copied()).collect();
        twinrung(&arguments)
    }

    fn done(&self, action: &[&str]) -> String {
        let said = self.ask(action);
        assert_eq!(said.code, Some(0), "{action:?}: {}{}", said.out, said.err);
        said.out
    }

    fn refused(&self, action: &[&str], code: &str) {
        let said = self.ask(action);
        assert_eq!(said.code, Some(1), "{action:?}: {}{}", said.out, said.err);
        assert!(said.out.contains(&format!("\n  {code}: ")), "{action:?}: {}", said.out);
    }

    fn change(&self, from: &str, to: &str) {
        let text = fs::read_to_string(self.path()).unwrap();
        assert!(text.contains(from), "{from}");
        fs::write(self.path(), text.replacen(from, to, 1)).unwrap();
    }

    /// What `check` finds.
    fn codes(&self) -> Vec<String> {
        let said = twinrung(&["check", self.path().to_str().unwrap(), "--format", "json"]);
        let json: serde_json::Value = serde_json::from_str(&said.out).unwrap();
        json["findings"].as_array().unwrap().iter().map(|one| one["code"].as_str().unwrap().to_owned()).collect()
    }

    /// Instruction signature and safety instruction signature of the instruction, after it was sealed.
    fn signatures(&self) -> (String, String) {
        let json: serde_json::Value = serde_json::from_str(&self.done(&["--format", "json"])).unwrap();
        let text = |key: &str| json[0][key].as_str().unwrap().to_owned();
        (text("instruction"), text("safety"))
    }

    /// The signatures after a change that is sealed anew.
    fn signatures_after(from: &str, to: &str) -> (String, String) {
        let copy = Copy::new();
        copy.change(from, to);
        copy.done(&["generate", NAME, "--clock", CLOCK]);
        copy.signatures()
    }
}

/// REQ-SIGN-006, REQ-SIGN-009. Comments are content, and do not execute.
#[test]
fn signatures_when_a_comment_changes_then_only_the_instruction_signature_does() {
    let (before, executes) = Copy::sealed().signatures();
    let (after, executes_after) = Copy::signatures_after("RC: \"The valve has not", "RC: \"The valve had not");
    assert_ne!(before, after);
    assert_eq!(executes, executes_after);
}

/// REQ-SIGN-006, REQ-SIGN-009.
#[test]
fn signatures_when_a_rung_changes_then_both_do() {
    let (before, executes) = Copy::sealed().signatures();
    let (after, executes_after) =
        Copy::signatures_after("N: XIC(Travel.DN)OTL(Faulted);", "N: XIC(Travel.DN)OTE(Faulted);");
    assert_ne!(before, after);
    assert_ne!(executes, executes_after);
}

/// REQ-SIGN-006. Another rung of the program is no content of the instruction.
#[test]
fn signatures_when_what_stands_around_the_instruction_changes_then_neither_does() {
    let before = Copy::sealed().signatures();
    let after = Copy::signatures_after("XIC(Guard_Closed)XIO", "XIC(Guard_Closed)XIC(Guard_Closed)XIO");
    assert_eq!(before, after);
}

/// REQ-SIGN-006. A date, a signature and the history are not content.
#[test]
fn signature_when_it_is_removed_and_generated_again_then_it_is_the_same() {
    let copy = Copy::sealed();
    let before = copy.signatures();
    copy.done(&["entry", NAME, "--user", "A. Tester", "--description", "released"]);
    copy.done(&["remove", NAME]);
    copy.done(&["generate", NAME, "--clock", "2027-01-01T00:00:00Z"]);
    assert_eq!(copy.signatures(), before);
}

/// REQ-SIGN-006. The sample's .rll and its L5X define one instruction.
#[test]
fn signature_when_taken_from_the_l5x_then_it_seals_what_the_rll_seals() {
    let copy = Copy::sealed();
    let (id, _) = copy.signatures();
    let export = fs::read_to_string(project_path("samples/add-on-instruction/project.L5X")).unwrap();
    let seal =
        format!("<AddOnInstructionDefinition InstructionSignature=\"{id}\" InstructionSignatureTimestamp=\"{CLOCK}\" ");
    let path = copy.home.path().join("project.L5X");
    fs::write(&path, export.replacen("<AddOnInstructionDefinition ", &seal, 1)).unwrap();
    let said = twinrung(&["check", path.to_str().unwrap()]);
    assert_eq!(said.code, Some(0), "{}", said.out);
}

/// REQ-SIGN-007. 1756-RM093 Appendix B: comments, descriptions and documentation included.
#[test]
fn check_when_a_sealed_instruction_was_changed_then_it_is_refused() {
    let changes = [
        ("RC: \"The valve has not", "RC: \"The valve had not"),
        ("Travel : TIMER;", "Travel : TIMER (Description := \"new\");"),
        ("Revision := \"1.0\"", "Revision := \"1.1\""),
        ("XIO(Faulted)OTE(Coil)", "OTE(Coil)"),
        ("Reset_Edge : BOOL;", "Reset_Edge : BOOL := 1;"),
    ];
    for (from, to) in changes {
        let copy = Copy::sealed();
        assert!(!copy.codes().contains(&"S0801".to_owned()));
        copy.change(from, to);
        assert!(copy.codes().contains(&"S0801".to_owned()), "{to}");
    }
}

/// REQ-SIGN-008. The table of protection decides.
#[test]
fn seal_when_it_is_there_or_not_then_what_the_table_refuses_is_refused() {
    let copy = Copy::new();
    copy.refused(&["remove", NAME], "P66");
    copy.refused(&["entry", NAME, "--user", "A", "--description", "B"], "P67");
    copy.done(&["generate", NAME]);
    copy.refused(&["generate", NAME], "P65");
    copy.done(&["remove", NAME]);
    assert_eq!(copy.codes(), Copy::new().codes());
}

/// REQ-SIGN-008. 1756-RM093 Appendix B: up to six entries.
#[test]
fn history_when_it_has_six_entries_then_a_seventh_is_refused() {
    let copy = Copy::sealed();
    for number in 1..=6 {
        copy.done(&["entry", NAME, "--user", "A. Tester", "--description", &format!("release {number}")]);
    }
    copy.refused(&["entry", NAME, "--user", "A. Tester", "--description", "release 7"], "P68");
    let listing = copy.done(&[]);
    assert_eq!(listing.matches("history").count(), 6, "{listing}");
    assert!(listing.contains("Description release 6"), "{listing}");
    assert!(!copy.codes().contains(&"S0801".to_owned()));
}

/// REQ-SIGN-008. 1756-RM093 Appendix B: not in a project that is locked or signed.
#[test]
fn seal_when_the_project_is_locked_or_signed_then_it_is_refused() {
    for (setting, code) in [("SafetyLocked := Yes", "P62"), ("SafetySignature := \"16#11b2_536b\"", "P63")] {
        let copy = Copy::new();
        copy.change(
            "SafetyNetwork := 16#0000_0000_0001_0001)",
            &format!("SafetyNetwork := 16#0000_0000_0001_0001, {setting})"),
        );
        copy.refused(&["generate", NAME], code);
    }
}

/// REQ-SIGN-009. 1756-RM093 Appendix B, Verify Safety Add-On Instruction Signatures.
#[test]
fn compare_when_instructions_were_recorded_then_what_differs_is_named() {
    let copy = Copy::sealed();
    let recorded = copy.home.path().join("recorded.json");
    fs::write(&recorded, copy.done(&["--format", "json"])).unwrap();
    let recorded = recorded.to_str().unwrap();
    assert!(copy.done(&["compare", recorded]).contains("Monitored_Valve: as recorded"));
    copy.done(&["remove", NAME]);
    copy.change("XIO(Faulted)OTE(Coil)", "OTE(Coil)");
    let said = copy.ask(&["compare", recorded]);
    assert_eq!(said.code, Some(1));
    assert!(said.out.contains("the instruction signature is another"), "{}", said.out);
    assert!(said.out.contains("it executes otherwise"), "{}", said.out);
}

/// REQ-SIGN-009. 1756-RM093 Appendix B: generated when a sealed instruction is downloaded.
#[test]
fn controller_when_a_sealed_instruction_is_downloaded_then_it_shows_what_is_to_be_compared() {
    let copy = Copy::sealed();
    let (id, safety) = copy.signatures();
    let cell = copy.home.path().join("cell").display().to_string();
    let project = copy.path().display().to_string();
    let said = twinrung(&["controller", &cell, "download", &project]);
    assert_eq!(said.code, Some(0), "{}{}", said.out, said.err);
    let short = |id: &str| format!("{}_{}", &id[..4], &id[4..8]);
    let line = format!(
        "Monitored_Valve: instruction signature {}  {CLOCK}, safety instruction signature {}",
        short(&id),
        short(&safety)
    );
    assert!(said.out.contains(&line), "{}", said.out);
    let status = twinrung(&["controller", &cell, "status"]);
    assert!(status.out.contains(&line), "{}", status.out);
}

/// REQ-SIGN-009. An image has no text: whether its instructions were sealed is not known, and not denied.
#[test]
fn controller_when_an_image_is_downloaded_then_it_says_that_seals_are_not_known() {
    let copy = Copy::sealed();
    let path = |name: &str| copy.home.path().join(name).display().to_string();
    let (cell, project, image) = (path("cell"), path("project.rll"), path("project.image"));
    assert_eq!(twinrung(&["controller", &cell, "download", &project]).code, Some(0));
    assert_eq!(twinrung(&["controller", &cell, "upload", &image]).code, Some(0));
    let said = twinrung(&["controller", &cell, "download", &image]);
    let words = "Monitored_Valve: an image does not say whether it is sealed; safety instruction signature ";
    assert!(said.out.contains(words), "{}", said.out);
    let status = twinrung(&["controller", &cell, "status"]).out;
    assert!(status.contains(words) && !status.contains("not sealed"), "{status}");
}

/// REQ-SIGN-008. What has no text of ours is not sealed here, and left as it is.
#[test]
fn seal_when_the_file_is_an_export_or_an_image_then_it_is_left_as_it_is() {
    let copy = Copy::new();
    let path = |name: &str| copy.home.path().join(name);
    fs::copy(project_path("samples/add-on-instruction/project.L5X"), path("project.L5X")).unwrap();
    let (project, image) = (copy.path().display().to_string(), path("project.image").display().to_string());
    assert_eq!(twinrung(&["build", &project, "--output", &image]).code, Some(0));
    let files =
        [("project.L5X", Some(2), "an export is sealed in the tool that wrote it"), ("project.image", Some(2), "")];
    for (name, code, words) in files {
        let before = fs::read(path(name)).unwrap();
        let said = twinrung(&["signature", path(name).to_str().unwrap(), "generate", NAME]);
        assert_eq!(said.code, code, "{}{}", said.out, said.err);
        assert!(said.err.contains(words), "{}", said.err);
        assert_eq!(fs::read(path(name)).unwrap(), before);
    }
    let said = twinrung(&["signature", &image]);
    assert_eq!(said.code, Some(1));
    assert!(said.out.contains("an image holds no text"), "{}", said.out);
}

/// REQ-SIGN-010. How the maker computes his is not published; a change after his seal shows in the dates.
#[test]
fn check_when_the_maker_sealed_an_instruction_then_it_is_a_warning_and_a_later_change_an_error() {
    let seal = "Revision := \"1.0\", SignatureID := 16#cae1_ac8c, SignatureTimestamp := \"2022-03-01T03:10:25.642Z\"";
    let copy = Copy::new();
    copy.change("Revision := \"1.0\"", seal);
    assert!(copy.codes().contains(&"W0130".to_owned()));
    copy.change(seal, &format!("{seal}, EditedDate := \"2022-03-01T03:10:26.000Z\""));
    assert!(copy.codes().contains(&"S0801".to_owned()));
}
