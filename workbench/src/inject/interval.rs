//! Shares with their confidence intervals.

use statrs::distribution::{Beta, ContinuousCDF, Normal};

/// The probability that an interval does not hold what it is of.
const MISSED: f64 = 0.05;

/// A share of faults, with the exact (Clopper-Pearson) interval of 95 %.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Coverage {
    /// Detected faults among the faults that were not masked; 1 where none was.
    pub share: f64,
    /// The lower end of the interval.
    pub lower: f64,
    /// The upper end of the interval.
    pub upper: f64,
}

impl Coverage {
    /// So many of so many.
    pub fn of(detected: u64, all: u64) -> Coverage {
        if all == 0 {
            return Coverage { share: 1.0, lower: 0.0, upper: 1.0 };
        }
        let (hits, misses) = (detected as f64, all.saturating_sub(detected) as f64);
        let quantile = |a: f64, b: f64, at: f64, otherwise: f64| {
            Beta::new(a, b).map_or(otherwise, |distribution| distribution.inverse_cdf(at))
        };
        let lower = if detected == 0 { 0.0 } else { quantile(hits, misses + 1.0, MISSED / 2.0, 0.0) };
        let upper = if misses == 0.0 { 1.0 } else { quantile(hits + 1.0, misses, 1.0 - MISSED / 2.0, 1.0) };
        Coverage { share: hits / all as f64, lower, upper }
    }

    /// So many of so many that were drawn, with the interval of Wilson (1927) of 95 %, which is the usual one where a score
    /// is estimated from a sample.
    pub fn wilson(hits: u64, all: u64) -> Coverage {
        if all == 0 {
            return Coverage { share: 1.0, lower: 0.0, upper: 1.0 };
        }
        let (count, share) = (all as f64, hits.min(all) as f64 / all as f64);
        let z = Normal::standard().inverse_cdf(1.0 - MISSED / 2.0);
        let middle = share + z * z / (2.0 * count);
        let half = z * (share * (1.0 - share) / count + z * z / (4.0 * count * count)).sqrt();
        let whole = 1.0 + z * z / count;
        Coverage { share, lower: ((middle - half) / whole).max(0.0), upper: ((middle + half) / whole).min(1.0) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn is_near(found: f64, expected: f64) -> bool {
        (found - expected).abs() < 1e-4
    }

    #[test]
    fn coverage_when_everything_was_detected_then_the_lower_end_is_that_of_the_closed_form() {
        let coverage = Coverage::of(1000, 1000);
        assert_eq!((coverage.share, coverage.upper), (1.0, 1.0));
        assert!(is_near(coverage.lower, 0.025_f64.powf(1.0 / 1000.0)), "{coverage:?}");
    }

    #[test]
    fn coverage_when_some_were_missed_then_the_interval_is_the_published_one() {
        // 15 of 20: Clopper-Pearson 0.5090 to 0.9134.
        let coverage = Coverage::of(15, 20);
        assert!(is_near(coverage.lower, 0.5090) && is_near(coverage.upper, 0.9134), "{coverage:?}");
    }

    #[test]
    fn wilson_when_some_were_missed_then_the_interval_is_the_published_one() {
        // 15 of 20: Wilson 0.5313 to 0.8881.
        let coverage = Coverage::wilson(15, 20);
        assert!(is_near(coverage.lower, 0.5313) && is_near(coverage.upper, 0.8881), "{coverage:?}");
        assert!(is_near(Coverage::wilson(120, 120).upper, 1.0));
    }

    #[test]
    fn coverage_when_nothing_was_injected_then_nothing_is_known() {
        assert_eq!(Coverage::of(0, 0), Coverage { share: 1.0, lower: 0.0, upper: 1.0 });
    }
}
