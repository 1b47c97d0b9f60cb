//! L5X: the same tree as from text, with places in the XML.

mod add_ons;
mod cursor;
mod data;
mod modules;
mod programs;
mod tags;
mod types;

use crate::components;
use crate::errors::Errors;
use crate::read::beginning;
use crate::tree::{
    Attribute, Controller, Encoded, ErrorKind, Export, File, FileForm, Island, Name, SafetyInfo, SourceId, Spanned,
    Text, Trivia, Usage,
};
use cursor::{Element, Xml};

/// Reads a whole L5X.
pub(crate) fn read_l5x(source: SourceId, text: &str) -> (File, Errors) {
    let mut reader = Reader {
        xml: Xml::new(source, text),
        file: File { sources: vec![source], form: FileForm::Xml, ..File::default() },
    };
    match reader.xml.child() {
        Some(root) if root.name == "RSLogix5000Content" => reader.root(&root),
        Some(root) => {
            let message = format!("the root element is `{}`; an L5X has `RSLogix5000Content`", root.name);
            reader.xml.errors.add(ErrorKind::NotL5x, root.span, message);
        }
        None if reader.xml.errors.is_empty() => {
            reader.xml.errors.add(ErrorKind::NotL5x, beginning(source), "XML without an element");
        }
        None => {}
    }
    (reader.file, reader.xml.errors)
}

/// The state of reading a file.
struct Reader<'a> {
    xml: Xml<'a>,
    file: File,
}

/// What an element's `Use` says, or what the element around it says.
fn usage(element: &Element<'_>, around: Usage) -> Usage {
    match element.get("Use") {
        Some(text) if text.text.eq_ignore_ascii_case("Target") => Usage::Target,
        Some(text) if text.text.eq_ignore_ascii_case("Context") => Usage::Context,
        Some(text) if text.text.eq_ignore_ascii_case("Reference") => Usage::Reference,
        _ => around,
    }
}

impl<'a> Reader<'a> {
    fn root(&mut self, root: &Element<'a>) {
        let mut fields = root.fields(&[], &mut self.xml.errors);
        let export = Export {
            software_revision: fields.text(&["SoftwareRevision"]),
            target_type: fields.name(&["TargetType"]),
            target_name: fields.name(&["TargetName"]),
            target_class: fields.name(&["TargetClass"]),
            contains_context: fields.flag(&["ContainsContext"]),
            options: fields.text(&["ExportOptions"]),
            attributes: fields.rest(),
            span: root.span,
        };
        self.file.export = Some(Box::new(export));
        while let Some(child) = self.xml.child() {
            if child.name == "Controller" {
                self.controller(&child);
            } else {
                // Some tools write an exported component without a controller around it.
                self.component(child, Usage::Target);
            }
        }
    }

    fn controller(&mut self, element: &Element<'a>) {
        let fields = element.fields(&["Name"], &mut self.xml.errors);
        let mut controller = components::controller(element.name_of("Name"), fields, element.span);
        let around = controller.usage;
        while let Some(child) = self.xml.child() {
            match child.name {
                "Description" => controller.description = self.description(),
                "SafetyInfo" => self.safety_info(&child, &mut controller),
                _ => self.component(child, around),
            }
        }
        if let Some(first) = &self.file.controller {
            let message = format!("a second controller: `{}` is already declared", first.name);
            self.xml.errors.add(ErrorKind::TwoControllers, element.span, message);
        } else {
            self.file.controller = Some(Box::new(controller));
        }
    }

    /// A component, or the list that holds components of a kind.
    fn component(&mut self, element: Element<'a>, around: Usage) {
        let around = match element.name {
            "DataTypes" | "Modules" | "AddOnInstructionDefinitions" | "Tags" | "Programs" | "Tasks" => {
                usage(&element, around)
            }
            _ => around,
        };
        match element.name {
            "DataTypes" | "Modules" | "AddOnInstructionDefinitions" | "Tags" | "Programs" | "Tasks" => {
                while let Some(child) = self.xml.child() {
                    self.component_of_list(&child, around);
                }
            }
            "DataType" | "Module" | "AddOnInstructionDefinition" | "Tag" | "Program" | "Task" | "EncodedData" => {
                self.component_of_list(&element, around);
            }
            "Trends" | "DataLogs" | "QuickWatchLists" | "ParameterConnections" => self.islands(&element),
            _ => self.xml.skip(),
        }
    }

    fn component_of_list(&mut self, element: &Element<'a>, around: Usage) {
        match element.name {
            "DataType" => self.data_type(element, around),
            "Module" => self.module(element, around),
            "AddOnInstructionDefinition" => self.add_on_instruction(element, around),
            "Tag" => {
                let tag = self.tag(element, around);
                self.file.tags.push(tag);
            }
            "Program" => self.program(element, around),
            "Task" => self.task(element),
            "EncodedData" => {
                let encoded = self.encoded(element);
                self.file.encoded.push(encoded);
            }
            _ => self.xml.skip(),
        }
    }

    /// `<SafetyInfo SafetyLocked="false" ...><SafetyTagMap> a=b</SafetyTagMap></SafetyInfo>`
    fn safety_info(&mut self, element: &Element<'a>, controller: &mut Controller) {
        let mut fields = element.fields(&[], &mut self.xml.errors);
        let mut safety = components::safety_info(&mut fields, element.span)
            .unwrap_or_else(|| Box::new(SafetyInfo { span: element.span, ..SafetyInfo::default() }));
        safety.attributes = fields.rest();
        while let Some(child) = self.xml.child() {
            if child.name == "SafetyTagMap" {
                let text = self.xml.content().into_text();
                let mut fields = crate::fields::Fields::new(Vec::new(), &mut self.xml.errors);
                safety.tag_map.extend(components::tag_map(&text, &mut fields));
            } else {
                self.xml.skip();
            }
        }
        controller.safety = Some(safety);
    }

    /// Lists of things that are skipped; each thing in them is named.
    fn islands(&mut self, list: &Element<'a>) {
        while let Some(child) = self.xml.child() {
            let name = child.optional_name("Name");
            self.xml.skip();
            self.file.islands.push(Island {
                kind: Name::new(list.name, list.span),
                name,
                text: Text::new("", child.span),
                trivia: Trivia::none(),
                span: child.span,
            });
        }
    }

    /// `<EncodedData EncodedType="AddOnInstructionDefinition" Name="...">`
    fn encoded(&mut self, element: &Element<'a>) -> Encoded {
        self.xml.skip();
        Encoded {
            kind: element.name_of("EncodedType"),
            name: element.optional_name("Name"),
            attributes: element.attributes_without(&["EncodedType", "Name"]),
            text: Text::default(),
            trivia: Trivia::none(),
            span: element.span,
        }
    }

    fn description(&mut self) -> Option<Box<Text>> {
        let text = self.xml.content().into_text();
        (!text.text.is_empty()).then(|| Box::new(text))
    }

    /// A number of an attribute; nothing, with an error, when it is none.
    fn number(&mut self, text: Option<Text>, what: &str) -> Option<Spanned<u32>> {
        let text = text?;
        match text.text.parse() {
            Ok(value) => Some(Spanned::new(value, text.span)),
            Err(_) => {
                let message = format!("`{what}` is `{}`; expected a whole number", text.text);
                self.xml.errors.add(ErrorKind::BadAttribute, text.span, message);
                None
            }
        }
    }
}

/// Adds the attributes of an element inside a component to the component's own.
fn adopt(attributes: &mut Vec<Attribute>, element: &Element<'_>, without: &[&str]) {
    attributes.extend(element.attributes_without(without));
}
