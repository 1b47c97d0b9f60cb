//! Regions of rungs as dense records without dispatch.
//!
//! A region is a sequence of rungs that can neither fault nor jump. Its contacts, branches, coils, latches and one-shots
//! are series/parallel networks. Each network becomes panels: up to six contacts, and a table that says for each of their
//! 64 combinations whether current flows. The table is made once, at load, by walking the network; a scan only looks up:
//! the complemented bytes of the six cells, weighted 1, 2, 4 .. 32, add up to the place in the table. Latches and
//! one-shots are panels too, with their own bit among the contacts. Timers, comparisons, moves and sums are records of
//! a few more kinds without branches; what is left is executed as a step.
//!
//! All records of a region are put into an order that keeps every dependency (a cell's writes in their order, its reads
//! between the same writes) and in which records of one kind stand together, so that a scan is a few long loops.

pub(crate) mod effect;
pub(crate) mod function;
pub(crate) mod lower;
mod network;
pub(crate) mod record;
mod run;
mod schedule;

use alloc::vec::Vec;

use record::{Pools, Records};

/// What a run's records are.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
#[repr(u8)]
pub(crate) enum Kind {
    /// Networks of up to four contacts.
    FourContacts = 0,
    /// Networks of five or six contacts.
    SixContacts = 1,
    /// Integer comparisons.
    Compare = 2,
    /// Bits out of words.
    Extract = 3,
    /// Bits into words.
    Insert = 4,
    /// TON.
    OnDelay = 5,
    /// TOF.
    OffDelay = 6,
    /// RTO.
    Retentive = 7,
    /// MOV and CLR of integers.
    Move = 8,
    /// ADD and SUB of integers.
    Sum = 9,
    /// Any other instruction.
    Other = 10,
}

impl Kind {
    /// All kinds, in the order in which runs follow each other.
    pub(crate) const ALL: [Kind; 11] = [
        Kind::FourContacts,
        Kind::SixContacts,
        Kind::Compare,
        Kind::Extract,
        Kind::Insert,
        Kind::OnDelay,
        Kind::OffDelay,
        Kind::Retentive,
        Kind::Move,
        Kind::Sum,
        Kind::Other,
    ];
}

/// Consecutive records of one kind.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Run {
    /// Their kind.
    pub(crate) kind: Kind,
    /// First record in the pool of the kind.
    pub(crate) begin: u32,
    /// One past the last.
    pub(crate) end: u32,
}

/// A sequence of rungs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Region {
    /// First run.
    pub(crate) first_run: u32,
    /// Runs.
    pub(crate) runs: u32,
    /// The step after its last rung.
    pub(crate) end: u32,
    /// Instructions on its rungs.
    pub(crate) executed: u32,
    /// First of its guards: PRE cells of timers, which must not be negative, nor the ACC behind them.
    pub(crate) first_guard: u32,
    /// Guards.
    pub(crate) guards: u32,
}

/// All regions of an application.
#[derive(Debug, Clone)]
pub(crate) struct Panels {
    /// Regions.
    pub(crate) regions: Vec<Region>,
    /// Runs.
    pub(crate) runs: Vec<Run>,
    /// PRE cells of timers.
    pub(crate) guards: Vec<u32>,
    /// Records.
    pub(crate) records: Records,
}

impl Panels {
    /// The region's runs.
    fn runs_of(&self, region: &Region) -> &[Run] {
        let begin = region.first_run as usize;
        self.runs.get(begin..begin.saturating_add(region.runs as usize)).unwrap_or(&[])
    }

    /// The region's guards.
    fn guards_of(&self, region: &Region) -> &[u32] {
        let begin = region.first_guard as usize;
        self.guards.get(begin..begin.saturating_add(region.guards as usize)).unwrap_or(&[])
    }
}

/// Records before the size of the banks is known.
pub(crate) type WidePools = Pools<u32>;
