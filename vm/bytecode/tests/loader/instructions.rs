//! Rules of instructions: admission, operand kinds, writes, backing tags, copies, system values.

use twinrung_bytecode::limits;

use crate::support::samples::{Rich, SCALE, rich};
use crate::support::*;

/// The rule that refuses the rich sample with one more rung in the main routine.
fn rule(element: impl FnOnce(&mut Rich) -> Vec<u8>) -> &'static str {
    let mut r = rich();
    let element = element(&mut r);
    r.rule_with(&[element])
}

#[test]
fn instruction_when_the_controller_lacks_it_then_is_refused() {
    let cmp = |processor: &str, revision| {
        let mut b = build_for(processor, revision);
        let word = b.data("W", DINT);
        let expression = b.expression(&[Operation::Push(word)]);
        b.rung(&[op(Opcode::Cmp, &[expression])]);
        b.rule()
    };
    assert_eq!(cmp("1756-L72S", 20), "admitted");
    assert_eq!(cmp("1756-L63S", 20), "InstructionRequires");
    let event = |revision| {
        let mut b = build_for("1756-L62S", revision);
        b.image.event_tasks.push("Report".into());
        let task = b.operand(OperandRecord::EventTask(EventTaskIndex(0)));
        b.rung(&[op(Opcode::Event, &[task])]);
        b.rule()
    };
    assert_eq!(event(20), "admitted");
    assert_eq!(event(19), "InstructionVersion");
}

#[test]
fn operands_when_not_as_many_as_declared_then_are_refused() {
    assert_eq!(rule(|_| op(Opcode::Xic, &[])), "OperandCount");
    assert_eq!(rule(|r| op(Opcode::Xic, &[r.x[0], r.x[1]])), "OperandCount");
    assert_eq!(rule(|r| op(Opcode::Jsr, &[r.sub])), "OperandCount");
    assert_eq!(rule(|r| op(Opcode::Afi, &[r.x[0]])), "OperandCount");
}

#[test]
fn operand_when_not_of_the_declared_kind_then_is_refused() {
    assert_eq!(rule(|r| op(Opcode::Xic, &[r.word])), "OperandKind");
    assert_eq!(rule(|r| op(Opcode::Xic, &[r.b.integer(1)])), "OperandKind");
    assert_eq!(rule(|r| op(Opcode::Xic, &[r.alias])), "admitted");
    assert_eq!(rule(|r| op(Opcode::Ote, &[r.b.operand(OperandRecord::Status(0))])), "OperandKind");
    assert_eq!(rule(|r| op(Opcode::Mov, &[r.x[0], r.y])), "OperandKind");
    assert_eq!(rule(|r| op(Opcode::Mov, &[r.word, r.b.integer(1)])), "OperandKind");
    assert_eq!(rule(|r| op(Opcode::Mov, &[r.list, r.y])), "OperandKind");
    assert_eq!(rule(|r| op(Opcode::And, &[r.word, r.real, r.y])), "OperandKind");
    assert_eq!(rule(|r| op(Opcode::Ton, &[r.stop, r.word, r.word])), "OperandKind");
    assert_eq!(rule(|r| op(Opcode::Res, &[r.time])), "admitted");
    assert_eq!(rule(|r| op(Opcode::Res, &[r.stop])), "OperandKind");
    assert_eq!(rule(|r| op(Opcode::Cpt, &[r.y, r.word])), "OperandKind");
    assert_eq!(rule(|r| op(Opcode::Xic, &[r.b.operand(OperandRecord::Unassigned)])), "OperandKind");
    assert_eq!(rule(|r| op(Opcode::Jsr, &[r.word, r.word])), "OperandKind");
}

#[test]
fn relation_when_in_an_expression_that_is_no_condition_then_is_refused() {
    let relation = |opcode: fn(&mut Rich, OperandIndex) -> Vec<u8>| {
        rule(|r| {
            let operations = [
                Operation::Push(r.word),
                Operation::Push(r.y),
                Operation::Apply(twinrung_bytecode::format::OPERATION_EQUAL),
            ];
            let expression = r.b.expression(&operations);
            opcode(r, expression)
        })
    };
    assert_eq!(relation(|_, expression| op(Opcode::Cmp, &[expression])), "admitted");
    assert_eq!(relation(|r, expression| op(Opcode::Cpt, &[r.y, expression])), "OperandKind");
}

#[test]
fn literal_when_out_of_the_declared_range_then_is_refused() {
    // Operand 3 is the discrepancy time, 5 to 3000 ms; 1 the safety function; 8 an immediate bit.
    let dcs = |position: usize, record: OperandRecord| {
        let mut r = rich();
        let mut element = r.stop_call(r.stop);
        let operand = r.b.operand(record);
        element[2 + 4 * position..][..4].copy_from_slice(&operand.0.to_le_bytes());
        // In the place of the sample's own call: a backing tag serves one.
        let code = r.b.image.routines[0].code.clone();
        let at = code.windows(2).position(|pair| pair == [Opcode::Dcs as u8, 10]).unwrap();
        r.b.image.routines[0].code[at..at + element.len()].copy_from_slice(&element);
        r.b.rule()
    };
    let integer = |value| OperandRecord::Integer { radix: 10, value };
    assert_eq!(dcs(3, integer(5)), "admitted");
    assert_eq!(dcs(3, integer(4)), "OperandRange");
    assert_eq!(dcs(3, integer(3000)), "admitted");
    assert_eq!(dcs(3, integer(3001)), "OperandRange");
    assert_eq!(dcs(3, OperandRecord::Integer { radix: 16, value: 500 }), "admitted");
    assert_eq!(dcs(1, OperandRecord::Choice(100)), "admitted");
    assert_eq!(dcs(1, OperandRecord::Choice(7)), "OperandWithoutText");
    assert_eq!(dcs(1, integer(1)), "OperandKind");
    assert_eq!(dcs(8, integer(0)), "admitted");
    assert_eq!(dcs(8, integer(2)), "OperandRange");
    assert_eq!(dcs(6, integer(1)), "OperandKind");
}

#[test]
fn mode_when_no_word_of_it_has_the_value_then_is_refused() {
    let fal = |mode: i32| {
        let mut b = build();
        let control = b.predefined("CONTROL");
        let (control, word) = (b.data("C", control), b.data("W", DINT));
        let unassigned = b.operand(OperandRecord::Unassigned);
        let mode = b.operand(OperandRecord::Choice(mode));
        let expression = b.expression(&[Operation::Push(word)]);
        b.rung(&[op(Opcode::Fal, &[control, unassigned, unassigned, mode, word, expression])]);
        b.rule()
    };
    assert_eq!([0, -1, 1, i32::MAX].map(fal), ["admitted"; 4]);
    assert_eq!(fal(-2), "OperandWithoutText");
}

#[test]
fn tag_when_logic_may_not_write_it_then_is_refused() {
    let ote = |change: fn(&mut Rich) -> TagIndex| {
        let mut r = rich();
        let tag = change(&mut r);
        let operand = r.b.whole(tag);
        r.rule_with(&[op(Opcode::Ote, &[operand])])
    };
    assert_eq!(ote(|r| r.tags.mapped), "WriteMapped");
    let mut b = build();
    let consumed = b.tag_of("C", BOOL, SCALAR, TagKind::Consumed);
    let operand = b.whole(consumed);
    assert_eq!(b.clone().rung(&[op(Opcode::Xic, &[operand])]).rule(), "admitted");
    assert_eq!(b.rung(&[op(Opcode::Ote, &[operand])]).rule(), "WriteConsumed");
    let constant = |rung: fn(&mut Rich) -> Vec<u8>| {
        let mut r = rich();
        r.tag(r.tags.list).constant = true;
        let element = rung(&mut r);
        r.rule_with(&[element])
    };
    assert_eq!(constant(|r| op(Opcode::Mov, &[r.list_element(0), r.y])), "admitted");
    assert_eq!(constant(|r| op(Opcode::Clr, &[r.list_element(0)])), "WriteConstant");
    assert_eq!(constant(|r| op(Opcode::Fll, &[r.word, r.list, r.b.integer(1)])), "WriteConstant");
}

#[test]
fn alias_when_constant_then_nothing_writes_through_it() {
    let mut r = rich();
    r.tag(r.tags.alias).constant = true;
    assert_eq!(r.b.rule(), "admitted");
    assert_eq!(r.rule_with(&[op(Opcode::Otl, &[r.alias])]), "WriteConstant");
}

#[test]
fn in_out_argument_when_the_logic_writes_it_then_it_is_a_write() {
    let mut r = rich();
    r.tag(r.tags.word).constant = true;
    assert_eq!(r.b.rule(), "admitted");
    let (gain, reference) = (r.member(2, 0), r.in_out());
    r.b.rung_in(r.logic, &[op(Opcode::Mov, &[gain, reference])]);
    assert_eq!(r.b.rule(), "WriteConstant");
}

#[test]
fn controller_tag_when_the_program_hides_its_name_then_is_refused() {
    let mut r = rich();
    r.b.scoped_tag("WORD", Some(PROGRAM), DINT, SCALAR, TagKind::Base);
    assert_eq!(r.b.rule(), "HiddenTag");
    let mut r = rich();
    r.b.scoped_tag("Other", Some(PROGRAM), DINT, SCALAR, TagKind::Base);
    assert_eq!(r.b.rule(), "admitted");
}

#[test]
fn backing_tag_when_written_by_others_then_is_refused() {
    let known = PredefinedType::by_name("DCI_STOP").unwrap();
    let (member, _) = known.member("O1").unwrap();
    let with = |element: fn(OperandIndex) -> Vec<u8>| {
        let mut r = rich();
        let base = r.b.image.tags[r.tags.stop.position()].clone();
        let bits = known.members[..member].iter().filter(|member| member.element == Element::Bool).count() as u32;
        let words = member as u32 - bits;
        let there = access(Shape::Bit, element_bool(), base.bit_cell + bits, base.word_cell + words, 1);
        let output = r.b.reference(Root::Tag(r.tags.stop), &[Step::Member(member as u16)], there);
        r.rule_with(&[element(output)])
    };
    assert_eq!(with(|output| op(Opcode::Xic, &[output])), "admitted");
    assert_eq!(with(|output| op(Opcode::Otu, &[output])), "WriteBacking");
    assert_eq!(rule(|r| op(Opcode::Ret, &[r.stop])), "OperandKind");
}

fn element_bool() -> AccessType {
    AccessType::Element(Element::Bool)
}

#[test]
fn backing_tag_when_it_serves_two_calls_or_is_selected_then_is_refused() {
    assert_eq!(rule(|r| r.stop_call(r.stop)), "BackingTwice");
    let array = |subscript: fn(&Rich) -> Subscript| {
        let mut r = rich();
        let kind = r.b.image.tags[r.tags.stop.position()].type_reference;
        let stops = r.b.scoped_tag("Stops", Some(PROGRAM), kind, [2, 0, 0], TagKind::Base);
        let layouts = twinrung_bytecode::layout::layouts(&r.b.image.types).unwrap();
        let (bit_stride, word_stride) = twinrung_bytecode::layout::cells(&layouts, kind).unwrap();
        let subscript = subscript(&r);
        let cells = r.b.image.tags[stops.position()].clone();
        let TypeReference::Structure(index) = kind else { unreachable!() };
        let mut there = access(Shape::Region, AccessType::Structure(index), cells.bit_cell, cells.word_cell, 2);
        let operand = [subscript].into_iter().find_map(|subscript| match subscript {
            Subscript::Operand(operand) => Some(operand),
            Subscript::Constant(_) => None,
        });
        there.terms = operand.map(|operand| Term { operand, length: 2, bit_stride, word_stride }).into_iter().collect();
        let backing = r.b.reference(Root::Tag(stops), &[Step::Subscript(vec![subscript])], there);
        let element = r.stop_call(backing);
        r.rule_with(&[element])
    };
    assert_eq!(array(|_| Subscript::Constant(0)), "admitted");
    assert_eq!(array(|r| Subscript::Operand(r.word)), "BackingVariable");
}

/// An Add-On Instruction that calls DCS on a local tag, and its instances.
fn guarded() -> (Build, [OperandIndex; 2], RoutineIndex, [OperandIndex; 9]) {
    let mut b = build();
    let dci_stop = b.predefined("DCI_STOP");
    let member = |name: &str, type_reference| MemberRecord { name: name.into(), type_reference, dimensions: SCALAR };
    let members = vec![member("EnableIn", BOOL), member("EnableOut", BOOL), member("Stop", dci_stop)];
    let guard = b.structure("Guard", TypeKind::AddOn(SCALE), members);
    let instances = ["G1", "G2"].map(|name| b.data(name, guard));
    let logic = b.routine("Logic", Owner::AddOn(SCALE));
    let parameter = |name: &str, usage, member| ParameterRecord {
        name: name.into(),
        usage,
        type_reference: BOOL,
        dimensions: SCALAR,
        argument: false,
        member: Some(member),
    };
    b.image.add_ons.push(AddOnRecord {
        name: "Guard".into(),
        instance_type: TypeIndex(1),
        parameters: vec![parameter("EnableIn", Usage::Input, 0), parameter("EnableOut", Usage::Output, 1)],
        logic,
        prescan: None,
        enable_in_false: None,
        attributes: vec![],
    });
    let region = access(Shape::Region, AccessType::Structure(TypeIndex(0)), 2, 0, 1);
    let stop = b.reference(Root::Member(SCALE, 2), &[], Access { base: Base::Instance, ..region });
    let enable = |b: &mut Build, member: u16| {
        let bit = access(Shape::Bit, element_bool(), u32::from(member), 0, 1);
        b.reference(Root::Member(SCALE, member), &[], Access { base: Base::Instance, ..bit })
    };
    let (first, second) = (enable(&mut b, 0), enable(&mut b, 1));
    let [function, zero] = [1, 0].map(|value| b.operand(OperandRecord::Choice(value)));
    let (discrepancy, status) = (b.integer(500), b.integer(1));
    let operands = [function, zero, discrepancy, zero, zero, first, second, status, first];
    let mut all = vec![stop];
    all.extend(operands);
    b.rung_in(logic, &[op(Opcode::Dcs, &all)]);
    (b, instances, logic, operands)
}

#[test]
fn instance_that_holds_a_backing_tag_when_called_twice_then_is_refused() {
    let (mut b, [first, second], ..) = guarded();
    b.rung(&[call(&[first])]).rung(&[call(&[second])]);
    assert_eq!(b.rule(), "admitted");
    b.rung(&[call(&[first])]);
    assert_eq!(b.rule(), "BackingTwice");
}

#[test]
fn backing_tag_within_an_instance_when_named_outside_then_is_refused() {
    let (mut b, ..) = guarded();
    let there = access(Shape::Region, AccessType::Structure(TypeIndex(0)), 2, 0, 1);
    b.reference(Root::Tag(TagIndex(0)), &[Step::Member(2)], there);
    assert_eq!(b.rule(), "PathPrivate");
}

/// Backing tags that pass through InOut parameters count at every call: 1,024 calls of 1,024 are as many as there may be.
#[test]
fn calls_with_backing_tags_when_too_many_then_are_refused() {
    let with = |callers: u16| {
        let mut b = build();
        let dci_stop = b.predefined("DCI_STOP");
        let layouts = twinrung_bytecode::layout::layouts(&b.image.types).unwrap();
        let (bits, words) = twinrung_bytecode::layout::cells(&layouts, dci_stop).unwrap();
        let member = |name: &str| MemberRecord { name: name.into(), type_reference: BOOL, dimensions: SCALAR };
        for index in 0..=callers {
            let members = vec![member("EnableIn"), member("EnableOut")];
            b.structure(&format!("A{index:04}"), TypeKind::AddOn(AddOnIndex(index)), members);
        }
        let parameter = |name: &str, usage, type_reference, dimensions, argument, member| ParameterRecord {
            name: name.into(),
            usage,
            type_reference,
            dimensions,
            argument,
            member,
        };
        for index in 0..=callers {
            let add_on = AddOnIndex(index);
            let logic = b.routine("Logic", Owner::AddOn(add_on));
            let callee = TypeReference::Structure(TypeIndex(1));
            let mut parameters = vec![
                parameter("EnableIn", Usage::Input, BOOL, SCALAR, false, Some(0)),
                parameter("EnableOut", Usage::Output, BOOL, SCALAR, false, Some(1)),
                parameter("Stops", Usage::InOut, dci_stop, [1024, 0, 0], true, None),
            ];
            parameters.extend((index > 0).then(|| parameter("Inner", Usage::InOut, callee, SCALAR, true, None)));
            b.image.add_ons.push(AddOnRecord {
                name: format!("A{index:04}"),
                instance_type: TypeIndex(index + 1),
                parameters,
                logic,
                prescan: None,
                enable_in_false: None,
                attributes: vec![],
            });
        }
        let enable = access(Shape::Bit, element_bool(), 0, 0, 1);
        let enable = b.reference(Root::Member(SCALE, 0), &[], Access { base: Base::Instance, ..enable });
        let enable_out = access(Shape::Bit, element_bool(), 1, 0, 1);
        let enable_out = b.reference(Root::Member(SCALE, 1), &[], Access { base: Base::Instance, ..enable_out });
        let [function, zero] = [1, 0].map(|value| b.operand(OperandRecord::Choice(value)));
        let (discrepancy, status) = (b.integer(500), b.integer(1));
        for index in 0..1024 {
            let region =
                access(Shape::Region, AccessType::Structure(TypeIndex(0)), bits * index, words * index, 1024 - index);
            let there = Access { base: Base::InOut(2), ..region };
            let stop = b.reference(Root::InOut(SCALE, 2), &[Step::Subscript(vec![Subscript::Constant(index)])], there);
            let operands = [stop, function, zero, discrepancy, zero, zero, enable, enable_out, status, enable];
            b.rung_in(RoutineIndex(1), &[op(Opcode::Dcs, &operands)]);
        }
        for index in 1..=callers {
            let add_on = AddOnIndex(index);
            let inner = access(Shape::Region, AccessType::Structure(TypeIndex(1)), 0, 0, 1);
            let inner = b.reference(Root::InOut(add_on, 3), &[], Access { base: Base::InOut(3), ..inner });
            let stops = access(Shape::Region, AccessType::Structure(TypeIndex(0)), 0, 0, 1024);
            let stops = b.reference(Root::InOut(add_on, 2), &[], Access { base: Base::InOut(2), ..stops });
            b.rung_in(RoutineIndex(u32::from(index) + 1), &[call(&[inner, stops])]);
        }
        b.rule()
    };
    assert_eq!(limits::BACKING_CALLS, 1024 * 1024);
    assert_eq!(with(1023), "admitted");
    assert_eq!(with(1024), "BackingCount");
}

#[test]
fn preset_when_not_what_the_tag_begins_with_then_is_refused() {
    let preset = |value: i32, initial: i32| {
        let mut r = rich();
        let cell = r.tag(r.tags.time).word_cell as usize;
        r.b.image.initial_words[cell] = initial;
        let (value, accumulated) = (r.b.integer(value), r.b.operand(OperandRecord::Unassigned));
        r.rule_with(&[op(Opcode::Ton, &[r.time, value, accumulated])])
    };
    assert_eq!(preset(5000, 5000), "admitted");
    assert_eq!(preset(5000, 0), "PresetDiffers");
}

#[test]
fn copy_when_sizes_or_lengths_differ_then_is_refused() {
    let cop = |operands: fn(&mut Rich) -> [OperandIndex; 3]| rule(|r| op(Opcode::Cop, &operands(r)));
    assert_eq!(cop(|r| [r.list_element(0), r.list_element(2), r.b.integer(2)]), "admitted");
    assert_eq!(cop(|r| [r.list, r.list, r.b.integer(4)]), "admitted");
    assert_eq!(cop(|r| [r.real, r.y, r.b.integer(1)]), "admitted");
    assert_eq!(cop(|r| [r.time, r.part_at(0), r.b.integer(1)]), "admitted");
    assert_eq!(cop(|r| [r.list_element(0), r.list_element(3), r.b.integer(2)]), "CopyLength");
    assert_eq!(cop(|r| [r.list_element(3), r.list_element(0), r.b.integer(2)]), "CopyLength");
    assert_eq!(cop(|r| [r.word, r.part_at(0), r.b.integer(1)]), "CopySize");
    assert_eq!(cop(|r| [r.x[0], r.x[1], r.b.integer(1)]), "CopyType");
    assert_eq!(cop(|r| [r.stop, r.stop, r.b.integer(1)]), "CopyType");
    assert_eq!(cop(|r| [r.instance, r.instance, r.b.integer(1)]), "CopyType");
    assert_eq!(cop(|r| [r.word, r.y, r.b.integer(0)]), "OperandRange");
    assert_eq!(cop(|r| [r.word, r.y, r.word]), "OperandKind");
    assert_eq!(cop(|r| [r.alias, r.y, r.b.integer(1)]), "OperandKind");
}

#[test]
fn copy_when_of_more_bytes_than_one_moves_then_is_refused() {
    let most = limits::COPY_BYTES / 4;
    let cop = |opcode: Opcode, elements: u32| {
        let mut b = build();
        let tags = ["A", "B"].map(|name| b.tag_of(name, DINT, [most + 1, 0, 0], TagKind::Base));
        let [source, destination] = tags.map(|tag| b.whole(tag));
        let (length, zero) = (b.integer(elements as i32), b.integer(0));
        let source = if opcode == Opcode::Fll { zero } else { source };
        b.rung(&[op(opcode, &[source, destination, length])]);
        b.rule()
    };
    assert_eq!(cop(Opcode::Cop, most), "admitted");
    assert_eq!(cop(Opcode::Cop, most + 1), "CopyLength");
    assert_eq!(cop(Opcode::Fll, most), "admitted");
    assert_eq!(cop(Opcode::Fll, most + 1), "CopyLength");
}

#[test]
fn fill_when_beyond_the_array_or_into_structures_then_is_refused() {
    let fll = |operands: fn(&mut Rich) -> [OperandIndex; 3]| rule(|r| op(Opcode::Fll, &operands(r)));
    assert_eq!(fll(|r| [r.b.integer(7), r.list, r.b.integer(4)]), "admitted");
    assert_eq!(fll(|r| [r.b.integer(7), r.list, r.b.integer(5)]), "CopyLength");
    assert_eq!(fll(|r| [r.b.integer(7), r.part_at(0), r.b.integer(1)]), "OperandKind");
    assert_eq!(fll(|r| [r.b.integer(7), r.x[0], r.b.integer(1)]), "OperandKind");
}

#[test]
fn swap_when_types_differ_then_is_refused() {
    let swpb = |operands: fn(&mut Rich) -> [OperandIndex; 3]| rule(|r| op(Opcode::Swpb, &operands(r)));
    assert_eq!(swpb(|r| [r.word, r.b.operand(OperandRecord::Choice(2)), r.y]), "admitted");
    assert_eq!(swpb(|r| [r.word, r.b.operand(OperandRecord::Choice(2)), r.real]), "SwapTypes");
    assert_eq!(swpb(|r| [r.b.integer(1), r.b.operand(OperandRecord::Choice(2)), r.y]), "SwapTypes");
    assert_eq!(swpb(|r| [r.word, r.b.operand(OperandRecord::Choice(3)), r.y]), "OperandWithoutText");
}

#[test]
fn size_when_the_array_lacks_the_dimension_then_is_refused() {
    let size = |operands: fn(&mut Rich) -> [OperandIndex; 3]| rule(|r| op(Opcode::Size, &operands(r)));
    assert_eq!(size(|r| [r.list, r.b.integer(0), r.y]), "admitted");
    assert_eq!(size(|r| [r.list_element(2), r.b.integer(0), r.y]), "admitted");
    assert_eq!(size(|r| [r.part_at(1), r.b.integer(0), r.y]), "admitted");
    assert_eq!(size(|r| [r.list, r.b.integer(1), r.y]), "SizeDimension");
    assert_eq!(size(|r| [r.list, r.b.integer(3), r.y]), "OperandRange");
    assert_eq!(size(|r| [r.word, r.b.integer(0), r.y]), "OperandKind");
}

#[test]
fn safety_instruction_when_its_operands_contradict_each_other_then_is_refused() {
    let dcs = |first: usize, second: usize| {
        let mut r = rich();
        r.b.image.routines[0].code.clear();
        let mut element = r.stop_call(r.stop);
        for (position, x) in [(6, first), (7, second)] {
            element[2 + 4 * position..][..4].copy_from_slice(&r.x[x].0.to_le_bytes());
        }
        r.rule_with(&[element])
    };
    assert_eq!(dcs(0, 1), "admitted");
    assert_eq!(dcs(1, 1), "OperandRelation");
}

#[test]
fn system_value_when_class_instance_and_attribute_disagree_then_is_refused() {
    let gsv = |class: &str, instance: &str| rule(|r| r.gsv(class, instance, 0, r.y));
    assert_eq!(gsv("TASK", "Safety_Task"), "admitted");
    assert_eq!(gsv("TASK", "THIS"), "admitted");
    assert_eq!(gsv("Task", "THIS"), "SystemObject");
    assert_eq!(gsv("PROGRAM", "Main"), "SystemObject");
    assert_eq!(gsv("TASK", ""), "SystemObject");
    assert_eq!(gsv("TASK", "Other"), "SystemObject");
    assert_eq!(rule(|r| r.gsv("TASK", "THIS", 0, r.x[0])), "SystemData");
    assert_eq!(rule(|r| r.gsv("TASK", "THIS", 0, r.real)), "SystemData");
    assert_eq!(rule(|r| r.gsv("TASK", "THIS", 0, r.stop)), "SystemData");
    assert_eq!(rule(|r| r.gsv("TASK", "THIS", 0, r.list)), "admitted");
    let ssv = |r: &mut Rich| {
        let mut element = r.gsv("TASK", "THIS", 0, r.y);
        element[0] = Opcode::Ssv as u8;
        element
    };
    assert_eq!(rule(ssv), "SystemReadOnly");
}

#[test]
fn fault_record_when_read_or_written_then_needs_all_its_bytes() {
    let record = |length: u32, opcode: Opcode, instance: &str| {
        let mut r = rich();
        let tag = r.b.scoped_tag("Record", Some(PROGRAM), DINT, [length, 0, 0], TagKind::Base);
        let data = r.b.whole(tag);
        let value = SystemValueRecord { attribute: 9, instance: 0, first: 1, program: Some(PROGRAM) };
        r.b.image.system_values.push(value);
        let mut element = r.gsv("PROGRAM", instance, 1, data);
        element[0] = opcode as u8;
        r.rule_with(&[element])
    };
    assert_eq!(record(11, Opcode::Gsv, "THIS"), "admitted");
    assert_eq!(record(11, Opcode::Ssv, "Main"), "admitted");
    assert_eq!(record(10, Opcode::Gsv, "THIS"), "SystemData");
    assert_eq!(record(11, Opcode::Gsv, "Other"), "SystemObject");
}
