//! Applications to start from.

use super::*;

/// Two bits and a coil: the smallest application that does something.
pub fn small() -> Build {
    let mut b = build();
    let (a, c, e) = (b.bit("A"), b.bit("B"), b.bit("C"));
    b.rung(&[op(Opcode::Xic, &[a]), op(Opcode::Xio, &[c]), op(Opcode::Ote, &[e])]);
    b
}

/// An application with something of every kind, and the parts of which tests make further rungs.
#[derive(Clone)]
pub struct Rich {
    pub b: Build,
    pub part: TypeReference,
    pub scale: TypeReference,
    pub tags: Tags,
    /// BOOL tags.
    pub x: [OperandIndex; 3],
    pub word: OperandIndex,
    pub y: OperandIndex,
    pub real: OperandIndex,
    pub list: OperandIndex,
    pub stop: OperandIndex,
    pub instance: OperandIndex,
    pub time: OperandIndex,
    pub alias: OperandIndex,
    pub sub: OperandIndex,
    pub sub_routine: RoutineIndex,
    pub logic: RoutineIndex,
}

/// The tags of [`rich`], in table order.
#[derive(Clone, Copy)]
pub struct Tags {
    pub alias: TagIndex,
    pub instance: TagIndex,
    pub list: TagIndex,
    pub mapped: TagIndex,
    pub input: TagIndex,
    pub parts: TagIndex,
    pub real: TagIndex,
    pub stop: TagIndex,
    pub time: TagIndex,
    pub word: TagIndex,
    pub y: TagIndex,
    pub local: TagIndex,
}

pub const SCALE: AddOnIndex = AddOnIndex(0);

pub fn rich() -> Rich {
    let mut b = build();
    let timer = b.predefined("TIMER");
    let dci_stop = b.predefined("DCI_STOP");
    // 2 bits, 3 words, 12 bytes.
    let part = b.user("Part", &[("A", BOOL, 0), ("B", BOOL, 0), ("N", DINT, 0), ("W", INT, 2)]);
    // 2 bits, 4 words; Hold is its last member.
    let member = |name: &str, type_reference| MemberRecord { name: name.into(), type_reference, dimensions: SCALAR };
    let members = vec![
        member("EnableIn", BOOL),
        member("EnableOut", BOOL),
        member("Gain", DINT),
        member("Result", DINT),
        member("Hold", timer),
    ];
    let scale = b.structure("Scale", TypeKind::AddOn(SCALE), members);

    let controller =
        |b: &mut Build, name: &str, type_reference, dimensions, kind| b.tag_of(name, type_reference, dimensions, kind);
    let alias = controller(&mut b, "Alias_Bit", BOOL, SCALAR, TagKind::Alias(OperandIndex(0)));
    let instance = controller(&mut b, "Inst", scale, SCALAR, TagKind::Base);
    let list = controller(&mut b, "List", DINT, [4, 0, 0], TagKind::Base);
    let mapped = controller(&mut b, "Mapped", BOOL, SCALAR, TagKind::Base);
    let input = controller(&mut b, "Mod:I", part, SCALAR, TagKind::ModuleInput);
    let parts = controller(&mut b, "Parts", part, [3, 0, 0], TagKind::Base);
    let real = controller(&mut b, "Real", REAL, SCALAR, TagKind::Base);
    let stop = controller(&mut b, "Stop", dci_stop, SCALAR, TagKind::Base);
    let time = controller(&mut b, "Time", timer, SCALAR, TagKind::Base);
    let word = controller(&mut b, "Word", DINT, SCALAR, TagKind::Base);
    let word_cell = b.image.tags[word.position()].word_cell;
    let bit_3 = Shape::WordBit(BitNumber::Constant { bit: 3, length: 32 });
    let target = access(bit_3, element(Element::Dint), b.image.tags[word.position()].bit_cell, word_cell, 1);
    let alias_target = b.reference(Root::Tag(word), &[Step::Bit(3)], target.clone());
    assert_eq!(alias_target, OperandIndex(0));
    let x = ["X1", "X2", "X3"].map(|name| b.bit(name));
    let y = b.tag("Y", DINT);
    let local = b.scoped_tag("Local", Some(PROGRAM), DINT, SCALAR, TagKind::Base);
    let tags = Tags { alias, instance, list, mapped, input, parts, real, stop, time, word, y, local };

    let sub_routine = b.routine("Sub", Owner::Program(PROGRAM));
    let logic = b.routine("Logic", Owner::AddOn(SCALE));
    let parameter = |name: &str, usage, type_reference, argument, member| ParameterRecord {
        name: name.into(),
        usage,
        type_reference,
        dimensions: SCALAR,
        argument,
        member,
    };
    let TypeReference::Structure(instance_type) = scale else { unreachable!() };
    b.image.add_ons.push(AddOnRecord {
        name: "Scale".into(),
        instance_type,
        parameters: vec![
            parameter("EnableIn", Usage::Input, BOOL, false, Some(0)),
            parameter("EnableOut", Usage::Output, BOOL, false, Some(1)),
            parameter("Gain", Usage::Input, DINT, true, Some(2)),
            parameter("Result", Usage::Output, DINT, true, Some(3)),
            parameter("Ref", Usage::InOut, DINT, true, None),
        ],
        logic,
        prescan: None,
        enable_in_false: None,
        attributes: vec![("Revision".into(), "\"1.0\"".into())],
    });
    b.image.map.push(MapRecord { standard: "Panel_Reset".into(), safety: mapped });
    b.image.system_values.push(SystemValueRecord { attribute: 6, instance: 0, first: 0, program: None });
    b.image.event_tasks.push("Report".into());
    b.image.modules.push(ModuleRecord { name: "Mod".into(), text: "MODULE Mod END_MODULE\n".into() });
    b.image.tags[word.position()].attributes.push(("SIL".into(), "2".into()));
    b.image.initial_words[word_cell as usize] = 2;

    let alias_operand = b.reference(Root::Tag(alias), &[], target);
    let [word_operand, y_operand, real_operand, list_operand, stop_operand, instance_operand, time_operand] =
        [word, y, real, list, stop, instance, time].map(|tag| b.whole(tag));
    let sub = b.operand(OperandRecord::Routine(sub_routine));

    let mut rich = Rich {
        b,
        part,
        scale,
        tags,
        x,
        word: word_operand,
        y: y_operand,
        real: real_operand,
        list: list_operand,
        stop: stop_operand,
        instance: instance_operand,
        time: time_operand,
        alias: alias_operand,
        sub,
        sub_routine,
        logic,
    };
    rich.fill();
    rich
}

impl Rich {
    fn fill(&mut self) {
        let [x1, x2, x3] = self.x;
        self.b.rung(&[
            op(Opcode::Xic, &[self.alias]),
            branch(&[vec![op(Opcode::Xic, &[x1])], vec![op(Opcode::Xio, &[x2]), op(Opcode::Afi, &[])], vec![]]),
            op(Opcode::Ote, &[x3]),
        ]);
        let selected = self.list_at(self.word);
        self.b.rung(&[op(Opcode::Mov, &[selected, self.y])]);
        let stop = self.stop_call(self.stop);
        self.b.rung(&[stop]);
        let (unassigned, zero) = (self.b.operand(OperandRecord::Unassigned), self.b.integer(0));
        self.b.rung(&[op(Opcode::Ton, &[self.time, unassigned, zero])]);
        let (from, to, two) = (self.part_at(0), self.part_at(1), self.b.integer(2));
        self.b.rung(&[op(Opcode::Cop, &[from, to, two])]);
        let five = self.b.integer(5);
        self.b.rung(&[call(&[self.instance, five, self.y, self.word])]);
        let one = self.b.integer(1);
        self.b.rung(&[op(Opcode::Jsr, &[self.sub, one, self.word, self.y])]);
        let gsv = self.gsv("TASK", "Safety_Task", 0, self.y);
        let first_scan = self.b.operand(OperandRecord::Status(0));
        self.b.rung(&[op(Opcode::Xic, &[first_scan]), gsv]);
        let sum = self.b.expression(&[
            Operation::Push(self.word),
            Operation::Push(one),
            Operation::Apply(format::OPERATION_ADD),
        ]);
        let local = self.b.whole(self.tags.local);
        self.b.rung(&[op(Opcode::Cpt, &[local, sum])]);
        self.b.rung_in(self.sub_routine, &[op(Opcode::Sbr, &[self.y])]);
        self.b.rung_in(self.sub_routine, &[op(Opcode::Ret, &[self.word])]);
        let (gain, result, reference) = (self.member(2, 0), self.member(3, 1), self.in_out());
        self.b.rung_in(self.logic, &[op(Opcode::Mul, &[gain, reference, result])]);
    }

    /// `List[operand]`
    pub fn list_at(&mut self, operand: OperandIndex) -> OperandIndex {
        let record = &self.b.image.tags[self.tags.list.position()];
        let term = Term { operand, length: 4, bit_stride: 0, word_stride: 1 };
        let access = Access {
            terms: vec![term],
            ..access(Shape::Word, element(Element::Dint), record.bit_cell, record.word_cell, 4)
        };
        self.b.reference(Root::Tag(self.tags.list), &[Step::Subscript(vec![Subscript::Operand(operand)])], access)
    }

    /// `List[index]`
    pub fn list_element(&mut self, index: u32) -> OperandIndex {
        let record = &self.b.image.tags[self.tags.list.position()];
        let (bit_cell, word_cell) = (record.bit_cell, record.word_cell + index);
        let access = access(Shape::Word, element(Element::Dint), bit_cell, word_cell, 4u32.saturating_sub(index));
        self.b.reference(Root::Tag(self.tags.list), &[Step::Subscript(vec![Subscript::Constant(index)])], access)
    }

    /// `Parts[index]`
    pub fn part_at(&mut self, index: u32) -> OperandIndex {
        let record = &self.b.image.tags[self.tags.parts.position()];
        let TypeReference::Structure(part) = self.part else { unreachable!() };
        let (bit_cell, word_cell) = (record.bit_cell + 2 * index, record.word_cell + 3 * index);
        let access = access(Shape::Region, AccessType::Structure(part), bit_cell, word_cell, 3 - index);
        self.b.reference(Root::Tag(self.tags.parts), &[Step::Subscript(vec![Subscript::Constant(index)])], access)
    }

    /// A word member of the instance, by member and word cell.
    pub fn member(&mut self, member: u16, word_cell: u32) -> OperandIndex {
        let access = Access { base: Base::Instance, ..access(Shape::Word, element(Element::Dint), 2, word_cell, 1) };
        self.b.reference(Root::Member(SCALE, member), &[], access)
    }

    /// The InOut parameter `Ref`.
    pub fn in_out(&mut self) -> OperandIndex {
        let access = Access { base: Base::InOut(4), ..access(Shape::Word, element(Element::Dint), 0, 0, 1) };
        self.b.reference(Root::InOut(SCALE, 4), &[], access)
    }

    /// A DCS on a backing tag.
    pub fn stop_call(&mut self, backing: OperandIndex) -> Vec<u8> {
        let [x1, x2, x3] = self.x;
        let choices = [1, 0, 0, 0].map(|value| self.b.operand(OperandRecord::Choice(value)));
        let (discrepancy, status) = (self.b.integer(500), self.b.integer(1));
        let [function, input, restart, cold_start] = choices;
        op(Opcode::Dcs, &[backing, function, input, discrepancy, restart, cold_start, x1, x2, status, x3])
    }

    /// A GSV of a system value.
    pub fn gsv(&mut self, class: &str, instance: &str, value: u16, destination: OperandIndex) -> Vec<u8> {
        let (class, instance) = (self.b.word_text(class), self.b.word_text(instance));
        let attribute = self.b.operand(OperandRecord::SystemValue(SystemValueIndex(value)));
        op(Opcode::Gsv, &[class, instance, attribute, destination])
    }

    /// The rule that refuses the image with one more rung in the main routine.
    pub fn rule_with(&mut self, elements: &[Vec<u8>]) -> &'static str {
        self.b.rung(elements);
        self.b.rule()
    }

    pub fn tag(&mut self, tag: TagIndex) -> &mut TagRecord {
        &mut self.b.image.tags[tag.position()]
    }
}
