//! The longest path of a scan, from the code alone: no scan of this image executes more (REQ-BOUND-001 and following).
//!
//! Every leg of a branch is executed and a forward jump only skips, so that the longest straight path of a routine is the
//! sum of its elements. What is between a label and a JMP that jumps back to it is executed once more for each backward
//! jump, and each JMP jumps back at most [`crate::limits::BACKWARD_JUMPS`] times in one execution of its routine
//! (REQ-EXEC-016): loops within one routine add up, and do not multiply each other. A routine runs as often as the JSRs
//! that reach it are executed; an Add-On Instruction is a body at each of its calls; a fault routine runs once (REQ-EXEC-051).
//!
//! A prescan has a bound of its own: it visits each routine once and takes no jump, but for the Prescan routines of Add-On
//! Instructions, which run (REQ-EXEC-024, REQ-EXEC-032).
//!
//! What an element costs is the caller's choice: 1 for each instruction gives what `executed` counts (REQ-EXEC-014), a
//! time for each opcode gives a time.

mod calls;
mod file_elements;
mod walk;

use alloc::vec::Vec;

use twinrung_catalog::Opcode;

use crate::admitted::AdmittedImage;
use crate::image::Owner;

/// Something that a scan does and that has a cost.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Work {
    /// A rung is entered.
    Rung,
    /// A call of an Add-On Instruction is reached; what its logic does is counted by itself.
    AddOnCall,
    /// An instruction is reached, true or false.
    Instruction(Opcode),
    /// FAL or FSC begins an element.
    FileElement(Opcode),
}

/// What one scan, and one prescan, can cost at most, in the unit of the costs that it was computed with. Sums stop at `u64::MAX`.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Bound {
    /// The whole scan.
    pub total: u64,
    /// The whole prescan.
    pub prescan: u64,
    /// Each program with its subroutines and its fault routine, in the order of the programs.
    pub programs: Vec<u64>,
    /// Each routine, in the order of the routines. What the routines of an Add-On Instruction do is part of the routines
    /// that call it.
    pub routines: Vec<RoutineBound>,
}

impl Bound {
    /// The greater of scan and prescan: the budget is one for both.
    pub fn greatest(&self) -> u64 {
        self.total.max(self.prescan)
    }
}

/// What one routine can cost in one scan at most.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct RoutineBound {
    /// How often the scan can begin it.
    pub runs: u64,
    /// All its runs together, without its subroutines, with the Add-On Instructions that it calls.
    pub total: u64,
    /// The same for each of its rungs.
    pub rungs: Vec<u64>,
}

/// The bound with the given costs.
pub fn bound(image: &AdmittedImage, cost: &dyn Fn(Work) -> u64) -> Bound {
    let bodies = walk::add_on_bodies(image, cost);
    let walks: Vec<walk::Walk> = image
        .image()
        .routines
        .iter()
        .map(|record| match record.owner {
            Owner::Program(_) => walk::walk(image, record, &bodies, cost),
            Owner::AddOn(_) => walk::Walk::default(),
        })
        .collect();
    let runs = calls::runs(image.image(), &walks);
    let mut bound = Bound {
        prescan: calls::prescan(image.image(), &walks),
        programs: alloc::vec![0; image.image().programs.len()],
        ..Bound::default()
    };
    for ((record, walk), runs) in image.image().routines.iter().zip(&walks).zip(runs) {
        let routine = walk.with_runs(runs);
        if let Owner::Program(program) = record.owner
            && let Some(sum) = bound.programs.get_mut(program.position())
        {
            *sum = sum.saturating_add(routine.total);
        }
        bound.total = bound.total.saturating_add(routine.total);
        bound.routines.push(routine);
    }
    bound
}

/// The bound in instructions as `executed` counts them (REQ-EXEC-014).
pub fn instructions(image: &AdmittedImage) -> Bound {
    bound(image, &|work| match work {
        Work::Rung => 0,
        Work::Instruction(_) | Work::AddOnCall | Work::FileElement(_) => 1,
    })
}

/// Instructions that a scan, or a prescan, may execute in simulated time: the watchdog at [`crate::limits::BUDGET_PER_MICROSECOND`].
/// `None` for a library, which has no task.
pub fn budget(image: &AdmittedImage) -> Option<u64> {
    let task = image.image().task.as_ref()?;
    Some(u64::from(task.watchdog_us).saturating_mul(crate::limits::BUDGET_PER_MICROSECOND))
}

/// An image that the budget of its watchdog does not cover.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct BeyondBudget {
    /// What a scan can execute at most.
    pub scan: u64,
    /// What a prescan can execute at most.
    pub prescan: u64,
    /// What either may execute.
    pub budget: u64,
}

impl core::fmt::Display for BeyondBudget {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        let BeyondBudget { scan, prescan, budget } = self;
        write!(f, "a scan can execute {scan} instructions, a prescan {prescan}, and the watchdog allows {budget}")
    }
}

impl core::error::Error for BeyondBudget {}

/// Refuses an image whose bound exceeds the budget of its watchdog (REQ-BOUND-007). The budget then ends no scan and no
/// prescan.
///
/// # Errors
///
/// The bound of the scan or that of the prescan is greater than the budget.
pub fn check(image: &AdmittedImage) -> Result<(), BeyondBudget> {
    let bound = instructions(image);
    match budget(image) {
        Some(budget) if bound.greatest() > budget => {
            Err(BeyondBudget { scan: bound.total, prescan: bound.prescan, budget })
        }
        _ => Ok(()),
    }
}
