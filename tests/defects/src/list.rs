//! The lists of defects.

use std::fmt;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use serde::Deserialize;

/// Which interpreter, with its half of the safety library, a defect is put into.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Channel {
    /// `vm/primary` and `stdlib-safety/primary`.
    Primary,
    /// `vm/partner` and `stdlib-safety/partner`.
    Partner,
}

impl Channel {
    /// Both.
    pub const ALL: [Channel; 2] = [Channel::Primary, Channel::Partner];

    /// Its name in paths.
    pub fn name(self) -> &'static str {
        match self {
            Channel::Primary => "primary",
            Channel::Partner => "partner",
        }
    }

    /// The file that holds its list.
    pub fn list(self) -> String {
        format!("tests/defects/{}.toml", self.name())
    }
}

/// A mistake that somebody could have made.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Defect {
    /// Words with hyphens; no two defects have one name.
    pub name: String,
    /// The file, from the root of the project.
    pub file: String,
    /// A text that stands there exactly once.
    pub find: String,
    /// What is to stand there instead.
    pub replace: String,
    /// The mistake in one sentence.
    pub why: String,
}

/// Why a defect cannot be put into a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Misfit {
    /// The text stands there so many times and not once.
    Stands(usize),
    /// It is replaced by itself.
    ChangesNothing,
    /// The file belongs to neither the channel nor its half of the library.
    Elsewhere,
}

impl fmt::Display for Misfit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Misfit::Stands(count) => write!(f, "`find` stands {count} times in its file; give a text that stands once"),
            Misfit::ChangesNothing => f.write_str("`replace` is what `find` is; nothing would change"),
            Misfit::Elsewhere => f.write_str("the file is not of the channel whose list this is"),
        }
    }
}

impl Defect {
    /// Whether its file belongs to a channel.
    ///
    /// # Errors
    ///
    /// [`Misfit::Elsewhere`].
    pub fn is_of(&self, channel: Channel) -> Result<(), Misfit> {
        let folders = ["vm", "stdlib-safety"].map(|folder| format!("{folder}/{}/", channel.name()));
        let inside = folders.iter().any(|folder| self.file.starts_with(folder)) && !self.file.contains("..");
        if inside { Ok(()) } else { Err(Misfit::Elsewhere) }
    }

    /// The text of its file with the mistake in it.
    ///
    /// # Errors
    ///
    /// What keeps it from being put in.
    pub fn applied(&self, text: &str) -> Result<String, Misfit> {
        match text.matches(&self.find).count() {
            _ if self.find == self.replace => Err(Misfit::ChangesNothing),
            1 => Ok(text.replacen(&self.find, &self.replace, 1)),
            count => Err(Misfit::Stands(count)),
        }
    }
}

/// Why a list cannot be read.
#[derive(Debug)]
pub struct ListError {
    /// The file.
    pub path: PathBuf,
    /// What is wrong with it.
    pub message: String,
}

impl fmt::Display for ListError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.path.display(), self.message)
    }
}

impl std::error::Error for ListError {}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    #[serde(default)]
    defect: Vec<Defect>,
}

/// The list of a channel; nothing where it has none.
///
/// # Errors
///
/// The file cannot be read, or is not a list.
pub fn read(root: &Path, channel: Channel) -> Result<Option<Vec<Defect>>, ListError> {
    let path = root.join(channel.list());
    let text = match fs::read_to_string(&path) {
        Ok(text) => text,
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(None),
        Err(error) => return Err(ListError { path, message: error.to_string() }),
    };
    match toml::from_str::<File>(&text) {
        Ok(file) => Ok(Some(file.defect)),
        Err(error) => Err(ListError { path, message: error.to_string() }),
    }
}
