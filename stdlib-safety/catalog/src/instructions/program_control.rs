//! Program control. general-instructions.md A.8.

use crate::execution::{NOTHING, execution};
use crate::instruction::{Group, Instruction, Opcode, Position, base};
use crate::operand::{
    Access,
    OperandKind::{EventTask, InputCount, Label, LabelDefinition, Parameter, Routine},
    operand, repeated,
};

/// Jump to label.
pub static JMP: Instruction = Instruction {
    opcode: Opcode::Jmp,
    mnemonic: "JMP",
    name: "Jump To Label",
    operands: &[operand("Label Name", Label)],
    summary: "Continues at the rung with the label.",
    execution: execution(
        "Goes on at the rung with the label; the rungs between are not executed at all: bits keep their values, \
         timers get no update.",
        "Nothing.",
        "Does not jump: every rung is visited.",
        "Major fault 4/94 when one execution of its routine would jump backward more than 1,000 times.",
    ),
    ..base(Group::ProgramControl, Position::Ending)
};

/// Label.
pub static LBL: Instruction = Instruction {
    opcode: Opcode::Lbl,
    mnemonic: "LBL",
    name: "Label",
    operands: &[operand("Label Name", LabelDefinition)],
    summary: "Names a rung that JMP can reach.",
    execution: execution("Passes the rung condition on.", "Passes the rung condition on.", NOTHING, ""),
    ..base(Group::ProgramControl, Position::First)
};

/// Jump to subroutine.
pub static JSR: Instruction = Instruction {
    opcode: Opcode::Jsr,
    mnemonic: "JSR",
    name: "Jump to Subroutine",
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
    ..base(Group::ProgramControl, Position::Output)
};

/// Subroutine.
pub static SBR: Instruction = Instruction {
    opcode: Opcode::Sbr,
    mnemonic: "SBR",
    name: "Subroutine",
    operands: &[repeated("Input Parameter", Parameter(Access::Write))],
    summary: "Receives the inputs of a JSR.",
    execution: execution(
        "Receives the inputs of the JSR; passes the rung condition on.",
        "Passes the rung condition on.",
        NOTHING,
        "",
    ),
    ..base(Group::ProgramControl, Position::First)
};

/// Return.
pub static RET: Instruction = Instruction {
    opcode: Opcode::Ret,
    mnemonic: "RET",
    name: "Return",
    operands: &[repeated("Return Parameter", Parameter(Access::Read))],
    summary: "Ends the routine and hands values back.",
    execution: execution(
        "Ends the routine and hands its values back to the JSR. In a main routine it ends the program.",
        "Nothing.",
        "Does not return: every rung is visited.",
        "",
    ),
    ..base(Group::ProgramControl, Position::Ending)
};

/// Temporary end.
pub static TND: Instruction = Instruction {
    opcode: Opcode::Tnd,
    mnemonic: "TND",
    name: "Temporary End",
    operands: &[],
    summary: "Ends the routine.",
    execution: execution(
        "Ends the routine: a subroutine returns, a main routine ends its program. The rest of the rung is not \
         executed.",
        "Nothing.",
        "Does not end the routine.",
        "",
    ),
    ..base(Group::ProgramControl, Position::Ending)
};

/// Master control reset.
pub static MCR: Instruction = Instruction {
    opcode: Opcode::Mcr,
    mnemonic: "MCR",
    name: "Master Control Reset",
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
    ..base(Group::ProgramControl, Position::Output)
};

/// Always false.
pub static AFI: Instruction = Instruction {
    opcode: Opcode::Afi,
    mnemonic: "AFI",
    name: "Always False Instruction",
    operands: &[],
    summary: "Makes the rung false.",
    execution: execution("Is false.", "Is false.", NOTHING, ""),
    ..base(Group::ProgramControl, Position::Input)
};

/// No operation.
pub static NOP: Instruction = Instruction {
    opcode: Opcode::Nop,
    mnemonic: "NOP",
    name: "No Operation",
    operands: &[],
    summary: "Does nothing.",
    execution: execution("Nothing.", "Nothing.", NOTHING, ""),
    ..base(Group::ProgramControl, Position::Output)
};

/// Trigger event task.
pub static EVENT: Instruction = Instruction {
    opcode: Opcode::Event,
    mnemonic: "EVENT",
    name: "Trigger Event Task",
    first_version: 20,
    operands: &[operand("Task", EventTask)],
    summary: "Triggers one execution of a standard event task.",
    execution: execution(
        "Triggers the task once, in every scan in which the rung is true: put a one shot before it. The task runs \
         after the outputs of the safety task are written.",
        "Nothing.",
        NOTHING,
        "",
    ),
    ..base(Group::ProgramControl, Position::Output)
};
