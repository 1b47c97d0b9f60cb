//! Reading an entry of the operand table. Every entry has one form: what is accepted here encodes to the same bytes.

use alloc::string::String;
use alloc::vec::Vec;

use twinrung_catalog::Element;

use super::*;
use crate::limits;

/// Why the bytes of an entry are none.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DecodeError {
    /// The entry ends too early.
    Truncated,
    /// Bytes are left over.
    Slack,
    /// No kind has this number.
    Kind,
    /// A radix other than 2, 8, 10 and 16.
    Radix,
    /// A text that is not UTF-8.
    Text,
    /// No status keyword has this number.
    Status,
    /// No operation has this number.
    Operation,
    /// No root has this number.
    Root,
    /// No step has this number.
    Step,
    /// More steps than [`limits::PATH_STEPS`].
    TooManySteps,
    /// No subscript, more than three, or an unknown form of one.
    Subscript,
    /// No shape has this number.
    Shape,
    /// Neither an elementary type nor a structure, or both.
    Type,
    /// No base has this number, or a parameter where there is none.
    Base,
    /// More variable subscripts than [`limits::SUBSCRIPT_TERMS`].
    TooManyTerms,
    /// A bit number where there is none, or none or two where there is one.
    BitNumber,
}

impl core::fmt::Display for DecodeError {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str(match self {
            DecodeError::Truncated => "it ends too early",
            DecodeError::Slack => "bytes are left over",
            DecodeError::Kind => "no kind of operand has its number",
            DecodeError::Radix => "its radix is not 2, 8, 10 or 16",
            DecodeError::Text => "its text is not UTF-8",
            DecodeError::Status => "no status keyword has its number",
            DecodeError::Operation => "no operation of an expression has its number",
            DecodeError::Root => "no root of a path has its number",
            DecodeError::Step => "no step of a path has its number",
            DecodeError::TooManySteps => "its path has too many steps",
            DecodeError::Subscript => "an element has one to three subscripts, each a number or an operand",
            DecodeError::Shape => "no shape of an access has its number",
            DecodeError::Type => "its type is neither elementary nor a structure",
            DecodeError::Base => "no base of an access has its number",
            DecodeError::TooManyTerms => "it has too many variable subscripts",
            DecodeError::BitNumber => "its bit number does not fit its shape",
        })
    }
}

impl OperandRecord {
    /// Reads the bytes of an entry.
    ///
    /// # Errors
    ///
    /// The bytes are not exactly what [`OperandRecord::encode`] makes of some record.
    pub fn decode(bytes: &[u8]) -> Result<OperandRecord, DecodeError> {
        let mut entry = Entry(bytes);
        let record = match entry.byte()? {
            format::INTEGER => {
                let radix = entry.byte()?;
                if !matches!(radix, 2 | 8 | 10 | 16) {
                    return Err(DecodeError::Radix);
                }
                OperandRecord::Integer { radix, value: entry.signed()? }
            }
            format::REAL => OperandRecord::Real(entry.word()?),
            format::CHOICE => OperandRecord::Choice(entry.signed()?),
            format::UNASSIGNED => OperandRecord::Unassigned,
            format::TEXT => {
                let length = usize::from(entry.half()?);
                let text = core::str::from_utf8(entry.take(length)?).map_err(|_| DecodeError::Text)?;
                OperandRecord::Text(String::from(text))
            }
            format::ROUTINE => OperandRecord::Routine(RoutineIndex(entry.word()?)),
            format::STATUS => {
                let keyword = entry.byte()?;
                if usize::from(keyword) >= format::STATUS_KEYWORDS.len() {
                    return Err(DecodeError::Status);
                }
                OperandRecord::Status(keyword)
            }
            format::SYSTEM_VALUE => OperandRecord::SystemValue(SystemValueIndex(entry.half()?)),
            format::EVENT_TASK => OperandRecord::EventTask(EventTaskIndex(entry.half()?)),
            format::EXPRESSION => OperandRecord::Expression(entry.operations()?),
            format::REFERENCE => OperandRecord::Reference(entry.reference()?),
            _ => return Err(DecodeError::Kind),
        };
        entry.finish()?;
        Ok(record)
    }
}

/// The tag of an entry that is a reference to a whole tag. Of the entry no more is looked at than the path: what follows it
/// may still be wrong.
pub(crate) fn whole_tag(bytes: &[u8]) -> Option<TagIndex> {
    /// The number of the root and the tag.
    const PATH_BYTES: u16 = 5;
    let mut entry = Entry(bytes);
    let begin = (entry.byte().ok()?, entry.half().ok()?, entry.byte().ok()?);
    if begin != (format::REFERENCE, PATH_BYTES, format::ROOT_TAG) {
        return None;
    }
    entry.word().ok().map(TagIndex)
}

struct Entry<'a>(&'a [u8]);

impl<'a> Entry<'a> {
    fn take(&mut self, count: usize) -> Result<&'a [u8], DecodeError> {
        let (piece, rest) = self.0.split_at_checked(count).ok_or(DecodeError::Truncated)?;
        self.0 = rest;
        Ok(piece)
    }

    fn array<const N: usize>(&mut self) -> Result<[u8; N], DecodeError> {
        let (piece, rest) = self.0.split_first_chunk().ok_or(DecodeError::Truncated)?;
        self.0 = rest;
        Ok(*piece)
    }

    fn byte(&mut self) -> Result<u8, DecodeError> {
        let [byte] = self.array()?;
        Ok(byte)
    }

    fn half(&mut self) -> Result<u16, DecodeError> {
        Ok(u16::from_le_bytes(self.array()?))
    }

    fn word(&mut self) -> Result<u32, DecodeError> {
        Ok(u32::from_le_bytes(self.array()?))
    }

    fn signed(&mut self) -> Result<i32, DecodeError> {
        Ok(i32::from_le_bytes(self.array()?))
    }

    fn operand(&mut self) -> Result<OperandIndex, DecodeError> {
        Ok(OperandIndex(self.word()?))
    }

    fn finish(&self) -> Result<(), DecodeError> {
        if self.0.is_empty() { Ok(()) } else { Err(DecodeError::Slack) }
    }

    fn operations(&mut self) -> Result<Vec<Operation>, DecodeError> {
        let count = usize::from(self.half()?);
        if count > self.0.len() {
            return Err(DecodeError::Truncated);
        }
        let mut operations = Vec::with_capacity(count);
        for _ in 0..count {
            operations.push(match self.byte()? {
                format::OPERATION_PUSH => Operation::Push(self.operand()?),
                operator @ (format::OPERATION_NEGATE..=format::OPERATION_SQUARE_ROOT
                | format::OPERATION_MULTIPLY..=format::OPERATION_NOT_EQUAL) => Operation::Apply(operator),
                _ => return Err(DecodeError::Operation),
            });
        }
        Ok(operations)
    }

    fn reference(&mut self) -> Result<Reference, DecodeError> {
        let length = usize::from(self.half()?);
        let mut path = Entry(self.take(length)?);
        let root = match path.byte()? {
            format::ROOT_TAG => Root::Tag(TagIndex(path.word()?)),
            format::ROOT_MEMBER => Root::Member(AddOnIndex(path.half()?), path.half()?),
            format::ROOT_IN_OUT => Root::InOut(AddOnIndex(path.half()?), path.half()?),
            _ => return Err(DecodeError::Root),
        };
        let mut steps = Vec::new();
        while !path.0.is_empty() {
            if steps.len() >= limits::PATH_STEPS {
                return Err(DecodeError::TooManySteps);
            }
            steps.push(path.step()?);
        }
        Ok(Reference { root, steps, access: self.access()? })
    }

    fn step(&mut self) -> Result<Step, DecodeError> {
        Ok(match self.byte()? {
            format::STEP_MEMBER => Step::Member(self.half()?),
            format::STEP_SUBSCRIPT => {
                let count = self.byte()?;
                if !(1..=3).contains(&count) {
                    return Err(DecodeError::Subscript);
                }
                let mut subscripts = Vec::with_capacity(usize::from(count));
                for _ in 0..count {
                    subscripts.push(match self.byte()? {
                        format::SUBSCRIPT_CONSTANT => Subscript::Constant(self.word()?),
                        format::SUBSCRIPT_OPERAND => Subscript::Operand(self.operand()?),
                        _ => return Err(DecodeError::Subscript),
                    });
                }
                Step::Subscript(subscripts)
            }
            format::STEP_BIT => Step::Bit(self.byte()?),
            format::STEP_BIT_OPERAND => Step::BitOperand(self.operand()?),
            _ => return Err(DecodeError::Step),
        })
    }

    fn access(&mut self) -> Result<Access, DecodeError> {
        let shape = self.byte()?;
        let element = self.byte()?;
        let element = Element::ALL.into_iter().find(|known| *known as u8 == element).ok_or(element);
        let access_type = match (element, self.half()?) {
            (Ok(element), format::NO_INDEX) => AccessType::Element(element),
            (Err(format::NO_ELEMENT), index) if index != format::NO_INDEX => AccessType::Structure(TypeIndex(index)),
            _ => return Err(DecodeError::Type),
        };
        let base = match (self.byte()?, self.half()?) {
            (format::BASE_ABSOLUTE, format::NO_INDEX) => Base::Absolute,
            (format::BASE_INSTANCE, format::NO_INDEX) => Base::Instance,
            (format::BASE_IN_OUT, parameter) if parameter != format::NO_INDEX => Base::InOut(parameter),
            _ => return Err(DecodeError::Base),
        };
        let (bit_cell, word_cell, count) = (self.word()?, self.word()?, self.word()?);
        let terms = usize::from(self.byte()?);
        if terms > limits::SUBSCRIPT_TERMS {
            return Err(DecodeError::TooManyTerms);
        }
        let terms = (0..terms)
            .map(|_| {
                Ok(Term {
                    operand: self.operand()?,
                    length: self.word()?,
                    bit_stride: self.word()?,
                    word_stride: self.word()?,
                })
            })
            .collect::<Result<Vec<Term>, DecodeError>>()?;
        let bit_number = (self.byte()?, self.word()?, self.byte()?);
        let shape = match (shape, bit_number) {
            (format::SHAPE_BIT, NO_BIT_NUMBER) => Shape::Bit,
            (format::SHAPE_WORD, NO_BIT_NUMBER) => Shape::Word,
            (format::SHAPE_REGION, NO_BIT_NUMBER) => Shape::Region,
            (format::SHAPE_WORD_BIT, (format::NO_BIT, operand, length)) if operand != format::NO_OPERAND => {
                Shape::WordBit(BitNumber::Operand { operand: OperandIndex(operand), length })
            }
            (format::SHAPE_WORD_BIT, (bit, format::NO_OPERAND, length)) if bit != format::NO_BIT => {
                Shape::WordBit(BitNumber::Constant { bit, length })
            }
            (format::SHAPE_BIT..=format::SHAPE_REGION, _) => return Err(DecodeError::BitNumber),
            _ => return Err(DecodeError::Shape),
        };
        Ok(Access { shape, access_type, base, bit_cell, word_cell, count, terms })
    }
}

const NO_BIT_NUMBER: (u8, u32, u8) = (format::NO_BIT, format::NO_OPERAND, 0);
