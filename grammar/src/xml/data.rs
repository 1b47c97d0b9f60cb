//! Data of tags: decorated, as L5K, as bytes, as a string.

use super::Reader;
use super::cursor::Element;
use super::types::parse_dimensions;
use crate::limits::VALUE_DEPTH_MAX;
use crate::text::read_value;
use crate::tree::{CompactString, Data, DataForm, Dimensions, ErrorKind, MemberValue, Text, Value};

impl<'a> Reader<'a> {
    /// `<Data Format="...">`, `<DefaultData>`, `<ForceData>`; nothing, with an error, when it cannot
    /// be read.
    pub(super) fn data(&mut self, element: &Element<'a>) -> Option<Data> {
        let format = element.get("Format");
        let (form, value) = match format.as_ref().map(|format| format.text.as_str()) {
            None => (DataForm::Raw, self.raw()?),
            Some("L5K") => (DataForm::L5k, self.l5k()?),
            Some("Decorated") => (DataForm::Decorated, self.decorated()?),
            Some("String") => {
                let text = unquoted(self.xml.content().into_text());
                (DataForm::String, Value::String(text))
            }
            Some(_) => {
                self.xml.skip();
                (DataForm::Other, Value::List { items: Vec::new(), span: element.span })
            }
        };
        Some(Data { form, value })
    }

    /// `01 00 00 00`
    fn raw(&mut self) -> Option<Value> {
        let content = self.xml.content();
        let mut bytes = Vec::with_capacity(content.text.len() / 3 + 1);
        for pair in content.text.split_ascii_whitespace() {
            match u8::from_str_radix(pair, 16) {
                Ok(byte) if pair.len() == 2 => bytes.push(byte),
                _ => {
                    let message =
                        format!("`{}` is no byte of two hexadecimal digits", crate::reading::number::clip(pair));
                    self.xml.errors.add(ErrorKind::MalformedData, content.span, message);
                    return None;
                }
            }
        }
        Some(Value::Bytes { bytes, span: content.span })
    }

    /// `0`, `[1,[2,3],'text']`
    pub(super) fn l5k(&mut self) -> Option<Value> {
        let content = self.xml.content();
        if is_plain_number(&content.text) {
            return Some(Value::Number(content.into_text()));
        }
        match read_value(content.excerpt()) {
            Ok(value) => Some(value),
            Err(error) => {
                self.xml.errors.push(error);
                None
            }
        }
    }

    fn decorated(&mut self) -> Option<Value> {
        let mut value = None;
        while let Some(child) = self.xml.child() {
            let next = self.decorated_value(&child, 1);
            value = value.or(next);
        }
        value
    }

    /// An element of decorated data. Recurses as deep as structures nest, which has a limit.
    fn decorated_value(&mut self, element: &Element<'a>, depth: usize) -> Option<Value> {
        if depth > VALUE_DEPTH_MAX {
            let message = format!("data nested deeper than {VALUE_DEPTH_MAX}");
            self.xml.errors.add(ErrorKind::TooDeep, element.span, message);
            self.xml.skip();
            return None;
        }
        match element.name {
            "DataValue" | "DataValueMember" => Some(self.single(element)),
            "Array" | "ArrayMember" => Some(self.array(element, depth)),
            "Structure" | "StructureMember" => Some(self.structure(element, depth)),
            _ => {
                self.xml.skip();
                None
            }
        }
    }

    fn single(&mut self, element: &Element<'a>) -> Value {
        match element.get("Value") {
            Some(text) => {
                self.xml.skip();
                // Characters are written as a literal, `'A'`.
                if text.text.starts_with('\'') { Value::String(unquoted(text)) } else { Value::Number(text) }
            }
            // The characters of a string are the element's text.
            None => Value::String(unquoted(self.xml.content().into_text())),
        }
    }

    fn array(&mut self, element: &Element<'a>, depth: usize) -> Value {
        let data_type = text_of(element, "DataType");
        let dimensions = self.dimensions(element.get("Dimensions"));
        let mut elements = Vec::new();
        while let Some(child) = self.xml.child() {
            let index = self.index(&child);
            let value = match child.get("Value") {
                Some(text) => {
                    self.xml.skip();
                    Some(if text.text.starts_with('\'') { Value::String(unquoted(text)) } else { Value::Number(text) })
                }
                None => {
                    let mut value = None;
                    while let Some(inner) = self.xml.child() {
                        let next = self.decorated_value(&inner, depth + 1);
                        value = value.or(next);
                    }
                    value
                }
            };
            elements.extend(value.map(|value| (index, value)));
        }
        elements.shrink_to_fit();
        Value::Array { data_type, dimensions, elements, span: element.span }
    }

    /// `[0]`, `[0,1]`
    fn index(&mut self, element: &Element<'a>) -> Dimensions {
        let Some(text) = element.get("Index") else { return Dimensions::default() };
        parse_dimensions(&text.text).unwrap_or_else(|| {
            self.xml.errors.add(ErrorKind::MalformedData, text.span, format!("`{}` is no index", text.text));
            Dimensions::default()
        })
    }

    fn structure(&mut self, element: &Element<'a>, depth: usize) -> Value {
        let data_type = text_of(element, "DataType");
        let mut members = Vec::new();
        while let Some(child) = self.xml.child() {
            let (name, data_type) = (child.name_of("Name"), text_of(&child, "DataType"));
            let value = self.decorated_value(&child, depth + 1);
            members.extend(value.map(|value| MemberValue { name, data_type, value }));
        }
        members.shrink_to_fit();
        Value::Structure { data_type, members, span: element.span }
    }
}

fn text_of(element: &Element<'_>, key: &str) -> CompactString {
    element.get(key).map_or_else(CompactString::default, |text| text.text)
}

/// Digits with a sign or a point: no need of a parser.
fn is_plain_number(text: &str) -> bool {
    !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit() || matches!(byte, b'-' | b'.'))
}

/// Without the quotes of a literal.
fn unquoted(text: Text) -> Text {
    match text.text.strip_prefix('\'').and_then(|rest| rest.strip_suffix('\'')) {
        Some(inner) => {
            let span =
                crate::tree::Span { start: text.span.start + 1, end: text.span.end.saturating_sub(1), ..text.span };
            Text::new(inner, span)
        }
        None => text,
    }
}
