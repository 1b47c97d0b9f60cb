//! Conformance tables: readable traces of what each base instruction does, run on primary, partner and judge at once.
//!
//! It depends on the evaluators alone, so that a change in one of them is tested without building anything else. No
//! release may use it.
//!
//! [`table`] describes the format of a table file and [`reader`] reads it; [`source`] makes a project of a case; [`run`] runs a case
//! and compares each row; [`value`] reads and compares the values in the cells; [`admission`] tries each instruction on each
//! controller.

#![forbid(unsafe_code)]

pub mod admission;
pub mod reader;
pub mod run;
pub mod source;
pub mod table;
pub mod value;

use std::fs;
use std::path::PathBuf;

use table::Table;

/// The folder of the tables.
pub fn folder() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tables")
}

/// Every table, in the order of the file names; those that cannot be read as what is wrong with them.
pub fn tables() -> (Vec<Table>, Vec<String>) {
    let mut paths: Vec<PathBuf> = fs::read_dir(folder())
        .expect("the folder of the tables is there")
        .map(|entry| entry.expect("an entry of the folder").path())
        .filter(|path| path.extension().is_some_and(|extension| extension == "table"))
        .collect();
    paths.sort();
    let (mut tables, mut wrong) = (Vec::new(), Vec::new());
    for path in paths {
        let name = path.file_name().expect("a file has a name").to_string_lossy().into_owned();
        let text = fs::read_to_string(&path).unwrap_or_else(|error| panic!("{name}: {error}"));
        match reader::read(&name, &text) {
            Ok(table) => tables.push(table),
            Err(error) => wrong.push(error),
        }
    }
    (tables, wrong)
}

/// The tables that `TWINRUNG_TABLES` names, separated by commas; all of them where it is not set.
pub fn chosen_tables() -> (Vec<Table>, Vec<String>) {
    let (mut tables, wrong) = tables();
    if let Ok(names) = std::env::var("TWINRUNG_TABLES") {
        tables.retain(|table| names.split(',').any(|name| table.file == format!("{name}.table")));
    }
    (tables, wrong)
}
