//! How a value stands in a section: one trait for both directions, so that writing and reading cannot drift apart.

use alloc::string::String;
use alloc::vec::Vec;

use super::cursor::Cursor;
use crate::error::ImageError;

/// A value with exactly one byte form.
pub(super) trait Field: Sized {
    /// Fewest bytes that one takes: bounds what a count may promise before anything is allocated.
    const LEAST_BYTES: usize;

    /// Appends the bytes.
    fn write(&self, out: &mut Vec<u8>);

    /// Reads the bytes.
    fn read(from: &mut Cursor<'_>) -> Result<Self, ImageError>;

    /// Appends many.
    fn write_all(values: &[Self], out: &mut Vec<u8>) {
        for value in values {
            value.write(out);
        }
    }

    /// Reads many; the count has been checked.
    fn read_all(count: usize, from: &mut Cursor<'_>) -> Result<Vec<Self>, ImageError> {
        let mut values = Vec::with_capacity(count);
        for _ in 0..count {
            values.push(Self::read(from)?);
        }
        Ok(values)
    }
}

/// A value of which a table has at most so many.
pub(super) trait Listed: Field {
    /// The bound, out of [`crate::limits`].
    const LIMIT: usize;
}

impl Field for u8 {
    const LEAST_BYTES: usize = 1;

    fn write(&self, out: &mut Vec<u8>) {
        out.push(*self);
    }

    fn read(from: &mut Cursor<'_>) -> Result<u8, ImageError> {
        let [byte] = from.array()?;
        Ok(byte)
    }

    fn write_all(values: &[u8], out: &mut Vec<u8>) {
        out.extend_from_slice(values);
    }

    fn read_all(count: usize, from: &mut Cursor<'_>) -> Result<Vec<u8>, ImageError> {
        Ok(from.take(count)?.to_vec())
    }
}

macro_rules! number {
    ($($type:ty),*) => {$(
        impl Field for $type {
            const LEAST_BYTES: usize = size_of::<$type>();

            fn write(&self, out: &mut Vec<u8>) {
                out.extend_from_slice(&self.to_le_bytes());
            }

            fn read(from: &mut Cursor<'_>) -> Result<$type, ImageError> {
                Ok(<$type>::from_le_bytes(from.array()?))
            }
        }
    )*};
}

number!(u16, u32, i32);

impl Field for [u32; 3] {
    const LEAST_BYTES: usize = 12;

    fn write(&self, out: &mut Vec<u8>) {
        u32::write_all(self, out);
    }

    fn read(from: &mut Cursor<'_>) -> Result<[u32; 3], ImageError> {
        Ok([u32::read(from)?, u32::read(from)?, u32::read(from)?])
    }
}

impl Field for bool {
    const LEAST_BYTES: usize = 1;

    fn write(&self, out: &mut Vec<u8>) {
        out.push(u8::from(*self));
    }

    fn read(from: &mut Cursor<'_>) -> Result<bool, ImageError> {
        let offset = from.offset();
        match u8::read(from)? {
            0 => Ok(false),
            1 => Ok(true),
            _ => Err(ImageError::NotABoolean { offset }),
        }
    }
}

impl Field for String {
    const LEAST_BYTES: usize = 4;

    fn write(&self, out: &mut Vec<u8>) {
        write_count(self.len(), out);
        out.extend_from_slice(self.as_bytes());
    }

    fn read(from: &mut Cursor<'_>) -> Result<String, ImageError> {
        let count = u32::read(from)? as usize;
        let offset = from.offset();
        let text = core::str::from_utf8(from.take(count)?).map_err(|_| ImageError::NotText { offset })?;
        Ok(String::from(text))
    }
}

impl<T: Field> Field for Option<T> {
    const LEAST_BYTES: usize = 1;

    fn write(&self, out: &mut Vec<u8>) {
        self.is_some().write(out);
        if let Some(value) = self {
            value.write(out);
        }
    }

    fn read(from: &mut Cursor<'_>) -> Result<Option<T>, ImageError> {
        Ok(if bool::read(from)? { Some(T::read(from)?) } else { None })
    }
}

impl<A: Field, B: Field> Field for (A, B) {
    const LEAST_BYTES: usize = A::LEAST_BYTES.saturating_add(B::LEAST_BYTES);

    fn write(&self, out: &mut Vec<u8>) {
        self.0.write(out);
        self.1.write(out);
    }

    fn read(from: &mut Cursor<'_>) -> Result<(A, B), ImageError> {
        Ok((A::read(from)?, B::read(from)?))
    }
}

impl<T: Listed> Field for Vec<T> {
    const LEAST_BYTES: usize = 4;

    fn write(&self, out: &mut Vec<u8>) {
        write_count(self.len(), out);
        T::write_all(self, out);
    }

    fn read(from: &mut Cursor<'_>) -> Result<Vec<T>, ImageError> {
        let count = read_count::<T>(T::LIMIT, from)?;
        T::read_all(count, from)
    }
}

/// A count that no memory can hold becomes one that no reader accepts.
pub(super) fn write_count(count: usize, out: &mut Vec<u8>) {
    u32::try_from(count).unwrap_or(u32::MAX).write(out);
}

/// A count that is within its limit and within the bytes that are left.
pub(super) fn read_count<T: Field>(limit: usize, from: &mut Cursor<'_>) -> Result<usize, ImageError> {
    let offset = from.offset();
    let count = u32::read(from)? as usize;
    if count > limit {
        return Err(ImageError::TooMany { offset, count, limit });
    }
    if count.saturating_mul(T::LEAST_BYTES) > from.remaining() {
        return Err(ImageError::Truncated { offset });
    }
    Ok(count)
}
