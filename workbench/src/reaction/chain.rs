//! Chains, and what each part of one adds.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt;

use serde::Serialize;
use twinrung_bytecode::image::TypeReference;
use twinrung_catalog::failure::Use;
use twinrung_catalog::{Element as ElementType, reaction};
use twinrung_compiler::CheckedProject;
use twinrung_compiler::project::{Module, Project, TagClass, TagId, TagKind};

use super::connection::Connection;
use super::dependence::{Data, Dependence};
use super::failure::{self, Element, Loop};
use super::milliseconds;
use crate::usage::Cell;

/// What the project cannot say.
#[derive(Debug, Clone, Default)]
pub struct Settings {
    /// Reaction time of the sensor, µs.
    pub sensor_us: u64,
    /// Reaction time of the actuator, µs.
    pub actuator_us: u64,
    /// Years between proof tests.
    pub proof_test_years: u32,
    /// Reaction times of modules by catalogue number, µs: they count before those of the catalog.
    pub modules_us: Vec<(String, u64)>,
}

/// Why the chains cannot be added up.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum ReactionError {
    /// The project has no safety task with period and watchdog.
    NoTask(String),
    /// Several of the other projects produce a consumed tag, and none has the name of its producer.
    Ambiguous(String),
}

impl fmt::Display for ReactionError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            ReactionError::NoTask(name) => {
                write!(
                    f,
                    "{name} has no safety task with a period and a watchdog: name them with --period and --watchdog"
                )
            }
            ReactionError::Ambiguous(tag) => {
                write!(
                    f,
                    "several projects produce `{tag}`, and none has the name of its producer: give only the one that does"
                )
            }
        }
    }
}

impl std::error::Error for ReactionError {}

/// One part of a chain.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Component {
    /// What takes the time.
    pub name: String,
    /// How long at most, µs; nothing where no source tells it.
    pub us: Option<u64>,
    /// From what it follows.
    pub because: String,
}

/// A chain: all inputs of one module with the same filter that reach outputs of one module.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Chain {
    /// `Doors:I.Pt00Data`, ...
    pub inputs: Vec<String>,
    /// `Drives:O.Pt00Data`, ...
    pub outputs: Vec<String>,
    /// From the sensor to the actuator.
    pub components: Vec<Component>,
    /// From terminal to terminal, µs: without sensor and actuator.
    pub logix_us: Option<u64>,
    /// From event to safe state, µs.
    pub system_us: Option<u64>,
    /// What its logic element contributes to the probability of failure.
    pub failure: Loop,
}

/// The front of a chain, up to data that a safety task reads; and what its elements may fail with.
#[derive(Debug, Clone, PartialEq)]
struct Front {
    components: Vec<Component>,
    elements: Vec<Element>,
}

/// Chains that share a front: the names of their inputs.
type Fronts = Vec<(Front, BTreeSet<String>)>;

/// Every chain of a project, the slowest first. A tag that it consumes is followed into the one of `producers` that
/// produces it (one step, as Figure 21); without one the chain begins at the consumed tag, and its time is not known.
pub fn chains(
    project: &CheckedProject,
    producers: &[&CheckedProject],
    settings: &Settings,
) -> Result<Vec<Chain>, ReactionError> {
    let (period_us, task) = task(project)?;
    let dependence = Dependence::new(project);
    let mut list = Vec::new();
    for (module, points) in output_modules(project) {
        let mut fronts: BTreeMap<String, (Front, BTreeSet<String>, BTreeSet<String>)> = BTreeMap::new();
        for (data, point) in &points {
            for (front, inputs) in fronts_of(project, producers, settings, &dependence, *data)? {
                let key = format!("{:?}", front.components);
                let entry = fronts.entry(key).or_insert_with(|| (front, BTreeSet::new(), BTreeSet::new()));
                entry.1.extend(inputs);
                entry.2.insert(point.clone());
            }
        }
        let connection = Connection::of_outputs(&module.shown, period_us);
        for (front, inputs, outputs) in fronts.into_values() {
            let mut components = vec![component("sensor", Some(settings.sensor_us), "--sensor")];
            components.extend(front.components);
            components.push(task.clone());
            components.push(component("output connection", Some(connection.limit_us()), &connection.to_string()));
            components.push(of_module(settings, module, false));
            components.push(component("actuator", Some(settings.actuator_us), "--actuator"));
            let years = settings.proof_test_years;
            let mut elements = front.elements;
            elements.push(failure::controller(project, years));
            elements.push(failure::module(&module.catalog_number, used(module, &outputs), years));
            list.push(Chain::new(inputs, outputs, components, Loop::new(elements, years)));
        }
    }
    list.sort_by_key(|chain| (std::cmp::Reverse(chain.system_us.unwrap_or(u64::MAX)), chain.inputs.clone()));
    Ok(list)
}

impl Chain {
    fn new(inputs: BTreeSet<String>, outputs: BTreeSet<String>, components: Vec<Component>, failure: Loop) -> Chain {
        let sum = |parts: &[Component]| parts.iter().map(|part| part.us).sum::<Option<u64>>();
        let inner = components.get(1..components.len().saturating_sub(1)).unwrap_or_default();
        Chain {
            logix_us: sum(inner),
            system_us: sum(&components),
            inputs: inputs.into_iter().collect(),
            outputs: outputs.into_iter().collect(),
            components,
            failure,
        }
    }
}

fn component(name: &str, us: Option<u64>, because: &str) -> Component {
    Component { name: name.to_owned(), us, because: because.to_owned() }
}

/// The period, and what the safety task adds.
fn task(project: &Project) -> Result<(u64, Component), ReactionError> {
    let times = project
        .safety_task
        .and_then(|position| project.tasks.get(position))
        .and_then(|task| Some((task.period_us?.0, task.watchdog_us?.0)));
    let Some((period, watchdog)) = times else { return Err(ReactionError::NoTask(project.name.to_string())) };
    let because = format!("{} ms of period and {} ms of watchdog", milliseconds(period), milliseconds(watchdog));
    let name = format!("safety task of {}", project.name);
    Ok((period, component(&name, Some(period.saturating_add(watchdog)), &because)))
}

/// The reaction time of a module without its filters.
fn of_module(settings: &Settings, module: &Module, input: bool) -> Component {
    let number = &module.catalog_number;
    let name = format!("{} module {} {number}", if input { "input" } else { "output" }, module.name);
    let plain = twinrung_catalog::modules::without_series;
    let given = settings.modules_us.iter().find(|(own, _)| plain(own).eq_ignore_ascii_case(plain(number)));
    if let Some((own, us)) = given {
        return component(&name, Some(*us), &format!("--module {own}"));
    }
    let known = reaction::of_module(number).and_then(|one| if input { one.input_us } else { one.output_us });
    match known {
        Some(us) => component(&name, Some(us), "1734-UM013 Appendix C"),
        None => component(&name, None, &format!("not in the sources of this project: --module {number}=MS gives it")),
    }
}

/// Every safety output point, by its module.
fn output_modules(project: &Project) -> Vec<(&Module, Vec<(Data, String)>)> {
    let tags = project.tags.iter().enumerate().filter(|(_, tag)| tag.class == TagClass::Safety);
    tags.filter_map(|(position, tag)| match tag.kind {
        TagKind::ModuleOutput(module) => Some((project.modules.get(module)?, points(project, TagId(position as u32)))),
        _ => None,
    })
    .collect()
}

/// The data points of a module's tag.
fn points(project: &Project, id: TagId) -> Vec<(Data, String)> {
    let tag = project.tag(id);
    let Some(TypeReference::Structure(index)) = tag.type_reference else { return Vec::new() };
    let layout = &project.types.layout(index).members;
    let members = project.types.record(index).members.iter().zip(layout);
    members
        .filter(|(member, _)| is_data(&member.name))
        .filter_map(|(member, place)| {
            let cell = match member.type_reference {
                TypeReference::Element(ElementType::Bool) => Cell::Bit(place.bit_cell),
                TypeReference::Element(_) => Cell::Word(place.word_cell),
                TypeReference::Structure(_) => return None,
            };
            Some(((id, Some(cell)), format!("{}.{}", tag.image_name(), member.name)))
        })
        .collect()
}

/// `Pt00Data`, `Ch0Data`: what a sensor or an actuator is wired to.
fn is_data(member: &str) -> bool {
    let number =
        member.strip_prefix("Pt").or_else(|| member.strip_prefix("Ch")).and_then(|rest| rest.strip_suffix("Data"));
    number.is_some_and(|number| !number.is_empty() && number.bytes().all(|byte| byte.is_ascii_digit()))
}

/// Whether every one of these points of a module is used in a pair.
fn used(module: &Module, points: &BTreeSet<String>) -> Use {
    let dual = |point: &String| {
        let member = point.rsplit('.').next().unwrap_or_default();
        let number = member.get(2..4).and_then(|digits| digits.parse().ok());
        module.is_dual(member)
            || number.is_some_and(|number: u32| {
                [number, number ^ 1].into_iter().any(|one| module.point('O', one).is_some_and(|point| point.is_dual()))
            })
    };
    if points.iter().all(dual) { Use::Dual } else { Use::Single }
}

/// The fronts through which inputs reach `data`.
fn fronts_of(
    project: &CheckedProject,
    producers: &[&CheckedProject],
    settings: &Settings,
    dependence: &Dependence<'_>,
    data: Data,
) -> Result<Fronts, ReactionError> {
    let mut fronts = Fronts::new();
    for source in dependence.sources(data) {
        match project.tag(source.0).kind {
            TagKind::ModuleInput(module) => {
                let Some(module) = project.modules.get(module) else { continue };
                let reached = points(project, source.0);
                let reached = reached.into_iter().filter(|(point, _)| source.1.is_none() || *point == source);
                for (_, name) in reached {
                    let front = of_input(settings, module, &name);
                    add(&mut fronts, front, BTreeSet::from([name]));
                }
            }
            TagKind::Consumed => {
                for (front, names) in of_consumed(project, producers, settings, source.0)? {
                    add(&mut fronts, front, names);
                }
            }
            _ => {}
        }
    }
    Ok(fronts)
}

fn add(fronts: &mut Fronts, front: Front, names: BTreeSet<String>) {
    match fronts.iter_mut().find(|(own, _)| *own == front) {
        Some((_, own)) => own.extend(names),
        None => fronts.push((front, names)),
    }
}

/// Module, filter and connection of an input point.
fn of_input(settings: &Settings, module: &Module, name: &str) -> Front {
    let member = name.rsplit('.').next().unwrap_or_default();
    let filter = |key: &str| -> u64 {
        let text = module.point_of(member).and_then(|point| point.setting(key)).map(|setting| setting.value.clone());
        text.and_then(|text| text.parse::<u64>().ok()).unwrap_or(0)
    };
    // A demand can be either edge: which one is known to the wiring alone.
    let (rising, falling) = (filter("OffOn"), filter("OnOff"));
    let visible = module.shown.opaque.is_empty() || !module.points.is_empty();
    let filter = if visible {
        let because = format!("the longer of OffOn {rising} ms and OnOff {falling} ms");
        component("input filter", Some(rising.max(falling).saturating_mul(1000)), &because)
    } else {
        component(
            "input filter",
            None,
            "not visible in this export: declare the points in a .rll, or read them off the module",
        )
    };
    let connection = Connection::of_inputs(&module.shown);
    Front {
        components: vec![
            of_module(settings, module, true),
            filter,
            component("input connection", Some(connection.limit_us()), &connection.to_string()),
        ],
        elements: vec![failure::module(
            &module.catalog_number,
            used(module, &BTreeSet::from([name.to_owned()])),
            settings.proof_test_years,
        )],
    }
}

/// What lies before a consumed tag: the chain to the tag that its producer sends, and the connection between the two.
fn of_consumed(
    project: &CheckedProject,
    producers: &[&CheckedProject],
    settings: &Settings,
    consumed: TagId,
) -> Result<Fronts, ReactionError> {
    let tag = project.tag(consumed);
    let info = tag.connection.as_deref();
    let connection = Connection::of_consumed(info);
    let travel =
        component(&format!("connection of {}", tag.name), Some(connection.limit_us()), &connection.to_string());
    let remote = info.and_then(|info| info.remote_tag.as_ref()).map_or(tag.name.as_str(), |text| text.text.as_str());
    let produced_by = |producer: &CheckedProject| {
        producer
            .tags
            .iter()
            .position(|own| matches!(own.kind, TagKind::Produced) && own.name.eq_ignore_ascii_case(remote))
    };
    let named = info.and_then(|info| info.producer.as_ref()).map(|name| name.text.to_string()).unwrap_or_default();
    let candidates: Vec<(&CheckedProject, TagId)> =
        producers.iter().filter_map(|producer| Some((*producer, TagId(produced_by(producer)? as u32)))).collect();
    let by_name = candidates.iter().find(|(producer, _)| producer.name.eq_ignore_ascii_case(&named));
    let (producer, produced) = match (by_name, candidates.as_slice()) {
        (Some(found), _) => *found,
        (None, [only]) => *only,
        (None, []) => {
            let unknown = component("producer", None, &format!("`{remote}` of {named}: --producer FILE gives it"));
            let front = Front { components: vec![unknown, travel], elements: Vec::new() };
            return Ok(vec![(front, BTreeSet::from([tag.name.to_string()]))]);
        }
        (None, _) => return Err(ReactionError::Ambiguous(remote.to_owned())),
    };
    let (_, task) = task(producer)?;
    let dependence = Dependence::new(producer);
    let mut fronts = fronts_of(producer, &[], settings, &dependence, (produced, None))?;
    for (front, names) in &mut fronts {
        front.components.extend([task.clone(), travel.clone()]);
        front.elements.push(failure::controller(producer, settings.proof_test_years));
        *names = names.iter().map(|name| format!("{}: {name}", producer.name)).collect();
    }
    Ok(fronts)
}
