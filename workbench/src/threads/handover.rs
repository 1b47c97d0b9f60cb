//! A box that an owner lends to a helper thread and takes back, without a lock and without a request for memory.

use std::num::NonZero;
use std::thread;
use std::time::Instant;

use crossbeam_utils::CachePadded;
use crossbeam_utils::atomic::AtomicCell;

/// Turns of a waiting loop before it offers the processor to others in each turn (`sched_yield`): some ten microseconds. Where
/// other work makes both threads share a processor, each hand-over costs that time; on a quiet machine an offer that nobody takes costs
/// a fraction of a microsecond. With fewer processors than threads the loop offers it from the first turn.
const SPINS: u64 = 200;
/// The clock is looked at once in so many turns of a waiting loop.
const LOOKS: u64 = 64;

/// Whose turn it is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Turn {
    /// The helper has not begun.
    Beginning,
    /// The owner's: the box is with it, or lies here done.
    Owner,
    /// The helper's.
    Helper,
    /// Nobody's any more: the owner is gone, the helper is gone, or the owner would not wait any longer.
    Over,
}

/// Where the box changes hands. Turn and box lie in one cache line, which nothing else shares.
pub(super) struct Handover<T> {
    place: CachePadded<Place<T>>,
    spins: u64,
}

struct Place<T> {
    turn: AtomicCell<Turn>,
    parcel: AtomicCell<Option<Box<T>>>,
}

impl<T> Handover<T> {
    pub(super) fn new() -> Handover<T> {
        let processors = thread::available_parallelism().map_or(1, NonZero::get);
        let place = Place { turn: AtomicCell::new(Turn::Beginning), parcel: AtomicCell::new(None) };
        Handover { place: CachePadded::new(place), spins: if processors < 2 { 0 } else { SPINS } }
    }

    /// The owner's: waits until the helper has begun.
    pub(super) fn await_helper(&self) {
        self.wait_while(Turn::Beginning, None);
    }

    /// The owner's: lends the box.
    pub(super) fn lend(&self, parcel: Box<T>) {
        self.place.parcel.store(Some(parcel));
        // Where it is over it stays so: nobody takes the box, and `take_back` says it.
        let _ = self.place.turn.compare_exchange(Turn::Owner, Turn::Helper);
    }

    /// The owner's: waits for the box, and with a time limit no longer than that. `None` when it will not come back: the
    /// helper has ended, or the time is over; in both cases it is over for good, and a late box is not taken.
    pub(super) fn take_back(&self, until: Option<Instant>) -> Option<Box<T>> {
        if self.wait_while(Turn::Helper, until) == Some(Turn::Owner) {
            return self.place.parcel.take();
        }
        self.end();
        None
    }

    /// Says that it is over.
    pub(super) fn end(&self) {
        self.place.turn.store(Turn::Over);
    }

    /// The helper's: works on each box that is lent, until it is over. Where `work` panics it is over too.
    pub(super) fn serve(&self, mut work: impl FnMut(&mut T)) {
        let _ending = Ending(self);
        if self.place.turn.compare_exchange(Turn::Beginning, Turn::Owner).is_err() {
            return;
        }
        loop {
            if self.wait_while(Turn::Owner, None) != Some(Turn::Helper) {
                return;
            }
            let Some(mut parcel) = self.place.parcel.take() else { return };
            work(&mut parcel);
            self.place.parcel.store(Some(parcel));
            if self.place.turn.compare_exchange(Turn::Helper, Turn::Owner).is_err() {
                return;
            }
        }
    }

    /// Waits awake while it is this turn; the turn that it is then, or `None` where the time is over before.
    fn wait_while(&self, turn: Turn, until: Option<Instant>) -> Option<Turn> {
        let mut turns = 0_u64;
        loop {
            let now = self.place.turn.load();
            if now != turn {
                return Some(now);
            }
            if turns.is_multiple_of(LOOKS) && until.is_some_and(|until| Instant::now() >= until) {
                return None;
            }
            if turns < self.spins {
                std::hint::spin_loop();
            } else {
                thread::yield_now();
            }
            turns += 1;
        }
    }
}

/// Says that it is over when the helper ends, however it ends.
struct Ending<'a, T>(&'a Handover<T>);

impl<T> Drop for Ending<'_, T> {
    fn drop(&mut self) {
        self.0.end();
    }
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::{AtomicBool, Ordering};

    use super::*;

    #[test]
    fn cells_when_asked_then_they_need_no_lock() {
        assert!(AtomicCell::<Turn>::is_lock_free());
        assert!(AtomicCell::<Option<Box<[u64; 16]>>>::is_lock_free());
    }

    #[test]
    fn box_when_lent_many_times_then_the_helper_has_worked_on_it_each_time() {
        let handover = Handover::new();
        let worked = thread::scope(|scope| {
            let mut parcel = Box::new(0_u64);
            scope.spawn(|| handover.serve(|number| *number += 1));
            handover.await_helper();
            for _ in 0..1_000 {
                handover.lend(parcel);
                parcel = handover.take_back(None).expect("the helper is there");
            }
            handover.end();
            *parcel
        });
        assert_eq!(worked, 1_000);
    }

    #[test]
    fn box_when_the_helper_panics_then_it_does_not_come_back_and_nobody_waits() {
        let handover: Handover<u64> = Handover::new();
        thread::scope(|scope| {
            let helper = scope.spawn(|| handover.serve(|number| assert_ne!(*number, 7, "the helper ends")));
            handover.await_helper();
            handover.lend(Box::new(7));
            assert_eq!(handover.take_back(None), None);
            handover.lend(Box::new(8));
            assert_eq!(handover.take_back(None), None, "and it is over for good");
            assert!(helper.join().is_err());
        });
    }

    #[test]
    fn box_when_it_is_late_then_it_is_not_taken() {
        let (handover, released) = (Handover::new(), AtomicBool::new(false));
        thread::scope(|scope| {
            let helper = scope.spawn(|| {
                handover.serve(|_: &mut u64| {
                    while !released.load(Ordering::Acquire) {
                        thread::yield_now();
                    }
                });
            });
            handover.await_helper();
            handover.lend(Box::new(1));
            assert_eq!(handover.take_back(Some(Instant::now())), None);
            released.store(true, Ordering::Release);
            assert!(helper.join().is_ok());
            assert_eq!(handover.take_back(None), None);
        });
    }
}
