//! Program control. general-instructions.md A.8.

use crate::execution::{NOTHING, execution};
use crate::instruction::{Group, Instruction, Opcode, Position, Requires};
use crate::operand::{
    Access,
    OperandKind::{EventTask, InputCount, Label, LabelDefinition, Parameter, Routine},
    operand, repeated,
};

/// Jump to label.
pub static JMP: Instruction = Instruction {
    opcode: Opcode::Jmp,
    mnemonic: "JMP",
    also: &[],
    name: "Jump To Label",
    group: Group::ProgramControl,
    first_version: 14,
    requires: Requires::Any,
    source: "1756-RM093 Table 12",
    position: Position::Ending,
    transitional: false,
    operands: &[operand("Label Name", Label)],
    summary: "Continues at the rung with the label.",
    execution: execution(
        "Goes on at the rung with the label; the rungs between are not executed at all: bits keep their values, \
         timers get no update.",
        "Nothing.",
        "Does not jump: every rung is visited.",
        "Major fault 4/94 when one execution of its routine would jump backward more than 1,000 times.",
    ),
    safety: None,
};

/// Label.
pub static LBL: Instruction = Instruction {
    opcode: Opcode::Lbl,
    mnemonic: "LBL",
    also: &[],
    name: "Label",
    group: Group::ProgramControl,
    first_version: 14,
    requires: Requires::Any,
    source: "1756-RM093 Table 12",
    position: Position::First,
    transitional: false,
    operands: &[operand("Label Name", LabelDefinition)],
    summary: "Names a rung that JMP can reach.",
    execution: execution("Passes the rung condition on.", "Passes the rung condition on.", NOTHING, ""),
    safety: None,
};

/// Jump to subroutine.
pub static JSR: Instruction = Instruction {
    opcode: Opcode::Jsr,
    mnemonic: "JSR",
    also: &[],
    name: "Jump to Subroutine",
    group: Group::ProgramControl,
    first_version: 14,
    requires: Requires::Any,
    source: "1756-RM093 Table 12",
    position: Position::Output,
    transitional: false,
    operands: &[
        operand("Routine Name", Routine),
        operand("Number of Inputs", InputCount),
        repeated("Parameter", Parameter(Access::ReadWrite)),
    ],
    summary: "Runs another routine of the program.",
    execution: execution(
        "Copies the inputs to the parameters of SBR, runs the routine, copies the values of RET to the return \
         parameters, and goes on.",
        "Nothing: the routine does not run.",
        "Prescans the routine, once for all its calls; no parameters are passed.",
        "",
    ),
    safety: None,
};

/// Subroutine.
pub static SBR: Instruction = Instruction {
    opcode: Opcode::Sbr,
    mnemonic: "SBR",
    also: &[],
    name: "Subroutine",
    group: Group::ProgramControl,
    first_version: 14,
    requires: Requires::Any,
    source: "1756-RM093 Table 12",
    position: Position::First,
    transitional: false,
    operands: &[repeated("Input Parameter", Parameter(Access::Write))],
    summary: "Receives the inputs of a JSR.",
    execution: execution(
        "Receives the inputs of the JSR; passes the rung condition on.",
        "Passes the rung condition on.",
        NOTHING,
        "",
    ),
    safety: None,
};

/// Return.
pub static RET: Instruction = Instruction {
    opcode: Opcode::Ret,
    mnemonic: "RET",
    also: &[],
    name: "Return",
    group: Group::ProgramControl,
    first_version: 14,
    requires: Requires::Any,
    source: "1756-RM093 Table 12",
    position: Position::Ending,
    transitional: false,
    operands: &[repeated("Return Parameter", Parameter(Access::Read))],
    summary: "Ends the routine and hands values back.",
    execution: execution(
        "Ends the routine and hands its values back to the JSR. In a main routine it ends the program.",
        "Nothing.",
        "Does not return: every rung is visited.",
        "",
    ),
    safety: None,
};

/// Temporary end.
pub static TND: Instruction = Instruction {
    opcode: Opcode::Tnd,
    mnemonic: "TND",
    also: &[],
    name: "Temporary End",
    group: Group::ProgramControl,
    first_version: 14,
    requires: Requires::Any,
    source: "1756-RM093 Table 12",
    position: Position::Ending,
    transitional: false,
    operands: &[],
    summary: "Ends the routine.",
    execution: execution(
        "Ends the routine: a subroutine returns, a main routine ends its program. The rest of the rung is not \
         executed.",
        "Nothing.",
        "Does not end the routine.",
        "",
    ),
    safety: None,
};

/// Master control reset.
pub static MCR: Instruction = Instruction {
    opcode: Opcode::Mcr,
    mnemonic: "MCR",
    also: &[],
    name: "Master Control Reset",
    group: Group::ProgramControl,
    first_version: 14,
    requires: Requires::Any,
    source: "1756-RM093 Table 12",
    position: Position::Output,
    transitional: true,
    operands: &[],
    summary: "Begins or ends a zone whose rungs all start false.",
    execution: execution(
        "Nothing.",
        "Begins a zone, or ends the one that is open. Within a zone every rung starts false: OTE clears, OTL and \
         OTU leave, timers and counters see a false rung, JSR and JMP do nothing.",
        "Does not begin a zone.",
        "",
    ),
    safety: None,
};

/// Always false.
pub static AFI: Instruction = Instruction {
    opcode: Opcode::Afi,
    mnemonic: "AFI",
    also: &[],
    name: "Always False Instruction",
    group: Group::ProgramControl,
    first_version: 14,
    requires: Requires::Any,
    source: "1756-RM093 Table 12",
    position: Position::Input,
    transitional: false,
    operands: &[],
    summary: "Makes the rung false.",
    execution: execution("Is false.", "Is false.", NOTHING, ""),
    safety: None,
};

/// No operation.
pub static NOP: Instruction = Instruction {
    opcode: Opcode::Nop,
    mnemonic: "NOP",
    also: &[],
    name: "No Operation",
    group: Group::ProgramControl,
    first_version: 14,
    requires: Requires::Any,
    source: "1756-RM093 Table 12",
    position: Position::Output,
    transitional: false,
    operands: &[],
    summary: "Does nothing.",
    execution: execution("Nothing.", "Nothing.", NOTHING, ""),
    safety: None,
};

/// Trigger event task.
pub static EVENT: Instruction = Instruction {
    opcode: Opcode::Event,
    mnemonic: "EVENT",
    also: &[],
    name: "Trigger Event Task",
    group: Group::ProgramControl,
    first_version: 20,
    requires: Requires::Any,
    source: "1756-RM093 Table 12",
    position: Position::Output,
    transitional: false,
    operands: &[operand("Task", EventTask)],
    summary: "Triggers one execution of a standard event task.",
    execution: execution(
        "Triggers the task once, in every scan in which the rung is true: put a one shot before it. The task runs \
         after the outputs of the safety task are written.",
        "Nothing.",
        NOTHING,
        "",
    ),
    safety: None,
};
