//! Every feature of the language once: compiled, admitted by the loader, and printed as written.

mod support;

use support::{admitted, image, project, text_of};
use twinrung_bytecode::image::TagKind;

const TYPES: &str = "  DATATYPE Axis_T
    BOOL Enabled;
    BOOL Homed;
    INT Speed;
    DINT Limits[4];
    TIMER Delay;
  END_DATATYPE
  DATATYPE Cell_T
    Axis_T Axes[3];
    SINT Code;
    BOOL Flags[32];
    STRING Label;
  END_DATATYPE
";

fn prints(tags: &str, rungs: &str) {
    let image = admitted(&project(TYPES, tags, rungs, ""));
    let expected: String = rungs.lines().map(|rung| format!("{};\n", rung.trim())).collect();
    assert_eq!(text_of(&image, "Main"), expected);
}

#[test]
fn members_when_nested_in_arrays_of_structures_then_reached() {
    prints(
        "    Cell : Cell_T (Class := Safety);\n    I : DINT (Class := Safety);\n    Run : BOOL (Class := Safety);",
        "XIC(Cell.Axes[1].Enabled)XIC(Cell.Flags[31])OTE(Run)
         XIC(Cell.Axes[I].Homed)OTE(Run)
         MOV(Cell.Axes[I].Limits[I+1],Cell.Axes[2].Speed)
         XIC(Run)TON(Cell.Axes[0].Delay,500,0)
         XIC(Cell.Axes[2].Delay.DN)XIC(Cell.Code.7)XIC(Cell.Axes[1].Speed.[I])OTE(Run)
         MOV(Cell.Label.LEN,I)",
    );
}

#[test]
fn subscripts_when_three_dimensional_and_variable_then_reached() {
    prints(
        "    Cube : DINT[2,3,4] (Class := Safety);\n    I, J : DINT (Class := Safety);\n    Bits : BOOL[64] (Class := Safety);\n    Run : BOOL (Class := Safety);",
        "MOV(Cube[1,2,3],Cube[I,J,0])
         MOV(Cube[I,2,J],I)
         MOV(Cube[Cube[0,0,0],I-1,(I+J)*2],I)
         XIC(Bits[5])XIC(Bits[I])XIC(I.[J])XIC(Cube[0,0,1].31)OTE(Run)",
    );
}

#[test]
fn instructions_when_of_every_base_kind_then_printed_as_written() {
    prints(
        "    A, B, C : DINT (Class := Safety);\n    R, Q : REAL (Class := Safety);\n    W : INT (Class := Safety);\n    X, Y, S : BOOL (Class := Safety);\n    T : TIMER (Class := Safety);\n    N : COUNTER (Class := Safety);\n    K : CONTROL (Class := Safety);\n    V, U : DINT[10] (Class := Safety);",
        "XIC(X)XIO(Y)ONS(S)OTE(Y)
         OSR(S,Y)
         [XIC(X) ,XIO(Y) [XIC(S) ,] ][OTL(X) ,OTU(Y) ]
         CTU(N,?,?)
         RES(N)
         EQU(A,B)NEQ(A,-5)GRT(A,16#ff)GEQ(A,8#17)LES(A,2#1)LEQ(A,B)LIM(1,A,10)MEQ(A,16#ff,B)OTE(X)
         CMP((A*2+1)>B)OTE(X)
         CMP((A>B) OR (B>C))OTE(X)
         CPT(R,ABS(Q)*1.5-SQR(R))
         ADD(A,1,B)
         SUB(A,B,C)
         MUL(R,2.0,Q)
         NEQ(B,0)DIV(A,B,C)
         NEQ(B,0)MOD(A,B,C)
         SQR(A,B)
         NEG(A,B)
         ABS(A,B)
         AND(A,B,C)
         NOT(A,B)
         MVM(A,16#f,B)
         CLR(A)
         SWPB(A,REVERSE,B)
         COP(V[0],U[2],8)
         FLL(0,V[0],10)
         SIZE(V[0],0,A)
         FAL(K,10,0,ALL,U[K.POS],V[K.POS]+1)
         FSC(K,10,?,INC,V[K.POS]=7)
         GSV(SAFETY,,SafetyLocked,Locked)
         GSV(TASK,Safety_Task,Rate,A)
         XIC(S:FS)OTE(Y)
         AFI()NOP()
         XIC(X)MCR()
         MCR()"
            .replace("GSV(SAFETY,,SafetyLocked,Locked)\n         ", "")
            .as_str(),
    );
}

#[test]
fn newer_mnemonics_when_read_then_printed_as_the_classic_ones() {
    let image = admitted(&project(
        "",
        "    A, B : DINT (Class := Safety);\n    X : BOOL (Class := Safety);",
        "EQ(A,B)GE(A,1)OTE(X)\nMOVE(A,B)",
        "",
    ));
    assert_eq!(text_of(&image, "Main"), "EQU(A,B)GEQ(A,1)OTE(X);\nMOV(A,B);\n");
}

#[test]
fn names_when_in_another_case_then_printed_as_declared() {
    let image = admitted(&project("", "    Motor : BOOL (Class := Safety);", "xic(MOTOR)ote(motor)", ""));
    assert_eq!(text_of(&image, "Main"), "XIC(Motor)OTE(Motor);\n");
}

#[test]
fn option_words_when_written_as_numbers_or_in_quotes_then_one_image() {
    let tags = "    E : DCI_STOP (Class := Safety);\n    A, B, S, R : BOOL (Class := Safety);";
    let words = image(&project("", tags, "DCS(E,E-STOP,EQUIVALENT - ACTIVE HIGH,500,MANUAL,MANUAL,A,B,S,R)", ""));
    let numbers = image(&project("", tags, "DCS(E,1,0,500,0,0,A,B,S,R)", ""));
    let quoted =
        image(&project("", tags, "DCS(E,'E-STOP','EQUIVALENT - ACTIVE HIGH',500,'MANUAL','MANUAL',A,B,S,R)", ""));
    assert_eq!(words.bytes, numbers.bytes);
    assert_eq!(words.bytes, quoted.bytes);
}

#[test]
fn aliases_when_chained_to_elements_bits_and_module_tags_then_resolved() {
    let modules = "  MODULE Rack (CatalogNumber := \"1734-AENT\", Parent := \"Local\", IPAddress := \"192.168.1.10\") END_MODULE
  MODULE Doors (CatalogNumber := \"1734-IB8S\", Parent := \"Rack\", Slot := 1, SafetyNetwork := 16#0000_0000_0001_0002, RPI := 10) END_MODULE
";
    let tags = "    Second OF First;\n    First OF Words[2].5;\n    Words : DINT[4] (Class := Safety);\n    Door OF Doors:I.Pt00Data;\n    Row OF Words;\n    Run : BOOL (Class := Safety);";
    let rungs = "XIC(Second)XIC(Door)XIC(Doors:I.Pt01Data)XIO(Doors:I.ConnectionFaulted)OTE(Run)\nMOV(Row[1],Words[0])";
    let image = admitted(&project(modules, tags, rungs, ""));
    let kinds = |name: &str| image.image().tags.iter().find(|tag| tag.name == name).unwrap().kind;
    assert!(matches!(kinds("Second"), TagKind::Alias(_)));
    assert_eq!(kinds("Doors:I"), TagKind::ModuleInput);
}

#[test]
fn module_tags_when_written_by_rack_and_slot_then_named_so() {
    let modules = "  MODULE Rack (CatalogNumber := \"1734-AENT\", Parent := \"Local\", IPAddress := \"192.168.1.10\") END_MODULE
  MODULE Doors (CatalogNumber := \"1734-IB8S\", Parent := \"Rack\", Slot := 1, SafetyNetwork := 16#0000_0000_0001_0002, RPI := 10) END_MODULE
";
    let tags = "    Run : BOOL (Class := Safety);";
    let rungs = "XIC(Rack:1:I.Pt01Data)XIO(Rack:1:I.ConnectionFaulted)OTE(Run)";
    let image = admitted(&project(modules, tags, rungs, ""));
    assert!(image.image().tags.iter().any(|tag| tag.name == "Rack:1:I"));
}

#[test]
fn add_on_instructions_when_nested_with_in_out_arrays_and_structures_then_admitted() {
    let declarations = "  DATATYPE Axis_T
    BOOL Enabled;
    DINT Speed;
  END_DATATYPE
  ADD_ON_INSTRUCTION_DEFINITION Outer (Class := Safety)
    PARAMETERS
      Start : BOOL (Usage := Input);
      Limit : INT (Usage := Input) := 7;
      Done : BOOL (Usage := Output, Required := Yes);
      Axes : Axis_T[2] (Usage := InOut);
    END_PARAMETERS
    LOCAL_TAGS
      Inner_1 : Inner;
      Wait : TIMER := [0,250,0];
      Table : DINT[3] := [1,2,3];
    END_LOCAL_TAGS
    ROUTINE Logic
      N: XIC(Start)TON(Wait,250,0);
      N: Inner(Inner_1,Limit,Axes[1].Speed);
      N: XIC(Wait.DN)XIC(Axes[0].Enabled)OTE(Done);
      N: MOV(Table[2],Axes[0].Speed);
    END_ROUTINE
    ROUTINE EnableInFalse
      N: OTU(Done);
    END_ROUTINE
  END_ADD_ON_INSTRUCTION_DEFINITION
  ADD_ON_INSTRUCTION_DEFINITION Inner (Class := Safety)
    PARAMETERS
      Value : DINT (Usage := Input);
      Result : DINT (Usage := Output, Required := Yes);
    END_PARAMETERS
    ROUTINE Logic
      N: ADD(Value,1,Result);
    END_ROUTINE
    ROUTINE Prescan
      N: CLR(Result);
    END_ROUTINE
  END_ADD_ON_INSTRUCTION_DEFINITION
";
    let tags = "    One : Outer (Class := Safety);\n    Many : Outer[2] (Class := Safety);\n    Axes : Axis_T[2] (Class := Safety);\n    Go, Ready : BOOL (Class := Safety);";
    let image = admitted(&project(
        declarations,
        tags,
        "Outer(One,Go,5,Ready,Axes)\nOuter(Many[1],1,Axes[0].Speed,Ready,Axes)\nXIC(One.Done)OTE(Ready)",
        "",
    ));
    let records = image.image();
    assert_eq!(records.add_ons.iter().map(|one| one.name.as_str()).collect::<Vec<_>>(), ["Inner", "Outer"]);
    // Every instance begins with what the definition gives its local tags and its timer's preset.
    assert_eq!(records.initial_words.iter().filter(|word| **word == 250).count(), 3);
    assert_eq!(records.initial_words.iter().filter(|word| **word == 7).count(), 3);
}

#[test]
fn subroutines_when_parameters_of_every_kind_pass_then_admitted() {
    let routines = "    ROUTINE Part
      N: SBR(Word,Flag,Local_Axis)XIC(Flag)OTE(Local_Axis.Enabled);
      N: XIC(Flag)RET(Word);
      N: RET(Word);
    END_ROUTINE
";
    let tags = "    Word, Back : DINT (Class := Safety);\n    Flag, Go : BOOL (Class := Safety);\n    Local_Axis, Axis : Axis_T (Class := Safety);";
    admitted(&project(TYPES, tags, "XIC(Go)JSR(Part,3,5,Go,Axis,Back)\nJSR(part,3,Back,Word.3,Axis,Word)", routines));
}

#[test]
fn jumps_when_forward_with_labels_in_another_case_then_admitted() {
    let image =
        admitted(&project("", "    A, B : BOOL (Class := Safety);", "XIC(A)JMP(SKIP)\nOTE(B)\nLBL(Skip)NOP()", ""));
    assert_eq!(text_of(&image, "Main"), "XIC(A)JMP(Skip);\nOTE(B);\nLBL(Skip)NOP();\n");
}

#[test]
fn system_values_and_events_when_used_then_listed_once() {
    let text = project(
        "",
        "    Rate, Rate_2 : DINT (Class := Safety);\n    Record : DINT[11] (Class := Safety);\n    Exists : SINT (Class := Safety);",
        "GSV(Task,Safety_Task,Rate,Rate)\nGSV(TASK,this,Rate,Rate_2)\nGSV(PROGRAM,THIS,MajorFaultRecord,Record[0])\nSSV(PROGRAM,THIS,MajorFaultRecord,Record[0])\nGSV(SAFETY,,SafetySignatureExists,Exists)\nEVENT(Alarm)",
        "",
    )
    .replace("END_CONTROLLER", "  TASK Alarm (Type := EVENT, Priority := 5)\n  END_TASK\nEND_CONTROLLER");
    let image = admitted(&text);
    assert_eq!(image.image().system_values.len(), 3);
    assert_eq!(image.image().event_tasks, ["Alarm"]);
}

#[test]
fn connected_tags_when_produced_consumed_and_mapped_then_marked() {
    let declarations = "  DATATYPE Line_T\n    CONNECTION_STATUS Status;\n    BOOL Stop;\n  END_DATATYPE\n";
    let tags = "    Out_Line : Line_T (Class := Safety, Produced := 1, RPI := 20);\n    In_Line : Line_T (Class := Safety, Producer := Other, RemoteTag := \"Out_Line\", RPI := 20);\n    Panel : DINT;\n    Speed : DINT (Class := Safety, MappedFrom := Panel);\n    Run : BOOL (Class := Safety);";
    let image = admitted(&project(
        declarations,
        tags,
        "XIC(In_Line.Stop)XIO(In_Line.Status.ConnectionFaulted)OTE(Out_Line.Stop)\nGRT(Speed,5)OTE(Run)",
        "",
    ));
    let kind = |name: &str| image.image().tags.iter().find(|tag| tag.name == name).unwrap().kind;
    assert_eq!((kind("Out_Line"), kind("In_Line")), (TagKind::Produced, TagKind::Consumed));
    assert_eq!(image.image().map.len(), 1);
}

#[test]
fn initial_values_when_of_every_type_then_in_the_cells() {
    let tags = "    Word : INT (Class := Safety) := -5;\n    Flag : BOOL (Class := Safety) := 1;\n    Ratio : REAL (Class := Safety) := 1.5;\n    T : TIMER (Class := Safety) := [0,1500,20];\n    Row : SINT[3] (Class := Safety) := [1,-2,16#ff];\n    Axis : Axis_T (Class := Safety) := [3,7,[1,2,3,4],[0,90,0]];\n    Text : STRING (Class := Safety) := [2,'Ab'];";
    let image = admitted(&project(TYPES, tags, "OTE(Flag)", ""));
    let records = image.image();
    let words = |name: &str, count: usize| {
        let tag = records.tags.iter().find(|tag| tag.name == name).unwrap();
        records.initial_words[tag.word_cell as usize..][..count].to_vec()
    };
    assert_eq!(words("Word", 1), [-5]);
    assert_eq!(words("Ratio", 1), [0x3FC0_0000]);
    assert_eq!(words("T", 2), [1500, 20]);
    assert_eq!(words("Row", 3), [1, -2, -1]);
    assert_eq!(words("Axis", 7), [7, 1, 2, 3, 4, 90, 0]);
    assert_eq!(words("Text", 3), [2, 65, 98]);
    let axis = records.tags.iter().find(|tag| tag.name == "Axis").unwrap();
    assert_eq!(records.initial_bits[axis.bit_cell as usize..][..2], [1, 1]);
}

#[test]
fn declarations_when_in_another_order_then_the_same_bytes() {
    let first = image(&project(
        TYPES,
        "    A : BOOL (Class := Safety);\n    B : Cell_T (Class := Safety);",
        "XIC(A)OTE(B.Axes[0].Homed)",
        "",
    ));
    let swapped: String = {
        let mut parts: Vec<&str> = TYPES.split_inclusive("END_DATATYPE\n").collect();
        parts.reverse();
        parts.concat()
    };
    let second = image(&project(
        &swapped,
        "    B : Cell_T (Class := Safety);\n    A : BOOL (Class := Safety);",
        "XIC(A)OTE(B.Axes[0].Homed)",
        "",
    ));
    assert_eq!(first.bytes, second.bytes);
}
