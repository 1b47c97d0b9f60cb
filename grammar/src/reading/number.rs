//! Immediate values: every form of the reference's C.2.

use crate::reading::escape::unescape_bytes;
use crate::tree::{ErrorKind, Number, Radix};

/// Why a text is no number.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum NumberFault {
    /// Not of any form.
    Form,
    /// A digit that the base does not have.
    Digit(Radix),
    /// Beyond 64 bits.
    Range,
    /// A `$` escape that does not exist.
    Escape,
}

impl NumberFault {
    pub(crate) fn kind(self) -> ErrorKind {
        match self {
            NumberFault::Escape => ErrorKind::MalformedEscape,
            _ => ErrorKind::MalformedNumber,
        }
    }

    pub(crate) fn message(self, text: &str) -> String {
        let text = clip(text);
        match self {
            NumberFault::Form => format!("`{text}` is no number"),
            NumberFault::Digit(radix) => format!("`{text}` has a digit that {} does not have", radix_name(radix)),
            NumberFault::Range => format!("`{text}` is beyond 64 bits"),
            NumberFault::Escape => format!("{text} has a `$` escape that does not exist"),
        }
    }
}

fn radix_name(radix: Radix) -> &'static str {
    match radix {
        Radix::Decimal => "base 10",
        Radix::Hexadecimal => "base 16",
        Radix::Octal => "base 8",
        Radix::Binary => "base 2",
    }
}

/// The beginning of a text, for messages.
pub(crate) fn clip(text: &str) -> String {
    const SHOWN: usize = 40;
    match text.char_indices().nth(SHOWN) {
        Some((end, _)) => format!("{}...", &text[..end]),
        None => text.to_string(),
    }
}

/// Reads a number of any form: `-5`, `16#00ff`, `1.5e+01`, `1.#QNAN`, `'AB'`.
pub(crate) fn parse_number(text: &str) -> Result<Number, NumberFault> {
    if let Some(quoted) = text.strip_prefix('\'') {
        let inner = quoted.strip_suffix('\'').ok_or(NumberFault::Form)?;
        return unescape_bytes(inner).map(Number::Ascii).ok_or(NumberFault::Escape);
    }
    let (negative, digits) = match text.as_bytes().first() {
        Some(b'-') => (true, &text[1..]),
        Some(b'+') => (false, &text[1..]),
        _ => (false, text),
    };
    let digits = digits.trim_start();
    if let Some((base, digits)) = digits.split_once('#') {
        return match base {
            "16" => integer(negative, digits, Radix::Hexadecimal),
            "8" => integer(negative, digits, Radix::Octal),
            "2" => integer(negative, digits, Radix::Binary),
            _ => special(negative, base, digits),
        };
    }
    if digits.bytes().all(|byte| byte.is_ascii_digit() || byte == b'_') {
        return integer(negative, digits, Radix::Decimal);
    }
    if let Some(whole) = digits.strip_suffix(".$") {
        // The display form of infinity and of what is no number.
        return special(negative, whole, "INF");
    }
    real(negative, digits)
}

fn integer(negative: bool, digits: &str, radix: Radix) -> Result<Number, NumberFault> {
    let base = match radix {
        Radix::Decimal => 10,
        Radix::Hexadecimal => 16,
        Radix::Octal => 8,
        Radix::Binary => 2,
    };
    let mut magnitude: u64 = 0;
    let mut any = false;
    for character in digits.chars().filter(|&character| character != '_') {
        let digit = character.to_digit(base).ok_or(NumberFault::Digit(radix))?;
        magnitude = magnitude
            .checked_mul(u64::from(base))
            .and_then(|shifted| shifted.checked_add(u64::from(digit)))
            .ok_or(NumberFault::Range)?;
        any = true;
    }
    if any { Ok(Number::Integer { negative, magnitude, radix }) } else { Err(NumberFault::Form) }
}

fn special(negative: bool, whole: &str, word: &str) -> Result<Number, NumberFault> {
    const QUIET_NAN: u32 = 0x7FC0_0000;
    const INFINITY: u32 = 0x7F80_0000;
    if !matches!(whole, "1" | "1.") {
        return Err(NumberFault::Form);
    }
    let word = word.to_ascii_uppercase();
    let bits = match word.as_str() {
        "QNAN" | "SNAN" | "IND" | "NAN" => QUIET_NAN,
        "INF" => INFINITY,
        _ => return Err(NumberFault::Form),
    };
    Ok(Number::Special { bits: bits | if negative { 0x8000_0000 } else { 0 } })
}

fn real(negative: bool, digits: &str) -> Result<Number, NumberFault> {
    let shape = digits.bytes().all(|byte| matches!(byte, b'0'..=b'9' | b'.' | b'e' | b'E' | b'+' | b'-' | b'_'))
        && digits.bytes().any(|byte| byte.is_ascii_digit());
    if !shape {
        return Err(NumberFault::Form);
    }
    let plain: std::borrow::Cow<'_, str> =
        if digits.contains('_') { digits.replace('_', "").into() } else { digits.into() };
    let value: f32 = plain.parse().map_err(|_| NumberFault::Form)?;
    if value.is_infinite() {
        return Err(NumberFault::Range);
    }
    Ok(Number::Real { bits: if negative { -value } else { value }.to_bits() })
}
