//! What a call of a safety application instruction may say, driven by the catalog's declarations: every option of every
//! instruction at both ends of its range and just beyond, every word, the controllers, and the backing tag. A refusal
//! stands at the operand's place.

mod backing;
mod call;

use twinrung_catalog::operand::OperandKind;
use twinrung_catalog::{Opcode, Relation, Requires, controller};
use twinrung_safety_vectors::normal_operation;
use twinrung_workbench::pages::instruction::example;

use self::call::{Call, expect_none, instructions, least, operands};

#[test]
fn calls_when_every_operand_is_as_declared_then_they_are_accepted() {
    expect_none(instructions().filter_map(|instruction| Call::of(instruction).expect_accepted()));
}

#[test]
fn example_of_a_page_when_compiled_then_it_is_accepted() {
    expect_none(instructions().filter_map(|instruction| {
        let vector = normal_operation(instruction.opcode).unwrap().unwrap();
        let text = example(instruction, &vector);
        let inner = text.split_once('(').unwrap().1.strip_suffix(')').unwrap();
        // A word may hold parentheses, never a comma.
        let shown: Vec<&str> = inner.split(',').collect();
        let mut call = Call::of(instruction);
        assert_eq!(shown.len(), call.operands.len(), "{text}");
        for (place, operand) in instruction.operands.iter().enumerate() {
            if matches!(operand.kind, OperandKind::Choice(_) | OperandKind::Literal { .. }) {
                call.operands[place] = shown[place].to_owned();
            }
        }
        call.expect_accepted()
    }));
}

#[test]
fn numeric_options_when_at_an_end_of_their_range_then_accepted_and_when_beyond_then_refused_there() {
    expect_none(operands().flat_map(|(call, place, kind)| {
        let OperandKind::Literal { or_zero, least, greatest, step, .. } = kind else { return Vec::new() };
        let zero = or_zero.then_some(0);
        let accepted = [least, greatest].into_iter().chain(zero).map(|value| call.with(place, value.to_string()));
        let beyond = [least - 1, greatest + 1, -1, least + step - 1]
            .into_iter()
            .filter(|value| Some(*value) != zero && !((least..=greatest).contains(value) && value % step == 0));
        let refused = beyond.map(|value| call.with(place, value.to_string()));
        let others = ["Operand_0", "7.5", "?"].map(|text| call.with(place, text).refusals());
        let unrefused = others.iter().filter(|found| found.first().map(|one| one.operand) != Some(Some(place)));
        let wrong = unrefused.map(|found| format!("{} operand {place}: {found:?}", call.instruction.mnemonic));
        let wrong: Vec<String> = wrong.collect();
        accepted
            .filter_map(|call| call.expect_accepted())
            .chain(refused.filter_map(|call| call.expect_refused("E0305", place)))
            .chain(wrong)
            .collect()
    }));
}

#[test]
fn numbers_in_place_of_tags_when_admitted_then_their_range_is_checked_and_when_not_then_refused() {
    expect_none(operands().flat_map(|(call, place, kind)| {
        let (accepted, refused, code): (Vec<String>, Vec<String>, _) = match kind {
            OperandKind::SafetyBit { immediate: true } => (vec!["0".into(), "1".into()], vec!["2".into()], "E0302"),
            OperandKind::SafetyBit { immediate: false } => (vec![], vec!["0".into(), "1".into()], "E0302"),
            OperandKind::SafetyInteger { immediate: Some((least, greatest)), .. } => {
                let beyond = [least.checked_sub(1), greatest.checked_add(1)].into_iter().flatten();
                (
                    [least, greatest].map(|one| one.to_string()).to_vec(),
                    beyond.map(|one| one.to_string()).collect(),
                    "E0305",
                )
            }
            OperandKind::SafetyInteger { immediate: None, .. } => (vec![], vec!["1".into()], "E0302"),
            OperandKind::SafetyReal { immediate: true, not_negative: true } => {
                (vec!["0.0".into(), "0.5".into()], vec!["-0.5".into()], "E0305")
            }
            OperandKind::SafetyReal { immediate: true, not_negative: false } => (vec!["-0.5".into()], vec![], "E0305"),
            OperandKind::SafetyReal { immediate: false, .. } => (vec![], vec!["0.5".into()], "E0302"),
            _ => (vec![], vec![], ""),
        };
        let accepted = accepted.into_iter().filter_map(|text| call.with(place, text).expect_accepted());
        let refused = refused.into_iter().filter_map(|text| call.with(place, text).expect_refused(code, place));
        accepted.chain(refused).collect::<Vec<_>>()
    }));
}

#[test]
fn words_when_in_the_list_then_accepted_by_word_and_number_and_when_not_then_refused_there() {
    expect_none(operands().flat_map(|(call, place, kind)| {
        let OperandKind::Choice(list) = kind else { return Vec::new() };
        let words =
            list.words.iter().flat_map(|(word, value)| [(*word).to_owned(), word.to_lowercase(), value.to_string()]);
        let accepted = words.filter_map(|text| call.with(place, text).expect_accepted());
        let stranger = (-1..=200).find(|value| list.word(*value).is_none()).unwrap().to_string();
        let refused = ["NO SUCH WORD".to_owned(), stranger, "Operand_0".to_owned()]
            .into_iter()
            .filter_map(|text| call.with(place, text).expect_refused("E0304", place));
        let missing = call.with(place, "?").expect_refused("E0303", place);
        accepted.chain(refused).chain(missing).collect()
    }));
}

#[test]
fn tags_when_of_another_type_then_refused_at_the_operand() {
    expect_none(operands().filter_map(|(mut call, place, kind)| {
        let wrong = match kind {
            OperandKind::Structure(..) | OperandKind::SafetyBit { .. } => "DINT",
            OperandKind::SafetyInteger { .. } | OperandKind::SafetyReal { .. } => "BOOL",
            _ => return None,
        };
        call.tags = format!("Wrong : {wrong} (Class := Safety);\n");
        call.with(place, "Wrong").expect_refused("E0302", place)
    }));
}

#[test]
fn instructions_when_the_controller_or_its_revision_lacks_them_then_refused_at_the_mnemonic() {
    expect_none(instructions().flat_map(|instruction| {
        let known = controller::ALL
            .iter()
            .flat_map(|known| [14, 16, 17, 18, 19, 20, 28, 31, 36].map(|revision| (known, revision)));
        known
            .filter(|(known, revision)| known.knows_revision(*revision))
            .filter_map(move |(known, revision)| {
                let has_real = known.has_real() || instruction.requires == Requires::Any;
                let admitted = has_real && revision >= u16::from(instruction.first_version);
                let call = Call { controller: (known.catalog_number, revision), ..Call::of(instruction) };
                let found = call.refusals();
                let refused = found.iter().any(|one| one.code == "S0102" && one.text == instruction.mnemonic);
                let as_meant = if admitted { found.is_empty() } else { refused };
                (!as_meant)
                    .then(|| format!("{} on {}/{revision}: {found:?}", instruction.mnemonic, known.catalog_number))
            })
            .collect::<Vec<_>>()
    }));
    let dcaf = Call { controller: ("1756-L63S", 20), ..Call::of(Opcode::Dcaf.instruction()) };
    assert!(dcaf.refusals().iter().any(|one| one.code == "S0102" && one.text == "DCAF"));
}

#[test]
fn relations_when_broken_then_refused_at_the_operand_and_when_kept_then_accepted() {
    expect_none(instructions().flat_map(|instruction| {
        let call = Call::of(instruction);
        let relations = instruction.safety.unwrap().relations.iter();
        relations.flat_map(|relation| broken_and_kept(&call, *relation)).collect::<Vec<_>>()
    }));
}

fn broken_and_kept(call: &Call, relation: Relation) -> Vec<String> {
    let set = |pairs: &[(usize, String)]| {
        let mut call = call.clone();
        pairs.iter().for_each(|(place, text)| call.operands[*place] = text.clone());
        call
    };
    let wrong = match relation {
        Relation::DifferentTags(first, second) => {
            let (first, second) = (call.place(first), call.place(second));
            let same = set(&[(second, call.operands[first].clone())]);
            vec![same.expect_refused("S0605", second), call.expect_accepted()]
        }
        Relation::NotZeroWhen(time, choice, value) => {
            let (time, choice) = (call.place(time), call.place(choice));
            let some = least(&call.instruction.operands[time]).to_string();
            let broken = set(&[(choice, value.to_string()), (time, "0".into())]);
            let kept = set(&[(choice, value.to_string()), (time, some)]);
            vec![broken.expect_refused("S0605", time), kept.expect_accepted()]
        }
        Relation::BelowUnlessZero(first, second) => {
            let (first, second) = (call.place(first), call.place(second));
            let values = |a: &str, b: &str| set(&[(first, a.to_owned()), (second, b.to_owned())]);
            vec![
                values("50", "50").expect_refused("S0605", first),
                values("50", "51").expect_accepted(),
                values("50", "0").expect_accepted(),
            ]
        }
        Relation::NotAbove(first, second) => {
            let (first, second) = (call.place(first), call.place(second));
            let values = |a: &str, b: &str| set(&[(first, a.to_owned()), (second, b.to_owned())]);
            vec![values("51", "50").expect_refused("S0605", first), values("50", "50").expect_accepted()]
        }
        Relation::PeriodAtMost(ms) => {
            let at = Call { period_ms: ms, ..call.clone() };
            let above = Call { period_ms: ms + 1, ..call.clone() }.refusals();
            let as_meant = matches!(&above[..], [one] if one.code == "S0605");
            vec![at.expect_accepted(), (!as_meant).then(|| format!("{ms} ms: {above:?}"))]
        }
    };
    wrong.into_iter().flatten().collect()
}
