//! Attribute lists: `key := value`.

use super::value::print_value;
use crate::reading::escape::escape_text;
use crate::tree::{Attribute, AttributeValue, Class, ExternalAccess, Name, Spanned, Text};

/// An attribute list in the making.
#[derive(Default)]
pub(super) struct List {
    pub(super) items: Vec<String>,
}

/// A text between double quotes.
pub(super) fn quoted(text: &str) -> String {
    let mut out = String::with_capacity(text.len() + 2);
    out.push('"');
    escape_text(text, &mut out);
    out.push('"');
    out
}

/// Whether a text can stand without quotes: one word or number.
fn is_word(text: &str) -> bool {
    text.bytes().next().is_some_and(|first| first.is_ascii_alphanumeric() || first == b'_')
        && text.bytes().all(|byte| byte.is_ascii_alphanumeric() || matches!(byte, b'_' | b'#' | b'.'))
        && !text.starts_with("END_")
        && (text.bytes().next().is_some_and(|first| first.is_ascii_digit()) || !text.contains('#'))
}

impl List {
    pub(super) fn push(&mut self, key: &str, value: &str) {
        self.items.push(format!("{key} := {value}"));
    }

    /// In quotes.
    pub(super) fn text(&mut self, key: &str, text: Option<&Text>) {
        if let Some(text) = text {
            self.push(key, &quoted(&text.text));
        }
    }

    /// Without quotes when it is one word.
    pub(super) fn word(&mut self, key: &str, text: Option<&str>) {
        if let Some(text) = text {
            if is_word(text) {
                self.push(key, text);
            } else {
                self.push(key, &quoted(text));
            }
        }
    }

    pub(super) fn name(&mut self, key: &str, name: Option<&Name>) {
        self.word(key, name.map(Name::as_str));
    }

    pub(super) fn number(&mut self, key: &str, number: Option<Spanned<u32>>) {
        if let Some(number) = number {
            self.push(key, &number.value.to_string());
        }
    }

    pub(super) fn flag(&mut self, key: &str, flag: Option<Spanned<bool>>) {
        if let Some(flag) = flag {
            self.push(key, if flag.value { "Yes" } else { "No" });
        }
    }

    /// A time in microseconds, written in milliseconds.
    pub(super) fn milliseconds(&mut self, key: &str, time_us: Option<Spanned<u64>>) {
        if let Some(time_us) = time_us {
            let (whole, rest) = (time_us.value / 1000, time_us.value % 1000);
            let text = if rest == 0 {
                whole.to_string()
            } else {
                format!("{whole}.{rest:03}").trim_end_matches('0').to_string()
            };
            self.push(key, &text);
        }
    }

    pub(super) fn microseconds(&mut self, key: &str, time_us: Option<Spanned<u64>>) {
        if let Some(time_us) = time_us {
            self.push(key, &time_us.value.to_string());
        }
    }

    pub(super) fn class(&mut self, class: Option<Spanned<Class>>) {
        if let Some(class) = class {
            self.push("Class", if class.value == Class::Safety { "Safety" } else { "Standard" });
        }
    }

    pub(super) fn external_access(&mut self, access: Option<Spanned<ExternalAccess>>) {
        if let Some(access) = access {
            let word = match access.value {
                ExternalAccess::ReadWrite => "Read/Write",
                ExternalAccess::ReadOnly => "Read Only",
                ExternalAccess::None => "None",
            };
            self.push("ExternalAccess", word);
        }
    }

    /// Attributes without a field of their own, as they were.
    pub(super) fn rest(&mut self, attributes: &[Attribute]) {
        for attribute in attributes {
            let value = match &attribute.value {
                AttributeValue::Words(text) => text.text.to_string(),
                AttributeValue::Quoted(text) => quoted(&text.text),
                AttributeValue::List(value) => print_value(value).unwrap_or_else(|| "[]".to_string()),
            };
            self.push(&attribute.key.text, &value);
        }
    }
}
