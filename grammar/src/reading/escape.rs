//! `$` escapes of quoted texts.
//!
//! In a text for people (double quotes, RM084 p46): `$$ $' $Q $L $N $P $R $T` and `$xxxx`, four
//! hexadecimal digits of a character. A line ends with `$N` there, and with a line feed here, as in
//! an L5X. In a string of data (single quotes): the same letters, and
//! `$xx`, two hexadecimal digits of a byte.

/// The text that a double-quoted text stands for, or nothing when an escape does not exist.
pub(crate) fn unescape_text(quoted: &str) -> Option<std::borrow::Cow<'_, str>> {
    if !quoted.contains('$') {
        return Some(quoted.into());
    }
    let mut text = String::with_capacity(quoted.len());
    let mut rest = quoted;
    while let Some((before, after)) = rest.split_once('$') {
        text.push_str(before);
        let letter = after.chars().next()?;
        match letter.to_ascii_uppercase() {
            '$' => text.push('$'),
            '\'' => text.push('\''),
            '"' | 'Q' => text.push('"'),
            'L' | 'N' => text.push('\n'),
            'P' => text.push('\u{c}'),
            'R' => text.push('\r'),
            'T' => text.push('\t'),
            _ => {
                let digits = after.get(..4)?;
                let code = u32::from_str_radix(digits, 16).ok()?;
                text.push(char::from_u32(code).unwrap_or('\u{fffd}'));
                rest = after.get(4..)?;
                continue;
            }
        }
        rest = after.get(letter.len_utf8()..)?;
    }
    text.push_str(rest);
    Some(text.into())
}

/// A text as it is written between double quotes; [`unescape_text`] is its inverse.
pub(crate) fn escape_text(text: &str, out: &mut String) {
    for character in text.chars() {
        match character {
            '$' => out.push_str("$$"),
            '"' => out.push_str("$Q"),
            '\n' => out.push_str("$N"),
            '\r' => out.push_str("$R"),
            '\t' => out.push_str("$T"),
            '\u{c}' => out.push_str("$P"),
            control if control.is_control() => out.push_str(&format!("${:04X}", control as u32)),
            plain => out.push(plain),
        }
    }
}

/// The bytes that a string of data stands for (without its quotes), or nothing when an escape does
/// not exist.
pub(crate) fn unescape_bytes(quoted: &str) -> Option<Vec<u8>> {
    let mut bytes = Vec::with_capacity(quoted.len());
    let mut rest = quoted.as_bytes();
    while let Some((&first, after)) = rest.split_first() {
        if first != b'$' {
            bytes.push(first);
            rest = after;
            continue;
        }
        let (&letter, after_letter) = after.split_first()?;
        rest = after_letter;
        match letter {
            b'$' | b'\'' | b'"' => bytes.push(letter),
            b'Q' | b'q' => bytes.push(b'"'),
            b'L' | b'l' => bytes.push(b'\n'),
            b'N' | b'n' => bytes.extend_from_slice(b"\r\n"),
            b'P' | b'p' => bytes.push(0x0C),
            b'R' | b'r' => bytes.push(b'\r'),
            b'T' | b't' => bytes.push(b'\t'),
            _ => {
                let (&low, after_digits) = after_letter.split_first()?;
                let digit = |byte: u8| char::from(byte).to_digit(16);
                bytes.push((digit(letter)? * 16 + digit(low)?) as u8);
                rest = after_digits;
            }
        }
    }
    Some(bytes)
}
