//! The reaction time limit of a safety connection. 1756-RM093 Appendix C; 1734-UM013, Configure Safety Connections;
//! neutral-text-and-l5x.md D.3.

use std::fmt;

use twinrung_bytecode::image::TagRecord;
use twinrung_catalog::points::TIME_UNIT_US;
use twinrung_catalog::reaction::{INPUT_RPI_US, NETWORK_DELAY_MULTIPLIER, TIMEOUT_MULTIPLIER};
use twinrung_grammar::tree::{ConsumeInfo, Module};

/// What data travel on a connection.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Direction {
    /// Into this controller: safety inputs, consumed tags.
    In,
    /// Out of it: safety outputs. One timeout less, since the output follows the safety task.
    Out,
}

/// The parameters of a connection, and what follows from them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Connection {
    direction: Direction,
    /// Requested packet interval, µs; of an output connection the period of the safety task.
    rpi_us: u64,
    timeout_multiplier: u32,
    network_delay_percent: u32,
    /// What the export says the limit is, µs.
    exported_us: Option<u64>,
    /// Whether the project itself says interval and multipliers; else some are the defaults.
    is_declared: bool,
}

impl Connection {
    /// The connection of a module's safety inputs.
    pub fn of_inputs(module: &Module) -> Connection {
        Connection::of_module(module, Direction::In, "safetyinput", module.rpi_us.map(|rpi| rpi.value))
    }

    /// The connection of a module's safety outputs, in a task with this period.
    pub fn of_outputs(module: &Module, period_us: u64) -> Connection {
        Connection {
            rpi_us: period_us,
            ..Connection::of_module(module, Direction::Out, "safetyoutput", Some(period_us))
        }
    }

    /// The connection of a consumed tag.
    pub fn of_consumed(info: Option<&ConsumeInfo>) -> Connection {
        let rpi_us = info.and_then(|info| info.rpi_us).map(|rpi| rpi.value);
        let timeouts = info.and_then(|info| info.timeout_multiplier).map(|one| one.value);
        let delay = info.and_then(|info| info.network_delay_multiplier).map(|one| one.value);
        let limit = info.and_then(|info| info.reaction_time_limit_us).map(|one| one.value);
        Connection::new(Direction::In, rpi_us, timeouts, delay, limit)
    }

    /// The connection of a consumed tag of an image.
    pub fn of_consumed_record(tag: &TagRecord) -> Connection {
        let number = |key: &str| {
            let value = tag.attributes.iter().find(|(own, _)| own == key).map(|(_, value)| value.trim_matches('"'));
            value.and_then(|text| text.parse::<u64>().ok())
        };
        let count = |key: &str| number(key).and_then(|value| u32::try_from(value).ok());
        let (timeouts, delay) = (count("TimeoutMultiplier"), count("NetworkDelayMultiplier"));
        Connection::new(Direction::In, number("RPI_us"), timeouts, delay, number("ReactionTimeLimit_us"))
    }

    /// The requested packet interval in µs.
    pub const fn rpi_us(&self) -> u64 {
        self.rpi_us
    }

    fn of_module(module: &Module, direction: Direction, kind: &str, rpi_us: Option<u64>) -> Connection {
        let is_of_kind = |text: &str| text.to_ascii_lowercase().starts_with(kind);
        let shown = module
            .connections
            .iter()
            .find(|one| one.connection_type.as_ref().is_some_and(|own| is_of_kind(own.as_str())));
        let rpi_us = shown.and_then(|one| one.rpi_us).map(|rpi| rpi.value).or(rpi_us);
        let timeouts = shown.and_then(|one| one.timeout_multiplier).map(|one| one.value);
        let delay = shown.and_then(|one| one.network_delay_multiplier).map(|one| one.value);
        let limit = shown.and_then(|one| one.reaction_time_limit_us).map(|one| one.value);
        Connection::new(direction, rpi_us, timeouts, delay, limit)
    }

    /// From what a project says; the defaults hold where it says nothing. Times in µs, the delay in percent.
    pub(crate) fn new(
        direction: Direction,
        rpi_us: Option<u64>,
        timeouts: Option<u32>,
        delay: Option<u32>,
        exported_us: Option<u64>,
    ) -> Connection {
        Connection {
            direction,
            rpi_us: rpi_us.unwrap_or(INPUT_RPI_US),
            timeout_multiplier: timeouts.unwrap_or(TIMEOUT_MULTIPLIER),
            network_delay_percent: delay.unwrap_or(NETWORK_DELAY_MULTIPLIER),
            exported_us,
            is_declared: rpi_us.is_some() && timeouts.is_some() && delay.is_some(),
        }
    }

    /// The limit in µs: interval times multipliers, rounded up to the unit in which safety connections count time; the
    /// exported limit where that is greater. Up, since a connection cannot time out between two units.
    pub fn limit_us(&self) -> u64 {
        let timeouts = match self.direction {
            Direction::In => u64::from(self.timeout_multiplier),
            Direction::Out => u64::from(self.timeout_multiplier).saturating_sub(1),
        };
        let percent = timeouts.saturating_mul(100).saturating_add(u64::from(self.network_delay_percent));
        let product = self.rpi_us.saturating_mul(percent).div_ceil(100);
        let counted = product.div_ceil(TIME_UNIT_US).saturating_mul(TIME_UNIT_US);
        self.exported_us.map_or(counted, |exported| exported.max(counted))
    }
}

impl fmt::Display for Connection {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let rpi = super::milliseconds(self.rpi_us);
        write!(f, "{rpi} ms, timeout x {}, network delay {} %", self.timeout_multiplier, self.network_delay_percent)?;
        f.write_str(if self.is_declared { "" } else { " (defaults where the project names none)" })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn limit(direction: Direction, rpi_us: u64, timeouts: u32, delay: u32) -> u64 {
        Connection::new(direction, Some(rpi_us), Some(timeouts), Some(delay), None).limit_us()
    }

    /// 1734-UM013, Configure Safety Connections: 10 ms give 40.1 ms, 20 ms of period give 60.0 ms; exports write 40.064 and 60.
    #[test]
    fn limit_when_multipliers_are_the_defaults_then_four_intervals_in_and_three_out() {
        assert_eq!(limit(Direction::In, 10_000, 2, 200), 40_064);
        assert_eq!(limit(Direction::Out, 20_000, 2, 200), 60_032);
    }

    /// An export rounds this one to the nearest unit, 29.952; below the product a limit must not be.
    #[test]
    fn limit_when_the_product_lies_between_units_then_it_is_rounded_up() {
        assert_eq!(limit(Direction::In, 10_000, 2, 100), 30_080);
    }

    #[test]
    fn limit_when_the_export_shows_a_greater_one_then_that_counts() {
        let connection = |exported| Connection::new(Direction::In, Some(10_000), None, None, Some(exported)).limit_us();
        assert_eq!(connection(50_048), 50_048);
        assert_eq!(connection(39_936), 40_064);
    }
}
