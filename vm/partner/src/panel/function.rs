//! What a series/parallel network of up to six contacts conducts, as a truth table over its cells.

/// Contacts of one network.
pub(crate) const CONTACTS: usize = 6;

/// The table of each contact by itself.
const ALONE: [u64; CONTACTS] = [
    0xAAAA_AAAA_AAAA_AAAA,
    0xCCCC_CCCC_CCCC_CCCC,
    0xF0F0_F0F0_F0F0_F0F0,
    0xFF00_FF00_FF00_FF00,
    0xFFFF_0000_FFFF_0000,
    0xFFFF_FFFF_0000_0000,
];

/// How two networks are joined.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Join {
    /// Both must conduct.
    Series,
    /// Either conducts.
    Parallel,
}

/// A network's conduction.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Function {
    count: u8,
    /// Whether it already holds everything from the rail on, not only what stands on its leg.
    pub(crate) from_rail: bool,
    cells: [u32; CONTACTS],
    /// Bit `x` is the conduction when contact `k` has the value of bit `k` of `x`.
    table: u64,
}

impl Function {
    /// A wire, or a gap.
    pub(crate) const fn constant(conducts: bool) -> Function {
        let table = if conducts { u64::MAX } else { 0 };
        Function { count: 0, from_rail: false, cells: [0; CONTACTS], table }
    }

    /// One contact.
    pub(crate) const fn contact(cell: u32, closed: bool) -> Function {
        let [first, ..] = ALONE;
        let table = if closed { first } else { !first };
        Function { count: 1, from_rail: false, cells: [cell, 0, 0, 0, 0, 0], table }
    }

    /// The cells of its contacts.
    pub(crate) fn cells(&self) -> &[u32] {
        self.cells.get(..usize::from(self.count)).unwrap_or(&[])
    }

    /// Whether a contact looks at the cell.
    pub(crate) fn looks_at(&self, cell: u32) -> bool {
        self.cells().contains(&cell)
    }

    /// The value, where it has no contact.
    pub(crate) fn as_constant(&self) -> Option<bool> {
        match self.table {
            u64::MAX => Some(true),
            0 => Some(false),
            _ => None,
        }
    }

    /// The cell, where the network is that cell's closed contact.
    pub(crate) fn as_cell(&self) -> Option<u32> {
        let [first, ..] = ALONE;
        match self.cells() {
            [cell] if self.table == first => Some(*cell),
            _ => None,
        }
    }

    /// Whether both conduct alike, by the same contacts in the same order.
    pub(crate) fn same(&self, other: &Function) -> bool {
        self.table == other.table && self.cells() == other.cells()
    }

    /// Conducts where this one does not.
    pub(crate) const fn inverted(mut self) -> Function {
        self.table = !self.table;
        self
    }

    /// Two networks joined; `None` when they have too many contacts together.
    pub(crate) fn join(&self, other: &Function, how: Join) -> Option<Function> {
        let mut joined = *self;
        let mut places = [0usize; CONTACTS];
        for (cell, place) in other.cells().iter().zip(places.iter_mut()) {
            let known = joined.cells().iter().position(|known| known == cell);
            *place = match known {
                Some(known) => known,
                None => {
                    let next = usize::from(joined.count);
                    *joined.cells.get_mut(next)? = *cell;
                    joined.count = joined.count.saturating_add(1);
                    next
                }
            };
        }
        let moved = other.moved(&places);
        joined.table = match how {
            Join::Series => joined.table & moved,
            Join::Parallel => joined.table | moved,
        };
        joined.from_rail = match how {
            Join::Series => self.from_rail || other.from_rail,
            Join::Parallel => self.from_rail && other.from_rail,
        };
        Some(joined)
    }

    /// The table with contact `k` in place `places[k]`.
    fn moved(&self, places: &[usize; CONTACTS]) -> u64 {
        let count = usize::from(self.count);
        if places.iter().take(count).enumerate().all(|(from, to)| from == *to) {
            return self.table;
        }
        let mut moved = 0u64;
        for row in 0..1u32 << count.min(CONTACTS) {
            if (self.table >> row) & 1 == 0 {
                continue;
            }
            let mut rows = u64::MAX;
            for (contact, place) in places.iter().take(count).enumerate() {
                let alone = ALONE.get(*place).copied().unwrap_or(0);
                rows &= if (row >> contact) & 1 == 1 { alone } else { !alone };
            }
            moved |= rows;
        }
        moved
    }

    /// Whether its contacts fit a panel of four.
    pub(crate) const fn fits_four(&self) -> bool {
        self.count <= 4
    }

    /// The table as a panel of six contacts holds it. A complemented byte is 255 less its cell's value, so that the
    /// weighted sum of six is 1 less the row, modulo 64; the panel stores complemented results.
    pub(crate) const fn table_of_six(&self) -> u64 {
        (!self.table).reverse_bits().rotate_left(2)
    }

    /// The table as a panel of four contacts holds it, whose weighted sum is 17 less the row, modulo 32.
    pub(crate) const fn table_of_four(&self) -> u32 {
        let rows = (self.table & 0xFFFF) as u32;
        (!(rows | (rows << 16))).reverse_bits().rotate_left(2)
    }

    /// The cells as a panel holds them; unused places repeat the first, or `spare`.
    pub(crate) fn panel_inputs<const PLACES: usize>(&self, spare: u32) -> [u32; PLACES] {
        let mut inputs = [self.cells().first().copied().unwrap_or(spare); PLACES];
        for (input, cell) in inputs.iter_mut().zip(self.cells()) {
            *input = *cell;
        }
        inputs
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn value(function: &Function, values: &[(u32, bool)]) -> bool {
        let lookup = |cell: u32| values.iter().any(|(known, value)| *known == cell && *value);
        let inputs = function.panel_inputs::<CONTACTS>(99);
        let sum: u64 = inputs.iter().enumerate().map(|(k, cell)| (0xFF ^ u64::from(lookup(*cell))) << k).sum();
        function.table_of_six().wrapping_shr(sum as u32) & 1 == 0
    }

    #[test]
    fn table_of_six_when_every_combination_is_looked_up_then_the_network_conducts_as_drawn() {
        // a, not b, (c or (d and not a)), in a table of four contacts.
        let inner = Function::contact(13, true).join(&Function::contact(10, false), Join::Series).unwrap();
        let branch = inner.join(&Function::contact(12, true), Join::Parallel).unwrap();
        let front = Function::contact(10, true).join(&Function::contact(11, false), Join::Series).unwrap();
        let network = front.join(&branch, Join::Series).unwrap();
        for row in 0..16u32 {
            let bit = |number: u32| (row >> number) & 1 == 1;
            let (a, b, c, d) = (bit(0), bit(1), bit(2), bit(3));
            let values = [(10, a), (11, b), (12, c), (13, d)];
            let inner = c || (d && !a);
            assert_eq!(value(&network, &values), a && !b && inner, "row {row}");
        }
    }

    #[test]
    fn table_of_four_when_every_combination_is_looked_up_then_as_that_of_six() {
        let network = Function::contact(1, true)
            .join(&Function::contact(2, false), Join::Series)
            .and_then(|network| network.join(&Function::contact(3, true), Join::Parallel))
            .and_then(|network| network.join(&Function::contact(4, false), Join::Series))
            .unwrap();
        for row in 0..16u64 {
            let sum: u64 = (0..4).map(|k| (0xFF ^ (row >> k & 1)) << k).sum();
            let six: u64 = (0..6).map(|k| (0xFF ^ (row >> k & 1)) << k).sum();
            let four = network.table_of_four().wrapping_shr(sum as u32) & 1;
            assert_eq!(u64::from(four), network.table_of_six().wrapping_shr(six as u32) & 1, "row {row}");
        }
    }

    #[test]
    fn join_when_seven_contacts_then_none() {
        let mut network = Function::constant(true);
        for cell in 0..6 {
            network = network.join(&Function::contact(cell, true), Join::Series).unwrap();
        }
        assert!(network.join(&Function::contact(3, false), Join::Parallel).is_some());
        assert!(network.join(&Function::contact(6, true), Join::Series).is_none());
    }

    #[test]
    fn table_of_six_when_constant_then_every_row_is_it() {
        assert_eq!(Function::constant(true).table_of_six(), 0);
        assert_eq!(Function::constant(false).table_of_six(), u64::MAX);
    }
}
