//! Instructions of each rung, counted through the observer.

use twinrung_bytecode::AdmittedImage;
use twinrung_bytecode::channel::Place;
use twinrung_bytecode::index::RoutineIndex;
use twinrung_bytecode::observer::Observer;

/// Most instructions that each rung, routine and program executed in one scan.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Counts {
    /// For each routine, for each of its rungs.
    pub rungs: Vec<Vec<u64>>,
    /// For each routine, whoever called it.
    pub routines: Vec<u64>,
    /// For each program: all that it executed, Add-On Instructions included.
    pub programs: Vec<u64>,
}

/// Counts what one channel does. FAL and FSC count their elements to the rung that they stand on.
pub(super) struct Counter {
    most: Counts,
    now: Counts,
    at: Option<Place>,
    /// Executed, and not yet told by which element.
    open: u64,
}

impl Counter {
    pub(super) fn new(image: &AdmittedImage) -> Counter {
        let empty = Counts {
            rungs: image.rung_counts().iter().map(|rungs| vec![0; *rungs as usize]).collect(),
            routines: vec![0; image.image().routines.len()],
            programs: vec![0; image.image().programs.len()],
        };
        Counter { most: empty.clone(), now: empty, at: None, open: 0 }
    }

    pub(super) fn begin(&mut self) {
        self.now.rungs.iter_mut().for_each(|rungs| rungs.fill(0));
        self.now.routines.fill(0);
        self.now.programs.fill(0);
        self.at = None;
        self.open = 0;
    }

    pub(super) fn end(&mut self) {
        self.settle();
        let keep = |most: &mut Vec<u64>, now: &[u64]| {
            most.iter_mut().zip(now).for_each(|(most, now)| *most = (*most).max(*now));
        };
        keep(&mut self.most.routines, &self.now.routines);
        keep(&mut self.most.programs, &self.now.programs);
        self.most.rungs.iter_mut().zip(&self.now.rungs).for_each(|(most, now)| keep(most, now));
    }

    pub(super) fn counts(self) -> Counts {
        self.most
    }

    /// What was executed is that of the place at hand.
    fn settle(&mut self) {
        let count = std::mem::take(&mut self.open);
        if let Some(place) = self.at {
            self.add(place, count);
        }
    }

    fn add(&mut self, place: Place, count: u64) {
        let RoutineIndex(routine) = place.routine;
        let routine = routine as usize;
        if let Some(sum) = self.now.rungs.get_mut(routine).and_then(|rungs| rungs.get_mut(place.rung as usize)) {
            *sum += count;
        }
        if let Some(sum) = self.now.routines.get_mut(routine) {
            *sum += count;
        }
        if let Some(sum) = self.now.programs.get_mut(place.program.position()) {
            *sum += count;
        }
    }
}

impl Observer for Counter {
    fn rung_entered(&mut self, place: Place) {
        // A JSR, an Add-On call or a fault stands on the rung that is left here.
        self.settle();
        self.at = Some(place);
    }

    fn element_result(&mut self, place: Place, _: bool, _: bool) {
        // The element may stand behind a JSR or an Add-On call: control has come back to its rung without entering it.
        self.at = Some(place);
        self.settle();
    }

    fn instructions_retired(&mut self, count: u64) {
        self.open += count;
    }
}
