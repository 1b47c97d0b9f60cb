//! What there is to cover.

use serde::Serialize;

/// Kinds of items, in the order of a report.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Kind {
    /// An input that logic looks at changes, each way.
    Input,
    /// An output that logic writes changes, each way.
    Output,
    /// A rung is true, and false.
    Rung,
    /// A condition decides its rung, in each of its positions.
    Contact,
    /// A fault code of a safety application instruction is shown.
    Code,
}

impl Kind {
    /// All kinds.
    pub const ALL: [Kind; 5] = [Kind::Input, Kind::Output, Kind::Rung, Kind::Contact, Kind::Code];

    /// What a report calls them.
    pub fn plural(self) -> &'static str {
        match self {
            Kind::Input => "inputs toggled",
            Kind::Output => "outputs toggled",
            Kind::Rung => "rungs true and false",
            Kind::Contact => "contacts that decided",
            Kind::Code => "fault codes reached",
        }
    }
}

/// Something to cover.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Item {
    /// Its kind.
    pub kind: Kind,
    /// Its name, as an exclusion quotes it.
    pub name: String,
    /// Whether a scenario has shown it.
    pub reached: bool,
    /// What a scenario does to show it.
    pub way: String,
    /// Why it need not be shown.
    pub excluded: Option<String>,
}

impl Item {
    /// Whether it is missing.
    pub fn is_missing(&self) -> bool {
        !self.reached && self.excluded.is_none()
    }
}
