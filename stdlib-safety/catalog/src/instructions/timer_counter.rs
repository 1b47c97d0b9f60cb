//! Timers, counters and RES. general-instructions.md A.2 and A.3.

use crate::instruction::{Group, Instruction, Opcode, Position, Requires};
use crate::operand::{
    Access,
    OperandKind::{Pseudo, Resettable, Structure},
    operand,
};
use crate::types::base::{COUNTER, TIMER};

/// Timer on delay.
pub static TON: Instruction = Instruction {
    opcode: Opcode::Ton,
    mnemonic: "TON",
    also: &[],
    name: "Timer On Delay",
    group: Group::TimerCounter,
    first_version: 14,
    requires: Requires::Any,
    source: "1756-RM093 Table 12",
    position: Position::Output,
    transitional: true,
    operands: &[
        operand("Timer", Structure(&TIMER, Access::ReadWrite)),
        operand("Preset", Pseudo("PRE")),
        operand("Accum", Pseudo("ACC")),
    ],
    summary: "Sets DN after the rung has been true for PRE ms; the first true execution adds no time.",
    safety: None,
};

/// Timer off delay.
pub static TOF: Instruction = Instruction {
    opcode: Opcode::Tof,
    mnemonic: "TOF",
    also: &[],
    name: "Timer Off Delay",
    group: Group::TimerCounter,
    first_version: 14,
    requires: Requires::Any,
    source: "1756-RM093 Table 12",
    position: Position::Output,
    transitional: true,
    operands: &[
        operand("Timer", Structure(&TIMER, Access::ReadWrite)),
        operand("Preset", Pseudo("PRE")),
        operand("Accum", Pseudo("ACC")),
    ],
    summary: "Clears DN after the rung has been false for PRE ms.",
    safety: None,
};

/// Retentive timer on.
pub static RTO: Instruction = Instruction {
    opcode: Opcode::Rto,
    mnemonic: "RTO",
    also: &[],
    name: "Retentive Timer On",
    group: Group::TimerCounter,
    first_version: 14,
    requires: Requires::Any,
    source: "1756-RM093 Table 12",
    position: Position::Output,
    transitional: true,
    operands: &[
        operand("Timer", Structure(&TIMER, Access::ReadWrite)),
        operand("Preset", Pseudo("PRE")),
        operand("Accum", Pseudo("ACC")),
    ],
    summary: "As TON, and keeps ACC and DN while the rung is false.",
    safety: None,
};

/// Count up.
pub static CTU: Instruction = Instruction {
    opcode: Opcode::Ctu,
    mnemonic: "CTU",
    also: &[],
    name: "Count Up",
    group: Group::TimerCounter,
    first_version: 14,
    requires: Requires::Any,
    source: "1756-RM093 Table 12",
    position: Position::Output,
    transitional: true,
    operands: &[
        operand("Counter", Structure(&COUNTER, Access::ReadWrite)),
        operand("Preset", Pseudo("PRE")),
        operand("Accum", Pseudo("ACC")),
    ],
    summary: "Adds one to ACC when the rung rises.",
    safety: None,
};

/// Count down.
pub static CTD: Instruction = Instruction {
    opcode: Opcode::Ctd,
    mnemonic: "CTD",
    also: &[],
    name: "Count Down",
    group: Group::TimerCounter,
    first_version: 14,
    requires: Requires::Any,
    source: "1756-RM093 Table 12",
    position: Position::Output,
    transitional: true,
    operands: &[
        operand("Counter", Structure(&COUNTER, Access::ReadWrite)),
        operand("Preset", Pseudo("PRE")),
        operand("Accum", Pseudo("ACC")),
    ],
    summary: "Takes one from ACC when the rung rises.",
    safety: None,
};

/// Reset.
pub static RES: Instruction = Instruction {
    opcode: Opcode::Res,
    mnemonic: "RES",
    also: &[],
    name: "Reset",
    group: Group::TimerCounter,
    first_version: 14,
    requires: Requires::Any,
    source: "1756-RM093 Table 12",
    position: Position::Output,
    transitional: false,
    operands: &[operand("Structure", Resettable)],
    summary: "Clears ACC (or POS) and the status bits of a TIMER, COUNTER or CONTROL.",
    safety: None,
};
