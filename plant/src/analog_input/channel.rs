//! One analog channel.

use super::alarm::Alarms;
use super::filter::Filter;
use super::range::{Range, Scaling};
use super::tachometer::{Sensor, Tachometer};
use crate::error_latch::ErrorLatch;
use crate::settings::PointSettings;

/// How much longer the status may take after an overcurrent of the sensor supply, ms. 1734-UM013, Sensor Power Supply: up to 15 s;
/// the longest.
pub const OVERCURRENT_MS: u64 = 15_000;

/// Why a channel shows an error: the codes of 1734-UM013 Table 16 that are not of the module itself.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ChannelFault {
    /// No error.
    None = 1,
    /// Signal over range.
    OverRange = 2,
    /// Signal under range.
    UnderRange = 3,
    /// The channels of a pair differ.
    Discrepancy = 5,
    /// The other channel of the pair has an error.
    Partner = 6,
    /// The sensor takes too much current.
    SensorOvercurrent = 100,
    /// The sensor takes too little current.
    SensorUndercurrent = 101,
    /// Both measurements of the signal inside the module differ.
    Inside = 108,
    /// Both tachometer signals of a pair are low.
    DualLow = 109,
    /// Field power is missing.
    FieldPower = 125,
    /// The sensor supply touches an input.
    SensorWiring = 127,
}

/// An analog channel.
#[derive(Debug, Clone)]
pub struct Channel {
    /// Whether a device is connected.
    pub used: bool,
    /// Its range.
    pub range: &'static Range,
    scaling: Scaling,
    filter: Filter,
    /// Its alarms.
    pub alarms: Alarms,
    /// Whether the module supplies the sensor.
    pub supplies_sensor: bool,
    /// What counts its pulses.
    pub tachometer: Tachometer,
    /// Whether both signals of a pair being low is an error.
    pub dual_low: bool,
    latch: ErrorLatch,
    fault: ChannelFault,
    /// What was measured, in engineering units.
    pub value: i32,
    /// Device: what the sensor gives, in mV or µA.
    pub amount: i64,
    /// Device: the pulses that the sensor gives.
    pub sensor: Sensor,
}

impl Channel {
    /// As configured; a channel that is not configured is not used.
    pub fn new(number: u8, settings: &PointSettings) -> Channel {
        let range = Range::of(settings.word("Range"));
        Channel {
            used: settings.has("Mode", "SAFETY") || settings.has("Mode", "STANDARD"),
            range,
            scaling: Scaling::new(range, settings.number("LowEngineering"), settings.number("HighEngineering")),
            filter: Filter::new(settings.word("Filter")),
            alarms: Alarms::new(settings),
            supplies_sensor: !settings.has("SensorPower", "EXTERNAL"),
            tachometer: Tachometer::new(settings.has("TachometerTrigger", "RISING")),
            dual_low: settings.has("TachometerDualLow", "ON"),
            latch: ErrorLatch::new(settings.error_latch_ms()),
            fault: ChannelFault::None,
            value: 0,
            amount: 0,
            sensor: Sensor::new(number),
        }
    }

    /// As new; the sensor stays as it is.
    pub fn power_up(&mut self) {
        self.filter.reset();
        self.alarms.reset();
        self.tachometer = Tachometer::new(self.tachometer.sources());
        self.latch.power_up();
        self.fault = ChannelFault::None;
        self.value = 0;
    }

    /// Measures an amount at the terminal; what is wrong with it. (Frequencies come from the tachometer.)
    pub fn measure(&mut self, amount: i64) -> ChannelFault {
        let measured = if self.range.is_tachometer() {
            match self.tachometer.frequency() {
                Some(frequency) if self.tachometer.is_over() => frequency,
                Some(frequency) => self.filter.pass(frequency),
                None => {
                    self.filter.reset();
                    0.0
                }
            }
        } else {
            self.filter.pass(amount as f64)
        };
        self.value = self.scaling.scaled(self.range, measured);
        self.alarms.look(self.value);
        // A frequency beyond its range is reported by bits of its own.
        match self.range.is_tachometer() {
            false if self.range.is_over(measured) => ChannelFault::OverRange,
            false if self.range.is_under(measured) => ChannelFault::UnderRange,
            _ => ChannelFault::None,
        }
    }

    /// What the sensor gives, in mV or µA, or in mHz of a tachometer.
    pub fn give(&mut self, amount: i64) {
        match self.range.is_tachometer() {
            true => self.sensor.frequency = u64::try_from(amount).unwrap_or_default(),
            false => self.amount = amount,
        }
    }

    /// An error is there, or none: it goes when its cause is gone and the error latch time has run out.
    pub fn judge(&mut self, now_ms: u64, cause: ChannelFault) {
        match cause {
            ChannelFault::None => {
                self.latch.gone(now_ms, true);
                if !self.latch.is_set() {
                    self.fault = ChannelFault::None;
                }
            }
            // A partner's error ends with the partner's.
            ChannelFault::Partner => self.found(now_ms, cause, 0),
            ChannelFault::SensorOvercurrent => self.found(now_ms, cause, self.latch.latch_ms() + OVERCURRENT_MS),
            cause => self.found(now_ms, cause, self.latch.latch_ms()),
        }
    }

    /// What was found first says most; a partner's error says least.
    fn found(&mut self, now_ms: u64, cause: ChannelFault, latch_ms: u64) {
        self.latch.seen_for(now_ms, latch_ms);
        if matches!(self.fault, ChannelFault::None | ChannelFault::Partner) {
            self.fault = cause;
        }
    }

    /// Its error.
    pub fn fault(&self) -> ChannelFault {
        self.fault
    }
}
