//! What a rung is written with: the names in reach, and the choice of places among them.

use twinrung_catalog::Element;

use super::Actor;
use super::data::{Kind, Names, Part, Place, Record, Role, Variable};
use super::palette::Palette;
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
    /// Whether safety instructions are called in it, or in what it calls: an instance then serves one call.
    pub guards: bool,
}

/// What all routines share.
#[derive(Debug, Clone, Default)]
pub struct Shared {
    pub records: Vec<Record>,
    pub add_ons: Vec<AddOn>,
    pub event_tasks: Vec<String>,
    pub programs: Vec<String>,
    pub palette: Palette,
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

/// How subscripts are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Subscripts {
    Any,
    Numbers,
    Tags,
    Expressions,
}

/// A way to reach data.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Wish {
    Tag,
    Member,
    Element,
    ElementByTag,
    ElementByExpression,
    Alias,
    InOut,
}

impl Wish {
    const ALL: &[Wish] = &[
        Wish::Tag,
        Wish::Member,
        Wish::Element,
        Wish::ElementByTag,
        Wish::ElementByExpression,
        Wish::Alias,
        Wish::InOut,
        Wish::InOut,
    ];

    fn is_met(self, place: &Place) -> bool {
        let Some(Part::Text(first)) = place.parts.first() else { return false };
        match self {
            Wish::Tag => place.parts.len() == 1 && *first == place.base,
            Wish::Member => place.parts.iter().any(|part| matches!(part, Part::Text(text) if text.starts_with('.'))),
            Wish::Element | Wish::ElementByTag | Wish::ElementByExpression => {
                place.parts.iter().any(|part| matches!(part, Part::Subscripts(_)))
            }
            Wish::Alias => *first != place.base,
            Wish::InOut => first.starts_with(super::program::IN_OUT),
        }
    }
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
    /// Bits that may be written and were named last.
    pub near_bits: Vec<String>,
    /// Structures that an instruction has for itself.
    pub owned: Vec<(Kind, String)>,
    /// Timers of TOFs, which RES must not name.
    pub off_timers: Vec<String>,
    /// Passed timers that TOF has, and structures that RES resets: the two keep apart.
    pub passed_off: Vec<String>,
    pub reset: Vec<String>,
    /// Instances of Add-On Instructions.
    pub instances: Vec<(usize, String)>,
    /// What stands before a name of `own` for somebody outside; nothing where its tags cannot be driven.
    pub scope: Option<String>,
    /// InOut parameters that back a call already.
    pub passed_backings: Vec<String>,
    /// Calls whose operands the stimulus moves together.
    pub actors: Vec<Actor>,
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
        if self.random.percent(12) {
            return self.wished_place(fits);
        }
        let place = self.open_place(fits)?;
        Some(self.named(&place, Subscripts::Any))
    }

    /// As `place`, with constant subscripts only.
    pub fn constant_place(&mut self, fits: impl Fn(&Place) -> bool) -> Option<Named> {
        let place = self.open_place(fits)?;
        Some(self.named(&place, Subscripts::Numbers))
    }

    /// As `place`, reached in a way that is drawn first: the rare ways then come as often as the frequent ones.
    pub fn wished_place(&mut self, fits: impl Fn(&Place) -> bool) -> Option<Named> {
        let wish = *self.random.of(Wish::ALL);
        let place = self.open_place(|place| fits(place) && wish.is_met(place)).or_else(|| self.open_place(fits))?;
        let subscripts = match wish {
            Wish::Element => Subscripts::Numbers,
            Wish::ElementByTag => Subscripts::Tags,
            Wish::ElementByExpression => Subscripts::Expressions,
            _ => Subscripts::Any,
        };
        Some(self.named(&place, subscripts))
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

    fn named(&mut self, place: &Place, subscripts: Subscripts) -> Named {
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
                        let number = match subscripts {
                            Subscripts::Any => self.random.percent(45),
                            Subscripts::Numbers => true,
                            Subscripts::Tags | Subscripts::Expressions => false,
                        };
                        if number {
                            let number = self.random.below(*size as usize) as u32;
                            skipped += number * stride;
                            written.push(number.to_string());
                        } else {
                            written.push(match subscripts {
                                Subscripts::Tags => self.index(*size),
                                Subscripts::Expressions => format!("{}-{}", size - 1, self.index(*size)),
                                Subscripts::Any | Subscripts::Numbers => self.subscript(*size),
                            });
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
        let one = self.index(size);
        // In range whatever the numbers are.
        let mask = (1 << size.ilog2()) - 1;
        match self.random.below(13) {
            0 => match self.plain_integer() {
                Some(number) => format!("{number} AND {mask}"),
                None => one,
            },
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
            5 => match (self.plain_integer(), self.plain_integer()) {
                (Some(left), Some(right)) => {
                    let sum = format!("({left}{}{right})", *self.random.of(&['+', '-', '*']));
                    if self.random.percent(50) { format!("{sum} AND {mask}") } else { format!("{mask} AND {sum}") }
                }
                _ => one,
            },
            _ => one,
        }
    }

    /// A tag that is mostly in range; 0 where there is none.
    fn index(&mut self, size: u32) -> String {
        let fitting = self.indices(size);
        if fitting.is_empty() { "0".to_owned() } else { self.random.of(&fitting).clone() }
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
