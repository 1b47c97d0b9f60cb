//! How often a scan can begin each routine.

use alloc::vec::Vec;

use super::walk::Walk;
use crate::image::Image;

/// Main routines once for each time that they are scheduled, fault routines once, subroutines as often as the JSRs that
/// reach them. Nobody calls in a circle: the verifier has shown it.
pub(super) fn runs(image: &Image, walks: &[Walk]) -> Vec<u64> {
    let mut runs = alloc::vec![0_u64; walks.len()];
    for program in image.task.iter().flat_map(|task| &task.schedule) {
        let Some(program) = image.programs.get(program.position()).filter(|program| !program.disabled) else {
            continue;
        };
        for routine in [program.main, program.fault].into_iter().flatten() {
            if let Some(count) = runs.get_mut(routine.position()) {
                *count = count.saturating_add(1);
            }
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
