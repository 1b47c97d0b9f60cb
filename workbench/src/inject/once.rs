//! One fault: injected, and followed until it is known what became of it.

use std::cell::Cell;
use std::panic::{AssertUnwindSafe, catch_unwind};

use twinrung_bytecode::admit;
use twinrung_bytecode::injection::{Flip, Injectable, Memory};
use twinrung_bytecode::observer::Silent;
use twinrung_controller::{Difference, SafetyFault, SharedMemory, Side, StopReason};

use super::channel::Wrong;
use super::clock::{Disturbance, MOMENTS};
use super::fault::{Bits, Class, Fault, Time};
use super::subject::{State, Subject};
use super::upset::Upsetter;

/// What found a fault.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Mechanism {
    /// The comparison of cells.
    Cells,
    /// The comparison of statuses and counts.
    Status,
    /// The comparison of how executions ended.
    End,
    /// The comparison of the path of control.
    Path,
    /// The comparison of events and fault records.
    Records,
    /// The second comparison alone.
    SecondComparison,
    /// The budget of instructions, or the watchdog.
    Budget,
    /// The running check of the image.
    ImageCheck,
    /// A scan in which nothing was executed.
    Execution,
    /// The verdict.
    Verdict,
    /// The outputs of both halves when they are taken over.
    Outputs,
    /// What the controller holds twice, at a scan boundary.
    Halves,
    /// The plausibility of time.
    Time,
    /// A major fault of the program, which stops both channels.
    MajorFault,
    /// The loader.
    Loader,
    /// A panic, which stops the machine.
    Panic,
    /// The mode is Program, and outputs are off.
    Mode,
}

impl Mechanism {
    const fn of(reason: StopReason) -> Mechanism {
        match reason {
            // No campaign injects it: it is what a person says of the hardware.
            StopReason::PartnershipLost => Mechanism::Panic,
            StopReason::Recoverable(_) => Mechanism::MajorFault,
            StopReason::Safety(fault) => match fault {
                SafetyFault::Difference(difference) => match difference {
                    Difference::Bit(..) | Difference::Word(..) | Difference::Size => Mechanism::Cells,
                    Difference::Status => Mechanism::Status,
                    Difference::End(..) => Mechanism::End,
                    Difference::Path => Mechanism::Path,
                    Difference::Event(_) | Difference::FaultRecord(_) => Mechanism::Records,
                },
                SafetyFault::WatchdogExpired | SafetyFault::BudgetExceeded | SafetyFault::ChannelStopped => {
                    Mechanism::Budget
                }
                SafetyFault::ImageCorrupted => Mechanism::ImageCheck,
                SafetyFault::SecondComparison => Mechanism::SecondComparison,
                SafetyFault::NothingExecuted => Mechanism::Execution,
                SafetyFault::VerdictIncomplete => Mechanism::Verdict,
                SafetyFault::OutputsDiffer => Mechanism::Outputs,
                SafetyFault::ControllerCorrupted => Mechanism::Halves,
                SafetyFault::Time(_) => Mechanism::Time,
            },
        }
    }

    /// In words.
    pub const fn words(self) -> &'static str {
        match self {
            Mechanism::Cells => "comparison of cells",
            Mechanism::Status => "comparison of status and counts",
            Mechanism::End => "comparison of how executions ended",
            Mechanism::Path => "comparison of the path of control",
            Mechanism::Records => "comparison of events and fault records",
            Mechanism::SecondComparison => "second comparison alone",
            Mechanism::Budget => "budget and watchdog",
            Mechanism::ImageCheck => "running check of the image",
            Mechanism::Execution => "check that something was executed",
            Mechanism::Verdict => "verdict of the comparisons",
            Mechanism::Outputs => "outputs of both halves",
            Mechanism::Halves => "what the controller holds twice",
            Mechanism::Time => "plausibility of time",
            Mechanism::MajorFault => "major fault in both channels",
            Mechanism::Loader => "loader",
            Mechanism::Panic => "panic, which stops the machine",
            Mechanism::Mode => "mode Program, outputs off",
        }
    }
}

/// What became of a fault.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Outcome {
    /// Every output was right as long as was looked.
    Masked,
    /// The same, and the bit is still wrong in a memory that no execution writes: what it does, another input shows.
    Latent,
    /// Found, with no wrong output let out before; in which scan after it, counted from 1.
    Detected(Mechanism, u32),
    /// Not found; outputs were off that should be on, and none was on that should be off.
    Off,
    /// A wrong output was let out, in this scan.
    LetOut(u32),
    /// The field has no value with that bit turned round, or there is no such place.
    Impossible,
}

thread_local! {
    static INJECTING: Cell<bool> = const { Cell::new(false) };
}

/// Whether this thread follows a fault: a panic is then an outcome, and nobody needs to hear of it.
pub fn is_injecting() -> bool {
    INJECTING.get()
}

/// Does something in which a panic is an outcome.
fn heard_by_nobody<T>(work: impl FnOnce() -> T) -> Option<T> {
    INJECTING.set(true);
    let done = catch_unwind(AssertUnwindSafe(work)).ok();
    INJECTING.set(false);
    done
}

impl<A: Injectable, B: Injectable> Subject<A, B> {
    /// Injects a fault into a state in front of its scan, and runs so many scans from it on.
    pub(super) fn inject(&self, mut state: State<A, B>, fault: Fault, scans: u32) -> Outcome {
        if let Class::Image(bits) = fault.class {
            return self.load_disturbed(bits, fault);
        }
        let followed = heard_by_nobody(|| {
            self.arm(&mut state, fault);
            self.follow(&mut state, fault, scans)
        });
        followed.unwrap_or(Outcome::Detected(Mechanism::Panic, 1))
    }

    /// Says a channel or the clock what will be wrong in the next scan.
    fn arm(&self, state: &mut State<A, B>, fault: Fault) {
        let Fault { class, place, second, .. } = fault;
        match class {
            Class::Memory(side, memory, bits) => {
                let all = self.memory_bits[side as usize][memory as usize];
                let wrong = match bits {
                    Bits::Flip if memory == Memory::Program => {
                        Wrong::Flip { memory, bits: [Some(place), None], after: false }
                    }
                    Bits::Flip => Wrong::Flip { memory, bits: [Some(place / 2), None], after: place % 2 == 1 },
                    Bits::Double => Wrong::Flip { memory, bits: pair(place, second, all), after: false },
                    Bits::Stuck => Wrong::Stuck { memory, bit: place, value: second % 2 == 1 },
                };
                disturb(state, side, wrong);
            }
            Class::Behaviour(side, behaviour) => disturb(state, side, Wrong::Behaviour(behaviour, place)),
            Class::ChannelTime(side, time) => disturb(state, side, Wrong::Time(time)),
            Class::BothStop => {
                for side in [Side::Primary, Side::Partner] {
                    disturb(state, side, Wrong::Behaviour(super::fault::Behaviour::Stops, 0));
                }
            }
            Class::Shared(memory, bits) => {
                let all = self.shared_bits[memory as usize];
                let (side, rest) =
                    if memory.is_twofold() { (side_of(place % 2), place / 2) } else { (Side::Primary, place) };
                let (moment, bit) = (MOMENTS[(rest % 6) as usize], rest / 6);
                let [first, other] = if bits == Bits::Double { pair(bit, second, all) } else { [Some(bit), None] };
                let bits = [first, other].map(|bit| bit.map(|bit| (side, bit)));
                state.clock.disturb(Disturbance { moment, memory, bits });
            }
            Class::BothHalves(memory) => {
                let (moment, bit) = (MOMENTS[(place % 6) as usize], place / 6);
                let bits = [Some((Side::Primary, bit)), Some((Side::Partner, bit))];
                state.clock.disturb(Disturbance { moment, memory, bits });
            }
            Class::BothChannels(memory) => {
                for side in [Side::Primary, Side::Partner] {
                    disturb(state, side, Wrong::Flip { memory, bits: [Some(place), None], after: false });
                }
            }
            Class::Upset(..) | Class::Time(_) | Class::WireFlipped | Class::Image(_) => {}
        }
    }

    fn follow(&self, state: &mut State<A, B>, fault: Fault, scans: u32) -> Outcome {
        let mut was_off = false;
        let end = fault.scan.saturating_add(scans).min(self.golden.len() as u32);
        for (scan, golden) in (fault.scan..end).zip(&self.golden[fault.scan as usize..]) {
            let stopped = self.disturbed_step(state, fault, scan);
            let outputs = self.outputs(&state.controller);
            if outputs.is_wrong(&golden.outputs) {
                return Outcome::LetOut(scan);
            }
            was_off |= outputs != golden.outputs;
            let after = scan - fault.scan + 1;
            if let Some(reason) = stopped.filter(|reason| golden.stopped != Some(*reason)) {
                return Outcome::Detected(Mechanism::of(reason), after);
            }
            if stopped.is_none() && state.controller.mode() == twinrung_controller::Mode::Program {
                return Outcome::Detected(Mechanism::Mode, after);
            }
            if scan == fault.scan && self.flip(state) == Some(Flip::NoSuchValue) {
                return Outcome::Impossible;
            }
        }
        match fault.class {
            _ if self.flip(state).is_some_and(|flip| flip != Flip::Done) => Outcome::Impossible,
            _ if was_off => Outcome::Off,
            Class::Memory(_, Memory::Program, _) | Class::Shared(SharedMemory::Image, _) => Outcome::Latent,
            _ => Outcome::Masked,
        }
    }

    fn disturbed_step(&self, state: &mut State<A, B>, fault: Fault, scan: u32) -> Option<StopReason> {
        let mut now_ms = state.drive(scan, self.period_ms);
        let at_fault = scan == fault.scan;
        match fault.class {
            Class::Time(time) => now_ms = time_from(time, fault.scan, now_ms, self.period_ms),
            Class::WireFlipped if at_fault => {
                if let Some(cell) = self.wires.get(fault.place as usize) {
                    let value = state.controller.driven_bit(*cell).unwrap_or_default();
                    state.controller.drive_bit(*cell, !value);
                }
            }
            Class::Upset(side, upset) if at_fault => {
                let mut upsetter = Upsetter::upsetting(self.rungs.clone(), upset, fault.place, fault.second);
                let (controller, clock) = (&mut state.controller, &mut state.clock);
                let report = match side {
                    Side::Primary => controller.scan_observed(now_ms, clock, &mut upsetter, &mut Silent),
                    Side::Partner => controller.scan_observed(now_ms, clock, &mut Silent, &mut upsetter),
                };
                return report.stopped;
            }
            _ => {}
        }
        state.controller.scan_observed(now_ms, &mut state.clock, &mut Silent, &mut Silent).stopped
    }

    fn flip(&self, state: &mut State<A, B>) -> Option<Flip> {
        let (primary, partner) = state.controller.channels_mut();
        let channels = primary.flip().max(partner.flip());
        channels.max(state.clock.flip())
    }

    fn load_disturbed(&self, bits: Bits, fault: Fault) -> Outcome {
        let mut bytes = self.bytes.clone();
        let all = bytes.len() as u64 * 8;
        let turned =
            if bits == Bits::Double { pair(fault.place, fault.second, all) } else { [Some(fault.place), None] };
        for bit in turned.into_iter().flatten() {
            let Some(byte) = bytes.get_mut((bit / 8) as usize) else { return Outcome::Impossible };
            *byte ^= 1 << (bit % 8);
        }
        match heard_by_nobody(|| admit(&bytes).is_ok()) {
            Some(false) => Outcome::Detected(Mechanism::Loader, 1),
            // Another image that is admitted is another program.
            Some(true) => Outcome::LetOut(fault.scan),
            None => Outcome::Detected(Mechanism::Panic, 1),
        }
    }
}

fn disturb<A: Injectable, B: Injectable>(state: &mut State<A, B>, side: Side, wrong: Wrong) {
    let (primary, partner) = state.controller.channels_mut();
    match side {
        Side::Primary => primary.disturb(wrong),
        Side::Partner => partner.disturb(wrong),
    }
}

const fn side_of(number: u64) -> Side {
    if number == 0 { Side::Primary } else { Side::Partner }
}

/// Two different bits of so many.
fn pair(bit: u64, second: u64, all: u64) -> [Option<u64>; 2] {
    let other = second.checked_rem(all).unwrap_or_default();
    let other = if other == bit { (other + 1).checked_rem(all).unwrap_or_default() } else { other };
    [Some(bit), (other != bit).then_some(other)]
}

/// The time that the controller is told, where it has been wrong since the scan before that of the fault.
fn time_from(time: Time, scan: u32, now_ms: i64, period_ms: i64) -> i64 {
    time.of((i64::from(scan) - 1) * period_ms, now_ms)
}
