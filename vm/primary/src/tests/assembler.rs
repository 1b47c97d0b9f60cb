//! Puts images together from declarations and neutral text, as far as these tests need it: one-dimensional arrays,
//! members, constant and tag subscripts, bits, infix expressions.

use alloc::collections::BTreeMap;
use alloc::string::{String, ToString};
use alloc::vec;
use alloc::vec::Vec;

use twinrung_bytecode::format;
use twinrung_bytecode::image::*;
use twinrung_bytecode::index::*;
use twinrung_bytecode::layout::{self, TypeLayout};
use twinrung_bytecode::operand::*;
use twinrung_catalog::operand::OperandKind;
use twinrung_catalog::{Element, Instruction, PredefinedType};

use crate::{LoadError, Primary};

/// An image under construction.
pub(crate) struct Assembler {
    pub(crate) image: Image,
    layouts: Vec<TypeLayout>,
    operands: BTreeMap<Vec<u8>, u32>,
    tags: BTreeMap<String, u32>,
    bits: u32,
    words: u32,
    /// The Add-On Instruction whose routine is being written.
    inside: Option<u16>,
}

fn fold(name: &str) -> String {
    name.to_ascii_lowercase()
}

/// Splits at commas outside of brackets.
fn split(text: &str) -> Vec<&str> {
    let (mut depth, mut begin, mut parts) = (0i32, 0usize, Vec::new());
    for (at, character) in text.char_indices() {
        match character {
            '(' | '[' => depth += 1,
            ')' | ']' => depth -= 1,
            ',' if depth == 0 => {
                parts.push(&text[begin..at]);
                begin = at + 1;
            }
            _ => {}
        }
    }
    if !text.is_empty() {
        parts.push(&text[begin..]);
    }
    parts
}

impl Assembler {
    pub(crate) fn new() -> Self {
        let mut image = Image::default();
        image.operands.offsets.push(0);
        let program = ProgramRecord { name: "P".to_string(), main: None, fault: None, disabled: false };
        image.programs.push(program);
        image.task = Some(TaskRecord {
            name: "T".to_string(),
            period_us: 10_000,
            watchdog_us: 10_000,
            priority: 1,
            schedule: vec![ProgramIndex(0)],
        });
        Assembler {
            image,
            layouts: Vec::new(),
            operands: BTreeMap::new(),
            tags: BTreeMap::new(),
            bits: 0,
            words: 0,
            inside: None,
        }
    }

    fn type_index(&mut self, name: &str) -> TypeIndex {
        if let Some(known) = self.image.types.iter().position(|known| known.name.eq_ignore_ascii_case(name)) {
            return TypeIndex(known as u16);
        }
        let known = PredefinedType::by_name(name).expect("a predefined type");
        let members = known
            .members
            .iter()
            .map(|member| MemberRecord {
                name: member.name.to_string(),
                type_reference: TypeReference::Element(member.element),
                dimensions: [member.length, 0, 0],
            })
            .collect();
        self.add_type(TypeRecord { name: known.name.to_string(), kind: TypeKind::Predefined, members })
    }

    pub(crate) fn add_type(&mut self, record: TypeRecord) -> TypeIndex {
        self.image.types.push(record);
        self.layouts = layout::layouts(&self.image.types).expect("a layout");
        TypeIndex((self.image.types.len() - 1) as u16)
    }

    pub(crate) fn type_reference(&mut self, name: &str) -> TypeReference {
        match Element::by_name(name) {
            Some(element) => TypeReference::Element(element),
            None => TypeReference::Structure(self.type_index(name)),
        }
    }

    /// Declares a tag: `name`, and its type, `DINT` or `DINT[10]`.
    pub(crate) fn tag(&mut self, name: &str, declared: &str) {
        let (base, dimension) = match declared.split_once('[') {
            Some((base, rest)) => (base, rest.trim_end_matches(']').parse().expect("a dimension")),
            None => (declared, 0u32),
        };
        let type_reference = self.type_reference(base);
        let (bits, words) = layout::cells(&self.layouts, type_reference).expect("cells");
        let count = dimension.max(1);
        self.tags.insert(fold(name), self.image.tags.len() as u32);
        self.image.tags.push(TagRecord {
            name: name.to_string(),
            program: None,
            type_reference,
            dimensions: [dimension, 0, 0],
            kind: TagKind::Base,
            constant: false,
            bit_cell: self.bits,
            word_cell: self.words,
            attributes: Vec::new(),
        });
        self.bits += bits * count;
        self.words += words * count;
        self.image.initial_bits.resize(self.bits as usize, 0);
        self.image.initial_words.resize(self.words as usize, 0);
    }

    /// Declares tags: `"a b BOOL; n DINT[4]"`.
    pub(crate) fn tags(&mut self, text: &str) {
        for declaration in text.split(';') {
            let words: Vec<&str> = declaration.split_whitespace().collect();
            let Some((declared, names)) = words.split_last() else { continue };
            for name in names {
                self.tag(name, declared);
            }
        }
    }

    /// A program's routine out of rungs in neutral text; routines must be added callee first.
    pub(crate) fn routine(&mut self, name: &str, rungs: &[&str]) -> RoutineIndex {
        self.owned_routine(Owner::Program(ProgramIndex(0)), name, rungs)
    }

    fn owned_routine(&mut self, owner: Owner, name: &str, rungs: &[&str]) -> RoutineIndex {
        let mut code = Vec::new();
        for rung in rungs {
            code.push(format::RUNG);
            self.series(rung.trim().trim_end_matches(';'), &mut code);
            code.push(format::END_RUNG);
        }
        self.image.routines.push(RoutineRecord { owner, name: name.to_string(), code, text: String::new() });
        RoutineIndex((self.image.routines.len() - 1) as u32)
    }

    pub(crate) fn main(&mut self, rungs: &[&str]) {
        self.image.programs[0].main = Some(self.routine("Main", rungs));
    }

    pub(crate) fn fault(&mut self, rungs: &[&str]) {
        self.image.programs[0].fault = Some(self.routine("Fault", rungs));
    }

    /// An Add-On Instruction: parameters as `(name, type, usage)`, local tags as `(name, type)`, and its routines.
    pub(crate) fn add_on(
        &mut self,
        name: &str,
        parameters: &[(&str, &str, Usage)],
        locals: &[(&str, &str)],
        routines: [&[&str]; 3],
    ) {
        let index = AddOnIndex(self.image.add_ons.len() as u16);
        let mut members = Vec::new();
        let mut records = Vec::new();
        let enables = [("EnableIn", "BOOL", Usage::Input), ("EnableOut", "BOOL", Usage::Output)];
        for (position, (name, declared, usage)) in enables.iter().chain(parameters).enumerate() {
            let type_reference = self.type_reference(declared);
            let member = (*usage != Usage::InOut).then_some(members.len() as u16);
            if member.is_some() {
                members.push(MemberRecord { name: name.to_string(), type_reference, dimensions: [0; 3] });
            }
            records.push(ParameterRecord {
                name: name.to_string(),
                usage: *usage,
                type_reference,
                dimensions: [0; 3],
                argument: position >= 2,
                member,
            });
        }
        for (name, declared) in locals {
            let type_reference = self.type_reference(declared);
            members.push(MemberRecord { name: name.to_string(), type_reference, dimensions: [0; 3] });
        }
        let instance_type = self.add_type(TypeRecord { name: name.to_string(), kind: TypeKind::AddOn(index), members });
        self.image.add_ons.push(AddOnRecord {
            name: name.to_string(),
            instance_type,
            parameters: records,
            logic: RoutineIndex(0),
            prescan: None,
            enable_in_false: None,
            attributes: Vec::new(),
        });
        self.inside = Some(index.0);
        let [logic, prescan, enable_in_false] = routines;
        let owner = Owner::AddOn(index);
        let logic = self.owned_routine(owner, "Logic", logic);
        let mut optional =
            |name: &str, rungs: &[&str]| (!rungs.is_empty()).then(|| self.owned_routine(owner, name, rungs));
        let prescan = optional("Prescan", prescan);
        let enable_in_false = optional("EnableInFalse", enable_in_false);
        self.inside = None;
        let record = self.image.add_ons.last_mut().expect("an add-on");
        record.logic = logic;
        record.prescan = prescan;
        record.enable_in_false = enable_in_false;
    }

    fn series(&mut self, text: &str, code: &mut Vec<u8>) {
        let mut rest = text.trim();
        while !rest.is_empty() {
            if rest.starts_with('[') {
                let end = matching(rest);
                code.push(format::BRANCH);
                for (leg, text) in split(&rest[1..end]).into_iter().enumerate() {
                    if leg > 0 {
                        code.push(format::NEXT_LEG);
                    }
                    self.series(text, code);
                }
                code.push(format::END_BRANCH);
                rest = rest[end + 1..].trim_start();
                continue;
            }
            let open = rest.find('(').expect("an instruction");
            let end = open + matching(&rest[open..]);
            self.element(rest[..open].trim(), &rest[open + 1..end], code);
            rest = rest[end + 1..].trim_start();
        }
    }

    fn element(&mut self, mnemonic: &str, operands: &str, code: &mut Vec<u8>) {
        let operands: Vec<&str> = split(operands).into_iter().map(str::trim).collect();
        let indices: Vec<u32> = match Instruction::by_mnemonic(mnemonic) {
            Some(instruction) => {
                code.push(instruction.opcode as u8);
                operands
                    .iter()
                    .enumerate()
                    .map(|(position, text)| self.operand(text, instruction.operand(position).expect("an operand").kind))
                    .collect()
            }
            None => {
                code.push(format::ADD_ON);
                operands.iter().map(|text| self.operand(text, OperandKind::Array)).collect()
            }
        };
        code.push(indices.len() as u8);
        for index in indices {
            code.extend_from_slice(&index.to_le_bytes());
        }
    }

    fn intern(&mut self, record: &OperandRecord) -> u32 {
        let mut bytes = Vec::new();
        record.encode(&mut bytes);
        if let Some(known) = self.operands.get(&bytes) {
            return *known;
        }
        let index = (self.image.operands.offsets.len() - 1) as u32;
        self.image.operands.bytes.extend_from_slice(&bytes);
        self.image.operands.offsets.push(self.image.operands.bytes.len() as u32);
        self.operands.insert(bytes, index);
        index
    }

    fn operand(&mut self, text: &str, kind: OperandKind) -> u32 {
        let record = match kind {
            OperandKind::Label | OperandKind::LabelDefinition => OperandRecord::Text(text.to_string()),
            OperandKind::SystemClass | OperandKind::SystemInstance => OperandRecord::Text(text.to_string()),
            OperandKind::SystemAttribute => {
                OperandRecord::SystemValue(SystemValueIndex(text.parse().expect("an index")))
            }
            OperandKind::EventTask => OperandRecord::EventTask(EventTaskIndex(text.parse().expect("an index"))),
            OperandKind::Routine => {
                let routine = self.image.routines.iter().position(|routine| routine.name == text).expect("a routine");
                OperandRecord::Routine(RoutineIndex(routine as u32))
            }
            OperandKind::FileMode => OperandRecord::Choice(match text {
                "ALL" => 0,
                "INC" => -1,
                number => number.parse().expect("a mode"),
            }),
            OperandKind::ByteOrder => OperandRecord::Choice(match text {
                "REVERSE" => 0,
                "WORD" => 1,
                _ => 2,
            }),
            OperandKind::Choice(list) => OperandRecord::Choice(list.value(text).expect("a word")),
            OperandKind::Expression | OperandKind::Condition => {
                let operations = self.expression(text);
                OperandRecord::Expression(operations)
            }
            _ => return self.value(text),
        };
        self.intern(&record)
    }

    fn value(&mut self, text: &str) -> u32 {
        let record = if text == "?" {
            OperandRecord::Unassigned
        } else if let Some(keyword) = format::STATUS_KEYWORDS.iter().position(|keyword| *keyword == text) {
            OperandRecord::Status(keyword as u8)
        } else if let Ok(value) = text.parse::<i32>() {
            OperandRecord::Integer { radix: 10, value }
        } else if text.starts_with(|first: char| first.is_ascii_digit() || first == '-') {
            OperandRecord::Real(text.parse::<f32>().expect("a number").to_bits())
        } else {
            self.reference(text)
        };
        self.intern(&record)
    }

    fn expression(&mut self, text: &str) -> Vec<Operation> {
        let mut tokens: Vec<String> = Vec::new();
        let mut word = String::new();
        let mut depth = 0;
        for character in text.chars() {
            match character {
                '[' => depth += 1,
                ']' => depth -= 1,
                _ => {}
            }
            if depth == 0 && "()+-*/<>= ".contains(character) {
                if !word.is_empty() {
                    tokens.push(core::mem::take(&mut word));
                }
                if character != ' ' {
                    tokens.push(character.to_string());
                }
            } else {
                word.push(character);
            }
        }
        if !word.is_empty() {
            tokens.push(word);
        }
        let (mut out, mut stack, mut operand_before) = (Vec::new(), Vec::<(u8, u8)>::new(), false);
        let mut index = 0;
        while index < tokens.len() {
            let pair = tokens.get(index + 1).map(String::as_str);
            let (level, operator) = match (tokens[index].to_ascii_uppercase().as_str(), pair) {
                ("(", _) => {
                    stack.push((0, 0));
                    operand_before = false;
                    index += 1;
                    continue;
                }
                (")", _) => {
                    while let Some((level, operator)) = stack.pop() {
                        if level == 0 {
                            break;
                        }
                        out.push(Operation::Apply(operator));
                    }
                    operand_before = true;
                    index += 1;
                    continue;
                }
                ("-", _) if !operand_before => (9, format::OPERATION_NEGATE),
                ("NOT", _) => (9, format::OPERATION_NOT),
                ("ABS", _) => (10, format::OPERATION_ABSOLUTE),
                ("SQR", _) => (10, format::OPERATION_SQUARE_ROOT),
                ("*", _) => (8, format::OPERATION_MULTIPLY),
                ("/", _) => (8, format::OPERATION_DIVIDE),
                ("MOD", _) => (8, format::OPERATION_MODULO),
                ("+", _) => (6, format::OPERATION_ADD),
                ("-", _) => (6, format::OPERATION_SUBTRACT),
                ("AND", _) => (5, format::OPERATION_AND),
                ("XOR", _) => (4, format::OPERATION_XOR),
                ("OR", _) => (3, format::OPERATION_OR),
                ("<", Some("=")) => (72, format::OPERATION_LESS_OR_EQUAL),
                (">", Some("=")) => (72, format::OPERATION_GREATER_OR_EQUAL),
                ("<", Some(">")) => (72, format::OPERATION_NOT_EQUAL),
                ("<", _) => (7, format::OPERATION_LESS),
                (">", _) => (7, format::OPERATION_GREATER),
                ("=", _) => (7, format::OPERATION_EQUAL),
                _ => {
                    let operand = self.value(&tokens[index]);
                    out.push(Operation::Push(OperandIndex(operand)));
                    operand_before = true;
                    index += 1;
                    continue;
                }
            };
            let (level, width) = if level == 72 { (7, 2) } else { (level, 1) };
            if level < 9 {
                while let Some((top, operator)) = stack.last().copied().filter(|(top, _)| *top >= level && *top != 0) {
                    let _ = top;
                    out.push(Operation::Apply(operator));
                    stack.pop();
                }
            }
            stack.push((level, operator));
            operand_before = false;
            index += width;
        }
        while let Some((_, operator)) = stack.pop() {
            out.push(Operation::Apply(operator));
        }
        out
    }

    /// The start of a reference: root, type, dimension, cells, base.
    fn root(&self, name: &str) -> (Root, TypeReference, u32, u32, u32, Base) {
        if let Some(add_on) = self.inside {
            let record = &self.image.add_ons[add_on as usize];
            let found = record.parameters.iter().position(|known| known.name.eq_ignore_ascii_case(name));
            if let Some(parameter) = found.filter(|found| record.parameters[*found].usage == Usage::InOut) {
                let known = &record.parameters[parameter];
                let root = Root::InOut(AddOnIndex(add_on), parameter as u16);
                let base = Base::InOut(parameter as u16);
                return (root, known.type_reference, known.dimensions[0], 0, 0, base);
            }
            let instance = record.instance_type.position();
            let members = &self.image.types[instance].members;
            let member = members.iter().position(|known| known.name.eq_ignore_ascii_case(name)).expect("a member");
            let place = &self.layouts[instance].members[member];
            let root = Root::Member(AddOnIndex(add_on), member as u16);
            let known = &members[member];
            let (bit, word) = (place.bit_cell, place.word_cell);
            return (root, known.type_reference, known.dimensions[0], bit, word, Base::Instance);
        }
        let index = *self.tags.get(&fold(name)).unwrap_or_else(|| panic!("no tag {name}"));
        let tag = &self.image.tags[index as usize];
        let root = Root::Tag(TagIndex(index));
        (root, tag.type_reference, tag.dimensions[0], tag.bit_cell, tag.word_cell, Base::Absolute)
    }

    fn reference(&mut self, text: &str) -> OperandRecord {
        let end = text.find(['.', '[']).unwrap_or(text.len());
        let (root, mut type_reference, mut dimension, mut bit_cell, mut word_cell, base) = self.root(&text[..end]);
        let mut rest = &text[end..];
        let (mut steps, mut terms, mut word_bit) = (Vec::new(), Vec::new(), None);
        let mut count = dimension.max(1);
        while !rest.is_empty() {
            if rest.starts_with('[') {
                let end = matching(rest);
                let inner = rest[1..end].to_string();
                rest = &rest[end + 1..];
                let (bits, words) = layout::cells(&self.layouts, type_reference).expect("cells");
                if let Ok(index) = inner.parse::<u32>() {
                    steps.push(Step::Subscript(vec![Subscript::Constant(index)]));
                    bit_cell += bits * index;
                    word_cell += words * index;
                    count = dimension - index;
                } else {
                    let operand = if inner.contains(['+', '*', '-']) {
                        let operations = self.expression(&inner);
                        self.intern(&OperandRecord::Expression(operations))
                    } else {
                        self.value(&inner)
                    };
                    let operand = OperandIndex(operand);
                    steps.push(Step::Subscript(vec![Subscript::Operand(operand)]));
                    terms.push(Term { operand, length: dimension, bit_stride: bits, word_stride: words });
                    count = dimension;
                }
                dimension = 0;
                continue;
            }
            rest = &rest[1..];
            if rest.starts_with('[') {
                let inner = rest[1..rest.len() - 1].to_string();
                let operand = OperandIndex(self.value(&inner));
                steps.push(Step::BitOperand(operand));
                let TypeReference::Element(element) = type_reference else { panic!("a bit of a structure") };
                word_bit = Some(BitNumber::Operand { operand, length: element.bits() });
                break;
            }
            let end = rest.find(['.', '[']).unwrap_or(rest.len());
            let name = &rest[..end];
            rest = &rest[end..];
            if let Ok(bit) = name.parse::<u8>() {
                steps.push(Step::Bit(bit));
                let TypeReference::Element(element) = type_reference else { panic!("a bit of a structure") };
                word_bit = Some(BitNumber::Constant { bit, length: element.bits() });
                continue;
            }
            let TypeReference::Structure(index) = type_reference else { panic!("a member of an element") };
            let members = &self.image.types[index.position()].members;
            let member = members.iter().position(|known| known.name.eq_ignore_ascii_case(name)).expect("a member");
            let place = &self.layouts[index.position()].members[member];
            steps.push(Step::Member(member as u16));
            bit_cell += place.bit_cell;
            word_cell += place.word_cell;
            type_reference = members[member].type_reference;
            dimension = members[member].dimensions[0];
            count = dimension.max(1);
        }
        let (shape, access_type) = match (type_reference, word_bit) {
            (TypeReference::Element(element), Some(bit)) => (Shape::WordBit(bit), AccessType::Element(element)),
            (TypeReference::Element(element), None) if dimension > 0 => (Shape::Region, AccessType::Element(element)),
            (TypeReference::Element(Element::Bool), None) => (Shape::Bit, AccessType::Element(Element::Bool)),
            (TypeReference::Element(element), None) => (Shape::Word, AccessType::Element(element)),
            (TypeReference::Structure(index), _) => (Shape::Region, AccessType::Structure(index)),
        };
        OperandRecord::Reference(Reference {
            root,
            steps,
            access: Access { shape, access_type, base, bit_cell, word_cell, count, terms },
        })
    }

    pub(crate) fn load(&self) -> Result<Primary, LoadError> {
        Primary::from_records(&self.image, &self.layouts)
    }

    pub(crate) fn build(&self) -> Primary {
        self.load().expect("a loaded image")
    }

    /// The cell of a scalar: bit or word.
    pub(crate) fn cell(&mut self, name: &str) -> Cell {
        match self.reference(name) {
            OperandRecord::Reference(Reference { access, .. }) => match access.shape {
                Shape::Bit => Cell::Bit(access.bit_cell),
                _ => Cell::Word(access.word_cell),
            },
            _ => panic!("no reference"),
        }
    }
}

/// A cell of the image.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Cell {
    Bit(u32),
    Word(u32),
}

/// Position of the bracket that closes the one at the begin.
fn matching(text: &str) -> usize {
    let mut depth = 0;
    for (at, character) in text.char_indices() {
        match character {
            '(' | '[' => depth += 1,
            ')' | ']' => {
                depth -= 1;
                if depth == 0 {
                    return at;
                }
            }
            _ => {}
        }
    }
    panic!("unbalanced: {text}")
}
