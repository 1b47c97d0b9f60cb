//! Where a controller is kept: two slots, written in turn, each whole or not at all.
//!
//! A write goes to a temporary file, which is synced, renamed onto the slot that does not hold the newest state, and made
//! durable by syncing the folder; only then is it acknowledged. A reader takes the slot of the highest generation whose
//! checksum is right. So at every moment one slot holds the last acknowledged state, or the one after it.

mod folder;

use std::fmt;

pub use folder::{FolderStorage, TEMPORARY};

use crate::record::{self, RecordError, RecordKind};
use crate::state::ControllerState;

/// A place for a state.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Slot {
    /// The first.
    A,
    /// The second.
    B,
}

impl Slot {
    /// Both.
    pub const ALL: [Slot; 2] = [Slot::A, Slot::B];

    /// The name of its file.
    pub const fn file_name(self) -> &'static str {
        match self {
            Slot::A => "state.a",
            Slot::B => "state.b",
        }
    }

    const fn other(self) -> Slot {
        match self {
            Slot::A => Slot::B,
            Slot::B => Slot::A,
        }
    }
}

/// Bytes that are handed to the storage at once.
pub const PIECE_BYTES: usize = 64 * 1024;

/// What a store needs of a file system, step by step, so that a test can let any step be the last one.
pub trait Storage {
    /// Why a step failed.
    type Error: std::error::Error + Send + Sync + 'static;

    /// The bytes of a slot; `None` where there is none.
    fn read(&mut self, slot: Slot) -> Result<Option<Vec<u8>>, Self::Error>;

    /// Makes the temporary file anew, empty.
    fn create_temporary(&mut self) -> Result<(), Self::Error>;

    /// Appends to it.
    fn append(&mut self, piece: &[u8]) -> Result<(), Self::Error>;

    /// Makes what was appended durable.
    fn sync_temporary(&mut self) -> Result<(), Self::Error>;

    /// Gives it the name of a slot, in one step, in place of what had that name.
    fn rename_temporary(&mut self, to: Slot) -> Result<(), Self::Error>;

    /// Makes the names durable.
    fn sync_folder(&mut self) -> Result<(), Self::Error>;
}

/// Why a state cannot be read or written.
#[derive(Debug)]
pub enum StoreError<E> {
    /// The storage.
    Storage(E),
    /// There are slots, and none of them is whole.
    Damaged(RecordError),
    /// The state cannot be written as a record.
    Record(RecordError),
}

impl<E: fmt::Display> fmt::Display for StoreError<E> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            StoreError::Storage(error) => write!(f, "{error}"),
            StoreError::Damaged(error) => write!(f, "no state of this controller is whole: {error}"),
            StoreError::Record(error) => write!(f, "the state cannot be written: {error}"),
        }
    }
}

impl<E: fmt::Debug + fmt::Display> std::error::Error for StoreError<E> {}

/// Keeps the state of one controller.
#[derive(Debug)]
pub struct Store<S> {
    storage: S,
    generation: u64,
    newest: Slot,
}

/// What a store held when it was opened.
#[derive(Debug)]
pub struct Opened {
    /// The last whole state; `None` where nothing was ever kept.
    pub state: Option<ControllerState>,
    /// Slots whose bytes are no whole record: something other than a loss of power has changed them.
    pub damaged: Vec<Slot>,
}

impl<S: Storage> Store<S> {
    /// Reads the last whole state.
    ///
    /// # Errors
    ///
    /// [`StoreError::Storage`]; [`StoreError::Damaged`] where something is there and nothing of it is whole.
    pub fn open(mut storage: S) -> Result<(Store<S>, Opened), StoreError<S::Error>> {
        let mut best: Option<(u64, Slot, ControllerState)> = None;
        let mut damaged = Vec::new();
        let mut why = None;
        for slot in Slot::ALL {
            let Some(bytes) = storage.read(slot).map_err(StoreError::Storage)? else { continue };
            match record::decode::<ControllerState>(RecordKind::Controller, &bytes) {
                Err(error) => {
                    damaged.push(slot);
                    why = Some(error);
                }
                Ok((generation, mut state, image)) => {
                    if let Some(application) = &mut state.application {
                        application.image = image;
                    }
                    if best.as_ref().is_none_or(|(newest, _, _)| generation > *newest) {
                        best = Some((generation, slot, state));
                    }
                }
            }
        }
        match (best, why) {
            (None, Some(error)) => Err(StoreError::Damaged(error)),
            (None, None) => {
                let store = Store { storage, generation: 0, newest: Slot::B };
                Ok((store, Opened { state: None, damaged }))
            }
            (Some((generation, newest, state)), _) => {
                Ok((Store { storage, generation, newest }, Opened { state: Some(state), damaged }))
            }
        }
    }

    /// How many states have been kept.
    pub fn generation(&self) -> u64 {
        self.generation
    }

    /// Keeps a state. When this returns without an error it is acknowledged: no loss of power takes it back.
    ///
    /// # Errors
    ///
    /// [`StoreError::Storage`], [`StoreError::Record`]. What was kept before is still kept, or this state is.
    pub fn keep(&mut self, state: &ControllerState) -> Result<u64, StoreError<S::Error>> {
        let generation = self.generation.saturating_add(1);
        let image = state.application.as_ref().map_or(&[] as &[u8], |application| &application.image);
        let bytes = record::encode(RecordKind::Controller, generation, state, image).map_err(StoreError::Record)?;
        let slot = self.newest.other();
        self.write(slot, &bytes).map_err(StoreError::Storage)?;
        self.generation = generation;
        self.newest = slot;
        Ok(generation)
    }

    fn write(&mut self, slot: Slot, bytes: &[u8]) -> Result<(), S::Error> {
        self.storage.create_temporary()?;
        for piece in bytes.chunks(PIECE_BYTES) {
            self.storage.append(piece)?;
        }
        self.storage.sync_temporary()?;
        self.storage.rename_temporary(slot)?;
        self.storage.sync_folder()
    }
}
