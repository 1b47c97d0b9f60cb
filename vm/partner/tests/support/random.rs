//! Random programs without jumps and subscripts.

use super::{project, tags};

/// A small generator of numbers.
pub struct Numbers(pub u64);

impl Numbers {
    /// One of the numbers below the limit.
    pub fn below(&mut self, limit: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as usize % limit
    }

    /// One of the list.
    pub fn pick<'a>(&mut self, list: &[&'a str]) -> &'a str {
        list[self.below(list.len())]
    }
}

const TAGS: &[&str] = &[
    "x : BOOL[32]",
    "y : BOOL[32]",
    "s : BOOL[32]",
    "d : DINT[8]",
    "i : INT[4]",
    "b : SINT[4]",
    "r : REAL[4]",
    "w : DINT[4]",
    "t : TIMER[6]",
    "c : COUNTER[3]",
    "k : CONTROL[2]",
    "v : DINT",
];

fn bit(numbers: &mut Numbers) -> String {
    match numbers.below(20) {
        0..6 => format!("x[{}]", numbers.below(32)),
        6..13 => format!("y[{}]", numbers.below(32)),
        13 => format!("s[{}]", numbers.below(32)),
        14 => format!("w[{}].{}", numbers.below(4), numbers.below(32)),
        15 => format!("b[{}].{}", numbers.below(4), numbers.below(8)),
        16 => format!("t[{}].{}", numbers.below(6), numbers.pick(&["EN", "TT", "DN"])),
        17 => format!("c[{}].{}", numbers.below(3), numbers.pick(&["CU", "CD", "DN", "OV", "UN"])),
        18 => numbers.pick(&["S:V", "S:Z", "S:N", "S:C", "S:FS", "S:MINOR"]).to_string(),
        _ => format!("x[{}]", numbers.below(4)),
    }
}

fn coil(numbers: &mut Numbers) -> String {
    match numbers.below(12) {
        0..9 => format!("y[{}]", numbers.below(32)),
        9 => format!("w[{}].{}", numbers.below(4), numbers.below(32)),
        10 => format!("b[{}].{}", numbers.below(4), numbers.below(8)),
        _ => format!("t[{}].DN", numbers.below(6)),
    }
}

fn word(numbers: &mut Numbers) -> String {
    match numbers.below(8) {
        0..3 => format!("d[{}]", numbers.below(8)),
        3 => format!("i[{}]", numbers.below(4)),
        4 => format!("b[{}]", numbers.below(4)),
        5 => format!("w[{}]", numbers.below(4)),
        6 => format!("t[{}].ACC", numbers.below(6)),
        _ => numbers.pick(&["0", "1", "-1", "7", "300", "70000", "2147483647", "-2147483648"]).to_string(),
    }
}

fn target(numbers: &mut Numbers) -> String {
    match numbers.below(12) {
        0..5 => format!("d[{}]", numbers.below(8)),
        5..7 => format!("i[{}]", numbers.below(4)),
        7..9 => format!("b[{}]", numbers.below(4)),
        9 => format!("w[{}]", numbers.below(4)),
        10 => format!("c[{}].PRE", numbers.below(3)),
        _ => format!("t[{}].PRE", numbers.below(6)),
    }
}

fn number(numbers: &mut Numbers) -> String {
    if numbers.below(4) == 0 {
        numbers.pick(&["r[0]", "r[1]", "r[2]", "2.5", "-1.0e30", "0.1"]).to_string()
    } else {
        word(numbers)
    }
}

fn destination(numbers: &mut Numbers) -> String {
    if numbers.below(4) == 0 { format!("r[{}]", numbers.below(4)) } else { target(numbers) }
}

fn input(numbers: &mut Numbers) -> String {
    match numbers.below(24) {
        0..9 => format!("XIC({})", bit(numbers)),
        9..16 => format!("XIO({})", bit(numbers)),
        16 => format!("ONS(s[{}])", numbers.below(32)),
        17 => format!(
            "{}({},{})",
            numbers.pick(&["EQU", "NEQ", "GRT", "GEQ", "LES", "LEQ"]),
            number(numbers),
            number(numbers)
        ),
        18..20 => format!(
            "{}({},{})",
            numbers.pick(&["EQU", "NEQ", "GRT", "GEQ", "LES", "LEQ"]),
            word(numbers),
            word(numbers)
        ),
        20 => format!("LIM({},{},{})", number(numbers), number(numbers), number(numbers)),
        21 => format!("MEQ({},{},{})", word(numbers), word(numbers), word(numbers)),
        22 => format!("CMP({}*2>{})", word(numbers), word(numbers)),
        _ => "AFI()".to_string(),
    }
}

fn output(numbers: &mut Numbers) -> String {
    match numbers.below(30) {
        0..7 => format!("OTE({})", coil(numbers)),
        7..9 => format!("OTL({})", coil(numbers)),
        9..11 => format!("OTU({})", coil(numbers)),
        11 => format!("OSR(s[{}],{})", numbers.below(32), coil(numbers)),
        12 => format!("OSF(s[{}],{})", numbers.below(32), coil(numbers)),
        13..15 => format!("{}(t[{}],?,?)", numbers.pick(&["TON", "RTO"]), numbers.below(4)),
        15 => format!("TOF(t[{}],?,?)", 4 + numbers.below(2)),
        16 => format!("{}(c[{}],?,?)", numbers.pick(&["CTU", "CTD"]), numbers.below(3)),
        17 => format!("RES({}[{}])", numbers.pick(&["t", "c"]), numbers.below(3)),
        18..20 => format!("MOV({},{})", word(numbers), target(numbers)),
        20 => format!("MOV({},{})", number(numbers), destination(numbers)),
        21..23 => format!("{}({},{},{})", numbers.pick(&["ADD", "SUB"]), word(numbers), word(numbers), target(numbers)),
        23 => format!(
            "{}({},{},{})",
            numbers.pick(&["ADD", "SUB", "MUL", "DIV", "MOD"]),
            number(numbers),
            number(numbers),
            destination(numbers)
        ),
        24 => format!(
            "{}({},{},{})",
            numbers.pick(&["AND", "OR", "XOR", "MVM"]),
            word(numbers),
            word(numbers),
            target(numbers)
        ),
        25 => format!("{}({},{})", numbers.pick(&["NOT", "NEG", "ABS", "SQR"]), word(numbers), target(numbers)),
        26 => format!("CLR({})", destination(numbers)),
        27 => format!("FLL({},d[{}],2)", number(numbers), numbers.below(6)),
        28 => format!("COP(d[{}],w[{}],2)", numbers.below(6), numbers.below(2)),
        _ => format!("CPT({},({}+1)*{})", destination(numbers), word(numbers), number(numbers)),
    }
}

fn series(numbers: &mut Numbers, depth: usize) -> String {
    let mut text = String::new();
    for _ in 0..1 + numbers.below(3) {
        let branch = depth < 3 && numbers.below(4) == 0;
        text += &if branch {
            let legs: Vec<String> = (0..2 + numbers.below(2)).map(|_| leg(numbers, depth + 1)).collect();
            format!("[{} ]", legs.join(" ,"))
        } else if numbers.below(4) == 0 {
            output(numbers)
        } else {
            input(numbers)
        };
    }
    text
}

fn leg(numbers: &mut Numbers, depth: usize) -> String {
    if numbers.below(8) == 0 { String::new() } else { series(numbers, depth) }
}

/// A program of so many random rungs; with zones, MCRs stand between them.
pub fn program(seed: u64, rungs: usize, zones: bool) -> String {
    let mut numbers = Numbers(seed.wrapping_mul(2).wrapping_add(1).wrapping_mul(0x2545_F491_4F6C_DD1D));
    let mut body = String::new();
    for rung in 0..rungs {
        if zones && rung % 16 == 4 {
            body += &format!("N: XIC({})MCR();\n", bit(&mut numbers));
        } else if zones && rung % 16 == 12 {
            body += "N: MCR();\n";
        }
        body += &format!("N: {}{};\n", series(&mut numbers, 0), output(&mut numbers));
    }
    project("", &tags(TAGS), &format!(", FAULT := \"Handler\")\nROUTINE Main\n{body}END_ROUTINE\nROUTINE Handler\nN: GSV(PROGRAM,THIS,MajorFaultRecord,f)CLR(f[2])SSV(PROGRAM,THIS,MajorFaultRecord,f);\nEND_ROUTINE"))
        .replace("END_TAG", "f : DINT[11] (Class := Safety);\nEND_TAG")
}
