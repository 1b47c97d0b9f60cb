//! The probability of failure of a loop: the sum over its input module, its controllers and its output module. 1756-RM093
//! Table 4, Appendix E; 1734-UM013, Safety Data.

use serde::Serialize;
use twinrung_catalog::failure::{FailureData, Use, of_controller, of_module};
use twinrung_compiler::project::Project;

/// One element of a loop.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Element {
    /// What it is: `1734-IB8S`, or the controller's table row.
    pub subject: String,
    /// Probability of failure on demand at the proof test interval that was asked for.
    pub on_demand: Option<f64>,
    /// Dangerous failures per hour.
    pub per_hour: Option<f64>,
    /// Where the figures stand, or why there are none.
    pub source: String,
}

/// A loop's sum; a figure is there only where every element has one.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Loop {
    /// Input module, controllers, output module.
    pub elements: Vec<Element>,
    /// Years between proof tests.
    pub proof_test_years: u32,
    /// Sum of the probabilities of failure on demand.
    pub on_demand: Option<f64>,
    /// Sum of the dangerous failures per hour.
    pub per_hour: Option<f64>,
}

impl Loop {
    /// Adds up.
    pub fn new(elements: Vec<Element>, proof_test_years: u32) -> Loop {
        Loop {
            on_demand: elements.iter().map(|one| one.on_demand).sum(),
            per_hour: elements.iter().map(|one| one.per_hour).sum(),
            elements,
            proof_test_years,
        }
    }
}

/// A module whose points are used so; of the rows that can apply the worst.
pub fn module(catalog_number: &str, used: Use, years: u32) -> Element {
    let rows: Vec<&FailureData> = of_module(catalog_number, used).collect();
    element(catalog_number, &rows, years, "no source of this project has its safety data: its own manual does")
}

/// The controller of a project, its safety partner included.
pub fn controller(project: &Project, years: u32) -> Element {
    let declared = project.profile.map(|profile| profile.controller);
    let rows: Vec<&FailureData> = declared.and_then(of_controller).into_iter().collect();
    let name = declared.map_or("controller", |controller| controller.catalog_number);
    element(name, &rows, years, "1756-RM093 does not cover it: its own safety reference manual has its safety data")
}

fn element(subject: &str, rows: &[&FailureData], years: u32, missing: &str) -> Element {
    let worst = |figures: Vec<Option<f64>>| -> Option<f64> {
        let figures: Option<Vec<f64>> = figures.into_iter().collect();
        figures?.into_iter().reduce(f64::max)
    };
    let mut sources: Vec<&str> = rows.iter().map(|row| row.source).collect();
    sources.dedup();
    let source = match rows.len() {
        0 => missing.to_owned(),
        1 => sources.join("; "),
        _ => format!("{}; the series is not named, the worse row counts", sources.join("; ")),
    };
    Element {
        subject: subject.to_owned(),
        on_demand: worst(rows.iter().map(|row| row.on_demand_after(years)).collect()),
        per_hour: worst(rows.iter().map(|row| Some(row.per_hour)).collect()),
        source,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn module_when_the_series_is_not_named_then_the_worse_row_counts() {
        let named = module("1734-OB8S/B", Use::Dual, 20);
        assert_eq!((named.on_demand, named.per_hour), (Some(1.02e-5), Some(1.20e-10)));
        let unnamed = module("1734-OB8S", Use::Dual, 20);
        assert_eq!((unnamed.on_demand, unnamed.per_hour), (Some(4.27e-5), Some(5.14e-10)));
        let single = module("1734-OB8S", Use::Single, 20);
        assert_eq!((single.on_demand, single.per_hour), (Some(4.04e-4), Some(4.62e-9)));
    }

    #[test]
    fn module_when_no_source_has_it_then_no_figure_and_no_sum() {
        let unknown = module("1791DS-IB12", Use::Dual, 20);
        let known = module("1734-IB8S/A", Use::Dual, 20);
        assert_eq!(unknown.per_hour, None);
        assert_eq!(Loop::new(vec![known, unknown], 20).per_hour, None);
    }

    #[test]
    fn module_when_the_interval_is_between_two_of_the_table_then_the_longer_one_counts() {
        assert_eq!(module("1734-IB8S/A", Use::Single, 3).on_demand, Some(1.06e-5));
        assert_eq!(module("1734-IB8S/A", Use::Single, 21).on_demand, None);
    }
}
