//! Where the evaluators disagree.

use std::fmt;

/// What the three hold, where not all of them hold the same.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Disagreement {
    /// The scan, from 0; `None` for the prescan.
    pub scan: Option<u64>,
    /// Each value that differs: its name, then what primary, partner and judge hold.
    pub values: Vec<(String, [String; 3])>,
}

/// Differences that are listed; more of them say nothing new.
pub(crate) const LISTED: usize = 12;

impl fmt::Display for Disagreement {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.scan {
            Some(scan) => writeln!(f, "the evaluators disagree in scan {scan}:")?,
            None => writeln!(f, "the evaluators disagree in the prescan:")?,
        }
        for (name, [primary, partner, judge]) in &self.values {
            writeln!(f, "  {name}: primary {primary}, partner {partner}, judge {judge}")?;
        }
        Ok(())
    }
}

impl std::error::Error for Disagreement {}
