//! Times as a distribution.

use std::time::Duration;

use hdrhistogram::{CreationError, Histogram};
use serde::Serialize;

/// A distribution of times in ns, exact to three digits; least and greatest are exact.
#[derive(Debug, Clone)]
pub struct Distribution {
    histogram: Histogram<u64>,
    least: u64,
    greatest: u64,
}

/// What a distribution amounts to, in ns.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct Quantiles {
    /// Half of the scans took no longer.
    pub p50: u64,
    /// 99 in 100.
    pub p99: u64,
    /// 999 in 1,000.
    pub p999: u64,
    /// All.
    pub max: u64,
}

impl Quantiles {
    /// Each with its name.
    pub(super) fn marks(self) -> [(&'static str, u64); 4] {
        [("p50", self.p50), ("p99", self.p99), ("p99.9", self.p999), ("max", self.max)]
    }
}

/// Some of the scans: those that took between two times.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct Bucket {
    /// From this time on, in ns.
    pub from_ns: u64,
    /// To below this one, in ns.
    pub to_ns: u64,
    /// So many.
    pub scans: u64,
}

/// The longest time that is told from longer ones: an hour.
const LONGEST_NS: u64 = 3_600_000_000_000;
/// Digits that are kept of a time.
const DIGITS: u8 = 3;

impl Distribution {
    /// Nothing recorded yet.
    ///
    /// # Errors
    ///
    /// None with these bounds; the histogram's own word for it.
    pub fn new() -> Result<Distribution, CreationError> {
        let histogram = Histogram::new_with_bounds(1, LONGEST_NS, DIGITS)?;
        Ok(Distribution { histogram, least: u64::MAX, greatest: 0 })
    }

    /// Records one time.
    pub fn record(&mut self, time: Duration) {
        let ns = u64::try_from(time.as_nanos()).unwrap_or(u64::MAX);
        self.least = self.least.min(ns);
        self.greatest = self.greatest.max(ns);
        self.histogram.saturating_record(ns.max(1));
    }

    /// How many were recorded.
    pub fn count(&self) -> u64 {
        self.histogram.len()
    }

    /// Its quantiles; zeros when nothing was recorded.
    pub fn quantiles(&self) -> Quantiles {
        let at = |quantile| self.histogram.value_at_quantile(quantile).min(self.greatest);
        Quantiles { p50: at(0.5), p99: at(0.99), p999: at(0.999), max: self.greatest }
    }

    /// The distribution in at most `most` buckets. All but the last are equally wide and reach a little beyond the 99th
    /// percentile; the last holds what took longer.
    pub fn buckets(&self, most: usize) -> Vec<Bucket> {
        if self.count() == 0 || most < 2 {
            return Vec::new();
        }
        let usual = self.histogram.value_at_quantile(0.99).saturating_mul(6) / 5;
        let step = usual.saturating_sub(self.least).div_ceil(most as u64 - 1).max(1);
        let mut buckets: Vec<Bucket> = (0..most as u64 - 1)
            .map(|index| self.least + index * step)
            .take_while(|from_ns| *from_ns <= self.greatest)
            .map(|from_ns| Bucket { from_ns, to_ns: from_ns + step, scans: 0 })
            .collect();
        if let Some(from_ns) = buckets.last().map(|last| last.to_ns).filter(|end| *end <= self.greatest) {
            buckets.push(Bucket { from_ns, to_ns: self.greatest + 1, scans: 0 });
        }
        for recorded in self.histogram.iter_recorded() {
            let ns = recorded.value_iterated_to().clamp(self.least, self.greatest);
            let at = buckets.partition_point(|bucket| bucket.to_ns <= ns).min(buckets.len().saturating_sub(1));
            if let Some(bucket) = buckets.get_mut(at) {
                bucket.scans += recorded.count_since_last_iteration();
            }
        }
        buckets
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(times_ns: impl Iterator<Item = u64>) -> Distribution {
        let mut distribution = Distribution::new().unwrap();
        times_ns.for_each(|ns| distribution.record(Duration::from_nanos(ns)));
        distribution
    }

    #[test]
    fn quantiles_when_the_times_are_1_to_1000_then_they_are_those_of_the_ranks() {
        let quantiles = of(1..=1000).quantiles();
        assert_eq!((quantiles.p50, quantiles.p99, quantiles.p999, quantiles.max), (500, 990, 999, 1000));
    }

    #[test]
    fn quantiles_when_nothing_was_recorded_then_they_are_zero() {
        assert_eq!(of(std::iter::empty()).quantiles(), Quantiles { p50: 0, p99: 0, p999: 0, max: 0 });
    }

    #[test]
    fn buckets_when_summed_then_every_time_is_in_one() {
        let buckets = of((1..=500).map(|step| step * 1234).chain([9_000_000])).buckets(20);
        assert_eq!(buckets.iter().map(|bucket| bucket.scans).sum::<u64>(), 501);
        assert_eq!(buckets.last().map(|last| last.scans), Some(1));
        assert!(buckets.windows(2).all(|pair| pair[0].to_ns == pair[1].from_ns));
    }
}
