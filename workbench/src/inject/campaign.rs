//! Which faults are injected: all of a class where there are few, otherwise a sample by a seed.

use std::panic::resume_unwind;
use std::sync::atomic::{AtomicU64, Ordering};
use std::thread;

use twinrung_bytecode::injection::{Injectable, Memory};
use twinrung_controller::SharedMemory;

use super::channel::{ENDS, STATUS_BITS};
use super::clock::MOMENTS;
use super::fault::{Behaviour, Bits, Class, Fault, Group};
use super::once::Outcome;
use super::report::{ClassReport, Report};
use super::subject::Subject;

/// How much is injected, and where.
#[derive(Debug, Clone)]
pub struct Plan {
    /// Faults in all.
    pub injections: u64,
    /// What random places depend on.
    pub seed: u64,
    /// Scans that a fault is followed for.
    pub follow: u32,
    /// Threads.
    pub jobs: usize,
    /// Groups of classes.
    pub groups: Vec<Group>,
    /// Only classes whose name contains this.
    pub only: Option<String>,
}

/// Faults for a project.
pub struct Campaign<'s, A: Injectable, B: Injectable> {
    subject: &'s Subject<A, B>,
    plan: Plan,
    classes: Vec<(Class, u64)>,
    /// By scan.
    faults: Vec<Fault>,
}

impl<'s, A, B> Campaign<'s, A, B>
where
    A: Injectable + Send + Sync,
    B: Injectable + Send + Sync,
{
    /// Chooses the faults.
    pub fn new(subject: &'s Subject<A, B>, plan: Plan) -> Campaign<'s, A, B> {
        let meant = |class: &Class| {
            plan.groups.contains(&class.group())
                && plan.only.as_ref().is_none_or(|part| class.to_string().contains(part.as_str()))
        };
        let mut classes: Vec<(Class, u64)> =
            Class::all().into_iter().filter(meant).map(|class| (class, subject.population(class))).collect();
        let mut faults = Vec::new();
        let mut left = plan.injections;
        // Small classes first: what they leave of their share, larger ones take.
        classes.sort_by_key(|(_, population)| *population);
        let mut open = classes.iter().filter(|(_, population)| *population > 0).count() as u64;
        for (class, population) in &classes {
            if *population == 0 {
                continue;
            }
            let share = left / open;
            open -= 1;
            let before = faults.len();
            if *population <= share && !class.has_second() {
                subject.every(*class, &mut faults);
            } else {
                subject.sample(*class, share, plan.seed, &mut faults);
            }
            left = left.saturating_sub((faults.len() - before) as u64);
        }
        classes.sort_by_key(|(class, _)| *class);
        faults.sort_by_key(|fault| fault.scan);
        Campaign { subject, plan, classes, faults }
    }

    /// How many faults.
    pub fn len(&self) -> u64 {
        self.faults.len() as u64
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.faults.is_empty()
    }

    /// Injects them. `done` counts them while that goes on.
    pub fn run(&self, done: &AtomicU64) -> Report {
        let jobs = self.plan.jobs.max(1);
        let empty = || self.classes.iter().map(|(class, population)| ClassReport::new(*class, *population)).collect();
        let parts: Vec<Vec<ClassReport>> = thread::scope(|scope| {
            let threads: Vec<_> =
                (0..jobs).map(|job| scope.spawn(move || self.part(job, jobs, empty(), done))).collect();
            threads.into_iter().map(|thread| thread.join().unwrap_or_else(|panic| resume_unwind(panic))).collect()
        });
        let mut classes: Vec<ClassReport> = empty();
        for part in parts {
            classes.iter_mut().zip(part).for_each(|(sum, part)| sum.add(part));
        }
        Report::new(classes, self.plan.seed, self.subject.scans(), self.plan.follow)
    }

    fn part(&self, job: usize, jobs: usize, mut reports: Vec<ClassReport>, done: &AtomicU64) -> Vec<ClassReport> {
        let mut state = self.subject.start();
        let mut scan = 0;
        for fault in self.faults.iter().skip(job).step_by(jobs) {
            while scan < fault.scan {
                self.subject.step(&mut state, scan);
                scan += 1;
            }
            let outcome = self.subject.inject(state.clone(), *fault, self.plan.follow);
            if let Ok(index) = self.classes.binary_search_by_key(&fault.class, |(class, _)| *class) {
                reports[index].count(*fault, outcome);
            }
            done.fetch_add(1, Ordering::Relaxed);
        }
        reports
    }
}

impl<A: Injectable, B: Injectable> Subject<A, B> {
    /// Injects one fault, as a campaign does.
    pub fn replay(&self, fault: Fault, follow: u32) -> Outcome {
        let mut state = self.start();
        for scan in 0..fault.scan.min(self.scans()) {
            self.step(&mut state, scan);
        }
        if fault.scan < self.scans() { self.inject(state, fault, follow) } else { Outcome::Impossible }
    }

    /// Places of a class in a scan.
    fn places(&self, class: Class, scan: u32) -> u64 {
        let shared = |memory: SharedMemory| {
            let sides = if memory.is_twofold() { 2 } else { 1 };
            self.shared_bits[memory as usize] * MOMENTS.len() as u64 * sides
        };
        match class {
            Class::Memory(side, memory, bits) => {
                let moments = if bits == Bits::Flip && memory != Memory::Program { 2 } else { 1 };
                self.memory_bits[side as usize][memory as usize] * moments
            }
            Class::Upset(side, upset) => self.golden[scan as usize].places[side as usize].of(upset),
            Class::Behaviour(_, Behaviour::EndWrong) => ENDS,
            Class::Behaviour(_, Behaviour::StatusWrong) => STATUS_BITS,
            // In the first scan time has not gone on, so nothing is wrong with it yet.
            Class::Behaviour(..) | Class::BothStop => 1,
            Class::ChannelTime(..) | Class::Time(_) => u64::from(scan > 0),
            Class::Shared(memory, _) => shared(memory),
            Class::BothHalves(memory) => shared(memory) / 2,
            Class::Image(_) => {
                if scan == 0 {
                    self.bytes.len() as u64 * 8
                } else {
                    0
                }
            }
            Class::WireFlipped => self.wires.len() as u64,
            Class::BothChannels(memory) => {
                self.memory_bits.iter().map(|bits| bits[memory as usize]).min().unwrap_or_default()
            }
        }
    }

    /// Places of a class in all scans.
    fn population(&self, class: Class) -> u64 {
        (0..self.scans()).map(|scan| self.places(class, scan)).sum()
    }

    fn every(&self, class: Class, faults: &mut Vec<Fault>) {
        for scan in 0..self.scans() {
            faults.extend((0..self.places(class, scan)).map(|place| Fault { scan, class, place, second: 0 }));
        }
    }

    /// So many places at random, each as likely as another.
    fn sample(&self, class: Class, count: u64, seed: u64, faults: &mut Vec<Fault>) {
        let name = class.to_string();
        let number = name.bytes().fold(seed, |hash, byte| hash.wrapping_mul(0x100_0000_01B3) ^ u64::from(byte));
        let mut random = fastrand::Rng::with_seed(number);
        let ends: Vec<u64> = (0..self.scans())
            .scan(0, |sum, scan| {
                *sum += self.places(class, scan);
                Some(*sum)
            })
            .collect();
        let all = ends.last().copied().unwrap_or_default();
        faults.extend((0..count).map(|_| {
            let chosen = random.u64(..all);
            let scan = ends.partition_point(|end| *end <= chosen);
            let before = scan.checked_sub(1).map_or(0, |before| ends[before]);
            let second = if class.has_second() { random.u64(..) } else { 0 };
            Fault { scan: scan as u32, class, place: chosen - before, second }
        }));
    }
}
