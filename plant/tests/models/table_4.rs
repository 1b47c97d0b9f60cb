//! Table 4 and Figure 21 of 1734-UM013: the muting status bit. REQ-PLANT-011

use twinrung_plant::Reading::{Muting, TestStatus};
use twinrung_plant::digital_input::{DigitalInput, TestFault};
use twinrung_plant::{Command, Fault, ModuleSettings, Stimulus, Terminal};

use super::support::Bench;

const LAMP: Command = Command::Test(1);

/// T1 and T3 of a module can be muting lamps.
fn lamp_at(terminal: Terminal) -> Bench<DigitalInput> {
    let settings = ModuleSettings::new("1734-IB8S").point(terminal, &[("Mode", "MUTING_LAMP")]);
    Bench::new(DigitalInput::new(&settings))
}

fn lamp() -> Bench<DigitalInput> {
    lamp_at(T1)
}

const T1: Terminal = Terminal::new('T', 1);
const BAD: Stimulus = Stimulus::Fault(T1, Fault::Open);
const GOOD: Stimulus = Stimulus::Repaired(T1);

/// Commanded; the lamp; the muting status bit. Rows in the order of the table; the lamp was on for two intervals before, as its
/// description asks (`if it remains off after the output was cycled`).
const TABLE: [(bool, Stimulus, i32); 4] = [(true, BAD, 0), (true, GOOD, 1), (false, BAD, 0), (false, GOOD, 1)];

#[test]
fn lamp_when_commanded_and_tested_then_the_status_is_that_of_the_table() {
    for (commanded, condition, status) in TABLE {
        let mut bench = lamp();
        bench.at(0, condition).command(0, &[(LAMP, true)]).command(7000, &[(LAMP, commanded)]);
        assert_eq!(bench.read(20_000, &[Muting(1)]), [status], "commanded {commanded}, {condition:?}");
    }
}

/// The whole table at the other terminal that can be one, by its own bit.
#[test]
fn lamp_when_it_is_at_the_other_terminal_then_its_own_status_is_that_of_the_table() {
    const T3: Terminal = Terminal::new('T', 3);
    let conditions = [Stimulus::Fault(T3, Fault::Open), Stimulus::Repaired(T3)];
    for (commanded, condition, status) in TABLE {
        let own = conditions[usize::from(condition == GOOD)];
        let mut bench = lamp_at(T3);
        let command = |on: bool| [(Command::Test(3), on)];
        bench.at(0, own).command(0, &command(true)).command(7000, &command(commanded));
        assert_eq!(bench.read(20_000, &[Muting(1), Muting(3)]), [1, status], "commanded {commanded}, {own:?}");
    }
}

/// The point beside the table: at power-up the bit is on, and a lamp that stays off is not tested.
#[test]
fn lamp_when_burnt_out_and_never_switched_on_then_the_status_stays_as_at_power_up() {
    let mut bench = lamp();
    bench.at(0, BAD);
    assert_eq!(bench.changes(20_000, Muting(1)), [(0, 1)]);
}

/// Figure 21: tests each 3 s from power-up, two failed ones in a row, and normal again with the next test after the lamp was
/// replaced, although the output is off by then.
#[test]
fn lamp_when_burnt_out_and_replaced_then_the_figure_is_replayed() {
    let mut bench = lamp();
    bench.command(1000, &[(LAMP, true)]);
    assert_eq!(bench.read(3999, &[Muting(1)]), [1]);
    bench.at(4000, BAD);
    // The test at 6 s is the first that fails, the one at 9 s the second.
    assert_eq!(bench.changes(10_000, Muting(1)), [(4000, 1), (9000, 0)]);
    assert_eq!(bench.device.test_fault(1), TestFault::Undercurrent);
    bench.command(10_500, &[(LAMP, false)]).at(11_000, GOOD);
    assert_eq!(bench.changes(13_000, Muting(1)), [(11_000, 0), (12_000, 1)]);
}

/// A lamp that is on for less than two tests is never found: the manual asks for 6 s.
#[test]
fn lamp_when_on_for_one_test_at_a_time_then_it_is_not_found_to_be_burnt_out() {
    let mut bench = lamp();
    bench.at(0, BAD);
    for round in 0..5 {
        bench.command(round * 6000 + 2000, &[(LAMP, true)]).command(round * 6000 + 5000, &[(LAMP, false)]);
    }
    assert_eq!(bench.read(30_000, &[Muting(1), TestStatus(1)]), [1, 1]);
}

/// A short to 0 V is found by the lamp test too.
#[test]
fn lamp_when_its_wire_touches_0_v_then_the_status_goes_off() {
    let mut bench = lamp();
    bench.command(0, &[(LAMP, true)]).at(100, Stimulus::Fault(T1, Fault::ToCommon));
    assert_eq!(bench.read(6000, &[Muting(1)]), [0]);
    assert_eq!(bench.device.test_fault(1), TestFault::Overload);
}
