//! Records to canonical text: what people read, what the application signature covers, and what the verifier compares
//! with the text that an image carries.
//!
//! One text for one meaning: names as declared, the exporter's blanks, integers in their radix with lower-case digits,
//! REAL in its shortest form, choice words in the catalog's first spelling, symbols without blanks (`a+b*2`), word
//! operators with one on either side (`a AND b`), the fewest parentheses.

mod declaration;
mod expression;
mod number;
mod operand;
mod rung;
mod value;

use alloc::string::String;

pub use declaration::{
    type_name, write_add_on, write_controller, write_map, write_module, write_program, write_tags, write_task,
    write_type,
};
pub use number::{write_integer, write_real, write_real_data};
pub use operand::Stop;
pub use rung::write_routine;

pub(crate) use operand::decode;
pub(crate) use rung::code_error;

use crate::error::ImageError;
use crate::image::Image;
use crate::index::{OperandIndex, RoutineIndex};
use twinrung_catalog::OperandKind;

/// The canonical text of a routine: one rung per line, each ending in `;` and a line feed.
///
/// # Errors
///
/// The code or an operand of it has no text.
pub fn render_routine(image: &Image, routine: RoutineIndex) -> Result<String, ImageError> {
    rendered(|out| write_routine(image, routine, out))
}

/// The canonical text of an operand where an instruction declares `kind`; `None` for arguments, subscripts and tags.
///
/// # Errors
///
/// The operand has no text there.
pub fn render_operand(image: &Image, operand: OperandIndex, kind: Option<OperandKind>) -> Result<String, ImageError> {
    rendered(|out| operand::OperandWriter::new(image).write(operand, kind, out))
}

/// A routine's full name: `Program/Routine`, or `AddOn/Logic`.
pub fn routine_name(image: &Image, routine: RoutineIndex) -> String {
    image.routines.get(routine.position()).map_or_else(String::new, |record| {
        let mut name = String::from(rung::owner_name(image, record));
        name.push('/');
        name.push_str(&record.name);
        name
    })
}

fn rendered(write: impl FnOnce(&mut String) -> Result<(), Stop>) -> Result<String, ImageError> {
    let mut text = String::new();
    match write(&mut text) {
        // A string takes whatever is written to it.
        Ok(()) | Err(Stop::Writer) => Ok(text),
        Err(Stop::Image(error)) => Err(error),
    }
}
