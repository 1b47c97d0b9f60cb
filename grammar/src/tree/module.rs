//! I/O modules.

use super::{Attribute, CompactString, Data, ExternalAccess, Name, Span, Spanned, Text, Trivia, Usage, Value};

/// A `MODULE`.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Module {
    /// The module's name; the safety partner is `<controller>:Partner`.
    pub name: Name,
    /// Whether this comes along as context of a partial export, or is what was exported.
    pub usage: Usage,
    /// Catalogue number, `1734-IB8S`.
    pub catalog_number: Option<Text>,
    /// CIP vendor number.
    pub vendor: Option<Spanned<u32>>,
    /// CIP product type.
    pub product_type: Option<Spanned<u32>>,
    /// CIP product code.
    pub product_code: Option<Spanned<u32>>,
    /// Major revision.
    pub major: Option<Spanned<u32>>,
    /// Minor revision.
    pub minor: Option<Spanned<u32>>,
    /// The module that this one is attached to.
    pub parent: Option<Name>,
    /// The port of the parent.
    pub parent_port: Option<Spanned<u32>>,
    /// Slot in the parent's chassis or rack: `Slot`, or the address of a port that is not Ethernet.
    pub slot: Option<Spanned<u32>>,
    /// Network address: `IPAddress`, `NodeAddress`, or the address of an Ethernet port.
    pub address: Option<Text>,
    /// Safety network number, `16#0000_41b4_02bb_cb7e`, as written. (On newer controllers it is on
    /// the ports.)
    pub safety_network: Option<Text>,
    /// `SafetyEnabled`.
    pub safety_enabled: Option<Spanned<bool>>,
    /// Connections are not made.
    pub inhibited: Option<Spanned<bool>>,
    /// `RPI` of the module as a whole, µs (`.rll`; exports have it on each connection).
    pub rpi_us: Option<Spanned<u64>>,
    /// Electronic keying: `ExactMatch`, `CompatibleModule`, `Disabled`, `Custom`.
    pub electronic_key: Option<Name>,
    /// `POINT` and `TEST` entries (`.rll`).
    pub points: Vec<Point>,
    /// Ports.
    pub ports: Vec<Port>,
    /// Connections.
    pub connections: Vec<Connection>,
    /// The module's configuration tag.
    pub configuration: Option<Box<ModuleTag>>,
    /// Configuration that the export holds but does not disclose.
    pub opaque: Vec<OpaqueData>,
    /// For people.
    pub description: Option<Box<Text>>,
    /// Everything else.
    pub attributes: Vec<Attribute>,
    /// Comments of the source around it.
    pub trivia: Trivia,
    /// The whole declaration.
    pub span: Span,
}

impl Module {
    /// The safety network number: its own, or that of the port to the parent, where newer controllers have it.
    pub fn network_number(&self) -> Option<&Text> {
        self.safety_network.as_ref().or_else(|| self.ports.iter().find_map(|port| port.safety_network.as_ref()))
    }
}

/// `POINT I00 (Mode := SAFETY_PULSE_TEST, ...)`. The catalogue knows which keys and words there are.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Point {
    /// A point of safety data, or a test output.
    pub kind: PointKind,
    /// `I00`, `O03`, `T1`.
    pub name: Name,
    /// What is set.
    pub attributes: Vec<Attribute>,
    /// Comments of the source around it.
    pub trivia: Trivia,
    /// The whole entry.
    pub span: Span,
}

/// Which of the two kinds of entry.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum PointKind {
    /// `POINT`: a safety input or output.
    Point,
    /// `TEST`: a test output.
    Test,
}

/// A port of a module.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Port {
    /// Port number.
    pub id: Option<Spanned<u32>>,
    /// Slot, node or IP address, as written.
    pub address: Option<Text>,
    /// `ICP`, `Ethernet`, `PointIO`, ...
    pub port_type: Option<Text>,
    /// Whether it leads to the parent.
    pub upstream: Option<Spanned<bool>>,
    /// Safety network number, as written.
    pub safety_network: Option<Text>,
    /// Everything else.
    pub attributes: Vec<Attribute>,
    /// The whole element.
    pub span: Span,
}

/// A `CONNECTION` of a module. Times in microseconds.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Connection {
    /// The connection's name.
    pub name: Name,
    /// `Input`, `Output`, `SafetyInput`, `SafetyOutput`, ...
    pub connection_type: Option<Text>,
    /// Requested packet interval, µs.
    pub rpi_us: Option<Spanned<u64>>,
    /// Timeout multiplier.
    pub timeout_multiplier: Option<Spanned<u32>>,
    /// Network delay multiplier, percent.
    pub network_delay_multiplier: Option<Spanned<u32>>,
    /// Connection reaction time limit, µs.
    pub reaction_time_limit_us: Option<Spanned<u64>>,
    /// Whether the connection is unicast.
    pub unicast: Option<Spanned<bool>>,
    /// The input tag, its [`ModuleTag::suffix`] after the colon of the module tag.
    pub input: Option<Box<ModuleTag>>,
    /// The output tag.
    pub output: Option<Box<ModuleTag>>,
    /// Everything else.
    pub attributes: Vec<Attribute>,
    /// Comments of the source around it.
    pub trivia: Trivia,
    /// The whole declaration.
    pub span: Span,
}

/// A tag that a module brings: `Module:I`, `Module:O`, `Module:C`.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct ModuleTag {
    /// What follows the module's name and slot: `I`, `O`, `C`, `SI`, `SO`, `I1`.
    pub suffix: CompactString,
    /// The type, where the export names it.
    pub data_type: Option<Name>,
    /// Data in each form.
    pub data: Vec<Data>,
    /// Forces in each form.
    pub forces: Vec<Data>,
    /// External access.
    pub external_access: Option<Spanned<ExternalAccess>>,
    /// The whole element.
    pub span: Span,
}

/// Data that is in the file and that nobody outside the maker can read: "not visible in this
/// export", never a pass.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct OpaqueData {
    /// `ConfigData`, `ConfigScript`, `SafetyScript`, `ExtendedProperties`, ...
    pub kind: Name,
    /// The data, for the signature.
    pub value: Value,
    /// The whole element.
    pub span: Span,
}
