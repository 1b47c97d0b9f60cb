//! Values of operands and their conversion. general-instructions.md 2.2.

use twinrung_catalog::Element;

use crate::real;

/// A value and the type that it had where it was read.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Value {
    /// Its type; DINT for a literal and for a result.
    pub(crate) element: Element,
    /// Sign-extended, or the bits of a REAL.
    pub(crate) bits: i32,
}

impl Default for Value {
    fn default() -> Value {
        Value::dint(0)
    }
}

/// A DINT, and whether the exact value did not fit.
pub(crate) fn narrow_to_dint(exact: i64) -> (i32, bool) {
    let kept = exact as i32;
    (kept, i64::from(kept) != exact)
}

impl Value {
    /// A DINT.
    pub(crate) const fn dint(value: i32) -> Value {
        Value { element: Element::Dint, bits: value }
    }

    /// A REAL; every NaN becomes the one form.
    pub(crate) fn real(value: f32) -> Value {
        Value { element: Element::Real, bits: real::canonical(value.to_bits()) as i32 }
    }

    /// Whether it is REAL.
    pub(crate) fn is_real(self) -> bool {
        self.element == Element::Real
    }

    /// As REAL: the nearest one.
    pub(crate) fn to_real(self) -> f32 {
        if self.is_real() { f32::from_bits(self.bits as u32) } else { self.bits as f32 }
    }

    /// As an exact integer with the low bits of a DINT kept, and whether it did not fit.
    pub(crate) fn to_dint(self) -> (i32, bool) {
        if !self.is_real() {
            return (self.bits, false);
        }
        match real::nearest_integer(self.to_real()) {
            Some(exact) => narrow_to_dint(exact),
            None => (i32::MIN, true),
        }
    }

    /// As 32 bits for bitwise logic: SINT and INT zero-filled.
    pub(crate) fn zero_filled(self) -> u32 {
        match self.element {
            Element::Sint => self.bits as u32 & 0xFF,
            Element::Int => self.bits as u32 & 0xFFFF,
            Element::Bool | Element::Dint | Element::Real => self.bits as u32,
        }
    }

    /// Converted to a destination's type: the cell's value, and whether it did not fit.
    pub(crate) fn converted(self, element: Element) -> (i32, bool) {
        if element == Element::Real {
            return (real::canonical(self.to_real().to_bits()) as i32, false);
        }
        let (value, unfit) = self.to_dint();
        let kept = low_bits(value, element);
        (kept, unfit || kept != value)
    }
}

/// The low bits of a value, sign-extended from the type's width.
pub(crate) fn low_bits(value: i32, element: Element) -> i32 {
    match element {
        Element::Sint => i32::from(value as i8),
        Element::Int => i32::from(value as i16),
        Element::Bool | Element::Dint | Element::Real => value,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn converted_when_integers_do_not_fit_then_low_bits_and_overflow() {
        let rows = [
            (65665, Element::Int, 129, true),
            (129, Element::Sint, -127, true),
            (-128, Element::Sint, -128, false),
            (32768, Element::Int, -32768, true),
            (-1, Element::Dint, -1, false),
        ];
        for (value, element, stored, overflow) in rows {
            assert_eq!(Value::dint(value).converted(element), (stored, overflow));
        }
    }

    #[test]
    fn converted_when_real_then_half_even_and_the_fixed_value_for_what_no_integer_has() {
        let rows = [
            (2.5, Element::Dint, 2, false),
            (-3.5, Element::Dint, -4, false),
            (300.0, Element::Sint, 44, true),
            (4_294_967_296.0, Element::Dint, 0, true),
            (3e9, Element::Dint, -1_294_967_296, true),
            (f32::NAN, Element::Dint, i32::MIN, true),
            (f32::INFINITY, Element::Int, 0, true),
            (1e30, Element::Dint, i32::MIN, true),
        ];
        for (value, element, stored, overflow) in rows {
            assert_eq!(Value::real(value).converted(element), (stored, overflow), "{value}");
        }
    }

    #[test]
    fn converted_when_dint_to_real_then_nearest_even() {
        assert_eq!(Value::dint(16_777_217).converted(Element::Real).0, 16_777_216.0f32.to_bits() as i32);
    }

    #[test]
    fn zero_filled_when_sint_is_negative_then_upper_bits_are_clear() {
        assert_eq!(Value { element: Element::Sint, bits: -1 }.zero_filled(), 0xFF);
    }
}
