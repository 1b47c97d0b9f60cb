//! Values at which arithmetic and comparisons differ.

use twinrung_catalog::Element;

/// A class of values.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Class {
    /// The integer 0.
    Zero,
    /// 1.
    One,
    /// -1.
    MinusOne,
    /// Above 1, within 16 bits.
    Positive,
    /// Below -1, within 16 bits.
    Negative,
    /// Above 16 bits.
    Large,
    /// Below 16 bits.
    LargeNegative,
    /// The greatest value of the type.
    Greatest,
    /// The least value of the type.
    Least,
    /// The REAL 0.
    RealZero,
    /// -0.
    RealMinusZero,
    /// Nearer to 0 than a normal number.
    Subnormal,
    /// A number that a DINT can hold.
    Whole,
    /// A number with a fraction.
    Fraction,
    /// Further from 0 than a DINT can be.
    Huge,
    /// Infinity.
    Infinite,
    /// Minus infinity.
    MinusInfinite,
    /// Not a number.
    NotANumber,
}

impl Class {
    /// Those of integers.
    pub const INTEGERS: [Class; 9] = [
        Class::Zero,
        Class::One,
        Class::MinusOne,
        Class::Positive,
        Class::Negative,
        Class::Large,
        Class::LargeNegative,
        Class::Greatest,
        Class::Least,
    ];
    /// Those of REALs.
    pub const REALS: [Class; 9] = [
        Class::RealZero,
        Class::RealMinusZero,
        Class::Subnormal,
        Class::Whole,
        Class::Fraction,
        Class::Huge,
        Class::Infinite,
        Class::MinusInfinite,
        Class::NotANumber,
    ];

    /// The class of what a word cell of a type holds.
    pub fn of(element: Element, held: i32) -> Class {
        let (least, greatest) = match element {
            Element::Real => return Class::of_real(f32::from_bits(held as u32)),
            Element::Sint => (i32::from(i8::MIN), i32::from(i8::MAX)),
            Element::Int => (i32::from(i16::MIN), i32::from(i16::MAX)),
            Element::Dint | Element::Bool => (i32::MIN, i32::MAX),
        };
        match held {
            0 => Class::Zero,
            1 => Class::One,
            -1 => Class::MinusOne,
            _ if held == least => Class::Least,
            _ if held == greatest => Class::Greatest,
            2..=32_767 => Class::Positive,
            -32_768..=-2 => Class::Negative,
            32_768.. => Class::Large,
            _ => Class::LargeNegative,
        }
    }

    fn of_real(value: f32) -> Class {
        match value {
            _ if value.is_nan() => Class::NotANumber,
            _ if value == f32::INFINITY => Class::Infinite,
            _ if value == f32::NEG_INFINITY => Class::MinusInfinite,
            _ if value == 0.0 && value.is_sign_negative() => Class::RealMinusZero,
            _ if value == 0.0 => Class::RealZero,
            _ if value.is_subnormal() => Class::Subnormal,
            _ if value.abs() >= 2_147_483_648.0 => Class::Huge,
            _ if value.fract() == 0.0 => Class::Whole,
            _ => Class::Fraction,
        }
    }
}
