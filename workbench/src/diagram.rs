//! The timing diagram of a recording, as manuals draw it: one line for each tag, time from left to right.

use std::fmt::Write;

use crate::recording::{Recording, Row};
use crate::signal::Value;

/// How a diagram is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Style {
    /// Columns of the terminal.
    pub columns: usize,
    /// Whether escape codes may colour it.
    pub colour: bool,
}

/// Narrowest plot that is still worth looking at.
const LEAST_PLOT: usize = 20;
/// Longest name shown whole.
const LONGEST_NAME: usize = 32;

pub(crate) const LOW: char = '▁';
pub(crate) const HIGH: char = '█';
const BOTH: char = '▒';

/// Draws a recording. BOOLs are bars (`▁` off, `█` on, `▒` both within one column); a number is written where it changes.
pub fn draw(recording: &Recording, style: Style) -> String {
    let mut out = String::new();
    if recording.rows.is_empty() {
        return out;
    }
    let names: Vec<String> = recording.names.iter().map(|name| shortened(name)).collect();
    let gutter = names.iter().map(|name| name.chars().count()).max().unwrap_or(0) + 2;
    let plot = style.columns.saturating_sub(gutter).max(LEAST_PLOT);
    let rows = recording.rows.len();
    let columns: Vec<&[Row]> = match rows <= plot {
        true => recording.rows.chunks(1).collect(),
        false => (0..plot).map(|column| &recording.rows[column * rows / plot..(column + 1) * rows / plot]).collect(),
    };
    axis(&mut out, &columns, gutter);
    for (column, name) in names.iter().enumerate() {
        let pad = gutter - name.chars().count();
        let _ = write!(out, "{name}{:pad$}", "");
        if matches!(recording.rows[0].values.get(column), Some(Value::Bool(_))) {
            bars(&mut out, columns.iter().map(|rows| rows.iter().filter_map(|row| row.values.get(column))), style);
        } else {
            numbers(&mut out, columns.iter().map(|rows| rows.last().and_then(|row| row.values.get(column))));
        }
        out.push('\n');
    }
    out
}

fn shortened(name: &str) -> String {
    let length = name.chars().count();
    if length <= LONGEST_NAME {
        return name.to_owned();
    }
    let tail: String = name.chars().skip(length - (LONGEST_NAME - 1)).collect();
    format!("…{tail}")
}

fn axis(out: &mut String, columns: &[&[Row]], gutter: usize) {
    let _ = write!(out, "{:<gutter$}", "ms");
    let mut at = 0;
    while let Some(first) = columns.get(at).and_then(|rows| rows.first()) {
        let label = first.time_ms.to_string();
        let step = (label.len() + 2).next_multiple_of(10).max(10);
        let room = step.min(columns.len() - at);
        if label.len() < room || at == 0 {
            let _ = write!(out, "|{label:<width$}", width = room.saturating_sub(1));
        }
        at += step;
    }
    out.truncate(out.trim_end().len());
    out.push('\n');
}

fn bars<'a>(out: &mut String, columns: impl Iterator<Item = impl Iterator<Item = &'a Value>>, style: Style) {
    let mut coloured = false;
    for column in columns {
        let (mut on, mut off) = (false, false);
        for value in column {
            let high = value.is_true();
            on |= high;
            off |= !high;
        }
        let mark = match (on, off) {
            (true, false) => HIGH,
            (true, true) => BOTH,
            _ => LOW,
        };
        if style.colour && (mark != LOW) != coloured {
            out.push_str(if coloured { "\u{1b}[0m" } else { "\u{1b}[32m" });
            coloured = !coloured;
        }
        out.push(mark);
    }
    if coloured {
        out.push_str("\u{1b}[0m");
    }
}

fn numbers<'a>(out: &mut String, columns: impl Iterator<Item = Option<&'a Value>>) {
    let mut shown: Option<&Value> = None;
    let mut pending = String::new();
    for value in columns {
        if value != shown {
            shown = value;
            if let Some(value) = value {
                // A value that has no room is cut off by the next one; `…` says so.
                if !pending.is_empty() {
                    out.pop();
                    out.push('…');
                }
                pending = value.to_string().chars().rev().collect();
            }
        }
        out.push(pending.pop().unwrap_or('·'));
    }
    // The last value has all the room that it needs.
    out.extend(pending.chars().rev());
}

#[cfg(test)]
mod tests {
    use super::*;

    fn recording(values: &[(u64, bool, i32)]) -> Recording {
        Recording {
            names: vec!["Motor".into(), "Step".into()],
            rows: values
                .iter()
                .map(|(time_ms, motor, step)| Row {
                    time_ms: *time_ms,
                    values: vec![Value::Bool(*motor), Value::Integer(*step)],
                })
                .collect(),
        }
    }

    #[test]
    fn diagram_when_every_scan_has_a_column_then_levels_and_changes_stand_where_they_happen() {
        let drawn = draw(
            &recording(&[(0, false, 1), (10, false, 1), (20, true, 12), (30, true, 12), (40, false, 12)]),
            Style { columns: 40, colour: false },
        );
        assert_eq!(drawn, "ms     |0\nMotor  ▁▁██▁\nStep   1·12·\n");
    }

    #[test]
    fn diagram_when_scans_share_a_column_then_both_levels_are_marked() {
        let rows: Vec<(u64, bool, i32)> = (0..40).map(|scan| (scan * 10, scan == 3, 0)).collect();
        let drawn = draw(&recording(&rows), Style { columns: 27, colour: false });
        assert_eq!(drawn.lines().nth(1), Some("Motor  ▁▒▁▁▁▁▁▁▁▁▁▁▁▁▁▁▁▁▁▁"));
    }

    #[test]
    fn diagram_when_the_last_value_is_long_then_it_is_written_whole() {
        let drawn = draw(&recording(&[(0, false, 0), (10, false, 20487)]), Style { columns: 40, colour: false });
        assert_eq!(drawn.lines().nth(2), Some("Step   020487"));
    }
}
