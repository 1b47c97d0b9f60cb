//! Ranges of an analog channel: what they span, and where a signal leaves them. 1734-UM013, Safety Analog Input Module
//! Specifications. Amounts are in mV, µA and mHz.

/// What a channel measures.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Quantity {
    /// Amounts are mV.
    Voltage,
    /// Amounts are µA.
    Current,
    /// Pulses are counted; amounts are mHz.
    Frequency,
}

/// A range.
#[derive(Debug, PartialEq, Eq)]
pub struct Range {
    word: &'static str,
    low: i64,
    high: i64,
    /// Below this the signal is under range.
    under: i64,
    /// Above this it is over range.
    over: i64,
    /// What is measured.
    pub quantity: Quantity,
    /// The high engineering value that holds without a setting. (Table 21)
    default_high: i64,
}

const fn range(word: &'static str, (low, high): (i64, i64), under: i64, over: i64, quantity: Quantity) -> Range {
    Range { word, low, high, under, over, quantity, default_high: 10_000 }
}

/// 24 V at a voltage input, mV.
const SUPPLY_MV: i64 = 24_000;
/// What an input for currents takes at 24 V, µA: beyond any range, whatever it is (decided).
const SUPPLY_UA: i64 = 30_000;

static RANGES: [Range; 7] = [
    range("MA_4_20", (4_000, 20_000), 4_000, 20_000, Quantity::Current),
    range("MA_0_20", (0, 20_000), 500, 20_000, Quantity::Current),
    range("V_10", (-10_000, 10_000), -10_000, 10_000, Quantity::Voltage),
    range("V_5", (-5_000, 5_000), -5_000, 5_000, Quantity::Voltage),
    range("V_0_5", (0, 5_000), 250, 5_000, Quantity::Voltage),
    range("V_0_10", (0, 10_000), 500, 10_000, Quantity::Voltage),
    Range {
        word: "TACHOMETER",
        low: 0,
        high: 1_000_000,
        under: 0,
        over: 1_000_000,
        quantity: Quantity::Frequency,
        default_high: 1_000,
    },
];

impl Range {
    /// The range of a word; 4 to 20 mA without one. (Table 21)
    pub fn of(word: Option<&str>) -> &'static Range {
        let found = word.and_then(|word| RANGES.iter().find(|range| range.word.eq_ignore_ascii_case(word)));
        found.unwrap_or(&RANGES[0])
    }

    /// Whether the channel counts pulses.
    pub fn is_tachometer(&self) -> bool {
        self.quantity == Quantity::Frequency
    }

    /// What touches 24 V gives so much. (A level, not an amount, is what a tachometer gets.)
    pub fn supply(&self) -> i64 {
        match self.quantity {
            Quantity::Voltage => SUPPLY_MV,
            Quantity::Current => SUPPLY_UA,
            Quantity::Frequency => 0,
        }
    }

    /// Whether an amount is below the range.
    pub fn is_under(&self, amount: f64) -> bool {
        // A filter comes near its end value and does not reach it: what a thousandth cannot tell apart is equal.
        amount.round() < self.under as f64
    }

    /// Whether an amount is above the range.
    pub fn is_over(&self, amount: f64) -> bool {
        amount.round() > self.over as f64
    }
}

/// From the range to engineering units.
#[derive(Debug, Clone, PartialEq)]
pub struct Scaling {
    low: f64,
    high: f64,
}

impl Scaling {
    /// The engineering values of both ends; those of Table 21 where none are set.
    pub fn new(range: &Range, low: Option<i64>, high: Option<i64>) -> Scaling {
        Scaling { low: low.unwrap_or(0) as f64, high: high.unwrap_or(range.default_high) as f64 }
    }

    /// An amount in engineering units, to the nearest whole one (rounding decided), as a 16-bit integer.
    pub fn scaled(&self, range: &Range, amount: f64) -> i32 {
        let part = (amount - range.low as f64) / (range.high - range.low) as f64;
        let value = self.low + part * (self.high - self.low);
        value.round().clamp(f64::from(i16::MIN), f64::from(i16::MAX)) as i32
    }
}
