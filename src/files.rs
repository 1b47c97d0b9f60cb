//! Writing files: whole, or not at all.

use std::io::{self, Write};
use std::path::Path;

/// Writes a file under a temporary name beside its place, flushes it to the disk and renames it: a reader sees the old file or
/// the new one.
pub fn write_whole(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let folder = match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    };
    let mut file = tempfile::NamedTempFile::new_in(folder)?;
    file.write_all(bytes)?;
    file.as_file().sync_all()?;
    file.persist(path).map_err(|error| error.error)?;
    Ok(())
}
