//! A project with every name resolved and every type laid out: what the rules judge and the lowering lowers.

pub mod add_on;
pub mod controller;
pub mod data;
pub mod module;
pub mod program;
pub mod rung;
pub mod tag;
pub mod task;
pub mod types;

mod build;
mod context;
pub(crate) mod names_in_scope;
mod packed_bits;
pub(crate) mod reading;
pub mod standard;
mod tags;

pub(crate) use build::{Inputs, build, is_argument};
pub(crate) use names_in_scope::ScopeNames;

use twinrung_grammar::tree::{CompactString, Span};

pub use add_on::{AddOn, Parameter};
pub use controller::Profile;
pub use module::{Module, Point, Setting};
pub use program::{Program, Routine, RoutineOwner};
pub use rung::{Branch, Call, Element, Instruction, OpcodeSet, OperandUse, Place, Rung};
pub use tag::{MapLine, Tag, TagClass, TagKind, TagScope};
pub use task::Task;
pub use types::Types;

use crate::operand::Operand;

/// The safety program of routines that a file shows without a program.
pub const UNNAMED_PROGRAM: &str = "SafetyProgram";

macro_rules! id {
    ($($(#[$doc:meta])* $name:ident($inner:ty);)*) => {
        $(
            $(#[$doc])*
            #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
            pub struct $name(pub $inner);

            impl $name {
                /// As a position in its table.
                pub const fn position(self) -> usize {
                    self.0 as usize
                }
            }
        )*
    };
}

id! {
    /// A tag of [`Project::tags`].
    TagId(u32);
    /// A safety program of [`Project::programs`].
    ProgramId(u16);
    /// A routine of [`Project::routines`].
    RoutineId(u32);
    /// An Add-On Instruction of [`Project::add_ons`].
    AddOnId(u16);
    /// An operand of [`Project::operands`].
    OperandId(u32);
}

/// A project. Where an instruction or a declaration was found faulty it is left out here, so that one mistake is
/// reported once; [`crate::CheckedProject`] says that nothing was.
#[derive(Debug)]
pub struct Project {
    /// The controller's name; empty for a library.
    pub name: CompactString,
    /// What the controller admits; nothing for a library.
    pub profile: Option<Profile>,
    /// The structure types that safety data uses.
    pub types: Types,
    /// What instances of Add-On Instructions hold before anything runs.
    pub defaults: data::Defaults,
    /// Safety Add-On Instructions.
    pub add_ons: Vec<AddOn>,
    /// Safety programs.
    pub programs: Vec<Program>,
    /// Routines of safety programs and of Add-On Instructions.
    pub routines: Vec<Routine>,
    /// All tags, those of class Standard among them.
    pub tags: Vec<Tag>,
    /// The operands that rungs use.
    pub operands: Vec<Operand>,
    /// All modules.
    pub modules: Vec<Module>,
    /// The safety tag map.
    pub map: Vec<MapLine>,
    /// All tasks.
    pub tasks: Vec<Task>,
    /// The safety task: a position in [`Project::tasks`].
    pub safety_task: Option<usize>,
    /// Places where a force is installed.
    pub forces: Vec<Span>,
    /// Which instructions the safety logic holds, by opcode.
    pub opcodes: OpcodeSet,
    /// What standard programs write.
    pub standard_writes: Vec<standard::StandardWrite>,
    /// Names of event tasks of class Standard.
    pub event_tasks: Vec<CompactString>,
    /// Further settings of the controller that belong to the signed declaration.
    pub attributes: Vec<(String, String)>,
    /// Names of the tags to publish instead of output modules and produced tags.
    pub outputs: Vec<String>,
    /// Whether this is a library of Add-On Instructions.
    pub library: bool,
    /// Where the controller is declared.
    pub span: Span,
}

impl Project {
    /// One tag.
    pub fn tag(&self, id: TagId) -> &Tag {
        &self.tags[id.position()]
    }

    /// One operand.
    pub fn operand(&self, id: OperandId) -> &Operand {
        &self.operands[id.position()]
    }

    /// One routine.
    pub fn routine(&self, id: RoutineId) -> &Routine {
        &self.routines[id.position()]
    }

    /// One program.
    pub fn program(&self, id: ProgramId) -> &Program {
        &self.programs[id.position()]
    }

    /// One Add-On Instruction.
    pub fn add_on(&self, id: AddOnId) -> &AddOn {
        &self.add_ons[id.position()]
    }

    /// `Program/Routine`, or `AddOn/Routine`.
    pub fn routine_name(&self, id: RoutineId) -> String {
        let routine = self.routine(id);
        let owner = match routine.owner {
            RoutineOwner::Program(program) => &self.program(program).name,
            RoutineOwner::AddOn(add_on) => &self.add_on(add_on).name,
        };
        format!("{owner}/{}", routine.name)
    }
}
