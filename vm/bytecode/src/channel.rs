//! What a controller asks of a channel. Definitions only: nothing here computes.

use crate::index::{BitCell, EventTaskIndex, ProgramIndex, RoutineIndex, WordCell};
use crate::observer::Observer;

/// Where something happened.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Place {
    /// The program that the task was running.
    pub program: ProgramIndex,
    /// The routine (of that program, or of an Add-On Instruction).
    pub routine: RoutineIndex,
    /// The rung, from 0.
    pub rung: u32,
    /// The instruction on the rung, from 0, counted in the order of the code without branch marks.
    pub element: u32,
}

/// A major fault that an instruction raised: type 4 with a code (general-instructions.md 2.5).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct MajorFault {
    /// The code, e.g. 20 for a subscript out of range.
    pub code: u16,
    /// Which instruction raised it.
    pub place: Place,
}

/// The MajorFaultRecord of a program (general-instructions.md A.10): time low and high, type in the low and code in the
/// high half of one word, and eight words of information.
pub type FaultRecord = [i32; 11];

/// How an execution ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ScanEnd {
    /// All scheduled programs ran.
    Completed,
    /// A recoverable fault that no fault routine cleared; the programs after it did not run.
    MajorFault(MajorFault),
    /// More instructions than the budget were executed. Checked when a backward JMP is taken, and at the end.
    BudgetExceeded,
}

/// What a scan receives besides its own memory; constant while it runs.
#[derive(Debug, Clone, Copy)]
pub struct ScanInputs<'a> {
    /// Time at the start of the scan in ms, the same for every instruction.
    pub now_ms: i64,
    /// Instructions that the scan may execute.
    pub budget: u64,
    /// Values of system attributes, sampled once for both channels; where each lies:
    /// [`crate::image::SystemValueRecord::first`].
    pub system_values: &'a [i32],
}

/// The arithmetic status and what else drives logic without being a tag. Compared like a tag.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Status {
    /// S:FS
    pub first_scan: bool,
    /// S:V
    pub overflow: bool,
    /// S:Z
    pub zero: bool,
    /// S:N
    pub negative: bool,
    /// S:C
    pub carry: bool,
    /// S:MINOR
    pub minor_fault: bool,
    /// Minor faults 4/4, 4/5, 4/6 and 4/7 logged since the last prescan.
    pub minor_faults: u32,
    /// Instructions executed since loading: each instruction of the catalog and each Add-On call that was reached, true
    /// or false, counts 1, and FAL and FSC 1 more for each element they process. What a library half executes within
    /// a safety application instruction does not count.
    pub executed: u64,
    /// Recoverable faults that a program's fault routine cleared since the last prescan.
    pub cleared_faults: u32,
}

/// How a channel holds its cells.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Representation {
    /// A bit cell is the byte 0 or 1; a word cell is the value.
    Plain,
    /// Every byte and word is the bitwise complement of the plain form.
    Complemented,
}

/// One of the two interpreters, as the controller sees it.
pub trait Channel: Sized {
    /// Why an admitted image could not be loaded (a resource of this channel ran out).
    type LoadError: core::fmt::Debug + core::fmt::Display;

    /// How it holds its cells.
    const REPRESENTATION: Representation;

    /// Decodes an admitted image into the channel's own form and sets every cell to its initial value. The only call
    /// that allocates.
    fn load(image: &crate::AdmittedImage) -> Result<Self, Self::LoadError>;

    /// Sets every cell, and all private state, to what it was after `load`.
    fn reset(&mut self);

    /// Program to Run: prescans every scheduled program (main routine and what JSR reaches, then the fault routine).
    /// Clears the status but for `executed`, and arms S:FS for the next scan.
    fn prescan<O: Observer>(&mut self, inputs: ScanInputs<'_>, observer: &mut O) -> ScanEnd;

    /// The controller will ask for this scan next. A channel with a thread or a processor of its own may begin it now, unless
    /// it is observed (`O::ACTIVE`); [`Channel::scan`], which follows, then waits for its end. Between the two nothing is
    /// asked of the channel.
    fn begin<O: Observer>(&mut self, inputs: ScanInputs<'_>) {
        let _ = inputs;
    }

    /// One execution of the safety task.
    fn scan<O: Observer>(&mut self, inputs: ScanInputs<'_>, observer: &mut O) -> ScanEnd;

    /// Whether the channel has stopped: what it runs on is gone, or gave no answer in time. It executes no more, and what
    /// it says of its cells and of how a scan ended means nothing. An interpreter by itself never stops.
    fn has_stopped(&self) -> bool {
        false
    }

    /// Writes a frozen input or mapped tag before a scan. Out of range: no effect.
    fn set_bit(&mut self, cell: BitCell, value: bool);

    /// Writes a frozen input or mapped tag before a scan. Out of range: no effect.
    fn set_word(&mut self, cell: WordCell, value: i32);

    /// All bit cells of the image, one byte each, in the channel's representation.
    fn bits(&self) -> &[u8];

    /// All word cells of the image, in the channel's representation.
    fn words(&self) -> &[u32];

    /// The status after the last execution.
    fn status(&self) -> Status;

    /// How often EVENT triggered this task in the last scan.
    fn events(&self, task: EventTaskIndex) -> u32;

    /// The MajorFaultRecord of a program, in plain form; `None` when there is no such program.
    fn fault_record(&self, program: ProgramIndex) -> Option<FaultRecord>;

    /// The signature of the path that control took through the last execution (docs/spec/scan.md, REQ-SCAN-010).
    fn path_signature(&self) -> u32;
}
