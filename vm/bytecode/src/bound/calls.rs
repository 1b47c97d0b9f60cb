//! How often a scan can begin each routine, and which ones a prescan visits.

use alloc::vec::Vec;

use super::walk::Walk;
use crate::image::Image;
use crate::index::RoutineIndex;

/// Main routines once for each time that they are scheduled, fault routines once, subroutines as often as the JSRs that
/// reach them. Nobody calls in a circle: the verifier has shown it.
pub(super) fn runs(image: &Image, walks: &[Walk]) -> Vec<u64> {
    let mut runs = alloc::vec![0_u64; walks.len()];
    for routine in begun_by_the_task(image) {
        if let Some(count) = runs.get_mut(routine.position()) {
            *count = count.saturating_add(1);
        }
    }
    let mut open = alloc::vec![0_usize; walks.len()];
    for call in walks.iter().flat_map(|walk| &walk.calls) {
        if let Some(count) = open.get_mut(call.target.position()) {
            *count = count.saturating_add(1);
        }
    }
    let mut ready: Vec<usize> =
        open.iter().enumerate().filter(|(_, callers)| **callers == 0).map(|(routine, _)| routine).collect();
    while let Some(routine) = ready.pop() {
        let own = runs.get(routine).copied().unwrap_or_default();
        for call in walks.get(routine).into_iter().flat_map(|walk| &walk.calls) {
            let target = call.target.position();
            if let Some(count) = runs.get_mut(target) {
                *count = count.saturating_add(own.saturating_mul(call.times));
            }
            if let Some(callers) = open.get_mut(target) {
                *callers = callers.saturating_sub(1);
                if *callers == 0 {
                    ready.push(target);
                }
            }
        }
    }
    runs
}

/// What a prescan costs: main and fault routines and what their JSRs reach, each once (REQ-EXEC-024). A JSR that raises a user
/// fault reaches the fault routine, which is visited in any case.
pub(super) fn prescan(image: &Image, walks: &[Walk]) -> u64 {
    let mut visited = alloc::vec![false; walks.len()];
    let mut open: Vec<RoutineIndex> = begun_by_the_task(image).collect();
    let mut total = 0_u64;
    while let Some(routine) = open.pop() {
        let (Some(walk), Some(visited)) = (walks.get(routine.position()), visited.get_mut(routine.position())) else {
            continue;
        };
        if !core::mem::replace(visited, true) {
            total = total.saturating_add(walk.prescan);
            open.extend(walk.calls.iter().map(|call| call.target));
        }
    }
    total
}

/// Main and fault routine of every program that is scheduled and not disabled, as often as it is scheduled.
fn begun_by_the_task(image: &Image) -> impl Iterator<Item = RoutineIndex> {
    let scheduled = image.task.iter().flat_map(|task| &task.schedule);
    scheduled
        .filter_map(|program| image.programs.get(program.position()).filter(|program| !program.disabled))
        .flat_map(|program| [program.main, program.fault].into_iter().flatten())
}
