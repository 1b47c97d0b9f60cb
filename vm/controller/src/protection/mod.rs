//! What a controller permits in which state: modes, lock, signature, forces, edits, faults.
//!
//! One table, [`RULES`], says which action is refused when, why, and what is to be done about it. What no row refuses is
//! permitted. [`State::impossible`] says which states cannot occur. Everything else about protection (what the command
//! permits, what `status` lists, the page `docs/protection.md`) is read from these two; nothing here changes a state,
//! allocates or knows of time.
//!
//! Sources: 1756-RM093I Table 8, Chapters 6 and 7, Appendix B; what no manual at hand says is marked *recalled* or
//! *decided* in its row.

mod action;
mod condition;
mod rules;
mod state;

pub use action::{Action, Offer, OfferedSignature, Verb};
pub use condition::Condition;
pub use rules::{RULES, Rule};
pub use state::{Edits, Forces, IMPOSSIBLE, Impossible, Keyswitch, Place, SafetyTaskStatus, State};

/// Every row that refuses an action in a state, in the order of the table; none where it is permitted.
pub fn refusals(state: State, action: Action) -> impl Iterator<Item = &'static Rule> {
    RULES.iter().filter(move |rule| rule.refuses(state, action))
}

/// Why an action cannot occur in a state at all; nothing where it can.
pub fn impossible(state: State, action: Action) -> Option<&'static Impossible> {
    state.impossible().or_else(|| state::impossible_offer(state, action))
}

/// Whether an action is permitted.
///
/// # Errors
///
/// The first row that refuses it.
pub fn judge(state: State, action: Action) -> Result<(), &'static Rule> {
    refusals(state, action).next().map_or(Ok(()), Err)
}
