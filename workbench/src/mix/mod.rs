//! Synthetic safety programs with a known mix of rungs, so that anybody can compare: the same program for the same rungs,
//! mix and seed on every machine.
//!
//! - `simple`: rung i is `XIC(a)XIO(b)[XIC(c) ,XIC(d) ]OTE(y_i)`: one shape, for comparing engines.
//! - `plant`: one to ten elements in series (mostly one to three), up to two of them branches of two to six legs (mostly
//!   two), nested up to three deep, empty legs and both kinds of contact among them, latches beside coils.
//!
//! In both every tenth rung also drives a timer, and every fifth has, in turn, an ADD, a MOV or a comparison. Operands are 256
//! inputs x, coils y of earlier and later rungs, and done bits of timers.

mod text;
mod toggles;

use std::fmt;
use std::str::FromStr;

pub use toggles::{Toggles, hash};

/// Inputs of every mix.
pub const INPUTS: usize = 256;
/// Period of its safety task in ms.
pub const PERIOD_MS: u64 = 10;
/// Seed of the program: multiplied by an odd number that depends on the caller's.
const SEED: u64 = 0x2545_F491_4F6C_DD1D;

/// Which mix.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Mix {
    /// One shape of rung.
    Simple,
    /// Rungs as plants have them.
    Plant,
}

impl FromStr for Mix {
    type Err = String;

    fn from_str(text: &str) -> Result<Mix, String> {
        match text {
            "simple" => Ok(Mix::Simple),
            "plant" => Ok(Mix::Plant),
            _ => Err("a mix is `simple` or `plant`".to_owned()),
        }
    }
}

impl fmt::Display for Mix {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Mix::Simple => "simple",
            Mix::Plant => "plant",
        })
    }
}

/// A generated program.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Program {
    rungs: Vec<Rung>,
}

#[derive(Debug, Clone, PartialEq, Eq)]
struct Rung {
    network: Vec<Part>,
    comparison: Option<usize>,
    coil: Coil,
    timer: Option<(usize, u32)>,
    number: Option<Number>,
}

#[derive(Debug, Clone, PartialEq, Eq)]
enum Part {
    Contact { closed: bool, operand: Operand },
    Branch(Vec<Vec<Part>>),
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Operand {
    Input(usize),
    Coil(usize),
    Done(usize),
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Coil {
    Energize,
    Latch,
    Unlatch,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Number {
    Count(usize),
    Copy { from: usize, to: usize },
}

/// Branches within branches.
const DEPTH: usize = 3;

struct Generator {
    state: u64,
    rungs: usize,
    timers: usize,
}

impl Program {
    /// Generates. Seeds count from 1.
    pub fn new(mix: Mix, rungs: usize, seed: u64) -> Program {
        let odd = seed.wrapping_mul(2).wrapping_sub(1);
        let mut generator = Generator { state: SEED.wrapping_mul(odd), rungs, timers: rungs / 10 };
        Program { rungs: (0..rungs).map(|index| generator.rung(mix, index)).collect() }
    }

    /// How many rungs it has.
    pub fn rungs(&self) -> usize {
        self.rungs.len()
    }
}

impl Generator {
    fn below(&mut self, limit: usize) -> usize {
        self.state ^= self.state << 13;
        self.state ^= self.state >> 7;
        self.state ^= self.state << 17;
        ((self.state >> 11) % limit.max(1) as u64) as usize
    }

    fn coil_operand(&mut self, rung: usize) -> usize {
        if rung == 0 {
            return self.below(self.rungs);
        }
        if self.below(10) < 8 {
            let low = rung.saturating_sub(200);
            return low + self.below(rung - low);
        }
        self.below(self.rungs)
    }

    fn operand(&mut self, rung: usize, input_percent: usize) -> Operand {
        let choice = self.below(100);
        if choice < input_percent {
            Operand::Input(self.below(INPUTS))
        } else if choice < 92 || self.timers == 0 {
            Operand::Coil(self.coil_operand(rung))
        } else {
            Operand::Done(self.below(self.timers))
        }
    }

    fn contact(&mut self, rung: usize) -> Part {
        let closed = self.below(3) == 0;
        Part::Contact { closed, operand: self.operand(rung, 60) }
    }

    /// A series. It nests at most [`DEPTH`] deep.
    fn network(&mut self, rung: usize, depth: usize) -> Vec<Part> {
        let length = if depth > 0 {
            1 + self.below(2)
        } else {
            let most = if self.below(4) > 0 { 3 } else { 10 };
            1 + self.below(most)
        };
        let mut branches = match depth {
            0 => self.below(3),
            1..DEPTH => usize::from(self.below(5) == 0),
            _ => 0,
        };
        let mut parts = Vec::with_capacity(length);
        for _ in 0..length {
            if branches > 0 && self.below(3) == 0 {
                branches -= 1;
                let legs = 2 + if self.below(4) == 0 { self.below(5) } else { 0 };
                let mut legs: Vec<Vec<Part>> = (0..legs).map(|_| self.network(rung, depth + 1)).collect();
                if self.below(12) == 0
                    && let Some(last) = legs.last_mut()
                {
                    last.clear();
                }
                parts.push(Part::Branch(legs));
            } else {
                parts.push(self.contact(rung));
            }
        }
        parts
    }

    fn simple(&mut self, rung: usize) -> Vec<Part> {
        let [a, b, c, d] = [60, 30, 60, 60].map(|percent| self.operand(rung, percent));
        let contact = |closed, operand| Part::Contact { closed, operand };
        let legs = vec![vec![contact(false, c)], vec![contact(false, d)]];
        vec![contact(false, a), contact(true, b), Part::Branch(legs)]
    }

    fn rung(&mut self, mix: Mix, index: usize) -> Rung {
        let (network, coil) = match mix {
            Mix::Simple => (self.simple(index), Coil::Energize),
            Mix::Plant => {
                let network = self.network(index, 0);
                let coil = match self.below(9) {
                    7 => Coil::Latch,
                    8 => Coil::Unlatch,
                    _ => Coil::Energize,
                };
                (network, coil)
            }
        };
        let timer = (index % 10 == 9).then(|| (index / 10, 20 + 10 * (index / 10 % 16) as u32));
        let (fifth, turn) = (index / 5, index / 5 % 3);
        let has_number = index % 5 == 4;
        Rung {
            network,
            comparison: (has_number && turn == 2).then(|| fifth - 2),
            coil,
            timer,
            number: match turn {
                0 if has_number => Some(Number::Count(fifth)),
                1 if has_number => Some(Number::Copy { from: fifth - 1, to: fifth }),
                _ => None,
            },
        }
    }
}
