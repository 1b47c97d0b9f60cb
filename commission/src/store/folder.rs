//! A folder as storage.

use std::fs::{self, File};
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};

use super::{Slot, Storage};

/// The file that a write begins with. One that is left over was never acknowledged, and the next write replaces it.
pub const TEMPORARY: &str = "state.new";

/// The file that is locked while a command is at work on the controller.
const LOCK: &str = "in-use";

/// A folder that one process has to itself.
#[derive(Debug)]
pub struct FolderStorage {
    folder: PathBuf,
    temporary: Option<File>,
    in_use: File,
}

impl FolderStorage {
    /// Opens the folder of a controller, and keeps others from it until this is dropped.
    ///
    /// # Errors
    ///
    /// There is no such folder; another process has it ([`ErrorKind::WouldBlock`]).
    pub fn open(folder: &Path) -> io::Result<FolderStorage> {
        let in_use = File::options().create(true).truncate(false).write(true).open(folder.join(LOCK))?;
        in_use.try_lock().map_err(|error| match error {
            fs::TryLockError::WouldBlock => {
                io::Error::new(ErrorKind::WouldBlock, "another command is at work on this controller")
            }
            fs::TryLockError::Error(error) => error,
        })?;
        Ok(FolderStorage { folder: folder.to_owned(), temporary: None, in_use })
    }

    fn temporary(&mut self) -> io::Result<&mut File> {
        self.temporary.as_mut().ok_or_else(|| io::Error::other("there is no temporary file"))
    }
}

impl Drop for FolderStorage {
    /// Closing the file is not enough: a process that is being started holds a copy of it for a moment.
    fn drop(&mut self) {
        // Where this fails, closing the file is what is left.
        let _ = self.in_use.unlock();
    }
}

impl Storage for FolderStorage {
    type Error = io::Error;

    fn read(&mut self, slot: Slot) -> io::Result<Option<Vec<u8>>> {
        match fs::read(self.folder.join(slot.file_name())) {
            Ok(bytes) => Ok(Some(bytes)),
            Err(error) if error.kind() == ErrorKind::NotFound => Ok(None),
            Err(error) => Err(error),
        }
    }

    fn create_temporary(&mut self) -> io::Result<()> {
        self.temporary = Some(File::create(self.folder.join(TEMPORARY))?);
        Ok(())
    }

    fn append(&mut self, piece: &[u8]) -> io::Result<()> {
        self.temporary()?.write_all(piece)
    }

    fn sync_temporary(&mut self) -> io::Result<()> {
        self.temporary()?.sync_all()
    }

    fn rename_temporary(&mut self, to: Slot) -> io::Result<()> {
        self.temporary = None;
        fs::rename(self.folder.join(TEMPORARY), self.folder.join(to.file_name()))
    }

    fn sync_folder(&mut self) -> io::Result<()> {
        sync(&self.folder)
    }
}

/// Makes the names in a folder durable. Systems whose folders cannot be opened do so by themselves.
#[cfg(unix)]
pub fn sync(folder: &Path) -> io::Result<()> {
    File::open(folder)?.sync_all()
}

/// Makes the names in a folder durable. Systems whose folders cannot be opened do so by themselves.
#[cfg(not(unix))]
pub fn sync(_folder: &Path) -> io::Result<()> {
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::FolderStorage;

    /// A process that is being started holds copies of all open files until its program is there.
    #[test]
    fn folder_when_dropped_while_a_copy_of_its_lock_is_open_then_the_next_command_has_it() {
        let folder = tempfile::tempdir().unwrap();
        let storage = FolderStorage::open(folder.path()).unwrap();
        let copy = storage.in_use.try_clone().unwrap();
        drop(storage);
        assert!(FolderStorage::open(folder.path()).is_ok());
        drop(copy);
    }
}
