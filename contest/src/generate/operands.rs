//! Operands after the declarations of the catalog: an instruction that it gains is generated without a line here, and a
//! kind of operand that it gains does not compile until it stands here.

use twinrung_catalog::instructions::system::{ATTRIBUTES, Attribute};
use twinrung_catalog::{Access, Element, Instruction, Opcode, OperandKind};

use super::data::{Kind, Place, Role};
use super::literals;
use super::writer::{Named, Subroutine, Writer};

/// What the operands written so far ask of those that follow.
#[derive(Default)]
struct Call {
    opcode: Option<Opcode>,
    /// The type that the next number must have (SWPB).
    element: Option<Element>,
    /// Source of a COP.
    source: Option<Named>,
    /// The greatest length of COP and FLL.
    count: u32,
    /// Sizes of the array that SIZE measures.
    sizes: Vec<u32>,
    attribute: Option<&'static Attribute>,
    subroutine: Option<Subroutine>,
    /// Whether Preset, Length and the like may be literals.
    owns_structure: bool,
}

/// How many bits a rung is likely to come back to.
const NEAR_BITS: usize = 6;

impl Writer<'_> {
    /// A call of a base instruction; none where nothing in reach fits its operands.
    pub fn call(&mut self, instruction: &'static Instruction) -> Option<String> {
        let mut call = Call { opcode: Some(instruction.opcode), count: 1, ..Call::default() };
        let mut written = Vec::new();
        for operand in instruction.operands {
            if operand.repeats {
                written.extend(self.repeated(operand.kind, &call)?);
            } else {
                written.push(self.operand(operand.kind, &mut call)?);
            }
        }
        Some(self.with_its_position(format!("{}({})", instruction.mnemonic, written.join(","))))
    }

    fn operand(&mut self, kind: OperandKind, call: &mut Call) -> Option<String> {
        match kind {
            OperandKind::Bit(access) => self.bit(access, call),
            OperandKind::Number(access) => {
                let element = call.element;
                if call.opcode == Some(Opcode::Swpb) {
                    let element = element.unwrap_or(*self.random.of(&[Element::Int, Element::Dint, Element::Real]));
                    call.element = Some(element);
                    return self.element(element, access.writes()).map(|named| named.text);
                }
                self.number(access, false)
            }
            OperandKind::Integer(access) => self.number(access, true),
            OperandKind::Structure(wanted, _) => self.structure(wanted.name, call),
            OperandKind::Resettable => {
                let off_timers = [self.off_timers.as_slice(), &self.passed_off].concat();
                let fits = |place: &Place| {
                    place.kind.is_structure()
                        && !place.is_array()
                        && place.writable
                        && !off_timers.contains(&place.base)
                };
                let named = self.place(fits)?;
                self.reset.push(named.base);
                Some(named.text)
            }
            OperandKind::Pseudo(member) => Some(match (call.owns_structure, member) {
                (true, "PRE") => self.random.of(&["?", "0", "10", "25", "40", "100", "2147483647"]).to_string(),
                (true, "LEN") => self.random.between(0, 6).to_string(),
                (true, _) => self.random.of(&["?", "0", "0", "5"]).to_string(),
                (false, _) => "?".to_owned(),
            }),
            OperandKind::CopySource => {
                let named = self.place(|place| copy_class(place).is_some())?;
                let text = named.text.clone();
                call.source = Some(named);
                Some(text)
            }
            OperandKind::CopyDestination => {
                let source = call.source.clone()?;
                let class = class_of(source.kind);
                let fits = |place: &Place| place.writable && copy_class(place) == class && place.base != source.base;
                let named = self.place(fits)?;
                call.count = source.count.min(named.count);
                Some(named.text)
            }
            OperandKind::FillDestination => {
                let named = self.place(|place| place.writable && place.kind.is_number())?;
                call.count = named.count;
                Some(named.text)
            }
            OperandKind::ConstantLength => {
                let count = call.count.max(1) as usize;
                Some(self.random.between(1, count).to_string())
            }
            OperandKind::Expression => Some(self.expression(2)),
            OperandKind::Condition => Some(self.condition(2)),
            OperandKind::FileMode => Some(self.random.of(&["ALL", "ALL", "INC", "1", "2", "3", "100"]).to_string()),
            OperandKind::ByteOrder => Some(self.random.of(&["REVERSE", "WORD", "HIGH/LOW"]).to_string()),
            OperandKind::Array => {
                let named = self.place(|place| !place.kind.is_bit() && !place.sizes().is_empty())?;
                call.sizes = named.sizes;
                Some(named.text)
            }
            OperandKind::Dimension => Some(self.random.below(call.sizes.len()).to_string()),
            OperandKind::Label => Some(self.label()),
            // Written where the rung of the label is.
            OperandKind::LabelDefinition => None,
            OperandKind::Routine => {
                if self.subroutines.is_empty() || self.in_add_on {
                    return None;
                }
                let list = self.subroutines.clone();
                let subroutine = self.random.of(&list).clone();
                call.subroutine = Some(subroutine.clone());
                Some(subroutine.name)
            }
            OperandKind::InputCount => call.subroutine.as_ref().map(|one| one.receives.len().to_string()),
            // Only a last operand is a parameter, and those repeat.
            OperandKind::Parameter(_) => None,
            OperandKind::EventTask => {
                let tasks = &self.shared.event_tasks;
                if tasks.is_empty() { None } else { Some(self.random.of(tasks).clone()) }
            }
            OperandKind::SystemClass => {
                let writes = call.opcode == Some(Opcode::Ssv);
                let list: Vec<&'static Attribute> = ATTRIBUTES
                    .iter()
                    .filter(|one| one.writable || !writes)
                    .filter(|one| !(self.in_add_on && one.class == "ROUTINE"))
                    .collect();
                let attribute = *self.random.of(&list);
                call.attribute = Some(attribute);
                Some(attribute.class.to_owned())
            }
            OperandKind::SystemInstance => {
                let attribute = call.attribute?;
                Some(match attribute.class {
                    _ if !attribute.has_instance => String::new(),
                    "PROGRAM" if self.in_add_on || self.random.percent(30) => {
                        let programs = &self.shared.programs;
                        self.random.of(programs).clone()
                    }
                    "TASK" if self.random.percent(50) => "Safety_Task".to_owned(),
                    "ROUTINE" if self.random.percent(50) => "Main".to_owned(),
                    _ => "THIS".to_owned(),
                })
            }
            OperandKind::SystemAttribute => call.attribute.map(|one| one.name.to_owned()),
            OperandKind::SystemData(access) => {
                let attribute = call.attribute?;
                let needed = attribute.element.bytes() * attribute.length;
                let fits = |place: &Place| {
                    let elements = place.sizes().iter().product::<u32>().max(1);
                    let bytes = system_bytes(place.kind).map_or(0, |bytes| bytes * elements);
                    (place.writable || !access.writes()) && bytes >= needed
                };
                let named = (0..8).find_map(|_| {
                    let named = self.place(fits)?;
                    let bytes = system_bytes(named.kind).unwrap_or_default() * named.count;
                    (bytes >= needed).then_some(named)
                })?;
                Some(named.text)
            }
            // Operands of safety application instructions: `guards` writes their calls.
            OperandKind::Choice(_)
            | OperandKind::Literal { .. }
            | OperandKind::SafetyBit { .. }
            | OperandKind::SafetyInteger { .. }
            | OperandKind::SafetyReal { .. } => None,
        }
    }

    fn bit(&mut self, access: Access, call: &mut Call) -> Option<String> {
        let one_shot = matches!(call.opcode, Some(Opcode::Ons | Opcode::Osr | Opcode::Osf));
        if one_shot && access == Access::ReadWrite && self.random.percent(80) {
            let kind = Kind::Element(Element::Bool);
            return Some(self.declare("Storage", kind, Role::Owned));
        }
        if access == Access::Read && self.random.percent(10) {
            return Some(self.random.of(&["S:V", "S:Z", "S:N", "S:C", "S:FS", "S:MINOR"]).to_string());
        }
        let writes = access.writes();
        // What a rung asks it often switches as well, as a circuit that seals itself in does.
        if !self.near_bits.is_empty() && self.random.percent(20) {
            return Some(self.random.of(&self.near_bits.clone()).clone());
        }
        let writable = writes || self.random.percent(40);
        let word = if self.random.percent(20) { self.bit_of_word(writable, "") } else { None };
        let bit = match word {
            Some(bit) => bit,
            None => self.element(Element::Bool, writable)?.text,
        };
        if writable {
            self.near_bits.truncate(NEAR_BITS - 1);
            self.near_bits.insert(0, bit.clone());
        }
        Some(bit)
    }

    /// A bit of an integer, by number or by a tag, that does not lie in a tag.
    pub fn bit_of_word(&mut self, writes: bool, but: &str) -> Option<String> {
        let kind = Kind::Element(*self.random.of(&[Element::Sint, Element::Int, Element::Dint]));
        let fits = |place: &Place| place.kind == kind && !place.is_array() && (place.writable || !writes);
        let word = self.place(|place| fits(place) && place.base != but)?;
        let bits = match word.kind {
            Kind::Element(element) => u32::from(element.bits()),
            _ => 8,
        };
        Some(if self.random.percent(60) {
            format!("{}.{}", word.text, self.random.below(bits as usize))
        } else {
            format!("{}.[{}]", word.text, self.subscript(bits))
        })
    }

    /// A number of any type, or an integer.
    pub fn number(&mut self, access: Access, integer: bool) -> Option<String> {
        if access == Access::Read && self.random.percent(30) {
            return Some(if !integer && self.random.percent(20) {
                literals::real_text(self.random)
            } else {
                literals::integer_text(self.random)
            });
        }
        let writes = access.writes();
        let fits = |place: &Place| {
            let kind = if integer { place.kind.is_integer() } else { place.kind.is_number() };
            kind && !place.is_array() && (place.writable || !writes)
        };
        self.place(fits).map(|named| named.text)
    }

    fn structure(&mut self, wanted: &str, call: &mut Call) -> Option<String> {
        let kind = match wanted {
            "TIMER" => Kind::Timer,
            "COUNTER" => Kind::Counter,
            _ => Kind::Control,
        };
        let is_off_timer = call.opcode == Some(Opcode::Tof);
        let reset = self.reset.clone();
        let text = if is_off_timer && !self.off_timers.is_empty() && self.random.percent(20) {
            self.random.of(&self.off_timers.clone()).clone()
        } else if is_off_timer
            && self.random.percent(30)
            && let Some(named) = self.wished_place(|place| {
                // In an Add-On Instruction any timer that it is given; in a program those that RES leaves alone.
                let passed = place.base.starts_with(super::program::IN_OUT) && !reset.contains(&place.base);
                place.kind == kind && !place.is_array() && (place.base.starts_with("Off_") || passed)
            })
        {
            self.passed_off.push(named.base);
            named.text
        } else if !is_off_timer
            && self.random.percent(30)
            && let Some(named) = self.place(|place| place.kind == kind && !place.is_array() && place.writable)
        {
            named.text
        } else {
            call.owns_structure = true;
            let name = self.declare(wanted.get(..1).unwrap_or("T"), kind, Role::Owned);
            if is_off_timer {
                self.off_timers.push(name.clone());
            }
            self.owned.push((kind, name.clone()));
            name
        };
        if kind == Kind::Control {
            self.control = Some(text.clone());
        }
        Some(text)
    }

    /// Parameters of JSR and RET.
    fn repeated(&mut self, _kind: OperandKind, call: &Call) -> Option<Vec<String>> {
        match (call.opcode, &call.subroutine) {
            (Some(Opcode::Jsr), Some(subroutine)) => {
                let mut list: Vec<String> = Vec::new();
                for kind in &subroutine.receives {
                    list.push(self.passed(*kind, false)?);
                }
                for kind in &subroutine.returns {
                    list.push(self.passed(*kind, true)?);
                }
                Some(list)
            }
            (Some(Opcode::Ret), _) => self.returns.clone().into_iter().map(|kind| self.passed(kind, false)).collect(),
            _ => None,
        }
    }

    /// An operand that is passed by value, without conversion.
    pub fn passed(&mut self, kind: Kind, writes: bool) -> Option<String> {
        if !writes && self.random.percent(25) {
            match kind {
                Kind::Element(Element::Dint) => return Some(literals::integer_text(self.random)),
                Kind::Element(Element::Real) => return Some(literals::real_text(self.random)),
                _ => {}
            }
        }
        self.place(|place| place.kind == kind && !place.is_array() && (place.writable || !writes))
            .map(|named| named.text)
    }
}

/// Bytes of one element, where GSV and SSV take such data.
fn system_bytes(kind: Kind) -> Option<u32> {
    match kind {
        Kind::Element(Element::Sint | Element::Int | Element::Dint) | Kind::Timer | Kind::Counter | Kind::Control => {
            class_of(kind)
        }
        Kind::Record(super::TWELVE) => class_of(kind),
        // At least: two bytes of a packed part and its array.
        Kind::Record(1) => Some(12),
        Kind::Record(2) => Some(144),
        _ => None,
    }
}

/// Places of one class have elements of one size.
fn copy_class(place: &Place) -> Option<u32> {
    class_of(place.kind)
}

fn class_of(kind: Kind) -> Option<u32> {
    match kind {
        Kind::Element(Element::Bool) | Kind::Instance(_) | Kind::Backing(_) => None,
        Kind::Element(element) => Some(element.bytes()),
        Kind::Timer | Kind::Counter | Kind::Control => Some(12),
        Kind::Record(super::TWELVE) => Some(12),
        Kind::Record(index) => Some(1000 + index as u32),
    }
}
