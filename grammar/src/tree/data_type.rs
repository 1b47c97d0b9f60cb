//! User-defined and module-defined data types.

use super::{Attribute, ExternalAccess, Name, Span, Spanned, Text, Trivia};

/// Up to three array dimensions, or an index of as many subscripts. Empty for a scalar.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Default)]
pub struct Dimensions {
    length: u8,
    sizes: [u32; 3],
}

impl Dimensions {
    /// Dimensions in the order of subscripts; nothing when there are more than three.
    pub fn new(sizes: &[u32]) -> Option<Dimensions> {
        let mut dimensions = Dimensions { length: sizes.len() as u8, sizes: [0; 3] };
        dimensions.sizes.get_mut(..sizes.len())?.copy_from_slice(sizes);
        Some(dimensions)
    }

    /// The sizes in the order of subscripts.
    pub fn sizes(&self) -> &[u32] {
        &self.sizes[..usize::from(self.length)]
    }

    /// Whether this is a scalar.
    pub fn is_scalar(&self) -> bool {
        self.length == 0
    }
}

impl std::fmt::Debug for Dimensions {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_list().entries(self.sizes()).finish()
    }
}

/// A `DATATYPE`.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct DataType {
    /// The type's name.
    pub name: Name,
    /// Whether this comes along as context of a partial export, or is what was exported.
    pub usage: super::Usage,
    /// `FamilyType := StringFamily`: LEN and DATA of a string.
    pub is_string: bool,
    /// `User`, `IO`, `ProductDefined`: who defined it (L5X only).
    pub type_class: Option<Name>,
    /// The members in the order of memory.
    pub members: Vec<Member>,
    /// For people.
    pub description: Option<Box<Text>>,
    /// Everything else.
    pub attributes: Vec<Attribute>,
    /// Comments of the source around it.
    pub trivia: Trivia,
    /// The whole declaration.
    pub span: Span,
}

/// A member of a type.
///
/// A BOOL is either written plainly (`data_type` is `BOOL`, no `bit`), or as Studio packs it: a
/// hidden SINT member `ZZZZZZZZZZ...` and members of type `BIT` that name it as their target.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Member {
    /// The member's name.
    pub name: Name,
    /// Its type; `BIT` when `bit` is set.
    pub data_type: Name,
    /// Array size (one dimension at most in Studio; the shape allows three).
    pub dimensions: Dimensions,
    /// A hidden host of packed BOOLs.
    pub hidden: bool,
    /// For a `BIT`: which bit of which member.
    pub bit: Option<Box<BitPlace>>,
    /// Display radix.
    pub radix: Option<Name>,
    /// External access.
    pub external_access: Option<Spanned<ExternalAccess>>,
    /// For people.
    pub description: Option<Box<Text>>,
    /// Everything else.
    pub attributes: Vec<Attribute>,
    /// Comments of the source around it.
    pub trivia: Trivia,
    /// The whole declaration.
    pub span: Span,
}

/// Where a packed BOOL lives.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct BitPlace {
    /// The host member.
    pub target: Name,
    /// The bit in it, from 0.
    pub number: Spanned<u32>,
}
