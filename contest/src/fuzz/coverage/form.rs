//! How an operand stands in a call: what decoding and addressing differ by.

use twinrung_bytecode::image::{Image, TagKind};
use twinrung_bytecode::index::OperandIndex;
use twinrung_bytecode::operand::{
    AccessType, BitNumber, OperandRecord, Operation, Reference, Root, Shape, Step, Subscript,
};
use twinrung_catalog::Element;

/// One trait of an operand; data has several: how it is reached, and what it is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Form {
    /// A whole tag, not an array.
    Tag,
    /// A member of a structure.
    Member,
    /// An element of an array, by number.
    Element,
    /// An element whose number a tag holds.
    ElementByTag,
    /// An element whose number is computed.
    ElementByExpression,
    /// A whole array.
    WholeArray,
    /// Through another name.
    Alias,
    /// An InOut parameter of the Add-On Instruction.
    InOut,
    /// A parameter or local tag of the Add-On Instruction's instance.
    Instance,
    /// A bit of an integer of this type.
    BitOf(Element),
    /// A bit whose number is a tag's or computed.
    BitByTag,
    /// Data of this type.
    Of(Element),
    /// A structure.
    Structure,
    /// A status keyword, by its number.
    Status(u8),
    /// An integer literal where every value is alike.
    Integer,
    /// An integer literal where a range is declared.
    Literal(Extent),
    /// A REAL literal.
    Real,
    /// A word out of a list, or a small number with a meaning of its own.
    Word(i32),
    /// `?`, or nothing.
    Unassigned,
    /// A label, an object class, an instance.
    Name,
    /// A routine.
    Routine,
    /// An event task.
    EventTask,
    /// A system attribute, by its number.
    Attribute(u8),
    /// An operator of an expression, by its number.
    Operator(u8),
}

/// Where in its range a literal lies.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Extent {
    /// 0 beside the range.
    Zero,
    /// The least value.
    Least,
    /// Neither end.
    Between,
    /// The greatest value.
    Greatest,
}

impl Extent {
    /// Where a value lies in a range.
    pub fn of(value: i32, least: i32, greatest: i32) -> Extent {
        match value {
            _ if value == least => Extent::Least,
            _ if value == greatest => Extent::Greatest,
            0 if least > 0 => Extent::Zero,
            _ => Extent::Between,
        }
    }
}

/// The operand at an index; none where an image holds none that can be read, which admission rules out.
pub fn operand(image: &Image, index: OperandIndex) -> Option<OperandRecord> {
    OperandRecord::decode(image.operands.entry(index)?).ok()
}

/// The forms of a reference.
pub fn of_reference(image: &Image, reference: &Reference, forms: &mut Vec<Form>) {
    match reference.root {
        Root::Tag(tag) => {
            let record = image.tags.get(tag.position());
            if record.is_some_and(|record| matches!(record.kind, TagKind::Alias(_))) {
                forms.push(Form::Alias);
            }
        }
        Root::Member(..) => forms.push(Form::Instance),
        Root::InOut(..) => forms.push(Form::InOut),
    }
    if reference.steps.is_empty() {
        let array = match reference.root {
            Root::Tag(tag) => image.tags.get(tag.position()).is_some_and(|record| record.dimensions[0] > 0),
            Root::Member(..) | Root::InOut(..) => is_array_parameter(image, reference.root),
        };
        forms.push(if array { Form::WholeArray } else { Form::Tag });
    }
    let mut is_bit = false;
    for step in &reference.steps {
        match step {
            Step::Member(_) => forms.push(Form::Member),
            Step::Subscript(subscripts) => forms.extend(subscripts.iter().map(|one| match one {
                Subscript::Constant(_) => Form::Element,
                Subscript::Operand(index) => match operand(image, *index) {
                    Some(OperandRecord::Reference(_)) => Form::ElementByTag,
                    _ => Form::ElementByExpression,
                },
            })),
            Step::Bit(_) => is_bit = true,
            Step::BitOperand(_) => {
                is_bit = true;
                forms.push(Form::BitByTag);
            }
        }
    }
    let access = &reference.access;
    if let Shape::WordBit(BitNumber::Constant { .. } | BitNumber::Operand { .. }) = access.shape {
        is_bit = true;
    }
    forms.push(match access.access_type {
        AccessType::Element(element) if is_bit => Form::BitOf(element),
        AccessType::Element(element) => Form::Of(element),
        AccessType::Structure(_) => Form::Structure,
    });
}

/// Whether a parameter or local tag is an array.
fn is_array_parameter(image: &Image, root: Root) -> bool {
    match root {
        Root::InOut(add_on, parameter) => {
            let add_on = image.add_ons.get(add_on.position());
            let parameter = add_on.and_then(|add_on| add_on.parameters.get(usize::from(parameter)));
            parameter.is_some_and(|parameter| parameter.dimensions[0] > 0)
        }
        Root::Member(add_on, member) => {
            let add_on = image.add_ons.get(add_on.position());
            let layout = add_on.and_then(|add_on| image.types.get(add_on.instance_type.position()));
            let member = layout.and_then(|layout| layout.members.get(usize::from(member)));
            member.is_some_and(|member| member.dimensions[0] > 0)
        }
        Root::Tag(_) => false,
    }
}

/// The forms of what an expression is made of.
pub fn of_expression(image: &Image, operations: &[Operation], forms: &mut Vec<Form>) {
    for operation in operations {
        match operation {
            Operation::Apply(operator) => forms.push(Form::Operator(*operator)),
            Operation::Push(index) => match operand(image, *index) {
                Some(OperandRecord::Integer { .. }) => forms.push(Form::Integer),
                Some(OperandRecord::Real(_)) => forms.push(Form::Real),
                Some(OperandRecord::Reference(reference)) => of_reference(image, &reference, forms),
                _ => {}
            },
        }
    }
}
