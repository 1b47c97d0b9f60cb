//! What the controller admits.

use twinrung_catalog::Controller;
use twinrung_grammar::tree::Span;

/// A controller and its revision.
#[derive(Debug, Clone, Copy)]
pub struct Profile {
    /// The controller.
    pub controller: &'static Controller,
    /// Major revision.
    pub revision: u16,
    /// Where it is declared.
    pub span: Span,
}

impl Profile {
    /// Whether safety data may be REAL.
    pub fn has_real(&self) -> bool {
        self.controller.has_real()
    }

    /// As people write it: `1756-L73S, revision 20`.
    pub fn display(&self) -> String {
        format!("{}, revision {}", self.controller.catalog_number, self.revision)
    }
}
