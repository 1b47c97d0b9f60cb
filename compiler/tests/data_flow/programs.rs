//! Random small programs of boolean rungs: branches, latches, one-shots, jumps both ways, a subroutine with a parameter
//! and a return, a zone of MCR, bits of words and of arrays.

use std::fmt::Write;

/// What a contact or coil names: a position in [`NAMES`].
pub type Bit = usize;

/// The bits of a program. The first two are standard inputs, the next two safety inputs, the last is the output.
pub const NAMES: [&str; 17] = [
    "Std",
    "Std2",
    "Safe",
    "Safe2",
    "A",
    "B",
    "Bits[1]",
    "W.3",
    "Once",
    "Given",
    "Taken",
    "Motor",
    "Turn",
    "G.Go",
    "G.Step",
    "G.Done",
    "G.EnableOut",
];

pub const STANDARD: [Bit; 2] = [0, 1];
pub const SAFETY: [Bit; 2] = [2, 3];
pub const ONCE: Bit = 8;
pub const GIVEN: Bit = 9;
pub const TAKEN: Bit = 10;
pub const MOTOR: Bit = 11;
pub const TURN: Bit = 12;
/// The members of the Add-On Instruction's instance.
pub const GO: Bit = 13;
pub const STEP: Bit = 14;
pub const DONE: Bit = 15;
pub const ENABLE_OUT: Bit = 16;

/// One thing in a series.
#[derive(Debug, Clone)]
pub enum Element {
    Contact(Bit, bool),
    OneShot(Bit),
    Branch(Vec<Vec<Element>>),
    Coil(Bit),
    Latch(Bit),
    Unlatch(Bit),
    /// To the rung of this number.
    Jump(usize),
    End,
    /// Hands `TAKEN` back.
    Return,
    /// Passes the first bit on and receives the second.
    Call(Bit, Bit),
    Zone,
    /// The Add-On Instruction: takes the first bit, gives the second.
    Gate(Bit, Bit),
}

/// A program, and the bits that begin with 1.
#[derive(Debug, Clone)]
pub struct Program {
    pub main: Vec<Vec<Element>>,
    pub part: Vec<Vec<Element>>,
    /// The logic of the Add-On Instruction, and what runs while its rung is false.
    pub logic: Vec<Vec<Element>>,
    pub when_false: Vec<Vec<Element>>,
    pub set: Vec<Bit>,
}

/// Numbers that look random, from a seed.
pub struct Dice(u64);

impl Dice {
    pub fn new(seed: u64) -> Dice {
        Dice(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1)
    }

    pub fn below(&mut self, limit: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 33) as usize % limit
    }

    fn one_in(&mut self, count: usize) -> bool {
        self.below(count) == 0
    }

    fn contact(&mut self) -> Element {
        let bit = [0, 0, 1, 2, 3, 4, 4, 5, 5, 6, 7, 11][self.below(12)];
        Element::Contact(bit, self.one_in(3))
    }

    fn contacts(&mut self, nested: bool) -> Vec<Element> {
        let mut list = Vec::new();
        for _ in 0..self.below(3) {
            if nested && self.one_in(4) {
                let legs = (0..2).map(|_| self.contacts(false)).collect();
                list.push(Element::Branch(legs));
            } else {
                list.push(self.contact());
            }
        }
        if nested && self.one_in(12) {
            list.push(Element::OneShot(ONCE));
        }
        list
    }

    fn coil(&mut self) -> Element {
        let bit = [4, 5, 6, 7, 4, 11][self.below(6)];
        match self.below(4) {
            0 => Element::Latch(bit),
            1 => Element::Unlatch(bit),
            _ => Element::Coil(bit),
        }
    }

    fn rung(&mut self) -> Vec<Element> {
        let mut rung = self.contacts(true);
        if self.one_in(6) {
            let mut leg = self.contacts(false);
            leg.push(self.coil());
            rung.push(Element::Branch(vec![leg, vec![self.coil()]]));
        } else {
            rung.push(self.coil());
        }
        rung
    }

    fn ends_with(&mut self, last: Element) -> Vec<Element> {
        let mut rung = self.contacts(false);
        rung.push(last);
        rung
    }

    /// A program of a few rungs.
    pub fn program(&mut self) -> Program {
        let mut main: Vec<Vec<Element>> = (0..2 + self.below(4)).map(|_| self.rung()).collect();
        let part = if self.one_in(3) { self.part(&mut main) } else { Vec::new() };
        let (mut logic, mut when_false) = (Vec::new(), Vec::new());
        if self.one_in(3) {
            logic = self.inner();
            when_false = if self.one_in(3) { self.inner() } else { Vec::new() };
            for _ in 0..1 + self.below(2) {
                let call = Element::Gate(self.below(8), [4, 5, 6, 7, 11][self.below(5)]);
                let mut rung = self.ends_with(call);
                if self.one_in(3) {
                    rung.push(self.coil());
                }
                main.insert(self.below(main.len() + 1), rung);
            }
        }
        if self.one_in(3) {
            let (from, to) = (self.below(main.len()), self.below(main.len() + 1));
            let (begin, end) = (from.min(to), from.max(to));
            main.insert(end, vec![Element::Zone]);
            let mut contact = vec![self.contact()];
            contact.push(Element::Zone);
            main.insert(begin, contact);
        }
        for _ in 0..self.below(3) {
            self.jump(&mut main);
        }
        if self.one_in(4) {
            self.back(&mut main);
        }
        if self.one_in(8) {
            let at = self.below(main.len());
            let end = self.ends_with(Element::End);
            insert(&mut main, at, end);
        }
        if self.one_in(6) {
            // What is left on a rung after a jump within a branch.
            let to = main.len() + 1;
            let mut leg = self.contacts(false);
            leg.push(Element::Jump(to));
            main.push(vec![Element::Branch(vec![leg, vec![self.coil()]])]);
        }
        let mut last = self.contacts(true);
        last.push(Element::Contact(4 + self.below(4), false));
        last.push(Element::Coil(MOTOR));
        main.push(last);
        let set = (4..6).filter(|_| self.one_in(3)).collect();
        Program { main, part, logic, when_false, set }
    }

    /// Rungs of the Add-On Instruction.
    fn inner(&mut self) -> Vec<Vec<Element>> {
        let mut rungs = Vec::new();
        for _ in 0..1 + self.below(3) {
            let mut rung: Vec<Element> = (0..self.below(3))
                .map(|_| Element::Contact([GO, STEP, DONE, GO][self.below(4)], self.one_in(3)))
                .collect();
            let bit = [STEP, DONE, DONE, ENABLE_OUT][self.below(4)];
            rung.push(match self.below(4) {
                0 => Element::Latch(bit),
                1 => Element::Unlatch(bit),
                _ => Element::Coil(bit),
            });
            rungs.push(rung);
        }
        rungs
    }

    fn part(&mut self, main: &mut Vec<Vec<Element>>) -> Vec<Vec<Element>> {
        let mut part: Vec<Vec<Element>> = (0..1 + self.below(2)).map(|_| self.rung()).collect();
        part[0].insert(0, Element::Contact(GIVEN, self.one_in(2)));
        let mut taken = vec![self.contact(), self.contact()];
        taken.push(Element::Coil(TAKEN));
        part.insert(self.below(part.len() + 1), taken);
        for _ in 0..1 + self.below(2) {
            let back = self.ends_with(Element::Return);
            part.insert(self.below(part.len() + 1), back);
        }
        for _ in 0..1 + self.below(2) {
            let call = Element::Call(self.below(8), 4 + self.below(3));
            let rung = self.ends_with(call);
            main.insert(self.below(main.len() + 1), rung);
        }
        part
    }

    /// A jump to an earlier rung, taken once in a scan at most.
    fn back(&mut self, main: &mut Vec<Vec<Element>>) {
        insert(main, 0, vec![Element::Unlatch(TURN)]);
        let at = 1 + self.below(main.len());
        let to = 1 + self.below(at);
        let mut rung = vec![Element::Contact(TURN, true)];
        rung.extend(self.contacts(false));
        rung.push(Element::Branch(vec![vec![Element::Latch(TURN)], vec![Element::Jump(to)]]));
        insert(main, at, rung);
    }

    /// A jump to a later rung.
    fn jump(&mut self, main: &mut Vec<Vec<Element>>) {
        let at = self.below(main.len());
        let rung = self.ends_with(Element::Jump(0));
        insert(main, at, rung);
        let to = at + 1 + self.below(main.len() - at);
        let last = main[at].len() - 1;
        main[at][last] = Element::Jump(to);
    }
}

/// Inserts a rung; jumps go on to lead to the rungs that they led to, or to the new one before.
fn insert(main: &mut Vec<Vec<Element>>, at: usize, rung: Vec<Element>) {
    fn shift(elements: &mut [Element], at: usize) {
        for element in elements {
            match element {
                Element::Jump(to) if *to > at => *to += 1,
                Element::Branch(legs) => legs.iter_mut().for_each(|leg| shift(leg, at)),
                _ => {}
            }
        }
    }
    for rung in main.iter_mut() {
        shift(rung, at);
    }
    main.insert(at, rung);
}

impl Program {
    /// The definition of the Add-On Instruction as text; nothing where none is called.
    pub fn definition(&self) -> String {
        if self.logic.is_empty() {
            return String::new();
        }
        let mut text = "  ADD_ON_INSTRUCTION_DEFINITION Gate (Class := Safety)\n    PARAMETERS\n      Go : BOOL (Usage := Input, \
                        Required := Yes);\n      Done : BOOL (Usage := Output, Required := Yes);\n    END_PARAMETERS\n    \
                        LOCAL_TAGS\n      Step : BOOL;\n    END_LOCAL_TAGS\n"
            .to_owned();
        for (name, rungs) in [("Logic", &self.logic), ("EnableInFalse", &self.when_false)] {
            if rungs.is_empty() {
                continue;
            }
            let _ = writeln!(text, "    ROUTINE {name}");
            for rung in rungs {
                let mut line = String::new();
                series(rung, &mut line);
                let _ = writeln!(text, "      N: {};", line.replace("G.", ""));
            }
            text.push_str("    END_ROUTINE\n");
        }
        text.push_str("  END_ADD_ON_INSTRUCTION_DEFINITION\n");
        text
    }

    /// The rungs of the main routine, and the subroutine, as text.
    pub fn text(&self) -> (String, String) {
        let mut targets = Vec::new();
        for rung in &self.main {
            jumps(rung, &mut targets);
        }
        let mut main = String::new();
        for (number, rung) in self.main.iter().enumerate() {
            if targets.contains(&number) {
                let _ = write!(main, "LBL(L{number})");
            }
            series(rung, &mut main);
            main.push('\n');
        }
        let mut part = String::new();
        if !self.part.is_empty() {
            part.push_str("    ROUTINE Part\n      N: SBR(Given)NOP();\n");
            for rung in &self.part {
                part.push_str("      N: ");
                series(rung, &mut part);
                part.push_str(";\n");
            }
            part.push_str("    END_ROUTINE\n");
        }
        (main, part)
    }
}

fn jumps(elements: &[Element], targets: &mut Vec<usize>) {
    for element in elements {
        match element {
            Element::Jump(to) => targets.push(*to),
            Element::Branch(legs) => legs.iter().for_each(|leg| jumps(leg, targets)),
            _ => {}
        }
    }
}

fn series(elements: &[Element], out: &mut String) {
    for element in elements {
        let _ = match element {
            Element::Contact(bit, false) => write!(out, "XIC({})", NAMES[*bit]),
            Element::Contact(bit, true) => write!(out, "XIO({})", NAMES[*bit]),
            Element::OneShot(bit) => write!(out, "ONS({})", NAMES[*bit]),
            Element::Coil(bit) => write!(out, "OTE({})", NAMES[*bit]),
            Element::Latch(bit) => write!(out, "OTL({})", NAMES[*bit]),
            Element::Unlatch(bit) => write!(out, "OTU({})", NAMES[*bit]),
            Element::Jump(to) => write!(out, "JMP(L{to})"),
            Element::End => write!(out, "TND()"),
            Element::Return => write!(out, "RET(Taken)"),
            Element::Call(given, taken) => write!(out, "JSR(Part,1,{},{})", NAMES[*given], NAMES[*taken]),
            Element::Zone => write!(out, "MCR()"),
            Element::Gate(given, taken) => write!(out, "Gate(G,{},{})", NAMES[*given], NAMES[*taken]),
            Element::Branch(legs) => {
                out.push('[');
                for (at, leg) in legs.iter().enumerate() {
                    if at > 0 {
                        out.push_str(" ,");
                    }
                    series(leg, out);
                }
                out.push(']');
                Ok(())
            }
        };
    }
}
