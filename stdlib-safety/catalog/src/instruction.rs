//! What an instruction is: the shape of one row of the certified set.

use crate::code::Code;
use crate::execution::{Execution, execution};
use crate::operand::Operand;
use crate::predefined::PredefinedType;

pub use crate::instructions::Opcode;

/// One admitted instruction.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Instruction {
    /// The number that stands for this instruction in an image.
    pub opcode: Opcode,
    /// The mnemonic as canonical text prints it.
    pub mnemonic: &'static str,
    /// Other mnemonics that newer exports write for the same instruction (`EQ` for `EQU`). Read, never printed.
    pub also: &'static [&'static str],
    /// The full name.
    pub name: &'static str,
    /// The group of the manual's tables.
    pub group: Group,
    /// First programming-software version that admits it in safety logic.
    pub first_version: u8,
    /// What a controller must offer.
    pub requires: Requires,
    /// Where the admission stands, e.g. `1756-RM093 Table 12`.
    pub source: &'static str,
    /// Where it may stand on a rung and what it does to the rung condition.
    pub position: Position,
    /// Whether it acts, or checks subscripts, when the rung condition is false.
    pub transitional: bool,
    /// The operands in neutral-text order. A trailing operand with [`Operand::repeats`] may occur any number of times.
    pub operands: &'static [Operand],
    /// One sentence for `explain`.
    pub summary: &'static str,
    /// What it does with a true and a false rung and in a prescan, for `explain`.
    pub execution: Execution,
    /// For safety application instructions: the rest of the declaration.
    pub safety: Option<&'static SafetyApplication>,
}

/// What most base instructions have in common: the rest of a declaration says what is its own. Its opcode, names and texts
/// are to be replaced.
pub(crate) const fn base(group: Group, position: Position) -> Instruction {
    Instruction {
        opcode: Opcode::Nop,
        mnemonic: "",
        also: &[],
        name: "",
        group,
        first_version: 14,
        requires: Requires::Any,
        source: "1756-RM093 Table 12",
        position,
        transitional: false,
        operands: &[],
        summary: "",
        execution: execution("", "", "", ""),
        safety: None,
    }
}

/// The operands of safety application instructions that say whether the data of their other operands is valid.
pub const STATUS_OPERANDS: &[&str] = &["Input Status", "Output Status"];

/// What a safety application instruction has beyond a base instruction.
#[derive(Debug, PartialEq, Eq)]
pub struct SafetyApplication {
    /// The type of its backing tag.
    pub backing: &'static PredefinedType,
    /// For each operand after the backing tag, in order: the member of the backing tag that mirrors it, or `""`.
    pub mirrored: &'static [&'static str],
    /// Names of the operands without which no output comes on: what they carry decides whether the outputs are of safety
    /// origin. The other inputs (a reset, a status) can spoil an output, and do not qualify it. (decided, from the
    /// conditions for O1 in the reference)
    pub decides: &'static [&'static str],
    /// Names of the operands that are the channels of one device, which the instruction compares with each other; none
    /// where it evaluates no redundant inputs.
    pub channels: &'static [&'static str],
    /// Names of the operands that take no unqualified data: channels, contacts, feedbacks, and what opens a guard or mutes
    /// a device. dual-channel-inputs.md C7 and C8; the like of other families decided.
    pub safety_only: &'static [&'static str],
    /// Rules that bind several operands of one call together, or the task; checked when compiled.
    pub relations: &'static [Relation],
    /// The codes it can show, fault words first; 0 (nothing to report) is not listed.
    pub codes: &'static [Code],
    /// The reference file and section that specifies it, e.g. `dual-channel-inputs.md 4`.
    pub reference: &'static str,
    /// What it guards and how, in a few sentences, for `explain`.
    pub purpose: &'static str,
}

/// A rule between operands of one call, by operand name; checked when compiled.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Relation {
    /// The two operands must be different tags (dual-channel-inputs.md D20).
    DifferentTags(&'static str, &'static str),
    /// The first literal must not be 0 while the choice operand has this value.
    NotZeroWhen(&'static str, &'static str, i32),
    /// The first literal must be below the second, unless the second is 0.
    BelowUnlessZero(&'static str, &'static str),
    /// The first immediate must not be above the second (where both are immediates).
    NotAbove(&'static str, &'static str),
    /// The period of the safety task must not be longer, in ms.
    PeriodAtMost(u32),
}

/// The groups of the manual's tables.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Group {
    /// Contacts, coils and one-shots.
    Bit,
    /// Timers, counters and their reset.
    TimerCounter,
    /// Comparisons.
    Compare,
    /// Moves and copies.
    Move,
    /// Bitwise logic.
    Logical,
    /// Arithmetic.
    Math,
    /// Array (file) instructions.
    Array,
    /// Jumps, subroutines, zones.
    ProgramControl,
    /// System values.
    InputOutput,
    /// Safety application instructions of Tables 10 and 11.
    SafetyApplication,
    /// The metal-form set.
    MetalForm,
    /// The version-14 safety set.
    SafetyApplicationV14,
}

impl Group {
    /// Whether the two halves of the safety library, and not the interpreters themselves, execute this group.
    pub const fn is_safety_library(self) -> bool {
        matches!(self, Group::SafetyApplication | Group::MetalForm | Group::SafetyApplicationV14)
    }
}

/// What a controller must offer for an instruction to be admitted.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Requires {
    /// Any safety controller.
    Any,
    /// Footnote 1 of Table 12: 1756-L7xS and the families that take what it takes.
    L7x,
    /// Only where safety REAL is allowed.
    Real,
}

/// Where an instruction may stand and what it does to the rung condition.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Position {
    /// Computes the rung condition from its operands.
    Input,
    /// Acts, and passes the rung condition through.
    Output,
    /// Ends the rung's path when it acts (JMP, RET, TND): nothing after it runs.
    Ending,
    /// First element of a rung (LBL, SBR).
    First,
}

impl Instruction {
    /// Finds an instruction by its mnemonic or by a newer name for it; upper and lower case are the same.
    pub fn by_mnemonic(mnemonic: &str) -> Option<&'static Instruction> {
        crate::instructions::ALL.iter().copied().find(|instruction| {
            instruction.mnemonic.eq_ignore_ascii_case(mnemonic)
                || instruction.also.iter().any(|also| also.eq_ignore_ascii_case(mnemonic))
        })
    }

    /// Finds an instruction by its number in an image.
    pub fn by_number(number: u8) -> Option<&'static Instruction> {
        crate::instructions::ALL.iter().copied().find(|instruction| instruction.opcode as u8 == number)
    }

    /// The least and the greatest number of operands that a call may have; `None` where the number has no limit here.
    pub fn operand_count(&self) -> (usize, Option<usize>) {
        let repeated = self.operands.last().is_some_and(|last| last.repeats);
        if repeated { (self.operands.len() - 1, None) } else { (self.operands.len(), Some(self.operands.len())) }
    }

    /// The declaration of the operand at `index`, counting a repeated last operand as often as it occurs.
    pub fn operand(&self, index: usize) -> Option<&'static Operand> {
        self.operands.get(index).or_else(|| self.operands.last().filter(|last| last.repeats))
    }
}

impl Opcode {
    /// The declaration of this instruction.
    pub fn instruction(self) -> &'static Instruction {
        crate::instructions::declaration(self)
    }
}
