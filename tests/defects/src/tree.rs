//! A copy of the project into which defects are put, kept between runs so that little has to be built again.

use std::collections::BTreeSet;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use crate::Defect;

/// The copy.
#[derive(Debug)]
pub struct ScratchTree {
    root: PathBuf,
}

/// A defect in the copy, taken out again when this is dropped.
#[derive(Debug)]
pub struct Applied {
    path: PathBuf,
    original: String,
}

impl Drop for Applied {
    fn drop(&mut self) {
        if let Err(error) = fs::write(&self.path, &self.original) {
            eprintln!("{} keeps a defect: {error}", self.path.display());
        }
    }
}

impl ScratchTree {
    /// Makes the copy at `root` equal to the project at `from`. Files that are equal already are not touched: what was built
    /// from them stays valid.
    ///
    /// # Errors
    ///
    /// A file cannot be read or written.
    pub fn copy(from: &Path, root: &Path) -> io::Result<ScratchTree> {
        let (wanted, found) = (files(from)?, files(root)?);
        for gone in found.difference(&wanted) {
            fs::remove_file(root.join(gone))?;
        }
        for path in &wanted {
            let (bytes, target) = (fs::read(from.join(path))?, root.join(path));
            if fs::read(&target).ok().as_ref() != Some(&bytes) {
                target.parent().map_or(Ok(()), fs::create_dir_all)?;
                fs::write(target, bytes)?;
            }
        }
        Ok(ScratchTree { root: root.to_owned() })
    }

    /// Where it is.
    pub fn root(&self) -> &Path {
        &self.root
    }

    /// Puts a defect in.
    ///
    /// # Errors
    ///
    /// The file cannot be read or written, or the defect does not fit.
    pub fn apply(&self, defect: &Defect) -> io::Result<Applied> {
        let path = self.root.join(&defect.file);
        let original = fs::read_to_string(&path)?;
        let changed = defect.applied(&original).map_err(|misfit| io::Error::other(misfit.to_string()))?;
        fs::write(&path, changed)?;
        Ok(Applied { path, original })
    }
}

/// The files of a project, from its root; nothing that was built and nothing hidden but what cargo reads.
fn files(root: &Path) -> io::Result<BTreeSet<PathBuf>> {
    let mut found = BTreeSet::new();
    let mut open = vec![PathBuf::new()];
    while let Some(folder) = open.pop() {
        let here = root.join(&folder);
        if !here.is_dir() {
            continue;
        }
        for entry in fs::read_dir(here)? {
            let entry = entry?;
            let name = entry.file_name();
            let hidden = name.to_string_lossy().starts_with('.') && name != ".cargo";
            match entry.file_type()? {
                kind if hidden || name == "target" || kind.is_symlink() => {}
                kind if kind.is_dir() => open.push(folder.join(&name)),
                _ => {
                    found.insert(folder.join(&name));
                }
            }
        }
    }
    Ok(found)
}
