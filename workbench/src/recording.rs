//! A recording: the values of tags at the end of each scan.

use std::io::{self, Write};

use crate::signal::Value;

/// A recording, one row for each scan.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Recording {
    /// The recorded names, as they were asked for.
    pub names: Vec<String>,
    /// One row for each scan.
    pub rows: Vec<Row>,
}

/// The values at the end of one scan.
#[derive(Debug, Clone, PartialEq)]
pub struct Row {
    /// When the scan began, in ms.
    pub time_ms: u64,
    /// One value for each name.
    pub values: Vec<Value>,
}

impl Recording {
    /// Writes the recording as CSV: header `time_ms,TAG,...`, one row per scan.
    pub fn write_csv(&self, out: &mut dyn Write) -> io::Result<()> {
        let mut writer = csv::WriterBuilder::new().terminator(csv::Terminator::Any(b'\n')).from_writer(out);
        let as_io = |error: csv::Error| io::Error::other(error.to_string());
        writer.write_record(std::iter::once("time_ms").chain(self.names.iter().map(String::as_str))).map_err(as_io)?;
        for row in &self.rows {
            let cells = std::iter::once(row.time_ms.to_string()).chain(row.values.iter().map(ToString::to_string));
            writer.write_record(cells).map_err(as_io)?;
        }
        writer.flush()
    }

    /// The recording as CSV text.
    pub fn to_csv(&self) -> String {
        let mut bytes = Vec::new();
        // A Vec accepts every write, and the CSV of ASCII names and numbers is text.
        match self.write_csv(&mut bytes) {
            Ok(()) => String::from_utf8_lossy(&bytes).into_owned(),
            Err(error) => unreachable!("writing into memory failed: {error}"),
        }
    }
}
