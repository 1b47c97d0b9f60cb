//! Numbers as canonical text writes them.

use core::fmt::{self, Write};

/// An integer literal: decimal with its sign, or the 32 bits in lower-case digits without leading zeros.
pub fn write_integer(out: &mut dyn Write, radix: u8, value: i32) -> fmt::Result {
    match radix {
        16 => write!(out, "16#{value:x}"),
        8 => write!(out, "8#{value:o}"),
        2 => write!(out, "2#{value:b}"),
        _ => write!(out, "{value}"),
    }
}

/// A finite REAL: the shortest digits that read back as the same bits, with a point or an exponent. What is not finite
/// has no form in logic.
pub fn write_real(out: &mut dyn Write, bits: u32) -> fmt::Result {
    let value = f32::from_bits(bits);
    if value.is_finite() { write!(out, "{value:?}") } else { Err(fmt::Error) }
}

/// A REAL of a tag's data: as in logic, or the exporter's words for what is not finite
/// (neutral-text-and-l5x.md C.2).
pub fn write_real_data(out: &mut dyn Write, bits: u32) -> fmt::Result {
    let value = f32::from_bits(bits);
    match (value.is_nan(), value.is_sign_negative()) {
        _ if value.is_finite() => write_real(out, bits),
        (true, false) => out.write_str("1.#QNAN"),
        (true, true) => out.write_str("-1.#QNAN"),
        (false, false) => out.write_str("1.#INF"),
        (false, true) => out.write_str("-1.#INF"),
    }
}
