//! Small images by hand: an assembler for code, operands and references whose accesses the tests write themselves.

pub mod samples;

pub use twinrung_bytecode::image::*;
pub use twinrung_bytecode::index::*;
pub use twinrung_bytecode::operand::*;
pub use twinrung_catalog::{Element, Opcode, PredefinedType};

use twinrung_bytecode::{AdmittedImage, ImageError, admit, format, layout, seal, text};

pub const BOOL: TypeReference = TypeReference::Element(Element::Bool);
pub const SINT: TypeReference = TypeReference::Element(Element::Sint);
pub const INT: TypeReference = TypeReference::Element(Element::Int);
pub const DINT: TypeReference = TypeReference::Element(Element::Dint);
pub const REAL: TypeReference = TypeReference::Element(Element::Real);
pub const SCALAR: [u32; 3] = [0; 3];
pub const MAIN: RoutineIndex = RoutineIndex(0);
pub const PROGRAM: ProgramIndex = ProgramIndex(0);

/// An application with one program `Main`, one routine `Main` and a task, to which a test adds.
#[derive(Clone)]
pub struct Build {
    pub image: Image,
}

pub fn build() -> Build {
    build_for("1756-L72S", 20)
}

pub fn build_for(processor: &str, revision: u16) -> Build {
    Build {
        image: Image {
            controller: ControllerRecord {
                name: "Cell".into(),
                processor: processor.into(),
                revision,
                attributes: vec![("SafetyNetwork".into(), "16#0000_41b4_02bb_cb7e".into())],
            },
            programs: vec![ProgramRecord { name: "Main".into(), main: Some(MAIN), fault: None, disabled: false }],
            routines: vec![RoutineRecord {
                owner: Owner::Program(PROGRAM),
                name: "Main".into(),
                code: vec![],
                text: String::new(),
            }],
            task: Some(TaskRecord {
                name: "Safety_Task".into(),
                period_us: 20_000,
                watchdog_us: 10_000,
                priority: 5,
                schedule: vec![PROGRAM],
            }),
            ..Image::default()
        },
    }
}

impl Build {
    pub fn predefined(&mut self, name: &str) -> TypeReference {
        let known = PredefinedType::by_name(name).unwrap();
        let member = |member: &twinrung_catalog::Member| MemberRecord {
            name: member.name.into(),
            type_reference: TypeReference::Element(member.element),
            dimensions: [member.length, 0, 0],
        };
        self.structure(known.name, TypeKind::Predefined, known.members.iter().map(member).collect())
    }

    pub fn user(&mut self, name: &str, members: &[(&str, TypeReference, u32)]) -> TypeReference {
        let member = |(name, type_reference, length): &(&str, TypeReference, u32)| MemberRecord {
            name: (*name).into(),
            type_reference: *type_reference,
            dimensions: [*length, 0, 0],
        };
        self.structure(name, TypeKind::User, members.iter().map(member).collect())
    }

    pub fn structure(&mut self, name: &str, kind: TypeKind, members: Vec<MemberRecord>) -> TypeReference {
        self.image.types.push(TypeRecord { name: name.into(), kind, members });
        TypeReference::Structure(TypeIndex((self.image.types.len() - 1) as u16))
    }

    /// Adds a tag behind all others, with cells behind all others, all 0.
    pub fn tag_of(
        &mut self,
        name: &str,
        type_reference: TypeReference,
        dimensions: [u32; 3],
        kind: TagKind,
    ) -> TagIndex {
        self.scoped_tag(name, None, type_reference, dimensions, kind)
    }

    pub fn tag(&mut self, name: &str, type_reference: TypeReference) -> TagIndex {
        self.tag_of(name, type_reference, SCALAR, TagKind::Base)
    }

    pub fn scoped_tag(
        &mut self,
        name: &str,
        program: Option<ProgramIndex>,
        type_reference: TypeReference,
        dimensions: [u32; 3],
        kind: TagKind,
    ) -> TagIndex {
        let alias = matches!(kind, TagKind::Alias(_));
        let (bit_cell, word_cell) =
            if alias { (0, 0) } else { (self.image.initial_bits.len() as u32, self.image.initial_words.len() as u32) };
        if !alias {
            let layouts = layout::layouts(&self.image.types).unwrap();
            let (bits, words) = layout::cells(&layouts, type_reference).unwrap();
            let elements = layout::elements(dimensions).unwrap() as usize;
            self.image.initial_bits.resize(bit_cell as usize + bits as usize * elements, 0);
            self.image.initial_words.resize(word_cell as usize + words as usize * elements, 0);
        }
        self.image.tags.push(TagRecord {
            name: name.into(),
            program,
            type_reference,
            dimensions,
            kind,
            constant: false,
            bit_cell,
            word_cell,
            attributes: vec![],
        });
        TagIndex((self.image.tags.len() - 1) as u32)
    }

    pub fn operand(&mut self, record: OperandRecord) -> OperandIndex {
        let table = &mut self.image.operands;
        if table.offsets.is_empty() {
            table.offsets.push(0);
        }
        record.encode(&mut table.bytes);
        table.offsets.push(table.bytes.len() as u32);
        OperandIndex((table.offsets.len() - 2) as u32)
    }

    pub fn integer(&mut self, value: i32) -> OperandIndex {
        self.operand(OperandRecord::Integer { radix: 10, value })
    }

    pub fn word_text(&mut self, text: &str) -> OperandIndex {
        self.operand(OperandRecord::Text(text.into()))
    }

    pub fn expression(&mut self, operations: &[Operation]) -> OperandIndex {
        self.operand(OperandRecord::Expression(operations.to_vec()))
    }

    pub fn reference(&mut self, root: Root, steps: &[Step], access: Access) -> OperandIndex {
        self.operand(OperandRecord::Reference(Reference { root, steps: steps.to_vec(), access }))
    }

    /// A scalar tag, or a whole one.
    pub fn whole(&mut self, tag: TagIndex) -> OperandIndex {
        let record = &self.image.tags[tag.position()];
        let (shape, access_type) = match record.type_reference {
            TypeReference::Structure(index) => (Shape::Region, AccessType::Structure(index)),
            TypeReference::Element(element) if record.dimensions != SCALAR => {
                (Shape::Region, AccessType::Element(element))
            }
            TypeReference::Element(Element::Bool) => (Shape::Bit, AccessType::Element(Element::Bool)),
            TypeReference::Element(element) => (Shape::Word, AccessType::Element(element)),
        };
        let access = Access {
            shape,
            access_type,
            base: Base::Absolute,
            bit_cell: record.bit_cell,
            word_cell: record.word_cell,
            count: layout::elements(record.dimensions).unwrap(),
            terms: vec![],
        };
        self.reference(Root::Tag(tag), &[], access)
    }

    /// A new BOOL tag as an operand.
    pub fn bit(&mut self, name: &str) -> OperandIndex {
        let tag = self.tag(name, BOOL);
        self.whole(tag)
    }

    /// A new tag as an operand.
    pub fn data(&mut self, name: &str, type_reference: TypeReference) -> OperandIndex {
        let tag = self.tag(name, type_reference);
        self.whole(tag)
    }

    pub fn routine(&mut self, name: &str, owner: Owner) -> RoutineIndex {
        self.image.routines.push(RoutineRecord { owner, name: name.into(), code: vec![], text: String::new() });
        RoutineIndex((self.image.routines.len() - 1) as u32)
    }

    /// Appends a rung to the main routine.
    pub fn rung(&mut self, elements: &[Vec<u8>]) -> &mut Build {
        self.rung_in(MAIN, elements)
    }

    pub fn rung_in(&mut self, routine: RoutineIndex, elements: &[Vec<u8>]) -> &mut Build {
        let code = &mut self.image.routines[routine.position()].code;
        code.push(format::RUNG);
        code.extend(elements.concat());
        code.push(format::END_RUNG);
        self
    }

    /// Gives every routine the text of its code.
    pub fn texts(&mut self) -> &mut Build {
        for index in 0..self.image.routines.len() {
            // What has no text keeps the part that has one: the verifier then meets the reason.
            let mut text = String::new();
            let _ = text::write_routine(&self.image, RoutineIndex(index as u32), &mut text);
            self.image.routines[index].text = text;
        }
        self
    }

    pub fn bytes(&mut self) -> Vec<u8> {
        self.texts();
        seal(&self.image).unwrap()
    }

    pub fn admit(&mut self) -> Result<AdmittedImage, ImageError> {
        self.texts();
        admit(&seal(&self.image)?)
    }

    /// The rule that refuses the image, or "admitted".
    pub fn rule(&mut self) -> &'static str {
        self.admit().map_or_else(|error| error.rule(), |_| "admitted")
    }

    /// The text of the main routine.
    pub fn text(&self) -> String {
        text::render_routine(&self.image, MAIN).unwrap()
    }
}

/// An instruction.
pub fn op(opcode: Opcode, operands: &[OperandIndex]) -> Vec<u8> {
    raw(opcode as u8, operands)
}

/// An Add-On call.
pub fn call(operands: &[OperandIndex]) -> Vec<u8> {
    raw(format::ADD_ON, operands)
}

pub fn raw(opcode: u8, operands: &[OperandIndex]) -> Vec<u8> {
    let mut bytes = vec![opcode, operands.len() as u8];
    operands.iter().for_each(|operand| bytes.extend(operand.0.to_le_bytes()));
    bytes
}

/// A branch of legs.
pub fn branch(legs: &[Vec<Vec<u8>>]) -> Vec<u8> {
    let legs: Vec<Vec<u8>> = legs.iter().map(|leg| leg.concat()).collect();
    let mut bytes = vec![format::BRANCH];
    bytes.extend(legs.join(&format::NEXT_LEG));
    bytes.push(format::END_BRANCH);
    bytes
}

/// The access of a scalar at these cells.
pub fn access(shape: Shape, access_type: AccessType, bit_cell: u32, word_cell: u32, count: u32) -> Access {
    Access { shape, access_type, base: Base::Absolute, bit_cell, word_cell, count, terms: vec![] }
}

pub fn element(element: Element) -> AccessType {
    AccessType::Element(element)
}
