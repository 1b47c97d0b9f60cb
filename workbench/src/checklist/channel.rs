//! The lists for each safety input channel and each safety output channel. 1756-RM093 Appendix D, pages 91 and 92.

use twinrung_bytecode::image::TypeReference;
use twinrung_catalog::Element;
use twinrung_compiler::project::{Project, TagClass, TagId, TagKind};
use twinrung_compiler::rules::status_not_watched::watches_connection;
use twinrung_grammar::tree::{AttributeValue, Module, PointKind};

use super::{Answer, Checklist, Evidence, Line, person};
use crate::usage::{Cell, Index, Uses};

/// One point of a module's tag.
struct Channel<'a> {
    /// `Doors:I.Pt00Data`
    name: String,
    /// What uses the status of its connection, when the tag shows one.
    status: Option<Uses>,
    module: Option<&'a Module>,
    /// `I00`: as a MODULE declaration names the point.
    point: String,
    uses: Uses,
}

/// All channels of safety modules, inputs before outputs.
pub fn lists(evidence: &Evidence<'_>, index: &Index) -> Vec<Checklist> {
    let Some(project) = evidence.project else { return Vec::new() };
    let of = |output: bool| channels(evidence, project, index, output);
    let inputs = of(false).into_iter().map(|channel| input(evidence, project, &channel));
    let outputs = of(true).into_iter().map(|channel| output(evidence, project, &channel));
    inputs.chain(outputs).collect()
}

fn channels<'a>(evidence: &Evidence<'a>, project: &Project, used: &Index, outputs: bool) -> Vec<Channel<'a>> {
    let mut list = Vec::new();
    for (position, tag) in project.tags.iter().enumerate() {
        let module = match tag.kind {
            TagKind::ModuleInput(module) if !outputs => module,
            TagKind::ModuleOutput(module) if outputs => module,
            _ => continue,
        };
        let Some(TypeReference::Structure(index)) = tag.type_reference else { continue };
        if tag.class != TagClass::Safety {
            continue;
        }
        let declared = project.modules.get(module);
        let shown = evidence.file.modules.iter().find(|one| declared.is_some_and(|own| one.name.span == own.span));
        let id = TagId(position as u32);
        let record = project.types.record(index);
        // Name and use of each BOOL and each number of the tag.
        let members: Vec<(&str, Uses)> = record
            .members
            .iter()
            .zip(&project.types.layout(index).members)
            .filter_map(|(member, place)| {
                let cell = match member.type_reference {
                    TypeReference::Element(Element::Bool) => Cell::Bit(place.bit_cell),
                    TypeReference::Element(_) => Cell::Word(place.word_cell),
                    TypeReference::Structure(_) => return None,
                };
                Some((member.name.as_str(), used.of_cell(id, cell)))
            })
            .collect();
        let statuses = members.iter().filter(|(name, _)| watches_connection(name)).map(|(_, uses)| uses.clone());
        let status = statuses.reduce(|all, one| all.and(&one));
        for (member, uses) in members {
            let Some(number) = point_number(member) else { continue };
            list.push(Channel {
                name: format!("{}.{member}", tag.image_name()),
                status: status.clone(),
                module: shown,
                point: format!("{}{number}", if outputs { "O" } else { "I" }),
                uses,
            });
        }
    }
    list
}

/// `00` of `Pt00Data`, `0` of `Ch0Data`.
fn point_number(member: &str) -> Option<&str> {
    let rest = member.strip_prefix("Pt").or_else(|| member.strip_prefix("Ch"))?.strip_suffix("Data")?;
    (!rest.is_empty() && rest.bytes().all(|byte| byte.is_ascii_digit())).then_some(rest)
}

fn input(evidence: &Evidence<'_>, project: &Project, channel: &Channel<'_>) -> Checklist {
    let lines = vec![
        person(1, "the module is installed as its instructions and the standards that apply ask for", Vec::new()),
        person(2, "functional verification tests of the system and the modules were done", Vec::new()),
        in_sequence(project, channel),
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
fn in_sequence(project: &Project, channel: &Channel<'_>) -> Line {
    let requirement = "control, diagnostics and alarming follow each other in the application logic";
    let used = format!("the logic uses the channel: {}", channel.uses.read_places(project));
    match &channel.status {
        Some(status) if status.is_unread() && !channel.uses.is_unread() => Line {
            number: 3,
            requirement,
            answer: Answer::No,
            evidence: vec![
                used,
                "no logic reads ConnectionFaulted, RunMode or another status of its connection".to_owned(),
            ],
        },
        Some(status) => {
            let watched = format!("the logic reads the connection's status: {}", status.read_places(project));
            person(3, requirement, vec![used, watched])
        }
        None => person(3, requirement, vec![used, "its connection shows no status".to_owned()]),
    }
}

fn output(evidence: &Evidence<'_>, project: &Project, channel: &Channel<'_>) -> Checklist {
    let writers = format!("the logic writes the channel: {}", channel.uses.written_places(project));
    let lines = vec![
        person(1, "the module is installed as its instructions and the standards that apply ask for", Vec::new()),
        person(2, "functional verification tests of the modules were done", Vec::new()),
        person(
            3,
            "the configuration was read back from the module and compared with the one that was sent",
            settings(channel),
        ),
        person(4, "no test output serves as a safety output", vec![writers]),
        person(5, "the wiring is that of PLe/Cat. 4 after ISO 13849-1", wiring(channel)),
        person(6, "output and actuator suit each other electrically", Vec::new()),
    ];
    let subject = format!("{}, {}", evidence.subject(), channel.name);
    Checklist { title: "safety output channel", page: 92, subject, lines }
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
