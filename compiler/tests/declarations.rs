//! Names that are declared twice, and declarations at a limit and one past it.

mod support;

use support::{admitted, lines, project, read, refused};
use twinrung_compiler::{Completion, check};
use twinrung_grammar::tree::Sources;

const TAGS: &str = "    X, Y : BOOL (Class := Safety);";

fn add_on(name: &str, parameters: &str) -> String {
    format!(
        "  ADD_ON_INSTRUCTION_DEFINITION {name} (Class := Safety)\n    PARAMETERS\n{parameters}    END_PARAMETERS\n    ROUTINE \
         Logic\n      N: NOP();\n    END_ROUTINE\n  END_ADD_ON_INSTRUCTION_DEFINITION\n"
    )
}

#[test]
fn data_type_when_declared_twice_then_the_second_is_refused() {
    let types =
        "  DATATYPE Axis_T\n    DINT Speed;\n  END_DATATYPE\n  DATATYPE <<axis_t>>\n    BOOL Homed;\n  END_DATATYPE\n";
    refused(&project(types, TAGS, "OTE(X)", ""), &["E0206"]);
}

#[test]
fn module_when_declared_twice_then_the_second_is_refused() {
    let rack = "  MODULE Rack (CatalogNumber := \"1734-AENT\", Parent := \"Local\", IPAddress := \"192.168.1.10\") END_MODULE\n";
    let second = rack.replace("Rack", "<<RACK>>").replace("1.10", "1.11");
    refused(&project(&format!("{rack}{second}"), TAGS, "OTE(X)", ""), &["E0206"]);
}

#[test]
fn add_on_instruction_when_it_has_the_name_of_a_type_or_an_instruction_then_refused() {
    let types = "  DATATYPE Axis_T\n    DINT Speed;\n  END_DATATYPE\n";
    for name in ["<<Axis_T>>", "<<TIMER>>", "<<Dint>>", "<<XIC>>"] {
        refused(&project(&format!("{types}{}", add_on(name, "")), TAGS, "OTE(X)", ""), &["E0206"]);
    }
}

#[test]
fn add_on_instruction_when_it_has_512_parameters_then_admitted_and_with_one_more_refused() {
    let with = |count: usize| -> String {
        (0..count).map(|at| format!("      P{at} : BOOL (Usage := Input, Required := No);\n")).collect()
    };
    let tags = format!("{TAGS}\n    Unit : Wide (Class := Safety);");
    admitted(&project(&add_on("Wide", &with(510)), &tags, "Wide(Unit)", ""));
    refused(&project(&add_on("Wide", &with(512)), &tags, "Wide(Unit)", ""), &[]);
    refused(&project(&add_on("<<Wide>>", &with(513)), &tags, "Wide(Unit)", ""), &["E0108"]);
}

#[test]
fn call_when_it_has_84_operands_then_admitted_and_with_one_more_refused() {
    let with = |count: usize| -> String {
        (0..count).map(|at| format!("      P{at} : BOOL (Usage := Input, Required := Yes);\n")).collect()
    };
    let tags = format!("{TAGS}\n    Unit : Wide (Class := Safety);");
    let call = |count: usize| format!("Wide(Unit{})", ",X".repeat(count));
    admitted(&project(&add_on("Wide", &with(83)), &tags, &call(83), ""));
    refused(&project(&add_on("Wide", &with(84)), &tags, &format!("<<{}>>", call(84)), ""), &["E0108"]);
}

#[test]
fn tags_when_they_fill_the_memory_of_an_image_then_admitted_and_with_one_more_refused() {
    let with = |element: &str, last: &str| {
        let tags: String = (0..16).map(|at| format!("    Row{at} : {element}[1048576] (Class := Safety);\n")).collect();
        project("", &format!("{tags}{last}"), "NOP()", "")
    };
    refused(&with("BOOL", ""), &[]);
    refused(&with("DINT", ""), &[]);
    refused(&with("BOOL", "    Last : <<BOOL>> (Class := Safety);"), &["E0108"]);
    refused(&with("DINT", "    Last : <<SINT>> (Class := Safety);"), &["E0108"]);
}

#[test]
fn data_type_when_members_of_type_bool_stand_behind_a_host_then_they_go_on_in_it() {
    // Three BITs and five BOOLs fill a byte.
    let with = |bools: &str| {
        let types = format!(
            "  DATATYPE Flags_T (FamilyType := NoFamily)\n    SINT Z (Hidden := 1);\n    BIT A Z : 0;\n    BIT B Z : 1;\n    \
             BIT C Z : 2;\n    BOOL D;\n    BOOL E;\n    BOOL F;\n    BOOL G;\n{bools}    BIT Z1 Y : 0;\n  END_DATATYPE\n"
        );
        project(&types, &format!("{TAGS}\n    Flags : Flags_T (Class := Safety);"), "XIC(Flags.Z1)OTE(X)", "")
    };
    admitted(&with("    BOOL H;\n    SINT Y (Hidden := 1);\n"));
    refused(&with("    SINT <<Y>> (Hidden := 1);\n"), &["E0307"]);
}

#[test]
fn name_when_nearly_right_then_the_right_one_is_meant_for_the_first_twenty() {
    let rungs = "XIC(Motorr)OTE(X)\n".repeat(21);
    let mut sources = Sources::new();
    let tags = format!("{TAGS}\n    Motor : BOOL (Class := Safety);");
    let reading = read(&mut sources, "sample.rll", &project("", &tags, rungs.trim_end(), ""));
    let checked = check(&reading, &Completion::default());
    let shown = lines(&sources, &checked);
    let meant: Vec<bool> = checked
        .findings
        .iter()
        .filter(|finding| finding.is_error())
        .map(|finding| finding.help.as_deref() == Some("did you mean `Motor`?"))
        .collect();
    assert_eq!(meant, [vec![true; 20], vec![false]].concat(), "{shown}");
}

#[test]
fn mapped_tag_when_something_writes_what_it_is_given_to_then_refused() {
    let tags = "    Panel : DINT;\n    Speed : DINT (Class := Safety, MappedFrom := Panel);\n    Unit : Wide (Class := Safety);\n    Part_1 : DINT (Class := Safety);";
    let body = |rung: &str| add_on("Wide", "      Data : DINT (Usage := InOut);\n").replace("NOP()", rung);
    refused(&project(&body("CLR(Data)"), tags, "Wide(Unit,<<Speed>>)", ""), &["S0304"]);
    refused(&project(&body("EQU(Data,1)NOP()"), tags, "Wide(Unit,Speed)", ""), &[]);
    let part = "    ROUTINE Part\n      N: SBR(Part_1);\n      N: RET(Part_1);\n    END_ROUTINE\n";
    let given = |rung: &str| project(&body("NOP()"), tags, rung, part);
    refused(&given("JSR(Part,1,Part_1,<<Speed>>)"), &["S0304"]);
    refused(&given("JSR(Part,1,Speed,Part_1)"), &[]);
}

#[test]
fn structure_when_it_holds_the_tag_of_a_safety_instruction_then_nothing_else_writes_it_as_a_whole() {
    let types = "  DATATYPE Cell_T\n    DINT Count;\n    DCI_STOP Stop;\n  END_DATATYPE\n  DATATYPE Line_T\n    Cell_T Cells[2];\n  END_DATATYPE\n";
    let tags = "    One, Two : Line_T (Class := Safety);";
    refused(&project(types, tags, "COP(<<One>>,<<Two>>,1)", ""), &["S0106", "S0602"]);
    refused(&project(types, tags, "COP(<<One.Cells[0]>>,<<Two.Cells[1]>>,1)", ""), &["S0106", "S0602"]);
    refused(&project(types, tags, "MOV(One.Cells[0].Count,Two.Cells[1].Count)", ""), &[]);
}

#[test]
fn safety_task_when_there_are_others_then_the_first_of_its_class() {
    let text = project("", TAGS, "OTE(X)", "").replace(
        "  TASK Safety_Task",
        "  TASK Other (Type := PERIODIC, Rate := 10, Priority := 7)\n  END_TASK\n  TASK Safety_Task",
    );
    let image = admitted(&text);
    assert_eq!(
        image.image().task.as_ref().map(|task| (task.name.as_str(), task.period_us)),
        Some(("Safety_Task", 20_000))
    );
}
