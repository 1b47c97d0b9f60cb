//! What fault injection reaches of a memory: every bit of it can be read and turned round. Nothing of this is called in
//! a scan, and none of it exists without the feature `injection`.
//!
//! Each type of a memory lists its fields once, beside its declaration, by [`bits!`](crate::bits): a field that is
//! forgotten there does not compile. Safe Rust cannot hold every pattern of bits: a flip that gives no value changes
//! nothing and says so.

/// Lists what a type is made of: the fields of a structure, the variants of an enumeration, or (`coded`) that it has a
/// form of its own, [`Coded`](crate::injection::Coded). Without the feature `injection` it leaves nothing.
#[cfg(feature = "injection")]
#[macro_export]
macro_rules! bits {
    (enum $name:ident { $first:ident $(, $variant:ident)* $(,)? }) => {
        impl $name {
            const LISTED: &[$name] = &[$name::$first $(, $name::$variant)*];
        }

        impl $crate::injection::Bits for $name {
            fn zero() -> Self {
                // Does not compile where a variant is not listed.
                let ($name::$first $(| $name::$variant)*) = $name::$first;
                $name::$first
            }

            fn count(&self) -> u32 {
                $crate::injection::width(Self::LISTED.len())
            }

            fn bit(&self, bit: u32) -> bool {
                $crate::injection::place(Self::LISTED, self).bit(bit)
            }

            fn flip(&mut self, bit: u32) -> bool {
                let mut place = $crate::injection::place(Self::LISTED, self);
                let turned = bit < self.count() && place.flip(bit);
                match Self::LISTED.get(place as usize).filter(|_| turned) {
                    Some(other) => {
                        *self = *other;
                        true
                    }
                    None => false,
                }
            }
        }
    };
    (coded $name:ty) => {
        impl $crate::injection::Bits for $name {
            fn zero() -> Self {
                let code = <<$name as $crate::injection::Coded>::Code as $crate::injection::Bits>::zero();
                <$name as $crate::injection::Coded>::of(code).unwrap_or(<$name as $crate::injection::Coded>::FIRST)
            }

            fn count(&self) -> u32 {
                $crate::injection::Coded::code(self).count()
            }

            fn bit(&self, bit: u32) -> bool {
                $crate::injection::Coded::code(self).bit(bit)
            }

            fn flip(&mut self, bit: u32) -> bool {
                let mut code = $crate::injection::Coded::code(self);
                let turned = code.flip(bit);
                match <$name as $crate::injection::Coded>::of(code).filter(|other| turned && other != self) {
                    Some(other) => {
                        *self = other;
                        true
                    }
                    None => false,
                }
            }
        }
    };
    ($name:ident $(<$generic:ident $(: $bound:path)?> where ($($bounded:ty),*))? { $($field:ident),* $(,)? }) => {
        impl$(<$generic $(: $bound)?>)? $crate::injection::Bits for $name$(<$generic>)?
        $(where $($bounded: $crate::injection::Bits),*)?
        {
            fn zero() -> Self {
                Self { $($field: $crate::injection::Bits::zero()),* }
            }

            fn count(&self) -> u32 {
                let Self { $($field),* } = self;
                0u32 $(.saturating_add($crate::injection::Bits::count($field)))*
            }

            fn bit(&self, bit: u32) -> bool {
                let Self { $($field),* } = self;
                let mut rest = Some(bit);
                false $(|| $crate::injection::within(&mut rest, $field).is_some_and(|bit| $field.bit(bit)))*
            }

            fn flip(&mut self, bit: u32) -> bool {
                let Self { $($field),* } = self;
                let mut rest = Some(bit);
                false $(|| $crate::injection::within(&mut rest, &*$field).is_some_and(|bit| $field.flip(bit)))*
            }
        }
    };
}

/// Without fault injection nothing is listed.
#[cfg(not(feature = "injection"))]
#[macro_export]
macro_rules! bits {
    ($($listed:tt)*) => {};
}

#[cfg(feature = "injection")]
pub use enabled::{Bits, Coded, Few, place, width, within};

#[cfg(feature = "injection")]
mod enabled {
    use twinrung_catalog::{Element, Opcode};

    /// A value whose bits can be read and turned round. All values of a type have equally many.
    pub trait Bits: Sized {
        /// The value of which every bit is 0, or the nearest to it.
        fn zero() -> Self;

        /// How many bits.
        fn count(&self) -> u32;

        /// One of them, counted from 0.
        fn bit(&self, bit: u32) -> bool;

        /// Turns one round; false, and nothing is changed, where there is no such value.
        fn flip(&mut self, bit: u32) -> bool;
    }

    /// An enumeration whose variants hold something: a number for the variant, and room for what any of them holds.
    pub trait Coded: Copy + PartialEq {
        /// Its form.
        type Code: Bits;
        /// The variant with the number 0.
        const FIRST: Self;
        /// The value in that form.
        fn code(&self) -> Self::Code;
        /// The value of a form; `None` where there is none.
        fn of(code: Self::Code) -> Option<Self>;
    }

    /// A number of so many bits.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub struct Few<const BITS: u32>(pub u32);

    impl<const BITS: u32> Bits for Few<BITS> {
        fn zero() -> Self {
            Few(0)
        }

        fn count(&self) -> u32 {
            BITS
        }

        fn bit(&self, bit: u32) -> bool {
            self.0.bit(bit)
        }

        fn flip(&mut self, bit: u32) -> bool {
            bit < BITS && self.0.flip(bit)
        }
    }

    /// Bits that so many variants need.
    pub fn width(variants: usize) -> u32 {
        usize::BITS.saturating_sub(variants.saturating_sub(1).leading_zeros())
    }

    /// Where a variant is listed.
    pub fn place<T: PartialEq>(listed: &[T], variant: &T) -> u32 {
        listed.iter().position(|other| other == variant).unwrap_or(0) as u32
    }

    /// The bit of this part that is meant, if it is in this part; otherwise what is left of the way.
    pub fn within<T: Bits>(rest: &mut Option<u32>, part: &T) -> Option<u32> {
        let bit = (*rest)?;
        let behind = bit.checked_sub(part.count());
        *rest = behind;
        if behind.is_none() { Some(bit) } else { None }
    }

    macro_rules! integers {
        ($($integer:ty),*) => {$(
            impl Bits for $integer {
                fn zero() -> Self {
                    0
                }

                fn count(&self) -> u32 {
                    <$integer>::BITS
                }

                fn bit(&self, bit: u32) -> bool {
                    self.checked_shr(bit).is_some_and(|shifted| shifted & 1 == 1)
                }

                fn flip(&mut self, bit: u32) -> bool {
                    let mask: Option<$integer> = (1 as $integer).checked_shl(bit);
                    *self ^= mask.unwrap_or_default();
                    mask.is_some()
                }
            }
        )*};
    }

    integers!(u8, u16, u32, u64, usize, i32, i64);

    impl Bits for bool {
        fn zero() -> Self {
            false
        }

        fn count(&self) -> u32 {
            1
        }

        fn bit(&self, _bit: u32) -> bool {
            *self
        }

        fn flip(&mut self, _bit: u32) -> bool {
            *self = !*self;
            true
        }
    }

    impl Bits for f32 {
        fn zero() -> Self {
            0.0
        }

        fn count(&self) -> u32 {
            u32::BITS
        }

        fn bit(&self, bit: u32) -> bool {
            self.to_bits().bit(bit)
        }

        fn flip(&mut self, bit: u32) -> bool {
            let mut bits = self.to_bits();
            let done = bits.flip(bit);
            *self = f32::from_bits(bits);
            done
        }
    }

    /// A bit that says whether there is a value, then the value's.
    impl<T: Bits> Bits for Option<T> {
        fn zero() -> Self {
            None
        }

        fn count(&self) -> u32 {
            T::zero().count().saturating_add(1)
        }

        fn bit(&self, bit: u32) -> bool {
            match (bit.checked_sub(1), self) {
                (None, value) => value.is_some(),
                (Some(bit), Some(value)) => value.bit(bit),
                (Some(_), None) => false,
            }
        }

        fn flip(&mut self, bit: u32) -> bool {
            match (bit.checked_sub(1), &mut *self) {
                (None, Some(_)) => *self = None,
                (None, None) => *self = Some(T::zero()),
                (Some(bit), Some(value)) => return value.flip(bit),
                (Some(_), None) => return false,
            }
            true
        }
    }

    impl<T: Bits, const N: usize> Bits for [T; N] {
        fn zero() -> Self {
            core::array::from_fn(|_| T::zero())
        }

        fn count(&self) -> u32 {
            T::zero().count().saturating_mul(N as u32)
        }

        fn bit(&self, bit: u32) -> bool {
            let mut rest = Some(bit);
            self.iter().any(|part| within(&mut rest, part).is_some_and(|bit| part.bit(bit)))
        }

        fn flip(&mut self, bit: u32) -> bool {
            let mut rest = Some(bit);
            self.iter_mut().any(|part| within(&mut rest, &*part).is_some_and(|bit| part.flip(bit)))
        }
    }

    macro_rules! tuples {
        ($(($($part:ident),+))*) => {$(
            #[allow(non_snake_case, reason = "a part is named as its type")]
            impl<$($part: Bits),+> Bits for ($($part,)+) {
                fn zero() -> Self {
                    ($($part::zero(),)+)
                }

                fn count(&self) -> u32 {
                    let ($($part,)+) = self;
                    0u32 $(.saturating_add($part.count()))+
                }

                fn bit(&self, bit: u32) -> bool {
                    let ($($part,)+) = self;
                    let mut rest = Some(bit);
                    false $(|| within(&mut rest, $part).is_some_and(|bit| $part.bit(bit)))+
                }

                fn flip(&mut self, bit: u32) -> bool {
                    let ($($part,)+) = self;
                    let mut rest = Some(bit);
                    false $(|| within(&mut rest, &*$part).is_some_and(|bit| $part.flip(bit)))+
                }
            }
        )*};
    }

    tuples! { (A, B) (A, B, C) (A, B, C, D) (A, B, C, D, E) }

    impl Bits for Opcode {
        fn zero() -> Self {
            Opcode::Xic
        }

        fn count(&self) -> u32 {
            u8::BITS
        }

        fn bit(&self, bit: u32) -> bool {
            (*self as u8).bit(bit)
        }

        fn flip(&mut self, bit: u32) -> bool {
            let mut number = *self as u8;
            let other = if number.flip(bit) { Opcode::from_number(number) } else { None };
            *self = other.unwrap_or(*self);
            other.is_some()
        }
    }

    impl Bits for Element {
        fn zero() -> Self {
            Element::Bool
        }

        fn count(&self) -> u32 {
            width(Element::ALL.len())
        }

        fn bit(&self, bit: u32) -> bool {
            (*self as u8).bit(bit)
        }

        fn flip(&mut self, bit: u32) -> bool {
            let mut number = *self as u8;
            let turned = bit < self.count() && number.flip(bit);
            let other = Element::ALL.into_iter().find(|other| turned && *other as u8 == number);
            *self = other.unwrap_or(*self);
            other.is_some()
        }
    }
}
