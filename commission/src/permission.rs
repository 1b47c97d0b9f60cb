//! What is permitted now, and what is not and why.

use twinrung_controller::Mode;
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
    let offer = |signature| Offer { signature, same_type: true, same_revision: true, same_series: true };
    let same = state.signature.map(|_| (OfferedSignature::Same, "the same signature"));
    let offers = || same.into_iter().chain([(OfferedSignature::Other, "another application")]);
    let offered = |make: fn(Offer) -> Action| {
        offers().map(move |(signature, words)| (make(offer(signature)), Some(words))).collect::<Vec<_>>()
    };
    let plain = [
        Action::ChangeMode(Mode::Run),
        Action::ChangeMode(Mode::Program),
        Action::Upload,
        Action::StoreToCard,
        Action::GenerateSignature,
        Action::DeleteSignature,
        Action::Lock,
        Action::Unlock,
        Action::InstallForce,
        Action::RemoveForce,
        Action::EnableForces,
        Action::DisableForces,
        Action::WriteSafetyData,
        Action::InhibitModule,
        Action::UninhibitModule,
        Action::ClearFault,
        Action::OverrideFault,
    ];
    let now = state.protection();
    plain
        .map(|action| (action, None))
        .into_iter()
        .chain(offered(Action::Download))
        .chain(offered(Action::LoadFromCard))
        .map(|(action, offer)| Permission { verb: action.verb(), offer, refused: refusals(now, action).collect() })
        .collect()
}
