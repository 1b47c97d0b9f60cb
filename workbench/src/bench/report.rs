//! What a measurement means: rows, headroom, and the sentence that an engineer needs.

use std::cmp::Reverse;

use serde::Serialize;
use twinrung_bytecode::bound::Bound;
use twinrung_bytecode::image::Image;
use twinrung_bytecode::index::RoutineIndex;
use twinrung_bytecode::signature::short_form;
use twinrung_bytecode::text::routine_name;
use twinrung_bytecode::{AdmittedImage, limits};
use twinrung_controller::StopReason;

use super::units::{count, left, time};
use super::{Bucket, Coverage, Estimate, Measurement, Quantiles};

/// Most rungs that a report lists.
const RUNGS_LISTED: usize = 10;
/// Buckets of the histogram in JSON and on the page.
const BUCKETS: usize = 60;
/// A watchdog is proposed at this many times the slowest scan: room for what a measurement has not seen.
const MARGIN: u64 = 2;
/// A slowest scan of more than so many medians is not the program's own.
const DISTURBED: u64 = 20;
/// Watchdogs are set in whole milliseconds.
const MILLISECOND_NS: u64 = 1_000_000;

/// A measurement, ready to be printed. Its JSON form is stable.
#[derive(Debug, Clone, Serialize)]
pub struct Report {
    /// The project's name.
    pub project: String,
    /// Its safety application signature, short.
    pub signature: String,
    /// Rungs of all routines.
    pub rungs: u64,
    /// Scans whose time was taken.
    pub scans: u64,
    /// On how many threads the channels executed.
    pub threads: u8,
    /// Period of the safety task.
    pub period_ns: u64,
    /// Its watchdog.
    pub watchdog_ns: u64,
    /// The whole scan.
    pub scan_ns: Quantiles,
    /// Inputs and mapped tags are copied into both channels.
    pub freeze_ns: Quantiles,
    /// Channel 1.
    pub primary_ns: Quantiles,
    /// Channel 2; on two threads the wait for it, after channel 1 has ended.
    pub partner_ns: Quantiles,
    /// The comparison, and a piece of the running image check.
    pub compare_ns: Quantiles,
    /// Outputs are published.
    pub publish_ns: Quantiles,
    /// How late scans began; in real time only.
    pub jitter_ns: Option<Quantiles>,
    /// What reading the clock once costs; five readings lie within the time of each scan.
    pub clock_ns: u64,
    /// Most instructions that a scan can execute (REQ-BOUND-001).
    pub bound_instructions: u64,
    /// Most instructions that one channel executed in a scan.
    pub max_instructions: u64,
    /// Most instructions that a prescan can execute (REQ-BOUND-008).
    pub bound_prescan_instructions: u64,
    /// Instructions that the prescan executed; nothing where the measurement ended in its first scan.
    pub prescan_instructions: Option<u64>,
    /// Instructions that the watchdog allows a scan, and a prescan, in simulated time.
    pub budget_instructions: u64,
    /// What of the watchdog the slowest scan left, in percent.
    pub watchdog_headroom_percent: f64,
    /// What of the period the slowest scan left, in percent.
    pub period_headroom_percent: f64,
    /// The least watchdog with room for what was measured, for the estimate and for the bound; above the period it cannot be
    /// set. Nothing where no scan was measured.
    pub possible_watchdog_ms: Option<u64>,
    /// A time for the longest path, from costs measured on this machine: an estimate of this program on this computer, and
    /// of no other controller.
    pub estimate: Option<Estimate>,
    /// Why there is no estimate though one was asked for.
    pub estimate_failed: Option<String>,
    /// Programs in the order of the schedule.
    pub programs: Vec<ProgramRow>,
    /// Routines in the order of the image.
    pub routines: Vec<RoutineRow>,
    /// The rungs whose longest path takes longest by the estimate, whether it was seen or not; without an estimate, those that
    /// executed the most instructions.
    pub most_expensive_rungs: Vec<RungRow>,
    /// The distribution of the whole scan.
    pub histogram: Vec<Bucket>,
    /// What the random inputs reached; nothing with a stimulus.
    pub inputs: Option<Coverage>,
    /// The state of a generated program after the last scan, as 16 hexadecimal digits.
    pub hash: Option<String>,
    /// Why the measurement ended early, if it did.
    pub stopped: Option<String>,
}

/// One program.
#[derive(Debug, Clone, Serialize)]
pub struct ProgramRow {
    /// Its name.
    pub program: String,
    /// Most instructions in one of the observed scans.
    pub max_instructions: u64,
    /// What a scan can execute of it at most.
    pub bound_instructions: u64,
    /// The time estimated for that, in ns.
    pub estimated_ns: Option<u64>,
}

/// One routine.
#[derive(Debug, Clone, Serialize)]
pub struct RoutineRow {
    /// The program or Add-On Instruction, and the routine: `Safety_Main/Main`.
    pub routine: String,
    /// Its rungs.
    pub rungs: u64,
    /// Most instructions in one of the observed scans.
    pub max_instructions: u64,
    /// What a scan can execute of it at most, Add-On Instructions that it calls included; 0 for a routine of an Add-On
    /// Instruction, which counts with its callers.
    pub bound_instructions: u64,
    /// The time estimated for that, in ns.
    pub estimated_ns: Option<u64>,
}

/// One rung.
#[derive(Debug, Clone, Serialize)]
pub struct RungRow {
    /// The routine.
    pub routine: String,
    /// The rung, from 0.
    pub rung: u64,
    /// Most instructions in one of the observed scans.
    pub max_instructions: u64,
    /// What a scan can execute of it at most.
    pub bound_instructions: u64,
    /// The time estimated for that, in ns.
    pub estimated_ns: Option<u64>,
    /// Its text.
    pub text: String,
}

impl Report {
    /// Of a measurement of an image, with an estimate where one was asked for, or with the reason why there is none.
    pub fn new(image: &AdmittedImage, measurement: &Measurement, estimate: Option<Result<Estimate, String>>) -> Report {
        let (estimate, estimate_failed) = match estimate {
            Some(Ok(estimate)) => (Some(estimate), None),
            Some(Err(reason)) => (None, Some(reason)),
            None => (None, None),
        };
        let records = image.image();
        let task = records.task.as_ref();
        let watchdog_us = task.map_or(0, |task| u64::from(task.watchdog_us));
        let (period_ns, watchdog_ns) = (task.map_or(0, |task| u64::from(task.period_us) * 1000), watchdog_us * 1000);
        let scan_ns = measurement.whole.quantiles();
        let [freeze_ns, primary_ns, partner_ns, compare_ns, publish_ns] =
            measurement.parts.each_ref().map(super::Distribution::quantiles);
        let bound = &measurement.bound;
        let costs = estimate.as_ref().map(|estimate| &estimate.picoseconds);
        let programs = task.iter().flat_map(|task| &task.schedule).map(|program| ProgramRow {
            program: records.programs.get(program.position()).map_or_else(String::new, |record| record.name.clone()),
            max_instructions: measurement.counts.programs.get(program.position()).copied().unwrap_or_default(),
            bound_instructions: bound.programs.get(program.position()).copied().unwrap_or_default(),
            estimated_ns: costs.and_then(|costs| costs.programs.get(program.position())).map(|ps| ps / 1000),
        });
        let routines = (0..records.routines.len()).map(|index| RoutineRow {
            routine: routine_name(records, RoutineIndex(index as u32)),
            rungs: u64::from(image.rungs(RoutineIndex(index as u32))),
            max_instructions: measurement.counts.routines.get(index).copied().unwrap_or_default(),
            bound_instructions: bound.routines.get(index).map_or(0, |routine| routine.total),
            estimated_ns: costs.and_then(|costs| costs.routines.get(index)).map(|routine| routine.total / 1000),
        });
        let (programs, routines) = (programs.collect(), routines.collect());
        let most_expensive_rungs = most_expensive(records, measurement, costs);
        Report {
            project: records.controller.name.clone(),
            signature: short_form(image.application_signature()).to_string(),
            rungs: image.rung_counts().iter().copied().map(u64::from).sum(),
            scans: measurement.scans,
            threads: measurement.threads.count(),
            period_ns,
            watchdog_ns,
            scan_ns,
            freeze_ns,
            primary_ns,
            partner_ns,
            compare_ns,
            publish_ns,
            jitter_ns: measurement.lateness.as_ref().map(super::Distribution::quantiles),
            clock_ns: measurement.clock_ns,
            bound_instructions: bound.total,
            max_instructions: measurement.instructions_max,
            bound_prescan_instructions: bound.prescan,
            prescan_instructions: measurement.prescan_instructions,
            budget_instructions: watchdog_us.saturating_mul(limits::BUDGET_PER_MICROSECOND),
            watchdog_headroom_percent: left(scan_ns.max, watchdog_ns),
            period_headroom_percent: left(scan_ns.max, period_ns),
            possible_watchdog_ms: (measurement.scans > 0)
                .then(|| possible_watchdog_ms(longest_ns(scan_ns.max, estimate.as_ref()), bound.greatest())),
            estimate,
            estimate_failed,
            programs,
            routines,
            most_expensive_rungs,
            histogram: measurement.whole.buckets(BUCKETS),
            inputs: measurement.coverage,
            hash: measurement.hash.map(|hash| format!("{hash:016x}")),
            stopped: measurement.stopped.map(|(scan, reason)| stopped(scan, reason)),
        }
    }

    /// What the watchdog could be set to, and what the headroom is.
    pub fn verdict(&self) -> String {
        let period_ms = self.period_ns / MILLISECOND_NS;
        let Some(possible) = self.possible_watchdog_ms else {
            return "No scan was measured: nothing can be said about the watchdog.".to_owned();
        };
        let bound = self.bound_instructions.max(self.bound_prescan_instructions);
        let slowest = format!("The slowest of {} scans took {}: ", count(self.scans), time(self.scan_ns.max));
        let headroom = if self.scan_ns.max > self.watchdog_ns {
            format!("longer than the watchdog of {}.", time(self.watchdog_ns))
        } else {
            format!(
                "{:.1} % of the watchdog of {} and {:.1} % of the period of {} were left.",
                self.watchdog_headroom_percent,
                time(self.watchdog_ns),
                self.period_headroom_percent,
                time(self.period_ns),
            )
        };
        let disturbed = if self.scan_ns.max > DISTURBED * self.scan_ns.p50.max(1) {
            format!(
                " That is {} times the median: this computer did something else meanwhile, and on a quiet one the figure may be better.",
                count(self.scan_ns.max / self.scan_ns.p50.max(1))
            )
        } else {
            String::new()
        };
        let longest = longest_ns(self.scan_ns.max, self.estimate.as_ref());
        let why = if possible > least_watchdog_ms(MARGIN.saturating_mul(longest)) {
            format!("the least whose budget covers the bound of {} instructions", count(bound))
        } else {
            let what = if longest > self.scan_ns.max { "time estimated for the longest path" } else { "slowest scan" };
            format!("{MARGIN} times the {what}, in whole milliseconds")
        };
        let proposal = if possible > period_ms {
            format!("A watchdog of {possible} ms would be needed ({why}), and the period is {period_ms} ms.")
        } else {
            format!("On this machine the watchdog could be set to {possible} ms ({why}).")
        };
        let not_covered = if bound > self.budget_instructions {
            format!(
                " As it is set, its budget of {} instructions does not cover the bound of {}.",
                count(self.budget_instructions),
                count(bound)
            )
        } else {
            String::new()
        };
        format!("{slowest}{headroom}{disturbed} {proposal}{not_covered}")
    }

    /// The parts of a scan in their order, each with its name.
    pub(super) fn parts(&self) -> [(&'static str, Quantiles); 5] {
        [
            ("freeze", self.freeze_ns),
            ("primary", self.primary_ns),
            ("partner", self.partner_ns),
            ("comparison", self.compare_ns),
            ("publish", self.publish_ns),
        ]
    }

    /// What there is to say of the threads, where there are several.
    pub(super) fn on_threads(&self) -> Option<&'static str> {
        (self.threads > 1).then_some(
            "Both channels executed at the same time, on two threads: what is shown of the partner is the wait for it after the \
             primary had ended.",
        )
    }

    /// What there is to say of the time of the longest path.
    pub(super) fn longest_path(&self) -> Option<String> {
        if let Some(reason) = &self.estimate_failed {
            return Some(format!("No time is estimated for the longest path: {reason}"));
        }
        let estimate = self.estimate.as_ref()?;
        Some(format!(
            "The longest path would take about {}{}: an estimate from costs measured on this machine, for this computer only.",
            time(estimate.bound_ns),
            if self.threads > 1 { " on one thread" } else { "" }
        ))
    }
}

fn longest_ns(slowest_ns: u64, estimate: Option<&Estimate>) -> u64 {
    estimate.map_or(slowest_ns, |estimate| estimate.bound_ns.max(slowest_ns))
}

fn least_watchdog_ms(ns: u64) -> u64 {
    ns.div_ceil(MILLISECOND_NS).max(1)
}

fn possible_watchdog_ms(longest_ns: u64, bound: u64) -> u64 {
    let budget_us = bound.div_ceil(limits::BUDGET_PER_MICROSECOND);
    least_watchdog_ms(MARGIN.saturating_mul(longest_ns)).max(budget_us.div_ceil(1000))
}

/// The rungs with the longest estimated time, or without an estimate those that executed the most instructions.
fn most_expensive(records: &Image, measurement: &Measurement, costs: Option<&Bound>) -> Vec<RungRow> {
    let of = |bound: &Bound, routine: usize, rung: usize| {
        bound.routines.get(routine).and_then(|routine| routine.rungs.get(rung)).copied().unwrap_or_default()
    };
    let counts = measurement.counts.rungs.iter().enumerate();
    let mut rungs: Vec<(u64, u64, usize, usize)> = counts
        .flat_map(|(routine, rungs)| rungs.iter().enumerate().map(move |(rung, most)| (*most, routine, rung)))
        .map(|(most, routine, rung)| (costs.map_or(most, |costs| of(costs, routine, rung)), most, routine, rung))
        .filter(|(cost, _, _, _)| *cost > 0)
        .collect();
    rungs.sort_unstable_by_key(|(cost, most, routine, rung)| (Reverse(*cost), Reverse(*most), *routine, *rung));
    rungs.truncate(RUNGS_LISTED);
    let row = |(_, most, routine, rung): (u64, u64, usize, usize)| {
        let text = records.routines.get(routine).and_then(|record| record.text.lines().nth(rung));
        RungRow {
            routine: routine_name(records, RoutineIndex(routine as u32)),
            rung: rung as u64,
            max_instructions: most,
            bound_instructions: of(&measurement.bound, routine, rung),
            estimated_ns: costs.map(|costs| of(costs, routine, rung) / 1000),
            text: text.unwrap_or_default().to_owned(),
        }
    };
    rungs.into_iter().map(row).collect()
}

fn stopped(scan: u64, reason: StopReason) -> String {
    let (fault_type, code) = reason.type_and_code();
    let why = match reason {
        StopReason::Safety(fault) => format!("{fault:?}"),
        StopReason::PartnershipLost => "the partnership is lost".to_owned(),
        StopReason::Recoverable(fault) => format!("major fault 4/{} on rung {}", fault.code, fault.place.rung),
    };
    format!("scan {scan}: fault {fault_type}/{code}, {why}")
}
