//! What a place holds before anything runs, and who sees it.

use crate::{accepted, findings, refused, text};

const LATCHED: &str = "    Set : BOOL (Class := Safety) := 1;";

fn with(tags: &str, rungs: &str) -> Vec<String> {
    findings(&text("", tags, rungs, ""))
}

#[test]
fn bit_when_it_begins_set_and_safety_data_unlatches_it_then_safety_data_qualifies() {
    assert_eq!(with(LATCHED, "XIC(Safe)OTU(Set)\nXIC(Std)XIC(Set)OTE(Motor)"), Vec::<String>::new());
    assert_eq!(with(LATCHED, "XIC(Std2)OTU(Set)\nXIC(Std)XIC(Set)OTE(Motor)"), ["S0701 Std"]);
    assert_eq!(with(LATCHED, "XIC(Std)XIC(Set)OTE(Motor)"), ["S0701 Std"]);
}

#[test]
fn bit_when_a_coil_writes_it_then_only_a_rung_before_the_coil_sees_its_initial_value() {
    assert_eq!(with(LATCHED, "XIC(Safe)OTE(Set)\nXIC(Std)XIC(Set)OTE(Motor)"), Vec::<String>::new());
    assert_eq!(with(LATCHED, "XIC(Std)XIC(Set)OTE(Motor)\nXIC(Safe)OTE(Set)"), ["S0701 Std"]);
}

#[test]
fn scan_when_another_routine_is_declared_before_the_main_routine_then_it_begins_with_the_main_routine() {
    let project = text("", LATCHED, "JSR(Part,0)\nXIC(Safe)OTE(Set)\nXIC(Std)XIC(Set)OTE(Motor)", "");
    let part = "    ROUTINE Part\n      N: NOP();\n    END_ROUTINE\n    ROUTINE Main";
    assert_eq!(findings(&project.replace("    ROUTINE Main", part)), Vec::<String>::new());
}

#[test]
fn bit_of_a_number_when_it_begins_set_then_that_is_a_path_of_neither_origin() {
    let begins = |value: &str| {
        let tags = format!("    Word : DINT (Class := Safety) := {value};");
        with(&tags, "XIC(Safe)MOV(5,Word)\nXIC(Safe)OTL(Word.3)\nXIC(Std)XIC(Word.3)OTE(Motor)")
    };
    assert_eq!(begins("8"), ["S0701 Std"]);
    assert_eq!(begins("1"), Vec::<String>::new());
}

#[test]
fn bit_of_a_number_when_only_bits_of_it_are_written_then_each_has_its_own_origin() {
    accepted("XIC(Safe)OTE(W.1)\nXIC(Std)XIC(W.1)OTE(Motor)");
    refused("XIC(Safe)OTE(W.1)\nXIC(Std)XIO(W.2)OTE(Motor)", &["S0701 Std"]);
    refused("XIC(Safe)OTE(W.1)\nXIC(Std)EQU(W,0)OTE(Motor)", &["S0701 Std"]);
    refused("XIC(Safe)OTE(W.1)\nADD(W,1,W)\nXIC(Std)XIC(W.1)OTE(Motor)", &["S0701 Std"]);
}

#[test]
fn instances_when_several_in_an_array_then_each_begins_with_the_defaults_of_its_definition() {
    let definition = "  ADD_ON_INSTRUCTION_DEFINITION Unit (Class := Safety)\n    PARAMETERS\n      Count : DINT (Usage := Input, \
                      Required := No);\n      Flags : DINT (Usage := Input, Required := No) := 8;\n    END_PARAMETERS\n    \
                      ROUTINE Logic\n      N: NOP();\n    END_ROUTINE\n  END_ADD_ON_INSTRUCTION_DEFINITION\n";
    let tags = "    Units : Unit[3] (Class := Safety);";
    let on_bit = |bit: usize| {
        let flag = format!("Units[2].Flags.{bit}");
        let rungs = format!("XIC(Safe)MOV(5,Units[2].Flags)\nXIC(Safe)OTL({flag})\nXIC(Std)XIC({flag})OTE(Motor)");
        findings(&text(definition, tags, &rungs, ""))
    };
    assert_eq!(on_bit(3), ["S0701 Std"]);
    assert_eq!(on_bit(4), Vec::<String>::new());
}
