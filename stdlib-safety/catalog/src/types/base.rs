//! Structures of the base instructions, and CONNECTION_STATUS. Layout: general-instructions.md 2.1.

use crate::predefined::{Element, Member, MemberRole::Data, PredefinedType, flag, word};

/// TIMER of TON, TOF and RTO. The low bits of its first word are the real controller's private time stamp and read 0 here.
pub static TIMER: PredefinedType = PredefinedType {
    name: "TIMER",
    bytes: 12,
    members: &[
        word("PRE", 4, Data, "preset in ms"),
        word("ACC", 8, Data, "accumulated time in ms"),
        flag("EN", 0, 31, Data, "rung condition at the last execution"),
        flag("TT", 0, 30, Data, "timing"),
        flag("DN", 0, 29, Data, "done"),
    ],
    backs_one_call: false,
    source: "general-instructions.md 2.1",
};

/// COUNTER of CTU and CTD.
pub static COUNTER: PredefinedType = PredefinedType {
    name: "COUNTER",
    bytes: 12,
    members: &[
        word("PRE", 4, Data, "preset"),
        word("ACC", 8, Data, "count"),
        flag("CU", 0, 31, Data, "count-up rung condition at the last execution"),
        flag("CD", 0, 30, Data, "count-down rung condition at the last execution"),
        flag("DN", 0, 29, Data, "count has reached the preset"),
        flag("OV", 0, 28, Data, "wrapped above the greatest DINT"),
        flag("UN", 0, 27, Data, "wrapped below the least DINT"),
    ],
    backs_one_call: false,
    source: "general-instructions.md 2.1",
};

/// CONTROL of FAL and FSC.
pub static CONTROL: PredefinedType = PredefinedType {
    name: "CONTROL",
    bytes: 12,
    members: &[
        word("LEN", 4, Data, "number of elements"),
        word("POS", 8, Data, "current element"),
        flag("EN", 0, 31, Data, "enabled"),
        flag("EU", 0, 30, Data, "unload enabled (unused here)"),
        flag("DN", 0, 29, Data, "last element done"),
        flag("EM", 0, 28, Data, "empty (unused here)"),
        flag("ER", 0, 27, Data, "overflow stopped the operation"),
        flag("UL", 0, 26, Data, "unload (unused here)"),
        flag("IN", 0, 25, Data, "inhibited after a hit"),
        flag("FD", 0, 24, Data, "found"),
    ],
    backs_one_call: false,
    source: "general-instructions.md 2.1",
};

/// CONNECTION_STATUS: first member of produced and consumed safety tags. neutral-text-and-l5x.md D.3.
pub static CONNECTION_STATUS: PredefinedType = PredefinedType {
    name: "CONNECTION_STATUS",
    bytes: 4,
    members: &[
        flag("RunMode", 0, 0, Data, "the producer is in Run and its data is valid"),
        flag("ConnectionFaulted", 0, 1, Data, "the connection is lost; the data reads 0"),
    ],
    backs_one_call: false,
    source: "neutral-text-and-l5x.md D.3",
};

/// STRING: a length and 82 characters.
pub static STRING: PredefinedType = PredefinedType {
    name: "STRING",
    bytes: 88,
    members: &[
        word("LEN", 0, Data, "number of characters"),
        Member { name: "DATA", element: Element::Sint, length: 82, byte: 4, bit: 0, role: Data, meaning: "characters" },
    ],
    backs_one_call: false,
    source: "neutral-text-and-l5x.md D.5",
};
