//! The application in this channel's own form: everything that loading fixes and a scan only reads.

use alloc::vec::Vec;

use twinrung_catalog::{Element, Opcode};

use crate::lower::table::Tables;

/// No formula, step, body or cell.
pub(crate) const NONE: u32 = u32::MAX;

/// A range of one of the program's tables.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) struct Range {
    pub(crate) first: u32,
    pub(crate) count: u32,
}

impl Range {
    /// The entries of the range; none when the table is shorter.
    pub(crate) fn of<T>(self, table: &[T]) -> &[T] {
        let first = self.first as usize;
        table.get(first..first.saturating_add(self.count as usize)).unwrap_or(&[])
    }

    /// The range of what was pushed onto a table since it had `first` entries.
    pub(crate) fn since<T>(first: usize, table: &[T]) -> Range {
        Range { first: first as u32, count: table.len().saturating_sub(first) as u32 }
    }
}

/// Where data is: cells, and the formula that gives them where a subscript varies.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Location {
    /// Bit cell without variable subscripts.
    pub(crate) bit: u32,
    /// Word cell without variable subscripts.
    pub(crate) word: u32,
    /// Formula that leaves an address, or [`NONE`].
    pub(crate) formula: u32,
}

/// What a region is made of.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Content {
    /// Elements of an elementary type.
    Element(Element),
    /// Structures; index into the image's types.
    Structure(u16),
}

/// Which bit of a word.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum BitNumber {
    Constant(u8),
    /// The formula that gives the number, and how many bits the word has.
    Variable {
        formula: u32,
        length: u8,
    },
}

/// An operand, bound to absolute cells.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Operand {
    /// `?`, a label, a system name: nothing that an instruction reads when it runs.
    Nothing,
    /// An integer literal, a choice, a constant of the declaration.
    Integer(i32),
    /// A REAL literal.
    Real(f32),
    /// A routine: its body.
    Routine(u32),
    /// A status keyword.
    Status(u8),
    /// A system value.
    SystemValue(u16),
    /// An event task.
    EventTask(u16),
    /// An expression.
    Expression { formula: u32, real: bool, overflows: bool },
    /// A bit cell.
    Bit(Location),
    /// A word cell, the first of `count` in its array.
    Word { location: Location, element: Element, count: u32 },
    /// A bit of a word cell.
    WordBit { location: Location, number: BitNumber, element: Element },
    /// A structure or a whole array, of so many cells; `count` elements of `content` lie from here to the end of the
    /// array that it is in.
    Region { location: Location, content: Content, count: u32, bit_cells: u32, word_cells: u32 },
}

impl Operand {
    /// The location, for data.
    pub(crate) fn location(self) -> Option<Location> {
        match self {
            Operand::Bit(location)
            | Operand::Word { location, .. }
            | Operand::WordBit { location, .. }
            | Operand::Region { location, .. } => Some(location),
            _ => None,
        }
    }

    /// Whether reaching it needs no computation, so that it cannot fault.
    pub(crate) fn is_fixed(self) -> bool {
        let bit_fixed = match self {
            Operand::WordBit { number, .. } => matches!(number, BitNumber::Constant(_)),
            _ => true,
        };
        bit_fixed && self.location().is_none_or(|location| location.formula == NONE)
    }
}

/// One operation of a formula. Formulas run on two small stacks, one of values and one of addresses.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum FormulaOperation {
    /// Push an integer, or the bits of a REAL.
    Push(i32),
    /// Push a word cell.
    Load { word: u32 },
    /// Push the word cell of the top address, which is dropped.
    LoadAddress,
    /// Push an address.
    Address { bit: u32, word: u32 },
    /// Take a value, fault unless it is below `length`, and add so many strides to the top address.
    Index { length: u32, bit_stride: u32, word_stride: u32, elements: u32 },
    /// Zeros instead of the sign of the top value, a SINT or INT.
    ZeroFill(Element),
    /// The top value, an integer, as REAL.
    ToReal,
    /// The top value, a REAL, as integer.
    ToInteger,
    /// An operator of the image format; whether on REAL.
    Apply { operator: u8, real: bool },
}

/// An instruction of the catalog.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Instruction {
    pub(crate) opcode: Opcode,
    pub(crate) operands: Range,
    /// Its place on the rung.
    pub(crate) element: u32,
    /// JMP: jump; COP, FLL, GSV, SSV: copy plan; safety application instruction: call; else unused.
    pub(crate) extra: u32,
}

/// What a rung is made of, in the order of the text.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Code {
    Rung,
    EndRung,
    Branch,
    NextLeg,
    EndBranch,
    /// Index into [`Program::instructions`].
    Instruction(u32),
    /// Index into [`Program::calls`].
    AddOn(u32),
}

/// A routine of a program, or a routine of an Add-On Instruction for one call.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Body {
    /// The routine of the image.
    pub(crate) routine: u32,
    /// Its codes.
    pub(crate) codes: Range,
    /// Its steps; empty where it only ever runs in the order of the text.
    pub(crate) steps: Range,
    /// Whether it belongs to a program, whose rungs begin under the MCR override.
    pub(crate) of_program: bool,
    /// Whether it has steps.
    pub(crate) stepped: bool,
    /// Its parameters, where its first rung begins with SBR: the instruction.
    pub(crate) parameters: u32,
    /// Its JMPs; none where no JMP jumps backward.
    pub(crate) jumps: Range,
}

/// A rung that a JMP reaches.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Label {
    /// Position of its rung among the codes.
    pub(crate) code: u32,
    /// The rung.
    pub(crate) rung: u32,
    /// Position of its rung among the steps.
    pub(crate) step: u32,
}

/// A JMP: where to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Jump {
    pub(crate) label: u32,
    /// Whether to its own or an earlier rung.
    pub(crate) backward: bool,
}

/// A call of an Add-On Instruction.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct AddOnCall {
    /// Its place on the rung.
    pub(crate) element: u32,
    /// Bit cell of EnableIn.
    pub(crate) enable_in: u32,
    /// Bit cell of EnableOut.
    pub(crate) enable_out: u32,
    /// Input parameters.
    pub(crate) inputs: Range,
    /// Output parameters.
    pub(crate) outputs: Range,
    /// Those of both whose argument has a variable subscript or bit number, in the order of the call.
    pub(crate) varying: Range,
    pub(crate) logic: u32,
    /// Body of the Prescan routine, or [`NONE`].
    pub(crate) prescan: u32,
    /// Body of the EnableInFalse routine, or [`NONE`].
    pub(crate) enable_in_false: u32,
}

/// An argument of an Add-On call and the parameter's own cell: indices of operands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Argument {
    pub(crate) outside: u32,
    pub(crate) inside: u32,
}

/// What COP or FLL moves; for GSV and SSV both sides are the data, as many elements as hold the attribute.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct CopyPlan {
    /// Elements of the destination.
    pub(crate) length: u32,
    pub(crate) source: Side,
    pub(crate) destination: Side,
}

impl CopyPlan {
    /// Bytes of the destination.
    pub(crate) fn bytes(self) -> u32 {
        self.length.saturating_mul(self.destination.bytes)
    }

    /// Elements of the source that hold them.
    pub(crate) fn source_length(self) -> u32 {
        self.bytes().checked_div(self.source.bytes).unwrap_or(0)
    }
}

/// One side of a copy: what one element is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Side {
    /// Bytes of one element.
    pub(crate) bytes: u32,
    /// Cells of one element.
    pub(crate) bit_cells: u32,
    pub(crate) word_cells: u32,
    /// Its fields.
    pub(crate) fields: Range,
    pub(crate) content: Content,
    /// Elements from a fixed start to the end of the array.
    pub(crate) count: u32,
}

impl Side {
    /// Whether so many elements lie in the array behind those that variable subscripts skipped.
    pub(crate) fn holds(self, skipped: u32, length: u32) -> bool {
        skipped.saturating_add(length) <= self.count
    }
}

/// A call of a safety application instruction.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct SafetyCall {
    pub(crate) opcode: Opcode,
    /// Its state in the library.
    pub(crate) state: u32,
    /// First cells of the backing tag.
    pub(crate) bit: u32,
    pub(crate) word: u32,
}

/// A program of the image.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct ProgramEntry {
    /// Body of the main routine, or [`NONE`].
    pub(crate) main: u32,
    /// Body of the fault routine, or [`NONE`].
    pub(crate) fault: u32,
    pub(crate) disabled: bool,
}

/// A system value.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct SystemValue {
    /// Whether it is a program's MajorFaultRecord, and of which program.
    pub(crate) record_of: Option<u16>,
    /// First position in the values that a scan receives.
    pub(crate) first: u32,
    /// Number of its elements.
    pub(crate) length: u32,
    /// Bytes of one element.
    pub(crate) element_bytes: u32,
}

impl SystemValue {
    /// Bytes of all its elements.
    pub(crate) fn bytes(self) -> u32 {
        self.length.saturating_mul(self.element_bytes)
    }
}

/// One step of a body that runs lowered.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Step {
    /// Runs of uniform work; they stand for so many instructions of the text.
    Block { runs: Range, instructions: u32 },
    /// An instruction that may fault or change the flow.
    Single(Single),
    /// The end of the body, which has so many rungs.
    End { rungs: u32 },
}

/// An instruction that stands alone among the steps.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Single {
    /// Its position among the codes.
    pub(crate) code: u32,
    /// Its rung.
    pub(crate) rung: u32,
    /// Cell with its rung condition.
    pub(crate) input: u32,
    /// Cell for the rung condition after it.
    pub(crate) output: u32,
    /// Branches open around it.
    pub(crate) depth: u32,
    /// The step with which the next rung begins.
    pub(crate) resume: u32,
}

/// Everything that loading fixes.
#[derive(Debug, Clone, Default)]
pub(crate) struct Program {
    pub(crate) codes: Vec<Code>,
    pub(crate) instructions: Vec<Instruction>,
    pub(crate) operands: Vec<Operand>,
    pub(crate) formulas: Vec<Range>,
    pub(crate) formula_operations: Vec<FormulaOperation>,
    pub(crate) bodies: Vec<Body>,
    pub(crate) labels: Vec<Label>,
    pub(crate) jumps: Vec<Jump>,
    pub(crate) calls: Vec<AddOnCall>,
    pub(crate) arguments: Vec<Argument>,
    pub(crate) copies: Vec<CopyPlan>,
    pub(crate) fields: Vec<twinrung_bytecode::layout::Field>,
    pub(crate) safety_calls: Vec<SafetyCall>,
    pub(crate) programs: Vec<ProgramEntry>,
    pub(crate) schedule: Vec<u16>,
    pub(crate) system_values: Vec<SystemValue>,
    pub(crate) steps: Vec<Step>,
    pub(crate) tables: Tables,
    /// Cells of the image; the banks hold more behind them.
    pub(crate) bit_cells: u32,
    pub(crate) word_cells: u32,
    /// Bit cell that is 0 while the MCR override is on.
    pub(crate) rail: u32,
    /// Bit cell that shows S:FS.
    pub(crate) first_scan: u32,
    /// Bit cells that are always 0 and always 1.
    pub(crate) zero: u32,
    pub(crate) one: u32,
    /// TIMER structures that timer instructions use by fixed reference in steps: their PRE cells.
    pub(crate) watched_timers: Vec<u32>,
}

impl Program {
    /// The operand with this index.
    pub(crate) fn operand_at(&self, index: u32) -> Operand {
        self.operands.get(index as usize).copied().unwrap_or(Operand::Nothing)
    }

    /// An operand of an instruction.
    pub(crate) fn operand(&self, operands: Range, index: usize) -> Operand {
        operands.of(&self.operands).get(index).copied().unwrap_or(Operand::Nothing)
    }
}
