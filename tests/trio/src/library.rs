//! What the judge executes of the safety library.

use std::sync::OnceLock;

use twinrung_compiler::{CheckedProject, check_library};

/// The ladder half of the safety library as a checked tree, made once.
pub fn library() -> &'static CheckedProject {
    static LIBRARY: OnceLock<CheckedProject> = OnceLock::new();
    LIBRARY.get_or_init(|| {
        check_library(twinrung_safety_partner::SOURCES)
            .unwrap_or_else(|error| panic!("the ladder library is refused: {error}"))
    })
}
