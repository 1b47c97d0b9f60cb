//! Where the analysis no longer follows each cell or instance, and is conservative (docs/data-flow.md).

use crate::{findings, text};

#[test]
fn range_when_it_has_4096_cells_then_followed_and_with_one_more_its_tag_is_judged_as_one_cell() {
    let with = |size: usize| {
        let tags = format!("    Large : DINT[{size}] (Class := Safety);");
        let rungs = "XIC(Std)MOV(2,Large[7])\nXIC(Safe)MOV(1,Large[W])\nEQU(Large[9],1)OTE(Motor)";
        findings(&text("", &tags, rungs, ""))
    };
    assert_eq!(with(4096), Vec::<String>::new());
    assert_eq!(with(4097), ["S0701 Std"]);
}

#[test]
fn instances_when_they_have_more_operands_in_all_than_are_followed_then_all_that_goes_in_reaches_all_that_comes_out() {
    // 20,200 rungs, instructions and operands in each instance.
    let rung = format!("      N: {}OTE(Step);\n", "XIC(Go)".repeat(99));
    let definition = format!(
        "  ADD_ON_INSTRUCTION_DEFINITION Wide (Class := Safety)\n    PARAMETERS\n      Go : BOOL (Usage := Input, Required := Yes);\n      \
         Spare : BOOL (Usage := Input, Required := Yes);\n      Done : BOOL (Usage := Output, Required := Yes);\n    \
         END_PARAMETERS\n    LOCAL_TAGS\n      Step : BOOL;\n    END_LOCAL_TAGS\n    ROUTINE Logic\n{}      N: \
         XIC(Step)OTE(Done);\n    END_ROUTINE\n  END_ADD_ON_INSTRUCTION_DEFINITION\n",
        rung.repeat(100)
    );
    let tags = "    Units : Wide[60] (Class := Safety);\n    Ready : BOOL[64] (Class := Safety);";
    let with = |count: usize| {
        let calls: String = (0..count).map(|at| format!("Wide(Units[{at}],Safe,Std,Ready[{at}])\n")).collect();
        findings(&text(&definition, tags, &format!("{calls}XIC(Ready[{}])OTE(Motor)", count - 1), ""))
    };
    assert_eq!(with(49), Vec::<String>::new());
    assert_eq!(with(50), ["S0701 Std"]);
}
