//! What the tests of this crate share; each of them uses a part.

#![allow(dead_code)]

use twinrung_bytecode::AdmittedImage;
use twinrung_compiler::{Checked, CompiledImage, Completion, check, compile};
use twinrung_grammar::Reading;
use twinrung_grammar::tree::Sources;

/// A project on a 1756-L73S: declarations, tags of the controller, rungs of the main routine, further routines.
pub fn project(declarations: &str, tags: &str, rungs: &str, routines: &str) -> String {
    let rungs: String = rungs.lines().map(|rung| format!("      N: {};\n", rung.trim())).collect();
    format!(
        "CONTROLLER Sample (ProcessorType := \"1756-L73S\", Major := 20)\n{declarations}  TAG\n{tags}\n  END_TAG\n  \
         PROGRAM Safety_Main (Class := Safety, MAIN := \"Main\")\n    ROUTINE Main\n{rungs}    END_ROUTINE\n{routines}  \
         END_PROGRAM\n  TASK Safety_Task (Type := PERIODIC, Class := Safety, Rate := 20, Watchdog := 20, Priority := 5)\n    \
         Safety_Main;\n  END_TASK\nEND_CONTROLLER\n"
    )
}

/// Reads a text.
pub fn read(sources: &mut Sources, name: &str, text: &str) -> Reading {
    twinrung_grammar::read(sources, name, text.as_bytes().to_vec())
}

/// Findings of a check as lines.
pub fn lines(sources: &Sources, checked: &Checked) -> String {
    checked
        .findings
        .iter()
        .map(|finding| {
            let place = sources.line_column(finding.span);
            format!("{}:{} {} {}\n", place.line, place.column, finding.code.id, finding.message)
        })
        .collect()
}

/// Compiles a text that has no errors.
pub fn image(text: &str) -> CompiledImage {
    let mut sources = Sources::new();
    let reading = read(&mut sources, "sample.rll", text);
    let checked = check(&reading, &Completion::default());
    let shown = lines(&sources, &checked);
    let project = checked.project.unwrap_or_else(|| panic!("refused:\n{shown}\n{text}"));
    compile(&project).unwrap_or_else(|finding| panic!("{}", finding.message))
}

/// Compiles a text and lets the loader verify the image.
pub fn admitted(text: &str) -> AdmittedImage {
    let compiled = image(text);
    twinrung_bytecode::admit(&compiled.bytes).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

/// The canonical text of the first routine.
pub fn text_of(image: &AdmittedImage, routine: &str) -> String {
    image.image().routines.iter().find(|one| one.name == routine).unwrap().text.clone()
}

/// Checks a marked text: exactly these errors, in this order, at the marks.
pub fn refused(marked: &str, codes: &[&str]) {
    let text = marked.replace("<<", "").replace(">>", "");
    let mut sources = Sources::new();
    let reading = read(&mut sources, "sample.rll", &text);
    let checked = check(&reading, &Completion::default());
    let shown = lines(&sources, &checked);
    let errors: Vec<_> = checked.findings.iter().filter(|finding| finding.is_error()).collect();
    let found: Vec<(&str, &str)> = errors.iter().map(|finding| (finding.code.id, sources.text(finding.span))).collect();
    let marks: Vec<&str> = marked.split("<<").skip(1).map(|rest| rest.split(">>").next().unwrap()).collect();
    let expected: Vec<(&str, &str)> = codes.iter().copied().zip(marks).collect();
    assert_eq!(found, expected, "{shown}");
    assert!(errors.iter().all(|finding| finding.help.is_some()), "no way out:\n{shown}");
}

/// The same of rungs of the main routine, with tags of the controller.
pub fn on_rungs(tags: &str, rungs: &str, codes: &[&str]) {
    refused(&project("", tags, rungs, ""), codes);
}

/// The same as an export, with a data type `Axis_T` of two bits and an INT: tags of the controller, rungs of the main routine.
pub fn export(tags: &str, rungs: &str) -> String {
    let rungs: String = rungs
        .lines()
        .enumerate()
        .map(|(at, rung)| format!("<Rung Number=\"{at}\" Type=\"N\"><Text><![CDATA[{rung}]]></Text></Rung>\n"))
        .collect();
    format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"yes\"?>
<RSLogix5000Content SchemaRevision=\"1.0\" SoftwareRevision=\"20.01\" TargetName=\"Sample\" TargetType=\"Controller\" ContainsContext=\"false\">
<Controller Use=\"Target\" Name=\"Sample\" ProcessorType=\"1756-L73S\" MajorRev=\"20\" MinorRev=\"11\">
<DataTypes><DataType Name=\"Axis_T\" Family=\"NoFamily\" Class=\"User\"><Members>
<Member Name=\"ZZZZZZZZZZAxis_T0\" DataType=\"SINT\" Dimension=\"0\" Radix=\"Decimal\" Hidden=\"true\" ExternalAccess=\"Read/Write\"/>
<Member Name=\"Enabled\" DataType=\"BIT\" Dimension=\"0\" Radix=\"Decimal\" Hidden=\"false\" Target=\"ZZZZZZZZZZAxis_T0\" BitNumber=\"0\" ExternalAccess=\"Read/Write\"/>
<Member Name=\"Homed\" DataType=\"BIT\" Dimension=\"0\" Radix=\"Decimal\" Hidden=\"false\" Target=\"ZZZZZZZZZZAxis_T0\" BitNumber=\"1\" ExternalAccess=\"Read/Write\"/>
<Member Name=\"Speed\" DataType=\"INT\" Dimension=\"0\" Radix=\"Decimal\" Hidden=\"false\" ExternalAccess=\"Read/Write\"/>
</Members></DataType></DataTypes>
<Tags>{tags}</Tags>
<Programs><Program Name=\"Safety_Main\" TestEdits=\"false\" MainRoutineName=\"Main\" Disabled=\"false\" Class=\"Safety\"><Tags/><Routines>
<Routine Name=\"Main\" Type=\"RLL\"><RLLContent>{rungs}</RLLContent></Routine></Routines></Program></Programs>
<Tasks><Task Name=\"Safety_Task\" Type=\"PERIODIC\" Rate=\"20\" Priority=\"5\" Watchdog=\"20\" DisableUpdateOutputs=\"false\" InhibitTask=\"false\" Class=\"Safety\">
<ScheduledPrograms><ScheduledProgram Name=\"Safety_Main\"/></ScheduledPrograms></Task></Tasks>
</Controller></RSLogix5000Content>"
    )
}
