//! Modules.

use twinrung_grammar::tree::{CompactString, Span};

/// A module of the I/O tree.
#[derive(Debug, Clone)]
pub struct Module {
    /// Its name.
    pub name: CompactString,
    /// Where it is declared.
    pub span: Span,
    /// Catalogue number, where it is known.
    pub catalog_number: CompactString,
    /// Whether it carries safety data.
    pub safety: bool,
    /// The module that it is attached to.
    pub parent: CompactString,
    /// Slot in the parent's chassis or rack.
    pub slot: Option<u32>,
    /// Safety network number as written.
    pub safety_network: Option<(CompactString, Span)>,
    /// The canonical declaration, for the signature.
    pub text: String,
}
