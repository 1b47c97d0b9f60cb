//! What must hold of every declaration.

use std::collections::BTreeSet;
use twinrung_catalog::operand::OperandKind;
use twinrung_catalog::{
    ChoiceList, CodeWord, Element, MemberRole, Opcode, PredefinedType, Relation, SafetyApplication,
};
use twinrung_catalog::{Instruction, instructions, types};

/// The bits of the structure's memory that a member takes.
fn bits_of(member: &twinrung_catalog::Member) -> std::ops::Range<u32> {
    let first = member.byte * 8 + u32::from(member.bit);
    first..first + u32::from(member.element.bits()) * member.length.max(1)
}

fn safety_applications() -> impl Iterator<Item = (&'static Instruction, &'static SafetyApplication)> {
    instructions::ALL.iter().filter_map(|instruction| instruction.safety.map(|safety| (*instruction, safety)))
}

fn repeated<T: Ord + Copy>(values: impl IntoIterator<Item = T>) -> Vec<T> {
    let mut seen = BTreeSet::new();
    values.into_iter().filter(|value| !seen.insert(*value)).collect()
}

#[test]
fn opcodes_when_collected_then_numbers_are_unique_and_lead_to_their_declaration() {
    assert_eq!(repeated(Opcode::ALL.iter().map(|opcode| *opcode as u8)), Vec::<u8>::new());
    let strays: Vec<&str> = instructions::ALL
        .iter()
        .zip(Opcode::ALL)
        .filter(|(instruction, opcode)| {
            instruction.opcode != **opcode || opcode.instruction().mnemonic != instruction.mnemonic
        })
        .map(|(instruction, _)| instruction.mnemonic)
        .collect();
    assert_eq!(strays, Vec::<&str>::new());
}

#[test]
fn mnemonics_when_collected_then_no_two_instructions_share_one() {
    let names: Vec<String> = instructions::ALL
        .iter()
        .flat_map(|instruction| std::iter::once(instruction.mnemonic).chain(instruction.also.iter().copied()))
        .map(str::to_ascii_uppercase)
        .collect();
    assert_eq!(repeated(names.iter().map(String::as_str)), Vec::<&str>::new());
}

#[test]
fn safety_library_groups_when_listed_then_exactly_they_have_a_safety_declaration() {
    let strays: Vec<&str> = instructions::ALL
        .iter()
        .filter(|instruction| instruction.group.is_safety_library() != instruction.safety.is_some())
        .map(|instruction| instruction.mnemonic)
        .collect();
    assert_eq!(strays, Vec::<&str>::new());
}

#[test]
fn predefined_types_when_laid_out_then_members_are_named_once_do_not_overlap_and_lie_inside() {
    for known in types::ALL {
        assert_eq!(repeated(known.members.iter().map(|member| member.name)), Vec::<&str>::new(), "{}", known.name);
        let bits: Vec<u32> = known.members.iter().flat_map(bits_of).collect();
        assert_eq!(repeated(bits.iter().copied()), Vec::<u32>::new(), "{}", known.name);
        assert!(bits.iter().all(|bit| *bit < known.bytes * 8), "{}", known.name);
        assert!(known.members.iter().all(|member| member.byte % member.element.bytes().max(1) == 0), "{}", known.name);
        assert_eq!(known.bytes % 4, 0, "{}", known.name);
    }
}

#[test]
fn type_names_when_collected_then_each_occurs_once() {
    let names = types::ALL.iter().map(|known| known.name).chain(types::LISTED_WITHOUT_LAYOUT.iter().copied());
    assert_eq!(repeated(names), Vec::<&str>::new());
}

#[test]
fn backing_types_when_listed_then_each_backs_one_instruction() {
    let backing: Vec<&str> = safety_applications().map(|(_, safety)| safety.backing.name).collect();
    assert_eq!(repeated(backing.iter().copied()), Vec::<&str>::new());
    let marked: BTreeSet<&str> =
        types::ALL.iter().filter(|known| known.backs_one_call).map(|known| known.name).collect();
    assert_eq!(marked, backing.into_iter().collect());
}

#[test]
fn backing_types_when_executed_then_they_show_the_rung_condition() {
    for (_, safety) in safety_applications() {
        let role = |name| safety.backing.member(name).map(|(_, member)| member.role);
        assert_eq!(role("EnableIn"), Some(MemberRole::Internal), "{}", safety.backing.name);
        assert_eq!(role("EnableOut"), Some(MemberRole::Output), "{}", safety.backing.name);
    }
}

/// The role and the type that the member mirroring an operand must have.
fn mirror_of(kind: OperandKind) -> Option<(MemberRole, Option<Element>)> {
    match kind {
        OperandKind::Choice(_) => Some((MemberRole::Configuration, None)),
        OperandKind::Literal { .. } => Some((MemberRole::Configuration, Some(Element::Dint))),
        OperandKind::SafetyBit { .. } => Some((MemberRole::Input, Some(Element::Bool))),
        OperandKind::SafetyInteger { .. } => Some((MemberRole::Input, Some(Element::Dint))),
        OperandKind::SafetyReal { .. } => Some((MemberRole::Input, Some(Element::Real))),
        _ => None,
    }
}

#[test]
fn mirrored_members_when_looked_up_then_they_exist_once_with_the_operands_type_and_role() {
    for (instruction, safety) in safety_applications() {
        assert_eq!(safety.mirrored.len(), instruction.operands.len() - 1, "{}", instruction.mnemonic);
        assert_eq!(repeated(safety.mirrored.iter().copied()), Vec::<&str>::new(), "{}", instruction.mnemonic);
        for (operand, name) in instruction.operands[1..].iter().zip(safety.mirrored) {
            let (_, member) = safety.backing.member(name).expect(name);
            let (role, element) = mirror_of(operand.kind).expect(operand.name);
            assert_eq!(member.role, role, "{} {}", instruction.mnemonic, name);
            assert_eq!(element.unwrap_or(member.element), member.element, "{} {}", instruction.mnemonic, name);
        }
    }
}

#[test]
fn inputs_of_a_backing_type_when_listed_then_only_reserved_ones_mirror_no_operand() {
    for (instruction, safety) in safety_applications() {
        let unmirrored: Vec<&str> = safety
            .backing
            .members
            .iter()
            .filter(|member| matches!(member.role, MemberRole::Input | MemberRole::Configuration))
            .map(|member| member.name)
            .filter(|name| !safety.mirrored.contains(name) && !name.starts_with("Reserved"))
            .collect();
        assert_eq!(unmirrored, Vec::<&str>::new(), "{}", instruction.mnemonic);
    }
}

#[test]
fn first_operand_when_a_safety_application_is_called_then_it_is_the_backing_tag() {
    for (instruction, safety) in safety_applications() {
        assert!(
            matches!(instruction.operands[0].kind, OperandKind::Structure(known, access)
                if core::ptr::eq::<PredefinedType>(known, safety.backing) && access.writes()),
            "{}",
            instruction.mnemonic
        );
    }
}

/// The member of the backing tag that shows a code.
fn word_member(word: CodeWord) -> &'static str {
    match word {
        CodeWord::Fault => "FaultCode",
        CodeWord::Diagnostic => "DiagnosticCode",
        CodeWord::Flag(member) => member,
    }
}

#[test]
fn codes_when_collected_then_each_is_unique_in_its_word_and_its_member_exists() {
    for (instruction, safety) in safety_applications() {
        let keys = safety.codes.iter().map(|code| (word_member(code.word), code.value));
        assert_eq!(repeated(keys), Vec::new(), "{}", instruction.mnemonic);
        for code in safety.codes {
            let shown = word_member(code.word);
            let (_, member) = safety.backing.member(shown).expect(shown);
            assert_eq!(member.role, MemberRole::Output, "{}", instruction.mnemonic);
            assert_ne!(code.value, 0, "{}", instruction.mnemonic);
            assert!(!code.cause.is_empty() && !code.remedy.is_empty() && !code.origin.is_empty());
        }
    }
}

#[test]
fn relations_when_looked_up_then_they_name_operands() {
    for (instruction, safety) in safety_applications() {
        let named: Vec<&str> = safety
            .relations
            .iter()
            .flat_map(|relation| match *relation {
                Relation::DifferentTags(a, b)
                | Relation::NotZeroWhen(a, b, _)
                | Relation::BelowUnlessZero(a, b)
                | Relation::NotAbove(a, b) => vec![a, b],
                Relation::PeriodAtMost(_) => vec![],
            })
            .collect();
        assert!(
            named.iter().all(|name| instruction.operands.iter().any(|operand| operand.name == *name)),
            "{}",
            instruction.mnemonic
        );
    }
}

fn choice_lists() -> impl Iterator<Item = &'static ChoiceList> {
    safety_applications().flat_map(|(instruction, _)| instruction.operands).filter_map(|operand| match operand.kind {
        OperandKind::Choice(list) => Some(list),
        _ => None,
    })
}

#[test]
fn choice_words_when_read_then_every_spelling_and_the_number_give_the_value() {
    for list in choice_lists() {
        for (word, value) in list.words {
            assert_eq!(list.value(word), Some(*value), "{word}");
            assert_eq!(list.value(&word.to_lowercase().replace(' ', "_")), Some(*value), "{word}");
            assert_eq!(list.value(&value.to_string()), Some(*value), "{word}");
            assert_eq!(list.word(*value).and_then(|printed| list.value(printed)), Some(*value), "{word}");
        }
        assert_eq!(list.value("NO SUCH WORD"), None);
    }
}

#[test]
fn operands_that_decide_take_safety_data_only_or_are_channels_when_looked_up_then_they_exist() {
    let missing: Vec<_> = safety_applications()
        .flat_map(|(one, safety)| {
            let lists = [safety.decides, safety.safety_only, safety.channels];
            lists.into_iter().flatten().map(move |name| (one, *name))
        })
        .filter(|(one, name)| !one.operands.iter().any(|operand| operand.name == *name))
        .map(|(one, name)| (one.mnemonic, name))
        .collect();
    assert!(missing.is_empty(), "{missing:?}");
}

#[test]
fn channels_when_declared_then_there_are_two_at_least_and_all_take_safety_data_only() {
    let wrong: Vec<_> = safety_applications()
        .filter(|(_, safety)| {
            safety.channels.len() == 1 || !safety.channels.iter().all(|name| safety.safety_only.contains(name))
        })
        .map(|(one, _)| one.mnemonic)
        .collect();
    assert!(wrong.is_empty(), "{wrong:?}");
}

#[test]
fn members_that_report_when_looked_up_then_each_is_an_output_of_some_instruction() {
    let missing: Vec<_> = twinrung_catalog::REPORTS
        .iter()
        .filter(|name| {
            !safety_applications()
                .any(|(_, safety)| safety.backing.member(name).is_some_and(|(_, member)| member.reports()))
        })
        .collect();
    assert!(missing.is_empty(), "{missing:?}");
}
