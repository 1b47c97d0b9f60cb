//! Rules of labels, subroutines and Add-On calls.

use twinrung_bytecode::limits;

use crate::support::samples::{Rich, SCALE, rich};
use crate::support::*;

/// The rule that refuses the rich sample with one more rung in the main routine.
fn rule(rung: impl FnOnce(&mut Rich) -> Vec<Vec<u8>>) -> &'static str {
    let mut r = rich();
    let elements = rung(&mut r);
    r.rule_with(&elements)
}

#[test]
fn label_when_missing_twice_or_misspelt_then_is_refused() {
    let labels = |defined: &[&str], jumped: &str| {
        let mut b = build();
        for label in defined {
            let label = b.word_text(label);
            b.rung(&[op(Opcode::Lbl, &[label]), op(Opcode::Nop, &[])]);
        }
        let label = b.word_text(jumped);
        b.rung(&[op(Opcode::Jmp, &[label])]);
        b.rule()
    };
    assert_eq!(labels(&["Top", "End"], "End"), "admitted");
    assert_eq!(labels(&["Top"], "End"), "LabelMissing");
    assert_eq!(labels(&["Top"], "TOP"), "LabelMissing");
    assert_eq!(labels(&["Top", "top"], "Top"), "LabelTwice");
    assert_eq!(labels(&[""], "Top"), "LabelName");
    assert_eq!(labels(&["Top"], ""), "LabelName");
}

#[test]
fn jsr_when_its_parameters_are_not_those_of_sbr_and_ret_then_is_refused() {
    let jsr = |count: i32, parameters: fn(&mut Rich) -> Vec<OperandIndex>| {
        rule(|r| {
            let mut operands = vec![r.sub, r.b.integer(count)];
            operands.extend(parameters(r));
            vec![op(Opcode::Jsr, &operands)]
        })
    };
    assert_eq!(jsr(1, |r| vec![r.word, r.y]), "admitted");
    assert_eq!(jsr(1, |r| vec![r.b.integer(7), r.y]), "admitted");
    assert_eq!(jsr(1, |r| vec![r.real, r.y]), "CallParameters");
    assert_eq!(jsr(1, |r| vec![r.x[0], r.y]), "CallParameters");
    assert_eq!(jsr(1, |r| vec![r.list, r.y]), "CallParameters");
    assert_eq!(jsr(1, |r| vec![r.word]), "CallParameters");
    assert_eq!(jsr(1, |r| vec![r.word, r.x[0]]), "CallParameters");
    assert_eq!(jsr(0, |r| vec![r.y]), "CallParameters");
    assert_eq!(jsr(2, |r| vec![r.word, r.word, r.y]), "CallParameters");
    assert_eq!(jsr(3, |r| vec![r.word, r.y]), "CallCount");
    assert_eq!(jsr(1, |r| vec![r.word, r.b.integer(7)]), "OperandKind");
    assert_eq!(jsr(41, |r| vec![r.word; 41]), "CallCount");
    assert_eq!(jsr(1, |r| vec![r.word; 42]), "CallCount");
    assert_eq!(jsr(1, |r| vec![r.word; 83]), "OperandCount");
}

#[test]
fn jsr_with_forty_parameters_each_way_when_called_then_is_admitted() {
    let mut b = build();
    let words: Vec<OperandIndex> = (0..40).map(|index| b.data(&format!("W{index:02}"), DINT)).collect();
    let sub = b.routine("Sub", Owner::Program(PROGRAM));
    let mut operands = vec![b.operand(OperandRecord::Routine(sub)), b.integer(limits::JSR_PARAMETERS as i32)];
    operands.extend(words.iter().chain(&words));
    b.rung(&[op(Opcode::Jsr, &operands)]);
    b.rung_in(sub, &[op(Opcode::Sbr, &words)]);
    b.rung_in(sub, &[op(Opcode::Ret, &words)]);
    assert_eq!(b.rule(), "admitted");
    let mut more = words.clone();
    more.push(words[0]);
    b.rung_in(sub, &[op(Opcode::Ret, &more)]);
    assert_eq!(b.rule(), "CallCount");
}

#[test]
fn rets_when_they_differ_then_their_routine_cannot_be_called() {
    let mut r = rich();
    r.b.rung_in(r.sub_routine, &[op(Opcode::Ret, &[])]);
    assert_eq!(r.b.rule(), "CallParameters");
}

#[test]
fn user_fault_when_raised_then_needs_no_sbr() {
    let fault = |number: i32| {
        let mut b = build();
        let fault = b.routine("Oops", Owner::Program(PROGRAM));
        b.image.programs[0].fault = Some(fault);
        let operands = [b.operand(OperandRecord::Routine(fault)), b.integer(1), b.integer(number)];
        b.rung(&[op(Opcode::Jsr, &operands)]);
        b.rule()
    };
    assert_eq!(fault(990), "admitted");
    assert_eq!(fault(999), "admitted");
    assert_eq!(fault(989), "CallParameters");
    assert_eq!(fault(1000), "CallParameters");
}

/// A chain of subroutines, each calling the next; the last calls back where a circle is wanted.
fn chain(calls: usize, circle: bool) -> &'static str {
    let mut b = build();
    let none = b.integer(0);
    let mut caller = MAIN;
    for level in 0..calls {
        let callee = b.routine(&format!("S{level:02}"), Owner::Program(PROGRAM));
        let target = b.operand(OperandRecord::Routine(callee));
        b.rung_in(caller, &[op(Opcode::Jsr, &[target, none])]);
        caller = callee;
    }
    let back = b.operand(OperandRecord::Routine(MAIN));
    let last = [op(Opcode::Nop, &[]), op(Opcode::Jsr, &[back, none])];
    b.rung_in(caller, &last[usize::from(circle)..][..1]);
    b.rule()
}

#[test]
fn subroutines_when_circular_or_too_deep_then_are_refused() {
    assert_eq!(chain(limits::CALL_DEPTH, false), "admitted");
    assert_eq!(chain(limits::CALL_DEPTH + 1, false), "CallDepth");
    assert_eq!(chain(3, true), "CallCircle");
    assert_eq!(chain(0, true), "CallCircle");
}

#[test]
fn subroutine_when_of_another_program_then_is_foreign() {
    let mut r = rich();
    r.b.image.programs.push(ProgramRecord { name: "Other".into(), main: None, fault: None, disabled: false });
    let other = RoutineRecord {
        owner: Owner::Program(ProgramIndex(1)),
        name: "Main".into(),
        code: r.b.image.routines[0].code.clone(),
        text: String::new(),
    };
    r.b.image.routines.insert(2, other);
    r.b.image.add_ons[0].logic = RoutineIndex(3);
    r.b.image.routines[2].code.clear();
    let none = r.b.integer(0);
    r.b.rung_in(RoutineIndex(2), &[op(Opcode::Jsr, &[r.sub, none])]);
    assert_eq!(r.b.rule(), "ForeignOperand");
}

#[test]
fn subroutine_instructions_when_in_an_add_on_then_are_refused() {
    let logic = |rung: fn(&mut Rich) -> Vec<u8>| {
        let mut r = rich();
        let element = rung(&mut r);
        r.b.rung_in(r.logic, &[element]);
        r.b.rule()
    };
    assert_eq!(logic(|_| op(Opcode::Ret, &[])), "admitted");
    assert_eq!(logic(|_| op(Opcode::Tnd, &[])), "admitted");
    assert_eq!(logic(|r| op(Opcode::Ret, &[r.member(2, 0)])), "CallOutside");
    assert_eq!(logic(|_| op(Opcode::Mcr, &[])), "MasterControlInAddOn");
    assert_eq!(logic(|r| op(Opcode::Clr, &[r.y])), "ForeignOperand");
    let none = |r: &mut Rich| op(Opcode::Jsr, &[r.sub, OperandIndex(0)]);
    assert_eq!(logic(none), "ForeignOperand");
    let mut r = rich();
    r.b.image.routines[2].code.clear();
    r.b.rung_in(r.logic, &[op(Opcode::Sbr, &[])]);
    assert_eq!(r.b.rule(), "CallOutside");
}

#[test]
fn add_on_call_when_its_arguments_do_not_fit_then_is_refused() {
    let arguments = |arguments: fn(&mut Rich) -> [OperandIndex; 3]| {
        rule(|r| {
            let [gain, result, reference] = arguments(r);
            vec![call(&[r.instance, gain, result, reference])]
        })
    };
    assert_eq!(arguments(|r| [r.word, r.y, r.word]), "admitted");
    assert_eq!(arguments(|r| [r.real, r.real, r.word]), "admitted");
    assert_eq!(arguments(|r| [r.b.integer(7), r.y, r.list_element(1)]), "admitted");
    assert_eq!(arguments(|r| [r.x[0], r.y, r.word]), "AddOnArgument");
    assert_eq!(arguments(|r| [r.word, r.b.integer(7), r.word]), "AddOnArgument");
    assert_eq!(arguments(|r| [r.word, r.y, r.b.integer(7)]), "AddOnArgument");
    assert_eq!(arguments(|r| [r.word, r.y, r.real]), "AddOnArgument");
    assert_eq!(arguments(|r| [r.word, r.y, r.list]), "AddOnArgument");
    assert_eq!(arguments(|r| [r.word, r.y, r.alias]), "AddOnArgument");
    assert_eq!(arguments(|r| [r.word, r.y, r.list_at(r.word)]), "AddOnVariable");
    assert_eq!(rule(|r| vec![call(&[r.instance, r.word, r.y])]), "OperandCount");
    assert_eq!(rule(|_| vec![call(&[])]), "MarkOrder");
}

#[test]
fn add_on_call_when_the_first_operand_is_no_instance_then_is_refused() {
    assert_eq!(rule(|r| vec![call(&[r.time, r.word, r.y, r.word])]), "CallWithoutInstance");
    assert_eq!(rule(|r| vec![call(&[r.word, r.word, r.y, r.word])]), "CallWithoutInstance");
    let instances = |subscripts: fn(&mut Build) -> Vec<Subscript>| {
        let (mut r, many) = with_instances();
        let subscripts = subscripts(&mut r.b);
        let TypeReference::Structure(scale) = r.scale else { unreachable!() };
        let cells = r.b.image.tags[many.position()].clone();
        let mut there = access(Shape::Region, AccessType::Structure(scale), cells.bit_cell, cells.word_cell, 2);
        there.terms = subscripts.iter().filter_map(variable).collect();
        let steps: Vec<Step> = subscripts.chunks(1).map(|one| Step::Subscript(one.to_vec())).collect();
        let instance = r.b.reference(Root::Tag(many), &steps, there);
        r.rule_with(&[call(&[instance, r.word, r.y, r.word])])
    };
    assert_eq!(instances(|_| vec![Subscript::Constant(0)]), "admitted");
    assert_eq!(instances(|_| vec![]), "AddOnInstance");
    assert_eq!(instances(|b| vec![Subscript::Operand(word_of(b))]), "AddOnVariable");
}

fn word_of(b: &mut Build) -> OperandIndex {
    let word = b.image.tags.iter().position(|tag| tag.name == "Word").unwrap();
    b.whole(TagIndex(word as u32))
}

fn variable(subscript: &Subscript) -> Option<Term> {
    match subscript {
        Subscript::Operand(operand) => Some(Term { operand: *operand, length: 2, bit_stride: 5, word_stride: 4 }),
        Subscript::Constant(_) => None,
    }
}

/// The rich sample with an array of two instances behind all tags of the program.
fn with_instances() -> (Rich, TagIndex) {
    let mut r = rich();
    let scale = r.scale;
    let many = r.b.scoped_tag("Many", Some(PROGRAM), scale, [2, 0, 0], TagKind::Base);
    (r, many)
}

/// Add-On Instructions that each call the one before through an InOut parameter.
fn nested(levels: usize) -> Build {
    let mut b = build();
    let enable = |name: &str| MemberRecord { name: name.into(), type_reference: BOOL, dimensions: SCALAR };
    for level in 0..levels {
        let members = vec![enable("EnableIn"), enable("EnableOut")];
        b.structure(&format!("A{level:02}"), TypeKind::AddOn(AddOnIndex(level as u16)), members);
    }
    for level in 0..levels {
        let add_on = AddOnIndex(level as u16);
        let logic = b.routine("Logic", Owner::AddOn(add_on));
        let parameter = |name: &str, usage, type_reference, argument, member| ParameterRecord {
            name: name.into(),
            usage,
            type_reference,
            dimensions: SCALAR,
            argument,
            member,
        };
        let mut parameters = vec![
            parameter("EnableIn", Usage::Input, BOOL, false, Some(0)),
            parameter("EnableOut", Usage::Output, BOOL, false, Some(1)),
        ];
        for inner in 0..level {
            let inner_type = TypeReference::Structure(TypeIndex(inner as u16));
            parameters.push(parameter(&format!("I{inner:02}"), Usage::InOut, inner_type, true, None));
        }
        b.image.add_ons.push(AddOnRecord {
            name: format!("A{level:02}"),
            instance_type: TypeIndex(level as u16),
            parameters,
            logic,
            prescan: None,
            enable_in_false: None,
            attributes: vec![],
        });
        // Instance and arguments: every earlier one is passed on.
        let operands: Vec<OperandIndex> = (0..level)
            .rev()
            .map(|inner| {
                let base = Base::InOut(inner as u16 + 2);
                let region = access(Shape::Region, AccessType::Structure(TypeIndex(inner as u16)), 0, 0, 1);
                b.reference(Root::InOut(add_on, inner as u16 + 2), &[], Access { base, ..region })
            })
            .collect();
        let arguments = operands.split_first().map(|(instance, rest)| {
            let mut all = vec![*instance];
            all.extend(rest.iter().rev());
            call(&all)
        });
        b.rung_in(logic, &[arguments.unwrap_or_else(|| op(Opcode::Nop, &[]))]);
    }
    b
}

#[test]
fn add_ons_when_nested_beyond_the_limit_then_are_refused() {
    assert_eq!(nested(limits::ADD_ON_DEPTH + 1).rule(), "admitted");
    assert_eq!(nested(limits::ADD_ON_DEPTH + 2).rule(), "AddOnDepth");
}

#[test]
fn add_on_when_it_calls_itself_then_is_refused() {
    let mut r = rich();
    let scale = r.scale;
    let mut own = r.b.image.add_ons[0].parameters[4].clone();
    (own.name, own.type_reference) = ("Own".into(), scale);
    r.b.image.add_ons[0].parameters.push(own);
    let TypeReference::Structure(index) = scale else { unreachable!() };
    let there = Access { base: Base::InOut(5), ..access(Shape::Region, AccessType::Structure(index), 0, 0, 1) };
    let instance = r.b.reference(Root::InOut(SCALE, 5), &[], there);
    let (gain, result, reference) = (r.member(2, 0), r.member(3, 1), r.in_out());
    r.b.rung_in(r.logic, &[call(&[instance, gain, result, reference, instance])]);
    assert_eq!(r.b.rule(), "AddOnOrder");
}
