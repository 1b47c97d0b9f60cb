//! Attributes by name: what `.rll`, L5K and L5X spell differently becomes one typed field.

use crate::errors::Errors;
use crate::reading::number::{clip, parse_number};
use crate::tree::{
    Attribute, AttributeValue, Class, CompactString, ErrorKind, ExternalAccess, Name, Number, ReadError, Spanned, Text,
};

/// The attributes of one component. Fields are taken out; what is left stays as it is.
pub(crate) struct Fields<'e> {
    list: Vec<Attribute>,
    pub(crate) errors: &'e mut Errors,
}

impl<'e> Fields<'e> {
    pub(crate) fn new(list: Vec<Attribute>, errors: &'e mut Errors) -> Fields<'e> {
        Fields { list, errors }
    }

    /// What nobody took; without the memory of what was taken.
    pub(crate) fn rest(mut self) -> Vec<Attribute> {
        self.list.shrink_to_fit();
        self.list
    }

    pub(crate) fn has(&self, keys: &[&str]) -> bool {
        self.position(keys).is_some()
    }

    fn position(&self, keys: &[&str]) -> Option<usize> {
        self.list.iter().position(|attribute| keys.iter().any(|key| attribute.key.is(key)))
    }

    fn take(&mut self, keys: &[&str]) -> Option<Attribute> {
        let taken = self.list.remove(self.position(keys)?);
        if let Some(again) = self.position(keys) {
            let again = self.list.remove(again);
            let message = format!("`{}` is set twice", again.key);
            self.errors.add(ErrorKind::BadAttribute, again.key.span, message);
        }
        Some(taken)
    }

    /// A value that is text; nothing when it is empty.
    pub(crate) fn text(&mut self, keys: &[&str]) -> Option<Text> {
        self.keyed_text(keys).map(|(_, text)| text)
    }

    /// A value that is text, and the key that sets it.
    fn keyed_text(&mut self, keys: &[&str]) -> Option<(Name, Text)> {
        let taken = self.take(keys)?;
        match taken.value {
            AttributeValue::Quoted(text) | AttributeValue::Words(text) => {
                (!text.text.is_empty()).then_some((taken.key, text))
            }
            AttributeValue::List(value) => {
                let message = format!("`{}` is set to a list; expected a word or a quoted text", taken.key);
                self.errors.add(ErrorKind::BadAttribute, value.span(), message);
                None
            }
        }
    }

    pub(crate) fn boxed_text(&mut self, keys: &[&str]) -> Option<Box<Text>> {
        self.text(keys).map(Box::new)
    }

    pub(crate) fn name(&mut self, keys: &[&str]) -> Option<Name> {
        self.text(keys).map(|text| Name { text: text.text, span: text.span })
    }

    fn refuse(&mut self, key: &Name, text: &Text, expected: &str) {
        let message = format!("`{key}` is set to `{}`; expected {expected}", clip(&text.text));
        self.errors.push(ReadError::new(ErrorKind::BadAttribute, text.span, message));
    }

    pub(crate) fn flag(&mut self, keys: &[&str]) -> Option<Spanned<bool>> {
        let (key, text) = self.keyed_text(keys)?;
        let is = |words: &[&str]| words.iter().any(|word| text.text.eq_ignore_ascii_case(word));
        if is(&["true", "Yes", "1", "-1"]) {
            Some(Spanned::new(true, text.span))
        } else if is(&["false", "No", "0"]) {
            Some(Spanned::new(false, text.span))
        } else {
            self.refuse(&key, &text, "Yes or No");
            None
        }
    }

    pub(crate) fn number(&mut self, keys: &[&str]) -> Option<Spanned<u32>> {
        let (key, text) = self.keyed_text(keys)?;
        match parse_number(&text.text) {
            Ok(Number::Integer { negative: false, magnitude, .. }) if magnitude <= u64::from(u32::MAX) => {
                Some(Spanned::new(magnitude as u32, text.span))
            }
            _ => {
                self.refuse(&key, &text, "a whole number");
                None
            }
        }
    }

    /// A time written in microseconds.
    pub(crate) fn microseconds(&mut self, keys: &[&str]) -> Option<Spanned<u64>> {
        self.time(keys, 0, "a time in microseconds")
    }

    /// A time written in milliseconds, with decimals or without.
    pub(crate) fn milliseconds(&mut self, keys: &[&str]) -> Option<Spanned<u64>> {
        self.time(keys, 3, "a time in milliseconds")
    }

    fn time(&mut self, keys: &[&str], decimals: usize, expected: &str) -> Option<Spanned<u64>> {
        let (key, text) = self.keyed_text(keys)?;
        match scaled(&text.text, decimals) {
            Some(value) => Some(Spanned::new(value, text.span)),
            None => {
                self.refuse(&key, &text, expected);
                None
            }
        }
    }

    pub(crate) fn class(&mut self) -> Option<Spanned<Class>> {
        let (key, text) = self.keyed_text(&["Class"])?;
        if text.text.eq_ignore_ascii_case("Safety") {
            Some(Spanned::new(Class::Safety, text.span))
        } else if text.text.eq_ignore_ascii_case("Standard") {
            Some(Spanned::new(Class::Standard, text.span))
        } else {
            self.refuse(&key, &text, "Safety or Standard");
            None
        }
    }

    pub(crate) fn external_access(&mut self) -> Option<Spanned<ExternalAccess>> {
        let (key, text) = self.keyed_text(&["ExternalAccess"])?;
        let letters: CompactString = text.text.chars().filter(char::is_ascii_alphabetic).collect();
        let access = match letters.to_ascii_lowercase().as_str() {
            "readwrite" => ExternalAccess::ReadWrite,
            "readonly" => ExternalAccess::ReadOnly,
            "none" => ExternalAccess::None,
            _ => {
                self.refuse(&key, &text, "Read/Write, Read Only or None");
                return None;
            }
        };
        Some(Spanned::new(access, text.span))
    }

    /// One word of a list.
    pub(crate) fn choice<T: Copy>(&mut self, keys: &[&str], choices: &[(&str, T)]) -> Option<Spanned<T>> {
        let (key, text) = self.keyed_text(keys)?;
        match choices.iter().find(|(word, _)| text.text.eq_ignore_ascii_case(word)) {
            Some(&(_, value)) => Some(Spanned::new(value, text.span)),
            None => {
                let words: Vec<&str> = choices.iter().map(|(word, _)| *word).collect();
                self.refuse(&key, &text, &words.join(" or "));
                None
            }
        }
    }
}

/// `29.952` with three decimals is 29952; digits past them are rounded.
fn scaled(text: &str, decimals: usize) -> Option<u64> {
    let (whole, fraction) = text.split_once('.').unwrap_or((text, ""));
    let digits = |part: &str| part.bytes().all(|byte| byte.is_ascii_digit());
    if (whole.is_empty() && fraction.is_empty()) || !digits(whole) || !digits(fraction) {
        return None;
    }
    let mut value: u64 = if whole.is_empty() { 0 } else { whole.parse().ok()? };
    for place in 0..decimals {
        let digit = fraction.as_bytes().get(place).map_or(0, |byte| u64::from(byte - b'0'));
        value = value.checked_mul(10)?.checked_add(digit)?;
    }
    let round_up = fraction.as_bytes().get(decimals).is_some_and(|&byte| byte >= b'5');
    value.checked_add(u64::from(round_up))
}
