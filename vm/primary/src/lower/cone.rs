//! A small boolean function: up to four cells and a truth table. Contacts, branches and coils become such functions, and
//! every function that is stored becomes one gate.

/// Inputs of a gate.
pub(crate) const INPUTS: usize = 4;

/// A function of up to [`INPUTS`] signals.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Cone {
    /// The signals; entries from `count` on are unused.
    pub(crate) inputs: [u32; INPUTS],
    pub(crate) count: usize,
    /// Bit `i` is the value for the inputs whose bits spell `i`, first input lowest; unused inputs make no difference.
    pub(crate) table: u16,
}

/// How functions are combined.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Join {
    And,
    Or,
}

/// The value of each input, for each combination.
const VARIABLES: [u16; INPUTS] = [FIRST, 0xCCCC, 0xF0F0, 0xFF00];
/// That of the first.
const FIRST: u16 = 0xAAAA;

impl Cone {
    /// Always true.
    pub(crate) const TRUE: Cone = Cone { inputs: [0; INPUTS], count: 0, table: 0xFFFF };
    /// Always false.
    pub(crate) const FALSE: Cone = Cone { inputs: [0; INPUTS], count: 0, table: 0 };

    /// The value of a signal, or its inverse.
    pub(crate) fn literal(signal: u32, inverted: bool) -> Cone {
        Cone { inputs: [signal, 0, 0, 0], count: 1, table: if inverted { !FIRST } else { FIRST } }
    }

    /// The signal, where the function is just that.
    pub(crate) fn signal(&self) -> Option<u32> {
        let [first, ..] = self.inputs;
        (self.count == 1 && self.table == FIRST).then_some(first)
    }

    /// Its inputs.
    pub(crate) fn used(&self) -> impl Iterator<Item = u32> + '_ {
        self.inputs.iter().copied().take(self.count)
    }

    /// The inverse.
    pub(crate) fn inverse(self) -> Cone {
        Cone { table: !self.table, ..self }
    }

    /// Both functions joined, where the result fits into one gate.
    pub(crate) fn join(self, other: Cone, join: Join) -> Option<Cone> {
        let mut joined = self;
        let mut places = [0u32; INPUTS];
        for (place, signal) in places.iter_mut().zip(other.used()) {
            let known = joined.used().position(|known| known == signal);
            let position = match known {
                Some(position) => position,
                None => {
                    *joined.inputs.get_mut(joined.count)? = signal;
                    let position = joined.count;
                    joined.count = joined.count.saturating_add(1);
                    position
                }
            };
            *place = position as u32;
        }
        let spread = match (other.count, places) {
            // A literal; a constant with an input left over is spread like any other function.
            (1, [place, ..]) if other.table == FIRST || other.table == !FIRST => {
                let variable = VARIABLES.get(place as usize).copied().unwrap_or(0);
                if other.table == FIRST { variable } else { !variable }
            }
            _ => other.spread(places),
        };
        joined.table = match join {
            Join::And => self.table & spread,
            Join::Or => self.table | spread,
        };
        Some(joined)
    }

    /// The table with each input at another place.
    fn spread(&self, places: [u32; INPUTS]) -> u16 {
        let mut spread = 0u16;
        for combination in 0..16u32 {
            let mut index = 0u32;
            for (bit, place) in places.iter().enumerate().take(self.count) {
                index |= (combination.wrapping_shr(*place) & 1).wrapping_shl(bit as u32);
            }
            spread |= (self.table.wrapping_shr(index) & 1).wrapping_shl(combination);
        }
        spread
    }
}
