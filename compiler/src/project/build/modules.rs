//! Modules: which of them carry safety data, and their canonical declaration.

use std::fmt::Write;

use twinrung_catalog::modules;
use twinrung_grammar::tree::{self, Value};

use super::Inputs;
use crate::diagnostic::{DUPLICATE_NAME, Finding, Findings};
use crate::names::{Map, fold};
use crate::project::{Module, Point, Setting};

/// Electronic keying where a file says nothing of it, as exports are written.
const KEYING_WITHOUT_WORDS: &str = "CompatibleModule";

/// The modules of the files, each once.
pub(super) fn build<'a>(inputs: &Inputs<'a>, findings: &mut Findings) -> Vec<(&'a tree::Module, Module)> {
    let mut list: Vec<(&tree::Module, Module)> = Vec::new();
    let mut seen: Map<tree::CompactString, usize> = Map::default();
    for (file, context) in inputs.files() {
        for shown in &file.modules {
            if shown.usage == tree::Usage::Reference || shown.name.as_str().is_empty() {
                continue;
            }
            if let Some(first) = seen.get(&fold(shown.name.as_str())) {
                if !context {
                    let message = format!("the module `{}` is declared twice", shown.name);
                    let finding = Finding::new(&DUPLICATE_NAME, shown.name.span, message)
                        .label(list[*first].1.span, "first declared here")
                        .help("rename one of the two");
                    findings.push(finding);
                }
                continue;
            }
            seen.insert(fold(shown.name.as_str()), list.len());
            let catalog_number = shown.catalog_number.as_ref().map(|text| text.text.clone()).unwrap_or_default();
            let module = Module {
                name: shown.name.text.clone(),
                span: shown.name.span,
                safety: carries_safety(shown, &catalog_number),
                catalog_number,
                parent: shown.parent.as_ref().map(|name| name.text.clone()).unwrap_or_default(),
                slot: shown.slot.map(|slot| slot.value),
                safety_network: shown.network_number().map(|text| (text.text.clone(), text.span)),
                text: canonical(shown),
                points: points(shown),
                shown: Box::new(tree::Module { opaque: Vec::new(), configuration: None, ..shown.clone() }),
            };
            list.push((shown, module));
        }
    }
    list
}

fn points(shown: &tree::Module) -> Vec<Point> {
    let settings = |point: &tree::Point| {
        let of = |attribute: &tree::Attribute| {
            let value = attribute.value.text()?;
            Some(Setting {
                key: attribute.key.text.clone(),
                key_span: attribute.key.span,
                value: value.as_str().trim().into(),
                value_span: value.span,
            })
        };
        point.attributes.iter().filter_map(of).collect::<Vec<_>>()
    };
    let of = |point: &tree::Point| {
        let settings = settings(point);
        let sil = settings.iter().find(|one| one.key.eq_ignore_ascii_case("SIL"));
        Point {
            kind: point.kind,
            name: point.name.text.to_ascii_uppercase(),
            span: point.name.span,
            sil: sil.and_then(|one| one.value.parse().ok()),
            settings,
        }
    };
    shown.points.iter().map(of).collect()
}

/// Whether a module carries safety data (neutral-text-and-l5x.md D.3). The controller and its partner do not.
fn carries_safety(shown: &tree::Module, catalog_number: &str) -> bool {
    shown.safety_enabled.is_some_and(|enabled| enabled.value)
        || modules::Module::by_catalog_number(catalog_number).is_some()
        || shown.connections.iter().any(|connection| {
            let kind = connection.connection_type.as_ref();
            kind.is_some_and(|kind| kind.as_str().to_ascii_lowercase().starts_with("safety"))
        })
}

/// The declaration without comments, in one form for every kind of file; what the maker does not disclose goes in as
/// the bytes that stand in the file.
fn canonical(shown: &tree::Module) -> String {
    let mut text = String::new();
    let mut line = |key: &str, value: Option<String>| {
        if let Some(value) = value {
            // A line of its own, whatever a quoted text holds.
            let value = value.replace('\\', "\\\\").replace('\n', "\\n");
            let _ = writeln!(text, "{key} := {value}");
        }
    };
    line("MODULE", Some(shown.name.text.to_string()));
    let catalog =
        shown.catalog_number.as_ref().map(|number| modules::without_series(number.as_str()).to_ascii_uppercase());
    line("CatalogNumber", catalog);
    let identity = [
        ("Vendor", shown.vendor),
        ("ProductType", shown.product_type),
        ("ProductCode", shown.product_code),
        ("Major", shown.major),
        ("Minor", shown.minor),
    ];
    for (key, number) in identity {
        line(key, number.map(|number| number.value.to_string()));
    }
    let keying = shown.electronic_key.as_ref().map_or(KEYING_WITHOUT_WORDS, |key| key.text.as_str());
    line("Keying", Some(keying.to_ascii_uppercase()));
    line("Parent", shown.parent.as_ref().map(|name| name.text.to_string()));
    line("Slot", shown.slot.map(|slot| slot.value.to_string()));
    line("Address", shown.address.as_ref().map(|text| text.as_str().to_owned()));
    line("SafetyNetwork", shown.network_number().map(|text| text.as_str().to_ascii_lowercase()));
    line("Inhibited", shown.inhibited.filter(|inhibited| inhibited.value).map(|_| "Yes".to_owned()));
    line("RPI_us", shown.rpi_us.map(|rpi| rpi.value.to_string()));
    for key in ["InputStatus", "OutputData"] {
        let attribute = shown.attributes.iter().find(|attribute| attribute.key.is(key));
        line(key, attribute.and_then(|one| one.value.text()).map(|text| text.as_str().trim().to_ascii_uppercase()));
    }
    for point in &shown.points {
        let mut settings: Vec<String> = point
            .attributes
            .iter()
            .map(|attribute| {
                let value = attribute.value.text().map_or_else(String::new, |text| text.as_str().to_ascii_uppercase());
                format!("{}={value}", attribute.key.text.to_ascii_uppercase())
            })
            .collect();
        settings.sort();
        line("Point", Some(format!("{} {}", point.name.text.to_ascii_uppercase(), settings.join(" "))));
    }
    for connection in &shown.connections {
        let number = |value: Option<String>| value.unwrap_or_else(|| "-".to_owned());
        let kind = connection.connection_type.as_ref().map_or("-", |kind| kind.as_str());
        line(
            "Connection",
            Some(format!(
                "{} {kind} rpi_us {} timeout {} delay {} limit_us {}",
                connection.name,
                number(connection.rpi_us.map(|one| one.value.to_string())),
                number(connection.timeout_multiplier.map(|one| one.value.to_string())),
                number(connection.network_delay_multiplier.map(|one| one.value.to_string())),
                number(connection.reaction_time_limit_us.map(|one| one.value.to_string())),
            )),
        );
    }
    for opaque in &shown.opaque {
        if !opaque.kind.is("ExtendedProperties") {
            let mut bytes = String::new();
            flatten(&opaque.value, &mut bytes);
            line(opaque.kind.as_str(), Some(bytes));
        }
    }
    text
}

/// The numbers of an opaque value in their order, texts with their length. The grammar bounds the depth.
fn flatten(value: &Value, out: &mut String) {
    match value {
        Value::Number(text) | Value::String(text) => {
            let _ = write!(out, "{}:{},", text.as_str().len(), text.as_str());
        }
        Value::List { items, .. } => items.iter().for_each(|item| flatten(item, out)),
        Value::Structure { members, .. } => members.iter().for_each(|member| flatten(&member.value, out)),
        Value::Array { elements, .. } => elements.iter().for_each(|(_, item)| flatten(item, out)),
        Value::Bytes { bytes, .. } => bytes.iter().for_each(|byte| {
            let _ = write!(out, "{byte:02x}");
        }),
    }
}
