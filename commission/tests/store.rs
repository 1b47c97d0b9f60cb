//! The store when power is lost: at every step, with everything that a disk may have made of what was not yet durable; and
//! with a real process that is killed.

mod common;

use std::collections::BTreeMap;
use std::fmt;
use std::io::{BufRead, BufReader, Write};
use std::process::{Command, Stdio};

use common::controller;
use twinrung_commission::store::{FolderStorage, PIECE_BYTES, Slot, Storage, Store, StoreError, TEMPORARY};
use twinrung_commission::{Application, ControllerState};

/// What was not yet durable when power was lost.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Tail {
    Gone,
    Half,
    Zeros,
    Whole,
}

/// Power is lost.
#[derive(Debug, PartialEq, Eq)]
struct PowerLost;

impl fmt::Display for PowerLost {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("power is lost")
    }
}

impl std::error::Error for PowerLost {}

/// A file as a disk has it: what a reader sees, and how much of it is durable.
#[derive(Debug, Clone, Default)]
struct OnDisk {
    bytes: Vec<u8>,
    durable: usize,
}

/// A disk that loses power before a chosen step.
#[derive(Debug, Clone, Default)]
struct Disk {
    files: Vec<OnDisk>,
    temporary: Option<usize>,
    names: BTreeMap<Slot, usize>,
    durable_names: BTreeMap<Slot, usize>,
    steps_left: Option<usize>,
    steps: usize,
    syncs_files: bool,
}

impl Disk {
    fn new() -> Disk {
        Disk { syncs_files: true, ..Disk::default() }
    }

    fn step(&mut self) -> Result<(), PowerLost> {
        self.steps += 1;
        match &mut self.steps_left {
            Some(0) => Err(PowerLost),
            Some(left) => {
                *left -= 1;
                Ok(())
            }
            None => Ok(()),
        }
    }

    /// The disk after power came back: the names that were durable or those that were not, and each file with what became of
    /// its tail.
    fn after_power_loss(&self, names_survived: bool, tail: Tail) -> Disk {
        let files = self
            .files
            .iter()
            .map(|file| {
                let (durable, rest) = file.bytes.split_at(file.durable);
                let rest = match tail {
                    Tail::Gone => Vec::new(),
                    Tail::Half => rest[..rest.len() / 2].to_vec(),
                    Tail::Zeros => vec![0; rest.len()],
                    Tail::Whole => rest.to_vec(),
                };
                let bytes = [durable, &rest].concat();
                OnDisk { durable: bytes.len(), bytes }
            })
            .collect();
        let names = if names_survived { self.names.clone() } else { self.durable_names.clone() };
        Disk { files, durable_names: names.clone(), names, ..Disk::new() }
    }
}

impl Storage for &mut Disk {
    type Error = PowerLost;

    fn read(&mut self, slot: Slot) -> Result<Option<Vec<u8>>, PowerLost> {
        Ok(self.names.get(&slot).map(|file| self.files[*file].bytes.clone()))
    }

    fn create_temporary(&mut self) -> Result<(), PowerLost> {
        self.step()?;
        self.temporary = Some(self.files.len());
        self.files.push(OnDisk::default());
        Ok(())
    }

    fn append(&mut self, piece: &[u8]) -> Result<(), PowerLost> {
        self.step()?;
        let file = self.temporary.unwrap();
        self.files[file].bytes.extend(piece);
        Ok(())
    }

    fn sync_temporary(&mut self) -> Result<(), PowerLost> {
        self.step()?;
        let file = self.temporary.unwrap();
        self.files[file].durable = self.files[file].bytes.len() * usize::from(self.syncs_files);
        Ok(())
    }

    fn rename_temporary(&mut self, to: Slot) -> Result<(), PowerLost> {
        self.step()?;
        self.names.insert(to, self.temporary.take().unwrap());
        Ok(())
    }

    fn sync_folder(&mut self) -> Result<(), PowerLost> {
        self.step()?;
        self.durable_names = self.names.clone();
        Ok(())
    }
}

/// A controller with an application of these bytes.
fn with_image(mut state: ControllerState, image: Vec<u8>) -> ControllerState {
    state.application =
        Some(Application { name: "Cell".to_owned(), image, instructions: Vec::new(), from_image: false });
    state
}

/// States that differ: the image of the n-th is longer than a piece.
fn state(number: u8) -> ControllerState {
    with_image(controller(), vec![number; PIECE_BYTES + 17 * usize::from(number)])
}

/// Everything that a disk may be after power was lost in the third write, before a step.
fn disks_after_loss(step: usize) -> Vec<(Disk, bool)> {
    let mut disk = Disk::new();
    let (mut store, _) = Store::open(&mut disk).unwrap();
    store.keep(&state(1)).unwrap();
    store.keep(&state(2)).unwrap();
    disk.steps_left = Some(step);
    let (mut store, _) = Store::open(&mut disk).unwrap();
    let acknowledged = store.keep(&state(3)).is_ok();
    let tails = [Tail::Gone, Tail::Half, Tail::Zeros, Tail::Whole];
    [false, true]
        .into_iter()
        .flat_map(|survived| tails.map(|tail| (disk.after_power_loss(survived, tail), acknowledged)))
        .collect()
}

/// The steps of a write of two pieces and its few bytes around: create, two or three appends, sync, rename, sync.
fn steps_of_a_write() -> usize {
    let mut disk = Disk::new();
    let (mut store, _) = Store::open(&mut disk).unwrap();
    store.keep(&state(3)).unwrap();
    disk.steps
}

/// REQ-KEEP-001, REQ-KEEP-002. At every step, whatever became of what was not durable.
#[test]
fn store_when_power_is_lost_before_any_step_then_the_last_acknowledged_state_or_the_next_one_is_there() {
    let mut found = BTreeMap::new();
    for step in 0..=steps_of_a_write() {
        for (mut disk, acknowledged) in disks_after_loss(step) {
            let (store, opened) = Store::open(&mut disk).unwrap();
            let (generation, state_found) = (store.generation(), opened.state.unwrap());
            let expected = [state(2), state(3)][usize::try_from(generation - 2).unwrap()].clone();
            assert!(state_found == expected, "step {step}: generation {generation} holds another state");
            assert!(!acknowledged || generation == 3, "step {step}: what was acknowledged is lost");
            assert_eq!(opened.damaged, [], "step {step}: a torn record has the name of a slot");
            *found.entry((step, generation)).or_insert(0) += 1;
        }
    }
    println!("(step, generation found): times {found:?}");
    assert!(steps_of_a_write() >= 6);
    assert!(found.contains_key(&(0, 2)) && found.contains_key(&(steps_of_a_write(), 3)));
}

/// REQ-KEEP-001. After a loss the next write goes through, and is there after the next loss.
#[test]
fn store_when_power_came_back_then_the_next_state_is_kept() {
    for step in 0..=steps_of_a_write() {
        for (mut disk, _) in disks_after_loss(step) {
            Store::open(&mut disk).unwrap().0.keep(&state(4)).unwrap();
            let mut later = disk.after_power_loss(false, Tail::Gone);
            assert!(Store::open(&mut later).unwrap().1.state == Some(state(4)), "step {step}");
        }
    }
}

/// REQ-KEEP-002. The test above would see a loss: a disk that does not do as it says loses a state, and the store says so.
#[test]
fn store_when_the_disk_does_not_sync_what_it_says_then_the_torn_record_is_refused_and_reported() {
    let mut disk = Disk::new();
    Store::open(&mut disk).unwrap().0.keep(&state(1)).unwrap();
    disk.syncs_files = false;
    Store::open(&mut disk).unwrap().0.keep(&state(2)).unwrap();
    for tail in [Tail::Gone, Tail::Half, Tail::Zeros] {
        let mut after = disk.after_power_loss(true, tail);
        let (store, opened) = Store::open(&mut after).unwrap();
        assert_eq!((store.generation(), opened.damaged), (1, vec![Slot::B]));
        assert!(opened.state == Some(state(1)));
    }
}

/// REQ-KEEP-002
#[test]
fn store_when_no_record_is_whole_then_it_is_not_taken_for_a_new_controller() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join(Slot::A.file_name()), b"twinrung state 1, and then something else").unwrap();
    let opened = Store::open(FolderStorage::open(folder.path()).unwrap());
    assert!(matches!(opened, Err(StoreError::Damaged(_))));
}

/// REQ-KEEP-002. Any single byte of a record.
#[test]
fn record_when_any_byte_is_changed_or_missing_then_the_state_before_it_is_taken() {
    let folder = tempfile::tempdir().unwrap();
    let keep = |number| {
        let (mut store, _) = Store::open(FolderStorage::open(folder.path()).unwrap()).unwrap();
        store.keep(&with_image(controller(), vec![number; 40])).unwrap();
    };
    keep(1);
    keep(2);
    let path = folder.path().join(Slot::B.file_name());
    let whole = std::fs::read(&path).unwrap();
    let changed = (0..whole.len()).map(|at| {
        let mut bytes = whole.clone();
        bytes[at] ^= 0x10;
        bytes
    });
    let cut = (0..whole.len()).map(|length| whole[..length].to_vec());
    let longer = std::iter::once([whole.clone(), vec![0]].concat());
    for bytes in changed.chain(cut).chain(longer) {
        std::fs::write(&path, &bytes).unwrap();
        let (store, opened) = Store::open(FolderStorage::open(folder.path()).unwrap()).unwrap();
        assert_eq!((store.generation(), opened.damaged), (1, vec![Slot::B]));
    }
}

/// REQ-KEEP-004
#[test]
fn folder_when_another_process_is_at_work_then_it_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let _first = FolderStorage::open(folder.path()).unwrap();
    assert_eq!(FolderStorage::open(folder.path()).unwrap_err().kind(), std::io::ErrorKind::WouldBlock);
}

/// A folder whose process stops before a chosen step, says so, and waits to be killed.
struct Stopping {
    folder: FolderStorage,
    steps_left: usize,
}

impl Stopping {
    fn step(&mut self) {
        let waits = self.steps_left == 0;
        self.steps_left = self.steps_left.saturating_sub(1);
        std::iter::once(()).filter(|()| waits).for_each(|()| {
            say("waiting");
            loop {
                std::thread::park();
            }
        });
    }
}

/// One line for the process that kills this one.
fn say(word: &str) {
    let mut out = std::io::stdout().lock();
    writeln!(out, "\n{SAID}{word}").unwrap();
    out.flush().unwrap();
}

const SAID: &str = "the writer is ";
const FOLDER: &str = "TWINRUNG_TEST_FOLDER";
const STEP: &str = "TWINRUNG_TEST_STEP";

impl Storage for Stopping {
    type Error = std::io::Error;

    fn read(&mut self, slot: Slot) -> std::io::Result<Option<Vec<u8>>> {
        self.folder.read(slot)
    }

    fn create_temporary(&mut self) -> std::io::Result<()> {
        self.step();
        self.folder.create_temporary()
    }

    fn append(&mut self, piece: &[u8]) -> std::io::Result<()> {
        self.step();
        self.folder.append(piece)
    }

    fn sync_temporary(&mut self) -> std::io::Result<()> {
        self.step();
        self.folder.sync_temporary()
    }

    fn rename_temporary(&mut self, to: Slot) -> std::io::Result<()> {
        self.step();
        self.folder.rename_temporary(to)
    }

    fn sync_folder(&mut self) -> std::io::Result<()> {
        self.step();
        self.folder.sync_folder()
    }
}

/// What the killed process does: nothing, unless a folder is named to it.
#[test]
fn writer_when_a_folder_is_named_then_it_keeps_the_next_state_and_stops_before_its_step() {
    std::env::var_os(FOLDER).into_iter().for_each(|folder| {
        let steps_left = std::env::var(STEP).unwrap().parse().unwrap();
        let folder = FolderStorage::open(folder.as_ref()).unwrap();
        let (mut store, _) = Store::open(Stopping { folder, steps_left }).unwrap();
        store.keep(&state(3)).unwrap();
        say("acknowledged");
        loop {
            std::thread::park();
        }
    });
}

/// REQ-KEEP-001. A process that is killed at every step of a write to a real folder.
#[test]
fn store_when_its_process_is_killed_before_any_step_then_the_last_acknowledged_state_or_the_next_one_is_there() {
    let mut generations = Vec::new();
    for step in 0..=steps_of_a_write() {
        let folder = tempfile::tempdir().unwrap();
        let open = || Store::open(FolderStorage::open(folder.path()).unwrap()).unwrap();
        open().0.keep(&state(1)).unwrap();
        open().0.keep(&state(2)).unwrap();
        let mut writer = Command::new(std::env::current_exe().unwrap())
            .args(["writer_when_a_folder_is_named", "--nocapture", "--test-threads=1"])
            .env(FOLDER, folder.path())
            .env(STEP, step.to_string())
            .stdout(Stdio::piped())
            .spawn()
            .unwrap();
        let lines = BufReader::new(writer.stdout.take().unwrap()).lines();
        let said = lines.map_while(Result::ok).find_map(|line| line.strip_prefix(SAID).map(str::to_owned)).unwrap();
        writer.kill().unwrap();
        writer.wait().unwrap();
        let (store, opened) = open();
        let generation = store.generation();
        assert_eq!(opened.damaged, []);
        assert!(opened.state == Some(state(u8::try_from(generation).unwrap())), "step {step}");
        generations.push((said, generation));
    }
    println!("{generations:?}; left over: {TEMPORARY}");
    let last = generations.len() - 1;
    assert_eq!(generations[0], ("waiting".to_owned(), 2));
    assert_eq!(generations[last], ("acknowledged".to_owned(), 3));
    assert!(generations.iter().all(|(said, generation)| said == "waiting" || *generation == 3));
}
