//! Rungs: sequences of instructions and branches, and the groups of rungs that belong together.

use twinrung_catalog::{Instruction, Position};

use super::data::{Kind, Part, Place, Role};
use super::literals;
use super::writer::{Passing, Writer};

impl Writer<'_> {
    /// `count` rungs or a few more.
    pub fn rungs(&mut self, count: usize) -> Vec<String> {
        let mut rungs = Vec::new();
        while rungs.len() < count {
            self.random.gene();
            match self.random.below(40) {
                0 => self.bounded_loop(&mut rungs),
                1..=2 if !self.in_add_on => self.zone(&mut rungs),
                3..=4 => {
                    let rung = self.written_member();
                    rungs.push(rung);
                }
                5 => rungs.extend(self.raised_fault()),
                6..=12 => self.guard(&mut rungs),
                13..=20 if self.in_add_on => self.guard(&mut rungs),
                _ => {
                    let rung = self.labelled_rung();
                    rungs.push(rung);
                }
            }
        }
        for label in std::mem::take(&mut self.pending_labels) {
            rungs.push(format!("LBL({label})NOP()"));
        }
        rungs
    }

    /// A label that a jump names and that a later rung will carry.
    pub fn label(&mut self) -> String {
        if !self.pending_labels.is_empty() && self.random.percent(40) {
            return self.random.of(&self.pending_labels.clone()).clone();
        }
        self.fresh += 1;
        let label = format!("Past{}", self.fresh);
        self.pending_labels.push(label.clone());
        label
    }

    fn labelled_rung(&mut self) -> String {
        let label = if !self.pending_labels.is_empty() && self.random.percent(30) {
            let at = self.random.below(self.pending_labels.len());
            format!("LBL({})", self.pending_labels.remove(at))
        } else {
            String::new()
        };
        format!("{label}{}", self.rung())
    }

    /// One rung.
    pub fn rung(&mut self) -> String {
        let mut text = String::new();
        for _ in 0..self.random.between(0, 2) {
            text.push_str(&self.input());
        }
        text.push_str(&self.sequence(3));
        if self.random.percent(70) {
            text.push_str(&self.output());
        }
        if self.random.percent(5) {
            text.push_str(&format!("{}JMP({})", self.input(), self.label()));
        }
        // A rung of nothing but empty legs is an empty rung.
        if !text.contains('(') {
            text.push_str("NOP()");
        }
        text
    }

    /// Elements in series, at least one.
    fn sequence(&mut self, depth: usize) -> String {
        let mut text = String::new();
        for _ in 0..self.random.between(1, 3) {
            match self.random.below(10) {
                0..=1 if depth > 0 => text.push_str(&self.branch(depth - 1)),
                0..=4 => text.push_str(&self.input()),
                _ => text.push_str(&self.output()),
            }
        }
        text
    }

    fn branch(&mut self, depth: usize) -> String {
        let mut legs = Vec::new();
        for _ in 0..self.random.between(1, 4) {
            let mut leg = if self.random.percent(12) { String::new() } else { self.sequence(depth) };
            if self.random.percent(3) {
                leg.push_str(&format!("{}JMP({})", self.input(), self.label()));
            }
            legs.push(leg);
        }
        format!("[{}]", legs.join(" ,"))
    }

    fn drawn(&mut self, wanted: impl Fn(Position) -> bool) -> String {
        let fits = |one: &Instruction| !one.group.is_safety_library() && wanted(one.position);
        let drawn: Vec<(&'static Instruction, usize)> =
            self.shared.palette.iter().filter(|(one, _)| fits(one)).collect();
        let total: usize = drawn.iter().map(|(_, weight)| weight).sum();
        for _ in 0..6 {
            let mut at = self.random.below(total);
            for &(instruction, weight) in &drawn {
                if at < weight {
                    if let Some(text) = self.call(instruction) {
                        return self.sometimes(instruction, text);
                    }
                    break;
                }
                at -= weight;
            }
            self.control = None;
        }
        "NOP()".to_owned()
    }

    /// RET and TND stand behind a condition, or most routines would end at their first.
    fn sometimes(&mut self, instruction: &Instruction, text: String) -> String {
        if instruction.position == Position::Ending { format!("{}{}{text}", self.input(), self.input()) } else { text }
    }

    /// An instruction that computes the rung condition.
    pub fn input(&mut self) -> String {
        self.drawn(|position| position == Position::Input)
    }

    /// An instruction that acts.
    pub fn output(&mut self) -> String {
        if !self.shared.add_ons.is_empty() && self.random.percent(6) {
            return self.add_on_call().unwrap_or_else(|| "NOP()".to_owned());
        }
        self.drawn(|position| matches!(position, Position::Output | Position::Ending))
    }

    fn add_on_call(&mut self) -> Option<String> {
        let which = self.random.below(self.shared.add_ons.len());
        let add_on = &self.shared.add_ons[which];
        let again = !add_on.guards;
        let known: Vec<String> =
            self.instances.iter().filter(|(one, _)| *one == which).map(|(_, name)| name.clone()).collect();
        let mut arguments = Vec::new();
        for parameter in &add_on.parameters {
            arguments.push(match parameter.passing {
                Passing::InOut if matches!(parameter.kind, Kind::Backing(_)) => {
                    self.declare("Guard", parameter.kind, Role::Owned)
                }
                Passing::InOut => {
                    let (kind, dimensions) = (parameter.kind, parameter.dimensions);
                    self.constant_place(|place| {
                        // An InOut BOOL takes no bit of an integer, which an alias may be.
                        let is_alias = !matches!(place.parts.first(), Some(Part::Text(name)) if *name == place.base);
                        place.kind == kind
                            && !(kind.is_bit() && is_alias)
                            && place.writable
                            && place.dimensions[0] >= dimensions[0]
                            && place.is_array() == (dimensions[0] > 0)
                            && place.dimensions[1..] == dimensions[1..]
                    })?
                    .text
                }
                passing => {
                    let writes = passing == Passing::Output;
                    let access = if writes { twinrung_catalog::Access::Write } else { twinrung_catalog::Access::Read };
                    if parameter.kind.is_bit() {
                        if !writes && self.random.percent(10) {
                            self.random.of(&["0", "1"]).to_string()
                        } else {
                            self.passed(parameter.kind, writes)?
                        }
                    } else {
                        self.number(access, false)?
                    }
                }
            });
        }
        let instance = if again && !known.is_empty() && self.random.percent(25) {
            self.random.of(&known).clone()
        } else {
            let name = self.declare("Instance", Kind::Instance(which), Role::Owned);
            self.instances.push((which, name.clone()));
            name
        };
        arguments.insert(0, instance);
        Some(format!("{}({})", add_on.name, arguments.join(",")))
    }

    /// A loop that counts its rounds; rarely one that nothing bounds.
    fn bounded_loop(&mut self, rungs: &mut Vec<String>) {
        self.fresh += 1;
        let label = format!("Again{}", self.fresh);
        let count = self.declare("Count", Kind::Element(twinrung_catalog::Element::Dint), Role::Owned);
        rungs.push(format!("CLR({count})"));
        rungs.push(format!("LBL({label})ADD({count},1,{count})"));
        for _ in 0..self.random.between(1, 3) {
            let rung = self.labelled_rung();
            rungs.push(rung);
        }
        // At 1,001 jumps back a routine has come to no end: just below, at, and beyond.
        let rounds =
            if self.random.one_in(60) { *self.random.of(&[1001, 1002, 2000]) } else { self.random.between(1, 5) };
        rungs.push(format!("LES({count},{rounds})JMP({label})"));
    }

    /// A zone of MCR.
    fn zone(&mut self, rungs: &mut Vec<String>) {
        let begin = match self.random.below(5) {
            0 => format!("{}[{}MCR() ,{}]", self.input(), self.input(), self.output()),
            _ => format!("{}MCR()", self.input()),
        };
        rungs.push(begin);
        for _ in 0..self.random.between(1, 4) {
            let rung = self.labelled_rung();
            rungs.push(rung);
        }
        rungs.push("MCR()".to_owned());
    }

    /// Values for the members of structures that random writes leave alone: those of an instruction before, or any.
    fn written_member(&mut self) -> String {
        let condition = self.input();
        let of_an_instruction = match self.random.below(4) {
            0 => self.owned.last().cloned(),
            1 if !self.owned.is_empty() => Some(self.random.of(&self.owned.clone()).clone()),
            _ => None,
        };
        let (kind, text) = if let Some(own) = of_an_instruction {
            own
        } else {
            let fits = |place: &Place| place.kind.is_structure() && !place.is_array() && place.writable;
            match self.place(fits) {
                Some(named) => (named.kind, named.text),
                None => return format!("{condition}NOP()"),
            }
        };
        let (member, value) = match kind {
            Kind::Counter => (*self.random.of(&["PRE", "ACC"]), literals::integer(self.random)),
            Kind::Control => (*self.random.of(&["LEN", "POS"]), self.also_negative(6)),
            _ => (*self.random.of(&["PRE", "ACC"]), self.also_negative(80)),
        };
        format!("{condition}MOV({value},{text}.{member})")
    }

    /// A position that is set before the instruction in its own rung is there when it starts: one that another rung has set is
    /// seldom left by then.
    pub fn with_its_position(&mut self, call: String) -> String {
        match self.control.take() {
            Some(control) if self.random.one_in(16) => {
                let position = self.also_negative(6);
                format!("{}MOV({position},{control}.POS){call}", self.input())
            }
            _ => call,
        }
    }

    /// A number below a limit, or sometimes one below 0, which is a fault in most members.
    fn also_negative(&mut self, limit: usize) -> i32 {
        let number = self.random.below(limit) as i32;
        if self.random.one_in(6) { -1 - number } else { number }
    }

    /// A fault that the program raises itself.
    fn raised_fault(&mut self) -> Option<String> {
        let fault_routine = self.fault_routine.clone().filter(|_| !self.in_add_on)?;
        let storage = self.declare("Storage", Kind::Element(twinrung_catalog::Element::Bool), Role::Owned);
        let (first, second) = (self.input(), self.input());
        Some(format!("{first}{second}ONS({storage})JSR({fault_routine},1,{})", self.random.between(990, 999)))
    }
}
