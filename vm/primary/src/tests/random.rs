//! Random programs: by steps and in the order of the text they give the same.

extern crate std;

use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec::Vec;

use twinrung_bytecode::channel::ScanEnd;
use twinrung_bytecode::image::Usage;

use super::assembler::Assembler;
use super::rig::Rig;

const TAGS: &str = "a b c d e f g h BOOL; s0 s1 s2 s3 BOOL; i j k l m DINT; n INT; p SINT; r q REAL; \
                    arr DINT[6]; small SINT[8]; flags BOOL[32]; t0 t1 t2 TIMER; c0 c1 COUNTER; k0 k1 CONTROL; w DINT";

/// A generator of numbers; the same seed gives the same program.
pub(super) struct Random(pub(super) u64);

impl Random {
    pub(super) fn below(&mut self, bound: u64) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) % bound
    }

    fn pick<'a>(&mut self, from: &[&'a str]) -> &'a str {
        from[self.below(from.len() as u64) as usize]
    }

    fn bit(&mut self) -> String {
        match self.below(14) {
            0 => format!("w.{}", self.below(32)),
            1 => format!("n.{}", self.below(16)),
            2 => format!("flags[{}]", self.below(32)),
            3 if self.below(4) == 0 => "flags[i]".to_string(),
            4 if self.below(4) == 0 => "w.[j]".to_string(),
            5 => self.pick(&["t0.DN", "t1.TT", "t2.EN", "c0.DN", "c1.CU", "k0.DN", "k1.FD", "k0.ER"]).to_string(),
            _ => self.pick(&["a", "b", "c", "d", "e", "f", "g", "h"]).to_string(),
        }
    }

    fn contact_bit(&mut self) -> String {
        match self.below(24) {
            0 => "S:FS".to_string(),
            1 => self.pick(&["S:V", "S:Z", "S:N", "S:C", "S:MINOR"]).to_string(),
            _ => self.bit(),
        }
    }

    fn target(&mut self) -> String {
        match self.below(20) {
            0 => "n".to_string(),
            1 => "p".to_string(),
            2 => "r".to_string(),
            3 => "q".to_string(),
            4 => format!("arr[{}]", self.below(6)),
            5 if self.below(3) == 0 => "arr[i]".to_string(),
            6 => format!("small[{}]", self.below(8)),
            7 => self.pick(&["c0.PRE", "c1.ACC", "t2.PRE", "k1.POS"]).to_string(),
            _ => self.pick(&["i", "j", "k", "l", "m", "w"]).to_string(),
        }
    }

    fn integer_target(&mut self) -> String {
        loop {
            let target = self.target();
            if target != "r" && target != "q" {
                return target;
            }
        }
    }

    fn number(&mut self) -> String {
        match self.below(8) {
            0 => self.below(7).to_string(),
            1 => self.pick(&["-1", "7", "100", "-30000", "2147483647", "-2147483648", "65665"]).to_string(),
            2 if self.below(3) == 0 => self.pick(&["2.5", "-0.5", "1000000.0", "3.0e9"]).to_string(),
            _ => self.target(),
        }
    }

    fn integer(&mut self) -> String {
        match self.below(4) {
            0 => self.below(7).to_string(),
            _ => self.integer_target(),
        }
    }

    fn expression(&mut self, depth: u64) -> String {
        if depth == 0 || self.below(3) == 0 {
            return self.number();
        }
        let (left, right) = (self.expression(depth - 1), self.expression(depth - 1));
        match self.below(7) {
            0 => format!("NOT({left})"),
            1 => format!("ABS({left})"),
            2 => format!("SQR({left})"),
            3 => format!("-({left})"),
            _ => {
                let operator = self.pick(&["+", "-", "*", "/", "MOD", "AND", "OR", "XOR"]);
                format!("({left} {operator} {right})")
            }
        }
    }

    fn condition(&mut self) -> String {
        let (left, right) = (self.expression(1), self.expression(1));
        let relation = self.pick(&["<", "<=", ">", ">=", "=", "<>"]);
        format!("({left}) {relation} ({right})")
    }

    fn output(&mut self) -> String {
        match self.below(30) {
            0..=6 => format!("OTE({})", self.bit()),
            7 | 8 => format!("OTL({})", self.bit()),
            9 | 10 => format!("OTU({})", self.bit()),
            11 => format!("OSR({},{})", self.bit(), self.bit()),
            12 => format!("OSF({},{})", self.bit(), self.bit()),
            13 => format!("{}({},?,?)", self.pick(&["TON", "TOF", "RTO"]), self.pick(&["t0", "t1", "t2"])),
            14 => format!("{}({},?,?)", self.pick(&["CTU", "CTD"]), self.pick(&["c0", "c1"])),
            15 => format!("RES({})", self.pick(&["t0", "c0", "c1", "k0", "k1"])),
            16 | 17 => format!("MOV({},{})", self.number(), self.target()),
            18 | 19 => {
                let mnemonic = self.pick(&["ADD", "SUB", "MUL", "DIV", "MOD"]);
                format!("{mnemonic}({},{},{})", self.number(), self.number(), self.target())
            }
            20 => {
                let mnemonic = self.pick(&["AND", "OR", "XOR", "MVM"]);
                format!("{mnemonic}({},{},{})", self.integer(), self.integer(), self.integer_target())
            }
            21 => format!("{}({},{})", self.pick(&["SQR", "NEG", "ABS"]), self.number(), self.target()),
            22 => format!("NOT({},{})", self.integer(), self.integer_target()),
            23 => format!("CPT({},{})", self.target(), self.expression(3)),
            24 => format!("CLR({})", self.target()),
            25 => self
                .pick(&[
                    "COP(arr[1],arr[0],4)",
                    "COP(t0,t1,1)",
                    "COP(c0,arr[1],1)",
                    "COP(small[0],arr[2],1)",
                    "COP(arr[i],arr[0],2)",
                ])
                .to_string(),
            26 => {
                format!("FLL({},{},{})", self.number(), self.pick(&["arr[1]", "small[2]", "arr[i]"]), 1 + self.below(4))
            }
            27 => {
                let (control, mode) = (self.pick(&["k0", "k1"]), self.pick(&["ALL", "INC", "2"]));
                format!("FAL({control},?,?,{mode},arr[{control}.POS],{})", self.expression(2))
            }
            28 => {
                let (control, mode) = (self.pick(&["k0", "k1"]), self.pick(&["ALL", "INC", "2"]));
                format!("FSC({control},?,?,{mode},{})", self.condition())
            }
            _ => {
                self.pick(&["SWPB(i,WORD,j)", "SWPB(n,REVERSE,n)", "SIZE(arr[0],0,k)", "NOP()", "EVENT(0)"]).to_string()
            }
        }
    }

    fn input(&mut self) -> String {
        match self.below(20) {
            0 => format!("ONS({})", self.pick(&["s0", "s1", "s2", "s3"])),
            1 | 2 => {
                let mnemonic = self.pick(&["EQU", "NEQ", "GRT", "GEQ", "LES", "LEQ"]);
                format!("{mnemonic}({},{})", self.number(), self.number())
            }
            3 => format!("LIM({},{},{})", self.number(), self.number(), self.number()),
            4 => format!("MEQ({},{},{})", self.integer(), self.integer(), self.integer()),
            5 => format!("CMP({})", self.condition()),
            6 if self.below(3) == 0 => "AFI()".to_string(),
            _ => format!("{}({})", self.pick(&["XIC", "XIC", "XIO"]), self.contact_bit()),
        }
    }

    fn series(&mut self, depth: u64, out: &mut String) {
        for _ in 0..1 + self.below(4) {
            match self.below(12) {
                0..=2 if depth < 3 => {
                    out.push('[');
                    let legs = 2 + self.below(3);
                    for leg in 0..legs {
                        if leg > 0 {
                            out.push_str(" ,");
                        }
                        if self.below(10) != 0 {
                            self.series(depth + 1, out);
                        }
                    }
                    out.push_str(" ]");
                }
                3 | 4 => out.push_str(&self.output()),
                _ => out.push_str(&self.input()),
            }
        }
    }

    fn rung(&mut self, number: usize) -> String {
        let mut out = String::new();
        if number == 4 {
            out.push_str("LBL(back)");
        }
        if number == 9 {
            out.push_str("LBL(ahead)");
        }
        self.series(0, &mut out);
        match self.below(26) {
            0 => out.push_str("MCR()"),
            1 if number < 9 => out.push_str("JMP(ahead)"),
            2 if number > 4 => out.push_str("LES(l,3)ADD(l,1,l)JMP(back)"),
            3 => out.push_str("JSR(Sub,1,i,j)"),
            4 => out.push_str("[JSR(Plain,0) ,XIC(a)OTE(b) ]"),
            5 => out.push_str("TND()"),
            6 => out.push_str("Block(inst0,a,i,j,arr[2])OTE(c)"),
            7 => out.push_str("[XIC(b)Block(inst1,d,arr[i],k,m) ,XIO(c) ]OTE(e)"),
            8 => out.push_str("JSR(Fault,1,995)"),
            9 => out.push_str("GSV(PROGRAM,THIS,0,record[0])"),
            _ => out.push_str(&self.output()),
        }
        out
    }
}

pub(super) fn program(seed: u64) -> Rig {
    let mut random = Random(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1);
    let mut assembler = Assembler::new();
    assembler.tags(TAGS);
    assembler.tag("record", "DINT[11]");
    assembler.image.event_tasks.push("E".to_string());
    assembler.image.system_values.push(twinrung_bytecode::image::SystemValueRecord {
        attribute: 9,
        instance: 0,
        first: 0,
        program: None,
    });
    let inner = |random: &mut Random| {
        let mut rung = String::new();
        for _ in 0..random.below(3) {
            let contact = random.pick(&["XIC(Go)", "XIO(Mem)", "ONS(Mem)", "GRT(In,3)", "XIC(T.DN)"]);
            rung.push_str(contact);
        }
        let output = random.pick(&[
            "OTE(Mem)",
            "ADD(In,1,Out)",
            "MOV(In,Ref)",
            "TON(T,?,?)",
            "OTU(EnableOut)",
            "ADD(Ref,Out,Ref)",
            "TND()",
        ]);
        rung.push_str(output);
        rung
    };
    let logic: Vec<String> = (0..4).map(|_| inner(&mut random)).collect();
    let logic: Vec<&str> = logic.iter().map(String::as_str).collect();
    let with_false: &[&str] = if random.below(2) == 0 { &["ADD(Out,1,Out)[OTE(EnableOut) ,OTE(Mem) ]"] } else { &[] };
    assembler.add_on(
        "Block",
        &[
            ("Go", "BOOL", Usage::Input),
            ("In", "DINT", Usage::Input),
            ("Out", "INT", Usage::Output),
            ("Ref", "DINT", Usage::InOut),
        ],
        &[("Mem", "BOOL"), ("T", "TIMER")],
        [&logic, &["OTL(Mem)"], with_false],
    );
    assembler.tag("inst0", "Block");
    assembler.tag("inst1", "Block");
    assembler.routine("Plain", &["XIO(a)OTE(h)", "XIC(g)RET()", "ADD(m,1,m)"]);
    assembler.routine("Sub", &["SBR(l)XIC(h)OTE(f)", "ADD(l,1,k)", "XIC(c)RET(k)"]);
    if random.below(2) == 0 {
        assembler.tag("zero", "DINT[11]");
        let clear = ["ADD(m,1,m)OTE(d)", "GRT(m,3)SSV(PROGRAM,THIS,0,zero[0])", "JSR(Plain,0)"];
        assembler.fault(&clear);
    } else {
        assembler.fault(&["OTE(d)"]);
    }
    let rungs: Vec<String> = (0..14).map(|number| random.rung(number)).collect();
    let rungs: Vec<String> = rungs
        .into_iter()
        .enumerate()
        .map(|(number, rung)| if number == 4 || number == 9 { rung } else { rung.replace("LBL(", "XIC(") })
        .collect();
    let rungs: Vec<&str> = rungs.iter().map(String::as_str).collect();
    if std::env::var("SHOW").is_ok() {
        std::eprintln!("logic {logic:#?}\nmain {rungs:#?}");
    }
    assembler.main(&rungs);
    let mut rig = Rig::of(assembler);
    rig.budget = 3000;
    for (name, value) in [("t0.PRE", 30), ("t1.PRE", 0), ("t2.PRE", 15), ("c0.PRE", 3), ("k0.LEN", 5), ("k1.LEN", 6)] {
        rig.set(name, value);
    }
    rig
}

fn run(seed: u64, scans: u64) -> ScanEnd {
    let mut rig = program(seed);
    let mut random = Random(seed ^ 0x5555_AAAA_1234_5678);
    rig.prescan();
    let mut end = ScanEnd::Completed;
    for _ in 0..scans {
        for _ in 0..3 {
            let name = random.pick(&["a", "b", "c", "d", "e", "f", "g", "h", "s0"]);
            rig.set(name, random.below(2) as i32);
        }
        let name = random.pick(&["i", "j", "k", "n", "p", "l"]);
        rig.set(name, random.below(9) as i32 - 1);
        if random.below(8) == 0 {
            rig.set("t0.PRE", random.below(40) as i32 - 1);
        }
        end = rig.scan();
    }
    end
}

#[test]
fn random_programs_when_run_by_steps_and_by_text_then_are_equal() {
    let count = std::env::var("PROGRAMS").ok().and_then(|count| count.parse().ok()).unwrap_or(300);
    let first: u64 = std::env::var("SEED").ok().and_then(|seed| seed.parse().ok()).unwrap_or(1);
    for seed in first..first + count {
        // Names the program that fails.
        std::eprintln!("seed {seed}");
        run(seed, 12);
    }
}
