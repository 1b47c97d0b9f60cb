//! Reading values.

use alloc::string::String;
use twinrung_catalog::{ChoiceList, Element};

/// Reads a value of a member of this type; words are those of `choice`.
pub(crate) fn read(text: &str, element: Element, choice: Option<&ChoiceList>) -> Option<i32> {
    match element {
        Element::Real => text.parse::<f32>().ok().map(|real| real.to_bits().cast_signed()),
        Element::Bool => {
            choice.and_then(|list| list.value(text)).or_else(|| integer(text)).filter(|value| matches!(value, 0 | 1))
        }
        Element::Sint | Element::Int | Element::Dint => {
            choice.and_then(|list| list.value(text)).or_else(|| integer(text))
        }
    }
}

/// Reads a decimal or `16#` integer.
fn integer(text: &str) -> Option<i32> {
    match text.strip_prefix("16#") {
        Some(digits) => {
            let digits: String = digits.chars().filter(|character| *character != '_').collect();
            u32::from_str_radix(&digits, 16).ok().map(u32::cast_signed)
        }
        None => text.parse().ok(),
    }
}
