//! What a run has reached, and what there is to reach.

mod bits;
mod class;
mod form;
mod universe;
mod unreachable;

use std::fmt;

use twinrung_catalog::Opcode;

pub use bits::Bits;
pub use class::Class;
pub(crate) use form::operand;
pub(crate) use universe::forms;
pub use universe::{Point, Universe, What};
pub use unreachable::reason;

/// Opcodes are one byte; 0 stands for the call of an Add-On Instruction.
const OPCODES: usize = 256;

/// What was reached.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Coverage {
    /// For each opcode, evaluations with a false and with a true rung.
    seen: Vec<[u64; 2]>,
    /// Opcode times [`OPCODES`] plus the opcode evaluated after it on the same rung.
    pairs: Bits,
    /// Numbers of points.
    points: Bits,
}

impl Default for Coverage {
    fn default() -> Coverage {
        Coverage { seen: vec![[0; 2]; OPCODES], pairs: Bits::default(), points: Bits::default() }
    }
}

impl Coverage {
    pub(crate) fn evaluated(&mut self, opcode: u8, after: Option<u8>, condition: bool) {
        self.seen[usize::from(opcode)][usize::from(condition)] += 1;
        if let Some(after) = after {
            self.pairs.insert(u32::from(after) * OPCODES as u32 + u32::from(opcode));
        }
    }

    pub(crate) fn reached(&mut self, point: u32) -> bool {
        self.points.insert(point)
    }

    /// Adds what another run reached.
    pub fn add(&mut self, other: &Coverage) {
        for (sum, one) in self.seen.iter_mut().zip(&other.seen) {
            sum[0] += one[0];
            sum[1] += one[1];
        }
        self.pairs.add(&other.pairs);
        self.points.add(&other.points);
    }

    /// Evaluations of an instruction with a false and with a true rung.
    pub fn of(&self, opcode: Opcode) -> [u64; 2] {
        self.seen[usize::from(opcode as u8)]
    }

    /// Instructions that were evaluated one after the other on a rung, in ordered pairs.
    pub fn pairs(&self) -> usize {
        self.pairs.members().len()
    }

    /// The pairs, as numbers of opcodes; 0 is the call of an Add-On Instruction.
    pub fn pair_numbers(&self) -> impl Iterator<Item = (u8, u8)> {
        self.pairs.members().iter().map(|pair| ((pair / OPCODES as u32) as u8, (pair % OPCODES as u32) as u8))
    }

    /// Points that were reached.
    pub fn points(&self) -> usize {
        self.points.members().len()
    }

    /// Points that were not reached and are not argued to be out of reach.
    pub fn missing(&self) -> Vec<Point> {
        let all = Universe::get().points().iter().enumerate();
        let missing = all.filter(|(number, point)| !self.points.contains(*number as u32) && reason(point).is_none());
        missing.map(|(_, point)| *point).collect()
    }

    /// Points that were reached though the table says that they cannot be.
    pub fn against_the_table(&self) -> Vec<Point> {
        let points = Universe::get().points();
        let reached = self.points.members().iter().filter_map(|number| points.get(*number as usize));
        reached.filter(|point| reason(point).is_some()).copied().collect()
    }

    /// Points that there are to reach: all but those that are argued to be out of reach.
    pub fn reachable() -> usize {
        Universe::get().points().iter().filter(|point| reason(point).is_none()).count()
    }
}

impl fmt::Display for Coverage {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for opcode in Opcode::ALL {
            let [off, on] = self.of(*opcode);
            writeln!(f, "{:<6} {on:>12} true {off:>12} false", opcode.instruction().mnemonic)?;
        }
        let [off, on] = self.seen[0];
        writeln!(f, "Add-On {on:>12} true {off:>12} false")?;
        self.missing().iter().try_for_each(|point| writeln!(f, "not reached: {point}"))
    }
}
