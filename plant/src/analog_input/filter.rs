//! The input filter: a pole at 10 Hz, then four equal poles. The manual gives the time to 63 % of a step and the corner of the
//! whole (1734-UM013, Step Response and Filter Response): 450, 125, 72, 25 ms, and 0.68, 2.62, 4.75, 10.2 Hz. The share by which
//! a pole follows in a ms is chosen so that the times are met; the corners come out at 0.69, 2.62, 4.56 and 9.29 Hz.

/// Share of the pole at 10 Hz: 1 - exp(-1 ms / 15.9 ms).
const FIRST: f64 = 0.060_898_632_575_707;
/// Word of the setting and share of each of the four poles.
const SHARES: [(&str, f64); 4] = [
    ("HZ_1", 0.009_960_080_534_661),
    ("HZ_5", 0.039_163_014_891_833),
    ("HZ_10", 0.075_055_919_741_546),
    ("HZ_50", 0.351_003_515_744_133),
];

/// A filter with what it holds.
#[derive(Debug, Clone)]
pub struct Filter {
    share: f64,
    poles: Option<[f64; 5]>,
}

impl Filter {
    /// The filter of a word; 1 Hz without one. It begins with the first amount that it gets (decided).
    pub fn new(word: Option<&str>) -> Filter {
        let found = word.and_then(|word| SHARES.iter().find(|(own, _)| own.eq_ignore_ascii_case(word)));
        Filter { share: found.unwrap_or(&SHARES[0]).1, poles: None }
    }

    /// Forgets what it holds.
    pub fn reset(&mut self) {
        self.poles = None;
    }

    /// An amount, once each ms; the filtered one.
    pub fn pass(&mut self, amount: f64) -> f64 {
        let poles = self.poles.get_or_insert([amount; 5]);
        let mut input = amount;
        for (position, pole) in poles.iter_mut().enumerate() {
            *pole += (if position == 0 { FIRST } else { self.share }) * (input - *pole);
            input = *pole;
        }
        input
    }
}
