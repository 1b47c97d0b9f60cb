//! Stretches of a run: a vector with jitter, devices that move in their own rhythms, or noise.

use twinrung_catalog::Element;
use twinrung_safety_vectors::Vector;

use super::call::{Call, Given, element};
use super::knowledge::Knowledge;
use super::times::Times;
use crate::generate::Random;
use crate::generate::literals::REALS;

/// Something that happens to the inputs of a call.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Event {
    /// An operand takes a value.
    Operand(usize, i32),
    /// The rung condition changes.
    Rung(bool),
}

/// How the inputs move for a while.
#[derive(Debug, Clone)]
pub enum Episode {
    /// What will happen, by time; then the episode is over.
    Script {
        /// Events in ascending time.
        events: Vec<(i64, Event)>,
        /// The first that is still to come.
        next: usize,
        /// When the episode ends.
        end_ms: i64,
    },
    /// Every operand flips with this chance (of 1000) in each scan.
    Noise {
        /// Of 1000.
        chance: usize,
        /// When the episode ends.
        end_ms: i64,
    },
}

/// The steps of a vector with the times shifted, sometimes with a step missing or two operands exchanged.
pub fn jittered(random: &mut Random, call: &Call, vector: &Vector, now_ms: i64, period_ms: i64) -> Episode {
    let mut events: Vec<(i64, Event)> = Vec::new();
    for (index, given) in call.operands.iter().enumerate().filter(|_| random.percent(90)) {
        if *given == Given::Tag {
            events.push((now_ms, Event::Operand(index, 0)));
        }
    }
    events.push((now_ms, Event::Rung(true)));
    let jitter = random.below(4);
    let scale = random.between(30, 200) as i64;
    let exchanged = random.percent(15).then(|| [0, 1].map(|_| random.below(call.operands.len())));
    let mut shifted = 0;
    for step in &vector.steps {
        let at = i64::from(step.at_ms);
        let at = match jitter {
            0 => at,
            1 => at + (random.below(3) as i64 - 1) * period_ms,
            2 => {
                // What is late once makes all that follows late.
                if random.percent(20) {
                    shifted += (random.below(9) as i64 - 3) * period_ms;
                }
                at + shifted
            }
            _ => at * scale / 100,
        };
        if step.at_ms > 0 && random.percent(4) {
            continue;
        }
        for setting in &step.inputs {
            let spread = if random.percent(6) { random.below(4) as i64 * period_ms } else { 0 };
            let index = match exchanged {
                Some([first, second]) if setting.operand == first => second,
                Some([first, second]) if setting.operand == second => first,
                _ => setting.operand,
            };
            events.push((now_ms + at.max(0) + spread, Event::Operand(index, setting.value)));
        }
        events.extend(step.rung.map(|rung| (now_ms + at.max(0), Event::Rung(rung))));
    }
    disturb(random, call, &mut events);
    let end_ms = now_ms + i64::from(vector.end_ms) * if jitter == 3 { scale } else { 100 } / 100 + period_ms;
    script(events, end_ms)
}

/// A few glitches on top.
fn disturb(random: &mut Random, call: &Call, events: &mut Vec<(i64, Event)>) {
    if events.is_empty() || !random.percent(25) {
        return;
    }
    for _ in 0..random.between(1, 3) {
        let (at, _) = *random.of(events);
        let index = random.below(call.operands.len());
        let event = if random.percent(20) {
            Event::Rung(random.percent(50))
        } else {
            Event::Operand(index, random.below(2) as i32)
        };
        events.push((at + random.below(40) as i64, event));
    }
}

fn script(mut events: Vec<(i64, Event)>, end_ms: i64) -> Episode {
    events.sort_by_key(|(at, _)| *at);
    Episode::Script { events, next: 0, end_ms }
}

/// Devices that move by themselves: channels of one device nearly together, resets as pulses, statuses that are mostly good.
pub fn rhythm(
    random: &mut Random,
    call: &Call,
    knowledge: &Knowledge,
    times: &Times,
    now_ms: i64,
    length_ms: i64,
) -> Episode {
    let end_ms = now_ms + length_ms;
    let mut events = Vec::new();
    for group in groups(call) {
        let name = call.member(group[0]);
        if group.len() == 1 && is_number(call, group[0]) {
            let known = (knowledge.values(group[0]), call.is_real(group[0]));
            numbers(random, group[0], known, times, (now_ms, end_ms), &mut events);
        } else if name.contains("Reset") || name.ends_with("Ack") {
            pulses(random, &group, times, (now_ms, end_ms), &mut events);
        } else if is_status(name) {
            statuses(random, &group, times, (now_ms, end_ms), &mut events);
        } else if group.len() >= 5 {
            positions(random, &group, times, (now_ms, end_ms), &mut events);
        } else {
            device(random, call, &group, times, (now_ms, end_ms), &mut events);
        }
    }
    let mut at = now_ms;
    events.push((at, Event::Rung(random.percent(95))));
    while random.percent(40) && at < end_ms {
        at += times.hold_ms(random) * 8;
        events.push((at, Event::Rung(false)));
        at += times.hold_ms(random);
        events.push((at, Event::Rung(true)));
    }
    script(events, end_ms)
}

/// Operands that belong to one device: names that differ in a letter or digit at the end, or in open and closed.
fn groups(call: &Call) -> Vec<Vec<usize>> {
    let mut groups: Vec<(String, Vec<usize>)> = Vec::new();
    for (index, _) in call.operands.iter().enumerate().filter(|(_, given)| **given == Given::Tag) {
        let name = call.member(index);
        let stem = name.trim_end_matches("NormallyOpen").trim_end_matches("NormallyClosed");
        let stem = stem.trim_end_matches(|last: char| last.is_ascii_digit());
        let stem = stem.strip_suffix(['A', 'B']).filter(|stem| stem.ends_with("Channel")).unwrap_or(stem);
        let number = is_number(call, index) && stem != "Channel";
        match groups.iter_mut().find(|(known, _)| known == stem && !number) {
            Some((_, group)) => group.push(index),
            None => groups.push((stem.to_owned(), vec![index])),
        }
    }
    groups.into_iter().map(|(_, group)| group).collect()
}

fn is_number(call: &Call, index: usize) -> bool {
    element(call.kind(index)) != Element::Bool
}

fn is_status(name: &str) -> bool {
    name.ends_with("Status") || name.contains("Enable") || name.contains("Disconnected") || name == "ActivePin"
}

type Span = (i64, i64);

fn pulses(random: &mut Random, group: &[usize], times: &Times, (mut at, end): Span, events: &mut Vec<(i64, Event)>) {
    let spacing = random.between(1, 6) as i64;
    for index in group {
        events.push((at, Event::Operand(*index, i32::from(random.percent(8)))));
    }
    while at < end {
        at += times.hold_ms(random) * spacing;
        for index in group {
            events.push((at, Event::Operand(*index, 1)));
            events.push((at + times.hold_ms(random), Event::Operand(*index, 0)));
        }
    }
}

fn statuses(random: &mut Random, group: &[usize], times: &Times, (start, end): Span, events: &mut Vec<(i64, Event)>) {
    let good = i32::from(random.percent(93));
    for index in group {
        let mut at = start;
        events.push((at, Event::Operand(*index, good)));
        while at < end && random.percent(50) {
            at += times.hold_ms(random) * 10;
            events.push((at, Event::Operand(*index, 1 - good)));
            at += times.hold_ms(random);
            events.push((at, Event::Operand(*index, good)));
        }
    }
}

/// A selector: one position at a time, none or two of them for a moment.
fn positions(random: &mut Random, group: &[usize], times: &Times, (start, end): Span, events: &mut Vec<(i64, Event)>) {
    let mut at = start;
    let mut position = *random.of(group);
    for index in group {
        events.push((at, Event::Operand(*index, i32::from(*index == position))));
    }
    while at < end {
        at += times.hold_ms(random);
        let next = *random.of(group);
        events.push((at, Event::Operand(position, 0)));
        events.push((at + times.skew_ms(random), Event::Operand(next, 1)));
        if random.percent(5) {
            let other = *random.of(group);
            events.push((at, Event::Operand(other, random.below(2) as i32)));
        }
        position = next;
    }
}

/// Channels that follow one device, each with its own delay, in order or out of it.
fn device(
    random: &mut Random,
    call: &Call,
    group: &[usize],
    times: &Times,
    (start, end): Span,
    events: &mut Vec<(i64, Event)>,
) {
    let complementary = call.literal("InputType") == Some(2);
    let inverted = |index: usize, position: usize| {
        let name = call.member(index);
        i32::from(name.ends_with("NormallyClosed") || complementary && position % 2 == 1)
    };
    let diverse = random.percent(15);
    let mut value = i32::from(random.percent(40));
    let mut at = start;
    let first = group.iter().enumerate();
    events.extend(first.map(|(position, index)| (at, Event::Operand(*index, value ^ inverted(*index, position)))));
    while at < end {
        at += times.hold_ms(random);
        value ^= 1;
        let mut late = 0;
        let reversed = random.percent(50);
        for position in 0..group.len() {
            let position = if reversed { group.len() - 1 - position } else { position };
            let index = group[position];
            if random.percent(97) {
                let inverted = if diverse { (position % 2) as i32 } else { inverted(index, position) };
                events.push((at + late, Event::Operand(index, value ^ inverted)));
            }
            late += times.skew_ms(random);
        }
        // A channel that bounces, or cycles alone.
        if random.percent(8) {
            let index = *random.of(group);
            let alone = at + times.hold_ms(random);
            events.push((alone, Event::Operand(index, random.below(2) as i32)));
            events.push((alone + times.hold_ms(random), Event::Operand(index, random.below(2) as i32)));
        }
        at += late / 2;
    }
}

fn numbers(
    random: &mut Random,
    index: usize,
    (known, is_real): (&[i32], bool),
    times: &Times,
    (mut at, end): Span,
    events: &mut Vec<(i64, Event)>,
) {
    while at < end {
        events.push((at, Event::Operand(index, number(random, known, is_real))));
        at += times.hold_ms(random);
    }
}

/// A number that a vector uses, one beside it, or any; a REAL as its bits.
pub fn number(random: &mut Random, known: &[i32], is_real: bool) -> i32 {
    if is_real && random.one_in(8) {
        return *random.of(REALS) as i32;
    }
    match random.below(20) {
        0 => random.bits() as i32,
        1 => *random.of(&[0, 1, -1, i32::MAX, i32::MIN]),
        2..=3 if !known.is_empty() => random.of(known).wrapping_add(random.below(3) as i32 - 1),
        _ if !known.is_empty() => *random.of(known),
        _ => random.below(8) as i32,
    }
}
