//! What the command says of a replaced module, and of a controller whose partner failed.

use crate::cell::Cell;

fn project(safety: &str) -> String {
    format!(
        "CONTROLLER Cell (ProcessorType := \"1756-L73S\", Major := 20, SafetyNetwork := 16#0000_0000_0001_0003{safety})
  MODULE Rack (CatalogNumber := \"1734-AENT\", Parent := \"Local\", IPAddress := \"192.168.1.10\") END_MODULE
  MODULE Doors (CatalogNumber := \"1734-IB8S/B\", Parent := \"Rack\", Slot := 1, SafetyNetwork := 16#0000_0000_0001_0002, RPI := 10) END_MODULE
  TAG
    Run : BOOL (Class := Safety);
  END_TAG
  PROGRAM Safety_Main (Class := Safety, MAIN := \"Main\")
    ROUTINE Main
      N: XIC(Doors:I.Pt00Data)XIO(Doors:I.ConnectionFaulted)OTE(Run);
    END_ROUTINE
  END_PROGRAM
  TASK Safety_Task (Type := PERIODIC, Class := Safety, Rate := 10, Watchdog := 10, Priority := 5)
    Safety_Main;
  END_TASK
END_CONTROLLER
"
    )
}

/// REQ-REPLACE-001. The setting is the project's, the signature the controller's.
#[test]
fn module_when_it_is_replaced_then_the_command_says_what_the_table_says() {
    let cell = Cell::with_project(&project(""));
    assert_eq!(cell.ask("replace Doors").code, Some(0));
    let other = cell.ask("replace Doors --number other");
    assert_eq!(other.code, Some(1));
    assert!(other.out.contains("R06: 1734-UM013 Table 11, Scenario 3"), "{}", other.out);
    assert_eq!(cell.ask("generate").code, Some(0));
    let new = cell.ask("replace Doors");
    assert_eq!(new.code, Some(1));
    assert!(new.out.contains("R04: 1734-UM013 Table 11, Scenario 1"), "{}", new.out);
}

/// REQ-REPLACE-001.
#[test]
fn module_when_the_project_says_configure_always_then_a_new_one_is_configured_in_spite_of_the_signature() {
    let cell = Cell::with_project(&project(", ConfigureSafetyIOAlways := Yes"));
    assert_eq!(cell.ask("generate").code, Some(0));
    let said = cell.ask("replace Doors");
    assert_eq!(said.code, Some(0), "{}", said.out);
    assert!(said.out.contains("Configure Always"), "{}", said.out);
}

/// REQ-SIGN-004, REQ-REPLACE-001. The setting belongs to the signed application: a locked and signed controller takes no other one.
#[test]
fn download_when_only_configure_always_differs_then_it_is_another_application() {
    let cell = Cell::with_project(&project(""));
    cell.done("generate --clock 2026-11-22T18:00:00Z");
    cell.done("lock");
    cell.write("always.rll", &project(", ConfigureSafetyIOAlways := Yes"));
    cell.write("never.rll", &project(", ConfigureSafetyIOAlways := No"));
    let download = |name: &str| format!("download {}", cell.path(name).display());
    assert_eq!(cell.ask(&download("always.rll")).code, Some(1));
    cell.done(&download("never.rll"));
}

/// REQ-REPLACE-001. An image says so too.
#[test]
fn module_when_an_image_says_configure_always_then_a_new_one_is_configured() {
    let cell = Cell::with_project(&project(", ConfigureSafetyIOAlways := Yes"));
    let image = cell.path("cell.image").display().to_string();
    cell.done(&format!("upload {image}"));
    cell.done(&format!("download {image}"));
    cell.done("generate");
    assert!(cell.done("replace Doors").contains("Configure Always"));
}

/// REQ-FAULT-003, REQ-FAULT-007. 1756-RM093 Nonrecoverable Controller Faults.
#[test]
fn controller_when_its_partner_fails_then_only_a_download_recovers_and_the_log_says_so() {
    let cell = Cell::with_project(&project(""));
    assert_eq!(cell.ask("lose-partner").code, Some(3));
    for action in ["clear", "override"] {
        let said = cell.ask(action);
        assert_eq!(said.code, Some(1), "{action}");
        assert!(said.out.contains("P71: "), "{action}: {}", said.out);
    }
    assert_eq!(cell.ask("run").code, Some(3));
    let path = cell.path("project.rll").display().to_string();
    assert_eq!(cell.ask(&format!("download {path}")).code, Some(0));
    let log = cell.ask("faults").out;
    assert!(log.contains("14/9 at 0 ms  nonrecoverable controller fault"), "{log}");
    assert!(log.contains("reinitialized by a download"), "{log}");
    assert_eq!(cell.ask("run --until 20 --quiet").code, Some(0));
}
