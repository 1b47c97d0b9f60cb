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

impl Direction {
    /// Whether a module's connection of this type carries safety data this way. A type ends with a number where there are several.
    pub(crate) fn carries(self, connection_type: &str) -> bool {
        let begins = match self {
            Direction::In => "safetyinput",
            Direction::Out => "safetyoutput",
        };
        connection_type.to_ascii_lowercase().starts_with(begins)
    }
}

/// What a project shows of a connection: nothing for what it does not show.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) struct Shown {
    /// Requested packet interval, µs.
    pub rpi_us: Option<u64>,
    /// Timeout multiplier.
    pub timeouts: Option<u32>,
    /// Network delay multiplier, percent.
    pub delay_percent: Option<u32>,
    /// Connection reaction time limit, µs.
    pub limit_us: Option<u64>,
}

impl Shown {
    fn of_module(module: &Module, direction: Direction) -> Shown {
        let carries = |kind: &twinrung_grammar::tree::Text| direction.carries(kind.as_str());
        let Some(one) = module.connections.iter().find(|one| one.connection_type.as_ref().is_some_and(carries)) else {
            return Shown::default();
        };
        Shown {
            rpi_us: one.rpi_us.map(|rpi| rpi.value),
            timeouts: one.timeout_multiplier.map(|multiplier| multiplier.value),
            delay_percent: one.network_delay_multiplier.map(|multiplier| multiplier.value),
            limit_us: one.reaction_time_limit_us.map(|limit| limit.value),
        }
    }
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
        Connection::inputs(Shown::of_module(module, Direction::In), module.rpi_us.map(|rpi| rpi.value))
    }

    /// The connection of a module's safety outputs, in a task with this period.
    pub fn of_outputs(module: &Module, period_us: u64) -> Connection {
        Connection::outputs(Shown::of_module(module, Direction::Out), period_us)
    }

    /// Of safety inputs, where the connection itself or else the module shows the interval.
    pub(crate) fn inputs(shown: Shown, module_rpi_us: Option<u64>) -> Connection {
        Connection::new(Direction::In, Shown { rpi_us: shown.rpi_us.or(module_rpi_us), ..shown })
    }

    /// Of safety outputs: packets follow the safety task, whatever interval is shown.
    pub(crate) fn outputs(shown: Shown, period_us: u64) -> Connection {
        Connection::new(Direction::Out, Shown { rpi_us: Some(period_us), ..shown })
    }

    /// The connection of a consumed tag.
    pub fn of_consumed(info: Option<&ConsumeInfo>) -> Connection {
        let shown = info.map_or_else(Shown::default, |info| Shown {
            rpi_us: info.rpi_us.map(|rpi| rpi.value),
            timeouts: info.timeout_multiplier.map(|one| one.value),
            delay_percent: info.network_delay_multiplier.map(|one| one.value),
            limit_us: info.reaction_time_limit_us.map(|one| one.value),
        });
        Connection::new(Direction::In, shown)
    }

    /// The connection of a consumed tag of an image.
    pub fn of_consumed_record(tag: &TagRecord) -> Connection {
        let number = |key: &str| {
            let value = tag.attributes.iter().find(|(own, _)| own == key).map(|(_, value)| value.trim_matches('"'));
            value.and_then(|text| text.parse::<u64>().ok())
        };
        let count = |key: &str| number(key).and_then(|value| u32::try_from(value).ok());
        let shown = Shown {
            rpi_us: number("RPI_us"),
            timeouts: count("TimeoutMultiplier"),
            delay_percent: count("NetworkDelayMultiplier"),
            limit_us: number("ReactionTimeLimit_us"),
        };
        Connection::new(Direction::In, shown)
    }

    /// The requested packet interval in µs.
    pub const fn rpi_us(&self) -> u64 {
        self.rpi_us
    }

    /// From what a project shows; the defaults hold where it shows nothing.
    fn new(direction: Direction, shown: Shown) -> Connection {
        let Shown { rpi_us, timeouts, delay_percent, limit_us } = shown;
        Connection {
            direction,
            rpi_us: rpi_us.unwrap_or(INPUT_RPI_US),
            timeout_multiplier: timeouts.unwrap_or(TIMEOUT_MULTIPLIER),
            network_delay_percent: delay_percent.unwrap_or(NETWORK_DELAY_MULTIPLIER),
            exported_us: limit_us,
            is_declared: rpi_us.is_some() && timeouts.is_some() && delay_percent.is_some(),
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
        let (rpi_us, timeouts, delay_percent) = (Some(rpi_us), Some(timeouts), Some(delay));
        Connection::new(direction, Shown { rpi_us, timeouts, delay_percent, limit_us: None }).limit_us()
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
        let connection = |exported| {
            let shown = Shown { rpi_us: Some(10_000), limit_us: Some(exported), ..Shown::default() };
            Connection::new(Direction::In, shown).limit_us()
        };
        assert_eq!(connection(50_048), 50_048);
        assert_eq!(connection(39_936), 40_064);
    }
}
