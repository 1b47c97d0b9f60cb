//! An image that the verifier has admitted.

use alloc::vec::Vec;

use crate::image::Image;
use crate::layout::TypeLayout;

/// An image whose every byte has been verified: its records agree with each other, every cell, operand, jump and call
/// is in bounds, and its code decompiles to the text it carries. Only the verifier makes one.
#[derive(Debug, Clone)]
pub struct AdmittedImage {
    pub(crate) image: Image,
    pub(crate) layouts: Vec<TypeLayout>,
}

impl AdmittedImage {
    /// The records.
    pub fn image(&self) -> &Image {
        &self.image
    }

    /// The layouts of the types, in their order.
    pub fn layouts(&self) -> &[TypeLayout] {
        &self.layouts
    }
}
