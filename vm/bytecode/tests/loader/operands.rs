//! Rules of the operand table: encoding, paths, accesses, subscripts, expressions.

use twinrung_bytecode::format::{OPERATION_ADD, OPERATION_EQUAL, OPERATION_NEGATE, OPERATION_SQUARE_ROOT};
use twinrung_bytecode::limits;
use twinrung_catalog::MemberRole;

use crate::support::samples::{Rich, SCALE, rich};
use crate::support::*;

/// The rule that refuses the rich sample with one more operand.
fn rule(add: impl FnOnce(&mut Rich) -> OperandIndex) -> &'static str {
    let mut r = rich();
    add(&mut r);
    r.b.rule()
}

fn push(operand: OperandIndex) -> Operation {
    Operation::Push(operand)
}

#[test]
fn entry_when_not_encoded_as_operands_are_then_is_refused() {
    let bytes = |bytes: &[u8]| {
        let mut r = rich();
        let table = &mut r.b.image.operands;
        table.bytes.extend_from_slice(bytes);
        table.offsets.push(table.bytes.len() as u32);
        r.b.rule()
    };
    assert_eq!(bytes(&[4]), "admitted");
    for wrong in [
        &[0u8][..],
        &[12],
        &[4, 0],
        &[1, 10, 0, 0, 0],
        &[1, 7, 0, 0, 0, 0],
        &[5, 1, 0, 0xFF],
        &[7, 6],
        &[10, 1, 0, 5],
        &[10, 0xFF, 0xFF],
        &[11, 0, 0],
        &[11, 1, 0, 9],
    ] {
        assert_eq!(bytes(wrong), "OperandEncoding", "{wrong:?}");
    }
}

#[test]
fn entry_when_it_names_what_does_not_exist_then_is_refused() {
    assert_eq!(rule(|r| r.b.operand(OperandRecord::Routine(RoutineIndex(9)))), "OperandWithoutText");
    assert_eq!(rule(|r| r.b.operand(OperandRecord::Routine(r.logic))), "OperandWithoutText");
    assert_eq!(rule(|r| r.b.operand(OperandRecord::SystemValue(SystemValueIndex(1)))), "OperandWithoutText");
    assert_eq!(rule(|r| r.b.operand(OperandRecord::EventTask(EventTaskIndex(1)))), "OperandWithoutText");
    assert_eq!(rule(|r| r.b.word_text("a);")), "OperandWithoutText");
    assert_eq!(rule(|r| r.b.operand(OperandRecord::Real(f32::NAN.to_bits()))), "RealNotFinite");
    assert_eq!(rule(|r| r.b.operand(OperandRecord::Real(f32::INFINITY.to_bits()))), "RealNotFinite");
    assert_eq!(rule(|r| r.list_at(OperandIndex(9999))), "OperandOrder");
    let mut r = rich();
    r.b.rung(&[op(Opcode::Ote, &[OperandIndex(9999)])]);
    assert_eq!(r.b.rule(), "NoSuchOperand");
}

#[test]
fn access_when_any_field_differs_from_the_path_then_is_refused() {
    let changed = |change: fn(&mut Access)| {
        rule(|r| {
            let record = &r.b.image.tags[r.tags.list.position()];
            let (bit_cell, word_cell) = (record.bit_cell, record.word_cell + 2);
            let mut there = access(Shape::Word, element(Element::Dint), bit_cell, word_cell, 2);
            change(&mut there);
            r.b.reference(Root::Tag(r.tags.list), &[Step::Subscript(vec![Subscript::Constant(2)])], there)
        })
    };
    assert_eq!(changed(|_| ()), "admitted");
    assert_eq!(changed(|access| access.word_cell += 1), "AccessDiffers");
    assert_eq!(changed(|access| access.bit_cell += 1), "AccessDiffers");
    assert_eq!(changed(|access| access.count = 3), "AccessDiffers");
    assert_eq!(changed(|access| access.shape = Shape::Region), "AccessDiffers");
    assert_eq!(changed(|access| access.access_type = element(Element::Int)), "AccessDiffers");
    assert_eq!(changed(|access| access.base = Base::Instance), "AccessDiffers");
    let term = |access: &mut Access| {
        access.terms.push(Term { operand: OperandIndex(0), length: 4, bit_stride: 0, word_stride: 1 });
    };
    assert_eq!(changed(term), "AccessDiffers");
}

#[test]
fn access_with_a_variable_subscript_when_a_term_differs_then_is_refused() {
    let changed = |change: fn(&mut Term)| {
        rule(|r| {
            let record = &r.b.image.tags[r.tags.list.position()];
            let mut there = access(Shape::Word, element(Element::Dint), record.bit_cell, record.word_cell, 4);
            let mut term = Term { operand: r.word, length: 4, bit_stride: 0, word_stride: 1 };
            change(&mut term);
            there.terms.push(term);
            r.b.reference(Root::Tag(r.tags.list), &[Step::Subscript(vec![Subscript::Operand(r.word)])], there)
        })
    };
    assert_eq!(changed(|_| ()), "admitted");
    assert_eq!(changed(|term| term.length = 5), "AccessDiffers");
    assert_eq!(changed(|term| term.word_stride = 0), "AccessDiffers");
    assert_eq!(changed(|term| term.bit_stride = 1), "AccessDiffers");
    assert_eq!(changed(|term| term.operand = OperandIndex(0)), "AccessDiffers");
}

/// An array of three dimensions: the first is the slowest.
#[test]
fn access_of_a_cube_when_subscripts_are_mixed_then_counts_from_the_constants() {
    let mut b = build();
    let cube = b.tag_of("Cube", INT, [2, 3, 4], TagKind::Base);
    let index = b.data("I", DINT);
    let subscripts = vec![Subscript::Constant(1), Subscript::Operand(index), Subscript::Constant(3)];
    let there = Access {
        terms: vec![Term { operand: index, length: 3, bit_stride: 0, word_stride: 4 }],
        ..access(Shape::Word, element(Element::Int), 0, 12 + 3, 24 - 12 - 3)
    };
    let element = b.reference(Root::Tag(cube), &[Step::Subscript(subscripts)], there);
    b.rung(&[op(Opcode::Clr, &[element])]);
    assert_eq!(b.rule(), "admitted");
    assert_eq!(b.text(), "CLR(Cube[1,I,3]);\n");
}

#[test]
fn member_of_an_element_when_reached_then_lies_where_the_layout_says() {
    let mut r = rich();
    let base = r.b.image.tags[r.tags.parts.position()].clone();
    let steps = [
        Step::Subscript(vec![Subscript::Constant(2)]),
        Step::Member(3),
        Step::Subscript(vec![Subscript::Constant(1)]),
        Step::BitOperand(r.word),
    ];
    let bit = Shape::WordBit(BitNumber::Operand { operand: r.word, length: 16 });
    let there = access(bit, element(Element::Int), base.bit_cell + 6, base.word_cell + 8, 1);
    let bit = r.b.reference(Root::Tag(r.tags.parts), &steps, there);
    assert_eq!(r.rule_with(&[op(Opcode::Ote, &[bit])]), "admitted");
    assert!(r.b.text().ends_with("OTE(Parts[2].W[1].[Word]);\n"));
}

#[test]
fn path_when_it_leads_nowhere_then_is_refused() {
    let path = |root: fn(&Rich) -> Root, steps: &[Step]| {
        rule(|r| {
            let root = root(r);
            r.b.reference(root, steps, access(Shape::Word, element(Element::Dint), 0, 0, 1))
        })
    };
    let constant = |value| Step::Subscript(vec![Subscript::Constant(value)]);
    assert_eq!(path(|_| Root::Tag(TagIndex(99)), &[]), "PathRoot");
    assert_eq!(path(|_| Root::Member(SCALE, 5), &[]), "PathRoot");
    assert_eq!(path(|_| Root::Member(AddOnIndex(1), 0), &[]), "PathRoot");
    assert_eq!(path(|_| Root::InOut(SCALE, 2), &[]), "PathRoot");
    assert_eq!(path(|_| Root::InOut(SCALE, 9), &[]), "PathRoot");
    assert_eq!(path(|r| Root::Tag(r.tags.word), &[Step::Member(0)]), "PathMember");
    assert_eq!(path(|r| Root::Tag(r.tags.time), &[Step::Member(5)]), "PathMember");
    assert_eq!(path(|r| Root::Tag(r.tags.parts), &[Step::Member(0)]), "PathMember");
    assert_eq!(path(|r| Root::Tag(r.tags.word), &[constant(0)]), "PathSubscript");
    assert_eq!(path(|r| Root::Tag(r.tags.list), &[constant(0), constant(0)]), "PathSubscript");
    assert_eq!(path(|r| Root::Tag(r.tags.list), &[constant(4)]), "SubscriptRange");
    assert_eq!(path(|r| Root::Tag(r.tags.word), &[Step::Bit(32)]), "SubscriptRange");
    assert_eq!(path(|r| Root::Tag(r.tags.word), &[Step::Bit(31), Step::Bit(0)]), "PathBit");
    assert_eq!(path(|r| Root::Tag(r.tags.real), &[Step::Bit(0)]), "PathBit");
    assert_eq!(path(|r| Root::Tag(r.tags.list), &[Step::Bit(0)]), "PathBit");
    assert_eq!(path(|r| Root::Tag(r.tags.mapped), &[Step::Bit(0)]), "PathBit");
}

#[test]
fn internal_member_when_named_then_is_refused() {
    let known = PredefinedType::by_name("DCI_STOP").unwrap();
    let internal = known.members.iter().position(|member| member.role == MemberRole::Internal).unwrap() as u16;
    let refused = rule(|r| {
        let there = access(Shape::Bit, element(Element::Bool), 0, 0, 1);
        r.b.reference(Root::Tag(r.tags.stop), &[Step::Member(internal)], there)
    });
    assert_eq!(refused, "PathInternal");
}

#[test]
fn subscript_when_no_integer_then_is_refused() {
    assert_eq!(rule(|r| r.list_at(r.real)), "SubscriptType");
    assert_eq!(rule(|r| r.list_at(r.x[0])), "SubscriptType");
    assert_eq!(rule(|r| r.list_at(r.list)), "SubscriptType");
    let expression = |operations: fn(&Rich, OperandIndex) -> Vec<Operation>| {
        rule(|r| {
            let one = r.b.integer(1);
            let operations = operations(r, one);
            let expression = r.b.expression(&operations);
            r.list_at(expression)
        })
    };
    assert_eq!(expression(|r, one| vec![push(r.word), push(one), Operation::Apply(OPERATION_ADD)]), "admitted");
    assert_eq!(expression(|r, _| vec![push(r.real)]), "SubscriptType");
    assert_eq!(expression(|r, _| vec![push(r.word), Operation::Apply(OPERATION_SQUARE_ROOT)]), "SubscriptType");
    assert_eq!(expression(|r, one| vec![push(r.word), push(one), Operation::Apply(OPERATION_EQUAL)]), "SubscriptType");
}

#[test]
fn subscripts_when_nested_beyond_the_limit_then_are_refused() {
    let nested = |levels: usize| {
        rule(|r| {
            let mut operand = r.word;
            for _ in 0..levels {
                operand = r.list_at(operand);
            }
            operand
        })
    };
    assert_eq!(nested(limits::SUBSCRIPT_DEPTH), "admitted");
    assert_eq!(nested(limits::SUBSCRIPT_DEPTH + 1), "OperandDepth");
}

/// Structures of arrays in one another: each level takes one variable subscript.
#[test]
fn subscripts_when_more_than_a_reference_may_have_then_are_refused() {
    let with = |levels: u32| {
        let mut b = build();
        let mut inner = DINT;
        for level in 1..levels {
            inner = b.user(&format!("T{level:02}"), &[("M", inner, 2)]);
        }
        let deep = b.tag_of("Deep", inner, [2, 2, 0], TagKind::Base);
        let index = b.data("I", DINT);
        let variable = Subscript::Operand(index);
        let mut steps = vec![Step::Subscript(vec![variable, variable])];
        for _ in 1..levels {
            steps.extend([Step::Member(0), Step::Subscript(vec![variable])]);
        }
        let strides = (0..levels + 1).rev();
        let terms = strides.map(|power| Term { operand: index, length: 2, bit_stride: 0, word_stride: 1 << power });
        let terms = terms.take(limits::SUBSCRIPT_TERMS).collect();
        let count = if levels == 1 { 4 } else { 2 };
        let there = Access { terms, ..access(Shape::Word, element(Element::Dint), 0, 0, count) };
        b.reference(Root::Tag(deep), &steps, there);
        b.rule()
    };
    assert_eq!(with(limits::SUBSCRIPT_TERMS as u32 - 1), "admitted");
    assert_eq!(with(limits::SUBSCRIPT_TERMS as u32), "PathLength");
}

#[test]
fn expression_when_it_leaves_not_one_value_then_is_refused() {
    let expression = |operations: fn(&Rich) -> Vec<Operation>| {
        rule(|r| {
            let operations = operations(r);
            r.b.expression(&operations)
        })
    };
    let add = Operation::Apply(OPERATION_ADD);
    assert_eq!(expression(|r| vec![push(r.word)]), "admitted");
    assert_eq!(expression(|_| vec![]), "ExpressionShape");
    assert_eq!(expression(|r| vec![push(r.word), push(r.word)]), "ExpressionShape");
    assert_eq!(expression(|r| vec![push(r.word), Operation::Apply(OPERATION_ADD)]), "ExpressionShape");
    assert_eq!(expression(|_| vec![Operation::Apply(OPERATION_NEGATE)]), "ExpressionShape");
    assert_eq!(expression(|r| vec![push(r.x[0])]), "ExpressionOperand");
    assert_eq!(expression(|r| vec![push(r.list)]), "ExpressionOperand");
    assert_eq!(expression(|r| vec![push(r.alias)]), "ExpressionOperand");
    let sum = move |values: usize| {
        rule(move |r| {
            let mut operations = vec![push(r.word); values];
            operations.extend(vec![add; values - 1]);
            r.b.expression(&operations)
        })
    };
    assert_eq!(sum(limits::EXPRESSION_DEPTH), "admitted");
    assert_eq!(sum(limits::EXPRESSION_DEPTH + 1), "ExpressionDepth");
    let negated = |times: usize| {
        rule(move |r| {
            let mut operations = vec![push(r.word)];
            operations.extend(vec![Operation::Apply(OPERATION_NEGATE); times]);
            r.b.expression(&operations)
        })
    };
    assert_eq!(negated(limits::EXPRESSION_OPERATIONS - 1), "admitted");
    assert_eq!(negated(limits::EXPRESSION_OPERATIONS), "ExpressionLength");
}

#[test]
fn operand_when_it_joins_two_owners_then_is_refused() {
    let joined = rule(|r| {
        let member = r.member(2, 0);
        r.b.expression(&[push(member), push(r.word), Operation::Apply(OPERATION_ADD)])
    });
    assert_eq!(joined, "OperandScope");
}

#[test]
fn record_when_encoded_then_decodes_to_itself() {
    let r = rich();
    let table = &r.b.image.operands;
    for index in 0..table.len() {
        let bytes = table.entry(OperandIndex(index as u32)).unwrap();
        let mut again = Vec::new();
        OperandRecord::decode(bytes).unwrap().encode(&mut again);
        assert_eq!(again, bytes);
    }
}
