//! One thing that a row of the table asks.

use super::action::{Action, Offer, OfferedSignature};
use super::state::{Edits, Forces, Keyswitch, Place, SafetyTaskStatus, State};
use crate::mode::Mode;

/// One thing that a row of the table asks of the state, or of what the action is done with.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[expect(missing_docs, reason = "each says in words what it asks")]
pub enum Condition {
    Offline,
    Online,
    NoApplication,
    NoCard,
    KeyswitchRun,
    KeyswitchProgram,
    ModeRun,
    Locked,
    Unlocked,
    Signed,
    Unsigned,
    Forces,
    NoForces,
    ForcesEnabled,
    ForcesDisabled,
    Pending,
    NothingPending,
    Edits,
    NoEdits,
    NothingAccepted,
    NotTested,
    Tested,
    StatusNotOk,
    NoFault,
    SafetyFault,
    ControllerFault,
    OfferOfOtherSignature,
    OfferWithoutSignature,
    OfferOfOtherType,
    OfferOfOtherRevision,
    OfferOfOtherSeries,
    InstructionSealed,
    InstructionOpen,
    HistoryFull,
}

impl Condition {
    /// In words, as a page lists it.
    pub const fn words(self) -> &'static str {
        match self {
            Condition::Offline => "offline",
            Condition::Online => "online",
            Condition::NoApplication => "no application in the controller",
            Condition::NoCard => "no memory card (before revision 18)",
            Condition::KeyswitchRun => "keyswitch in RUN",
            Condition::KeyswitchProgram => "keyswitch in PROG",
            Condition::ModeRun => "mode Run",
            Condition::Locked => "locked",
            Condition::Unlocked => "unlocked",
            Condition::Signed => "with signature",
            Condition::Unsigned => "without signature",
            Condition::Forces => "forces installed",
            Condition::NoForces => "no forces installed",
            Condition::ForcesEnabled => "forces enabled",
            Condition::ForcesDisabled => "forces disabled",
            Condition::Pending => "pending edits",
            Condition::NothingPending => "no pending edits",
            Condition::Edits => "online edits",
            Condition::NoEdits => "no online edits",
            Condition::NothingAccepted => "no accepted edits",
            Condition::NotTested => "edits not tested",
            Condition::Tested => "edits tested",
            Condition::StatusNotOk => "safety task status not OK",
            Condition::NoFault => "no fault",
            Condition::SafetyFault => "nonrecoverable safety fault",
            Condition::ControllerFault => "nonrecoverable controller fault",
            Condition::OfferOfOtherSignature => "the other signature differs",
            Condition::OfferWithoutSignature => "the other has no signature",
            Condition::OfferOfOtherType => "for another controller",
            Condition::OfferOfOtherRevision => "for another revision",
            Condition::OfferOfOtherSeries => "for another hardware series",
            Condition::InstructionSealed => "the instruction is sealed",
            Condition::InstructionOpen => "the instruction is not sealed",
            Condition::HistoryFull => "six entries",
        }
    }

    /// Whether it holds.
    pub fn holds(self, state: State, action: Action) -> bool {
        let accepted = matches!(state.edits, Edits::Accepted | Edits::Tested);
        match self {
            Condition::Offline => state.place == Place::Offline,
            Condition::Online => state.place == Place::Online,
            Condition::NoApplication => {
                matches!(state.status, SafetyTaskStatus::NoProject | SafetyTaskStatus::NonrecoverableControllerFault)
            }
            Condition::NoCard => !state.takes_card,
            Condition::KeyswitchRun => state.keyswitch == Keyswitch::Run,
            Condition::KeyswitchProgram => state.keyswitch == Keyswitch::Program,
            Condition::ModeRun => state.mode == Mode::Run,
            Condition::Locked => state.locked,
            Condition::Unlocked => !state.locked,
            Condition::Signed => state.signed,
            Condition::Unsigned => !state.signed,
            Condition::Forces => state.forces != Forces::None,
            Condition::NoForces => state.forces == Forces::None,
            Condition::ForcesEnabled => state.forces == Forces::Enabled,
            Condition::ForcesDisabled => state.forces == Forces::Disabled,
            Condition::Pending => state.edits == Edits::Pending,
            Condition::NothingPending => state.edits != Edits::Pending,
            Condition::Edits => state.edits != Edits::None,
            Condition::NoEdits => state.edits == Edits::None,
            Condition::NothingAccepted => !accepted,
            Condition::NotTested => state.edits != Edits::Tested,
            Condition::Tested => state.edits == Edits::Tested,
            Condition::StatusNotOk => state.status != SafetyTaskStatus::Ok,
            Condition::NoFault => matches!(state.status, SafetyTaskStatus::Ok | SafetyTaskStatus::NoProject),
            Condition::SafetyFault => state.status == SafetyTaskStatus::NonrecoverableSafetyFault,
            Condition::ControllerFault => state.status == SafetyTaskStatus::NonrecoverableControllerFault,
            _ => self.holds_of_action(action),
        }
    }

    fn holds_of_action(self, action: Action) -> bool {
        let offered = |holds: fn(Offer) -> bool| match action {
            Action::Download(offer) | Action::LoadFromCard(offer) => holds(offer),
            _ => false,
        };
        let sealed = match action {
            Action::EditAddOn { sealed }
            | Action::SealAddOn { sealed }
            | Action::UnsealAddOn { sealed }
            | Action::AddHistoryEntry { sealed, .. } => Some(sealed),
            _ => None,
        };
        match self {
            Condition::OfferOfOtherSignature => offered(|offer| offer.signature == OfferedSignature::Other),
            Condition::OfferWithoutSignature => offered(|offer| offer.signature == OfferedSignature::Without),
            Condition::OfferOfOtherType => offered(|offer| !offer.same_type),
            Condition::OfferOfOtherRevision => offered(|offer| !offer.same_revision),
            Condition::OfferOfOtherSeries => offered(|offer| !offer.same_series),
            Condition::InstructionSealed => sealed == Some(true),
            Condition::InstructionOpen => sealed == Some(false),
            Condition::HistoryFull => matches!(action, Action::AddHistoryEntry { full: true, .. }),
            _ => false,
        }
    }
}
