//! The code of a routine, mark by mark, as [`mod@crate::format`] describes it.

use twinrung_catalog::Instruction;

use crate::format;
use crate::index::OperandIndex;

/// One mark of the code.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Mark<'a> {
    /// Begins a rung.
    Rung,
    /// Ends a rung.
    EndRung,
    /// Begins a branch and its first leg.
    Branch,
    /// Ends a leg and begins the next.
    NextLeg,
    /// Ends a branch.
    EndBranch,
    /// An instruction of the catalog.
    Instruction(&'static Instruction, Operands<'a>),
    /// A call of an Add-On Instruction; the first operand is the instance.
    AddOn(Operands<'a>),
}

/// Why a byte of the code is none.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CodeError {
    /// No instruction or mark has this number.
    UnknownOpcode {
        /// The byte in the routine's code.
        offset: usize,
        /// The number.
        opcode: u8,
    },
    /// The code ends within an element.
    Truncated {
        /// The byte in the routine's code.
        offset: usize,
    },
}

/// The operands of one element.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Operands<'a>(&'a [[u8; 4]]);

impl<'a> Operands<'a> {
    /// How many.
    pub fn len(self) -> usize {
        self.0.len()
    }

    /// Whether there is none.
    pub fn is_empty(self) -> bool {
        self.0.is_empty()
    }

    /// The operand at a position.
    pub fn get(self, position: usize) -> Option<OperandIndex> {
        self.0.get(position).map(|bytes| OperandIndex(u32::from_le_bytes(*bytes)))
    }

    /// All of them.
    pub fn iter(self) -> impl ExactSizeIterator<Item = OperandIndex> + 'a {
        self.0.iter().map(|bytes| OperandIndex(u32::from_le_bytes(*bytes)))
    }
}

/// Reads marks up to the end of the code, or to the first error.
#[derive(Debug, Clone)]
pub struct Marks<'a> {
    rest: &'a [u8],
    offset: usize,
}

impl<'a> Marks<'a> {
    /// The marks of a routine's code.
    pub fn new(code: &'a [u8]) -> Marks<'a> {
        Marks { rest: code, offset: 0 }
    }

    /// Where the next mark begins in the code.
    pub fn offset(&self) -> usize {
        self.offset
    }

    fn take(&mut self, count: usize) -> Option<&'a [u8]> {
        let (piece, rest) = self.rest.split_at_checked(count)?;
        self.rest = rest;
        self.offset = self.offset.saturating_add(count);
        Some(piece)
    }

    fn operands(&mut self) -> Option<Operands<'a>> {
        let count = usize::from(*self.take(1)?.first()?);
        let bytes = self.take(count.saturating_mul(4))?;
        Some(Operands(bytes.as_chunks().0))
    }

    fn mark(&mut self) -> Result<Mark<'a>, CodeError> {
        let offset = self.offset;
        let truncated = CodeError::Truncated { offset };
        let opcode = self.take(1).and_then(|byte| byte.first().copied()).ok_or(truncated)?;
        Ok(match opcode {
            format::RUNG => Mark::Rung,
            format::END_RUNG => Mark::EndRung,
            format::BRANCH => Mark::Branch,
            format::NEXT_LEG => Mark::NextLeg,
            format::END_BRANCH => Mark::EndBranch,
            format::ADD_ON => Mark::AddOn(self.operands().ok_or(truncated)?),
            _ => {
                let known = twinrung_catalog::Opcode::from_number(opcode);
                let known = known.ok_or(CodeError::UnknownOpcode { offset, opcode })?;
                Mark::Instruction(known.instruction(), self.operands().ok_or(truncated)?)
            }
        })
    }
}

impl<'a> Iterator for Marks<'a> {
    type Item = Result<Mark<'a>, CodeError>;

    fn next(&mut self) -> Option<Self::Item> {
        if self.rest.is_empty() {
            return None;
        }
        let mark = self.mark();
        if mark.is_err() {
            self.rest = &[];
        }
        Some(mark)
    }
}
