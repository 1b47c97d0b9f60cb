//! The backing tag of a safety application instruction: its type, that it serves one call, and that nothing else touches it.

use twinrung_catalog::Instruction;
use twinrung_catalog::operand::OperandKind;

use super::call::{Call, expect_none, instructions, operands};

#[test]
fn backing_tag_when_of_another_instructions_type_then_refused_at_the_operand() {
    expect_none(instructions().flat_map(|instruction| {
        let other = instructions().filter(move |other| other.mnemonic != instruction.mnemonic);
        other.filter_map(move |other| {
            let mut call = Call::of(instruction);
            call.tags = format!("Wrong : {} (Class := Safety);\n", other.safety.unwrap().backing.name);
            call.with(0, "Wrong").expect_refused("E0302", 0)
        })
    }));
}

/// An accepted call, and a second rung.
fn with_second_rung(instruction: &'static Instruction, rung: &str) -> Call {
    let mut call = Call::of(instruction);
    call.tags = "Other : BOOL (Class := Safety);\nCopy : ".to_owned()
        + instruction.safety.unwrap().backing.name
        + " (Class := Safety);\n";
    call.rungs = format!("N: {rung};\n");
    call
}

/// The refusal of a second rung, and of nothing else: code and text.
fn expect_rung_refused(
    instruction: &'static Instruction,
    rung: &str,
    code: &'static str,
    text: &str,
) -> Option<String> {
    let found = with_second_rung(instruction, rung).refusals();
    let as_meant = matches!(&found[..], [one] if one.code == code && one.text == text && one.operand.is_none());
    (!as_meant).then(|| format!("{rung}: expected {code} at {text}, found {found:?}"))
}

#[test]
fn backing_tag_when_a_second_call_uses_it_then_that_call_is_refused() {
    expect_none(instructions().filter_map(|instruction| {
        let again = format!("{}({})", instruction.mnemonic, Call::of(instruction).operands.join(","));
        expect_rung_refused(instruction, &again, "S0601", "Operand_0")
    }));
}

#[test]
fn members_of_a_backing_tag_when_logic_writes_them_then_refused() {
    expect_none(instructions().filter_map(|instruction| {
        let output = instruction.safety.unwrap().backing.members.iter().find(|member| member.name == "FP");
        let member = output.map_or("EnableOut", |member| member.name);
        let rung = format!("XIC(Other)OTE(Operand_0.{member})");
        expect_rung_refused(instruction, &rung, "S0602", &format!("Operand_0.{member}"))
    }));
}

#[test]
fn backing_tag_when_logic_copies_into_it_then_refused() {
    expect_none(instructions().filter_map(|instruction| {
        let found = with_second_rung(instruction, "COP(Copy,Operand_0,1)").refusals();
        let refused = found.iter().any(|one| one.code == "S0602" && one.text == "Operand_0");
        (!refused).then(|| format!("{}: {found:?}", instruction.mnemonic))
    }));
}

#[test]
fn enable_in_of_a_backing_tag_when_logic_reads_it_then_refused() {
    expect_none(instructions().filter_map(|instruction| {
        expect_rung_refused(instruction, "XIC(Operand_0.EnableIn)OTE(Other)", "S0603", "Operand_0.EnableIn")
    }));
}

#[test]
fn members_of_a_backing_tag_when_its_own_call_reads_them_then_refused_at_the_operand() {
    expect_none(operands().filter_map(|(call, place, kind)| {
        let bit = matches!(kind, OperandKind::SafetyBit { .. });
        bit.then(|| call.with(place, "Operand_0.EnableOut").expect_refused("S0608", place)).flatten()
    }));
}
