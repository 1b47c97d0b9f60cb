//! Timers, counters and RES. general-instructions.md A.2 and A.3.

use crate::execution::{NOTHING, execution};
use crate::instruction::{Group, Instruction, Opcode, Position, base};
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
    name: "Timer On Delay",
    transitional: true,
    operands: &[
        operand("Timer", Structure(&TIMER, Access::ReadWrite)),
        operand("Preset", Pseudo("PRE")),
        operand("Accum", Pseudo("ACC")),
    ],
    summary: "Sets DN after the rung has been true for PRE ms; the first true execution adds no time.",
    execution: execution(
        "Sets EN. While DN is 0 it times: TT is set; the first true execution adds no time, each further one adds \
         what has passed to ACC; at ACC >= PRE DN is set and TT cleared. A PRE of 0 is done at the second true \
         execution.",
        "Clears EN, TT, DN and ACC.",
        "Clears EN, TT, DN and ACC.",
        "Major fault 4/34 when PRE or ACC is negative while it is enabled.",
    ),
    ..base(Group::TimerCounter, Position::Output)
};

/// Timer off delay.
pub static TOF: Instruction = Instruction {
    opcode: Opcode::Tof,
    mnemonic: "TOF",
    name: "Timer Off Delay",
    transitional: true,
    operands: &[
        operand("Timer", Structure(&TIMER, Access::ReadWrite)),
        operand("Preset", Pseudo("PRE")),
        operand("Accum", Pseudo("ACC")),
    ],
    summary: "Clears DN after the rung has been false for PRE ms.",
    execution: execution(
        "Sets EN and DN, clears TT and ACC.",
        "Clears EN. While DN is 1 it times: TT is set; the first false execution adds no time; at ACC >= PRE DN \
         and TT are cleared.",
        "Clears EN, TT and DN and sets ACC to PRE: a rung that starts false does not time.",
        "Major fault 4/34 when PRE or ACC is negative while it times. RES of a TOF is refused.",
    ),
    ..base(Group::TimerCounter, Position::Output)
};

/// Retentive timer on.
pub static RTO: Instruction = Instruction {
    opcode: Opcode::Rto,
    mnemonic: "RTO",
    name: "Retentive Timer On",
    transitional: true,
    operands: &[
        operand("Timer", Structure(&TIMER, Access::ReadWrite)),
        operand("Preset", Pseudo("PRE")),
        operand("Accum", Pseudo("ACC")),
    ],
    summary: "As TON, and keeps ACC and DN while the rung is false.",
    execution: execution(
        "Sets EN. While DN is 0 it times: TT is set; the first true execution adds no time, each further one adds \
         what has passed to ACC; at ACC >= PRE DN is set and TT cleared. A PRE of 0 is done at the second true \
         execution.",
        "Clears EN and TT; ACC and DN stay.",
        "Clears EN, TT and DN; ACC stays. A timer that was done sets DN again at its first true execution.",
        "Major fault 4/34 when PRE or ACC is negative while it is enabled.",
    ),
    ..base(Group::TimerCounter, Position::Output)
};

/// Count up.
pub static CTU: Instruction = Instruction {
    opcode: Opcode::Ctu,
    mnemonic: "CTU",
    name: "Count Up",
    transitional: true,
    operands: &[
        operand("Counter", Structure(&COUNTER, Access::ReadWrite)),
        operand("Preset", Pseudo("PRE")),
        operand("Accum", Pseudo("ACC")),
    ],
    summary: "Adds one to ACC when the rung rises.",
    execution: execution(
        "When CU is 0: sets it and adds one to ACC; above 2147483647 ACC goes on at -2147483648 and OV is set. DN \
         tells ACC >= PRE; while OV or UN is set it keeps its value.",
        "Clears CU. DN is refreshed; ACC, OV and UN stay.",
        "Sets CU: a rung that is true at the first scan is not counted.",
        "",
    ),
    ..base(Group::TimerCounter, Position::Output)
};

/// Count down.
pub static CTD: Instruction = Instruction {
    opcode: Opcode::Ctd,
    mnemonic: "CTD",
    name: "Count Down",
    transitional: true,
    operands: &[
        operand("Counter", Structure(&COUNTER, Access::ReadWrite)),
        operand("Preset", Pseudo("PRE")),
        operand("Accum", Pseudo("ACC")),
    ],
    summary: "Takes one from ACC when the rung rises.",
    execution: execution(
        "When CD is 0: sets it and takes one from ACC; below -2147483648 ACC goes on at 2147483647 and UN is set. \
         DN tells ACC >= PRE; while OV or UN is set it keeps its value.",
        "Clears CD. DN is refreshed; ACC, OV and UN stay.",
        "Sets CD: a rung that is true at the first scan is not counted.",
        "",
    ),
    ..base(Group::TimerCounter, Position::Output)
};

/// Reset.
pub static RES: Instruction = Instruction {
    opcode: Opcode::Res,
    mnemonic: "RES",
    name: "Reset",
    operands: &[operand("Structure", Resettable)],
    summary: "Clears ACC (or POS) and the status bits of a TIMER, COUNTER or CONTROL.",
    execution: execution(
        "TIMER: clears ACC, EN, TT and DN. COUNTER: clears ACC, CU, CD, DN, OV and UN. CONTROL: clears POS and \
         every flag. PRE and LEN stay.",
        "Nothing.",
        NOTHING,
        "",
    ),
    ..base(Group::TimerCounter, Position::Output)
};
