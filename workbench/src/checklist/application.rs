//! The list for the safety application program. 1756-RM093 Appendix D, page 93.

use twinrung_compiler::Severity;
use twinrung_compiler::diagnostic::ENCODED;
use twinrung_compiler::project::{TagClass, TagKind};
use twinrung_compiler::rules;
use twinrung_grammar::tree::{Class, FileForm};

use super::{Answer, Checklist, Evidence, Line, person};
use crate::usage::Index;

/// Fills in the list.
pub fn list(evidence: &Evidence<'_>, index: &Index) -> Checklist {
    let standard = [&rules::standard_tag::CODE, &rules::standard_write::CODE];
    let lines = vec![
        software(evidence),
        person(2, "the programming guidelines of chapter 6 were followed", findings(evidence)),
        evidence.decided(
            3,
            "the safety application holds relay ladder only",
            &[&rules::routine_language::CODE, &ENCODED],
            ladder(evidence),
        ),
        evidence.decided(
            4,
            "the safety application holds only instructions that are certified for it",
            &[&rules::uncertified::CODE, &rules::admission::CODE, &rules::expression_operator::CODE],
            instructions(evidence),
        ),
        person(5, "safety and standard tags are clearly told apart", tags(evidence)),
        evidence.decided(
            6,
            "safety routines use safety tags only",
            &standard,
            vec!["every operand of every safety rung resolves to a safety tag".to_owned()],
        ),
        evidence.decided(
            7,
            "safety routines neither read nor write standard tags",
            &standard,
            vec!["every operand of every safety rung resolves to a safety tag".to_owned()],
        ),
        evidence.decided(
            8,
            "no safety tag is an alias of a standard tag, and none the other way",
            &[&rules::alias_across_classes::CODE],
            vec!["every alias was followed to its end".to_owned()],
        ),
        outputs(evidence),
        mapped(evidence, index),
        person(11, "the process parameters that fault routines watch are defined", Vec::new()),
        add_ons(evidence),
        person(13, "an independent safety reviewer has reviewed the program, where that is required", Vec::new()),
        person(14, "the review is documented and signed", Vec::new()),
    ];
    Checklist { title: "safety application program", page: 93, subject: evidence.subject(), lines }
}

/// The first versions that program safety controllers are 14, and 16 and later; 18 and later for 1768 controllers.
fn software(evidence: &Evidence<'_>) -> Line {
    let requirement = "the programming software is version 14, or 16 or later (18 or later for 1768 controllers)";
    let shown = evidence.file.export.as_ref().and_then(|export| export.software_revision.as_ref());
    let major = shown.and_then(|text| text.as_str().split('.').next()?.trim().parse::<u32>().ok());
    let family = evidence.file.controller.as_ref().and_then(|one| one.processor_type.as_ref());
    let (Some(shown), Some(major), Some(family)) = (shown, major, family) else {
        return person(1, requirement, vec!["the file does not name the software".to_owned()]);
    };
    let compact = family.as_str().starts_with("1768");
    let fulfilled = if compact { major >= 18 } else { major == 14 || major >= 16 };
    let answer = if fulfilled { Answer::Yes } else { Answer::No };
    let evidence = vec![format!("the export was written by version {} for a {}", shown.as_str(), family.as_str())];
    Line { number: 1, requirement, answer, evidence }
}

fn findings(evidence: &Evidence<'_>) -> Vec<String> {
    let count =
        |severity| evidence.findings.iter().filter(|one| one.severity == severity && one.accepted.is_none()).count();
    let accepted = evidence.findings.iter().filter(|one| one.accepted.is_some()).count();
    vec![format!(
        "check gives {} errors, {} warnings, {accepted} suppressed",
        count(Severity::Error),
        count(Severity::Warning)
    )]
}

fn ladder(evidence: &Evidence<'_>) -> Vec<String> {
    let Some(project) = evidence.project else { return Vec::new() };
    let rungs: usize = project.routines.iter().map(|routine| routine.rungs.len()).sum();
    vec![format!("{} safety routines with {rungs} rungs, all of them ladder", project.routines.len())]
}

fn instructions(evidence: &Evidence<'_>) -> Vec<String> {
    let Some(project) = evidence.project else { return Vec::new() };
    let used: Vec<&str> = twinrung_catalog::instructions::ALL
        .iter()
        .filter(|one| project.opcodes.any(&[one.opcode]))
        .map(|one| one.mnemonic)
        .collect();
    let mut list = vec![format!("used: {}", used.join(", "))];
    list.extend(project.profile.as_ref().map(|profile| format!("all of them certified for {}", profile.display())));
    list
}

fn tags(evidence: &Evidence<'_>) -> Vec<String> {
    let Some(project) = evidence.project else { return Vec::new() };
    let count = |class| project.tags.iter().filter(|tag| tag.class == class).count();
    vec![format!(
        "{} safety tags, {} standard tags, {} safety tags take their value from a standard one",
        count(TagClass::Safety),
        count(TagClass::Standard),
        project.map.len()
    )]
}

fn outputs(evidence: &Evidence<'_>) -> Line {
    let requirement = "each safety output tag is configured and connected to a physical output";
    let unwritten = evidence.found(&[&rules::output_not_written::CODE]);
    if unwritten.is_empty() {
        return person(
            9,
            requirement,
            vec!["every output module is written; the connection is a person's to look at".to_owned()],
        );
    }
    Line { number: 9, requirement, answer: Answer::No, evidence: unwritten }
}

fn mapped(evidence: &Evidence<'_>, index: &Index) -> Line {
    let requirement = "the logic conditions every mapped tag";
    let Some(project) = evidence.project else {
        let found = evidence.found(&[&rules::unqualified_output::CODE, &rules::unqualified_operand::CODE]);
        return match found.is_empty() {
            true => person(10, requirement, vec![evidence.why_not_whole()]),
            false => Line { number: 10, requirement, answer: Answer::No, evidence: found },
        };
    };
    if project.map.is_empty() && evidence.is_whole() {
        return Line { number: 10, requirement, answer: Answer::Yes, evidence: vec!["no tag is mapped".to_owned()] };
    }
    let lines = project.map.iter().map(|line| {
        let places = index.of_tag(line.safety).read_places(project);
        format!("{} takes {}; read in {places}", project.tag(line.safety).image_name(), line.standard)
    });
    let mut lines: Vec<String> = lines.collect();
    // Where nothing is published, nothing that a mapped tag could control was looked at.
    let published = project
        .tags
        .iter()
        .any(|tag| tag.class == TagClass::Safety && matches!(tag.kind, TagKind::ModuleOutput(_) | TagKind::Produced));
    if published && evidence.is_whole() {
        lines.push("on every path to a safety output stands safety data beside it (S0701, S0702)".to_owned());
        return Line { number: 10, requirement, answer: Answer::Yes, evidence: lines };
    }
    person(10, requirement, lines)
}

/// The instruction signature is among the attributes of the export; that it was recorded, nobody can see there.
fn add_ons(evidence: &Evidence<'_>) -> Line {
    let requirement = "safety Add-On Instructions are sealed by an instruction signature, and it is recorded";
    let safety =
        |one: &&twinrung_grammar::tree::AddOnInstruction| one.class.is_some_and(|class| class.value == Class::Safety);
    let list: Vec<_> = evidence.file.add_on_instructions.iter().filter(safety).collect();
    if list.is_empty() {
        if evidence.is_whole() {
            let evidence = vec!["there is no safety Add-On Instruction".to_owned()];
            return Line { number: 12, requirement, answer: Answer::Yes, evidence };
        }
        return person(12, requirement, vec!["no safety Add-On Instruction is in this file".to_owned()]);
    }
    let sealed = |one: &twinrung_grammar::tree::AddOnInstruction| {
        let key = |name: &str| one.attributes.iter().find(|own| own.key.is(name)).and_then(|own| own.value.text());
        key("SignatureID").or_else(|| key("SafetySignatureID")).map(|text| text.text.to_string())
    };
    let lines = list.iter().map(|one| match sealed(one) {
        Some(signature) => format!("{}: signature {signature}", one.name),
        None => format!("{}: no signature in this file", one.name),
    });
    let lines: Vec<String> = lines.collect();
    // An export writes the signature of what is sealed; other text does not know any.
    if evidence.file.form == FileForm::Xml && list.iter().any(|one| sealed(one).is_none()) {
        return Line { number: 12, requirement, answer: Answer::No, evidence: lines };
    }
    person(12, requirement, lines)
}
