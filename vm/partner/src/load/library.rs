//! The ladder of the safety application instructions as the partner's half of the library carries it.

use alloc::string::ToString;
use alloc::vec::Vec;

use twinrung_bytecode::image::Image;
use twinrung_bytecode::layout::{TypeLayout, layouts};

use super::{LoadError, Unit};

/// The records of the library and the layouts of their types.
#[derive(Debug)]
pub(crate) struct Library {
    image: Image,
    layouts: Vec<TypeLayout>,
}

impl Library {
    /// Reads a library that was verified when it was built. Verifying it takes longer than all other loading of a small
    /// application; that the bytes still have the image signature which was admitted then says the same.
    pub(crate) fn read(bytes: &[u8], admitted: &[u8; 32]) -> Result<Library, LoadError> {
        let read = twinrung_bytecode::read(bytes).map_err(|error| LoadError::LibraryImage(error.to_string()))?;
        if read.image_signature() != *admitted {
            return Err(LoadError::LibraryImage("its image signature is not the one that was admitted".into()));
        }
        let layouts = layouts(&read.image.types).map_err(|error| LoadError::LibraryImage(error.to_string()))?;
        Ok(Library { image: read.image, layouts })
    }

    /// What the loader takes.
    pub(crate) fn unit(&self) -> Unit<'_> {
        Unit { image: &self.image, layouts: &self.layouts }
    }
}

#[cfg(test)]
mod tests {
    use std::vec::Vec;

    use twinrung_safety_partner::{LIBRARY, SIGNATURE};

    use super::*;

    #[test]
    fn read_when_the_library_is_as_it_was_built_then_its_records_are_those_that_the_verifier_admits() {
        let library = Library::read(LIBRARY, SIGNATURE).unwrap();
        let admitted = twinrung_bytecode::admit_library(LIBRARY).unwrap();
        assert_eq!(library.image, *admitted.image());
        assert_eq!(library.layouts, admitted.layouts());
    }

    #[test]
    fn read_when_a_byte_was_changed_then_the_library_is_refused() {
        let changed = |position: usize| {
            let mut bytes = LIBRARY.to_vec();
            bytes[position] ^= 1;
            Library::read(&bytes, SIGNATURE)
        };
        let accepted: Vec<usize> = (0..LIBRARY.len()).step_by(4099).filter(|place| changed(*place).is_ok()).collect();
        assert!(accepted.is_empty(), "{accepted:?}");
    }

    #[test]
    fn read_when_another_signature_was_admitted_then_the_library_is_refused() {
        let refused = Library::read(LIBRARY, &[0; 32]).unwrap_err();
        assert!(refused.to_string().starts_with("P007"), "{refused}");
    }
}
