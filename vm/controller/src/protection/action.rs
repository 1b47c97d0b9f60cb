//! What somebody asks of a controller, or does to a project file.

use crate::mode::Mode;

/// The safety task signature of what is offered, beside the controller's.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum OfferedSignature {
    /// The same ID.
    Same,
    /// Another ID.
    Other,
    /// None.
    Without,
}

/// A project that is downloaded, or loaded from a card, beside the controller that is to take it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Offer {
    /// Its signature.
    pub signature: OfferedSignature,
    /// Whether it is for this catalogue number.
    pub same_type: bool,
    /// Whether it is for this revision of the operating system.
    pub same_revision: bool,
    /// Whether it is for this series of the hardware.
    pub same_series: bool,
}

/// One thing that may be asked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Action {
    /// Changes the mode by software.
    ChangeMode(Mode),
    /// Downloads a project.
    Download(Offer),
    /// Uploads the project.
    Upload,
    /// Loads the project of the memory card.
    LoadFromCard(Offer),
    /// Stores the project on the memory card.
    StoreToCard,
    /// Generates the safety task signature.
    GenerateSignature,
    /// Deletes the safety task signature.
    DeleteSignature,
    /// Safety-locks the application.
    Lock,
    /// Safety-unlocks the application.
    Unlock,
    /// Installs a force on an I/O, produced or consumed safety tag.
    InstallForce,
    /// Removes forces.
    RemoveForce,
    /// Enables the installed forces.
    EnableForces,
    /// Disables the installed forces.
    DisableForces,
    /// Writes safety data otherwise than by routine logic or from another safety controller.
    WriteSafetyData,
    /// Begins to change a rung of a safety routine online.
    BeginEdit,
    /// Accepts the pending edits.
    AcceptEdits,
    /// Lets the accepted edits execute.
    TestEdits,
    /// Lets the original rungs execute again.
    UntestEdits,
    /// Makes the accepted edits the program.
    AssembleEdits,
    /// Drops the edits.
    CancelEdits,
    /// Edits safety components in a project file.
    EditOffline,
    /// Inhibits a safety module or the connection to a producer.
    InhibitModule,
    /// Ends that.
    UninhibitModule,
    /// Creates a safety Add-On Instruction.
    CreateAddOn,
    /// Edits a safety Add-On Instruction.
    EditAddOn {
        /// Whether an instruction signature seals it.
        sealed: bool,
    },
    /// Generates the instruction signature of a safety Add-On Instruction.
    SealAddOn {
        /// Whether there is one already.
        sealed: bool,
    },
    /// Removes the instruction signature.
    UnsealAddOn {
        /// Whether there is one.
        sealed: bool,
    },
    /// Adds an entry to the signature history of a safety Add-On Instruction.
    AddHistoryEntry {
        /// Whether an instruction signature seals it.
        sealed: bool,
        /// Whether the history has its six entries.
        full: bool,
    },
    /// Imports a safety Add-On Instruction.
    ImportAddOn,
    /// Clears the fault of the safety task.
    ClearFault,
    /// Overrides the fault of the safety task: standard tasks go on, the fault stays.
    OverrideFault,
}

/// An action without what it is done with: what a row of the table names.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[expect(missing_docs, reason = "each is explained at the action of the same name")]
pub enum Verb {
    RunMode,
    ProgramMode,
    Download,
    Upload,
    LoadFromCard,
    StoreToCard,
    GenerateSignature,
    DeleteSignature,
    Lock,
    Unlock,
    InstallForce,
    RemoveForce,
    EnableForces,
    DisableForces,
    WriteSafetyData,
    BeginEdit,
    AcceptEdits,
    TestEdits,
    UntestEdits,
    AssembleEdits,
    CancelEdits,
    EditOffline,
    InhibitModule,
    UninhibitModule,
    CreateAddOn,
    EditAddOn,
    SealAddOn,
    UnsealAddOn,
    AddHistoryEntry,
    ImportAddOn,
    ClearFault,
    OverrideFault,
}

impl Verb {
    /// All, in the order of the pages that list them.
    pub const ALL: [Verb; 32] = [
        Verb::RunMode,
        Verb::ProgramMode,
        Verb::Download,
        Verb::Upload,
        Verb::LoadFromCard,
        Verb::StoreToCard,
        Verb::GenerateSignature,
        Verb::DeleteSignature,
        Verb::Lock,
        Verb::Unlock,
        Verb::InstallForce,
        Verb::RemoveForce,
        Verb::EnableForces,
        Verb::DisableForces,
        Verb::WriteSafetyData,
        Verb::BeginEdit,
        Verb::AcceptEdits,
        Verb::TestEdits,
        Verb::UntestEdits,
        Verb::AssembleEdits,
        Verb::CancelEdits,
        Verb::EditOffline,
        Verb::InhibitModule,
        Verb::UninhibitModule,
        Verb::CreateAddOn,
        Verb::EditAddOn,
        Verb::SealAddOn,
        Verb::UnsealAddOn,
        Verb::AddHistoryEntry,
        Verb::ImportAddOn,
        Verb::ClearFault,
        Verb::OverrideFault,
    ];

    /// What it is called.
    pub const fn name(self) -> &'static str {
        match self {
            Verb::RunMode => "change to Run",
            Verb::ProgramMode => "change to Program",
            Verb::Download => "download",
            Verb::Upload => "upload",
            Verb::LoadFromCard => "load from the card",
            Verb::StoreToCard => "store to the card",
            Verb::GenerateSignature => "generate the safety task signature",
            Verb::DeleteSignature => "delete the safety task signature",
            Verb::Lock => "safety-lock",
            Verb::Unlock => "safety-unlock",
            Verb::InstallForce => "install a force",
            Verb::RemoveForce => "remove a force",
            Verb::EnableForces => "enable forces",
            Verb::DisableForces => "disable forces",
            Verb::WriteSafetyData => "write safety data",
            Verb::BeginEdit => "begin an online edit",
            Verb::AcceptEdits => "accept online edits",
            Verb::TestEdits => "test online edits",
            Verb::UntestEdits => "untest online edits",
            Verb::AssembleEdits => "assemble online edits",
            Verb::CancelEdits => "cancel online edits",
            Verb::EditOffline => "edit safety components offline",
            Verb::InhibitModule => "inhibit a module",
            Verb::UninhibitModule => "uninhibit a module",
            Verb::CreateAddOn => "create a safety Add-On Instruction",
            Verb::EditAddOn => "edit a safety Add-On Instruction",
            Verb::SealAddOn => "seal a safety Add-On Instruction",
            Verb::UnsealAddOn => "remove its seal",
            Verb::AddHistoryEntry => "add an entry to its signature history",
            Verb::ImportAddOn => "import a safety Add-On Instruction",
            Verb::ClearFault => "clear the safety fault",
            Verb::OverrideFault => "override the safety fault",
        }
    }
}

impl Action {
    /// The action without what it is done with.
    pub const fn verb(self) -> Verb {
        match self {
            Action::ChangeMode(Mode::Run) => Verb::RunMode,
            Action::ChangeMode(Mode::Program) => Verb::ProgramMode,
            Action::Download(_) => Verb::Download,
            Action::Upload => Verb::Upload,
            Action::LoadFromCard(_) => Verb::LoadFromCard,
            Action::StoreToCard => Verb::StoreToCard,
            Action::GenerateSignature => Verb::GenerateSignature,
            Action::DeleteSignature => Verb::DeleteSignature,
            Action::Lock => Verb::Lock,
            Action::Unlock => Verb::Unlock,
            Action::InstallForce => Verb::InstallForce,
            Action::RemoveForce => Verb::RemoveForce,
            Action::EnableForces => Verb::EnableForces,
            Action::DisableForces => Verb::DisableForces,
            Action::WriteSafetyData => Verb::WriteSafetyData,
            Action::BeginEdit => Verb::BeginEdit,
            Action::AcceptEdits => Verb::AcceptEdits,
            Action::TestEdits => Verb::TestEdits,
            Action::UntestEdits => Verb::UntestEdits,
            Action::AssembleEdits => Verb::AssembleEdits,
            Action::CancelEdits => Verb::CancelEdits,
            Action::EditOffline => Verb::EditOffline,
            Action::InhibitModule => Verb::InhibitModule,
            Action::UninhibitModule => Verb::UninhibitModule,
            Action::CreateAddOn => Verb::CreateAddOn,
            Action::EditAddOn { .. } => Verb::EditAddOn,
            Action::SealAddOn { .. } => Verb::SealAddOn,
            Action::UnsealAddOn { .. } => Verb::UnsealAddOn,
            Action::AddHistoryEntry { .. } => Verb::AddHistoryEntry,
            Action::ImportAddOn => Verb::ImportAddOn,
            Action::ClearFault => Verb::ClearFault,
            Action::OverrideFault => Verb::OverrideFault,
        }
    }

    /// Every action, with everything that it can be done with.
    pub fn all() -> impl Iterator<Item = Action> {
        Action::alone().chain(Offer::all().map(Action::Download)).chain(Offer::all().map(Action::LoadFromCard)).chain(
            [false, true].into_iter().flat_map(|sealed| {
                [Action::EditAddOn { sealed }, Action::SealAddOn { sealed }, Action::UnsealAddOn { sealed }]
                    .into_iter()
                    .chain([false, true].into_iter().map(move |full| Action::AddHistoryEntry { sealed, full }))
            }),
        )
    }

    /// Every action that is done with nothing: no offer, no Add-On Instruction.
    pub fn alone() -> impl Iterator<Item = Action> {
        const ALONE: [Action; 26] = [
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
            Action::BeginEdit,
            Action::AcceptEdits,
            Action::TestEdits,
            Action::UntestEdits,
            Action::AssembleEdits,
            Action::CancelEdits,
            Action::EditOffline,
            Action::InhibitModule,
            Action::UninhibitModule,
            Action::CreateAddOn,
            Action::ImportAddOn,
            Action::ClearFault,
            Action::OverrideFault,
        ];
        ALONE.into_iter()
    }
}

impl Offer {
    /// A project with this signature, made for this very controller.
    pub const fn fitting(signature: OfferedSignature) -> Offer {
        Offer { signature, same_type: true, same_revision: true, same_series: true }
    }

    /// Every offer.
    pub fn all() -> impl Iterator<Item = Offer> {
        let flags = || [true, false].into_iter();
        [OfferedSignature::Same, OfferedSignature::Other, OfferedSignature::Without].into_iter().flat_map(
            move |signature| {
                flags().flat_map(move |same_type| {
                    flags().flat_map(move |same_revision| {
                        flags().map(move |same_series| Offer { signature, same_type, same_revision, same_series })
                    })
                })
            },
        )
    }
}
