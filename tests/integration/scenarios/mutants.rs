//! The ladder without one of its contacts: what a scenario must notice.

use std::path::Path;

use twinrung_bytecode::admit;
use twinrung_bytecode::code::{Mark, Marks};
use twinrung_bytecode::image::Image;
use twinrung_bytecode::index::RoutineIndex;
use twinrung_bytecode::signature::seal;
use twinrung_bytecode::text::render_routine;
use twinrung_catalog::Position;
use twinrung_grammar::read_scenarios;
use twinrung_grammar::tree::Sources;
use twinrung_partner::Partner;
use twinrung_primary::Primary;
use twinrung_workbench::coverage::Coverage;
use twinrung_workbench::scenario::{plan, play};

use super::support::image;
use crate::support::{project_path, text};

/// A condition of the code: its routine, and which condition of the routine it is.
type Contact = (usize, usize);

/// The bytes of the conditions of a routine, in the order of the code, with their mnemonics.
fn conditions(code: &[u8]) -> Vec<(std::ops::Range<usize>, &'static str)> {
    let mut marks = Marks::new(code);
    let mut found = Vec::new();
    let mut begin = 0;
    while let Some(mark) = marks.next() {
        let range = begin..marks.offset();
        begin = marks.offset();
        if let Ok(Mark::Instruction(instruction, _)) = mark {
            found.extend((instruction.position == Position::Input).then_some((range, instruction.mnemonic)));
        }
    }
    found
}

/// Takes a condition out of the code, and out of the text that goes with it: a wire is in its place.
pub fn take_out(records: &mut Image, (routine, condition): Contact) {
    let code = &records.routines[routine].code;
    let (range, _) = conditions(code)[condition].clone();
    records.routines[routine].code = [&code[..range.start], &code[range.end..]].concat();
    let text = render_routine(records, RoutineIndex(routine as u32));
    records.routines[routine].text = text.unwrap_or_else(|error| panic!("{error}"));
}

/// The contacts without which every scenario of a sample is still met.
fn unnoticed(sample: &str) -> (usize, Vec<Contact>) {
    let folder = project_path("samples").join(sample);
    let (whole, _) = image(&text(&folder.join("project.rll")));
    let records = whole.image();
    let contacts: Vec<Contact> = (0..records.routines.len())
        .flat_map(|routine| {
            (0..conditions(&records.routines[routine].code).len()).map(move |contact| (routine, contact))
        })
        .collect();
    let scenarios = text(&folder.join("project.scenario"));
    let unnoticed = contacts.iter().copied().filter(|contact| !is_noticed(records, *contact, &scenarios));
    (contacts.len(), unnoticed.collect())
}

fn is_noticed(records: &Image, contact: Contact, scenarios: &str) -> bool {
    let mut mutant = records.clone();
    take_out(&mut mutant, contact);
    let bytes = seal(&mutant).unwrap_or_else(|error| panic!("{error:?}"));
    let image = admit(&bytes).unwrap_or_else(|error| panic!("{error}"));
    let mut sources = Sources::new();
    let reading = read_scenarios(&mut sources, Path::new("x.scenario"), scenarios.as_bytes().to_vec());
    let (plan, wrong) = plan(&image, &reading.file);
    assert!(wrong.is_empty(), "{wrong:?}");
    let mut coverage = Coverage::new(&image);
    plan.scenarios.iter().any(|scenario| {
        let played = play::<Primary, Partner>(&image, &bytes, scenario, &mut coverage).unwrap();
        !played.failures.is_empty()
    })
}

/// REQ-TEST-031
#[test]
fn emergency_stop_when_any_contact_is_removed_then_a_scenario_fails() {
    assert_eq!(unnoticed("estop-with-contactors"), (7, vec![]));
}

/// REQ-TEST-031
#[test]
fn muting_when_any_contact_is_removed_then_a_scenario_fails() {
    assert_eq!(unnoticed("conveyor-muting-two-sensor"), (8, vec![]));
}

/// REQ-TEST-031
#[test]
fn press_when_any_contact_is_removed_then_a_scenario_fails() {
    assert_eq!(unnoticed("two-hand-press"), (24, vec![]));
}

/// The samples of 1756-RM093 Appendix G.
const SIL_2_PATTERNS: [&str; 5] = [
    "sil-2-single-channel",
    "sil-2-inputs-from-standard",
    "sil-2-dual-channel-outputs",
    "sil-2-outputs-produced",
    "sil-2-outputs-consumed",
];

/// REQ-TEST-031
#[test]
fn sil_2_patterns_when_any_contact_is_removed_then_a_scenario_fails() {
    let counted: Vec<(usize, Vec<Contact>)> = SIL_2_PATTERNS.iter().map(|sample| unnoticed(sample)).collect();
    let expected: Vec<(usize, Vec<Contact>)> =
        [26, 24, 14, 20, 9].into_iter().map(|contacts| (contacts, vec![])).collect();
    assert_eq!(counted, expected);
}

/// A harness that can fail: with a single scenario, contacts that it does not concern go unnoticed.
#[test]
fn contacts_when_one_scenario_is_all_there_is_then_most_go_unnoticed() {
    let (whole, _) = image(&text(&project_path("samples/estop-with-contactors/project.rll")));
    let one = "scenario \"x\"\nthen EStop.O1 is off\nend\n";
    let noticed = (0..7).filter(|contact| is_noticed(whole.image(), (0, *contact), one)).count();
    assert_eq!(noticed, 0);
}
