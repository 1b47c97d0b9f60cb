//! The instructions that one program is written with.
//!
//! A mistake that shows only where something is absent (no other instruction writes presets, nothing but a constant is moved)
//! hides in programs that use everything. So some programs draw from a few instructions alone.

use twinrung_catalog::instructions::ALL;
use twinrung_catalog::{Group, Instruction, Opcode};

use super::random::Random;

/// How often each instruction of the catalog is drawn in relation to others, in the order of the catalog.
#[derive(Debug, Clone)]
pub struct Palette {
    weights: Vec<usize>,
}

impl Default for Palette {
    /// All instructions.
    fn default() -> Palette {
        Palette { weights: ALL.iter().map(|instruction| weight(instruction)).collect() }
    }
}

impl Palette {
    /// All instructions, or in one of three programs a few of them.
    pub fn of(random: &mut Random) -> Palette {
        let mut palette = Palette::default();
        if random.one_in(3) {
            let kept = *random.of(&[4, 8, 16, 32]);
            for (weight, instruction) in palette.weights.iter_mut().zip(ALL) {
                // Without these no rung has a condition, or acts.
                let is_needed = matches!(instruction.opcode, Opcode::Xic | Opcode::Ote);
                if !is_needed && !random.percent(kept) {
                    *weight = 0;
                }
            }
        }
        palette
    }

    /// The instructions with their weights.
    pub fn iter(&self) -> impl Iterator<Item = (&'static Instruction, usize)> + '_ {
        ALL.iter().copied().zip(self.weights.iter().copied())
    }
}

fn weight(instruction: &Instruction) -> usize {
    match (instruction.opcode, instruction.group) {
        // These have a group of rungs of their own, or stand at the end of a path.
        (Opcode::Mcr | Opcode::Jmp | Opcode::Lbl | Opcode::Sbr, _) => 0,
        (Opcode::Ret | Opcode::Tnd, _) => 1,
        (Opcode::Afi | Opcode::Nop, _) => 2,
        (Opcode::Ssv, _) => 1,
        (_, Group::Bit) => 12,
        _ => 5,
    }
}
