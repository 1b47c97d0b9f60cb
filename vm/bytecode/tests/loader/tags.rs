//! Rules of tags: scopes, cells, initial values, aliases.

use crate::support::samples::{Rich, rich};
use crate::support::*;

/// The rule that refuses the rich sample after a change.
fn rule(change: impl FnOnce(&mut Rich)) -> &'static str {
    let mut r = rich();
    change(&mut r);
    r.b.rule()
}

#[test]
fn tag_when_out_of_its_scope_then_is_refused() {
    assert_eq!(rule(|r| r.tag(r.tags.y).program = Some(PROGRAM)), "NameOrder");
    assert_eq!(rule(|r| r.tag(r.tags.list).program = Some(PROGRAM)), "TagScope");
    assert_eq!(rule(|r| r.tag(r.tags.local).program = Some(ProgramIndex(7))), "IndexRange");
    assert_eq!(rule(|r| r.tag(r.tags.local).name = "Mod:I".into()), "Name");
    assert_eq!(rule(|r| r.tag(r.tags.y).name = "x3".into()), "NameTwice");
    assert_eq!(rule(|r| r.tag(r.tags.local).kind = TagKind::Produced), "TagConnection");
}

#[test]
fn cells_when_not_assigned_in_table_order_then_are_refused() {
    assert_eq!(rule(|r| r.tag(r.tags.y).word_cell += 1), "TagCells");
    assert_eq!(rule(|r| r.tag(r.tags.y).bit_cell += 1), "TagCells");
    assert_eq!(rule(|r| r.tag(r.tags.alias).word_cell = 1), "TagCells");
    assert_eq!(rule(|r| r.tag(r.tags.local).dimensions = [0, 1, 0]), "TagDimensions");
    assert_eq!(rule(|r| r.tag(r.tags.local).dimensions = [1 << 20, 2, 0]), "TagDimensions");
    assert_eq!(rule(|r| r.tag(r.tags.local).type_reference = TypeReference::Structure(TypeIndex(9))), "IndexRange");
    assert_eq!(rule(|r| r.b.image.initial_bits.push(0)), "CellCount");
    assert_eq!(rule(|r| _ = r.b.image.initial_words.pop()), "CellCount");
}

#[test]
fn cells_when_more_than_an_image_has_then_are_refused() {
    let arrays = |count: u32| {
        let mut b = build();
        for index in 0..count {
            b.image.tags.push(TagRecord {
                name: format!("T{index:02}"),
                program: None,
                type_reference: BOOL,
                dimensions: [1 << 20, 0, 0],
                kind: TagKind::Base,
                constant: false,
                bit_cell: index << 20,
                word_cell: 0,
                attributes: vec![],
            });
        }
        b.rule()
    };
    assert_eq!(arrays(16), "CellCount");
    assert_eq!(arrays(17), "TooManyCells");
}

#[test]
fn initial_value_when_its_type_does_not_have_it_then_is_refused() {
    let part_word = |word: usize, value: i32| {
        rule(|r| {
            let cell = r.tag(r.tags.parts).word_cell as usize;
            r.b.image.initial_words[cell + 3 + word] = value;
        })
    };
    assert_eq!(part_word(0, i32::MIN), "admitted");
    assert_eq!(part_word(1, -32_768), "admitted");
    assert_eq!(part_word(2, 32_767), "admitted");
    assert_eq!(part_word(1, -32_769), "InitialWord");
    assert_eq!(part_word(2, 32_768), "InitialWord");
    let real = |bits: u32| {
        rule(|r| {
            let cell = r.tag(r.tags.real).word_cell as usize;
            r.b.image.initial_words[cell] = bits.cast_signed();
        })
    };
    assert_eq!(real(f32::INFINITY.to_bits()), "admitted");
    assert_eq!(real(0x7FC0_0000), "admitted");
    assert_eq!(real(0x7FC0_0001), "InitialWord");
    assert_eq!(rule(|r| r.b.image.initial_bits[0] = 1), "admitted");
    assert_eq!(rule(|r| r.b.image.initial_bits[0] = 2), "InitialBit");
}

#[test]
fn initial_value_of_sint_when_beyond_its_range_then_is_refused() {
    let sint = |value| {
        let mut b = build();
        let tag = b.tag_of("S", SINT, [2, 0, 0], TagKind::Base);
        b.image.initial_words[b.image.tags[tag.position()].word_cell as usize + 1] = value;
        b.rule()
    };
    assert_eq!(sint(-128), "admitted");
    assert_eq!(sint(127), "admitted");
    assert_eq!(sint(-129), "InitialWord");
    assert_eq!(sint(128), "InitialWord");
}

/// An alias behind all other tags of the controller, of what an operand designates.
fn alias(target: impl FnOnce(&mut Rich) -> OperandIndex, type_reference: TypeReference) -> &'static str {
    let mut r = rich();
    let target = target(&mut r);
    let mut tag = r.b.image.tags[r.tags.alias.position()].clone();
    (tag.name, tag.kind, tag.type_reference) = ("Z".into(), TagKind::Alias(target), type_reference);
    let end = r.tags.local.position();
    r.b.image.tags.insert(end, tag);
    r.b.rule()
}

#[test]
fn alias_when_it_leads_to_fixed_data_then_is_admitted() {
    // Operands that name the program's own tag would move with the insertion: the alias stands before it.
    let without_local = |r: &mut Rich| {
        r.b.image.routines[0].code.clear();
        r.b.rung(&[op(Opcode::Afi, &[])]);
        let empty = OperandTable::default();
        let kept = (0..1).map(|index| r.b.image.operands.entry(OperandIndex(index)).unwrap().to_vec());
        let kept: Vec<Vec<u8>> = kept.collect();
        r.b.image.operands = empty;
        r.b.image.routines[1].code.clear();
        r.b.image.routines[2].code.clear();
        for bytes in kept {
            r.b.operand(OperandRecord::decode(&bytes).unwrap());
        }
    };
    let to_element = |r: &mut Rich| {
        without_local(r);
        r.list_element(1)
    };
    assert_eq!(alias(to_element, DINT), "admitted");
    assert_eq!(alias(to_element, INT), "AliasType");
    assert_eq!(alias(to_element, BOOL), "AliasType");
    let to_alias = |r: &mut Rich| {
        without_local(r);
        let target = OperandRecord::decode(r.b.image.operands.entry(OperandIndex(0)).unwrap()).unwrap();
        let Shape::WordBit(bit) = access_of(&target).shape else { unreachable!() };
        let there = Access { shape: Shape::WordBit(bit), ..access_of(&target) };
        r.b.reference(Root::Tag(r.tags.alias), &[], there)
    };
    assert_eq!(alias(to_alias, BOOL), "admitted");
    let variable = |r: &mut Rich| {
        without_local(r);
        let word = r.b.whole(r.tags.word);
        r.list_at(word)
    };
    assert_eq!(alias(variable, DINT), "AliasTarget");
    let literal = |r: &mut Rich| {
        without_local(r);
        r.b.integer(5)
    };
    assert_eq!(alias(literal, DINT), "AliasTarget");
}

fn access_of(record: &OperandRecord) -> Access {
    match record {
        OperandRecord::Reference(reference) => reference.access.clone(),
        _ => unreachable!(),
    }
}

#[test]
fn alias_when_it_leads_into_a_program_or_to_itself_then_is_refused() {
    let retarget = |tag: TagIndex| {
        let mut r = rich();
        let at = r.b.image.tags[tag.position()].clone();
        let there = access(Shape::Word, element(Element::Dint), at.bit_cell, at.word_cell, 1);
        let target = r.b.reference(Root::Tag(tag), &[], there);
        r.tag(r.tags.alias).kind = TagKind::Alias(target);
        r.b.rule()
    };
    let tags = rich().tags;
    assert_eq!(retarget(tags.local), "AliasTarget");
    assert_eq!(retarget(tags.alias), "AliasCircle");
    assert_eq!(retarget(tags.word), "AliasType");
    assert_eq!(rule(|r| r.tag(r.tags.alias).kind = TagKind::Alias(OperandIndex(9999))), "NoSuchOperand");
}

#[test]
fn alias_of_a_program_when_the_program_hides_the_target_then_is_refused() {
    let mut b = build();
    let word = b.tag("Word", DINT);
    let target = b.whole(word);
    b.scoped_tag("Other", Some(PROGRAM), DINT, SCALAR, TagKind::Alias(target));
    assert_eq!(b.rule(), "admitted");
    b.scoped_tag("Word", Some(PROGRAM), DINT, SCALAR, TagKind::Base);
    assert_eq!(b.rule(), "AliasTarget");
}
