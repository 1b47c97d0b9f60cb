//! A controller that is kept in a folder, as an engineer commissions a project with it.

use std::fs;
use std::io::Write;
use std::path::Path;
use std::process::{Command, Stdio};

use crate::cell::Cell;
use crate::support::{project_path, text};

const SAMPLE: &str = "samples/estop-with-contactors";
const CLOCK: &str = "2026-11-22T18:00:00Z";

/// With the sample downloaded.
fn with_sample() -> Cell {
    let cell = Cell::new();
    cell.done("download samples/estop-with-contactors");
    cell
}

/// With a project of these rungs, which use these tags.
fn with_rungs(tags: &str, rungs: &[&str]) -> Cell {
    Cell::with_project(&project("Faulty", tags, rungs))
}

fn project(name: &str, tags: &str, rungs: &[&str]) -> String {
    let rungs: String = rungs.iter().map(|rung| format!("      N: {rung};\n")).collect();
    format!(
        "CONTROLLER {name} (ProcessorType := \"1756-L73S\", Major := 20, SafetyNetwork := 16#0000_0000_0001_0003)
  MODULE Rack (CatalogNumber := \"1734-AENT\", Parent := \"Local\", IPAddress := \"192.168.1.10\") END_MODULE
  MODULE Doors (CatalogNumber := \"1734-IB8S/B\", Parent := \"Rack\", Slot := 1, SafetyNetwork := 16#0000_0000_0001_0002, RPI := 10)
    POINT I00 (Mode := SAFETY);
    POINT I01 (Mode := SAFETY);
  END_MODULE
  MODULE Drives (CatalogNumber := \"1734-OB8S/B\", Parent := \"Rack\", Slot := 2, SafetyNetwork := 16#0000_0000_0001_0002)
    POINT O00 (Mode := SAFETY_PULSE_TEST, Channel := DUAL);
  END_MODULE
  TAG\n    Spare : BOOL (Class := Safety);\n{tags}  END_TAG
  PROGRAM Safety_Main (Class := Safety, MAIN := \"Main\")
    ROUTINE Main\n{rungs}    END_ROUTINE\n  END_PROGRAM
  TASK Safety_Task (Type := PERIODIC, Class := Safety, Rate := 20, Watchdog := 10, Priority := 5)
    Safety_Main;\n  END_TASK\nEND_CONTROLLER\n"
    )
}

fn write(path: &Path, content: &str) -> String {
    fs::write(path, content).unwrap();
    path.display().to_string()
}

/// REQ-SIGN-001, REQ-SIGN-002, REQ-MODE-002: the order of 1756-RM093 Figure 15.
#[test]
fn project_when_commissioned_in_the_manual_s_order_then_it_ends_locked_with_a_recorded_signature() {
    let cell = Cell::new();
    assert!(cell.done(&format!("download {SAMPLE}")).contains("the application is to be tested"));
    cell.done("mode run");
    let recording = cell.path("recording.csv");
    cell.done(&format!(
        "run --quiet --stimulus {SAMPLE}/stimulus.csv --record @{SAMPLE}/record.txt --out {}",
        recording.display()
    ));
    assert_eq!(text(&recording), text(&project_path(&format!("{SAMPLE}/recording.csv"))));
    cell.refused("generate", "P21");
    cell.done("mode program");
    let said = cell.done(&format!("generate --clock {CLOCK}"));
    assert!(said.contains(&format!("8245_78da  {CLOCK}")), "{said}");
    cell.done("lock");
    let status = cell.status();
    assert_eq!((&status["locked"], &status["signature"]["generated"]), (&true.into(), &CLOCK.into()));
    assert!(cell.done("status").contains("8245_78da  2026-11-22T18:00:00Z"));
    cell.refused("delete", "P22");
    cell.done("mode run");
    assert!(cell.done("status").contains("SIL 3"));
}

/// REQ-SIGN-004. Compare after every download: the same project from another form of it, and another project.
#[test]
fn download_when_repeated_from_the_export_then_the_signature_stays_and_another_project_is_refused_while_locked() {
    let cell = with_sample();
    cell.done(&format!("generate --clock {CLOCK}"));
    cell.done("lock");
    let said = cell.done(&format!("download {SAMPLE}/project.L5X"));
    assert!(said.contains(&format!("which stays: 8245_78da  {CLOCK}")), "{said}");
    assert!(cell.done(&format!("compare {SAMPLE}/project.rll")).contains("they are the same application"));
    let other = write(
        &cell.path("other.rll"),
        &text(&project_path(&format!("{SAMPLE}/project.rll"))).replace(",500,", ",600,"),
    );
    cell.refused(&format!("download {other}"), "P15");
    assert_eq!(cell.ask(&format!("compare {other}")).code, Some(1));
    cell.done("unlock");
    assert!(cell.done(&format!("download {other}")).contains("is to be validated again"));
    assert_eq!(cell.status()["signature"], serde_json::Value::Null);
}

/// REQ-SIGN-004. Newer controllers have a module's safety network number on its port: it is signed there as well.
#[test]
fn download_when_only_the_network_number_on_a_port_differs_then_it_is_another_application() {
    let export = text(&project_path("samples/add-on-instruction/project.L5X"));
    let number = "SafetyNetwork=\"16#0000_0000_0001_0002\"";
    let (before, module) = export.split_at(export.find("<Module Name=\"Field_In\"").unwrap());
    let port = "Address=\"1\" Type=\"PointIO\"";
    assert!(module.contains(number) && module.contains(port));
    let on_the_port = |number: &str| {
        let without = module.replacen("SafetyNetwork=\"16#0000_0000_0001_0002\" ", "", 1);
        format!("{before}{}", without.replacen(port, &format!("{port} {number}"), 1))
    };
    let cell = Cell::new();
    cell.write("module.L5X", &export);
    cell.write("port.L5X", &on_the_port(number));
    cell.write("other.L5X", &on_the_port("SafetyNetwork=\"16#0000_0000_0001_0003\""));
    let download = |name: &str| format!("download {}", cell.path(name).display());
    cell.done(&download("port.L5X"));
    cell.done(&format!("generate --clock {CLOCK}"));
    cell.done("lock");
    assert_eq!(cell.ask(&download("other.L5X")).code, Some(1));
    cell.done(&download("module.L5X"));
}

/// Which device answers is part of what was verified. REQ-SIGN-004
#[test]
fn download_when_only_the_keying_or_the_identity_of_a_module_differs_then_it_is_another_application() {
    let export = text(&project_path("samples/add-on-instruction/project.L5X"));
    let (before, module) = export.split_at(export.find("<Module Name=\"Field_In\"").unwrap());
    let with = |from: &str, to: &str| {
        assert!(module.contains(from), "{from}");
        format!("{before}{}", module.replacen(from, to, 1))
    };
    let cell = Cell::new();
    let download = |name: &str| format!("download {}", cell.path(name).display());
    cell.write("module.L5X", &export);
    cell.done(&download("module.L5X"));
    cell.done(&format!("generate --clock {CLOCK}"));
    cell.done("lock");
    for (name, changed) in [
        ("keying.L5X", with("<EKey State=\"CompatibleModule\"", "<EKey State=\"Disabled\"")),
        ("revision.L5X", with("CatalogNumber=\"1734-IB8S\"", "CatalogNumber=\"1734-IB8S\" Major=\"2\"")),
    ] {
        cell.write(name, &changed);
        assert_eq!(cell.ask(&download(name)).code, Some(1), "{name}");
    }
    cell.done(&download("module.L5X"));
}

/// REQ-MODE-009
#[test]
fn mode_when_changed_then_it_takes_more_than_one_period_and_less_than_two() {
    let cell = with_sample();
    assert!(cell.done("mode run --at 1").contains("Run mode 39.000 ms after it was asked for"));
    assert!(cell.done("mode program --at 19").contains("Program mode 21.000 ms after it was asked for"));
    assert_eq!(cell.ask("mode run --at 20").code, Some(2));
    assert_eq!(cell.status()["mode"], "Program");
}

/// REQ-MODE-009
#[test]
fn scans_when_the_controller_is_in_program_mode_then_outputs_are_off() {
    let cell = with_sample();
    let recording = cell.path("recording.csv");
    cell.done(&format!(
        "run --quiet --stimulus {SAMPLE}/stimulus.csv --record Published:K1,Controller:Mode --out {}",
        recording.display()
    ));
    let rows = text(&recording);
    assert!(rows.lines().skip(1).all(|row| row.ends_with(",0,0")), "{rows}");
}

/// REQ-MODE-011. A force acts in the scans, on what comes in and on what goes out, and is what the logic sees.
#[test]
fn force_when_installed_then_scans_have_it_until_it_is_disabled_and_only_connected_data_takes_one() {
    let cell = with_rungs("", &["XIC(Doors:I.Pt00Data)OTE(Drives:O.Pt00Data)", "XIC(Doors:I.Pt01Data)OTE(Spare)"]);
    cell.done("mode run");
    let record = |name: &str| {
        let path = cell.path(name);
        let names = "Spare,Drives:O.Pt00Data,Published:Drives:O.Pt00Data";
        cell.done(&format!("run --quiet --until 0 --record {names} --out {}", path.display()));
        text(&path).lines().nth(1).unwrap().to_owned()
    };
    assert_eq!(record("a.csv"), "0,0,0,0");
    cell.done("force Doors:I.Pt01Data=1");
    cell.done("force Drives:O.Pt00Data=1");
    assert_eq!(record("b.csv"), "0,1,0,1");
    cell.done("forces disable");
    assert_eq!(record("c.csv"), "0,0,0,0");
    cell.refused("lock", "P32");
    cell.done("forces enable");
    cell.done("mode program");
    assert_eq!(record("d.csv"), "0,0,0,0");
    cell.done("unforce Doors:I.Pt01Data");
    cell.done("unforce");
    assert_eq!(cell.ask("force Spare=1").code, Some(1));
    cell.done("lock");
    cell.refused("force Doors:I.Pt01Data=1", "P40");
}

/// REQ-MODE-012. 1756-RM093 Table 9: faulted, data zero.
#[test]
fn module_when_inhibited_then_its_connection_is_faulted_its_data_0_and_its_outputs_off() {
    let cell = with_rungs("", &["XIC(Doors:I.Pt00Data)OTE(Drives:O.Pt00Data)"]);
    let stimulus = write(&cell.path("s.csv"), "time_ms,Doors:I.Pt00Data,Doors:I.RunMode\n0,1,1\n");
    cell.done("mode run");
    let record = |name: &str| {
        let path = cell.path(name);
        let names = "Doors:I.RunMode,Doors:I.ConnectionFaulted,Doors:I.Pt00Data,Published:Drives:O.Pt00Data";
        cell.done(&format!("run --quiet --until 0 --stimulus {stimulus} --record {names} --out {}", path.display()));
        text(&path).lines().nth(1).unwrap().to_owned()
    };
    assert_eq!(record("a.csv"), "0,1,0,1,1");
    cell.done("inhibit Drives");
    assert_eq!(record("b.csv"), "0,1,0,1,0");
    cell.done("inhibit Doors");
    assert_eq!(record("c.csv"), "0,0,1,0,0");
    assert_eq!(cell.ask("inhibit Nobody").code, Some(1));
    cell.done("lock");
    cell.refused("uninhibit Doors", "P47");
}

/// REQ-MODE-010. A stimulus that writes safety data is data manipulation.
#[test]
fn stimulus_when_it_drives_safety_data_that_is_no_input_then_lock_and_signature_refuse_it() {
    let cell = with_rungs("", &["XIC(Spare)OTE(Drives:O.Pt00Data)"]);
    let inputs = write(&cell.path("inputs.csv"), "time_ms,Doors:I.Pt00Data\n0,1\n");
    let data = write(&cell.path("data.csv"), "time_ms,Spare\n0,1\n");
    cell.done(&format!("run --quiet --stimulus {data}"));
    cell.done("lock");
    cell.refused(&format!("run --quiet --stimulus {data}"), "P45");
    cell.done(&format!("run --quiet --stimulus {inputs}"));
    cell.done("unlock");
    cell.done("generate");
    cell.refused(&format!("run --quiet --stimulus {data}"), "P46");
}

/// REQ-MODE-004. Passwords come from a file or the standard input.
#[test]
fn lock_when_passwords_are_set_then_files_and_the_standard_input_give_them() {
    let cell = with_sample();
    let (shut, open) = (write(&cell.path("shut"), "shut\n"), write(&cell.path("open"), "open\r\n"));
    cell.done(&format!("password lock --new {shut}"));
    cell.done(&format!("password unlock --new {open}"));
    assert_eq!(cell.ask("lock").code, Some(1));
    cell.done(&format!("lock --password {shut}"));
    assert_eq!(cell.ask(&format!("unlock --password {shut}")).code, Some(1));
    let mut command = Command::new(env!("CARGO_BIN_EXE_twinrung"))
        .args(["controller", &cell.folder(), "unlock", "--password", "-"])
        .stdin(Stdio::piped())
        .stdout(Stdio::null())
        .spawn()
        .unwrap();
    command.stdin.take().unwrap().write_all(b"open\n").unwrap();
    assert_eq!(command.wait().unwrap().code(), Some(0));
    let status = cell.status();
    assert_eq!((&status["locked"], &status["unlock_password"]), (&false.into(), &true.into()));
}

/// REQ-SIGN-005
#[test]
fn card_when_loaded_into_another_controller_then_it_has_application_signature_and_lock_of_the_first() {
    let first = with_sample();
    first.done(&format!("generate --clock {CLOCK}"));
    first.done("lock");
    let card = first.path("card").display().to_string();
    first.done(&format!("store {card}"));
    let second = Cell::new();
    second.done(&format!("load {card}"));
    let (one, other) = (first.status(), second.status());
    for key in ["application_signature", "signature", "locked", "mode", "catalog_number"] {
        assert_eq!(one[key], other[key], "{key}");
    }
    let image = second.path("uploaded.image").display().to_string();
    second.done(&format!("upload {image}"));
    assert!(first.done(&format!("compare {image}")).contains("they are the same application"));
    let mut bytes = fs::read(&card).unwrap();
    bytes.truncate(bytes.len() - 1);
    fs::write(&card, bytes).unwrap();
    assert_eq!(second.ask(&format!("load {card}")).code, Some(2));
}

/// REQ-FAULT-005. A fault of the program stays with the controller.
#[test]
fn recoverable_fault_when_no_fault_routine_handles_it_then_the_controller_has_it_until_it_is_cleared() {
    let tags = "    A : DINT[4] (Class := Safety);\n    N, D : DINT (Class := Safety);\n";
    let cell = with_rungs(tags, &["XIC(Doors:I.Pt00Data)MOV(10,N)", "MOV(A[N],D)"]);
    let stimulus = write(&cell.path("s.csv"), "time_ms,Doors:I.Pt00Data\n0,0\n40,1\n");
    cell.done("mode run");
    let run = format!("run --quiet --stimulus {stimulus}");
    assert_eq!(cell.ask(&run).code, Some(4));
    let status = cell.status();
    assert_eq!((&status["status"], &status["fault"]["at_ms"]), (&"recoverable fault".into(), &40.into()));
    let again = cell.ask(&run);
    assert_eq!(again.code, Some(4));
    assert!(again.out.contains("the safety task does not execute, outputs are off"));
    cell.done("override");
    assert!(cell.done("status").contains("overridden, not cleared"));
    cell.done("clear");
    assert!(cell.done("faults").contains("safety connections were closed and opened again"));
    assert_eq!(cell.status()["status"], "OK");
}

/// REQ-KEEP-003. What the command does not do leaves no trace, and a damaged record is said to be one.
#[test]
fn state_when_an_action_is_refused_or_a_record_is_damaged_then_the_kept_one_is_used_and_said() {
    let cell = with_sample();
    let before = cell.status();
    cell.refused("unlock", "P34");
    cell.refused("forces enable", "P42");
    assert_eq!(cell.status(), before);
    cell.done("lock");
    let newest = cell.path("cell").join("state.b");
    let mut bytes = fs::read(&newest).unwrap();
    bytes[40] ^= 1;
    fs::write(&newest, bytes).unwrap();
    let said = cell.ask("status --format json");
    assert!(said.err.contains("state.b is damaged"), "{}", said.err);
    assert_eq!(serde_json::from_str::<serde_json::Value>(&said.out).unwrap(), before);
    assert_eq!(Cell::new().ask("status").code, Some(2));
}
