//! The proof that code says what its text says.

use core::fmt::{self, Write};

use crate::error::ImageError;
use crate::image::{Image, RoutineRecord};
use crate::index::RoutineIndex;
use crate::text::{self, Stop};

/// Takes what is written only as long as it is the text that is expected.
struct Comparison<'a> {
    rest: &'a [u8],
    offset: usize,
}

impl Write for Comparison<'_> {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        self.rest = self.rest.strip_prefix(text.as_bytes()).ok_or(fmt::Error)?;
        self.offset = self.offset.saturating_add(text.len());
        Ok(())
    }
}

/// The code of a routine decompiles to its text, byte for byte. Stops at the first difference, so that the work is
/// bounded by the text.
pub(super) fn check_text(image: &Image, routine: RoutineIndex, record: &RoutineRecord) -> Result<(), ImageError> {
    let mut comparison = Comparison { rest: record.text.as_bytes(), offset: 0 };
    match text::write_routine(image, routine, &mut comparison) {
        Ok(()) if comparison.rest.is_empty() => Ok(()),
        Ok(()) | Err(Stop::Writer) => Err(ImageError::TextDiffers { routine, offset: comparison.offset }),
        Err(Stop::Image(error)) => Err(error),
    }
}
