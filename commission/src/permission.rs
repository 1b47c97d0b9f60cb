//! What is permitted now, and what is not and why.

use twinrung_controller::protection::{Action, Offer, OfferedSignature, Rule, Verb, refusals};

use crate::state::ControllerState;

/// One action in the state of now.
#[derive(Debug, Clone)]
pub struct Permission {
    /// The action.
    pub verb: Verb,
    /// With which offer, where it takes one.
    pub offer: Option<&'static str>,
    /// Why it is refused; empty where it is permitted.
    pub refused: Vec<&'static Rule>,
}

/// What an engineer at this controller may do.
pub fn permissions(state: &ControllerState) -> Vec<Permission> {
    let same = state.signature.map(|_| (OfferedSignature::Same, "the same signature"));
    let offers = || same.into_iter().chain([(OfferedSignature::Other, "another application")]);
    let offered = |make: fn(Offer) -> Action| {
        offers().map(move |(signature, words)| (make(Offer::fitting(signature)), Some(words))).collect::<Vec<_>>()
    };
    let now = state.protection();
    Action::alone()
        .filter(|action| is_done_here(*action))
        .map(|action| (action, None))
        .chain(offered(Action::Download))
        .chain(offered(Action::LoadFromCard))
        .map(|(action, offer)| Permission { verb: action.verb(), offer, refused: refusals(now, action).collect() })
        .collect()
}

/// Whether a controller in a folder has the action at all: what is done in a project file is not done here.
fn is_done_here(action: Action) -> bool {
    !matches!(action, Action::EditOffline | Action::CreateAddOn | Action::ImportAddOn)
}
