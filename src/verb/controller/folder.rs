//! The folder that keeps a controller.

use std::fs;
use std::io;
use std::path::Path;

use twinrung_bytecode::signature::short_form;
use twinrung_bytecode::{AdmittedImage, admit};
use twinrung_commission::ControllerState;
use twinrung_commission::store::{FolderStorage, Opened, Store};

use crate::{failed, files, terminal};

/// A controller and where it is kept.
pub(super) struct Kept {
    store: Store<FolderStorage>,
    /// The controller.
    pub(super) state: ControllerState,
}

impl Kept {
    /// Reads the controller of a folder.
    pub(super) fn open(folder: &Path) -> io::Result<Kept> {
        let missing = || {
            let folder = folder.display();
            io::Error::other(format!(
                "{folder}: there is no controller; twinrung controller {folder} download PROJECT makes one"
            ))
        };
        if !folder.is_dir() {
            return Err(missing());
        }
        let (store, state) = open_store(folder)?;
        Ok(Kept { store, state: state.ok_or_else(missing)? })
    }

    /// Reads the controller of a folder, or makes one.
    pub(super) fn open_or_make(folder: &Path, make: impl FnOnce() -> ControllerState) -> io::Result<Kept> {
        if !folder.is_dir() {
            fs::create_dir_all(folder).map_err(|error| io::Error::other(format!("{}: {error}", folder.display())))?;
            files::sync_folder_of(folder)?;
        }
        let (store, state) = open_store(folder)?;
        Ok(Kept { store, state: state.unwrap_or_else(make) })
    }

    /// Keeps the state: when this returns, no loss of power takes it back.
    pub(super) fn keep(&mut self) -> io::Result<()> {
        self.store.keep(&self.state).map(|_| ()).map_err(failed)
    }

    /// How many states have been kept.
    pub(super) fn generation(&self) -> u64 {
        self.store.generation()
    }

    /// The application, as a loader admits it: nobody is trusted, not even the folder.
    pub(super) fn admitted(&self) -> io::Result<Option<(AdmittedImage, &[u8])>> {
        let Some(application) = &self.state.application else { return Ok(None) };
        let image = admit(&application.image)
            .map_err(|error| io::Error::other(format!("the application in the controller is refused: {error}")))?;
        if let Some(signature) = &self.state.signature
            && signature.id != *image.application_signature()
        {
            return Err(io::Error::other(format!(
                "the application in the controller is {}, its safety task signature {}",
                short_form(image.application_signature()),
                short_form(&signature.id)
            )));
        }
        Ok(Some((image, &application.image)))
    }

    /// The image with both versions of an accepted online edit, and whether the changed one executes.
    pub(super) fn both_versions(&self) -> io::Result<Option<(AdmittedImage, &[u8], bool)>> {
        // The edit is one of an application that still is what its signature says.
        self.admitted()?;
        let Some((bytes, tested)) = self.state.both_versions() else { return Ok(None) };
        let image = admit(bytes)
            .map_err(|error| io::Error::other(format!("the online edit in the controller is refused: {error}")))?;
        Ok(Some((image, bytes, tested)))
    }

    /// What executes: the application, or with a tested online edit the changed one.
    pub(super) fn executing(&self) -> io::Result<Option<(AdmittedImage, &[u8])>> {
        let own = self.admitted()?;
        let Some(bytes) = self.state.tested() else { return Ok(own) };
        let image = admit(bytes)
            .map_err(|error| io::Error::other(format!("the online edit in the controller is refused: {error}")))?;
        Ok(Some((image, bytes)))
    }
}

fn open_store(folder: &Path) -> io::Result<(Store<FolderStorage>, Option<ControllerState>)> {
    let in_folder = |error: &dyn std::fmt::Display| io::Error::other(format!("{}: {error}", folder.display()));
    let storage = FolderStorage::open(folder).map_err(|error| in_folder(&error))?;
    let (store, Opened { state, damaged }) = Store::open(storage).map_err(|error| in_folder(&error))?;
    for slot in damaged {
        terminal::tell(format_args!(
            "twinrung: {} is damaged; this is state {}: check signature, lock and forces before going on",
            folder.join(slot.file_name()).display(),
            store.generation()
        ));
    }
    Ok((store, state))
}
