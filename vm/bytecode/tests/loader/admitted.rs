//! What an admitted image answers, and that its bytes have one form.

use crate::support::samples::{rich, small};
use crate::support::*;
use twinrung_bytecode::signature::{self, Group, LeafKind, long_form, short_form};
use twinrung_bytecode::{admit, container, encode, read, seal};

#[test]
fn image_when_sealed_then_reads_back_and_encodes_to_the_same_bytes() {
    let mut r = rich();
    let bytes = r.b.bytes();
    let back = read(&bytes).unwrap();
    assert_eq!(back.image, r.b.image);
    assert_eq!(encode(&back.image, &back.carried), bytes);
    assert_eq!(seal(&back.image).unwrap(), bytes);
}

#[test]
fn image_without_operands_when_sealed_then_reads_back() {
    let mut b = build();
    b.rung(&[op(Opcode::Afi, &[])]);
    let bytes = b.bytes();
    assert_eq!(read(&bytes).unwrap().image, b.image);
    assert!(admit(&bytes).is_ok());
}

#[test]
fn image_when_admitted_then_answers_for_signatures_rungs_and_connections() {
    let mut r = rich();
    let bytes = r.b.bytes();
    let admitted = admit(&bytes).unwrap();
    let leaves = signature::leaves(admitted.image()).unwrap();
    assert_eq!(admitted.application_signature(), &signature::application_signature(&leaves));
    assert_eq!(bytes[container::HEADER_BYTES - 64..][..32], *admitted.application_signature());
    assert_eq!(bytes[container::HEADER_BYTES - 32..][..32], *admitted.image_signature());
    assert_eq!(admitted.rung_counts(), [9, 2, 1]);
    assert_eq!(admitted.rungs(MAIN), 9);
    assert_eq!(admitted.rungs(RoutineIndex(99)), 0);
    let frozen: Vec<TagIndex> = admitted.frozen().iter().map(|range| range.tag).collect();
    assert_eq!(frozen, [r.tags.mapped, r.tags.input]);
    let input = &admitted.frozen()[1];
    assert_eq!((input.bit_cells, input.word_cells), (2, 3));
    assert!(admitted.published().is_empty());
}

#[test]
fn output_and_produced_tags_when_admitted_then_are_published() {
    let mut b = build();
    b.tag_of("M:I", BOOL, SCALAR, TagKind::Consumed);
    b.tag_of("M:O", DINT, [3, 0, 0], TagKind::ModuleOutput);
    b.tag_of("P", BOOL, SCALAR, TagKind::Produced);
    let admitted = b.admit().unwrap();
    let published: Vec<_> =
        admitted.published().iter().map(|range| (range.tag, range.bit_cells, range.word_cells)).collect();
    assert_eq!(published, [(TagIndex(1), 0, 3), (TagIndex(2), 1, 0)]);
    assert_eq!(admitted.frozen().len(), 1);
}

#[test]
fn cells_when_logic_writes_them_then_are_in_the_set() {
    let mut r = rich();
    let admitted = r.b.admit().unwrap();
    let writes = admitted.program_writes();
    let bit = |tag: TagIndex| writes.has_bit(BitCell(admitted.image().tags[tag.position()].bit_cell));
    let word =
        |tag: TagIndex, index: u32| writes.has_word(WordCell(admitted.image().tags[tag.position()].word_cell + index));
    // OTE, MOV, DCS, TON, COP of elements 1 and 2, the instance, CPT.
    assert!(word(r.tags.y, 0) && bit(r.tags.stop) && bit(r.tags.time) && bit(r.tags.instance) && word(r.tags.local, 0));
    assert!(!word(r.tags.parts, 0) && word(r.tags.parts, 3) && word(r.tags.parts, 8));
    // Only read: the logic of the Add-On Instruction does not write its InOut parameter.
    assert!(!word(r.tags.word, 0) && !word(r.tags.list, 0) && !bit(r.tags.mapped));
    assert!(!writes.has_bit(BitCell(u32::MAX)) && !writes.has_word(WordCell(u32::MAX)));
}

#[test]
fn in_out_argument_when_the_logic_writes_the_parameter_then_is_in_the_set() {
    let mut r = rich();
    let (gain, reference) = (r.member(2, 0), r.in_out());
    r.b.rung_in(r.logic, &[op(Opcode::Mov, &[gain, reference])]);
    let admitted = r.b.admit().unwrap();
    let cell = admitted.image().tags[r.tags.word.position()].word_cell;
    assert!(admitted.program_writes().has_word(WordCell(cell)));
}

#[test]
fn element_when_a_variable_subscript_writes_it_then_the_whole_array_is_in_the_set() {
    let mut r = rich();
    let selected = r.list_at(r.word);
    r.b.rung(&[op(Opcode::Clr, &[selected])]);
    let admitted = r.b.admit().unwrap();
    let cell = admitted.image().tags[r.tags.list.position()].word_cell;
    let written = [0, 1, 2, 3].map(|index| admitted.program_writes().has_word(WordCell(cell + index)));
    assert_eq!(written, [true; 4]);
}

#[test]
fn leaves_when_listed_then_name_everything_that_is_signed() {
    let mut r = rich();
    r.b.texts();
    let leaves = signature::leaves(&r.b.image).unwrap();
    let names: Vec<(LeafKind, &str)> = leaves.iter().map(|leaf| (leaf.kind, leaf.name.as_str())).collect();
    assert_eq!(
        names,
        [
            (LeafKind::Routine, "Main/Main"),
            (LeafKind::Routine, "Main/Sub"),
            (LeafKind::Routine, "Scale/Logic"),
            (LeafKind::Program, "Main"),
            (LeafKind::AddOn, "Scale"),
            (LeafKind::Type, "Part"),
            (LeafKind::Tags, ""),
            (LeafKind::Tags, "Main"),
            (LeafKind::Controller, "Cell"),
            (LeafKind::Task, "Safety_Task"),
            (LeafKind::Module, "Mod"),
            (LeafKind::Map, ""),
        ]
    );
    assert_eq!(LeafKind::Tags.group(), Group::Data);
}

/// The leaves that differ after a change, and whether the application signature does.
fn moved(change: impl FnOnce(&mut Image)) -> (Vec<String>, bool) {
    let mut r = rich();
    r.b.texts();
    let before = signature::leaves(&r.b.image).unwrap();
    change(&mut r.b.image);
    let after = signature::leaves(&r.b.image).unwrap();
    let names = before.iter().zip(&after).filter(|(old, new)| old.hash != new.hash);
    let names = names.map(|(old, _)| format!("{} {}", old.kind.name(), old.name)).collect();
    (names, signature::application_signature(&before) != signature::application_signature(&after))
}

#[test]
fn leaf_when_its_content_changes_then_alone_moves_and_the_signature_with_it() {
    let one = |name: &str| (vec![name.to_string()], true);
    assert_eq!(moved(|image| image.routines[0].text.push(' ')), one("routine Main/Main"));
    assert_eq!(moved(|image| image.programs[0].disabled = true), one("program Main"));
    assert_eq!(moved(|image| image.add_ons[0].parameters[2].argument = false), one("Add-On Instruction Scale"));
    assert_eq!(moved(|image| image.add_ons[0].attributes[0].1 = "2".into()), one("Add-On Instruction Scale"));
    assert_eq!(moved(|image| image.types[2].members[0].name = "Z".into()), one("type Part"));
    assert_eq!(moved(|image| image.initial_bits[0] = 1), one("tags "));
    assert_eq!(moved(|image| image.tags.last_mut().unwrap().name = "Other".into()), one("tags Main"));
    assert_eq!(moved(|image| image.controller.revision = 21), one("controller Cell"));
    assert_eq!(moved(|image| image.task.as_mut().unwrap().period_us += 1), one("task Safety_Task"));
    assert_eq!(moved(|image| image.modules[0].text.push(' ')), one("module Mod"));
    assert_eq!(moved(|image| image.map[0].standard.push('2')), one("tag map "));
    // Bytecode is the image signature's affair.
    assert_eq!(moved(|image| image.routines[0].code.clear()), (vec![], false));
}

#[test]
fn signature_when_printed_then_in_the_makers_short_form() {
    let mut signature = [0; 32];
    signature[..4].copy_from_slice(&[0x11, 0xb2, 0x53, 0x6b]);
    assert_eq!(short_form(&signature).to_string(), "11b2_536b");
    assert!(long_form(&signature).starts_with("11b2536b00"));
    assert_eq!(long_form(&signature).len(), 64);
}

/// The application signature of the small sample must never change: it is what people wrote down (REQ: DESIGN 5).
#[test]
fn application_signature_when_the_tool_changes_then_stays() {
    let mut b = small();
    b.texts();
    let leaves = signature::leaves(&b.image).unwrap();
    assert_eq!(long_form(&signature::application_signature(&leaves)), include_str!("small.signature").trim());
}

#[test]
fn sections_when_placed_then_cover_the_file() {
    let mut r = rich();
    let bytes = r.b.bytes();
    let places = container::section_places(&bytes).unwrap();
    let last = places.last().unwrap();
    assert_eq!(places[0].offset, container::HEADER_BYTES);
    assert_eq!(last.offset + last.length, bytes.len());
    assert_eq!(places[2].section.name(), "Add-On Instructions");
}
