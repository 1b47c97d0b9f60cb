//! The loader's verifier: from bytes that nobody vouches for to an image that can be run.
//!
//! It reads like the specification: passes in a fixed order, one check and one [`ImageError`] for each rule, each pass
//! linear in what it reads. What a pass has shown the later ones use.
//!
//! 1. The file has the form of [`crate::container`]; the image signature is that of its bytes.
//! 2. Declarations: names and their order, controller, types and layouts, Add-On Instructions, routines, tags and their
//!    cells, initial values, aliases, tag map, system values, task.
//! 3. The application signature is that of the declarations and texts.
//! 4. Operands, each by itself: canonical bytes, earlier operands only, the access that the path gives.
//! 5. Code: the structure of every rung, and every routine's text byte for byte; then every instruction against the
//!    catalog, what it writes, backing tags, labels; then subroutines, and how much one scan can execute.

mod add_on;
mod calls;
mod code;
mod connections;
mod data;
mod declarations;
mod expression;
mod instruction;
mod operands;
mod place;
mod state;
mod tables;
mod tags;
mod text;
mod types;

use crate::admitted::AdmittedImage;
use crate::container::{self, ReadImage};
use crate::error::ImageError;
use crate::layout;
use crate::signature;
use tables::Tables;

/// Reads and verifies an application.
///
/// # Errors
///
/// The first rule that the image breaks.
pub fn admit(bytes: &[u8]) -> Result<AdmittedImage, ImageError> {
    admit_read(container::read(bytes)?)
}

/// Verifies an application that has been read.
///
/// # Errors
///
/// The first rule that the image breaks.
pub fn admit_read(read: ReadImage) -> Result<AdmittedImage, ImageError> {
    verify(read, false)
}

/// Reads and verifies a library: Add-On Instructions and their types, no task, programs or tags. It may leave the
/// controller open, and may then hold every instruction.
///
/// # Errors
///
/// The first rule that the image breaks.
pub fn admit_library(bytes: &[u8]) -> Result<AdmittedImage, ImageError> {
    verify(container::read(bytes)?, true)
}

fn verify(read: ReadImage, library: bool) -> Result<AdmittedImage, ImageError> {
    if read.image_signature() != read.carried.image {
        return Err(ImageError::ImageSignature);
    }
    let ReadImage { image, carried, .. } = read;
    declarations::check_all_names(&image)?;
    let controller = declarations::check_controller(&image.controller, library)?;
    if library {
        declarations::check_library(&image)?;
    } else {
        declarations::check_task(&image)?;
    }
    declarations::check_routines(&image)?;
    let hidden = tags::check_tag_names(&image)?;
    let mapped = declarations::check_map(&image)?;
    declarations::check_system_values(&image, controller)?;
    let layouts = layout::layouts(&image.types).map_err(|why| ImageError::Layout { why })?;
    let predefined = tables::predefined(&image);
    let tables = Tables { image: &image, layouts: &layouts, controller, predefined, mapped, hidden };
    types::check_types(&tables)?;
    types::check_add_ons(&tables)?;
    tags::check_cells(&tables)?;
    tags::check_initial(&tables)?;
    let aliases = tags::check_aliases(&tables)?;
    let leaves = signature::leaves_with(&image, &layouts)?;
    if signature::application_signature(&leaves) != carried.application {
        return Err(ImageError::ApplicationSignature);
    }
    let entries = operands::check_operands(&tables, &aliases)?;
    let code::Code { rungs, writes, written_by_others } = code::check_code(&tables, &entries)?;
    let (published, frozen) = connections::connections(&image, &layouts);
    Ok(AdmittedImage { image, layouts, signatures: carried, rungs, published, frozen, writes, written_by_others })
}
