//! What completes a partial export.

use twinrung_grammar::tree::File;

/// What the command line says beside the file. A whole project needs none of it.
#[derive(Debug, Clone, Default)]
pub struct Completion {
    /// Catalogue number of the controller; goes before what the file says.
    pub controller: Option<String>,
    /// Major revision; goes before what the file says.
    pub revision: Option<u16>,
    /// Period of the safety task in ms, for a file without one.
    pub period_ms: Option<u32>,
    /// Watchdog of the safety task in ms, for a file without one; the period when it is missing.
    pub watchdog_ms: Option<u32>,
    /// Files that declare what the file refers to: types, tags, modules, Add-On Instructions. They were read into the
    /// same [`twinrung_grammar::tree::Sources`].
    pub contexts: Vec<File>,
    /// Names of the tags to publish instead of output modules and produced tags.
    pub outputs: Vec<String>,
}
