//! Process alarms. 1734-UM013, Process Alarms; Figure 13.

use crate::settings::PointSettings;

/// One trip point.
#[derive(Debug, Clone, PartialEq, Eq)]
struct Trip {
    level: i32,
    deadband: i32,
    /// Whether values above the level are the alarm, and not those below.
    high: bool,
    active: bool,
}

impl Trip {
    /// An alarm comes beyond the level, and goes when the value is back by the deadband.
    fn look(&mut self, value: i32) {
        let (value, level, deadband) = (i64::from(value), i64::from(self.level), i64::from(self.deadband));
        let beyond = if self.high { value - level } else { level - value };
        self.active = beyond > 0 || (self.active && beyond > -deadband);
    }
}

/// The four alarms of a channel; none where they are not enabled.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Alarms {
    trips: Option<[Trip; 4]>,
}

/// Which alarm.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Alarm {
    /// High High.
    HighHigh,
    /// Low Low.
    LowLow,
    /// High.
    High,
    /// Low.
    Low,
}

impl Alarms {
    /// As configured; levels without a setting as Table 21 has them.
    pub fn new(settings: &PointSettings) -> Alarms {
        let number = |key: &str, default: i32| {
            settings.number(key).and_then(|number| i32::try_from(number).ok()).unwrap_or(default)
        };
        let outer = number("HighHighLowLowDeadband", 0);
        let inner = number("HighLowDeadband", 0);
        let trip = |level: i32, deadband: i32, high: bool| Trip { level, deadband, high, active: false };
        let trips = [
            trip(number("HighHighAlarm", 32_767), outer, true),
            trip(number("LowLowAlarm", -32_767), outer, false),
            trip(number("HighAlarm", 32_767), inner, true),
            trip(number("LowAlarm", 0), inner, false),
        ];
        Alarms { trips: settings.has("Alarms", "ENABLE").then_some(trips) }
    }

    /// As new.
    pub fn reset(&mut self) {
        self.trips.iter_mut().flatten().for_each(|trip| trip.active = false);
    }

    /// A value in engineering units.
    pub fn look(&mut self, value: i32) {
        self.trips.iter_mut().flatten().for_each(|trip| trip.look(value));
    }

    /// Whether an alarm is there.
    pub fn is_active(&self, alarm: Alarm) -> bool {
        self.trips.as_ref().and_then(|trips| trips.get(alarm as usize)).is_some_and(|trip| trip.active)
    }

    /// Whether the value is between the alarms.
    pub fn none(&self) -> bool {
        !self.trips.iter().flatten().any(|trip| trip.active)
    }
}
