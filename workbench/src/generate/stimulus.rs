//! How the inputs of a program move: mostly a few at a time, with the values at which arithmetic goes wrong.

use twinrung_catalog::Element;

use crate::signal::Value;

use super::random::Random;
use super::{Generated, Input, literals};

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
    let mut beyond = vec![false; generated.inputs.len()];
    let mut steps = Vec::with_capacity(scans + 1);
    for scan in 0..=scans {
        let values = if scan == 0 { first_values(random, generated) } else { moved(random, generated, &mut beyond) };
        let prescan = scan == 0 || random.one_in(200);
        let system_values = random.one_in(10).then(|| random.bits());
        steps.push(Step { now_ms, prescan, values, system_values });
        now_ms += match random.below(200) {
            0 => 0,
            1 => 1,
            2..=5 => random.below(1000) as i64,
            6 => 3_000_000_000,
            _ => period_ms,
        };
    }
    let budget = if random.one_in(25) { random.between(20, 400) as u64 } else { 200_000 };
    Stimulus { budget, steps }
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
