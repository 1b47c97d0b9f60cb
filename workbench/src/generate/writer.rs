//! What a rung is written with: the names in reach, and the choice of places among them.

use twinrung_catalog::Element;

use super::data::{Kind, Names, Part, Place, Record, Role, Variable};
use super::random::Random;

/// A subroutine that can be called.
#[derive(Debug, Clone)]
pub struct Subroutine {
    pub name: String,
    pub receives: Vec<Kind>,
    pub returns: Vec<Kind>,
}

/// How a parameter of an Add-On Instruction passes its value.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Passing {
    Input,
    Output,
    InOut,
}

/// A parameter of an Add-On Instruction.
#[derive(Debug, Clone)]
pub struct Parameter {
    pub name: String,
    pub kind: Kind,
    pub dimensions: [u32; 3],
    pub passing: Passing,
}

/// An Add-On Instruction that can be called.
#[derive(Debug, Clone)]
pub struct AddOn {
    pub name: String,
    pub parameters: Vec<Parameter>,
}

/// What all routines share.
#[derive(Debug, Clone, Default)]
pub struct Shared {
    pub records: Vec<Record>,
    pub add_ons: Vec<AddOn>,
    pub event_tasks: Vec<String>,
    pub programs: Vec<String>,
}

/// A place with its subscripts written.
#[derive(Debug, Clone)]
pub struct Named {
    pub text: String,
    pub kind: Kind,
    pub base: String,
    /// Elements of its array from it on, as far as its constant subscripts tell.
    pub count: u32,
    /// Sizes of the array that it is, or is an element of.
    pub sizes: Vec<u32>,
}

/// Writes the rungs of one routine.
pub struct Writer<'w> {
    pub random: &'w mut Random,
    pub shared: &'w Shared,
    /// Tags of the controller; nothing within an Add-On Instruction.
    pub outer: &'w Names,
    /// Tags of the program, or parameters and local tags.
    pub own: &'w mut Names,
    /// Subroutines that may be called from here.
    pub subroutines: Vec<Subroutine>,
    /// What RET hands back here.
    pub returns: Vec<Kind>,
    pub fault_routine: Option<String>,
    pub in_add_on: bool,
    /// Labels jumped to that stand on no rung yet.
    pub pending_labels: Vec<String>,
    /// Numbers fresh names.
    pub fresh: usize,
    /// Timers of TOFs, which RES must not name.
    pub off_timers: Vec<String>,
    /// Instances of Add-On Instructions.
    pub instances: Vec<(usize, String)>,
    /// The CONTROL tag of the FAL or FSC that is being written.
    pub control: Option<String>,
}

impl Writer<'_> {
    /// Declares a tag that one instruction owns.
    pub fn declare(&mut self, prefix: &str, kind: Kind, role: Role) -> String {
        self.fresh += 1;
        let name = format!("{prefix}{}", self.fresh);
        self.own.add(Variable::new(name.clone(), kind).role(role), &self.shared.records);
        name
    }

    /// A random place that fits, subscripts written; none where nothing fits.
    pub fn place(&mut self, fits: impl Fn(&Place) -> bool) -> Option<Named> {
        let place = self.open_place(fits)?;
        Some(self.named(&place, false))
    }

    /// As `place`, with constant subscripts only.
    pub fn constant_place(&mut self, fits: impl Fn(&Place) -> bool) -> Option<Named> {
        let place = self.open_place(fits)?;
        Some(self.named(&place, true))
    }

    fn open_place(&mut self, fits: impl Fn(&Place) -> bool) -> Option<Place> {
        let all = self.outer.places.iter().chain(&self.own.places);
        let fitting: Vec<&Place> = all.filter(|place| fits(place)).collect();
        if fitting.is_empty() {
            return None;
        }
        // Whole structures hold many places; of two draws the shallower one is taken, so that plain tags are as frequent.
        let (first, second) = (*self.random.of(&fitting), *self.random.of(&fitting));
        Some(if first.parts.len() <= second.parts.len() { first.clone() } else { second.clone() })
    }

    fn named(&mut self, place: &Place, constant: bool) -> Named {
        let mut text = String::new();
        let mut count = 1;
        if place.is_array() {
            count = place.sizes().iter().product();
        }
        for (at, part) in place.parts.iter().enumerate() {
            match part {
                Part::Text(words) => text.push_str(words),
                Part::Subscripts(sizes) => {
                    let mut skipped = 0;
                    let mut written = Vec::new();
                    for (position, size) in sizes.iter().enumerate() {
                        let stride: u32 = sizes[position + 1..].iter().product();
                        if constant || self.random.percent(45) {
                            let number = self.random.below(*size as usize) as u32;
                            skipped += number * stride;
                            written.push(number.to_string());
                        } else {
                            written.push(self.subscript(*size));
                        }
                    }
                    if at + 1 == place.parts.len() {
                        count = sizes.iter().product::<u32>() - skipped;
                    }
                    text.push_str(&format!("[{}]", written.join(",")));
                }
            }
        }
        Named { text, kind: place.kind, base: place.base.clone(), count, sizes: place.sizes() }
    }

    /// A subscript that is mostly in range.
    pub fn subscript(&mut self, size: u32) -> String {
        if let Some(control) = self.control.clone()
            && self.random.percent(70)
        {
            return format!("{control}.POS");
        }
        let fitting: Vec<String> = self.indices(size);
        let one = if fitting.is_empty() { "0".to_owned() } else { self.random.of(&fitting).clone() };
        match self.random.below(12) {
            0 => {
                let power = 1 << size.ilog2();
                match self.plain_integer() {
                    Some(number) => format!("{number} AND {}", power - 1),
                    None => one,
                }
            }
            1 => match self.plain_integer() {
                Some(number) => format!("ABS({number}) MOD {size}"),
                None => one,
            },
            2 => format!("{}-{one}", size - 1),
            3 => format!("({one}*3+1) MOD {size}"),
            4 => {
                let list: Vec<(String, u32)> = self.index_arrays(size);
                match list.is_empty() {
                    true => one,
                    false => {
                        let (name, length) = self.random.of(&list).clone();
                        let inner = self.random.below(length as usize);
                        let indices = self.indices(length);
                        let inner =
                            if indices.is_empty() { inner.to_string() } else { self.random.of(&indices).clone() };
                        format!("{name}[{inner}]")
                    }
                }
            }
            _ => one,
        }
    }

    fn indices(&self, size: u32) -> Vec<String> {
        let all = self.outer.variables.iter().chain(&self.own.variables);
        all.filter(|one| one.dimensions == [0; 3])
            .filter(|one| matches!(one.role, Role::Index(bound) if bound <= size))
            .map(|one| one.name.clone())
            .collect()
    }

    fn index_arrays(&self, size: u32) -> Vec<(String, u32)> {
        let all = self.outer.variables.iter().chain(&self.own.variables);
        all.filter(|one| one.dimensions[0] > 0 && matches!(one.role, Role::Index(bound) if bound <= size))
            .map(|one| (one.name.clone(), one.dimensions[0]))
            .collect()
    }

    /// An integer tag without subscripts.
    fn plain_integer(&mut self) -> Option<String> {
        let all = self.outer.variables.iter().chain(&self.own.variables);
        let list: Vec<&Variable> = all.filter(|one| one.kind.is_integer() && one.dimensions == [0; 3]).collect();
        if list.is_empty() { None } else { Some(self.random.of(&list).name.clone()) }
    }

    /// A tag of an elementary type.
    pub fn element(&mut self, element: Element, writable: bool) -> Option<Named> {
        self.place(|place| place.kind == Kind::Element(element) && !place.is_array() && (place.writable || !writable))
    }
}
