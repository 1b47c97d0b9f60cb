//! Probabilities of dangerous failure, as the manuals publish them: on demand (PFD) by proof test interval, and per hour
//! (PFH). Sources: 1756-RM093I Tables 14 and 15; 1734-UM013, Safety Data.

use crate::controller::{Controller, Family};

/// How the points of a module are used.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Use {
    /// Each point alone.
    Single,
    /// Points in pairs.
    Dual,
    /// The manual makes no difference.
    Either,
}

/// One row of a table.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FailureData {
    /// Catalogue number without a series letter; of a controller the family as the table names it.
    pub subject: &'static str,
    /// The series of the module; `None` where the table has one row for all.
    pub series: Option<char>,
    /// How its points are used.
    pub used: Use,
    /// Years between proof tests, and the PFD with that interval; intervals ascend.
    pub on_demand: &'static [(u32, f64)],
    /// Dangerous failures per hour: the greatest that the table shows for any proof test interval.
    pub per_hour: f64,
    /// Where it stands.
    pub source: &'static str,
}

const CONTROLLERS: &str = "1756-RM093I Tables 14 and 15";
const POINT_GUARD_A: &str = "1734-UM013, Series A Safety Data";
const POINT_GUARD_B: &str = "1734-UM013, Series B Safety Data";

static L6X: FailureData = FailureData {
    subject: "1756-L6xS and 1756-LSP",
    series: None,
    used: Use::Either,
    on_demand: &[(10, 5.5e-6), (20, 1.2e-5)],
    per_hour: 2.0e-10,
    source: CONTROLLERS,
};

static L7X: FailureData = FailureData {
    subject: "1756-L7xS and 1756-L7SP",
    series: None,
    used: Use::Either,
    on_demand: &[(2, 5.7e-6), (5, 1.5e-5), (10, 3.5e-5), (20, 8.9e-5)],
    per_hour: 1.2e-9,
    source: CONTROLLERS,
};

static L4X: FailureData = FailureData {
    subject: "1768-L43S and 1768-L45S",
    series: None,
    used: Use::Either,
    on_demand: &[(2, 1.1e-6), (5, 2.7e-6), (10, 5.7e-6), (20, 1.2e-5)],
    per_hour: 2.0e-10,
    source: CONTROLLERS,
};

/// Every row of the modules.
pub static MODULES: &[FailureData] = &[
    FailureData {
        subject: "1734-IB8S",
        series: Some('A'),
        used: Use::Either,
        on_demand: &[(1, 2.11e-6), (2, 4.23e-6), (5, 1.06e-5), (10, 2.11e-5), (20, 4.23e-5)],
        per_hour: 5.10e-10,
        source: POINT_GUARD_A,
    },
    FailureData {
        subject: "1734-OB8S",
        series: Some('A'),
        used: Use::Either,
        on_demand: &[(1, 2.13e-6), (2, 4.27e-6), (5, 1.07e-5), (10, 2.13e-5), (20, 4.27e-5)],
        per_hour: 5.14e-10,
        source: POINT_GUARD_A,
    },
    FailureData {
        subject: "1734-IE4S",
        series: Some('A'),
        used: Use::Single,
        on_demand: &[(1, 2.30e-7), (2, 4.70e-7), (5, 1.20e-6), (10, 2.40e-6), (20, 4.80e-6)],
        per_hour: 5.60e-11,
        source: POINT_GUARD_A,
    },
    FailureData {
        subject: "1734-IE4S",
        series: Some('A'),
        used: Use::Dual,
        on_demand: &[(1, 1.60e-7), (2, 3.20e-7), (5, 8.10e-7), (10, 1.60e-6), (20, 3.30e-6)],
        per_hour: 3.90e-11,
        source: POINT_GUARD_A,
    },
    FailureData {
        subject: "1734-IB8S",
        series: Some('B'),
        used: Use::Single,
        on_demand: &[(1, 2.42e-6), (2, 4.85e-6), (5, 1.21e-5), (10, 2.43e-5), (20, 4.89e-5)],
        per_hour: 5.61e-10,
        source: POINT_GUARD_B,
    },
    FailureData {
        subject: "1734-OB8S",
        series: Some('B'),
        used: Use::Single,
        on_demand: &[(1, 2.02e-5), (2, 4.04e-5), (5, 1.01e-4), (10, 2.02e-4), (20, 4.04e-4)],
        per_hour: 4.62e-9,
        source: POINT_GUARD_B,
    },
    FailureData {
        subject: "1734-IB8S",
        series: Some('B'),
        used: Use::Dual,
        on_demand: &[(1, 4.89e-7), (2, 9.80e-7), (5, 2.47e-6), (10, 5.00e-6), (20, 1.02e-5)],
        per_hour: 1.20e-10,
        source: POINT_GUARD_B,
    },
    FailureData {
        subject: "1734-OB8S",
        series: Some('B'),
        used: Use::Dual,
        on_demand: &[(1, 4.89e-7), (2, 9.81e-7), (5, 2.47e-6), (10, 5.00e-6), (20, 1.02e-5)],
        per_hour: 1.20e-10,
        source: POINT_GUARD_B,
    },
];

/// The row of a controller, its safety partner included; nothing for the families that the manual does not cover.
pub fn of_controller(controller: &Controller) -> Option<&'static FailureData> {
    match controller.family {
        Family::L6x => Some(&L6X),
        Family::L4x => Some(&L4X),
        Family::L7x if controller.catalog_number.starts_with("1756-L7") => Some(&L7X),
        Family::L7x => None,
    }
}

/// The rows that can apply to a module whose points are used so. A series letter in the catalogue number (`1734-IB8S/B`)
/// chooses; without one the rows of all series are there, and the worst counts.
pub fn of_module(catalog_number: &str, used: Use) -> impl Iterator<Item = &'static FailureData> {
    let number = crate::modules::without_series(catalog_number);
    let series = catalog_number.split_once('/').and_then(|(_, series)| series.chars().next());
    MODULES.iter().filter(move |row| {
        row.subject.eq_ignore_ascii_case(number)
            && (row.used == Use::Either || used == Use::Either || row.used == used)
            && (series.is_none()
                || row.series.is_none_or(|one| series.is_some_and(|own| own.eq_ignore_ascii_case(&one))))
    })
}

impl FailureData {
    /// The PFD with proof tests at most so many years apart: that of the next interval that the table has; nothing beyond
    /// its last.
    pub fn on_demand_after(&self, years: u32) -> Option<f64> {
        self.on_demand.iter().find(|(interval, _)| *interval >= years).map(|(_, probability)| *probability)
    }
}
