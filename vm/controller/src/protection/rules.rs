//! The table: which action is refused when, why, and the way out.

use super::action::{Action, Verb};
use super::condition::Condition;
use super::state::State;

use Condition as C;
use Verb as V;

/// A row of the table.
#[derive(Debug, PartialEq, Eq)]
pub struct Rule {
    /// Its number, for messages and pages: it stays with the row.
    pub code: &'static str,
    /// The actions that it refuses.
    pub actions: &'static [Verb],
    /// When: all of these.
    pub when: &'static [Condition],
    /// Why.
    pub reason: &'static str,
    /// What is to be done first.
    pub way_out: &'static str,
    /// Where it comes from.
    pub source: &'static str,
}

impl Rule {
    /// Whether this row refuses an action in a state.
    pub fn refuses(&self, state: State, action: Action) -> bool {
        let verb = action.verb();
        self.actions.contains(&verb) && self.when.iter().all(|condition| condition.holds(state, action))
    }
}

const fn rule(
    code: &'static str,
    actions: &'static [Verb],
    when: &'static [Condition],
    [reason, way_out, source]: [&'static str; 3],
) -> Rule {
    Rule { code, actions, when, reason, way_out, source }
}

const EDITS: &[Verb] = &[V::BeginEdit, V::AcceptEdits, V::TestEdits, V::UntestEdits, V::AssembleEdits, V::CancelEdits];
const FORCES: &[Verb] = &[V::InstallForce, V::RemoveForce, V::EnableForces, V::DisableForces];
const CHANGES_OF_INSTRUCTIONS: &[Verb] = &[V::CreateAddOn, V::EditAddOn, V::SealAddOn, V::UnsealAddOn, V::ImportAddOn];
const INHIBIT: &[Verb] = &[V::InhibitModule, V::UninhibitModule];

/// Every row; of those that refuse an action, the first is its reason.
pub static RULES: &[Rule] = &[
    rule(
        "P01",
        &[
            V::RunMode,
            V::ProgramMode,
            V::Download,
            V::Upload,
            V::LoadFromCard,
            V::StoreToCard,
            V::GenerateSignature,
            V::InstallForce,
            V::EnableForces,
            V::DisableForces,
            V::BeginEdit,
            V::AcceptEdits,
            V::TestEdits,
            V::UntestEdits,
            V::AssembleEdits,
            V::CancelEdits,
            V::ClearFault,
            V::OverrideFault,
        ],
        &[C::Offline],
        [
            "a project file has no controller",
            "go online with the controller",
            "1756-RM093 Generate the Safety Task Signature; of the rest recalled",
        ],
    ),
    rule(
        "P02",
        &[
            V::EditOffline,
            V::CreateAddOn,
            V::EditAddOn,
            V::SealAddOn,
            V::UnsealAddOn,
            V::AddHistoryEntry,
            V::ImportAddOn,
        ],
        &[C::Online],
        [
            "this is done in the project file",
            "go offline, change the project, download it",
            "1756-RM093 Online Editing; Appendix B; to create and to seal decided as to edit",
        ],
    ),
    rule(
        "P03",
        &[
            V::RunMode,
            V::Upload,
            V::StoreToCard,
            V::GenerateSignature,
            V::DeleteSignature,
            V::Lock,
            V::Unlock,
            V::InstallForce,
            V::RemoveForce,
            V::EnableForces,
            V::DisableForces,
            V::WriteSafetyData,
            V::BeginEdit,
            V::AcceptEdits,
            V::TestEdits,
            V::UntestEdits,
            V::AssembleEdits,
            V::CancelEdits,
            V::InhibitModule,
            V::UninhibitModule,
        ],
        &[C::NoApplication],
        [
            "the controller holds no application",
            "download the project",
            "1756-RM093 Table 8, comments; Nonrecoverable Controller Faults",
        ],
    ),
    rule(
        "P04",
        &[V::StoreToCard, V::LoadFromCard],
        &[C::NoCard],
        [
            "controllers have memory cards from revision 18 on",
            "download the project",
            "1756-RM093 Storing and Loading a Project from Nonvolatile Memory",
        ],
    ),
    // Modes and keyswitch.
    rule(
        "P05",
        &[V::RunMode, V::ProgramMode],
        &[C::KeyswitchRun],
        ["the keyswitch decides the mode", "turn the keyswitch to REM", "recalled"],
    ),
    rule(
        "P06",
        &[V::RunMode, V::ProgramMode],
        &[C::KeyswitchProgram],
        ["the keyswitch decides the mode", "turn the keyswitch to REM", "recalled"],
    ),
    // Download and memory card.
    rule(
        "P10",
        &[V::Download],
        &[C::KeyswitchRun],
        ["the keyswitch is in RUN", "turn the keyswitch to REM or PROG", "recalled"],
    ),
    rule(
        "P11",
        &[V::Download, V::LoadFromCard],
        &[C::ModeRun],
        [
            "the controller is in Run mode",
            "change to Program mode",
            "1756-RM093 Storing and Loading a Project from Nonvolatile Memory; for a download decided",
        ],
    ),
    rule(
        "P12",
        &[V::Download, V::LoadFromCard],
        &[C::OfferOfOtherType],
        [
            "the project is for another controller",
            "change the controller type of the project, and validate it again",
            "1756-RM093 Storing and Loading a Project from Nonvolatile Memory; for a download recalled",
        ],
    ),
    rule(
        "P13",
        &[V::Download, V::LoadFromCard],
        &[C::OfferOfOtherRevision],
        [
            "the project is for another revision of the operating system",
            "bring controller and project to one revision",
            "1756-RM093 Downloading the Safety Application Program; Storing and Loading; unlocked recalled",
        ],
    ),
    rule(
        "P14",
        &[V::Download, V::LoadFromCard],
        &[C::Locked, C::Unsigned],
        [
            "the controller is locked without a safety task signature: nothing can match",
            "unlock the controller",
            "1756-RM093 Downloading the Safety Application Program; Storing and Loading",
        ],
    ),
    rule(
        "P15",
        &[V::Download, V::LoadFromCard],
        &[C::Locked, C::OfferOfOtherSignature],
        [
            "the controller is locked and the safety task signatures differ",
            "unlock the controller; the download deletes its signature, and the application is to be validated again",
            "1756-RM093 Downloading the Safety Application Program; Storing and Loading",
        ],
    ),
    rule(
        "P16",
        &[V::Download, V::LoadFromCard],
        &[C::Locked, C::OfferWithoutSignature],
        [
            "the controller is locked and what is offered has no safety task signature",
            "unlock the controller; the download deletes its signature, and the application is to be validated again",
            "1756-RM093 Downloading the Safety Application Program; Storing and Loading",
        ],
    ),
    rule(
        "P17",
        &[V::Download],
        &[C::Locked, C::OfferOfOtherSeries],
        [
            "the controller is locked and of another hardware series than the project",
            "unlock the controller",
            "1756-RM093 Downloading the Safety Application Program",
        ],
    ),
    rule(
        "P18",
        &[V::Download],
        &[C::Locked, C::StatusNotOk],
        [
            "the controller is locked and its safety task status is not OK",
            "clear the fault, or unlock the controller",
            "1756-RM093 Downloading the Safety Application Program",
        ],
    ),
    rule(
        "P19",
        &[V::StoreToCard],
        &[C::ModeRun],
        ["the controller is in Run mode", "change to Program mode", "recalled"],
    ),
    // The safety task signature.
    rule(
        "P20",
        &[V::GenerateSignature],
        &[C::Signed],
        [
            "there is a safety task signature",
            "delete it first; the application is then to be validated again",
            "decided: a validated signature is not replaced by accident",
        ],
    ),
    rule(
        "P21",
        &[V::GenerateSignature],
        &[C::ModeRun],
        ["the controller is in Run mode", "change to Program mode", "1756-RM093 Generate the Safety Task Signature"],
    ),
    rule(
        "P22",
        &[V::GenerateSignature, V::DeleteSignature],
        &[C::Locked],
        [
            "the controller is safety-locked",
            "unlock the controller",
            "1756-RM093 Generate the Safety Task Signature; Lock the GuardLogix Controller; Table 8",
        ],
    ),
    rule(
        "P23",
        &[V::GenerateSignature],
        &[C::Forces],
        [
            "forces are installed on safety tags; to disable them is not enough",
            "remove the forces",
            "1756-RM093 Generate the Safety Task Signature; Force Data",
        ],
    ),
    rule(
        "P24",
        &[V::GenerateSignature],
        &[C::Edits],
        [
            "online edits of safety routines are neither assembled nor cancelled",
            "assemble or cancel them",
            "1756-RM093 Generate the Safety Task Signature; of accepted edits decided: a signature is of one text",
        ],
    ),
    rule(
        "P25",
        &[V::GenerateSignature],
        &[C::StatusNotOk],
        [
            "the safety task status is not OK",
            "clear the fault, or download the project",
            "1756-RM093 Generate the Safety Task Signature",
        ],
    ),
    rule(
        "P26",
        &[V::DeleteSignature],
        &[C::KeyswitchRun],
        [
            "the keyswitch is in RUN",
            "turn the keyswitch to REM or PROG",
            "1756-RM093 Generate the Safety Task Signature",
        ],
    ),
    rule(
        "P27",
        &[V::DeleteSignature],
        &[C::Unsigned],
        ["there is no safety task signature", "nothing is to be done", "decided"],
    ),
    // The lock.
    rule(
        "P30",
        &[V::Lock, V::Unlock],
        &[C::KeyswitchRun],
        ["the keyswitch is in RUN", "turn the keyswitch to REM or PROG", "1756-RM093 Lock the GuardLogix Controller"],
    ),
    rule("P31", &[V::Lock], &[C::Locked], ["the controller is locked", "nothing is to be done", "decided"]),
    rule(
        "P32",
        &[V::Lock],
        &[C::Forces],
        [
            "forces are installed on safety tags; to disable them is not enough",
            "remove the forces",
            "1756-RM093 Lock the GuardLogix Controller; Force Data",
        ],
    ),
    rule(
        "P33",
        &[V::Lock],
        &[C::Pending],
        [
            "safety edits are pending",
            "accept or cancel them",
            "1756-RM093 Lock the GuardLogix Controller; Online Editing",
        ],
    ),
    rule("P34", &[V::Unlock], &[C::Unlocked], ["the controller is unlocked", "nothing is to be done", "decided"]),
    // What a lock or a signature protects.
    rule(
        "P40",
        FORCES,
        &[C::Locked],
        ["the controller is safety-locked", "unlock the controller", "1756-RM093 Table 8; Force Data"],
    ),
    rule(
        "P41",
        FORCES,
        &[C::Signed],
        [
            "there is a safety task signature",
            "delete the signature; the application is then to be validated again",
            "1756-RM093 Table 8; Force Data",
        ],
    ),
    rule(
        "P42",
        &[V::RemoveForce, V::EnableForces, V::DisableForces],
        &[C::NoForces],
        ["no force is installed", "nothing is to be done", "decided"],
    ),
    rule(
        "P43",
        &[V::EnableForces],
        &[C::ForcesEnabled],
        ["the forces are enabled", "nothing is to be done", "decided"],
    ),
    rule(
        "P44",
        &[V::DisableForces],
        &[C::ForcesDisabled],
        ["the forces are disabled", "nothing is to be done", "decided"],
    ),
    rule(
        "P45",
        &[V::WriteSafetyData],
        &[C::Locked],
        [
            "the controller is safety-locked: safety memory is read only",
            "unlock the controller",
            "1756-RM093 Table 8; Lock the GuardLogix Controller",
        ],
    ),
    rule(
        "P46",
        &[V::WriteSafetyData],
        &[C::Signed],
        [
            "there is a safety task signature: safety memory is read only",
            "delete the signature; the application is then to be validated again",
            "1756-RM093 Table 8; Generate the Safety Task Signature",
        ],
    ),
    rule(
        "P47",
        INHIBIT,
        &[C::Locked],
        ["the controller is safety-locked", "unlock the controller", "1756-RM093 Inhibit a Module"],
    ),
    rule(
        "P48",
        INHIBIT,
        &[C::Signed],
        [
            "there is a safety task signature",
            "delete the signature; the application is then to be validated again",
            "1756-RM093 Inhibit a Module",
        ],
    ),
    // Edits.
    rule(
        "P50",
        EDITS,
        &[C::KeyswitchRun],
        ["the keyswitch is in RUN", "turn the keyswitch to REM or PROG", "recalled"],
    ),
    rule(
        "P51",
        EDITS,
        &[C::Locked],
        [
            "the controller is safety-locked: online edits stay as they are",
            "unlock the controller",
            "1756-RM093 Table 8; Online Editing",
        ],
    ),
    rule(
        "P52",
        EDITS,
        &[C::Signed],
        [
            "there is a safety task signature",
            "delete the signature; the application is then to be validated again",
            "1756-RM093 Table 8; Online Editing",
        ],
    ),
    rule("P53", &[V::AcceptEdits], &[C::NothingPending], ["no edit is pending", "begin an edit", "decided"]),
    rule(
        "P54",
        &[V::TestEdits, V::UntestEdits, V::AssembleEdits],
        &[C::NothingAccepted],
        ["no edit is accepted", "accept the pending edits", "decided"],
    ),
    rule("P55", &[V::TestEdits], &[C::Tested], ["the edits are being tested", "nothing is to be done", "decided"]),
    rule("P56", &[V::UntestEdits], &[C::NotTested], ["the edits are not tested", "test them", "decided"]),
    rule("P57", &[V::CancelEdits], &[C::NoEdits], ["there is no online edit", "nothing is to be done", "decided"]),
    rule(
        "P58",
        &[V::BeginEdit],
        &[C::Edits],
        ["there are online edits", "assemble or cancel them", "decided: one change at a time"],
    ),
    rule(
        "P60",
        &[V::EditOffline],
        &[C::Locked],
        [
            "the application is safety-locked",
            "unlock the application in the project file",
            "1756-RM093 Lock the GuardLogix Controller",
        ],
    ),
    rule(
        "P61",
        &[V::EditOffline],
        &[C::Signed],
        [
            "there is a safety task signature",
            "delete the signature; the application is then to be validated again",
            "1756-RM093 Generate the Safety Task Signature",
        ],
    ),
    // Safety Add-On Instructions.
    rule(
        "P62",
        CHANGES_OF_INSTRUCTIONS,
        &[C::Locked],
        [
            "the application is safety-locked",
            "unlock the application",
            "1756-RM093 Lock the GuardLogix Controller; Appendix B; to seal decided as to edit",
        ],
    ),
    rule(
        "P63",
        CHANGES_OF_INSTRUCTIONS,
        &[C::Signed],
        [
            "there is a safety task signature",
            "delete the signature; the application is then to be validated again",
            "1756-RM093 Generate the Safety Task Signature; Appendix B; to seal decided as to edit",
        ],
    ),
    rule(
        "P64",
        &[V::EditAddOn],
        &[C::InstructionSealed],
        ["an instruction signature seals the instruction", "remove the instruction signature", "1756-RM093 Appendix B"],
    ),
    rule(
        "P65",
        &[V::SealAddOn],
        &[C::InstructionSealed],
        ["the instruction is sealed", "nothing is to be done", "decided"],
    ),
    rule(
        "P66",
        &[V::UnsealAddOn],
        &[C::InstructionOpen],
        ["the instruction is not sealed", "nothing is to be done", "decided"],
    ),
    rule(
        "P67",
        &[V::AddHistoryEntry],
        &[C::InstructionOpen],
        [
            "an entry holds the instruction signature, and there is none",
            "generate the instruction signature",
            "1756-RM093 Appendix B",
        ],
    ),
    rule(
        "P68",
        &[V::AddHistoryEntry],
        &[C::HistoryFull],
        ["the history holds six entries", "remove one first", "1756-RM093 Appendix B; the way out decided"],
    ),
    // Faults.
    rule(
        "P70",
        &[V::ClearFault, V::OverrideFault],
        &[C::NoFault],
        ["there is no fault", "nothing is to be done", "decided"],
    ),
    rule(
        "P71",
        &[V::ClearFault, V::OverrideFault],
        &[C::ControllerFault],
        [
            "a nonrecoverable controller fault lost the application",
            "download the project",
            "1756-RM093 Nonrecoverable Controller Faults",
        ],
    ),
    rule(
        "P72",
        &[V::ClearFault],
        &[C::SafetyFault, C::Unsigned],
        [
            "without a safety task signature safety memory is not reinitialized by clearing",
            "download the project; to override keeps standard tasks running and does not clear the fault",
            "1756-RM093 Nonrecoverable Safety Faults",
        ],
    ),
];
