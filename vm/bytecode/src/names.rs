//! What a name is and how names are ordered. Upper and lower case are the same everywhere.

use core::cmp::Ordering;

use crate::limits;

/// The order of names in every table: byte by byte, with A to Z as a to z.
pub fn order(left: &str, right: &str) -> Ordering {
    let fold = |text| str::bytes(text).map(|byte| byte.to_ascii_lowercase());
    fold(left).cmp(fold(right))
}

/// Whether a component (program, routine, member, label, ...) can have this name: a letter or underscore, then
/// letters, digits and underscores (neutral-text-and-l5x.md C.2; the compiler holds the 40 characters).
pub fn is_component(name: &str) -> bool {
    let begins = name.bytes().next().is_some_and(|first| first.is_ascii_alphabetic() || first == b'_');
    begins && name.len() <= limits::NAME_BYTES && name.bytes().all(is_word)
}

/// Whether a module's tag or type can have this name: components and numbers with colons between them (`Rack:2:I`).
pub fn is_module_name(name: &str) -> bool {
    let mut parts = name.split(':');
    name.len() <= limits::NAME_BYTES
        && parts.next().is_some_and(is_component)
        && parts.all(|part| !part.is_empty() && part.bytes().all(is_word))
}

/// Whether a structure type can have this name: as a module's tag, and with the words by which a module's catalogue
/// tells its data formats apart (`AB:1734_IB8S:I:Safety - Combined Status`).
pub fn is_type_name(name: &str) -> bool {
    let begins = name.bytes().next().is_some_and(|first| first.is_ascii_alphabetic() || first == b'_');
    begins
        && name.len() <= limits::NAME_BYTES
        && !name.ends_with(' ')
        && name.bytes().all(|byte| is_word(byte) || b" -./:".contains(&byte))
}

/// Whether this can be a standard tag in the tag map: a module name, with members and elements.
pub fn is_tag_path(name: &str) -> bool {
    let begins = name.bytes().next().is_some_and(|first| first.is_ascii_alphabetic() || first == b'_');
    begins && name.len() <= limits::NAME_BYTES && name.bytes().all(|byte| is_word(byte) || b":.[],".contains(&byte))
}

/// Whether an expression or an operand would read this tag name as something else.
pub fn is_reserved(name: &str) -> bool {
    let operators = ["AND", "OR", "XOR", "NOT", "MOD", "ABS", "SQR"];
    operators.iter().chain(&crate::format::STATUS_KEYWORDS).any(|word| word.eq_ignore_ascii_case(name))
}

/// Whether this can be the text of a setting: quoted, or a run of characters that end no setting.
pub fn is_setting(value: &str) -> bool {
    match value.strip_prefix('"') {
        Some(quoted) => quoted
            .strip_suffix('"')
            .is_some_and(|inner| !inner.contains('"') && !inner.bytes().any(|byte| byte.is_ascii_control())),
        None => {
            !value.is_empty()
                && value.bytes().all(|byte| is_word(byte) || b" #+-./:\\".contains(&byte))
                && !value.contains(":=")
        }
    }
}

fn is_word(byte: u8) -> bool {
    byte.is_ascii_alphanumeric() || byte == b'_'
}
