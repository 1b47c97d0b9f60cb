//! Executes a random program with safety inputs that nobody knows: a bit is 0, 1, or whatever the safety inputs make it.
//! What is 1 here is 1 whatever the safety inputs are; so standard data alone has made it 1.

use crate::programs::{Bit, DONE, ENABLE_OUT, Element, GIVEN, GO, NAMES, ONCE, Program, SAFETY, STANDARD, TAKEN};

/// Nothing: not known.
type Value = Option<bool>;
type State = Vec<Value>;

/// Scans of a run.
pub const SCANS: usize = 3;
/// More decisions that are not known are not followed in one scan.
const DECISIONS: usize = 9;

fn and(left: Value, right: Value) -> Value {
    match (left, right) {
        (Some(false), _) | (_, Some(false)) => Some(false),
        (Some(true), Some(true)) => Some(true),
        _ => None,
    }
}

fn not(value: Value) -> Value {
    value.map(|known| !known)
}

fn or(left: Value, right: Value) -> Value {
    not(and(not(left), not(right)))
}

fn either(left: Value, right: Value) -> Value {
    if left == right { left } else { None }
}

/// How a rung goes on.
enum Exit {
    Jump(usize),
    End,
    /// Whether it is known that this RET is executed.
    Return(bool),
}

/// One scan with one decision for each question that the safety inputs would answer.
struct Scan<'p> {
    program: &'p Program,
    state: State,
    /// Whether the zone of MCR is enabled.
    zone: Value,
    at: usize,
    went_back: bool,
    /// Whether it is known that this is executed.
    known: bool,
    decisions: Vec<bool>,
    asked: usize,
}

impl Scan<'_> {
    fn decide(&mut self, value: Value) -> bool {
        if let Some(known) = value {
            return known;
        }
        if self.asked == self.decisions.len() {
            self.decisions.push(false);
        }
        self.asked += 1;
        self.decisions[self.asked - 1]
    }

    /// A call of the Add-On Instruction; gives the rung condition behind it.
    fn gate(&mut self, given: Bit, taken: Bit, condition: Value) -> Value {
        let program = self.program;
        let (outer, zone) = (self.known, self.zone);
        self.known &= condition.is_some();
        self.set(ENABLE_OUT, condition);
        // Its rungs begin true whatever the zone.
        self.zone = Some(true);
        let runs = [(condition != Some(false), &program.logic), (condition != Some(true), &program.when_false)];
        for (runs, rungs) in runs {
            if runs && !rungs.is_empty() {
                self.set(GO, self.state[given]);
                self.routine(rungs);
                self.set(taken, self.state[DONE]);
            }
        }
        let ran = condition == Some(true) || !program.when_false.is_empty();
        let out = self.state[ENABLE_OUT];
        (self.known, self.zone) = (outer, zone);
        if ran { out } else { and(condition, out) }
    }

    fn set(&mut self, bit: Bit, value: Value) {
        self.state[bit] = value.filter(|_| self.known);
    }

    /// Gives whether a RET ended it, and whether that is known.
    fn routine(&mut self, rungs: &[Vec<Element>]) -> Option<bool> {
        let mut at = 0;
        while at < rungs.len() {
            self.at = at;
            match self.series(&rungs[at], self.zone) {
                Ok(_) => at += 1,
                Err(Exit::Jump(to)) => at = to,
                Err(Exit::End) => return None,
                Err(Exit::Return(known)) => return Some(known),
            }
        }
        None
    }

    fn series(&mut self, elements: &[Element], condition: Value) -> Result<Value, Exit> {
        let mut condition = condition;
        for element in elements {
            match element {
                Element::Contact(bit, inverted) => {
                    let value = self.state[*bit];
                    condition = and(condition, if *inverted { not(value) } else { value });
                }
                Element::OneShot(bit) => {
                    let pulse = and(condition, not(self.state[*bit]));
                    self.set(*bit, condition);
                    condition = pulse;
                }
                Element::Coil(bit) => self.set(*bit, condition),
                // A latch that is not executed, or that changes nothing, leaves the bit known.
                Element::Latch(bit) | Element::Unlatch(bit)
                    if condition == Some(false) || self.state[*bit] == Some(matches!(element, Element::Latch(_))) => {}
                Element::Latch(bit) => self.set(*bit, or(self.state[*bit], condition)),
                Element::Unlatch(bit) => self.set(*bit, and(self.state[*bit], not(condition))),
                Element::Branch(legs) => {
                    let mut sum = Some(false);
                    for leg in legs {
                        sum = or(sum, self.series(leg, condition)?);
                    }
                    condition = sum;
                }
                // A second round is not begun: `Turn` has been set.
                Element::Jump(to) if *to <= self.at && self.went_back => {}
                Element::Jump(to) if self.decide(condition) => {
                    self.went_back |= *to <= self.at;
                    // In a zone that is disabled nothing jumps.
                    self.zone = Some(true);
                    return Err(Exit::Jump(*to));
                }
                Element::End if self.decide(condition) => return Err(Exit::End),
                Element::Return if self.decide(condition) => return Err(Exit::Return(condition.is_some())),
                Element::Call(given, taken) if condition != Some(false) => {
                    // The condition of a call stands in series with all that the routine writes.
                    let outer = self.known;
                    self.known &= condition.is_some();
                    self.set(GIVEN, self.state[*given]);
                    let program = self.program;
                    if let Some(known) = self.routine(&program.part) {
                        self.set(*taken, self.state[TAKEN].filter(|_| known));
                    }
                    self.known = outer;
                }
                Element::Gate(given, taken) => condition = self.gate(*given, *taken, condition),
                // An unconditional MCR ends the zone, another begins one.
                Element::Zone if elements.len() == 1 => self.zone = Some(true),
                Element::Zone => self.zone = and(self.zone, condition),
                Element::Jump(_) | Element::End | Element::Return | Element::Call(..) => {}
            }
        }
        Ok(condition)
    }
}

/// Every scan that the safety inputs may make of this one, as one state; nothing when there are too many.
fn scan(program: &Program, state: &State) -> Option<State> {
    let mut decisions = Vec::new();
    let mut all: Option<State> = None;
    loop {
        let mut one = Scan {
            program,
            state: state.clone(),
            zone: Some(true),
            at: 0,
            went_back: false,
            known: true,
            decisions,
            asked: 0,
        };
        one.routine(&program.main);
        if one.decisions.len() > DECISIONS {
            return None;
        }
        let values = one.state;
        all = Some(match all {
            Some(known) => known.iter().zip(&values).map(|(left, right)| either(*left, *right)).collect(),
            None => values,
        });
        decisions = one.decisions;
        decisions.truncate(one.asked);
        while decisions.last() == Some(&true) {
            decisions.pop();
        }
        match decisions.last_mut() {
            Some(last) => *last = true,
            None => return all,
        }
    }
}

/// What a bit is at the end of each scan, when the standard inputs are as these numbers say, bit by bit.
pub fn run(program: &Program, standard: [usize; SCANS], output: Bit) -> Option<[Value; SCANS]> {
    let mut state: State = (0..NAMES.len()).map(|bit| Some(program.set.contains(&bit))).collect();
    // A prescan clears what a coil writes, and sets the storage bit of a one-shot.
    let mut coils = Vec::new();
    program.main.iter().chain(&program.part).chain(&program.logic).for_each(|rung| prescan(rung, &mut coils));
    coils.iter().for_each(|bit| state[*bit] = Some(false));
    state[ONCE] = Some(true);
    SAFETY.iter().for_each(|bit| state[*bit] = None);
    let mut found = [None; SCANS];
    for (at, given) in standard.into_iter().enumerate() {
        STANDARD.iter().enumerate().for_each(|(place, bit)| state[*bit] = Some(given >> place & 1 != 0));
        state = scan(program, &state)?;
        found[at] = state[output];
    }
    Some(found)
}

fn prescan(elements: &[Element], coils: &mut Vec<Bit>) {
    for element in elements {
        match element {
            Element::Coil(bit) => coils.push(*bit),
            // `Done` is copied out; it begins with 0.
            Element::Gate(_, taken) => coils.push(*taken),
            Element::Branch(legs) => legs.iter().for_each(|leg| prescan(leg, coils)),
            _ => {}
        }
    }
}

/// Whether standard data alone makes the output 1 in some scan, and other standard data does not.
pub fn standard_data_alone_decides(program: &Program, output: Bit) -> bool {
    let choices = 1 << STANDARD.len();
    let mut is_on = [false; SCANS];
    let mut is_not = [false; SCANS];
    for number in 0..usize::pow(choices, SCANS as u32) {
        let standard = std::array::from_fn(|scan| number / usize::pow(choices, scan as u32) % choices);
        let Some(values) = run(program, standard, output) else { continue };
        for (at, value) in values.into_iter().enumerate() {
            is_on[at] |= value == Some(true);
            is_not[at] |= value != Some(true);
        }
    }
    (0..SCANS).any(|scan| is_on[scan] && is_not[scan])
}
