//! Immediates in every radix, with the values at which arithmetic goes wrong.

use super::random::Random;

/// Integers at which something changes.
pub const INTEGERS: &[i32] = &[
    0,
    1,
    -1,
    2,
    -2,
    3,
    7,
    8,
    10,
    31,
    32,
    100,
    127,
    128,
    -128,
    -129,
    255,
    256,
    32_767,
    32_768,
    -32_768,
    -32_769,
    65_535,
    65_536,
    16_777_216,
    16_777_217,
    i32::MAX,
    i32::MIN,
    i32::MAX - 1,
    i32::MIN + 1,
    0x5555_5555,
    -0x5555_5556,
];

/// REALs at which something changes, as bits: zeros, subnormals, limits, ties, infinities, NaNs.
pub const REALS: &[u32] = &[
    0x0000_0000,
    0x8000_0000,
    0x0000_0001,
    0x8000_0001,
    0x007F_FFFF,
    0x0080_0000,
    0x3F80_0000,
    0xBF80_0000,
    0x3F00_0000,
    0x3FC0_0000,
    0x4020_0000,
    0xC020_0000,
    0x4300_0000,
    0xC300_0000,
    0x4700_0000,
    0x4B80_0000,
    0x4F00_0000,
    0xCF00_0000,
    0x4F80_0000,
    0x5F00_0000,
    0xDF00_0000,
    0x7F7F_FFFF,
    0xFF7F_FFFF,
    0x7F80_0000,
    0xFF80_0000,
    0x7FC0_0000,
    0xFFC0_0001,
    0x7F80_0001,
    0x42F6_E979,
    0xC2F6_E979,
];

/// An integer: near zero, at a limit, or anywhere.
pub fn integer(random: &mut Random) -> i32 {
    match random.below(10) {
        0..=3 => *random.of(INTEGERS),
        4..=7 => random.below(21) as i32 - 10,
        8 => random.below(2001) as i32 - 1000,
        _ => random.bits() as i32,
    }
}

/// An integer as text, in a random radix.
pub fn integer_text(random: &mut Random) -> String {
    let value = integer(random);
    match random.below(10) {
        0 => format!("16#{value:x}"),
        1 => format!("16#{:04X}_{:04X}", (value as u32) >> 16, value as u32 & 0xFFFF),
        2 => format!("8#{value:o}"),
        3 => format!("2#{value:b}"),
        _ => value.to_string(),
    }
}

/// A REAL literal.
pub fn real_text(random: &mut Random) -> String {
    const TEXTS: &[&str] = &[
        "0.0",
        "-0.0",
        "0.5",
        "1.5",
        "2.5",
        "-2.5",
        "-1.0",
        "3.4028235e38",
        "-3.4028235e38",
        "1.17549435e-38",
        "1.0e-40",
        "16777216.0",
        "2147483648.0",
        "-2147483648.0",
        "1e10",
        "127.5",
        "32767.5",
        "0.1",
        "1.0e-3",
        "100.25",
    ];
    (*random.of(TEXTS)).to_owned()
}
