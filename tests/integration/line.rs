//! Several controllers in one simulated time: what a consumer has in each state of its producer and of the network, and how long it
//! takes at most.

use proptest::prelude::*;
use twinrung_compiler::{CheckedProject, Completion, check, compile};
use twinrung_controller::{Partner, Primary};
use twinrung_grammar::tree::Sources;
use twinrung_workbench::Stimulus;
use twinrung_workbench::line::{Joining, Line, LineError};
use twinrung_workbench::reaction::{self, Settings};

const RACK: &str = "  MODULE Rack (CatalogNumber := \"1734-AENT\", Parent := \"Local\", IPAddress := \"192.168.1.10\") END_MODULE
  MODULE Doors (CatalogNumber := \"1734-IB8S/B\", Parent := \"Rack\", Slot := 1, SafetyNetwork := 16#0000_0000_0001_0002, RPI := 10) END_MODULE
  MODULE Drives (CatalogNumber := \"1734-OB8S/B\", Parent := \"Rack\", Slot := 2, SafetyNetwork := 16#0000_0000_0001_0002) END_MODULE
";

fn checked(text: &str) -> CheckedProject {
    let reading = twinrung_grammar::read(&mut Sources::new(), "line.rll", text.as_bytes().to_vec());
    let checked = check(&reading, &Completion::default());
    checked.project.unwrap_or_else(|| panic!("{text}\n{:?}", checked.findings))
}

fn controller(name: &str, network: u32, tags: &str, rungs: &str, times: (u32, u32)) -> String {
    let (period, watchdog) = times;
    format!(
        "CONTROLLER {name} (ProcessorType := \"1756-L73S\", Major := 20, SafetyNetwork := 16#0000_0000_0001_000{network})
  DATATYPE Line_T\n    CONNECTION_STATUS Status;\n    BOOL Run;\n    DINT Speed;\n  END_DATATYPE\n{RACK}
  MODULE Other (CatalogNumber := \"1756-L73S\", Parent := \"Local\", Slot := 3, SafetyNetwork := 16#0000_0000_0001_0009) END_MODULE
  TAG\n{tags}  END_TAG\n  PROGRAM Safety_Main (Class := Safety, MAIN := \"Main\")\n    ROUTINE Main\n{rungs}    END_ROUTINE\n  END_PROGRAM
  TASK Safety_Task (Type := PERIODIC, Class := Safety, Rate := {period}, Watchdog := {watchdog}, Priority := 5)
    Safety_Main;\n  END_TASK\nEND_CONTROLLER\n"
    )
}

fn producer(times: (u32, u32)) -> CheckedProject {
    checked(&producer_text(times))
}

/// A project that produces `Guard`.
pub fn producer_text(times: (u32, u32)) -> String {
    controller(
        "Cell_A",
        3,
        "    Guard : Line_T (Class := Safety, Produced := 1, RPI := 20);\n    Ok : BOOL (Class := Safety);\n",
        "      N: XIO(Doors:I.ConnectionFaulted)OTE(Ok);\n      N: XIC(Doors:I.Pt00Data)[OTE(Guard.Run) ,MOV(7,Guard.Speed) ];\n",
        times,
    )
}

fn consumer(times: (u32, u32), connection: &str) -> CheckedProject {
    checked(&consumer_text(times, connection))
}

/// A project that consumes it.
pub fn consumer_text(times: (u32, u32), connection: &str) -> String {
    controller(
        "Cell_B",
        4,
        &format!(
            "    Guard : Line_T (Class := Safety, Producer := Other, RemoteTag := \"Guard\", {connection});\n    Ok : BOOL (Class := Safety);\n"
        ),
        "      N: XIO(Guard.Status.ConnectionFaulted)XIC(Guard.Status.RunMode)OTE(Ok);\n      N: XIC(Guard.Run)OTE(Drives:O.Pt00Data);\n",
        times,
    )
}

fn joining(project: &CheckedProject, phase_ms: u64, execution_us: u64) -> Joining {
    let bytes = compile(project).unwrap().bytes;
    let image = twinrung_bytecode::admit(&bytes).unwrap();
    Joining { name: project.name.to_string(), image, bytes, phase_ms, execution_us }
}

type Two = Line<Primary, Partner>;

fn two() -> Two {
    let members = vec![joining(&producer((20, 20)), 0, 0), joining(&consumer((20, 20), "RPI := 20"), 0, 0)];
    Line::new(members, 1_000, |_| 0).unwrap()
}

/// What was recorded of a line under a stimulus, as CSV.
fn played(mut line: Two, stimulus: &str, names: &[&str], until_ms: u64) -> String {
    line.stimulate(&Stimulus::read(stimulus).unwrap()).unwrap();
    line.record(&names.iter().map(|name| (*name).to_owned()).collect::<Vec<_>>()).unwrap();
    line.until(until_ms);
    line.recording().to_csv()
}

const WHAT_B_HAS: [&str; 5] = [
    "Cell_B/Guard.Status.RunMode",
    "Cell_B/Guard.Status.ConnectionFaulted",
    "Cell_B/Guard.Run",
    "Cell_B/Guard.Speed",
    "Cell_B/Published:Drives:O.Pt00Data",
];

/// The last row of a recording, without its time.
fn last(csv: &str) -> Vec<String> {
    csv.lines().last().unwrap().split(',').skip(1).map(str::to_owned).collect()
}

fn at_the_end(stimulus: &str) -> Vec<String> {
    last(&played(two(), stimulus, &WHAT_B_HAS, 1_000))
}

/// REQ-LINE-001. Table 9, first row.
#[test]
fn consumer_when_its_producer_runs_then_it_has_its_data_and_run_mode() {
    assert_eq!(at_the_end("time_ms,Cell_A/Doors:I.Pt00Data\n0,1\n"), ["1", "0", "1", "7", "1"]);
}

/// REQ-LINE-002. Table 9, second row: the producer is idle in Program mode.
#[test]
fn consumer_when_its_producer_is_in_program_then_it_is_idle_with_data_zero() {
    let stimulus = "time_ms,Cell_A/Doors:I.Pt00Data,Cell_A/Controller:Mode\n0,1,\n200,,0\n";
    assert_eq!(at_the_end(stimulus), ["0", "0", "0", "0", "0"]);
}

/// REQ-LINE-002. 1756-RM093 Recoverable Faults: the producer commands its consumers to be safe.
#[test]
fn consumer_when_a_recoverable_fault_stopped_its_producer_then_it_is_idle_with_data_zero() {
    let members = vec![joining(&checked(&faulty_text()), 0, 0), joining(&consumer((20, 20), "RPI := 20"), 0, 0)];
    let line = Line::new(members, 1_000, |_| 0).unwrap();
    let stimulus = "time_ms,Cell_A/Doors:I.Pt00Data,Cell_A/Doors:I.Pt01Data\n0,1,0\n200,,1\n";
    assert_eq!(last(&played(line, stimulus, &WHAT_B_HAS, 1_000)), ["0", "0", "0", "0", "0"]);
}

/// A producer that its second input stops with a recoverable fault.
pub fn faulty_text() -> String {
    controller(
        "Cell_A",
        3,
        "    Guard : Line_T (Class := Safety, Produced := 1, RPI := 20);\n    Ok : BOOL (Class := Safety);\n    Wait : TIMER (Class := Safety);\n    Bad : DINT (Class := Safety);\n",
        "      N: XIO(Doors:I.ConnectionFaulted)OTE(Ok);\n      N: XIC(Doors:I.Pt00Data)[OTE(Guard.Run) ,MOV(7,Guard.Speed) ];\n      N: XIC(Doors:I.Pt01Data)SUB(0,1,Bad);\n      N: XIC(Doors:I.Pt01Data)MOV(Bad,Wait.PRE);\n      N: TON(Wait,?,?);\n",
        (20, 20),
    )
}

/// REQ-LINE-003. Table 9, third row: nobody knows the state of the producer.
#[test]
fn consumer_when_the_network_is_lost_then_the_connection_is_faulted_with_data_zero() {
    let stimulus = "time_ms,Cell_A/Doors:I.Pt00Data,Cell_B/Guard:Network\n0,1,\n200,,0\n";
    assert_eq!(at_the_end(stimulus), ["0", "1", "0", "0", "0"]);
}

/// REQ-LINE-003. 1756-RM093 Nonrecoverable Controller Faults.
#[test]
fn consumer_when_the_partner_of_its_producer_fails_then_the_connection_is_faulted() {
    let stimulus = "time_ms,Cell_A/Doors:I.Pt00Data,Cell_A/Controller:Partner\n0,1,\n200,,0\n";
    assert_eq!(at_the_end(stimulus), ["0", "1", "0", "0", "0"]);
    let fault = last(&played(two(), stimulus, &["Cell_A/Controller:Fault", "Cell_B/Controller:Fault"], 1_000));
    assert_eq!(fault, ["14009", "0"]);
}

/// REQ-LINE-003. The limit with the default multipliers is 4 x RPI: 80.0 ms, counted from when the last packet was sent.
#[test]
fn consumer_when_the_network_is_lost_then_it_is_safe_at_the_first_scan_after_the_limit() {
    let stimulus = "time_ms,Cell_A/Doors:I.Pt00Data,Cell_B/Guard:Network\n0,1,\n210,,0\n";
    let csv = played(two(), stimulus, &["Cell_B/Guard.Status.ConnectionFaulted"], 400);
    let row = |time: &str| csv.lines().find(|line| line.starts_with(&format!("{time},"))).map(str::to_owned);
    assert_eq!(row("280"), Some("280,0".to_owned()));
    assert_eq!(row("300"), Some("300,1".to_owned()));
}

/// REQ-LINE-003. Without its producer a consumed tag is faulted from the beginning.
#[test]
fn consumer_when_nobody_produces_its_tag_then_it_is_named_and_faulted() {
    let mut line: Two = Line::new(vec![joining(&consumer((20, 20), "RPI := 20"), 0, 0)], 0, |_| 0).unwrap();
    assert_eq!(line.unconnected().collect::<Vec<_>>(), ["Cell_B/Guard"]);
    line.record(&["Cell_B/Guard.Status.ConnectionFaulted".to_owned()]).unwrap();
    line.until(100);
    assert_eq!(last(&line.recording().to_csv()), ["1"]);
}

/// REQ-LINE-001.
#[test]
fn stimulus_when_it_drives_what_a_producer_drives_then_it_is_refused() {
    let stimulus = Stimulus::read("time_ms,Cell_B/Guard.Run\n0,1\n").unwrap();
    assert_eq!(two().stimulate(&stimulus), Err(LineError::Driven("Cell_B/Guard.Run".to_owned())));
}

/// How long the parts of Figure 21 between the input tag of A and the output tag of B take at most, in µs.
fn bound_us(a: &CheckedProject, b: &CheckedProject) -> u64 {
    let chains = reaction::chains(b, &[a], &Settings::default()).unwrap();
    let chain = chains.iter().find(|chain| chain.inputs.iter().any(|name| name.contains("Doors:I"))).unwrap();
    let inner = chain
        .components
        .iter()
        .filter(|part| part.name.starts_with("safety task of") || part.name.starts_with("connection of"));
    inner.map(|part| part.us.unwrap()).sum()
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, failure_persistence: None, ..ProptestConfig::default() })]

    /// REQ-LINE-004. Whatever the network loses, however long packets and scans take: a demand at A's input has switched B's
    /// output off when the time of Figure 21 is over.
    #[test]
    fn output_when_a_demand_comes_then_it_is_off_within_the_reaction_time(
        (period_a, period_b) in (1_u32..60, 1_u32..60),
        (rpi, timeouts, delay_percent) in (6_u32..50, 1_u32..4, 100_u32..300),
        (phase_a, phase_b) in (0_u64..60, 0_u64..60),
        (share_a, share_b) in (0_u64..=100, 0_u64..=100),
        (delay_us, first_us) in (0_u64..200_000, 0_u64..50_000),
        demand_ms in 600_u64..900,
        losses in prop::collection::vec(0_u64..1_200, 0..12),
    ) {
        let a = producer((period_a, period_a));
        let connection = format!("RPI := {rpi}, TimeoutMultiplier := {timeouts}, NetworkDelayMultiplier := {delay_percent}");
        let b = consumer((period_b, period_b), &connection);
        let execution = |period: u32, share: u64| u64::from(period) * 10 * share;
        let (execution_a, execution_b) = (execution(period_a, share_a), execution(period_b, share_b));
        let members = vec![joining(&a, phase_a, execution_a), joining(&b, phase_b, execution_b)];
        let mut line: Two = Line::new(members, delay_us, |_| first_us).unwrap();
        let mut rows: std::collections::BTreeMap<u64, (&str, &str)> = [(0, ("1", "")), (demand_ms, ("0", ""))].into();
        let mut losses = losses;
        losses.sort_unstable();
        for (number, at) in losses.iter().enumerate() {
            rows.entry(*at).or_insert(("", "")).1 = if number % 2 == 0 { "0" } else { "1" };
        }
        let rows: String = rows.iter().map(|(at, (input, network))| format!("{at},{input},{network}\n")).collect();
        let stimulus = format!("time_ms,Cell_A/Doors:I.Pt00Data,Cell_B/Guard:Network\n{rows}");
        line.stimulate(&Stimulus::read(&stimulus).unwrap()).unwrap();
        line.record(&["Cell_B/Published:Drives:O.Pt00Data".to_owned()]).unwrap();
        line.until(2_000);
        let on = twinrung_workbench::Value::Bool(true);
        // A row is the end of a scan; what it says is published when that scan has ended.
        let rows = &line.recording().rows;
        let last_on = rows.iter().filter(|row| row.values[0] == on).map(|row| row.time_ms).max();
        let off_after = |on_ms: u64| rows.iter().map(|row| row.time_ms).find(|time_ms| *time_ms > on_ms);
        // An output that is never switched off again is off never.
        let off_us = last_on.map_or(0, |on_ms| off_after(on_ms).map_or(u64::MAX, |off_ms| off_ms * 1000 + execution_b));
        // Where nothing is lost or late the output was on, so that there was something to switch off.
        let is_sound = losses.is_empty() && delay_us < u64::from(rpi) * 1000;
        let was_on = rows.iter().any(|row| row.values[0] == on && row.time_ms < demand_ms);
        prop_assert!(was_on || !is_sound);
        prop_assert!(off_us <= demand_ms * 1000 + bound_us(&a, &b) || last_on.is_none_or(|last| last < demand_ms));
    }
}
