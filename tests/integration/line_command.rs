//! `twinrung line`: what the command plays, writes, says and refuses.

use std::fs;

use crate::cell::Cell;
use crate::command::{Said, twinrung};
use crate::line::{consumer_text, faulty_text, producer_text};

const WHAT_B_HAS: &str = "Cell_B/Guard.Status.RunMode,Cell_B/Guard.Status.ConnectionFaulted,Cell_B/Guard.Run,Cell_B/Published:Drives:O.Pt00Data";

/// Both projects and what drives them, in files.
fn files(producer: &str, stimulus: &str) -> Cell {
    let home = Cell::new();
    home.write("a.rll", producer);
    home.write("b.rll", &consumer_text((20, 20), "RPI := 20"));
    home.write("line.csv", stimulus);
    home
}

fn line(home: &Cell, more: &str) -> Said {
    let [a, b, stimulus, out] =
        ["a.rll", "b.rll", "line.csv", "out.csv"].map(|name| home.path(name).display().to_string());
    let arguments = ["line", &a, &b, "--stimulus", &stimulus, "--out", &out, "--quiet"];
    twinrung(&arguments.into_iter().chain(more.split_whitespace()).collect::<Vec<_>>())
}

fn recorded(home: &Cell) -> String {
    fs::read_to_string(home.path("out.csv")).unwrap()
}

const DRIVEN: &str = "time_ms,Cell_A/Doors:I.Pt00Data\n0,1\n";

/// REQ-LINE-001. The first packet goes out before the producer has scanned.
#[test]
fn line_when_played_then_it_writes_what_was_recorded() {
    let home = files(&producer_text((20, 20)), DRIVEN);
    let said = line(&home, &format!("--record {WHAT_B_HAS} --until 60"));
    assert_eq!(said.code, Some(0), "{}{}", said.out, said.err);
    assert!(said.out.contains("2 controllers, no difference between the channels of any of them"), "{}", said.out);
    assert_eq!(recorded(&home), format!("time_ms,{WHAT_B_HAS}\n0,0,1,0,0\n20,0,0,0,0\n40,1,0,1,1\n60,1,0,1,1\n"));
}

/// REQ-LINE-001, REQ-LINE-003. A packet that is on its way for longer than the limit of 80 ms is never young enough.
#[test]
fn line_when_packets_are_late_then_the_delay_counts() {
    let home = files(&producer_text((20, 20)), DRIVEN);
    let at_the_end = |delay: u32| {
        assert_eq!(line(&home, &format!("--record {WHAT_B_HAS} --until 400 --delay {delay}")).code, Some(0));
        recorded(&home).lines().last().unwrap().to_owned()
    };
    assert_eq!([at_the_end(60), at_the_end(100)], ["400,1,0,1,1", "400,0,1,0,0"]);
}

/// REQ-LINE-001. A row whenever a controller has scanned.
#[test]
fn line_when_controllers_begin_at_other_times_then_each_scans_at_its_own() {
    let home = files(&producer_text((20, 20)), DRIVEN);
    assert_eq!(line(&home, &format!("--record {WHAT_B_HAS} --until 45 --phase 0,5")).code, Some(0));
    let recorded = recorded(&home);
    let times: Vec<&str> = recorded.lines().skip(1).filter_map(|row| row.split(',').next()).collect();
    assert_eq!(times, ["0", "5", "20", "25", "40", "45"]);
}

/// REQ-LINE-002. The exit code is that of the worst fault.
#[test]
fn line_when_controllers_stop_then_each_is_named_and_the_worst_fault_is_the_exit_code() {
    let columns = "time_ms,Cell_A/Doors:I.Pt00Data,Cell_A/Doors:I.Pt01Data,Cell_B/Controller:Partner\n";
    let recoverable = files(&faulty_text(), &format!("{columns}0,1,0,\n100,,1,\n"));
    let said = line(&recoverable, "--until 200");
    assert_eq!(said.code, Some(4), "{}", said.out);
    assert!(
        said.out.contains("Cell_A stopped at 100 ms: fault 14/2, major fault 4/34 at Safety_Main/Main, rung 4,"),
        "{}",
        said.out
    );
    let both = files(&faulty_text(), &format!("{columns}0,1,0,\n100,,1,\n140,,,0\n"));
    let said = line(&both, "--until 200");
    assert_eq!(said.code, Some(3), "{}", said.out);
    assert!(said.out.contains("Cell_B stopped at 140 ms: fault 14/9, "), "{}", said.out);
}

/// REQ-LINE-003.
#[test]
fn line_when_nobody_produces_a_consumed_tag_then_it_is_named() {
    let home = files(&producer_text((20, 20)).replace("Guard", "Gate"), DRIVEN);
    let said = line(&home, &format!("--record {WHAT_B_HAS} --until 60"));
    assert_eq!(said.code, Some(0), "{}{}", said.out, said.err);
    assert!(said.err.contains("nobody here produces what Cell_B/Guard consumes"), "{}", said.err);
    assert!(recorded(&home).ends_with("60,0,1,0,0\n"));
}

/// REQ-LINE-001.
#[test]
fn line_when_controllers_do_not_fit_together_then_it_is_refused() {
    let same_name = files(&producer_text((20, 20)).replacen("CONTROLLER Cell_A", "CONTROLLER Cell_B", 1), DRIVEN);
    let other_type = files(&producer_text((20, 20)).replacen("DINT Speed;", "INT Speed;", 1), DRIVEN);
    let refused = [
        (same_name, "two controllers are called `Cell_B`"),
        (other_type, "Cell_B/Guard has another type than Cell_A/Guard"),
    ];
    for (home, words) in refused {
        let said = line(&home, "");
        assert_eq!(said.code, Some(1), "{}{}", said.out, said.err);
        assert!(said.out.contains(words) && said.out.contains("nothing was run"), "{}", said.out);
    }
}
