//! The loader's verifier: from bytes that nobody vouches for to an image that can be run.

mod connections;

use alloc::vec::Vec;

use crate::admitted::{AdmittedImage, CellSet};
use crate::code::{Mark, Marks};
use crate::container::{self, ReadImage};
use crate::error::ImageError;
use crate::image::Image;
use crate::index::RoutineIndex;
use crate::layout;
use crate::signature;

/// Reads and verifies an image.
///
/// # Errors
///
/// The first rule that the image breaks.
pub fn admit(bytes: &[u8]) -> Result<AdmittedImage, ImageError> {
    admit_read(container::read(bytes)?)
}

/// Verifies an image that has been read.
///
/// # Errors
///
/// The first rule that the image breaks.
pub fn admit_read(read: ReadImage) -> Result<AdmittedImage, ImageError> {
    let ReadImage { image, carried, body } = read;
    if signature::image_signature(&carried.application, &body) != carried.image {
        return Err(ImageError::ImageSignature);
    }
    let layouts = layout::layouts(&image.types).map_err(|why| ImageError::Layout { why })?;
    let leaves = signature::leaves_with(&image, &layouts)?;
    if signature::application_signature(&leaves) != carried.application {
        return Err(ImageError::ApplicationSignature);
    }
    let rungs = rung_counts(&image)?;
    let (published, frozen) = connections::connections(&image, &layouts);
    let writes = CellSet::default();
    Ok(AdmittedImage { image, layouts, signatures: carried, rungs, published, frozen, writes })
}

fn rung_counts(image: &Image) -> Result<Vec<u32>, ImageError> {
    let mut counts = Vec::with_capacity(image.routines.len());
    for (index, routine) in image.routines.iter().enumerate() {
        let mut count = 0u32;
        for mark in Marks::new(&routine.code) {
            let mark = mark.map_err(|error| crate::text::code_error(RoutineIndex(index as u32), error))?;
            count = count.saturating_add(u32::from(mark == Mark::EndRung));
        }
        counts.push(count);
    }
    Ok(counts)
}
