//! What a stimulus does to a line beside driving tags.

use super::LineError;
use crate::stimulus::Stimulus;

/// What a column of a stimulus acts on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Target {
    /// The mode of a member.
    Mode(usize),
    /// The safety partner of a member.
    Partner(usize),
    /// The network behind a joint.
    Network(usize),
}

/// What happens at a moment.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Event {
    pub(super) target: Target,
    /// Run, whole, carried; else Program, failed, lost.
    pub(super) good: bool,
}

/// The events of a column, with their times in µs.
pub(super) fn events(stimulus: &Stimulus, column: usize, target: Target) -> Result<Vec<(u64, Event)>, LineError> {
    let name = stimulus.tags.get(column).cloned().unwrap_or_default();
    let mut list = Vec::new();
    for row in &stimulus.rows {
        let Some(Some(cell)) = row.cells.get(column) else { continue };
        let good = match cell.as_str() {
            "0" => false,
            "1" => true,
            _ => return Err(LineError::Value(name)),
        };
        list.push((row.time_ms.saturating_mul(1000), Event { target, good }));
    }
    Ok(list)
}
