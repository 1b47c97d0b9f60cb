//! Kinds of paths from rail to coil, and what becomes of them in series, in parallel and in a computation.

/// A set of kinds of paths. A path is of one kind: it holds data of neither origin, unqualified data only, data of safety
/// origin only, or both (then the unqualified data is qualified).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) struct Kinds(u8);

/// How two kinds make one.
fn joined(left: u8, right: u8, one: impl Fn(u8, u8) -> u8) -> u8 {
    let mut result = 0;
    for a in [1, 2, 4, 8] {
        for b in [1, 2, 4, 8] {
            if left & a != 0 && right & b != 0 {
                result |= one(a, b);
            }
        }
    }
    result
}

type Table = [[u8; 16]; 16];

fn table(one: impl Fn(u8, u8) -> u8) -> Table {
    let mut table = [[0; 16]; 16];
    for (left, row) in table.iter_mut().enumerate() {
        for (right, result) in row.iter_mut().enumerate() {
            *result = joined(left as u8, right as u8, &one);
        }
    }
    table
}

static SERIES: std::sync::LazyLock<Table> = std::sync::LazyLock::new(|| {
    table(|a, b| match (a, b) {
        (1, other) | (other, 1) => other,
        (a, b) if a == b => a,
        _ => 8,
    })
});

static MIXED: std::sync::LazyLock<Table> = std::sync::LazyLock::new(|| {
    table(|a, b| match (a, b) {
        (2, _) | (_, 2) => 2,
        (8, _) | (_, 8) => 8,
        (4, _) | (_, 4) => 4,
        _ => 1,
    })
});

impl Kinds {
    /// No path at all.
    pub const NONE: Kinds = Kinds(0);
    /// A path that holds data of neither origin: constants, connection states, system values.
    pub const NEUTRAL: Kinds = Kinds(1);
    /// A path that holds unqualified data, and none of safety origin.
    pub const UNQUALIFIED: Kinds = Kinds(2);
    /// A path that holds data of safety origin, and none that is unqualified.
    pub const SAFETY: Kinds = Kinds(4);
    /// A path that holds both.
    pub const QUALIFIED: Kinds = Kinds(8);

    /// Whether a path of unqualified data alone is among them.
    pub fn has_unqualified(self) -> bool {
        self.0 & 2 != 0
    }

    /// The others.
    pub fn without_unqualified(self) -> Kinds {
        Kinds(self.0 & !2)
    }

    /// Whether there is no path.
    pub fn is_none(self) -> bool {
        self.0 == 0
    }

    /// Paths of either.
    pub fn or(self, other: Kinds) -> Kinds {
        Kinds(self.0 | other.0)
    }

    /// Whether all of `other` are among them.
    pub fn holds(self, other: Kinds) -> bool {
        self.0 & other.0 == other.0
    }

    /// Whether a path of neither origin is among them.
    pub fn has_neutral(self) -> bool {
        self.0 & 1 != 0
    }
}

/// Kinds of paths, and the place that brought a path of unqualified data alone.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Value {
    /// The kinds.
    pub kinds: Kinds,
    /// Which read brought the unqualified data; [`NOWHERE`] where there is none.
    pub from: u32,
}

/// No read.
pub(crate) const NOWHERE: u32 = u32::MAX;

impl Value {
    /// No path.
    pub const NONE: Value = Value { kinds: Kinds::NONE, from: NOWHERE };
    /// A path of neither origin.
    pub const NEUTRAL: Value = Value { kinds: Kinds::NEUTRAL, from: NOWHERE };
    /// A path of safety origin.
    pub const SAFETY: Value = Value { kinds: Kinds::SAFETY, from: NOWHERE };

    /// One after the other: a path through both.
    pub fn series(self, other: Value) -> Value {
        let kinds = Kinds(SERIES[usize::from(self.kinds.0)][usize::from(other.kinds.0)]);
        let through_self = self.kinds.has_unqualified() && (other.kinds.has_neutral() || other.kinds.has_unqualified());
        let from = match (kinds.has_unqualified(), through_self) {
            (false, _) => NOWHERE,
            (true, true) => self.from,
            (true, false) => other.from,
        };
        Value { kinds, from }
    }

    /// Beside each other: a path through either.
    pub fn either(self, other: Value) -> Value {
        let from = if self.kinds.has_unqualified() { self.from } else { other.from };
        Value { kinds: self.kinds.or(other.kinds), from }
    }

    /// Computed from both: what is unqualified decides alone, whatever it is computed with.
    pub fn mixed(self, other: Value) -> Value {
        let kinds = Kinds(MIXED[usize::from(self.kinds.0)][usize::from(other.kinds.0)]);
        let from = match (kinds.has_unqualified(), self.kinds.has_unqualified()) {
            (false, _) => NOWHERE,
            (true, true) => self.from,
            (true, false) => other.from,
        };
        Value { kinds, from }
    }

    /// The paths of unqualified data alone.
    pub fn spoil(self) -> Value {
        if self.kinds.has_unqualified() { Value { kinds: Kinds::UNQUALIFIED, from: self.from } } else { Value::NONE }
    }

    /// What an input that can spoil and cannot qualify adds to a path.
    pub fn taint(self) -> Value {
        let spoils = if self.kinds.has_unqualified() { Kinds::UNQUALIFIED } else { Kinds::NONE };
        Value { kinds: Kinds::NEUTRAL.or(spoils), from: self.from }
    }
}

/// A rung condition: the kinds of paths on which it is true, and the kinds of cuts by which it is false.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Condition {
    /// What makes it true.
    pub on: Value,
    /// What makes it false.
    pub off: Value,
}

impl Condition {
    /// The rail: true, and never false.
    pub const RAIL: Condition = Condition { on: Value::NEUTRAL, off: Value::NONE };

    /// Both, one after the other: true when both are, false when either is.
    pub fn series(self, other: Condition) -> Condition {
        Condition { on: self.on.series(other.on), off: self.off.either(other.off) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn unqualified() -> Value {
        Value { kinds: Kinds::UNQUALIFIED, from: 7 }
    }

    #[test]
    fn series_when_safety_data_follows_then_qualified() {
        assert_eq!(unqualified().series(Value::SAFETY).kinds, Kinds::QUALIFIED);
    }

    #[test]
    fn series_when_a_constant_follows_then_still_unqualified_and_the_place_is_known() {
        assert_eq!(unqualified().series(Value::NEUTRAL), unqualified());
        assert_eq!(Value::NEUTRAL.series(unqualified()), unqualified());
    }

    #[test]
    fn mixed_when_computed_with_safety_data_then_still_unqualified() {
        assert_eq!(Value::SAFETY.mixed(unqualified()), unqualified());
    }

    #[test]
    fn either_when_safety_data_is_beside_then_both_paths_stay() {
        let both = unqualified().either(Value::SAFETY);
        assert!(both.kinds.has_unqualified() && both.kinds.holds(Kinds::SAFETY));
    }
}
