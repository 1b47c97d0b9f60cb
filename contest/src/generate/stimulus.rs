//! How the inputs of a program move: mostly a few at a time, with the values at which arithmetic goes wrong.

use twinrung_catalog::Element;

use crate::signal::Value;

use super::random::Random;
use super::safety::Driver;
use super::{Actor, Generated, Input, literals};

/// One scan.
#[derive(Debug, Clone, PartialEq)]
pub struct Step {
    /// The time of the scan in ms.
    pub now_ms: i64,
    /// Whether this is a prescan (the controller changed to Run) and no scan.
    pub prescan: bool,
    /// Values that are set before it.
    pub values: Vec<(String, Value)>,
    /// The seed of new system values, where GSV reads others from here on.
    pub system_values: Option<u64>,
}

/// All scans of a run.
#[derive(Debug, Clone, PartialEq)]
pub struct Stimulus {
    /// Instructions that a scan may execute.
    pub budget: u64,
    /// The prescan and the scans after it.
    pub steps: Vec<Step>,
}

/// A stimulus for `scans` scans.
pub fn stimulus(seed: u64, generated: &Generated, scans: usize) -> Stimulus {
    stimulus_of(&mut Random::new(seed ^ 0x0005_7112_A1D5), generated, scans)
}

/// The stimulus that these choices make.
pub fn stimulus_of(random: &mut Random, generated: &Generated, scans: usize) -> Stimulus {
    let period_ms = *random.of(&[10, 10, 10, 20, 5]);
    let mut now_ms = random.below(100_000) as i64;
    let budget = if random.one_in(25) { random.between(20, 400) as u64 } else { 200_000 };
    let mut beyond = vec![false; generated.inputs.len()];
    let mut troupe = Troupe::new(&generated.actors, period_ms);
    let mut steps = Vec::with_capacity(scans + 1);
    for scan in 0..=scans {
        random.gene();
        let mut values =
            if scan == 0 { first_values(random, generated) } else { moved(random, generated, &mut beyond) };
        troupe.move_to(random, now_ms, &mut values);
        let prescan = scan == 0 || random.one_in(200);
        let system_values = random.one_in(10).then(|| random.bits());
        steps.push(Step { now_ms, prescan, values, system_values });
        now_ms += match random.below(200) {
            0 => 0,
            1 => 1,
            2..=5 => random.below(1000) as i64,
            6 => 3_000_000_000,
            7..=90 => troupe.leap_ms(random, now_ms).unwrap_or(period_ms),
            _ => period_ms,
        };
    }
    Stimulus { budget, steps }
}

/// The drivers of all calls whose operands move together.
struct Troupe<'g> {
    actors: &'g [Actor],
    drivers: Vec<Driver>,
    /// What each operand was last set to.
    shown: Vec<Vec<i32>>,
}

impl<'g> Troupe<'g> {
    fn new(actors: &'g [Actor], period_ms: i64) -> Troupe<'g> {
        let drivers = actors.iter().map(|actor| Driver::new(&actor.call, period_ms)).collect();
        let shown = actors.iter().map(|actor| vec![0; actor.tags.len()]).collect();
        Troupe { actors, drivers, shown }
    }

    fn move_to(&mut self, random: &mut Random, now_ms: i64, values: &mut Vec<(String, Value)>) {
        for ((actor, driver), shown) in self.actors.iter().zip(&mut self.drivers).zip(&mut self.shown) {
            driver.advance(random, now_ms);
            for (index, tag) in actor.tags.iter().enumerate() {
                let (Some(tag), value) = (tag, driver.inputs.operands[index]) else { continue };
                if std::mem::replace(&mut shown[index], value) != value {
                    values.push((tag.name.clone(), held(tag.element, value)));
                }
            }
        }
    }

    /// Time until something happens: the next change of an operand, or the end of a time that a call measures.
    fn leap_ms(&self, random: &mut Random, now_ms: i64) -> Option<i64> {
        if self.drivers.is_empty() {
            return None;
        }
        if random.percent(70) {
            let next = self.drivers.iter().filter_map(|driver| driver.next_ms(now_ms)).min()?;
            return Some((next - now_ms).min(LEAP_MS));
        }
        let times = random.of(&self.drivers).times().configured_ms();
        (!times.is_empty()).then(|| (random.of(times) + random.below(3) as i64 - 1).clamp(0, LEAP_MS))
    }
}

/// The longest time without a scan that a leap makes, in ms: longer than most times of the instructions.
const LEAP_MS: i64 = 40_000;

/// A driver's number as a value of the tag's type.
fn held(element: Element, value: i32) -> Value {
    match element {
        Element::Bool => Value::Bool(value != 0),
        Element::Sint => Value::Integer(i32::from(value as i8)),
        Element::Int => Value::Integer(i32::from(value as i16)),
        Element::Dint => Value::Integer(value),
        Element::Real => Value::Real(f32::from_bits(value as u32)),
    }
}

fn first_values(random: &mut Random, generated: &Generated) -> Vec<(String, Value)> {
    let driven = generated.inputs.iter().filter(|input| input.bound.is_some());
    driven.map(|input| (input.name.clone(), in_range(random, input))).collect()
}

fn moved(random: &mut Random, generated: &Generated, beyond: &mut [bool]) -> Vec<(String, Value)> {
    let mut values = Vec::new();
    for (input, beyond) in generated.inputs.iter().zip(beyond) {
        let value = if input.bound.is_some() {
            if *beyond && random.percent(80) || random.percent(30) {
                *beyond = false;
                in_range(random, input)
            } else if random.one_in(250) {
                *beyond = true;
                let bound = input.bound.unwrap_or_default() as i32;
                Value::Integer(*random.of(&[-1, bound, bound + 1, 100, -128, 127]))
            } else {
                continue;
            }
        } else if random.percent(if input.element == Element::Bool { 25 } else { 15 }) {
            any_value(random, input.element)
        } else {
            continue;
        };
        values.push((input.name.clone(), value));
    }
    values
}

fn in_range(random: &mut Random, input: &Input) -> Value {
    Value::Integer(random.below(input.bound.unwrap_or(1) as usize) as i32)
}

/// A value of a type, often one at which arithmetic goes wrong.
pub fn any_value(random: &mut Random, element: Element) -> Value {
    match element {
        Element::Bool => Value::Bool(random.percent(50)),
        Element::Sint => Value::Integer(i32::from(literals::integer(random) as i8)),
        Element::Int => Value::Integer(i32::from(literals::integer(random) as i16)),
        Element::Dint => Value::Integer(literals::integer(random)),
        Element::Real => Value::Real(match random.below(4) {
            0..=1 => f32::from_bits(*random.of(literals::REALS)),
            2 => (random.below(20_001) as f32 - 10_000.0) / 8.0,
            _ => f32::from_bits(random.bits() as u32),
        }),
    }
}
