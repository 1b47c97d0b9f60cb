//! Contacts that follow an output: the auxiliary contacts of a contactor or relay.

use crate::stimulus::{AuxiliaryContact, Signal, Terminal};

/// A contact with what it shows.
#[derive(Debug, Clone)]
struct Contact {
    declared: AuxiliaryContact,
    closed: bool,
    /// Since when its output has wanted the opposite, ms.
    since_ms: Option<u64>,
}

impl Contact {
    /// It stands as the output does at that moment: a contactor that is there when time begins has moved before.
    fn new(declared: AuxiliaryContact, high: bool) -> Contact {
        Contact { declared, closed: declared.wants(high), since_ms: None }
    }

    fn look(&mut self, now_ms: u64, high: bool) {
        if self.declared.wants(high) == self.closed {
            self.since_ms = None;
            return;
        }
        let since_ms = *self.since_ms.get_or_insert(now_ms);
        if now_ms.saturating_sub(since_ms) >= self.declared.delay_ms {
            self.closed = !self.closed;
            self.since_ms = None;
        }
    }
}

/// The contacts at one terminal, in series.
#[derive(Debug, Clone)]
struct Circuit {
    module: usize,
    terminal: Terminal,
    contacts: Vec<Contact>,
    /// Whether the terminal was last told that they are closed.
    told: Option<bool>,
}

/// All contacts of a plant that follow outputs.
#[derive(Debug, Clone, Default)]
pub(crate) struct Followers {
    circuits: Vec<Circuit>,
}

impl Followers {
    /// A device changes; `is_high` tells whether 24 V reach what is wired to an output. What follows an output at this terminal
    /// follows it no longer, unless it is said anew.
    pub(crate) fn apply(
        &mut self,
        module: usize,
        terminal: Terminal,
        signal: &Signal,
        is_high: impl Fn(usize, Terminal) -> bool,
    ) {
        self.circuits.retain(|circuit| (circuit.module, circuit.terminal) != (module, terminal));
        if let Signal::Follows(series) = signal {
            let contacts = series.contacts().map(|one| Contact::new(*one, is_high(one.module, one.output))).collect();
            self.circuits.push(Circuit { module, terminal, contacts, told: None });
        }
    }

    /// Outputs are looked at at a time in ms: contacts move that have waited long enough.
    pub(crate) fn look(&mut self, now_ms: u64, is_high: impl Fn(usize, Terminal) -> bool) {
        for contact in self.circuits.iter_mut().flat_map(|circuit| &mut circuit.contacts) {
            contact.look(now_ms, is_high(contact.declared.module, contact.declared.output));
        }
    }

    /// Where contacts are closed now that were open, or are open that were closed.
    pub(crate) fn moved(&mut self) -> impl Iterator<Item = (usize, Terminal, bool)> + '_ {
        self.circuits.iter_mut().filter_map(|circuit| {
            let closed = circuit.contacts.iter().all(|contact| contact.closed);
            (circuit.told.replace(closed) != Some(closed)).then_some((circuit.module, circuit.terminal, closed))
        })
    }
}
