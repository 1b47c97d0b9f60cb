//! The sources of some crates with mutants in them.

use std::collections::btree_map::Entry;
use std::collections::{BTreeMap, BTreeSet};
use std::error::Error;
use std::fmt;
use std::fs;
use std::io;
use std::ops::Range;
use std::path::{Path, PathBuf};

use crate::build::{BuildError, Built, build};
use crate::list::Mutant;
use crate::weave::{self, Unwoven};

/// Mutants and the sources that they are woven into. The sources are put back when it is dropped.
#[derive(Debug)]
pub struct Loom {
    root: PathBuf,
    mutants: Vec<Mutant>,
    unwoven: Vec<(Mutant, Unwoven)>,
    /// Mutants that do not compile, by their numbers.
    unviable: BTreeSet<usize>,
    /// The root of each crate that has mutants.
    crates: BTreeSet<PathBuf>,
    originals: Originals,
}

/// The sources as they were, by their paths.
#[derive(Debug)]
struct Originals(BTreeMap<PathBuf, String>);

impl Drop for Originals {
    fn drop(&mut self) {
        for (path, text) in &self.0 {
            if let Err(error) = fs::write(path, text) {
                eprintln!("{} is still woven: {error}", path.display());
            }
        }
    }
}

/// Lines of each file that belong to a mutant.
type Places = BTreeMap<PathBuf, Vec<(Range<usize>, usize)>>;

/// Why there is nothing to run.
#[derive(Debug)]
pub enum LoomError {
    /// A source cannot be read or written.
    Source(PathBuf, io::Error),
    /// A mutant's file lies in the `src` of no crate.
    NoCrate(String),
    /// Nothing was built.
    Build(BuildError),
    /// The sources do not compile, and it is not a mutant's fault: the compiler's words.
    Errors(String),
}

impl fmt::Display for LoomError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            LoomError::Source(path, error) => write!(f, "{}: {error}", path.display()),
            LoomError::NoCrate(file) => {
                write!(f, "{file} lies in the src of no crate: give files from the root of the workspace")
            }
            LoomError::Build(error) => error.fmt(f),
            LoomError::Errors(words) => write!(f, "errors outside of the mutants:\n{words}"),
        }
    }
}

impl Error for LoomError {}

impl Loom {
    /// Takes in the mutants of the project at `root` that can be woven. Nothing is changed yet.
    ///
    /// # Errors
    ///
    /// A source cannot be read, or is of no crate.
    pub fn new(root: &Path, mutants: Vec<Mutant>) -> Result<Loom, LoomError> {
        let mut originals = BTreeMap::new();
        let mut crates = BTreeSet::new();
        let (mut woven, mut unwoven) = (Vec::new(), Vec::new());
        for mutant in mutants {
            let text = kept(&mut originals, root.join(&mutant.file))?;
            match weave::weavable(text, &mutant) {
                Ok(()) => {
                    let folder =
                        mutant.file.split_once("/src/").ok_or_else(|| LoomError::NoCrate(mutant.file.clone()))?.0;
                    crates.insert(root.join(folder).join("src/lib.rs"));
                    woven.push(mutant);
                }
                Err(why) => unwoven.push((mutant, why)),
            }
        }
        for path in &crates {
            kept(&mut originals, path.clone())?;
        }
        let (root, originals) = (root.to_owned(), Originals(originals));
        Ok(Loom { root, mutants: woven, unwoven, unviable: BTreeSet::new(), crates, originals })
    }

    /// Builds what these words tell cargo to, with all mutants that compile in it.
    ///
    /// # Errors
    ///
    /// Cargo refuses, or something else than a mutant does not compile.
    pub fn build(&mut self, words: &[String]) -> Result<Built, LoomError> {
        loop {
            let places = self.write()?;
            let built = build(&self.root, words).map_err(LoomError::Build)?;
            if built.words.is_empty() {
                return Ok(built);
            }
            let before = self.unviable.len();
            for (file, line) in &built.errors {
                let own = places.get(&self.root.join(file));
                let at_fault = own.into_iter().flatten().filter(|(lines, _)| lines.contains(line));
                self.unviable.extend(at_fault.map(|(_, number)| *number));
            }
            if self.unviable.len() == before {
                return Err(LoomError::Errors(built.words.join("\n")));
            }
            println!("{} mutants do not compile", self.unviable.len());
        }
    }

    /// The mutants that compile, each with the number that switches it on.
    pub fn viable(&self) -> impl Iterator<Item = (usize, &Mutant)> {
        self.numbered().filter(|(number, _)| !self.unviable.contains(number))
    }

    /// The mutants that do not compile.
    pub fn unviable(&self) -> impl Iterator<Item = &Mutant> {
        self.numbered().filter(|(number, _)| self.unviable.contains(number)).map(|(_, mutant)| mutant)
    }

    /// The mutants that cannot be woven, and why.
    pub fn unwoven(&self) -> &[(Mutant, Unwoven)] {
        &self.unwoven
    }

    fn numbered(&self) -> impl Iterator<Item = (usize, &Mutant)> {
        self.mutants.iter().enumerate().map(|(at, mutant)| (at + 1, mutant))
    }

    /// Writes the sources with the mutants that compile. A file that is as it should be is not touched.
    fn write(&self) -> Result<Places, LoomError> {
        let mut places = Places::new();
        for (path, text) in &self.originals.0 {
            let own: Vec<(usize, &Mutant)> =
                self.viable().filter(|(_, mutant)| self.root.join(&mutant.file) == *path).collect();
            let mut woven = weave::weave(text, &own);
            if self.crates.contains(path) {
                woven.text.push_str(weave::SWITCHING);
            }
            let written = fs::read_to_string(path)
                .and_then(|now| if now == woven.text { Ok(()) } else { fs::write(path, &woven.text) });
            written.map_err(|error| LoomError::Source(path.clone(), error))?;
            places.insert(path.clone(), woven.lines);
        }
        Ok(places)
    }
}

/// The text of a source, read once.
fn kept(originals: &mut BTreeMap<PathBuf, String>, path: PathBuf) -> Result<&str, LoomError> {
    match originals.entry(path) {
        Entry::Occupied(entry) => Ok(entry.into_mut()),
        Entry::Vacant(entry) => {
            let text =
                fs::read_to_string(entry.key()).map_err(|error| LoomError::Source(entry.key().clone(), error))?;
            Ok(entry.insert(text))
        }
    }
}

#[cfg(test)]
mod tests {
    use std::process::Command;

    use tempfile::TempDir;

    use super::*;
    use crate::list::{Function, Place, Span};
    use crate::weave::SWITCH;

    const LIBRARY: &str = "/// Half of a number.\npub fn half(of: u32) -> u32 {\n    of / 2\n}\n";
    const COMMAND: &str = "fn main() {\n    println!(\"{}\", halves::half(8));\n}\n";

    /// A workspace of one crate, `halves`, which says half of 8.
    fn project() -> TempDir {
        let folder = tempfile::tempdir().unwrap();
        let write = |path: &str, text: &str| {
            let path = folder.path().join(path);
            fs::create_dir_all(path.parent().unwrap()).unwrap();
            fs::write(path, text).unwrap();
        };
        write("Cargo.toml", "[workspace]\nmembers = [\"halves\"]\nresolver = \"3\"\n");
        write("halves/Cargo.toml", "[package]\nname = \"halves\"\nversion = \"0.1.0\"\nedition = \"2024\"\n");
        write("halves/src/lib.rs", LIBRARY);
        write("halves/src/main.rs", COMMAND);
        folder
    }

    /// What cargo is told, wherever it would put what it builds otherwise.
    fn words(folder: &TempDir) -> Vec<String> {
        let target = folder.path().join("target").display().to_string();
        ["build", "--quiet", "--offline", "--target-dir", &target].map(str::to_owned).to_vec()
    }

    /// The mutant that puts something in place of the division.
    fn mutant(file: &str, replacement: &str) -> Mutant {
        let span = |from: &str, to: &str| {
            let at = |text: &str| LIBRARY.find(text).unwrap();
            Span { start: Place::of(LIBRARY, at(from)), end: Place::of(LIBRARY, at(to) + to.len()) }
        };
        Mutant {
            name: replacement.to_owned(),
            file: file.to_owned(),
            function: Some(Function { span: span("pub fn", "}") }),
            span: span("of / 2", "of / 2"),
            replacement: replacement.to_owned(),
        }
    }

    #[test]
    fn loom_when_it_has_built_then_each_mutant_that_compiles_is_switched_on_by_its_number_and_the_sources_are_put_back()
    {
        let folder = project();
        let file = "halves/src/lib.rs";
        let mutants = vec![mutant(file, "no_such_name"), mutant(file, "of * 2"), mutant(file, "of - 2")];
        let mut loom = Loom::new(folder.path(), mutants).unwrap();
        let built = loom.build(&words(&folder)).unwrap();
        assert!(built.words.is_empty());
        assert_eq!(loom.unviable().map(|mutant| mutant.name.as_str()).collect::<Vec<_>>(), ["no_such_name"]);
        let command = folder.path().join("target/debug/halves");
        let said = |number: usize| {
            let output = Command::new(&command).env(SWITCH, number.to_string()).output().unwrap();
            String::from_utf8(output.stdout).unwrap().trim().to_owned()
        };
        let viable: Vec<(String, String)> =
            loom.viable().map(|(number, mutant)| (mutant.name.clone(), said(number))).collect();
        assert_eq!(said(0), "4");
        assert_eq!(viable, [("of * 2", "16"), ("of - 2", "6")].map(|(name, said)| (name.to_owned(), said.to_owned())));
        drop(loom);
        assert_eq!(fs::read_to_string(folder.path().join(file)).unwrap(), LIBRARY);
    }

    #[test]
    fn loom_when_the_sources_are_wrong_without_a_mutant_then_that_is_said_and_no_mutant_is_blamed() {
        let folder = project();
        fs::write(folder.path().join("halves/src/main.rs"), "fn main() { no_such_name }").unwrap();
        let mut loom = Loom::new(folder.path(), vec![mutant("halves/src/lib.rs", "of * 2")]).unwrap();
        let refused = loom.build(&words(&folder)).unwrap_err();
        assert!(matches!(&refused, LoomError::Errors(words) if words.contains("no_such_name")), "{refused}");
        assert_eq!(loom.unviable().count(), 0);
    }
}
