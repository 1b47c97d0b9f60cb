//! The files that evidence is read from, as bytes.

use std::fmt::{self, Display};

use serde::de::DeserializeOwned;
use sha2::{Digest, Sha256};
use twinrung_bytecode::signature::long_form;

use crate::provenance::Provenance;

use super::Origin;

/// A file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct File {
    /// Its path in the project, with `/`.
    pub name: String,
    /// What stands in it.
    pub bytes: Vec<u8>,
}

/// All files. What is not there is empty or absent.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Sources {
    /// Reports of `twinrung fuzz`.
    pub fuzz: Vec<File>,
    /// Reports of `twinrung inject`.
    pub inject: Vec<File>,
    /// The differences that were found, and what became of them.
    pub differences: Option<File>,
    /// The lists of seeded defects, one for each channel.
    pub defects: Vec<File>,
    /// The times in which they were found.
    pub times: Option<File>,
    /// Results of mutation testing.
    pub mutants: Vec<File>,
    /// The review of what the channels share.
    pub independence: Option<File>,
    /// The samples that have a stimulus: paths in the project.
    pub samples: Vec<String>,
}

/// Why evidence cannot be read.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct EvidenceError {
    /// The file.
    pub file: String,
    /// What is wrong with it, and the way out.
    pub message: String,
}

impl Display for EvidenceError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.file, self.message)
    }
}

impl std::error::Error for EvidenceError {}

impl File {
    /// What is wrong with this file.
    pub(super) fn wrong(&self, message: impl Display) -> EvidenceError {
        EvidenceError { file: self.name.clone(), message: message.to_string() }
    }

    /// As text.
    pub(super) fn text(&self) -> Result<&str, EvidenceError> {
        std::str::from_utf8(&self.bytes)
            .map_err(|error| self.wrong(format_args!("no UTF-8 text: {error}; save it as UTF-8")))
    }

    /// As TOML.
    pub(super) fn toml<T: DeserializeOwned>(&self) -> Result<T, EvidenceError> {
        toml::from_str(self.text()?).map_err(|error| {
            let error = error.to_string();
            self.wrong(format_args!(
                "{}\nput the line right, or take the file away: then what it holds counts as not measured",
                error.trim_end()
            ))
        })
    }

    /// Where its figures come from.
    pub(super) fn origin(&self, measurements: Vec<Provenance>) -> Origin {
        Origin { file: self.name.clone(), sha256: long_form(&Sha256::digest(&self.bytes)), measurements }
    }
}
