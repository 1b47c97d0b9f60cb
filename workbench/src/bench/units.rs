//! Times and counts as people read them.

/// A time in ns with three digits and its unit.
pub fn time(ns: u64) -> String {
    let value = ns as f64;
    match ns {
        0..1_000 => format!("{ns} ns"),
        1_000..1_000_000 => format!("{} us", three_digits(value / 1e3)),
        1_000_000..1_000_000_000 => format!("{} ms", three_digits(value / 1e6)),
        _ => format!("{} s", three_digits(value / 1e9)),
    }
}

fn three_digits(value: f64) -> String {
    let digits = if value < 10.0 {
        2
    } else if value < 100.0 {
        1
    } else {
        0
    };
    format!("{value:.digits$}")
}

/// A count with a comma between thousands.
pub(crate) fn count(number: u64) -> String {
    let digits = number.to_string();
    let mut text = String::new();
    for (index, digit) in digits.chars().enumerate() {
        if index > 0 && (digits.len() - index).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text
}

/// The part of a whole that is left, as `97.9 %`; what is beyond the whole is negative.
pub(super) fn left(used: u64, whole: u64) -> f64 {
    if whole == 0 { 0.0 } else { 100.0 * (1.0 - used as f64 / whole as f64) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn time_when_written_then_it_has_three_digits_and_its_unit() {
        let written: Vec<String> = [0, 999, 1_234, 56_789, 999_400, 20_000_000, 1_500_000_000].map(time).to_vec();
        assert_eq!(written, ["0 ns", "999 ns", "1.23 us", "56.8 us", "999 us", "20.0 ms", "1.50 s"]);
    }

    #[test]
    fn count_when_written_then_thousands_are_set_apart() {
        assert_eq!([0, 999, 1_000, 1_234_567].map(count), ["0", "999", "1,000", "1,234,567"]);
    }
}
