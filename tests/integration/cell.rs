//! A controller that is kept in a folder, as the tests of several subjects ask it for things.

use std::fs;
use std::path::PathBuf;

use tempfile::TempDir;

use crate::command::{Said, twinrung};

/// A controller in a folder of its own, and room for files beside it.
pub struct Cell {
    home: TempDir,
}

impl Cell {
    /// Without anything.
    pub fn new() -> Cell {
        Cell { home: tempfile::tempdir().unwrap() }
    }

    /// With the project of this text downloaded.
    pub fn with_project(text: &str) -> Cell {
        let cell = Cell::new();
        cell.write("project.rll", text);
        cell.done(&format!("download {}", cell.path("project.rll").display()));
        cell
    }

    /// A file beside the controller.
    pub fn path(&self, name: &str) -> PathBuf {
        self.home.path().join(name)
    }

    /// Writes a file beside the controller.
    pub fn write(&self, name: &str, text: &str) {
        fs::write(self.path(name), text).unwrap();
    }

    /// The controller's folder, as the command is told it.
    pub fn folder(&self) -> String {
        self.path("cell").display().to_string()
    }

    /// Asks for something.
    pub fn ask(&self, action: &str) -> Said {
        let folder = self.folder();
        let arguments: Vec<&str> = ["controller", &folder].into_iter().chain(action.split_whitespace()).collect();
        twinrung(&arguments)
    }

    /// Asks for what is permitted.
    pub fn done(&self, action: &str) -> String {
        let said = self.ask(action);
        assert_eq!(said.code, Some(0), "{action}: {}{}", said.out, said.err);
        said.out
    }

    /// Asks for what is refused with these words, or for the reason of this number.
    pub fn refused(&self, action: &str, words: &str) {
        let said = self.ask(action);
        assert_eq!(said.code, Some(1), "{action}: {}{}", said.out, said.err);
        assert!(said.out.contains(words), "{action}: {}", said.out);
    }

    /// What it says of itself.
    pub fn status(&self) -> serde_json::Value {
        serde_json::from_str(&self.done("status --format json")).unwrap()
    }
}
