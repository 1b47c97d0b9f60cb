//! Replacement of a safety module: whether the controller configures what it finds at a module's place, and what a person has to do
//! first. 1734-UM013 Chapter 8, Table 11 and its scenarios; 1756-RM093 I/O Module Replacement.
//!
//! One table, [`ROWS`], says when a found module is refused; what no row refuses is configured and connected. A module's identity is
//! its node address and its safety network number; its configuration is known by the configuration signature.

use serde::{Deserialize, Serialize};

/// When the controller configures a replaced module by itself.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Policy {
    /// Configure Only When No Safety Signature Exists.
    WithoutSignature,
    /// Configure Always: only where nothing relies on the system while a module is replaced and tested.
    Always,
}

/// The safety network number that a found module holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Number {
    /// None: out-of-box.
    OutOfBox,
    /// The one of the project.
    Same,
    /// Another one.
    Other,
}

/// Who owns the configuration of a found module.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Owner {
    /// Nobody.
    Nobody,
    /// This controller.
    Local,
    /// Another one.
    Remote,
}

/// What is found at the place of a module.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Found {
    /// Its safety network number.
    pub number: Number,
    /// Whether it is the kind of module that electronic keying asks for.
    pub key_fits: bool,
    /// Whether it has the node or IP address of the project.
    pub address_fits: bool,
    /// Who owns its configuration.
    pub owner: Owner,
}

/// One thing that a row asks.
type Condition = fn(Policy, bool, Found) -> bool;

/// A row of the table.
#[derive(Debug)]
pub struct Row {
    /// Its number, for messages and pages: it stays with the row.
    pub code: &'static str,
    /// Why the module is not configured.
    pub reason: &'static str,
    /// What a person does, in order.
    pub steps: &'static [&'static str],
    /// Where it comes from.
    pub source: &'static str,
    when: Condition,
}

const TEST: &str = "test the replaced module and the system, and authorize it for use, by the procedure of the plant";
const SET: &str = "set the safety network number; confirm that the network status indicator of the right module alternates red and green";
const RESET: &str =
    "inhibit the connection of a module that this controller owns, then reset its ownership: it is out-of-box then";

/// Every row; of those that refuse a module, the first is the reason.
pub static ROWS: &[Row] = &[
    Row {
        code: "R01",
        reason: "nothing answers at the node or IP address of the module",
        steps: &["give the module the address of the project", TEST],
        source: "1756-RM093 Configure Only When No Safety Signature Exists; Configure Always",
        when: |_, _, found| !found.address_fits,
    },
    Row {
        code: "R02",
        reason: "electronic keying: it is another kind of module",
        steps: &["use the module that the project names", TEST],
        source: "1756-RM093 Configure Only When No Safety Signature Exists; Configure Always",
        when: |_, _, found| !found.key_fits,
    },
    Row {
        code: "R03",
        reason: "another controller owns its configuration",
        steps: &[RESET, TEST],
        source: "1734-UM013 Configuration Ownership",
        when: |_, _, found| found.owner == Owner::Remote,
    },
    Row {
        code: "R04",
        reason: "it is out-of-box and a safety task signature exists: its number is set by a person (scenario 1)",
        steps: &[SET, TEST],
        source: "1734-UM013 Table 11, Scenario 1",
        when: |policy, signed, found| policy == Policy::WithoutSignature && signed && found.number == Number::OutOfBox,
    },
    Row {
        code: "R05",
        reason: "it has another safety network number and a safety task signature exists (scenario 2)",
        steps: &[RESET, SET, TEST],
        source: "1734-UM013 Table 11, Scenario 2",
        when: |policy, signed, found| policy == Policy::WithoutSignature && signed && found.number == Number::Other,
    },
    Row {
        code: "R06",
        reason: "it has another safety network number (scenario 3)",
        steps: &[RESET, TEST],
        source: "1734-UM013 Table 11, Scenario 3",
        when: |policy, signed, found| policy == Policy::WithoutSignature && !signed && found.number == Number::Other,
    },
    Row {
        code: "R07",
        reason: "it has another safety network number",
        steps: &[RESET, TEST],
        source: "1734-UM013 Replacement with Configure Always Enabled",
        when: |policy, _, found| policy == Policy::Always && found.number == Number::Other,
    },
];

/// Whether the controller configures a found module and connects to it.
///
/// # Errors
///
/// The first row that refuses it.
pub fn judge(policy: Policy, signed: bool, found: Found) -> Result<(), &'static Row> {
    ROWS.iter().find(|row| (row.when)(policy, signed, found)).map_or(Ok(()), Err)
}

/// Why a module cannot be changed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Refusal {
    /// This controller is connected to it: the connection is inhibited first.
    Connected,
    /// It holds a number: only an out-of-box module takes one.
    HasNumber,
}

impl Refusal {
    /// Why, and the way out.
    pub const fn words(self) -> &'static str {
        match self {
            Refusal::Connected => {
                "this controller owns the module and is connected to it: inhibit the connection first"
            }
            Refusal::HasNumber => "the module holds a safety network number: reset its ownership first",
        }
    }
}

impl Found {
    /// Resets its ownership: out-of-box, without number and owner (1734-UM013 Resetting a Module to Out-of-box Condition).
    ///
    /// # Errors
    ///
    /// [`Refusal::Connected`].
    pub const fn reset_ownership(self, inhibited: bool) -> Result<Found, Refusal> {
        match self.owner {
            Owner::Local if !inhibited => Err(Refusal::Connected),
            _ => Ok(Found { number: Number::OutOfBox, owner: Owner::Nobody, ..self }),
        }
    }

    /// A person sets the number of the project, and has seen that it is the right module (1734-UM013 Manually Setting the Safety
    /// Network Number).
    ///
    /// # Errors
    ///
    /// [`Refusal::HasNumber`].
    pub const fn set_number(self) -> Result<Found, Refusal> {
        match self.number {
            Number::OutOfBox => Ok(Found { number: Number::Same, ..self }),
            Number::Same | Number::Other => Err(Refusal::HasNumber),
        }
    }

    /// Every combination, those that cannot be among them: a module out-of-box has no owner.
    pub fn all() -> impl Iterator<Item = Found> {
        let flags = || [true, false].into_iter();
        [Number::OutOfBox, Number::Same, Number::Other].into_iter().flat_map(move |number| {
            [Owner::Nobody, Owner::Local, Owner::Remote].into_iter().flat_map(move |owner| {
                flags().flat_map(move |key_fits| {
                    flags().map(move |address_fits| Found { number, key_fits, address_fits, owner })
                })
            })
        })
    }

    /// Whether a module can be so.
    pub const fn is_possible(self) -> bool {
        !matches!((self.number, self.owner), (Number::OutOfBox, Owner::Local | Owner::Remote))
    }
}

/// On what the connection between a module and its owner is based (1734-UM013 Configuration Ownership).
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Ownership {
    /// The module's node number or address.
    pub module_number: String,
    /// The module's safety network number.
    pub module_network: u64,
    /// The slot of the controller.
    pub controller_slot: u16,
    /// The controller's safety network number.
    pub controller_network: u64,
    /// The path from the controller to the module.
    pub path: String,
    /// The ID of the configuration signature.
    pub configuration: [u8; 32],
}

impl Ownership {
    /// What differs: with anything in this list the connection is lost.
    pub fn differences(&self, other: &Ownership) -> Vec<&'static str> {
        let parts = [
            (self.module_number == other.module_number, "the module number"),
            (self.module_network == other.module_network, "the safety network number of the module"),
            (self.controller_slot == other.controller_slot, "the slot of the controller"),
            (self.controller_network == other.controller_network, "the safety network number of the controller"),
            (self.path == other.path, "the path from the controller to the module"),
            (self.configuration == other.configuration, "the configuration signature"),
        ];
        parts.into_iter().filter(|(same, _)| !same).map(|(_, name)| name).collect()
    }
}
