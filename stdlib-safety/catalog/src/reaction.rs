//! How long safety I/O modules take from terminal to network and back, and the default times of safety connections.

/// The reaction time of a module, without filters that a project sets.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ModuleReaction {
    /// Catalogue number without a series letter.
    pub catalog_number: &'static str,
    /// Terminal to network, µs, at most; nothing where the module has no safety inputs, or no source tells it.
    pub input_us: Option<u64>,
    /// Network to terminal, µs, at most; nothing where the module has no safety outputs, or no source tells it.
    pub output_us: Option<u64>,
}

/// The modules of which a source tells it. 1734-UM013 Appendix C: series A and B are alike. Of the analog module the manual
/// gives the scan (at most 6 ms) and the step response of the filter, no reaction time: none is made up here.
pub static MODULE_REACTIONS: &[ModuleReaction] = &[
    ModuleReaction { catalog_number: "1734-IB8S", input_us: Some(16_200), output_us: None },
    ModuleReaction { catalog_number: "1734-OB8S", input_us: None, output_us: Some(6_200) },
];

/// The reaction time of a module; case and a series letter make no difference.
pub fn of_module(catalog_number: &str) -> Option<&'static ModuleReaction> {
    let number = crate::modules::without_series(catalog_number);
    MODULE_REACTIONS.iter().find(|known| known.catalog_number.eq_ignore_ascii_case(number))
}

/// The timeout multiplier of a connection that does not set one. 1734-UM013, Configure Safety Connections.
pub const TIMEOUT_MULTIPLIER: u32 = 2;
/// The network delay multiplier of a connection that does not set one, percent. 1734-UM013, Configure Safety Connections.
pub const NETWORK_DELAY_MULTIPLIER: u32 = 200;
/// The requested packet interval of an input connection that does not set one, µs. 1734-UM013 shows 10 ms in each of its
/// examples (decided).
pub const INPUT_RPI_US: u64 = 10_000;
