//! Wires between terminals: what is joined, and what level that gives.

use crate::stimulus::{Fault, Stimulus, Terminal};

/// A point of the wiring of one module.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Node(pub(crate) u8);

/// Nodes of one module: the two of the field power, and its terminals.
const NODES: usize = 16;

impl Node {
    /// 24 V of the field power.
    pub const SUPPLY: Node = Node(0);
    /// 0 V.
    pub const COMMON: Node = Node(1);

    pub(crate) const fn mask(self) -> u32 {
        1 << self.0
    }
}

/// Which nodes are joined. It is worked out when something at the terminals changes, not at each look.
#[derive(Debug, Clone)]
pub struct Wiring {
    /// For each node the nodes with which it is joined, itself among them.
    joined: [u32; NODES],
}

impl Default for Wiring {
    fn default() -> Wiring {
        Wiring { joined: std::array::from_fn(|node| 1 << node) }
    }
}

impl Wiring {
    /// Joins two nodes.
    pub fn join(&mut self, one: Node, other: Node) {
        let whole = self.joined(one) | self.joined(other);
        for (node, joined) in self.joined.iter_mut().enumerate() {
            if whole & (1 << node) != 0 {
                *joined = whole;
            }
        }
    }

    /// All nodes that are joined with a node.
    pub fn joined(&self, node: Node) -> u32 {
        self.joined.get(usize::from(node.0)).copied().unwrap_or_default()
    }

    /// Whether a node is joined with 0 V.
    pub fn is_grounded(&self, node: Node) -> bool {
        self.joined(node) & Node::COMMON.mask() != 0
    }

    /// Whether 24 V stand at a node while the nodes of a set are driven: outputs source current, so one of them is enough,
    /// and 0 V beats them all.
    pub fn is_high(&self, node: Node, driven: u32) -> bool {
        let joined = self.joined(node);
        joined & Node::COMMON.mask() == 0 && joined & driven != 0
    }
}

/// Faults of the wires of one module.
#[derive(Debug, Clone, Default)]
pub struct Faults {
    present: Vec<(Terminal, Fault)>,
}

impl Faults {
    /// A wire gets a fault.
    pub fn add(&mut self, terminal: Terminal, fault: Fault) {
        if !self.present.contains(&(terminal, fault)) {
            self.present.push((terminal, fault));
        }
    }

    /// One fault of a wire is gone, at whichever end it was named.
    pub fn remove(&mut self, terminal: Terminal, fault: Fault) {
        let mirrored = |own: Terminal, other: Fault| fault == Fault::To(own) && other == Fault::To(terminal);
        self.present.retain(|(own, other)| (*own, *other) != (terminal, fault) && !mirrored(*own, *other));
    }

    /// Every fault of a wire is gone, at whichever end it was named.
    pub fn repair(&mut self, terminal: Terminal) {
        self.present.retain(|(own, fault)| *own != terminal && *fault != Fault::To(terminal));
    }

    /// Whether a wire is broken.
    pub fn is_open(&self, terminal: Terminal) -> bool {
        self.present.contains(&(terminal, Fault::Open))
    }

    /// Whether the module's own circuit at a terminal is at fault.
    pub fn is_inside(&self, terminal: Terminal) -> bool {
        self.present.contains(&(terminal, Fault::Inside))
    }

    /// Joins what touches.
    pub fn join(&self, wiring: &mut Wiring, node: impl Fn(Terminal) -> Option<Node>) {
        for (terminal, fault) in &self.present {
            let Some(from) = node(*terminal) else { continue };
            let to = match fault {
                Fault::ToSupply => Some(Node::SUPPLY),
                Fault::ToCommon => Some(Node::COMMON),
                Fault::To(other) => node(*other),
                Fault::Open | Fault::Inside => None,
            };
            if let Some(to) = to {
                wiring.join(from, to);
            }
        }
    }
}

/// The wires of one module with their faults, and its field power.
#[derive(Debug, Clone)]
pub struct Field {
    /// What is wrong with the wires.
    pub faults: Faults,
    /// What that joins.
    pub wiring: Wiring,
    /// Whether field power is there.
    pub power: bool,
    node: fn(Terminal) -> Option<Node>,
}

impl Field {
    /// With power and without faults; `node` gives the node of each terminal of the module.
    pub fn new(node: fn(Terminal) -> Option<Node>) -> Field {
        Field { faults: Faults::default(), wiring: Wiring::default(), power: true, node }
    }

    /// Something happens to wires or power. Afterwards what faults join is joined, and nothing else.
    pub fn apply(&mut self, stimulus: &Stimulus) {
        match stimulus {
            Stimulus::Fault(terminal, fault) => self.faults.add(*terminal, *fault),
            Stimulus::FaultGone(terminal, fault) => self.faults.remove(*terminal, *fault),
            Stimulus::Repaired(terminal) => self.faults.repair(*terminal),
            Stimulus::FieldPower(on) => self.power = *on,
            Stimulus::Signal(..) | Stimulus::Present(_) | Stimulus::Running(_) => {}
        }
        self.wiring = Wiring::default();
        self.faults.join(&mut self.wiring, self.node);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const A: Node = Node(2);
    const B: Node = Node(3);
    const C: Node = Node(4);

    #[test]
    fn nodes_when_joined_in_a_row_then_the_ends_have_one_level() {
        let mut wiring = Wiring::default();
        wiring.join(A, B);
        wiring.join(B, C);
        assert!(wiring.is_high(C, A.mask()));
        assert!(!wiring.is_high(C, Node(5).mask()));
    }

    #[test]
    fn nodes_when_one_touches_0_v_then_all_are_low_whatever_drives() {
        let mut wiring = Wiring::default();
        wiring.join(A, B);
        wiring.join(B, Node::COMMON);
        assert!(!wiring.is_high(A, A.mask() | Node::SUPPLY.mask()));
        assert!(wiring.is_grounded(A));
    }

    #[test]
    fn fault_when_it_alone_is_gone_then_the_others_of_the_wire_stay() {
        let (one, other) = (Terminal::new('I', 0), Terminal::new('I', 1));
        let mut faults = Faults::default();
        faults.add(one, Fault::To(other));
        faults.add(one, Fault::Open);
        faults.remove(other, Fault::To(one));
        assert_eq!(faults.present, [(one, Fault::Open)]);
    }

    #[test]
    fn short_when_repaired_at_its_other_end_then_it_is_gone() {
        let (one, other) = (Terminal::new('I', 0), Terminal::new('I', 1));
        let mut faults = Faults::default();
        faults.add(one, Fault::To(other));
        faults.repair(other);
        let mut wiring = Wiring::default();
        faults.join(&mut wiring, |terminal| Some(Node(2 + terminal.number)));
        assert_eq!(wiring.joined(A), A.mask());
    }
}
