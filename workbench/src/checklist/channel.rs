//! The lists for each safety input channel and each safety output channel. 1756-RM093 Appendix D, pages 91 and 92.

use twinrung_compiler::project::{Project, TagClass, TagId, TagKind};
use twinrung_compiler::rules;
use twinrung_grammar::tree::{AttributeValue, Module, PointKind};

use super::usage::{Sought, Uses, uses};
use super::{Answer, Checklist, Evidence, Line, person};

/// One point of a module's tag.
struct Channel<'a> {
    /// `Doors:I.Pt00Data`
    name: String,
    /// Where the status of its connection is read, when the tag shows one.
    watched: Option<Vec<String>>,
    module: Option<&'a Module>,
    /// `I00`: as a MODULE declaration names the point.
    point: String,
    uses: Uses,
}

/// All channels of safety modules, inputs before outputs.
pub fn lists(evidence: &Evidence<'_>) -> Vec<Checklist> {
    let Some(project) = evidence.project else { return Vec::new() };
    let of = |output: bool| channels(evidence, project, output);
    let inputs = of(false).into_iter().map(|channel| input(evidence, &channel));
    let outputs = of(true).into_iter().map(|channel| output(evidence, &channel));
    inputs.chain(outputs).collect()
}

fn channels<'a>(evidence: &Evidence<'a>, project: &Project, outputs: bool) -> Vec<Channel<'a>> {
    let mut list = Vec::new();
    for (position, tag) in project.tags.iter().enumerate() {
        let module = match tag.kind {
            TagKind::ModuleInput(module) if !outputs => module,
            TagKind::ModuleOutput(module) if outputs => module,
            _ => continue,
        };
        let Some(twinrung_bytecode::image::TypeReference::Structure(index)) = tag.type_reference else { continue };
        if tag.class != TagClass::Safety {
            continue;
        }
        let declared = project.modules.get(module);
        let shown = evidence.file.modules.iter().find(|one| declared.is_some_and(|own| one.name.span == own.span));
        let id = TagId(position as u32);
        let record = project.types.record(index);
        let places = &project.types.layout(index).members;
        let use_of = |name: &str| {
            let at = record.members.iter().position(|member| member.name.eq_ignore_ascii_case(name))?;
            let cell = Some((places[at].bit_cell, places[at].word_cell, record.members[at].type_reference));
            Some(uses(project, Sought { tag: id, cell }))
        };
        let statuses: Vec<Uses> =
            record.members.iter().filter(|one| is_status(&one.name)).filter_map(|one| use_of(&one.name)).collect();
        let watched = (!statuses.is_empty()).then(|| {
            let mut rungs: Vec<String> = statuses.into_iter().flat_map(|one| one.read).collect();
            rungs.sort();
            rungs.dedup();
            rungs
        });
        for member in record.members.iter().filter(|member| point_number(&member.name).is_some()) {
            let number = point_number(&member.name).unwrap_or_default();
            list.push(Channel {
                name: format!("{}.{}", tag.image_name(), member.name),
                watched: watched.clone(),
                module: shown,
                point: format!("{}{number}", if outputs { "O" } else { "I" }),
                uses: use_of(&member.name).unwrap_or_default(),
            });
        }
    }
    list
}

/// What tells whether the connection and the points are sound, as rule W0105 takes it.
fn is_status(member: &str) -> bool {
    let name = member.to_ascii_lowercase();
    name == "connectionfaulted" || name == "runmode" || name.ends_with("status")
}

/// `00` of `Pt00Data`, `0` of `Ch0Data`.
fn point_number(member: &str) -> Option<&str> {
    let rest = member.strip_prefix("Pt").or_else(|| member.strip_prefix("Ch"))?.strip_suffix("Data")?;
    (!rest.is_empty() && rest.bytes().all(|byte| byte.is_ascii_digit())).then_some(rest)
}

fn input(evidence: &Evidence<'_>, channel: &Channel<'_>) -> Checklist {
    let lines = vec![
        person(1, "the module is installed as its instructions and the standards that apply ask for", Vec::new()),
        person(2, "functional verification tests of the system and the modules were done", Vec::new()),
        in_sequence(channel),
        person(
            4,
            "the configuration was read back from the module and compared with the one that was sent",
            settings(channel),
        ),
        person(5, "the wiring is that of PLe/Cat. 4 after ISO 13849-1", wiring(channel)),
        person(6, "sensor and input suit each other electrically", Vec::new()),
    ];
    let subject = format!("{}, {}", evidence.subject(), channel.name);
    Checklist { title: "safety input channel", page: 91, subject, lines }
}

/// Diagnostics without a look at the connection are not performed at all.
fn in_sequence(channel: &Channel<'_>) -> Line {
    let requirement = "control, diagnostics and alarming follow each other in the application logic";
    let used = at("the logic uses the channel", &channel.uses.read);
    match &channel.watched {
        Some(watched) if watched.is_empty() && !channel.uses.read.is_empty() => Line {
            number: 3,
            requirement,
            answer: Answer::No,
            evidence: vec![
                used,
                "no logic reads ConnectionFaulted, RunMode or another status of its connection".to_owned(),
            ],
        },
        Some(watched) => person(3, requirement, vec![used, at("the logic reads the connection's status", watched)]),
        None => person(3, requirement, vec![used, "its connection shows no status".to_owned()]),
    }
}

fn output(evidence: &Evidence<'_>, channel: &Channel<'_>) -> Checklist {
    let unwritten = evidence.found(&[&rules::output_not_written::CODE]);
    let writers = at("the logic writes the channel", &channel.uses.acted_on);
    let not_written = channel.uses.acted_on.is_empty() && !unwritten.is_empty();
    let lines = vec![
        person(1, "the module is installed as its instructions and the standards that apply ask for", Vec::new()),
        person(2, "functional verification tests of the modules were done", Vec::new()),
        person(
            3,
            "the configuration was read back from the module and compared with the one that was sent",
            settings(channel),
        ),
        person(4, "no test output serves as a safety output", {
            let mut evidence = vec![writers];
            evidence.extend(not_written.then(|| "this output is not written at all".to_owned()));
            evidence
        }),
        person(5, "the wiring is that of PLe/Cat. 4 after ISO 13849-1", wiring(channel)),
        person(6, "output and actuator suit each other electrically", Vec::new()),
    ];
    let subject = format!("{}, {}", evidence.subject(), channel.name);
    Checklist { title: "safety output channel", page: 92, subject, lines }
}

fn at(what: &str, places: &[String]) -> String {
    if places.is_empty() { format!("{what}: nowhere") } else { format!("{what}: {}", places.join(", ")) }
}

/// The settings of the point, as far as the file shows them.
fn settings(channel: &Channel<'_>) -> Vec<String> {
    let Some(module) = channel.module else { return vec!["the module is not declared in this file".to_owned()] };
    let point = module.points.iter().find(|one| one.kind == PointKind::Point && one.name.is(&channel.point));
    match point {
        Some(point) => {
            let settings = point.attributes.iter().map(|one| format!("{} := {}", one.key.text, value(&one.value)));
            vec![format!("{} {}: {}", module.name, point.name, settings.collect::<Vec<_>>().join(", "))]
        }
        None if !module.opaque.is_empty() => vec!["the configuration is not visible in this export".to_owned()],
        None => vec![format!("{} {}: no setting is declared", module.name, channel.point)],
    }
}

fn wiring(channel: &Channel<'_>) -> Vec<String> {
    let Some(module) = channel.module else { return Vec::new() };
    let point = module.points.iter().find(|one| one.kind == PointKind::Point && one.name.is(&channel.point));
    let Some(point) = point else { return Vec::new() };
    let of = |key: &str| point.attributes.iter().find(|one| one.key.is(key)).map(|one| value(&one.value));
    let mut list = Vec::new();
    list.extend(of("TestSource").map(|source| format!("declared to be supplied by test output {source}")));
    list.extend(of("Channel").map(|kind| format!("declared as {kind} channel")));
    list
}

fn value(value: &AttributeValue) -> String {
    value.text().map_or_else(|| "a list".to_owned(), |text| text.text.to_string())
}
