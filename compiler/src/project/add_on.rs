//! Add-On Instructions.

use twinrung_bytecode::image::{TypeReference, Usage};
use twinrung_bytecode::index::TypeIndex;
use twinrung_grammar::tree::{CompactString, Span};

use super::RoutineId;

/// A safety Add-On Instruction.
#[derive(Debug)]
pub struct AddOn {
    /// Its name, which is its mnemonic.
    pub name: CompactString,
    /// Where the name is declared.
    pub span: Span,
    /// The type of its tags: parameters other than InOut, then local tags. Nothing where a member's type is faulty.
    pub instance_type: Option<TypeIndex>,
    /// Parameters; `EnableIn` and `EnableOut` are the first two.
    pub parameters: Vec<Parameter>,
    /// Local tags, in the order of their members.
    pub locals: Vec<Local>,
    /// Runs while the rung is true.
    pub logic: Option<RoutineId>,
    /// Runs at prescan, after Logic was prescanned.
    pub prescan: Option<RoutineId>,
    /// Runs while the rung is false.
    pub enable_in_false: Option<RoutineId>,
    /// Further settings that belong to the signed declaration.
    pub attributes: Vec<(String, String)>,
}

/// A parameter.
#[derive(Debug)]
pub struct Parameter {
    /// Its name.
    pub name: CompactString,
    /// Where it is declared.
    pub span: Span,
    /// Its direction.
    pub usage: Usage,
    /// Its type; nothing where it is faulty.
    pub type_reference: Option<TypeReference>,
    /// Dimensions (InOut only).
    pub dimensions: [u32; 3],
    /// Whether a call has an argument for it.
    pub argument: bool,
    /// The member of the instance type that holds it; nothing for InOut.
    pub member: Option<u16>,
    /// Whether logic may not write it.
    pub constant: bool,
}

/// A local tag.
#[derive(Debug)]
pub struct Local {
    /// Its name.
    pub name: CompactString,
    /// Where it is declared.
    pub span: Span,
    /// The member of the instance type that holds it.
    pub member: u16,
    /// Its type; nothing where it is faulty.
    pub type_reference: Option<TypeReference>,
    /// Dimensions.
    pub dimensions: [u32; 3],
}

impl AddOn {
    /// The parameters for which a call has arguments, in order.
    pub fn arguments(&self) -> impl Iterator<Item = &Parameter> {
        self.parameters.iter().filter(|parameter| parameter.argument)
    }
}
