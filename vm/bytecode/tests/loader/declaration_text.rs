//! Declarations as canonical text, and the whole text of the rich sample.

use twinrung_bytecode::{layout, text};

use crate::support::samples::{Rich, rich};
use crate::support::*;

/// What a function writes.
fn written<E: std::fmt::Debug>(write: impl FnOnce(&mut String) -> Result<(), E>) -> String {
    let mut out = String::new();
    write(&mut out).unwrap();
    out
}

#[test]
fn routines_when_rendered_then_read_as_people_write_them() {
    let r = rich();
    assert_eq!(
        r.b.text(),
        "XIC(Alias_Bit)[XIC(X1) ,XIO(X2) AFI() ,]OTE(X3);\n\
         MOV(List[Word],Y);\n\
         DCS(Stop,E-STOP,EQUIVALENT - ACTIVE HIGH,500,MANUAL,MANUAL,X1,X2,1,X3);\n\
         TON(Time,?,0);\n\
         COP(Parts[0],Parts[1],2);\n\
         Scale(Inst,5,Y,Word);\n\
         JSR(Sub,1,Word,Y);\n\
         XIC(S:FS)GSV(TASK,Safety_Task,Rate,Y);\n\
         CPT(Local,Word+1);\n"
    );
    assert_eq!(text::render_routine(&r.b.image, r.sub_routine).unwrap(), "SBR(Y);\nRET(Word);\n");
    assert_eq!(text::render_routine(&r.b.image, r.logic).unwrap(), "MUL(Gain,Ref,Result);\n");
    assert_eq!(text::routine_name(&r.b.image, r.logic), "Scale/Logic");
}

#[test]
fn operand_words_when_rendered_then_are_those_of_the_declaration() {
    let mut r = rich();
    let words = [0, 1, 2].map(|value| r.b.operand(OperandRecord::Choice(value)));
    for word in words {
        r.b.rung(&[op(Opcode::Swpb, &[r.word, word, r.y])]);
    }
    let event = r.b.operand(OperandRecord::EventTask(EventTaskIndex(0)));
    r.b.rung(&[op(Opcode::Event, &[event])]);
    r.b.image.system_values.push(SystemValueRecord { attribute: 13, instance: 0, first: 1, program: None });
    let gsv = r.gsv("SAFETY", "", 1, r.y);
    r.b.rung(&[gsv]);
    let tail = "SWPB(Word,REVERSE,Y);\nSWPB(Word,WORD,Y);\nSWPB(Word,HIGH/LOW,Y);\nEVENT(Report);\n\
                GSV(SAFETY,,SafetySignatureExists,Y);\n";
    assert!(r.b.text().ends_with(tail), "{}", r.b.text());
    assert_eq!(r.b.rule(), "admitted");
}

#[test]
fn declarations_when_rendered_then_have_the_manner_of_the_language() {
    let Rich { b, .. } = rich();
    let image = &b.image;
    assert_eq!(
        written(|out| text::write_controller(&image.controller, out)),
        "CONTROLLER Cell (ProcessorType := \"1756-L72S\", Major := 20, SafetyNetwork := 16#0000_41b4_02bb_cb7e)\n"
    );
    assert_eq!(
        written(|out| text::write_type(image, &image.types[2], out)),
        "DATATYPE Part\n  BOOL A;\n  BOOL B;\n  DINT N;\n  INT W[2];\nEND_DATATYPE\n"
    );
    assert_eq!(
        written(|out| text::write_add_on(image, &image.add_ons[0], out)),
        "ADD_ON_INSTRUCTION_DEFINITION Scale (Class := Safety, Revision := \"1.0\")\n  PARAMETERS\n    \
         EnableIn : BOOL (Usage := Input, Required := No);\n    EnableOut : BOOL (Usage := Output, Required := No);\n    \
         Gain : DINT (Usage := Input, Required := Yes);\n    Result : DINT (Usage := Output, Required := Yes);\n    \
         Ref : DINT (Usage := InOut, Required := Yes);\n  END_PARAMETERS\n  LOCAL_TAGS\n    Hold : TIMER;\n  \
         END_LOCAL_TAGS\nEND_ADD_ON_INSTRUCTION_DEFINITION\n"
    );
    assert_eq!(
        written(|out| text::write_program(image, &image.programs[0], out)),
        "PROGRAM Main (Class := Safety, MAIN := \"Main\", DisableFlag := 0)\n"
    );
    assert_eq!(
        written(|out| text::write_task(image, image.task.as_ref().unwrap(), out)),
        "TASK Safety_Task (Type := PERIODIC, Class := Safety, Rate := 20, Watchdog := 10, Priority := 5)\n  Main;\nEND_TASK\n"
    );
    assert_eq!(written(|out| text::write_map(image, out)), "Mapped (MappedFrom := Panel_Reset);\n");
}

#[test]
fn tags_when_rendered_then_show_connections_aliases_and_initial_values() {
    let mut r = rich();
    let cell = r.tag(r.tags.parts).word_cell as usize;
    r.b.image.initial_words[cell..cell + 9].copy_from_slice(&[1, 2, 3, 4, 5, 6, 7, 8, 9]);
    let cell = r.tag(r.tags.parts).bit_cell as usize;
    r.b.image.initial_bits[cell + 3] = 1;
    let cell = r.tag(r.tags.real).word_cell as usize;
    r.b.image.initial_words[cell] = 0.5f32.to_bits().cast_signed();
    r.tag(r.tags.list).constant = true;
    let layouts = layout::layouts(&r.b.image.types).unwrap();
    let tags = written(|out| text::write_tags(&r.b.image, &layouts, None, out));
    assert_eq!(
        tags,
        "TAG\n  Alias_Bit OF Word.3 (Class := Safety);\n  Inst : Scale (Class := Safety);\n  \
         List : DINT[4] (Class := Safety, Constant := Yes);\n  Mapped : BOOL (Class := Safety);\n  \
         Mod:I : Part (Class := Safety, Connection := Input);\n  \
         Parts : Part[3] (Class := Safety) := [[0,0,1,[2,3]],[0,1,4,[5,6]],[0,0,7,[8,9]]];\n  \
         Real : REAL (Class := Safety) := 0.5;\n  Stop : DCI_STOP (Class := Safety);\n  Time : TIMER (Class := Safety);\n  \
         Word : DINT (Class := Safety, SIL := 2) := 2;\n  X1 : BOOL (Class := Safety);\n  X2 : BOOL (Class := Safety);\n  \
         X3 : BOOL (Class := Safety);\n  Y : DINT (Class := Safety);\nEND_TAG\n"
    );
    let local = written(|out| text::write_tags(&r.b.image, &layouts, Some(PROGRAM), out));
    assert_eq!(local, "TAG\n  Local : DINT (Class := Safety);\nEND_TAG\n");
}

#[test]
fn times_when_rendered_then_are_milliseconds_without_trailing_zeros() {
    let rate = |period_us| {
        let mut r = rich();
        let task = r.b.image.task.as_mut().unwrap();
        task.period_us = period_us;
        let text = written(|out| text::write_task(&r.b.image, r.b.image.task.as_ref().unwrap(), out));
        text.split(", ").nth(2).unwrap().to_string()
    };
    assert_eq!(
        [20_000, 1_500, 1_001, 500_000].map(rate),
        ["Rate := 20", "Rate := 1.5", "Rate := 1.001", "Rate := 500"]
    );
}
