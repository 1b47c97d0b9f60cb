//! Jumps within a routine: which rungs may be left out, or repeated, because of which of them.
//!
//! A JMP to a later label decides whether the rungs between are executed, TND and RET decide it for all that follow, a
//! JMP to an earlier label decides how often the rungs from there to itself are. Each of these runs of rungs gets the
//! reasons of its jump, by a tree of places: a run of rungs is a few nodes of it, and a rung sees all nodes above it.
//! What a jump within such a run decides depends on the first jump too, since the reasons of a rung are handed on.

use twinrung_catalog::Opcode;

use super::builder::Builder;
use super::places::Slot;
use crate::names::{Map, fold};
use crate::operand::Operand;
use crate::project::{Element, Instruction, Project, Rung};
use twinrung_grammar::tree::CompactString;

/// The jumps of one routine; of one instance of an Add-On Instruction.
#[derive(Default)]
pub(super) struct Jumps {
    /// For each rung what may leave it out or repeat it.
    spoils: Vec<Option<Slot>>,
    /// For each rung that may be left: where the reasons are gathered.
    leaves: Map<u32, Slot>,
    /// Rungs that a jump leads to, each with the rung of the jump.
    targets: Vec<(u32, u32)>,
}

impl Jumps {
    /// What may leave a rung out or repeat it.
    pub fn spoil(&self, rung: u32) -> Option<Slot> {
        self.spoils.get(rung as usize).copied().flatten()
    }

    /// Where the reasons are gathered for which a rung is left.
    pub fn leave(&self, rung: u32) -> Option<Slot> {
        self.leaves.get(&rung).copied()
    }

    /// Whether a jump leads from outside to one of these rungs other than the first.
    pub fn enters(&self, rungs: std::ops::RangeInclusive<u32>) -> bool {
        self.targets.iter().any(|(from, to)| to > rungs.start() && to <= rungs.end() && !rungs.contains(from))
    }
}

impl Builder<'_> {
    /// Looks at every jump of a routine, and makes the places that they need.
    pub(super) fn jumps(&mut self, rungs: &[Rung]) -> Jumps {
        let mut jumps = Jumps::default();
        if !self.project.opcodes.any(&[Opcode::Jmp, Opcode::Tnd, Opcode::Ret]) {
            return jumps;
        }
        let end = rungs.len() as u32;
        let mut runs = Vec::new();
        let labels = labels(self.project, rungs);
        for (number, rung) in rungs.iter().enumerate() {
            let number = number as u32;
            rung.visit(&mut |instruction| match instruction.call.opcode() {
                Some(Opcode::Jmp) => {
                    let label = label_name(self.project, instruction).and_then(|name| labels.get(&fold(name)));
                    // A label that is missing is another finding; the jump may then lead anywhere.
                    let to = label.copied().unwrap_or(end);
                    runs.push((number, if to > number { number + 1..to } else { to..number + 1 }));
                    jumps.targets.push((number, to));
                }
                Some(Opcode::Tnd | Opcode::Ret) => runs.push((number, number + 1..end)),
                _ => {}
            });
        }
        if runs.is_empty() {
            return jumps;
        }
        self.spread(end, &runs, &mut jumps);
        jumps
    }

    /// The tree of places over all rungs; the reasons of each jump lead to the nodes that make up its run.
    fn spread(&mut self, rungs: u32, runs: &[(u32, std::ops::Range<u32>)], jumps: &mut Jumps) {
        let size = rungs.next_power_of_two();
        let places = &mut self.network.places;
        let nodes: Vec<Slot> = (0..2 * size).map(|_| places.joint(None)).collect();
        for node in 2..2 * size {
            places.links.push((nodes[node as usize / 2], nodes[node as usize]));
        }
        // How many runs begin less those that end, so that rungs that nothing leaves out keep a rail of their own.
        let mut depth = vec![0i64; rungs as usize + 1];
        for (jump, run) in runs {
            let from = *jumps.leaves.entry(*jump).or_insert_with(|| places.joint(None));
            if run.is_empty() {
                continue;
            }
            depth[run.start as usize] += 1;
            depth[run.end as usize] -= 1;
            let (mut left, mut right) = (run.start + size, run.end + size);
            while left < right {
                if left % 2 == 1 {
                    places.links.push((from, nodes[left as usize]));
                    left += 1;
                }
                if right % 2 == 1 {
                    right -= 1;
                    places.links.push((from, nodes[right as usize]));
                }
                left /= 2;
                right /= 2;
            }
        }
        let mut covered = 0;
        jumps.spoils = (0..rungs)
            .map(|rung| {
                covered += depth[rung as usize];
                (covered > 0).then(|| nodes[(size + rung) as usize])
            })
            .collect();
    }
}

fn labels(project: &Project, rungs: &[Rung]) -> Map<CompactString, u32> {
    let mut labels = Map::default();
    for (at, rung) in rungs.iter().enumerate() {
        let first = first_instruction(&rung.elements).filter(|first| first.call.opcode() == Some(Opcode::Lbl));
        if let Some(name) = first.and_then(|first| label_name(project, first)) {
            labels.entry(fold(name)).or_insert(at as u32);
        }
    }
    labels
}

/// The instruction with which a rung begins, also within a branch.
pub(super) fn first_instruction(elements: &[Element]) -> Option<&Instruction> {
    let mut elements = elements;
    loop {
        match elements.first()? {
            Element::Instruction(first) => return Some(first),
            Element::Branch(branch) => elements = branch.legs.first()?,
        }
    }
}

fn label_name<'a>(project: &'a Project, instruction: &Instruction) -> Option<&'a str> {
    match project.operand(instruction.operands.first()?.id) {
        Operand::Text(label) => Some(label.as_str()),
        _ => None,
    }
}
