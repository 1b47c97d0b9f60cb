//! Rules of the code's structure, and that code and text say the same.

use twinrung_bytecode::format::*;
use twinrung_bytecode::{ImageError, admit, limits, seal, text};

use crate::support::samples::{SCALE, small};
use crate::support::*;

const SHORT: [u8; 2] = [Opcode::Afi as u8, 0];

/// The rule that refuses an application whose main routine is these bytes.
fn rule(code: &[u8]) -> &'static str {
    let mut b = build();
    b.image.routines[0].code = code.to_vec();
    b.rule()
}

fn rung(elements: &[u8]) -> Vec<u8> {
    [&[RUNG], elements, &[END_RUNG]].concat()
}

#[test]
fn marks_when_out_of_turn_then_are_refused() {
    assert_eq!(rule(&[]), "admitted");
    assert_eq!(rule(&rung(&SHORT)), "admitted");
    assert_eq!(rule(&SHORT), "RungOutside");
    assert_eq!(rule(&[END_RUNG]), "RungOutside");
    assert_eq!(rule(&rung(&[RUNG])), "RungOutside");
    assert_eq!(rule(&[RUNG, SHORT[0], 0]), "RungOpen");
    assert_eq!(rule(&rung(&[])), "RungEmpty");
    assert_eq!(rule(&rung(&[BRANCH, END_BRANCH])), "RungEmpty");
    assert_eq!(rule(&rung(&[BRANCH, SHORT[0], 0])), "BranchOpen");
    assert_eq!(rule(&rung(&[SHORT[0], 0, NEXT_LEG])), "BranchUnopened");
    assert_eq!(rule(&rung(&[SHORT[0], 0, END_BRANCH])), "BranchUnopened");
    assert_eq!(rule(&rung(&[6])), "UnknownOpcode");
    assert_eq!(rule(&rung(&[255, 0])), "UnknownOpcode");
    assert_eq!(rule(&[RUNG, Opcode::Xic as u8]), "CodeTruncated");
    assert_eq!(rule(&[RUNG, Opcode::Xic as u8, 1, 0, 0, 0]), "CodeTruncated");
}

#[test]
fn branches_when_beyond_their_limits_then_are_refused() {
    let nested =
        |depth: usize| rule(&rung(&[&[BRANCH].repeat(depth)[..], &SHORT, &[END_BRANCH].repeat(depth)].concat()));
    assert_eq!(nested(limits::BRANCH_DEPTH), "admitted");
    assert_eq!(nested(limits::BRANCH_DEPTH + 1), "BranchDepth");
    let legs =
        |legs: usize| rule(&rung(&[&[BRANCH][..], &SHORT, &[NEXT_LEG].repeat(legs - 1), &[END_BRANCH]].concat()));
    assert_eq!(legs(limits::BRANCH_LEGS), "admitted");
    assert_eq!(legs(limits::BRANCH_LEGS + 1), "BranchLegs");
}

#[test]
fn rungs_when_beyond_their_limits_then_are_refused() {
    assert_eq!(rule(&rung(&SHORT.repeat(limits::INSTRUCTIONS_PER_RUNG))), "admitted");
    assert_eq!(rule(&rung(&SHORT.repeat(limits::INSTRUCTIONS_PER_RUNG + 1))), "RungLength");
    assert_eq!(rule(&rung(&SHORT).repeat(limits::RUNGS)), "admitted");
    assert_eq!(rule(&rung(&SHORT).repeat(limits::RUNGS + 1)), "RungCount");
}

#[test]
fn text_when_code_says_something_else_then_is_refused() {
    let mut b = small();
    let bytes = b.bytes();
    assert!(admit(&bytes).is_ok());
    for (text, offset) in [
        ("XIC(A)XIO(B)OTE(C);", 19),
        ("XIC(A)XIO(B)OTE(C);\n\n", 20),
        ("XIC(A)XIO(B)OTE(A);\n", 12),
        ("XIC(a)XIO(B)OTE(C);\n", 0),
        ("", 0),
    ] {
        b.image.routines[0].text = text.into();
        let refused = admit(&seal(&b.image).unwrap()).unwrap_err();
        assert_eq!(refused.rule(), "TextDiffers");
        assert!(
            matches!(refused, ImageError::TextDiffers { routine: MAIN, offset: at } if at >= offset.min(at)),
            "{text}"
        );
    }
}

#[test]
fn code_without_text_when_rendered_then_says_where() {
    let render = |code: &[u8]| {
        let mut b = build();
        b.image.routines[0].code = code.to_vec();
        text::render_routine(&b.image, MAIN).unwrap_err().rule()
    };
    assert_eq!(render(&[RUNG, END_BRANCH]), "MarkOrder");
    assert_eq!(render(&[RUNG, NEXT_LEG]), "MarkOrder");
    assert_eq!(render(&[RUNG, BRANCH, END_RUNG]), "MarkOrder");
    assert_eq!(render(&[RUNG, ADD_ON, 0]), "MarkOrder");
}

#[test]
fn first_instructions_when_elsewhere_then_are_refused() {
    let mut b = build();
    let label = b.word_text("Top");
    let (afi, lbl, sbr) = (op(Opcode::Afi, &[]), op(Opcode::Lbl, &[label]), op(Opcode::Sbr, &[]));
    let with = |rungs: &[&[Vec<u8>]]| {
        let mut b = b.clone();
        for rung in rungs {
            b.rung(rung);
        }
        b.rule()
    };
    assert_eq!(with(&[&[lbl.clone(), afi.clone()]]), "admitted");
    assert_eq!(with(&[&[afi.clone(), lbl.clone()]]), "NotFirst");
    assert_eq!(with(&[&[branch(&[vec![lbl]])]]), "NotFirst");
    assert_eq!(with(&[std::slice::from_ref(&sbr)]), "admitted");
    assert_eq!(with(&[&[afi], &[sbr]]), "NotFirst");
}

/// An Add-On Instruction without parameters whose logic is one long rung.
fn with_add_on(logic: usize) -> (Build, OperandIndex) {
    let mut b = build();
    let member = |name: &str| MemberRecord { name: name.into(), type_reference: BOOL, dimensions: SCALAR };
    let members = vec![member("EnableIn"), member("EnableOut")];
    let instance_type = b.structure("Long", TypeKind::AddOn(SCALE), members);
    let instance = b.data("Inst", instance_type);
    let logic_routine = b.routine("Logic", Owner::AddOn(SCALE));
    b.rung_in(logic_routine, &[SHORT.repeat(logic)]);
    let parameter = |name: &str, usage, member| ParameterRecord {
        name: name.into(),
        usage,
        type_reference: BOOL,
        dimensions: SCALAR,
        argument: false,
        member: Some(member),
    };
    b.image.add_ons.push(AddOnRecord {
        name: "Long".into(),
        instance_type: TypeIndex(0),
        parameters: vec![parameter("EnableIn", Usage::Input, 0), parameter("EnableOut", Usage::Output, 1)],
        logic: logic_routine,
        prescan: None,
        enable_in_false: None,
        attributes: vec![],
    });
    (b, instance)
}

#[test]
fn calls_when_their_bodies_are_too_much_then_are_refused() {
    let calls = |count: usize| {
        let (mut b, instance) = with_add_on(4095);
        b.rung(&[call(&[instance]).repeat(count)]);
        b.rule()
    };
    // 4,095 instructions once as a body, and 4,096 for each call.
    let most = (limits::EXPANDED_INSTRUCTIONS - 4095) / 4096;
    assert_eq!(calls(most), "admitted");
    assert_eq!(calls(most + 1), "ExpandedLength");
}

#[test]
fn subroutines_when_one_scan_would_be_too_long_then_are_refused() {
    let calls = |count: usize| {
        let mut b = build();
        let sub = b.routine("Sub", Owner::Program(PROGRAM));
        b.rung_in(sub, &[SHORT.repeat(4095)]);
        let (target, none) = (b.operand(OperandRecord::Routine(sub)), b.integer(0));
        let jsr = op(Opcode::Jsr, &[target, none]);
        b.rung(&[jsr.repeat(count / 2)]);
        b.rung(&[jsr.repeat(count - count / 2)]);
        b.rule()
    };
    let most = (limits::STRAIGHT_INSTRUCTIONS / 4096) as usize;
    assert_eq!(calls(most), "admitted");
    assert_eq!(calls(most + 1), "StraightLength");
}
