//! `<AddOnInstructionDefinition>`.

use super::cursor::Element;
use super::{Reader, usage};
use crate::components;
use crate::tree::{Attribute, AttributeValue, HistoryEntry, Name, Parameter, Text, Trivia, Usage};

impl<'a> Reader<'a> {
    pub(super) fn add_on_instruction(&mut self, element: &Element<'a>, around: Usage) {
        let fields = element.fields(&["Name", "Use"], &mut self.xml.errors);
        let mut add_on = components::add_on_instruction(element.name_of("Name"), fields, element.span);
        add_on.usage = usage(element, around);
        while let Some(child) = self.xml.child() {
            match child.name {
                "Description" => add_on.description = self.description(),
                "Parameters" => {
                    while let Some(parameter) = self.xml.child() {
                        let parameter = self.parameter(&parameter);
                        add_on.parameters.push(parameter);
                    }
                }
                "LocalTags" => {
                    while let Some(tag) = self.xml.child() {
                        let tag = self.tag(&tag, Usage::Target);
                        add_on.local_tags.push(tag);
                    }
                }
                "Routines" => {
                    while let Some(routine) = self.xml.child() {
                        let routine = self.routine(&routine, Usage::Target);
                        add_on.routines.push(routine);
                    }
                }
                "SignatureHistory" => {
                    while let Some(entry) = self.xml.child() {
                        let entry = self.history_entry(&entry);
                        add_on.history.push(entry);
                    }
                }
                "RevisionNote" | "AdditionalHelpText" => {
                    let key = Name::new(child.name, child.span);
                    if let Some(text) = self.description() {
                        add_on.attributes.push(Attribute { key, value: AttributeValue::Quoted(*text) });
                    }
                }
                _ => self.xml.skip(),
            }
        }
        self.file.add_on_instructions.push(add_on);
    }

    fn history_entry(&mut self, element: &Element<'a>) -> HistoryEntry {
        let mut attributes = element.attributes_without(&[]);
        while let Some(child) = self.xml.child() {
            match child.name {
                "Description" => {
                    let key = Name::new(child.name, child.span);
                    if let Some(text) = self.description() {
                        attributes.push(Attribute { key, value: AttributeValue::Quoted(*text) });
                    }
                }
                _ => self.xml.skip(),
            }
        }
        HistoryEntry { attributes, text: Text::default(), trivia: Trivia::none(), span: element.span }
    }

    fn parameter(&mut self, element: &Element<'a>) -> Parameter {
        let fields = element.fields(&["Name", "DataType", "Dimensions"], &mut self.xml.errors);
        let mut parameter = components::parameter(element.name_of("Name"), fields, element.span);
        parameter.data_type = element.optional_name("DataType");
        parameter.dimensions = self.dimensions(element.get("Dimensions"));
        while let Some(child) = self.xml.child() {
            match child.name {
                "Description" => parameter.description = self.description(),
                "DefaultData" => parameter.default.extend(self.data(&child)),
                _ => self.xml.skip(),
            }
        }
        parameter
    }
}
