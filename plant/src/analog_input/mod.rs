//! 1734-IE4S: four safety analog inputs. Source: 1734-UM013, Safety Analog Inputs; Tables 16, 21, 25; Safety Analog Input Module
//! Specifications. What is not modelled: accuracy and drift, the on and off levels of a tachometer (its sensor gives 0 and
//! 24 V), which circuit of the module it is that fails.

mod alarm;
mod channel;
mod filter;
mod pair;
mod range;
mod tachometer;

use alarm::Alarm;
use channel::Channel;
pub use channel::{ChannelFault, OVERCURRENT_MS};
use pair::Pair;

use crate::device::{self, Device};
use crate::member::{Command, Reading};
use crate::settings::ModuleSettings;
use crate::station::STEP_US;
use crate::stimulus::{Fault, Refusal, Signal, Stimulus, Terminal};
use crate::wiring::{Field, Node};

/// Channels.
const CHANNELS: u8 = 4;
/// For how long the sensor supplies are tested at power-up, ms. 1734-UM013, Sensor Power Supply. Until then a channel with a
/// sensor supply is not valid (decided).
pub const SENSOR_TEST_MS: u64 = 500;

/// What decides the level of a tachometer signal.
#[derive(Debug, Clone, Copy)]
enum Feed {
    /// A pole of the field power.
    Level(bool),
    /// The sensors whose wires touch. Without one the resistor at the terminal decides: down for rising edges, where sensors
    /// source current, up for falling ones. (1734-UM013, Signal Measurement)
    Sensors { feeding: [bool; CHANNELS as usize], sources: bool },
}

impl Feed {
    fn level(&self, sensors: &[bool; CHANNELS as usize]) -> bool {
        match self {
            Feed::Level(level) => *level,
            Feed::Sensors { feeding, sources } => {
                let mut levels = feeding.iter().zip(sensors).filter(|(feeds, _)| **feeds).map(|(_, level)| *level);
                if *sources { levels.any(|high| high) } else { levels.all(|high| high) }
            }
        }
    }
}

/// A 1734-IE4S.
pub struct AnalogInput {
    channels: Vec<Channel>,
    pairs: [Option<Pair>; 2],
    discrepant: [bool; 2],
    /// Both signals of a pair were low in the last look.
    dual_low: [bool; 2],
    field: Field,
    origin_ms: u64,
    now_ms: u64,
}

fn channel_node(number: u8) -> Node {
    Node(2 + number)
}

fn sensor_node(number: u8) -> Node {
    Node(2 + CHANNELS + number)
}

fn node(terminal: Terminal) -> Option<Node> {
    match terminal.letter {
        'C' if terminal.number < CHANNELS => Some(channel_node(terminal.number)),
        'S' if terminal.number < CHANNELS => Some(sensor_node(terminal.number)),
        _ => None,
    }
}

impl AnalogInput {
    /// As a project configures it. In a pair the second channel is set as the first. (1734-UM013, Configure the Safety Analog
    /// Inputs)
    pub fn new(settings: &ModuleSettings) -> AnalogInput {
        let of = |number: u8| settings.of(Terminal::new('C', number));
        let pairs = [Pair::new(&of(0), &of(1)), Pair::new(&of(2), &of(3))];
        let paired = |number: u8| pairs.get(usize::from(number / 2)).is_some_and(Option::is_some);
        let channels = (0..CHANNELS)
            .map(|number| Channel::new(number, &of(if paired(number) { number & !1 } else { number })))
            .collect();
        AnalogInput {
            channels,
            pairs,
            discrepant: [false; 2],
            dual_low: [false; 2],
            field: Field::new(node),
            origin_ms: 0,
            now_ms: 0,
        }
    }

    fn channel(&self, number: u8) -> Option<&Channel> {
        self.channels.get(usize::from(number))
    }

    /// Why a channel shows an error.
    pub fn fault(&self, number: u8) -> ChannelFault {
        self.channel(number).map_or(ChannelFault::None, Channel::fault)
    }

    /// Whether the sensor of a channel has power.
    fn sensor_lives(&self, number: u8) -> bool {
        let supplied = self.channel(number).is_some_and(|channel| channel.supplies_sensor);
        let broken =
            self.field.faults.is_open(Terminal::new('S', number)) || self.field.wiring.is_grounded(sensor_node(number));
        self.field.power && !(supplied && broken)
    }

    /// Whether the sensor of another channel feeds this one: their wires touch, and both measure the same quantity.
    fn feeds(&self, number: u8, other: u8) -> bool {
        let quantity = |number: u8| self.channel(number).map(|channel| channel.range.quantity);
        self.field.wiring.joined(channel_node(number)) & channel_node(other).mask() != 0
            && quantity(number) == quantity(other)
            && !self.field.faults.is_open(Terminal::new('C', other))
            && self.sensor_lives(other)
    }

    /// Whether 24 V stand at a channel: of the field power, or of a sensor supply that its wire touches.
    fn is_supplied(&self, number: u8) -> bool {
        let joined = self.field.wiring.joined(channel_node(number));
        let touches = |other: u8| joined & sensor_node(other).mask() != 0;
        let supplies = |other: u8| self.channel(other).is_some_and(|channel| channel.supplies_sensor);
        let sensors = (0..CHANNELS).any(|other| touches(other) && supplies(other) && self.sensor_lives(other));
        self.field.power && joined & Node::COMMON.mask() == 0 && (joined & Node::SUPPLY.mask() != 0 || sensors)
    }

    /// The amount at a terminal: 0 V and 24 V beat a sensor, sensors that touch give the mean (decided).
    fn amount(&self, number: u8) -> i64 {
        let Some(own) = self.channel(number) else { return 0 };
        if self.field.wiring.is_grounded(channel_node(number)) {
            return 0;
        }
        if self.is_supplied(number) {
            return own.range.supply();
        }
        let feeding = (0..CHANNELS).zip(&self.channels).filter(|(other, _)| self.feeds(number, *other));
        let (sum, count) = feeding.fold((0, 0), |(sum, count), (_, channel)| (sum + channel.amount, count + 1));
        if count == 0 { 0 } else { sum / count }
    }

    /// What decides the level of a tachometer signal between two events at the terminals.
    fn feed(&self, number: u8) -> Feed {
        let sources = self.channel(number).is_some_and(|channel| channel.tachometer.sources());
        if self.field.wiring.is_grounded(channel_node(number)) || !self.field.power {
            return Feed::Level(false);
        }
        if self.is_supplied(number) {
            return Feed::Level(true);
        }
        let mut feeding = [false; CHANNELS as usize];
        for (other, feeds) in (0..CHANNELS).zip(&mut feeding) {
            *feeds = self.feeds(number, other);
        }
        Feed::Sensors { feeding, sources }
    }

    /// The pulses of one ms, µs by µs.
    fn count_pulses(&mut self, now_ms: u64) {
        self.dual_low = [false; 2];
        if !self.channels.iter().any(|channel| channel.used && channel.range.is_tachometer()) {
            return;
        }
        let mut feeds = [Feed::Level(false); CHANNELS as usize];
        for (number, feed) in (0..CHANNELS).zip(&mut feeds) {
            *feed = self.feed(number);
        }
        for us in 0..STEP_US {
            let mut sensors = [false; CHANNELS as usize];
            for (level, channel) in sensors.iter_mut().zip(&mut self.channels) {
                *level = channel.sensor.pass();
            }
            let mut levels = [false; CHANNELS as usize];
            for (feed, level) in feeds.iter().zip(&mut levels) {
                *level = feed.level(&sensors);
            }
            for (channel, level) in self.channels.iter_mut().zip(levels) {
                channel.tachometer.look(now_ms * STEP_US + us, level);
            }
            for (low, pair) in self.dual_low.iter_mut().zip(levels.chunks(2)) {
                *low |= pair == [false, false];
            }
        }
        for channel in &mut self.channels {
            channel.tachometer.settle((now_ms + 1) * STEP_US);
        }
    }

    /// What is wrong around a channel, its signal aside.
    fn cause(&self, number: u8) -> ChannelFault {
        let Some(channel) = self.channel(number) else { return ChannelFault::None };
        if !self.field.power {
            return ChannelFault::FieldPower;
        }
        if self.field.faults.is_inside(Terminal::new('C', number)) {
            return ChannelFault::Inside;
        }
        if channel.supplies_sensor {
            let at = sensor_node(number);
            let others = self.field.wiring.joined(at) & !(at.mask() | Node::SUPPLY.mask() | Node::COMMON.mask());
            if self.field.wiring.is_grounded(at) {
                return ChannelFault::SensorOvercurrent;
            }
            // A sensor that is fed from elsewhere takes no current of the module.
            if self.field.faults.is_open(Terminal::new('S', number))
                || self.field.wiring.joined(at) & Node::SUPPLY.mask() != 0
            {
                return ChannelFault::SensorUndercurrent;
            }
            if others != 0 {
                return ChannelFault::SensorWiring;
            }
        }
        let low = self.dual_low.get(usize::from(number / 2)).copied().unwrap_or_default();
        let watched = channel.range.is_tachometer() && channel.dual_low;
        if watched && low { ChannelFault::DualLow } else { ChannelFault::None }
    }

    fn is_valid(&self, number: u8) -> bool {
        let Some(channel) = self.channel(number) else { return false };
        let tested = self.now_ms.saturating_sub(self.origin_ms) >= SENSOR_TEST_MS;
        !channel.used || channel.fault() == ChannelFault::None && (tested || !channel.supplies_sensor)
    }

    /// A pair that differs reports what it measures; any other error makes the channel 0. (1734-UM013, Safe States)
    fn data(&self, number: u8) -> i32 {
        let Some(channel) = self.channel(number).filter(|channel| channel.used) else { return 0 };
        if self.is_valid(number) || channel.fault() == ChannelFault::Partner { channel.value } else { 0 }
    }

    fn alarm(&self, number: u8, alarm: Alarm) -> bool {
        !self.channel(number).is_some_and(|channel| channel.used && channel.alarms.is_active(alarm))
    }

    /// A tachometer that is used; other channels are never too slow, too fast or low.
    fn tachometer(&self, number: u8) -> Option<&Channel> {
        self.channel(number).filter(|channel| channel.used && channel.range.is_tachometer())
    }
}

impl Device for AnalogInput {
    fn accepts(&self, stimulus: &Stimulus) -> Result<(), Refusal> {
        for terminal in device::terminals(stimulus).into_iter().flatten() {
            node(terminal).ok_or(Refusal::NoTerminal(terminal))?;
            let used = self
                .channel(terminal.number)
                .is_some_and(|channel| channel.used && (terminal.letter == 'C' || channel.supplies_sensor));
            if !used {
                return Err(Refusal::NotUsed(terminal));
            }
        }
        if let Stimulus::Signal(terminal, signal) = stimulus {
            let Signal::Amount(amount) = signal else { return Err(Refusal::NotAContact(*terminal)) };
            if terminal.letter != 'C' {
                return Err(Refusal::NoDevice(*terminal));
            }
            let tachometer = self.channel(terminal.number).is_some_and(|channel| channel.range.is_tachometer());
            let within = if tachometer { (0..=10_000_000).contains(amount) } else { amount.abs() <= 30_000 };
            if !within {
                return Err(Refusal::Beyond(*terminal));
            }
        }
        if let Stimulus::Fault(own, Fault::To(other)) = stimulus
            && (own.letter, other.letter) == ('C', 'C')
        {
            let quantity = |one: &Terminal| self.channel(one.number).map(|channel| channel.range.quantity);
            if quantity(own) != quantity(other) {
                return Err(Refusal::OtherQuantity(*other));
            }
        }
        device::inside_only(stimulus, Some('C'))?;
        device::not_itself(stimulus)
    }

    fn apply(&mut self, stimulus: &Stimulus) {
        if self.accepts(stimulus).is_err() {
            return;
        }
        if let Stimulus::Signal(terminal, Signal::Amount(amount)) = stimulus
            && let Some(channel) = self.channels.get_mut(usize::from(terminal.number))
        {
            channel.give(*amount);
        }
        self.field.apply(stimulus);
    }

    fn step(&mut self, now_ms: u64) {
        self.now_ms = now_ms;
        self.count_pulses(now_ms);
        let mut causes = [ChannelFault::None; CHANNELS as usize];
        for (number, cause) in (0..CHANNELS).zip(&mut causes) {
            let amount = self.amount(number);
            let outer = self.cause(number);
            let signal = match self.channels.get_mut(usize::from(number)) {
                Some(channel) if channel.used => channel.measure(amount),
                _ => continue,
            };
            *cause = if outer == ChannelFault::None { signal } else { outer };
        }
        let AnalogInput { channels, pairs, discrepant, .. } = self;
        let couples = channels.chunks_mut(2).zip(causes.chunks(2));
        for (((couple, causes), pair), discrepant) in couples.zip(pairs).zip(discrepant) {
            let ([even, odd], [first, second]) = (couple, causes) else { continue };
            *discrepant = pair.as_mut().is_some_and(|pair| pair.look(now_ms, even.value, odd.value));
            let judged = |own: ChannelFault, other: ChannelFault| match (own, other) {
                (ChannelFault::None, ChannelFault::None) => ChannelFault::None,
                (ChannelFault::None, _) if pair.is_some() => ChannelFault::Partner,
                (own, _) => own,
            };
            even.judge(now_ms, judged(*first, *second));
            odd.judge(now_ms, judged(*second, *first));
        }
    }

    fn read(&self, reading: Reading) -> i32 {
        let discrepant = |number: u8| self.discrepant.get(usize::from(number / 2)).copied().unwrap_or_default();
        let bit = match reading {
            Reading::Data(number) => return self.data(number),
            Reading::FaultReason(number) if self.fault(number) == ChannelFault::None && discrepant(number) => {
                return ChannelFault::Discrepancy as i32;
            }
            Reading::FaultReason(number) => return self.fault(number) as i32,
            Reading::Status(number) => self.is_valid(number) && !discrepant(number),
            Reading::CombinedAlarm(number) => {
                !self.channel(number).is_some_and(|channel| channel.used && !channel.alarms.none())
            }
            Reading::HighHigh(number) => self.alarm(number, Alarm::HighHigh),
            Reading::LowLow(number) => self.alarm(number, Alarm::LowLow),
            Reading::High(number) => self.alarm(number, Alarm::High),
            Reading::Low(number) => self.alarm(number, Alarm::Low),
            Reading::Overfrequency(number) => !self.tachometer(number).is_some_and(|one| one.tachometer.is_over()),
            Reading::Underfrequency(number) => {
                self.tachometer(number).is_none_or(|one| one.tachometer.frequency().is_some())
            }
            Reading::DualLow(number) => {
                !self.tachometer(number).is_some_and(|channel| channel.fault() == ChannelFault::DualLow)
            }
            // Of this module 1 is normal. (1734-UM013, Values and States of Tags; Table 25)
            Reading::Power => self.field.power,
            _ => false,
        };
        i32::from(bit)
    }

    fn command(&mut self, command: Command, on: bool) {
        if let Command::ResetTachometer(number) = command
            && let Some(channel) = self.channels.get_mut(usize::from(number))
        {
            channel.tachometer.command_reset(on);
        }
    }

    fn commanded(&mut self, _now_ms: u64) {}

    fn output_connection_lost(&mut self, _now_ms: u64) {
        self.channels.iter_mut().for_each(|channel| channel.tachometer.command_reset(false));
    }

    fn has(&self, terminal: Terminal) -> bool {
        node(terminal).is_some()
    }

    /// Pulses are looked at each µs.
    fn looks_each_ms(&self) -> u64 {
        if self.channels.iter().any(|channel| channel.used && channel.range.is_tachometer()) { STEP_US } else { 1 }
    }

    /// Whether a sensor is supplied; at a channel a number stands.
    fn is_high(&self, terminal: Terminal) -> Option<bool> {
        node(terminal).filter(|_| terminal.letter == 'S').map(|_| self.sensor_lives(terminal.number))
    }

    fn power_up(&mut self, now_ms: u64) {
        self.origin_ms = now_ms;
        self.now_ms = now_ms;
        self.discrepant = [false; 2];
        self.channels.iter_mut().for_each(Channel::power_up);
        self.pairs.iter_mut().flatten().for_each(Pair::power_up);
    }

    fn letter(&self) -> char {
        'C'
    }
}
