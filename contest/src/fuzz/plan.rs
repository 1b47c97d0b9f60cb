//! How a campaign is run: on which threads, for how long, with or without guidance.

use std::sync::atomic::{AtomicBool, AtomicU64, AtomicUsize, Ordering};
use std::sync::mpsc;
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

use crate::generate::{Genome, Random, Size};

use super::cases::{Found, Ran, completed};
use super::guided::Corpus;
use super::{Campaign, Contest};

/// A campaign to be run.
#[derive(Debug, Clone, PartialEq)]
pub struct Plan {
    /// How long; a program that was begun is run to its end.
    pub time: Duration,
    /// The first seed.
    pub seed: u64,
    /// Programs at most.
    pub programs: u64,
    /// Scans of each program; those of its size where nothing is asked for.
    pub scans: Option<usize>,
    /// Rungs of each main routine; a mix where nothing is asked for.
    pub rungs: Option<usize>,
    /// Threads.
    pub jobs: usize,
    /// It ends after so many differences.
    pub differences: usize,
    /// Whether what differs is left as it was found.
    pub as_found: bool,
    /// Whether programs are made of those that reached something new; else each is drawn by itself.
    pub guided: bool,
    /// Genomes of an earlier campaign, run first.
    pub earlier: Vec<Genome>,
}

/// What a campaign tells while it runs.
#[derive(Debug)]
pub enum Told<'c> {
    /// A program was run.
    Program(&'c Campaign),
    /// A genome reached something new.
    Kept(&'c Genome),
    /// The evaluators differed; it is the last failure.
    Difference(&'c Campaign),
}

/// The first programs are drawn by themselves: changes of the very first would all be alike.
const DRAWN_FIRST: u64 = 128;
/// Of so many programs that follow guidance one is drawn by itself. What is new to coverage is not all that a mistake may
/// hang on: measured on the seeded defects, mistakes that any program shows took longer the fewer programs were drawn.
const FRESH_ONE_IN: u64 = 2;
/// Scans of a tiny, a small and a large program.
const SCANS: [usize; 3] = [40, 120, 300];

/// Size and scans of the program of a seed.
fn extent(plan: &Plan, seed: u64) -> (Size, usize) {
    let (size, scans) = match (plan.rungs, seed % 64) {
        (Some(rungs), _) => (Size::of_rungs(rungs), SCANS[2]),
        (None, 63) => (Size::LARGE, SCANS[2]),
        (None, 15 | 31 | 47) => (Size::SMALL, SCANS[1]),
        _ => (Size::TINY, SCANS[0]),
    };
    (size, plan.scans.unwrap_or(scans))
}

impl Plan {
    /// Runs it.
    pub fn run<C: Contest>(&self, mut told: impl FnMut(Told<'_>)) -> Campaign {
        let begun = Instant::now();
        let (next, over) = (AtomicU64::new(0), AtomicBool::new(false));
        let corpus = Mutex::new(Corpus::default());
        let (done, failed) = (AtomicU64::new(0), AtomicUsize::new(0));
        let mut campaign = Campaign::default();
        thread::scope(|scope| {
            let (sender, receiver) = mpsc::sync_channel::<(Ran, Option<Genome>)>(1_024);
            for job in 0..self.jobs {
                let sender = sender.clone();
                let (next, over, corpus, done, failed) = (&next, &over, &corpus, &done, &failed);
                scope.spawn(move || {
                    let mut random = Random::new(self.seed ^ (job as u64) << 48 ^ 0x6A1D_ED00);
                    while !over.load(Ordering::Relaxed) && begun.elapsed() < self.time {
                        let number = next.fetch_add(1, Ordering::Relaxed);
                        if number >= self.programs {
                            break;
                        }
                        let (mut ran, kept) = self.one::<C>(number, &mut random, corpus);
                        let programs = done.fetch_add(1, Ordering::Relaxed) + 1;
                        if let Ran::Failed(failure) = &mut ran {
                            failure.found = Some(Found { after: begun.elapsed(), programs });
                            // Counted here: whoever adds them up may be behind.
                            let differences = failed.fetch_add(1, Ordering::Relaxed) + 1;
                            over.fetch_or(differences >= self.differences, Ordering::Relaxed);
                            if !self.as_found {
                                failure.shrink::<C>();
                            }
                        }
                        if sender.send((ran, kept)).is_err() {
                            break;
                        }
                    }
                });
            }
            drop(sender);
            for (ran, kept) in receiver {
                let failed = matches!(ran, Ran::Failed(_));
                campaign.add(ran, begun.elapsed());
                if let Some(genome) = kept {
                    campaign.kept += 1;
                    told(Told::Kept(&genome));
                }
                told(if failed { Told::Difference(&campaign) } else { Told::Program(&campaign) });
            }
        });
        campaign
    }

    /// One program, and its genome where that reached something new.
    fn one<C: Contest>(&self, number: u64, random: &mut Random, corpus: &Mutex<Corpus>) -> (Ran, Option<Genome>) {
        random.forget();
        let seed = self.seed.wrapping_add(number);
        let earlier = self.earlier.get(number as usize).cloned();
        let follows =
            self.guided && self.rungs.is_none() && number >= DRAWN_FIRST && !number.is_multiple_of(FRESH_ONE_IN);
        let child = || follows.then(|| locked(corpus).child(random)).flatten();
        let (genome, (size, scans)) = match earlier.or_else(child) {
            Some(genome) => (genome, (Size::TINY, self.scans.unwrap_or(SCANS[0]))),
            None => (Genome::of_seed(seed), extent(self, seed)),
        };
        let (ran, genome) = completed::<C>(seed, &genome, size, scans);
        let Some(features) = ran.features().filter(|_| self.guided) else { return (ran, None) };
        let mut corpus = locked(corpus);
        if size != Size::TINY {
            corpus.note(features);
            return (ran, None);
        }
        let is_new = corpus.offer(&genome, features) > 0;
        drop(corpus);
        (ran, is_new.then_some(genome))
    }
}

/// The corpus is whole whatever a thread did that had it.
fn locked(corpus: &Mutex<Corpus>) -> MutexGuard<'_, Corpus> {
    corpus.lock().unwrap_or_else(PoisonError::into_inner)
}
