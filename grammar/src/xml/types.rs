//! `<DataType>`.

use super::cursor::Element;
use super::{Reader, usage};
use crate::components;
use crate::tree::{BitPlace, Dimensions, ErrorKind, Member, Text, Usage};

impl<'a> Reader<'a> {
    pub(super) fn data_type(&mut self, element: &Element<'a>, around: Usage) {
        let fields = element.fields(&["Name", "Use"], &mut self.xml.errors);
        let mut data_type = components::data_type(element.name_of("Name"), fields, element.span);
        data_type.usage = usage(element, around);
        while let Some(child) = self.xml.child() {
            match child.name {
                "Description" => data_type.description = self.description(),
                "Members" => {
                    while let Some(member) = self.xml.child() {
                        let member = self.member(&member);
                        data_type.members.push(member);
                    }
                }
                _ => self.xml.skip(),
            }
        }
        self.file.data_types.push(data_type);
    }

    fn member(&mut self, element: &Element<'a>) -> Member {
        const OWN: &[&str] = &["Name", "DataType", "Dimension", "Target", "BitNumber"];
        let fields = element.fields(OWN, &mut self.xml.errors);
        let data_type = element.name_of("DataType");
        let mut member = components::member(element.name_of("Name"), data_type, fields, element.span);
        member.dimensions = self.dimensions(element.get("Dimension"));
        if let Some(target) = element.optional_name("Target") {
            let number = self.number(element.get("BitNumber"), "BitNumber").unwrap_or_default();
            member.bit = Some(Box::new(BitPlace { target, number }));
        }
        while let Some(child) = self.xml.child() {
            match child.name {
                "Description" => member.description = self.description(),
                _ => self.xml.skip(),
            }
        }
        member
    }

    /// `10 3`, `10,3`, `[0,1]`; a scalar is `0` or nothing.
    pub(super) fn dimensions(&mut self, text: Option<Text>) -> Dimensions {
        let Some(text) = text else { return Dimensions::default() };
        match parse_dimensions(&text.text) {
            Some(dimensions) if dimensions.sizes() == [0] => Dimensions::default(),
            Some(dimensions) => dimensions,
            None => {
                let message = format!("`{}` are no array dimensions", text.text);
                self.xml.errors.add(ErrorKind::BadAttribute, text.span, message);
                Dimensions::default()
            }
        }
    }
}

/// Numbers with blanks or commas between, brackets around them or not.
pub(super) fn parse_dimensions(text: &str) -> Option<Dimensions> {
    let inner = text.trim().trim_start_matches('[').trim_end_matches(']');
    let mut sizes = [0; 3];
    let mut length = 0;
    for part in inner.split([',', ' ']).filter(|part| !part.is_empty()) {
        *sizes.get_mut(length)? = part.parse().ok()?;
        length += 1;
    }
    Dimensions::new(&sizes[..length])
}
