//! References to data: the path that the text writes, and where it leads.

use twinrung_bytecode::image::TypeReference;
use twinrung_bytecode::layout::elements;
use twinrung_catalog::Element;

use super::Expression;
use crate::project::{AddOnId, ProgramId, TagId};

/// Where names are looked up.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum Scope {
    /// Declarations of the controller.
    Controller,
    /// Routines of a safety program: its tags hide those of the controller.
    Program(ProgramId),
    /// Routines of an Add-On Instruction: parameters and local tags only.
    AddOn(AddOnId),
}

/// A reference to data.
#[derive(Debug, Clone, PartialEq)]
pub struct Reference {
    /// Where the path begins.
    pub root: Root,
    /// The steps from there.
    pub steps: Vec<Step>,
    /// The type at the end; of one element for an array.
    pub type_reference: TypeReference,
    /// Dimensions at the end, when a whole array is meant; 0 = unused.
    pub dimensions: [u32; 3],
    /// Where the data lies, in cells. For the lowering; an evaluator that walks trees has no need of it.
    pub location: Location,
}

/// Where a path begins.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Root {
    /// A tag; an alias goes on at its target.
    Tag(TagId),
    /// A member of the instance type of the Add-On Instruction whose routine this is.
    Member(AddOnId, u16),
    /// An InOut parameter, by position among all parameters, of the Add-On Instruction whose routine this is.
    InOut(AddOnId, u16),
}

/// One step of a path.
#[derive(Debug, Clone, PartialEq)]
pub enum Step {
    /// Into the member at this position of the structure.
    Member(u16),
    /// To an element.
    Subscript(Vec<Subscript>),
    /// To a bit of an integer.
    Bit(u8),
    /// To the bit of an integer that an expression numbers.
    BitExpression(Box<Expression>),
}

/// One subscript.
#[derive(Debug, Clone, PartialEq)]
pub enum Subscript {
    /// A number, within the array.
    Constant(u32),
    /// A tag or an expression over integers.
    Expression(Box<Expression>),
}

/// What a reference reaches.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Shape {
    /// One BOOL.
    Bit,
    /// One SINT, INT, DINT or REAL.
    Word,
    /// One bit of an integer.
    WordBit,
    /// A structure or a whole array.
    Region,
}

/// What cells count from.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum LocationBase {
    /// The first cells of a tag that is no alias.
    Tag(TagId),
    /// The instance of the Add-On Instruction whose routine this is.
    Instance,
    /// The argument of the InOut parameter at this position.
    InOut(u16),
}

/// A variable subscript, in the order of the path's.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Term {
    /// The value must be below this.
    pub length: u32,
    /// Bit cells from one element to the next.
    pub bit_stride: u32,
    /// Word cells from one element to the next.
    pub word_stride: u32,
}

/// Which bit of an integer.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum BitPlace {
    /// By number.
    Constant(u8),
    /// By the expression of the path's last step.
    Expression,
}

/// Where data lies.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Location {
    /// What the cells count from.
    pub base: LocationBase,
    /// Bit cell without variable subscripts.
    pub bit_cell: u32,
    /// Word cell without variable subscripts.
    pub word_cell: u32,
    /// Elements from here to the end of the innermost array.
    pub count: u32,
    /// Variable subscripts.
    pub terms: Vec<Term>,
    /// Which bit, for a bit of an integer.
    pub bit: Option<BitPlace>,
}

impl Reference {
    /// Whether it reaches the data that another reaches, whatever variable subscripts come to.
    pub fn is_same_data(&self, other: &Reference) -> bool {
        self.location == other.location && self.variable_subscripts().eq(other.variable_subscripts())
    }

    /// Subscripts and numbers of bits that are no constants, in order.
    fn variable_subscripts(&self) -> impl Iterator<Item = &Expression> {
        self.steps.iter().flat_map(|step| match step {
            Step::Subscript(subscripts) => subscripts
                .iter()
                .filter_map(|subscript| match subscript {
                    Subscript::Expression(expression) => Some(&**expression),
                    Subscript::Constant(_) => None,
                })
                .collect(),
            Step::BitExpression(expression) => vec![&**expression],
            Step::Member(_) | Step::Bit(_) => Vec::new(),
        })
    }

    /// What it reaches.
    pub fn shape(&self) -> Shape {
        if self.location.bit.is_some() {
            return Shape::WordBit;
        }
        match self.type_reference {
            _ if self.dimensions != [0; 3] => Shape::Region,
            TypeReference::Element(Element::Bool) => Shape::Bit,
            TypeReference::Element(_) => Shape::Word,
            TypeReference::Structure(_) => Shape::Region,
        }
    }

    /// The elementary type, when it reaches a single BOOL, number or bit of one.
    pub fn element(&self) -> Option<Element> {
        match (self.shape(), self.type_reference) {
            (Shape::Region, _) => None,
            (_, TypeReference::Element(element)) => Some(element),
            (_, TypeReference::Structure(_)) => None,
        }
    }

    /// The tag whose cells it reaches; nothing within an Add-On Instruction.
    pub fn base_tag(&self) -> Option<TagId> {
        match self.location.base {
            LocationBase::Tag(tag) => Some(tag),
            LocationBase::Instance | LocationBase::InOut(_) => None,
        }
    }

    /// Whether every subscript and bit number is a constant.
    pub fn is_constant(&self) -> bool {
        self.location.terms.is_empty() && self.location.bit != Some(BitPlace::Expression)
    }
}

/// How far a path has led.
#[derive(Debug, Clone)]
pub(crate) struct Walk {
    pub type_reference: TypeReference,
    pub dimensions: [u32; 3],
    pub location: Location,
}

impl Walk {
    /// The beginning of a tag, member or parameter.
    pub fn begin(base: LocationBase, type_reference: TypeReference, dimensions: [u32; 3]) -> Walk {
        let count = elements(dimensions).unwrap_or(1);
        let location = Location { base, bit_cell: 0, word_cell: 0, count, terms: Vec::new(), bit: None };
        Walk { type_reference, dimensions, location }
    }
}
