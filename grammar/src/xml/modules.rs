//! `<Module>`, with its ports, connections and what nobody can read.

use super::cursor::Element;
use super::{Reader, adopt, usage};
use crate::components;
use crate::tree::{
    Connection, Data, Module, ModuleTag, Name, OpaqueData, Point, PointKind, Port, Spanned, Text, Trivia, Usage, Value,
};

impl<'a> Reader<'a> {
    pub(super) fn module(&mut self, element: &Element<'a>, around: Usage) {
        let fields = element.fields(&["Name", "Use"], &mut self.xml.errors);
        let mut module = components::module(element.name_of("Name"), fields, element.span);
        module.usage = usage(element, around);
        while let Some(child) = self.xml.child() {
            match child.name {
                "Description" => module.description = self.description(),
                "EKey" => {
                    module.electronic_key = child.optional_name("State");
                    self.xml.skip();
                }
                "Ports" => {
                    while let Some(port) = self.xml.child() {
                        let port = self.port(&port);
                        module.ports.push(port);
                    }
                }
                "Communications" => {
                    adopt(&mut module.attributes, &child, &[]);
                    self.communications(&mut module);
                }
                "ExtendedProperties" => self.extended_properties(&mut module),
                _ => self.xml.skip(),
            }
        }
        place(&mut module);
        self.file.modules.push(module);
    }

    /// What an export cannot show of a module's points it may carry as `<public><Twinrung RPI="10"><POINT Name="I00" .../>`:
    /// extended properties are free-form, and other tools pass them on unread.
    fn extended_properties(&mut self, module: &mut Module) {
        while let Some(visibility) = self.xml.child() {
            if visibility.name != "public" {
                self.xml.skip();
                continue;
            }
            while let Some(property) = self.xml.child() {
                if property.name != "Twinrung" {
                    self.xml.skip();
                    continue;
                }
                let mut fields = property.fields(&[], &mut self.xml.errors);
                module.rpi_us = fields.milliseconds(&["RPI"]).or(module.rpi_us);
                module.attributes.extend(fields.rest());
                while let Some(entry) = self.xml.child() {
                    let kind = match entry.name {
                        "POINT" => Some(PointKind::Point),
                        "TEST" => Some(PointKind::Test),
                        _ => None,
                    };
                    module.points.extend(kind.map(|kind| Point {
                        kind,
                        name: entry.name_of("Name"),
                        attributes: entry.attributes_without(&["Name"]),
                        trivia: Trivia::default(),
                        span: entry.span,
                    }));
                    self.xml.skip();
                }
            }
        }
    }

    fn port(&mut self, element: &Element<'a>) -> Port {
        let mut fields = element.fields(&[], &mut self.xml.errors);
        let mut port = Port {
            id: fields.number(&["Id"]),
            address: fields.text(&["Address"]),
            port_type: fields.text(&["Type"]),
            upstream: fields.flag(&["Upstream"]),
            safety_network: fields.text(&["SafetyNetwork"]),
            attributes: fields.rest(),
            span: element.span,
        };
        while let Some(child) = self.xml.child() {
            if child.name == "Bus" {
                adopt(&mut port.attributes, &child, &[]);
            }
            self.xml.skip();
        }
        port
    }

    fn communications(&mut self, module: &mut Module) {
        while let Some(child) = self.xml.child() {
            match child.name {
                "ConfigTag" => {
                    let tag = self.module_tag(&child, "C");
                    module.configuration = Some(Box::new(tag));
                }
                "ConfigData" | "ConfigScript" | "SafetyScript" => {
                    let opaque = self.opaque(&child);
                    module.opaque.push(opaque);
                }
                "Connections" => {
                    while let Some(connection) = self.xml.child() {
                        if connection.name == "Connection" {
                            let connection = self.connection(&connection);
                            module.connections.push(connection);
                        } else {
                            self.xml.skip();
                        }
                    }
                }
                _ => self.xml.skip(),
            }
        }
    }

    fn opaque(&mut self, element: &Element<'a>) -> OpaqueData {
        let mut value = None;
        while let Some(child) = self.xml.child() {
            let next: Option<Data> = self.data(&child);
            value = value.or(next);
        }
        let value = value.map_or(Value::List { items: Vec::new(), span: element.span }, |data| data.value);
        OpaqueData { kind: Name::new(element.name, element.span), value, span: element.span }
    }

    fn connection(&mut self, element: &Element<'a>) -> Connection {
        let fields = element.fields(&["Name", "InputTagSuffix", "OutputTagSuffix"], &mut self.xml.errors);
        let mut connection = components::connection(element.name_of("Name"), fields, element.span, false);
        let suffix = |key: &str, usual: &str| element.get(key).map_or(usual.into(), |text| text.text);
        while let Some(child) = self.xml.child() {
            match child.name {
                "InputTag" => {
                    let tag = self.module_tag(&child, &suffix("InputTagSuffix", "I"));
                    connection.input = Some(Box::new(tag));
                }
                "OutputTag" => {
                    let tag = self.module_tag(&child, &suffix("OutputTagSuffix", "O"));
                    connection.output = Some(Box::new(tag));
                }
                _ => self.xml.skip(),
            }
        }
        connection
    }

    fn module_tag(&mut self, element: &Element<'a>, suffix: &str) -> ModuleTag {
        let external_access = element.fields(&[], &mut self.xml.errors).external_access();
        let mut tag = ModuleTag {
            suffix: suffix.into(),
            data_type: None,
            data: Vec::new(),
            forces: Vec::new(),
            external_access,
            span: element.span,
        };
        while let Some(child) = self.xml.child() {
            match child.name {
                "Data" => tag.data.extend(self.data(&child)),
                "ForceData" => tag.forces.extend(self.data(&child)),
                _ => self.xml.skip(),
            }
        }
        // The type is named where the data are decorated.
        tag.data_type = tag.data.iter().find_map(|data| match &data.value {
            Value::Structure { data_type, span, .. } | Value::Array { data_type, span, .. } => {
                Some(Name::new(data_type.clone(), *span))
            }
            _ => None,
        });
        tag
    }
}

/// A module is where its port to the parent is: in a slot, or at a network address.
fn place(module: &mut Module) {
    let upstream = |port: &&Port| port.upstream.is_some_and(|upstream| upstream.value);
    let Some(port) = module.ports.iter().find(upstream).or(module.ports.first()) else { return };
    let Some(Text { text, span }) = &port.address else { return };
    let ethernet = port.port_type.as_ref().is_some_and(|kind| kind.text.eq_ignore_ascii_case("Ethernet"));
    match text.parse::<u32>() {
        Ok(slot) if !ethernet => module.slot = module.slot.or(Some(Spanned::new(slot, *span))),
        _ => module.address = module.address.take().or_else(|| Some(Text { text: text.clone(), span: *span })),
    }
}
