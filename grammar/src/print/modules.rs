//! `MODULE`.

use super::attributes::List;
use super::layout::Layout;
use super::value::{print_data, print_value};
use crate::tree::{Connection, Module, ModuleTag, PointKind};

pub(super) fn module(layout: &mut Layout, module: &Module) {
    let mut list = List::default();
    list.text("Description", module.description.as_deref());
    list.text("CatalogNumber", module.catalog_number.as_ref());
    list.number("Vendor", module.vendor);
    list.number("ProductType", module.product_type);
    list.number("ProductCode", module.product_code);
    list.number("Major", module.major);
    list.number("Minor", module.minor);
    list.text(
        "Parent",
        module.parent.as_ref().map(|name| crate::tree::Text::new(name.text.clone(), name.span)).as_ref(),
    );
    list.number("ParentModPortId", module.parent_port);
    list.number("Slot", module.slot);
    list.text("IPAddress", module.address.as_ref());
    list.word("SafetyNetwork", module.network_number().map(|text| text.text.as_str()));
    list.flag("SafetyEnabled", module.safety_enabled);
    list.flag("Inhibited", module.inhibited);
    list.milliseconds("RPI", module.rpi_us);
    list.name("Keying", module.electronic_key.as_ref());
    list.rest(&module.attributes);
    let head = format!("MODULE {}", module.name);
    layout.block(&module.trivia, &head, &list.items, "END_MODULE", |layout| {
        for point in &module.points {
            let word = match point.kind {
                PointKind::Point => "POINT",
                PointKind::Test => "TEST",
            };
            let mut list = List::default();
            list.rest(&point.attributes);
            layout.declaration(&point.trivia, &format!("{word} {}", point.name), &list.items, ";");
        }
        for opaque in &module.opaque {
            match print_value(&opaque.value) {
                // A block of XML is not a quoted text.
                Some(text) if text.starts_with("'[[[___") => {
                    layout.line(&format!("{} := {};", opaque.kind, text.trim_matches('\'')));
                }
                Some(text) => layout.line(&format!("{} := {text};", opaque.kind)),
                None => {}
            }
        }
        for connection in &module.connections {
            self::connection(layout, connection);
        }
    });
}

fn connection(layout: &mut Layout, connection: &Connection) {
    let mut list = List::default();
    list.microseconds("Rate", connection.rpi_us);
    list.word("Type", connection.connection_type.as_ref().map(|text| text.text.as_str()));
    list.number("TimeoutMultiplier", connection.timeout_multiplier);
    list.number("NetworkDelayMultiplier", connection.network_delay_multiplier);
    list.milliseconds("ReactionTimeLimit", connection.reaction_time_limit_us);
    list.flag("Unicast", connection.unicast);
    list.rest(&connection.attributes);
    let head = format!("CONNECTION {}", connection.name);
    layout.block(&connection.trivia, &head, &list.items, "END_CONNECTION", |layout| {
        module_tag(layout, connection.input.as_deref(), "InputData", "InputForceData");
        module_tag(layout, connection.output.as_deref(), "OutputData", "OutputForceData");
    });
}

fn module_tag(layout: &mut Layout, tag: Option<&ModuleTag>, data: &str, forces: &str) {
    let Some(tag) = tag else { return };
    if let Some(text) = print_data(&tag.data) {
        layout.line(&format!("{data} := {text};"));
    }
    if let Some(text) = print_data(&tag.forces) {
        layout.line(&format!("{forces} := {text};"));
    }
}
