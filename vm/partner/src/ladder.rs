//! What an image becomes when it is loaded: flat tables of steps and resolved operands, one body for every routine and
//! for every call of an Add-On Instruction. Nothing here changes while a scan runs.

use alloc::vec::Vec;

use twinrung_bytecode::index::{ProgramIndex, RoutineIndex};
use twinrung_catalog::{Element, Opcode};

use crate::panel::Panels;

/// A body of steps.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct BodyIndex(pub(crate) u32);

/// No body, no region.
pub(crate) const NONE: u32 = u32::MAX;

/// What a step does.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Code {
    /// Runs a region of panels in place of the rungs that follow.
    Region,
    /// Begins a rung.
    Rung,
    /// Begins a branch.
    Branch,
    /// Begins the next leg.
    NextLeg,
    /// Ends a branch.
    EndBranch,
    /// An instruction of the catalog that stays on its rung.
    Instruction(Opcode),
    /// A call of an Add-On Instruction.
    AddOn,
    /// A safety application instruction.
    Safety,
    /// Ends the body.
    End,
}

/// One step.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Step {
    /// What it does.
    pub(crate) code: Code,
    /// Arguments.
    pub(crate) count: u8,
    /// The element's place on the rung.
    pub(crate) element: u16,
    /// First argument; the rung's number; at the end of a body its number of rungs; the call, jump or region.
    pub(crate) first: u32,
}

/// A structure that an instruction works on as a whole.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum StructureKind {
    /// TIMER.
    Timer,
    /// COUNTER.
    Counter,
    /// CONTROL.
    Control,
    /// Any other, or an array.
    Other,
}

/// Where data is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Location {
    /// A bit cell.
    Bit(u32),
    /// A word cell.
    Word(u32, Element),
    /// A bit of a word cell; the word's type.
    WordBit(u32, u8, Element),
    /// First cells of a structure or array.
    Region {
        /// First bit cell.
        bit: u32,
        /// First word cell.
        word: u32,
        /// Which structure it is.
        kind: StructureKind,
    },
}

/// An operand, resolved as far as loading can.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Argument {
    /// `?`, text, or whatever an instruction does not read when it runs.
    Nothing,
    /// An integer literal or the value of a word.
    Integer(i32),
    /// A REAL literal's bits.
    Real(u32),
    /// Data in a fixed place.
    At(Location),
    /// Data whose place depends on subscripts; entry of [`Ladder::dynamics`].
    Dynamic(u32),
    /// A status keyword.
    Status(u8),
    /// Entry of [`Ladder::spans`].
    Span(u32),
    /// Entry of [`Ladder::expressions`].
    Expression(u32),
    /// Entry of the image's system values.
    SystemValue(u16),
    /// Entry of the image's event tasks.
    EventTask(u16),
}

/// Data whose place depends on subscripts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Dynamic {
    /// What is reached; its cells are those without the subscripts.
    pub(crate) location: Location,
    /// Code that leaves the address; first operation.
    pub(crate) begin: u32,
    /// One past the last operation.
    pub(crate) end: u32,
}

/// Consecutive elements of one type, as COP, FLL, GSV, SSV and the copies of JSR see them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Span {
    /// `At` or `Dynamic`: the first element.
    pub(crate) start: Argument,
    /// Elements from there to the end of the innermost array.
    pub(crate) count: u32,
    /// The type of its elements, where they are elementary.
    pub(crate) element: Option<Element>,
    /// Bytes of an element.
    pub(crate) bytes: u32,
    /// Bit cells of an element.
    pub(crate) bits: u32,
    /// Word cells of an element.
    pub(crate) words: u32,
    /// Whether subscripts move the start within the innermost array.
    pub(crate) moves: bool,
    /// First of the element's fields in [`Ladder::fields`].
    pub(crate) first_field: u32,
    /// Number of fields.
    pub(crate) fields: u32,
}

/// One field of an element's bytes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Field {
    /// First byte.
    pub(crate) byte: u32,
    /// Bit of it, for a BOOL.
    pub(crate) bit: u8,
    /// Its type.
    pub(crate) element: Element,
    /// Its cell, counted from the element's first.
    pub(crate) cell: u32,
}

/// An operation of an address or expression; the machine has a stack of values and one of addresses.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Operation {
    /// Pushes a DINT.
    Integer(i32),
    /// Pushes a REAL.
    Real(u32),
    /// Pushes the value of a word cell.
    Word(u32, Element),
    /// Pushes an address.
    Address {
        /// Bit cell.
        bit: u32,
        /// Word cell.
        word: u32,
    },
    /// Pops a subscript and moves the topmost address.
    Subscript {
        /// The subscript must be below.
        length: u32,
        /// Bit cells for each.
        bits: u32,
        /// Word cells for each.
        words: u32,
        /// Elements of the innermost array for each; 0 for an outer array.
        elements: u32,
    },
    /// Pops a bit number into the topmost address.
    BitNumber(u8),
    /// Pops an address, pushes the value of its word.
    Load(Element),
    /// Makes the topmost value the 32 bits that bitwise logic works on.
    Pattern,
    /// Pops one or two values, pushes the result.
    Apply {
        /// `format::OPERATION_*`.
        operator: u8,
        /// Whether arithmetic is REAL.
        real: bool,
    },
}

/// An expression.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Expression {
    /// First operation.
    pub(crate) begin: u32,
    /// One past the last.
    pub(crate) end: u32,
}

/// A body.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Body {
    /// The routine, as faults and observers name it.
    pub(crate) routine: RoutineIndex,
    /// Its first step.
    pub(crate) begin: u32,
    /// Whether rungs begin true whatever the MCR override says.
    pub(crate) add_on: bool,
    /// First counter of its backward jumps.
    pub(crate) counter: u32,
    /// Its backward jumps.
    pub(crate) counters: u32,
}

/// An argument that is copied to a parameter when a call begins.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Input {
    /// Which of [`Call::arguments`] it is.
    pub(crate) argument: u32,
    /// The parameter's cell.
    pub(crate) parameter: Location,
}

/// A parameter that is copied to an argument when a call ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Output {
    /// The call's argument.
    pub(crate) argument: Argument,
    /// The parameter's cell.
    pub(crate) parameter: Location,
}

/// A call of an Add-On Instruction.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Call {
    /// What is looked at before anything is written, in declared order: the arguments of Input parameters, and those
    /// with subscripts of Output parameters.
    pub(crate) arguments: Vec<Argument>,
    /// Copied in.
    pub(crate) inputs: Vec<Input>,
    /// Copied out.
    pub(crate) outputs: Vec<Output>,
    /// Bit cell of EnableIn.
    pub(crate) enable_in: u32,
    /// Bit cell of EnableOut.
    pub(crate) enable_out: u32,
    /// Its routines.
    pub(crate) logic: BodyIndex,
    /// Runs at prescan.
    pub(crate) prescan: Option<BodyIndex>,
    /// Runs while the rung is false.
    pub(crate) enable_in_false: Option<BodyIndex>,
    /// For a safety application instruction: which inputs are configuration, set at prescan too.
    pub(crate) configuration: Vec<bool>,
    /// For a safety application instruction: its private state.
    pub(crate) private: PrivateCells,
    /// For a safety application instruction: private bit cell that says that a prescan has reached it since loading.
    pub(crate) prescanned: u32,
}

/// Consecutive cells of the channel's own.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) struct PrivateCells {
    /// First bit cell.
    pub(crate) bit: u32,
    /// Bit cells.
    pub(crate) bits: u32,
    /// First word cell.
    pub(crate) word: u32,
    /// Word cells.
    pub(crate) words: u32,
}

/// A JMP.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Jump {
    /// The step to go on at; [`NONE`] where the label is missing.
    pub(crate) target: u32,
    /// The rung that begins there.
    pub(crate) rung: u32,
    /// Counter of backward jumps; [`NONE`] for a forward jump.
    pub(crate) counter: u32,
}

/// A JSR.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Subroutine {
    /// What it calls.
    pub(crate) body: BodyIndex,
    /// What it passes.
    pub(crate) inputs: Vec<Argument>,
    /// The SBR operands of the routine.
    pub(crate) receivers: Vec<Argument>,
    /// Where RET's operands go.
    pub(crate) returns: Vec<Argument>,
    /// Whether it names the fault routine of its program.
    pub(crate) fault_routine: bool,
}

/// A system value.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct SystemValue {
    /// First position in the values of a scan.
    pub(crate) first: u32,
    /// Values.
    pub(crate) length: u32,
    /// Bytes of each.
    pub(crate) width: u32,
    /// For MajorFaultRecord: whose.
    pub(crate) record_of: Option<ProgramIndex>,
}

/// A program.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Program {
    /// Its main routine.
    pub(crate) main: Option<BodyIndex>,
    /// Its fault routine.
    pub(crate) fault: Option<BodyIndex>,
    /// Whether the task skips it.
    pub(crate) disabled: bool,
}

/// Cells of the channel's own that have a meaning for rungs.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) struct OwnCells {
    /// Always true.
    pub(crate) true_bit: u32,
    /// Always false.
    pub(crate) false_bit: u32,
    /// The MCR override.
    pub(crate) override_bit: u32,
    /// S:FS.
    pub(crate) first_scan_bit: u32,
}

/// A loaded application.
#[derive(Debug, Clone)]
pub(crate) struct Ladder {
    /// All steps, body after body.
    pub(crate) steps: Vec<Step>,
    /// All arguments.
    pub(crate) arguments: Vec<Argument>,
    /// Places that depend on subscripts.
    pub(crate) dynamics: Vec<Dynamic>,
    /// Consecutive elements.
    pub(crate) spans: Vec<Span>,
    /// Fields of elements.
    pub(crate) fields: Vec<Field>,
    /// Operations of addresses and expressions.
    pub(crate) operations: Vec<Operation>,
    /// Expressions.
    pub(crate) expressions: Vec<Expression>,
    /// Bodies.
    pub(crate) bodies: Vec<Body>,
    /// Calls of Add-On Instructions and safety application instructions.
    pub(crate) calls: Vec<Call>,
    /// JMPs.
    pub(crate) jumps: Vec<Jump>,
    /// Counters of backward jumps.
    pub(crate) counters: u32,
    /// JSRs.
    pub(crate) subroutines: Vec<Subroutine>,
    /// System values.
    pub(crate) system_values: Vec<SystemValue>,
    /// Programs.
    pub(crate) programs: Vec<Program>,
    /// Programs in the order in which they run.
    pub(crate) schedule: Vec<ProgramIndex>,
    /// Panels and what stands between them.
    pub(crate) panels: Panels,
    /// Cells with a meaning.
    pub(crate) own: OwnCells,
    /// Initial bits, private cells included.
    pub(crate) initial_bits: Vec<bool>,
    /// Initial words, private cells included.
    pub(crate) initial_words: Vec<i32>,
}

impl Ladder {
    /// The arguments of a step.
    pub(crate) fn arguments(&self, step: Step) -> &[Argument] {
        let begin = step.first as usize;
        self.arguments.get(begin..begin.saturating_add(usize::from(step.count))).unwrap_or(&[])
    }

    /// A step; the end of a body where there is none.
    pub(crate) fn step(&self, position: u32) -> Step {
        const END: Step = Step { code: Code::End, count: 0, element: 0, first: 0 };
        self.steps.get(position as usize).copied().unwrap_or(END)
    }
}
