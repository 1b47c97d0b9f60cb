//! Disturbed executions: what an observer asks for, the channel does.

use alloc::vec::Vec;

use twinrung_bytecode::channel::{Channel, Place, ScanInputs};
use twinrung_bytecode::index::{BitCell, WordCell};
use twinrung_bytecode::observer::{ElementUpset, Observer, RungUpset};

use super::rig::Rig;

/// Upsets one rung or element, once.
#[derive(Default)]
struct Upset {
    rung: Option<(u32, RungUpset)>,
    element: Option<(u32, u32, ElementUpset)>,
    bit: Option<BitCell>,
    word: Option<WordCell>,
    rungs: Vec<u32>,
}

impl Observer for Upset {
    fn rung_entered(&mut self, place: Place) {
        self.rungs.push(place.rung);
    }

    fn rung_upset(&mut self, place: Place) -> RungUpset {
        self.rung.take_if(|(rung, _)| *rung == place.rung).map_or(RungUpset::None, |(_, upset)| upset)
    }

    fn element_upset(&mut self, place: Place) -> ElementUpset {
        self.element
            .take_if(|(rung, element, _)| (*rung, *element) == (place.rung, place.element))
            .map_or(ElementUpset::None, |(_, _, upset)| upset)
    }

    fn bit_arrives(&mut self, cell: BitCell, value: bool) -> bool {
        value != (self.bit == Some(cell))
    }

    fn word_arrives(&mut self, cell: WordCell, value: i32) -> i32 {
        value ^ i32::from(self.word == Some(cell))
    }
}

const RUNGS: [&str; 3] = ["ADD(i,1,i)", "XIC(a)OTE(b)", "ADD(j,i,j)"];

/// Values of i, j and b behind one scan with a = 1, and the rungs that it went through.
fn disturbed(mut upset: Upset) -> (Vec<i32>, Vec<u32>) {
    let mut rig = Rig::new("a b BOOL; i j DINT", &RUNGS);
    rig.set("a", 1);
    rig.silent.scan(ScanInputs { now_ms: 0, budget: 1000, system_values: &[] }, &mut upset);
    (rig.all("i j b"), upset.rungs)
}

fn rung(number: u32, upset: RungUpset) -> (Vec<i32>, Vec<u32>) {
    disturbed(Upset { rung: Some((number, upset)), ..Upset::default() })
}

fn element(rung: u32, element: u32, upset: ElementUpset) -> Vec<i32> {
    disturbed(Upset { element: Some((rung, element, upset)), ..Upset::default() }).0
}

#[test]
fn rungs_when_not_upset_then_run_in_their_order() {
    assert_eq!(disturbed(Upset::default()), ([1, 1, 1].to_vec(), [0, 1, 2].to_vec()));
}

#[test]
fn rung_when_skipped_then_the_next_one_follows() {
    assert_eq!(rung(1, RungUpset::Skip), ([1, 1, 0].to_vec(), [0, 1, 2].to_vec()));
}

#[test]
fn rung_when_the_last_is_skipped_then_the_routine_ends() {
    assert_eq!(rung(2, RungUpset::Skip), ([1, 0, 1].to_vec(), [0, 1, 2].to_vec()));
}

#[test]
fn rung_when_repeated_then_runs_twice() {
    assert_eq!(rung(0, RungUpset::Repeat), ([2, 2, 1].to_vec(), [0, 0, 1, 2].to_vec()));
}

#[test]
fn rung_when_it_goes_elsewhere_then_goes_on_from_there() {
    assert_eq!(rung(1, RungUpset::Goto(2)), ([1, 1, 0].to_vec(), [0, 1, 2].to_vec()));
    assert_eq!(rung(2, RungUpset::Goto(0)), ([2, 2, 1].to_vec(), [0, 1, 2, 0, 1, 2].to_vec()));
    assert_eq!(rung(0, RungUpset::Goto(9)), ([0, 0, 0].to_vec(), [0].to_vec()));
}

#[test]
fn element_when_skipped_then_has_no_effect_and_passes_its_condition() {
    assert_eq!(element(0, 0, ElementUpset::Skip), [0, 0, 1]);
    assert_eq!(element(1, 1, ElementUpset::Skip), [1, 1, 0]);
}

#[test]
fn element_when_repeated_then_acts_twice() {
    assert_eq!(element(0, 0, ElementUpset::Repeat), [2, 2, 1]);
}

#[test]
fn element_when_its_condition_is_turned_round_then_the_rung_goes_the_other_way() {
    assert_eq!(element(1, 0, ElementUpset::Invert), [1, 1, 0]);
}

#[test]
fn cell_when_something_else_arrives_then_holds_that() {
    let bit = Upset { bit: Some(BitCell(1)), ..Upset::default() };
    assert_eq!(disturbed(bit).0, [1, 1, 0]);
    let word = Upset { word: Some(WordCell(1)), ..Upset::default() };
    assert_eq!(disturbed(word).0, [1, 0, 1]);
}
