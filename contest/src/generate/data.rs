//! Tags, and the places within them that an operand can name.

use twinrung_catalog::{Element, MemberRole, PredefinedType};

/// A type.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    Element(Element),
    Timer,
    Counter,
    Control,
    /// A data type of the program, by position.
    Record(usize),
    /// An instance of an Add-On Instruction, by position.
    Instance(usize),
    /// The backing tag of a safety application instruction.
    Backing(&'static PredefinedType),
}

impl Kind {
    pub fn is_number(self) -> bool {
        matches!(self, Kind::Element(element) if element != Element::Bool)
    }

    pub fn is_integer(self) -> bool {
        matches!(self, Kind::Element(Element::Sint | Element::Int | Element::Dint))
    }

    pub fn is_bit(self) -> bool {
        self == Kind::Element(Element::Bool)
    }

    pub fn is_structure(self) -> bool {
        matches!(self, Kind::Timer | Kind::Counter | Kind::Control)
    }
}

/// What the generator does with a tag.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Role {
    /// Read and written by anything.
    Data,
    /// Read by anything, written by the stimulus alone, mostly below the bound.
    Index(u32),
    /// Read by anything, written by the one instruction that owns it.
    Owned,
}

/// A tag, parameter or local tag.
#[derive(Debug, Clone)]
pub struct Variable {
    pub name: String,
    pub kind: Kind,
    pub dimensions: [u32; 3],
    pub role: Role,
    pub initial: Option<String>,
    /// What it is an alias of.
    pub alias: Option<String>,
}

impl Variable {
    pub fn new(name: impl Into<String>, kind: Kind) -> Variable {
        Variable { name: name.into(), kind, dimensions: [0; 3], role: Role::Data, initial: None, alias: None }
    }

    pub fn array(self, dimensions: [u32; 3]) -> Variable {
        Variable { dimensions, ..self }
    }

    pub fn role(self, role: Role) -> Variable {
        Variable { role, ..self }
    }

    pub fn initial(self, initial: impl Into<String>) -> Variable {
        Variable { initial: Some(initial.into()), ..self }
    }
}

/// A member of a data type of the program.
#[derive(Debug, Clone)]
pub struct Member {
    pub name: String,
    pub kind: Kind,
    pub length: u32,
}

/// A data type of the program.
#[derive(Debug, Clone)]
pub struct Record {
    pub name: String,
    pub members: Vec<Member>,
}

/// Part of the text of a place.
#[derive(Debug, Clone)]
pub enum Part {
    Text(String),
    /// Subscripts for these sizes.
    Subscripts(Vec<u32>),
}

/// Something that an operand can name, its subscripts open.
#[derive(Debug, Clone)]
pub struct Place {
    pub parts: Vec<Part>,
    pub kind: Kind,
    /// Not zero: a whole array.
    pub dimensions: [u32; 3],
    pub writable: bool,
    /// The tag it lies in.
    pub base: String,
}

impl Place {
    pub fn is_array(&self) -> bool {
        self.dimensions != [0; 3]
    }

    /// Sizes of the innermost array that it is, or is an element of.
    pub fn sizes(&self) -> Vec<u32> {
        if self.is_array() {
            return self.dimensions.iter().copied().take_while(|size| *size > 0).collect();
        }
        match self.parts.last() {
            Some(Part::Subscripts(sizes)) => sizes.clone(),
            _ => Vec::new(),
        }
    }
}

/// Tags of one scope with their places.
#[derive(Debug, Clone, Default)]
pub struct Names {
    pub variables: Vec<Variable>,
    pub places: Vec<Place>,
}

impl Names {
    pub fn add(&mut self, variable: Variable, records: &[Record]) {
        let base = match &variable.alias {
            Some(target) => target.split(['.', '[']).next().unwrap_or(target).to_owned(),
            None => variable.name.clone(),
        };
        let root = Place {
            parts: vec![Part::Text(variable.name.clone())],
            kind: variable.kind,
            dimensions: variable.dimensions,
            writable: variable.role == Role::Data,
            base,
        };
        expand(root, records, &mut self.places);
        self.variables.push(variable);
    }
}

fn expand(place: Place, records: &[Record], list: &mut Vec<Place>) {
    if place.is_array() {
        let mut element = place.clone();
        element.parts.push(Part::Subscripts(place.sizes()));
        element.dimensions = [0; 3];
        list.push(place);
        expand(element, records, list);
        return;
    }
    let member = |name: &str, kind: Kind, length: u32, writable: bool| {
        let mut one = place.clone();
        one.parts.push(Part::Text(format!(".{name}")));
        one.kind = kind;
        one.dimensions = [length, 0, 0];
        one.writable = place.writable && writable;
        one
    };
    let predefined: (&[&str], &[&str]) = match place.kind {
        Kind::Timer => (&["PRE", "ACC"], &["EN", "TT", "DN"]),
        Kind::Counter => (&["PRE", "ACC"], &["CU", "CD", "DN", "OV", "UN"]),
        Kind::Control => (&["LEN", "POS"], &["EN", "EU", "DN", "EM", "ER", "UL", "IN", "FD"]),
        _ => (&[], &[]),
    };
    for name in predefined.0 {
        // Random values there would make nearly every execution a fault; rungs of their own write them.
        list.push(member(name, Kind::Element(Element::Dint), 0, false));
    }
    for name in predefined.1 {
        list.push(member(name, Kind::Element(Element::Bool), 0, true));
    }
    if let Kind::Backing(backing) = place.kind {
        for one in backing.members.iter().filter(|one| one.length == 0 && one.role != MemberRole::Internal) {
            list.push(member(one.name, Kind::Element(one.element), 0, false));
        }
    }
    if let Kind::Record(index) = place.kind {
        for one in &records[index].members {
            expand(member(&one.name, one.kind, one.length, true), records, list);
        }
    }
    list.push(place);
}
