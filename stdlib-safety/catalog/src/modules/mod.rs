//! Safety I/O modules: the tags that each connection choice makes, member by member, with the class that the module manual
//! gives each; the assemblies behind them; the points and how they may be set. One file for each family; where a fact is
//! not the manual's, its origin stands beside it. The words for the choices are ours (decided), made from the manuals'
//! menu entries.

mod class;
mod device_net;
mod ethernet;
mod members;
mod point_guard;

pub use class::{class_of_input, is_safety_output, is_status};

use crate::points::Points;
use crate::predefined::Element;

/// Whether safety logic may rely on a member.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MemberClass {
    /// Safety data.
    Safety,
    /// `RunMode` and `ConnectionFaulted`: marked STANDARD, and to be watched all the same.
    ConnectionStatus,
    /// Marked STANDARD: readable, and unqualified.
    Standard,
}

/// A member of a module's tag.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ModuleMember {
    /// Its name.
    pub name: &'static str,
    /// Its type.
    pub element: Element,
    /// Its class.
    pub class: MemberClass,
}

/// The assembly object that a connection carries.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Assembly {
    /// Its instance.
    pub instance: u16,
    /// Its size in bytes.
    pub bytes: u8,
}

/// One choice of a connection menu, and the members that it adds.
#[derive(Debug, PartialEq, Eq)]
pub struct ConnectionChoice {
    /// The word in a MODULE declaration.
    pub word: &'static str,
    /// The assembly; nothing where the choice makes no connection, or where no source tells it.
    pub assembly: Option<Assembly>,
    /// The members that it adds to the tag, in groups, in order.
    pub members: &'static [&'static [ModuleMember]],
}

impl ConnectionChoice {
    /// The members that it adds to the tag, in order.
    pub fn each_member(&self) -> impl Iterator<Item = &'static ModuleMember> + Clone + use<> {
        self.members.iter().copied().flatten()
    }
}

/// How a module may drive its safety outputs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum OutputOperation {
    /// Each output alone, or in pairs. An output alone is good for SIL 2 (1756-RM093 Appendix G).
    SingleOrDual,
    /// Each output alone, or in pairs; SIL 2 and more takes pairs (1756-RM093 Appendix G).
    PairsForSafety,
    /// In pairs only: an output that sources and one that sinks (1791ES-UM001, Configure the Module Outputs).
    PairsOnly,
}

/// A safety I/O module.
#[derive(Debug, PartialEq, Eq)]
pub struct Module {
    /// Catalogue number without a series letter.
    pub catalog_number: &'static str,
    /// What it is.
    pub name: &'static str,
    /// Members that the input tag always has, before those of the chosen `InputStatus`, in groups.
    pub input: &'static [&'static [ModuleMember]],
    /// Choices of `InputStatus`; the first is taken where a declaration names none (decided). Empty where no source tells
    /// the tags of the module.
    pub input_status: &'static [ConnectionChoice],
    /// Choices of `OutputData`; the first is taken where a declaration names none (decided). A choice without members
    /// makes no output tag.
    pub output_data: &'static [ConnectionChoice],
    /// The points that can be set.
    pub points: &'static [&'static Points],
    /// Test outputs that can watch a muting lamp.
    pub muting_lamps: &'static [u32],
    /// Test outputs, from T0, that pulse where a project does not set them.
    pub pulsing_tests: u32,
    /// How it may drive its safety outputs.
    pub output_operation: OutputOperation,
}

const fn member(name: &'static str, element: Element, class: MemberClass) -> ModuleMember {
    ModuleMember { name, element, class }
}

const fn safety(name: &'static str) -> ModuleMember {
    member(name, Element::Bool, MemberClass::Safety)
}

const fn standard(name: &'static str) -> ModuleMember {
    member(name, Element::Bool, MemberClass::Standard)
}

const fn connection(name: &'static str) -> ModuleMember {
    member(name, Element::Bool, MemberClass::ConnectionStatus)
}

const fn analog(name: &'static str) -> ModuleMember {
    member(name, Element::Int, MemberClass::Safety)
}

const fn small(name: &'static str) -> ModuleMember {
    member(name, Element::Sint, MemberClass::Standard)
}

const fn choice(
    word: &'static str,
    instance: u16,
    bytes: u8,
    members: &'static [&'static [ModuleMember]],
) -> ConnectionChoice {
    ConnectionChoice { word, assembly: Some(Assembly { instance, bytes }), members }
}

const fn choice_without_assembly(word: &'static str, members: &'static [&'static [ModuleMember]]) -> ConnectionChoice {
    ConnectionChoice { word, assembly: None, members }
}

/// No connection in this direction.
const NONE: ConnectionChoice = choice_without_assembly("NONE", &[]);

/// Every safety I/O module.
pub static ALL: &[&Module] = &[
    &point_guard::IB8S,
    &point_guard::OB8S,
    &point_guard::IE4S,
    &ethernet::ES_1791_IB8XOBV4,
    &ethernet::ES_1732_IB8XOBV4,
    &ethernet::ES_1732_IB8XOB8,
    &ethernet::ES_1732_IB12XOB4,
    &ethernet::ES_1732_IB12XOBV2,
    &device_net::DS_1791_IB12,
    &device_net::DS_1791_IB8XOB8,
    &device_net::DS_1791_IB4XOW4,
    &device_net::DS_1791_IB4XOX4,
    &device_net::DS_1791_IB8XOBV4,
    &device_net::DS_1732_IB8XOBV4,
];

/// Adapters and other modules that carry no safety data of their own and may stand in the tree.
pub static CARRIERS: &[&str] = &[
    "1734-AENT",
    "1734-AENTR",
    "1756-EN2T",
    "1756-EN2TR",
    "1756-EN3TR",
    "1756-ENBT",
    "1756-DNB",
    "1768-ENBT",
    "ETHERNET-MODULE",
];

/// A catalogue number without its series letter: `1734-IB8S` of `1734-IB8S/A`.
pub fn without_series(catalog_number: &str) -> &str {
    catalog_number.split_once('/').map_or(catalog_number, |(number, _)| number)
}

impl Module {
    /// Finds a module by catalogue number; case and a series letter (`1734-IB8S/A`) make no difference.
    pub fn by_catalog_number(catalog_number: &str) -> Option<&'static Module> {
        let number = without_series(catalog_number);
        ALL.iter().copied().find(|module| module.catalog_number.eq_ignore_ascii_case(number))
    }

    /// Members that the input tag always has, in order.
    pub fn each_input(&self) -> impl Iterator<Item = &'static ModuleMember> + Clone + use<> {
        self.input.iter().copied().flatten()
    }

    /// Whether a source tells its tags.
    pub fn has_known_tags(&self) -> bool {
        !self.input_status.is_empty()
    }
}
