//! Moves the inputs of one call, episode after episode.

use twinrung_catalog::Element;
use twinrung_safety_vectors::Vector;

use super::call::{Call, Given, element};
use super::episode::{Episode, Event, jittered, number, rhythm};
use super::knowledge::{Knowledge, knowledge};
use super::times::Times;
use crate::generate::Random;

/// The inputs of a call in one scan.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Inputs {
    /// The rung condition.
    pub rung: bool,
    /// Values of the operands that are tags; 0 elsewhere.
    pub operands: Vec<i32>,
}

/// Drives one call.
pub struct Driver {
    call: Call,
    knowledge: &'static Knowledge,
    times: Times,
    period_ms: i64,
    episode: Episode,
    /// The feedbacks, and how much later than the output they follow it; none while the episode moves them.
    follows: Option<i64>,
    feedbacks: Vec<usize>,
    pending: Vec<(i64, usize, i32)>,
    output: i32,
    /// What was set last.
    pub inputs: Inputs,
}

impl Driver {
    /// A driver whose first episode begins with the first scan.
    pub fn new(call: &Call, period_ms: i64) -> Driver {
        let is_feedback =
            |index: &usize| call.operands[*index] == Given::Tag && call.member(*index).starts_with("Feedback");
        Driver {
            times: Times::new(call, period_ms),
            feedbacks: (0..call.operands.len()).filter(is_feedback).collect(),
            inputs: Inputs { rung: true, operands: vec![0; call.operands.len()] },
            call: call.clone(),
            knowledge: knowledge(call.instruction.opcode),
            period_ms,
            episode: Episode::Noise { chance: 0, end_ms: i64::MIN },
            follows: None,
            pending: Vec::new(),
            output: 0,
        }
    }

    /// Moves the inputs to where they are in the scan at `now_ms`.
    pub fn advance(&mut self, random: &mut Random, now_ms: i64) {
        if self.is_over(now_ms) {
            self.begin(random, now_ms);
        }
        match &mut self.episode {
            Episode::Script { events, next, .. } => {
                while let Some((_, event)) = events.get(*next).filter(|(at, _)| *at <= now_ms) {
                    *next += 1;
                    match *event {
                        Event::Rung(rung) => self.inputs.rung = rung,
                        Event::Operand(index, value) => {
                            if self.follows.is_none() || !self.feedbacks.contains(&index) {
                                self.inputs.operands[index] = value;
                            }
                        }
                    }
                }
            }
            Episode::Noise { chance, .. } => {
                let chance = *chance;
                for index in 0..self.call.operands.len() {
                    if self.call.operands[index] == Given::Tag && random.below(1000) < chance {
                        self.inputs.operands[index] = self.any(random, index);
                    }
                }
                if random.below(4000) < chance {
                    self.inputs.rung = !self.inputs.rung;
                }
            }
        }
        let due: Vec<(usize, i32)> =
            self.pending.iter().filter(|(at, ..)| *at <= now_ms).map(|(_, index, value)| (*index, *value)).collect();
        self.pending.retain(|(at, ..)| *at > now_ms);
        due.into_iter().for_each(|(index, value)| self.inputs.operands[index] = value);
        // A script may exchange a number and a bit.
        for (index, value) in self.inputs.operands.iter_mut().enumerate() {
            if element(self.call.kind(index)) == Element::Bool {
                *value = i32::from(*value != 0);
            }
        }
    }

    /// When the next change of a script is due, after a time in ms.
    pub fn next_ms(&self, after_ms: i64) -> Option<i64> {
        let scripted = match &self.episode {
            Episode::Script { events, next, end_ms } => Some(events.get(*next).map_or(*end_ms, |(at, _)| *at)),
            Episode::Noise { .. } => None,
        };
        scripted.into_iter().chain(self.pending.iter().map(|(at, ..)| *at)).filter(|at| *at > after_ms).min()
    }

    /// The durations that matter to its call.
    pub fn times(&self) -> &Times {
        &self.times
    }

    /// Looks at the output after a scan: where feedbacks follow it they will.
    pub fn observe(&mut self, random: &mut Random, output: i32, now_ms: i64) {
        let Some(delay_ms) = self.follows else { return };
        if output == self.output {
            return;
        }
        self.output = output;
        let negative = i32::from(self.call.literal("FeedbackType") != Some(1));
        for index in self.feedbacks.clone() {
            let late = if random.percent(85) { delay_ms } else { self.times.skew_ms(random) };
            self.pending.push((now_ms + late, index, output ^ negative));
        }
    }

    fn any(&self, random: &mut Random, index: usize) -> i32 {
        match element(self.call.kind(index)) {
            Element::Bool => random.below(2) as i32,
            element => number(random, self.knowledge.values(index), element == Element::Real),
        }
    }

    fn is_over(&self, now_ms: i64) -> bool {
        match &self.episode {
            Episode::Script { end_ms, .. } | Episode::Noise { end_ms, .. } => *end_ms <= now_ms,
        }
    }

    fn begin(&mut self, random: &mut Random, now_ms: i64) {
        let length_ms = self.period_ms * random.between(60, 600) as i64;
        self.episode = match random.below(20) {
            0..=10 if !self.knowledge.vectors.is_empty() => {
                let vector = self.fitting(random);
                jittered(random, &self.call, vector, now_ms, self.period_ms)
            }
            11..=17 => rhythm(random, &self.call, self.knowledge, &self.times, now_ms, length_ms),
            _ => Episode::Noise { chance: *random.of(&[5, 20, 100, 500]), end_ms: now_ms + length_ms / 2 },
        };
        self.follows = None;
        if !self.feedbacks.is_empty() && random.percent(50) {
            self.follows = Some(self.times.skew_ms(random));
            // Where they are when the output has been as it is for long.
            self.output ^= 1;
        }
        self.pending.clear();
    }

    /// A vector, one with this call's configuration if the first draws find one.
    fn fitting(&self, random: &mut Random) -> &'static Vector {
        let is_alike = |vector: &Vector| {
            vector.configuration.iter().all(|setting| match self.call.operands[setting.operand] {
                Given::Literal(value) => value == setting.value,
                Given::Tag => true,
            })
        };
        let mut vector = random.of(&self.knowledge.vectors);
        for _ in 0..random.between(0, 30) {
            if is_alike(vector) {
                break;
            }
            vector = random.of(&self.knowledge.vectors);
        }
        vector
    }
}
