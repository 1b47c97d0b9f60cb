//! What an observer upsets while rungs are walked.

mod support;

use support::{Rig, project, rungs, tags};
use twinrung_bytecode::channel::{Channel, Place, ScanEnd, ScanInputs};
use twinrung_bytecode::index::{BitCell, WordCell};
use twinrung_bytecode::observer::{ElementUpset, Observer, RungUpset};

/// Upsets the first rung with a number, or the first element at a place, and what arrives in cells.
struct Upsets {
    rung: Option<(u32, RungUpset)>,
    element: Option<(u32, u32, ElementUpset)>,
    bit: Option<(BitCell, bool)>,
    word: Option<(WordCell, i32)>,
    /// Rungs and elements as they were asked about.
    asked: Vec<(u32, Option<u32>)>,
}

impl Upsets {
    fn none() -> Upsets {
        Upsets { rung: None, element: None, bit: None, word: None, asked: Vec::new() }
    }
}

impl Observer for Upsets {
    fn rung_upset(&mut self, place: Place) -> RungUpset {
        self.asked.push((place.rung, None));
        let (_, upset) = self.rung.take_if(|(rung, _)| *rung == place.rung).unwrap_or((0, RungUpset::None));
        upset
    }

    fn element_upset(&mut self, place: Place) -> ElementUpset {
        self.asked.push((place.rung, Some(place.element)));
        let here = |(rung, element, _): &mut (u32, u32, ElementUpset)| (*rung, *element) == (place.rung, place.element);
        self.element.take_if(here).map_or(ElementUpset::None, |(_, _, upset)| upset)
    }

    fn bit_arrives(&mut self, cell: BitCell, value: bool) -> bool {
        self.bit.filter(|(wanted, _)| *wanted == cell).map_or(value, |(_, arrives)| arrives)
    }

    fn word_arrives(&mut self, cell: WordCell, value: i32) -> i32 {
        self.word.filter(|(wanted, _)| *wanted == cell).map_or(value, |(_, arrives)| arrives)
    }
}

fn upset(rig: &mut Rig, upsets: &mut Upsets) -> ScanEnd {
    rig.partner.scan(ScanInputs { now_ms: 10, budget: u64::MAX, system_values: &[] }, upsets)
}

/// Three rungs that count how often they were executed, and what a scan leaves.
fn counted(rung: (u32, RungUpset)) -> (Vec<i32>, Vec<u32>) {
    let mut rig = rungs(&["N : DINT[3]"], &["ADD(N[0],1,N[0])", "ADD(N[1],1,N[1])", "ADD(N[2],1,N[2])"]);
    let mut upsets = Upsets { rung: Some(rung), ..Upsets::none() };
    assert_eq!(upset(&mut rig, &mut upsets), ScanEnd::Completed);
    let entered = upsets.asked.iter().filter(|(_, element)| element.is_none()).map(|(rung, _)| *rung).collect();
    (rig.row(&["N[0]", "N[1]", "N[2]"]), entered)
}

#[test]
fn rung_when_upset_then_it_is_skipped_repeated_or_left_for_another() {
    assert_eq!(counted((1, RungUpset::None)), (vec![1, 1, 1], vec![0, 1, 2]));
    assert_eq!(counted((1, RungUpset::Skip)), (vec![1, 0, 1], vec![0, 1, 2]));
    assert_eq!(counted((2, RungUpset::Skip)), (vec![1, 1, 0], vec![0, 1, 2]));
    assert_eq!(counted((1, RungUpset::Repeat)), (vec![1, 2, 1], vec![0, 1, 1, 2]));
    assert_eq!(counted((2, RungUpset::Repeat)), (vec![1, 1, 2], vec![0, 1, 2, 2]));
    assert_eq!(counted((0, RungUpset::Goto(2))), (vec![0, 0, 1], vec![0, 2]));
    assert_eq!(counted((2, RungUpset::Goto(0))), (vec![2, 2, 1], vec![0, 1, 2, 0, 1, 2]));
    assert_eq!(counted((1, RungUpset::Goto(3))), (vec![1, 0, 0], vec![0, 1]));
}

#[test]
fn goto_when_a_rung_is_upset_by_it_then_it_is_no_jmp_of_the_path() {
    let mut rig = rungs(&["N : DINT[3]"], &["NOP()", "NOP()"]);
    upset(&mut rig, &mut Upsets::none());
    let path = rig.partner.path_signature();
    upset(&mut rig, &mut Upsets { rung: Some((1, RungUpset::Goto(0))), ..Upsets::none() });
    assert_eq!(rig.partner.path_signature(), path);
}

/// What a rung with an upset element leaves in `A`, `B` and `N`, and how much it executed.
fn element(rung: &str, element: (u32, u32, ElementUpset)) -> (Vec<i32>, u64) {
    let mut rig = rungs(&["A : BOOL := 1", "B : BOOL", "N : DINT"], &[rung]);
    rig.prescan(0);
    rig.set("A", 1);
    let before = rig.status().executed;
    upset(&mut rig, &mut Upsets { element: Some(element), ..Upsets::none() });
    (rig.row(&["A", "B", "N"]), rig.status().executed - before)
}

#[test]
fn element_when_upset_then_it_has_no_effect_or_two_or_leads_the_wrong_way() {
    let rung = "XIC(A)ADD(N,1,N)OTE(B)";
    assert_eq!(element(rung, (0, 0, ElementUpset::None)), (vec![1, 1, 1], 3));
    assert_eq!(element(rung, (0, 0, ElementUpset::Invert)), (vec![1, 0, 0], 3));
    assert_eq!(element(rung, (0, 1, ElementUpset::Skip)), (vec![1, 1, 0], 3));
    assert_eq!(element(rung, (0, 1, ElementUpset::Repeat)), (vec![1, 1, 2], 3));
    assert_eq!(element("XIO(A)OTE(B)", (0, 0, ElementUpset::Skip)), (vec![1, 1, 0], 2));
    assert_eq!(element("AFI()OTE(B)", (0, 0, ElementUpset::Invert)), (vec![1, 1, 0], 2));
}

const CALLED: &str = "ADD_ON_INSTRUCTION_DEFINITION Count_Up (Class := Safety, Revision := \"1.0\")\nPARAMETERS\n\
    Sum : DINT (Usage := InOut, Required := Yes, Visible := Yes);\nEND_PARAMETERS\n\
    ROUTINE Logic\nN: ADD(Sum,1,Sum);\nEND_ROUTINE\nEND_ADD_ON_INSTRUCTION_DEFINITION";

/// A rung with a call on it whose element is upset: `N`, `Behind`, and the elements of the rung as they were asked about.
fn called(call: &str, upset_as: ElementUpset) -> (Vec<i32>, usize) {
    let program =
        format!(")\nROUTINE Main\nN: {call}OTE(Behind);\nEND_ROUTINE\nROUTINE Sub\nN: ADD(N,1,N);\nEND_ROUTINE");
    let mut rig = Rig::new(&project(CALLED, &tags(&["I : Count_Up", "N : DINT", "Behind : BOOL"]), &program));
    let mut upsets = Upsets { element: Some((0, 0, upset_as)), ..Upsets::none() };
    assert_eq!(upset(&mut rig, &mut upsets), ScanEnd::Completed);
    (rig.row(&["N", "Behind"]), upsets.asked.len())
}

#[test]
fn call_when_upset_then_the_routine_runs_never_or_twice_and_is_asked_about_once() {
    for call in ["JSR(Sub,0)", "Count_Up(I,N)"] {
        // Two rungs and three elements, less those of a routine that does not run.
        assert_eq!(called(call, ElementUpset::None), (vec![1, 1], 5), "{call}");
        assert_eq!(called(call, ElementUpset::Skip), (vec![0, 1], 3), "{call}");
        assert_eq!(called(call, ElementUpset::Repeat), (vec![2, 1], 7), "{call}");
        assert_eq!(called(call, ElementUpset::Invert), (vec![1, 0], 5), "{call}");
    }
}

#[test]
fn safety_application_instruction_when_upset_then_its_ladder_is_not_asked_about() {
    let text = "DCS(Stop,E-STOP,EQUIVALENT - ACTIVE HIGH,100,AUTOMATIC,AUTOMATIC,A,B,Valid,Reset)";
    let tag_list = ["A : BOOL", "B : BOOL", "Valid : BOOL", "Reset : BOOL", "Stop : DCI_STOP"];
    let mut rig = rungs(&tag_list, &[text]);
    rig.prescan(0);
    rig.set("A", 1);
    let mut upsets = Upsets { element: Some((0, 0, ElementUpset::Skip)), ..Upsets::none() };
    upset(&mut rig, &mut upsets);
    assert_eq!((rig.get("Stop.ChannelA"), upsets.asked), (0, vec![(0, None), (0, Some(0))]));
    upset(&mut rig, &mut Upsets { element: Some((0, 0, ElementUpset::Repeat)), ..Upsets::none() });
    assert_eq!(rig.get("Stop.ChannelA"), 1);
}

#[test]
fn value_when_upset_on_its_way_then_the_cell_holds_what_arrives() {
    let mut rig = rungs(&["A : BOOL := 1", "B : BOOL", "N : DINT"], &["XIC(A)OTE(B)MOV(5,N)"]);
    upset(&mut rig, &mut Upsets { bit: Some((BitCell(1), false)), word: Some((WordCell(0), -1)), ..Upsets::none() });
    assert_eq!(rig.row(&["B", "N"]), [0, -1]);
    upset(&mut rig, &mut Upsets::none());
    assert_eq!(rig.row(&["B", "N"]), [1, 5]);
}
