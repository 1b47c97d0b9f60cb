//! A channel that executes its scans on a thread of its own.

use std::fmt;
use std::io;
use std::sync::Arc;
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant};

use twinrung_bytecode::AdmittedImage;
use twinrung_bytecode::channel::{Channel, FaultRecord, Representation, ScanEnd, ScanInputs, Status};
use twinrung_bytecode::index::{BitCell, EventTaskIndex, ProgramIndex, WordCell};
use twinrung_bytecode::observer::{Observer, Silent};

use super::handover::Handover;

/// Why a channel could not be put on a thread.
#[derive(Debug)]
pub enum LoadError<E> {
    /// The channel could not load the image.
    Channel(E),
    /// The system gave no thread.
    Thread(io::Error),
}

impl<E: fmt::Display> fmt::Display for LoadError<E> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            LoadError::Channel(error) => write!(f, "{error}"),
            LoadError::Thread(error) => write!(f, "no thread for it: {error}"),
        }
    }
}

/// A channel with a thread of its own. Between scans the channel is here; a scan that [`Channel::begin`] has announced
/// executes on the thread, and [`Channel::scan`] takes the channel back. The thread waits awake for the next scan, so that it
/// takes a processor for itself, and ends when this is dropped.
///
/// A prescan, a scan that was not announced and one that is observed execute where they are called.
///
/// A thread that ended by a panic, or that gave no answer within the time limit where there is one, has taken the channel
/// with it: the channel has stopped for good, and its cells cannot be seen any more.
pub struct OnThread<B> {
    job: Option<Box<Job<B>>>,
    handover: Arc<Handover<Job<B>>>,
    thread: Option<JoinHandle<()>>,
    time_limit: Option<Duration>,
    begun: Option<Instant>,
}

/// The channel, what its scan needs, and a copy of its cells as the last execution left them. None of it is requested anew.
///
/// The controller reads the copy, not the channel's own cells: a cache line that another processor has read costs a journey
/// when it is next written, and a scan writes its cells here and there, each such journey alone. The copy is written
/// from end to end by the thread that has just written the cells, and its journeys go side by side.
struct Job<B> {
    bits: Vec<u8>,
    words: Vec<u32>,
    channel: B,
    now_ms: i64,
    budget: u64,
    system_values: Vec<i32>,
    end: ScanEnd,
}

impl<B: Channel> Job<B> {
    fn execute(&mut self) {
        let inputs = ScanInputs { now_ms: self.now_ms, budget: self.budget, system_values: &self.system_values };
        self.end = self.channel.scan(inputs, &mut Silent);
        self.copy_cells();
    }

    /// Both vectors keep their room: a channel never has more cells than when it was loaded.
    fn copy_cells(&mut self) {
        self.bits.clear();
        self.bits.extend_from_slice(self.channel.bits());
        self.words.clear();
        self.words.extend_from_slice(self.channel.words());
    }
}

impl<B> OnThread<B> {
    /// How long a scan may take, from its beginning until its result is taken back; without a limit, as long as it takes.
    /// For real time only: in simulated time no clock judges.
    pub fn set_time_limit(&mut self, limit: Option<Duration>) {
        self.time_limit = limit;
    }

    fn channel(&self) -> Option<&B> {
        self.job.as_ref().map(|job| &job.channel)
    }
}

impl<B: Channel + Send + 'static> Channel for OnThread<B> {
    type LoadError = LoadError<B::LoadError>;

    const REPRESENTATION: Representation = B::REPRESENTATION;

    fn load(image: &AdmittedImage) -> Result<Self, Self::LoadError> {
        let channel = B::load(image).map_err(LoadError::Channel)?;
        let system_values = vec![0; image.image().system_values_length()];
        let (bits, words) = (channel.bits().to_vec(), channel.words().to_vec());
        let job = Job { bits, words, channel, now_ms: 0, budget: 0, system_values, end: ScanEnd::Completed };
        let handover = Arc::new(Handover::new());
        let served = Arc::clone(&handover);
        let thread = thread::Builder::new()
            .name("channel".to_owned())
            .spawn(move || served.serve(Job::execute))
            .map_err(LoadError::Thread)?;
        // What a thread requests and takes when it begins is not part of the first scan.
        handover.await_helper();
        Ok(OnThread { job: Some(Box::new(job)), handover, thread: Some(thread), time_limit: None, begun: None })
    }

    fn reset(&mut self) {
        if let Some(job) = self.job.as_mut() {
            job.channel.reset();
            job.copy_cells();
        }
    }

    fn prescan<O: Observer>(&mut self, inputs: ScanInputs<'_>, observer: &mut O) -> ScanEnd {
        let Some(job) = self.job.as_mut() else { return ScanEnd::BudgetExceeded };
        let end = job.channel.prescan(inputs, observer);
        job.copy_cells();
        end
    }

    fn begin<O: Observer>(&mut self, inputs: ScanInputs<'_>) {
        // An observer stays with its owner.
        if O::ACTIVE {
            return;
        }
        let Some(mut job) = self.job.take() else { return };
        job.now_ms = inputs.now_ms;
        job.budget = inputs.budget;
        job.system_values.clear();
        job.system_values.extend_from_slice(inputs.system_values);
        self.begun = self.time_limit.map(|_| Instant::now());
        self.handover.lend(job);
    }

    fn scan<O: Observer>(&mut self, inputs: ScanInputs<'_>, observer: &mut O) -> ScanEnd {
        if let Some(job) = self.job.as_mut() {
            let end = job.channel.scan(inputs, observer);
            job.copy_cells();
            return end;
        }
        let until = self.begun.zip(self.time_limit).and_then(|(begun, limit)| begun.checked_add(limit));
        self.job = self.handover.take_back(until);
        // A stopped channel has no end to tell; `has_stopped` is asked first.
        self.job.as_ref().map_or(ScanEnd::BudgetExceeded, |job| job.end)
    }

    fn has_stopped(&self) -> bool {
        self.channel().is_none_or(B::has_stopped)
    }

    fn set_bit(&mut self, cell: BitCell, value: bool) {
        let Some(job) = self.job.as_mut() else { return };
        job.channel.set_bit(cell, value);
        if let (Some(copy), Some(own)) = (job.bits.get_mut(cell.position()), job.channel.bits().get(cell.position())) {
            *copy = *own;
        }
    }

    fn set_word(&mut self, cell: WordCell, value: i32) {
        let Some(job) = self.job.as_mut() else { return };
        job.channel.set_word(cell, value);
        if let (Some(copy), Some(own)) = (job.words.get_mut(cell.position()), job.channel.words().get(cell.position()))
        {
            *copy = *own;
        }
    }

    fn bits(&self) -> &[u8] {
        self.job.as_ref().map_or(&[], |job| &job.bits)
    }

    fn words(&self) -> &[u32] {
        self.job.as_ref().map_or(&[], |job| &job.words)
    }

    fn status(&self) -> Status {
        self.channel().map_or_else(Status::default, B::status)
    }

    fn events(&self, task: EventTaskIndex) -> u32 {
        self.channel().map_or(0, |channel| channel.events(task))
    }

    fn fault_record(&self, program: ProgramIndex) -> Option<FaultRecord> {
        self.channel().and_then(|channel| channel.fault_record(program))
    }

    fn path_signature(&self) -> u32 {
        self.channel().map_or(0, B::path_signature)
    }
}

impl<B> Drop for OnThread<B> {
    fn drop(&mut self) {
        // A thread that has the channel still, since the wait for it was given up, ends with its scan; nobody waits for that.
        let ends_at_once = self.job.is_some();
        self.handover.end();
        if let Some(thread) = self.thread.take().filter(|thread| ends_at_once || thread.is_finished()) {
            // What a panic of it meant was said by `has_stopped`.
            let _ = thread.join();
        }
    }
}
