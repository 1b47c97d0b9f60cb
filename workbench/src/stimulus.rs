//! A stimulus: what drives the inputs, row by row.
//!
//! CSV with the header `time_ms,TAG,TAG...`. A row holds until the next one; cells are 0/1, decimal integers or REAL; an empty
//! cell leaves the tag as it was. Rows stand in ascending order of time.

use std::fmt;

/// A stimulus before its names are looked up.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Stimulus {
    /// The driven tags, in the order of the columns.
    pub tags: Vec<String>,
    /// The rows in ascending order of time.
    pub rows: Vec<StimulusRow>,
}

/// One row of a stimulus.
#[derive(Debug, Clone, PartialEq)]
pub struct StimulusRow {
    /// Line in the file, from 1.
    pub line: u64,
    /// From when it holds, in ms.
    pub time_ms: u64,
    /// One cell for each tag; `None` leaves it as it was.
    pub cells: Vec<Option<String>>,
}

/// Why a stimulus cannot be read.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum StimulusError {
    /// The first column of the header is not `time_ms`.
    Header {
        /// What stands there.
        found: String,
    },
    /// A tag has two columns.
    RepeatedTag {
        /// The tag.
        tag: String,
    },
    /// A time that is not a whole number of ms.
    Time {
        /// Line in the file, from 1.
        line: u64,
        /// What stands there.
        found: String,
    },
    /// A time that is not above the one before.
    Order {
        /// Line in the file, from 1.
        line: u64,
        /// The time there, in ms.
        time_ms: u64,
    },
    /// The file is not CSV with as many cells in each row as in the header.
    Csv(String),
}

impl fmt::Display for StimulusError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            StimulusError::Header { found } => {
                write!(f, "line 1: the first column of a stimulus is `time_ms`, found `{found}`")
            }
            StimulusError::RepeatedTag { tag } => write!(f, "line 1: `{tag}` has two columns"),
            StimulusError::Time { line, found } => {
                write!(f, "line {line}: the time is a whole number of milliseconds, found `{found}`")
            }
            StimulusError::Order { line, time_ms } => {
                write!(f, "line {line}: {time_ms} ms is not later than the row before")
            }
            StimulusError::Csv(message) => f.write_str(message),
        }
    }
}

impl std::error::Error for StimulusError {}

impl Stimulus {
    /// Reads a stimulus from CSV text.
    pub fn read(text: &str) -> Result<Stimulus, StimulusError> {
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        let mut reader =
            csv::ReaderBuilder::new().comment(Some(b'#')).trim(csv::Trim::All).from_reader(text.as_bytes());
        let header = reader.headers().map_err(|error| StimulusError::Csv(error.to_string()))?.clone();
        let first = header.get(0).unwrap_or_default();
        if !first.eq_ignore_ascii_case("time_ms") {
            return Err(StimulusError::Header { found: first.to_owned() });
        }
        let tags: Vec<String> = header.iter().skip(1).map(str::to_owned).collect();
        let mut seen = std::collections::HashSet::new();
        if let Some(tag) = tags.iter().find(|tag| !seen.insert(tag.to_ascii_lowercase())) {
            return Err(StimulusError::RepeatedTag { tag: tag.clone() });
        }
        let mut rows: Vec<StimulusRow> = Vec::new();
        for record in reader.records() {
            let record = record.map_err(|error| StimulusError::Csv(error.to_string()))?;
            let line = record.position().map_or(0, csv::Position::line);
            let time = record.get(0).unwrap_or_default();
            let time_ms = time.parse().map_err(|_| StimulusError::Time { line, found: time.to_owned() })?;
            if rows.last().is_some_and(|before| before.time_ms >= time_ms) {
                return Err(StimulusError::Order { line, time_ms });
            }
            let cells = record.iter().skip(1).map(|cell| (!cell.is_empty()).then(|| cell.to_owned())).collect();
            rows.push(StimulusRow { line, time_ms, cells });
        }
        Ok(Stimulus { tags, rows })
    }

    /// The time of the last row in ms, 0 without any.
    pub fn last_ms(&self) -> u64 {
        self.rows.last().map_or(0, |row| row.time_ms)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stimulus_when_a_cell_is_empty_then_the_tag_is_left_alone() {
        let stimulus = Stimulus::read("time_ms,A,B\n0,1,\n20,,7\n").unwrap();
        assert_eq!(stimulus.tags, ["A", "B"]);
        assert_eq!(stimulus.rows[0].cells, [Some("1".to_owned()), None]);
        assert_eq!(stimulus.rows[1].cells, [None, Some("7".to_owned())]);
        assert_eq!(stimulus.last_ms(), 20);
    }

    #[test]
    fn stimulus_when_times_do_not_ascend_then_the_line_is_named() {
        assert_eq!(Stimulus::read("time_ms,A\n20,1\n20,0\n"), Err(StimulusError::Order { line: 3, time_ms: 20 }));
    }

    #[test]
    fn stimulus_when_the_header_is_wrong_then_it_says_what_belongs_there() {
        assert_eq!(Stimulus::read("t,A\n0,1\n"), Err(StimulusError::Header { found: "t".to_owned() }));
    }

    #[test]
    fn stimulus_when_a_tag_has_two_columns_then_it_is_refused() {
        assert_eq!(Stimulus::read("time_ms,A,a\n"), Err(StimulusError::RepeatedTag { tag: "a".to_owned() }));
    }

    #[test]
    fn stimulus_when_a_row_is_short_then_it_is_refused() {
        assert!(matches!(Stimulus::read("time_ms,A,B\n0,1\n"), Err(StimulusError::Csv(_))));
    }
}
