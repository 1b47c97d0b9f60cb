//! What can be disturbed, and how a fault is written so that it can be injected again.

use std::fmt;
use std::str::FromStr;

use twinrung_bytecode::injection::Memory;
use twinrung_controller::{SharedMemory, Side};

/// What is done to bits.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Bits {
    /// One is turned round, once.
    Flip,
    /// Two of the same memory are turned round, once.
    Double,
    /// One has the same value before and after each execution from then on.
    Stuck,
}

/// What is done to a rung or an instruction, once.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Upset {
    /// The rung is not executed.
    RungSkipped,
    /// The rung is executed twice.
    RungRepeated,
    /// Another rung is executed.
    RungJumped,
    /// The instruction is not executed.
    InstructionSkipped,
    /// The instruction is executed twice.
    InstructionRepeated,
    /// The rung condition behind the instruction is the opposite.
    BranchWrong,
    /// A bit of a value flips on its way to memory.
    ValueFlipped,
}

/// How a channel as a whole misbehaves.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Behaviour {
    /// It executes nothing from then on, and says that it has.
    Stops,
    /// It executes nothing in one scan, and says that it has.
    Skips,
    /// It executes one scan twice.
    Repeats,
    /// What it says after a scan is what it said after the one before.
    Late,
    /// It says that the scan ended in another way.
    EndWrong,
    /// A bit of its status or of its path signature is wrong when it is compared.
    StatusWrong,
}

/// How time is wrong from then on.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Time {
    /// Twice as fast.
    Fast,
    /// Half as fast.
    Slow,
    /// The other way.
    Backwards,
    /// Not at all.
    Stuck,
}

impl Time {
    /// The wrong time, where the right one has gone on from `since_ms`.
    pub(super) fn of(self, since_ms: i64, now_ms: i64) -> i64 {
        let gone_ms = now_ms.saturating_sub(since_ms);
        match self {
            Time::Fast => now_ms.saturating_add(gone_ms),
            Time::Slow => since_ms.saturating_add(gone_ms / 2),
            Time::Backwards => since_ms.saturating_sub(gone_ms),
            Time::Stuck => since_ms,
        }
    }
}

/// A kind of fault.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Class {
    /// Bits of a channel.
    Memory(Side, Memory, Bits),
    /// An execution of a channel.
    Upset(Side, Upset),
    /// A channel as a whole.
    Behaviour(Side, Behaviour),
    /// The time that one channel is told.
    ChannelTime(Side, Time),
    /// Bits of what both channels share, in the middle of a scan.
    Shared(SharedMemory, Bits),
    /// The time that the controller is told.
    Time(Time),
    /// Both channels as a whole, in the same way.
    BothStop,
    /// Bits of the sealed image before it is decoded.
    Image(Bits),
    /// An input that arrives wrong at the controller.
    WireFlipped,
    /// The same bit of what both halves of the controller hold, at the same moment.
    BothHalves(SharedMemory),
    /// The bit with the same number in the same memory of both channels. Where these are built alike, nothing differs.
    BothChannels(Memory),
}

/// Which faults are alike in what they show.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Group {
    /// In one channel.
    Channel,
    /// In what both channels share.
    Shared,
    /// Beyond what a controller alone can see; docs/independence.md says what covers them.
    Residual,
}

impl Group {
    /// As it is written.
    pub const fn name(self) -> &'static str {
        match self {
            Group::Channel => "channel",
            Group::Shared => "shared",
            Group::Residual => "residual",
        }
    }
}

const SIDES: [Side; 2] = [Side::Primary, Side::Partner];
const TIMES: [Time; 4] = [Time::Fast, Time::Slow, Time::Backwards, Time::Stuck];
const BITS: [Bits; 3] = [Bits::Flip, Bits::Double, Bits::Stuck];
const UPSETS: [Upset; 7] = [
    Upset::RungSkipped,
    Upset::RungRepeated,
    Upset::RungJumped,
    Upset::InstructionSkipped,
    Upset::InstructionRepeated,
    Upset::BranchWrong,
    Upset::ValueFlipped,
];
const BEHAVIOURS: [Behaviour; 6] = [
    Behaviour::Stops,
    Behaviour::Skips,
    Behaviour::Repeats,
    Behaviour::Late,
    Behaviour::EndWrong,
    Behaviour::StatusWrong,
];

impl Class {
    /// All of them.
    pub fn all() -> Vec<Class> {
        let mut all = Vec::new();
        for side in SIDES {
            for memory in Memory::ALL {
                all.extend(BITS.map(|bits| Class::Memory(side, memory, bits)));
            }
            all.extend(UPSETS.map(|upset| Class::Upset(side, upset)));
            all.extend(BEHAVIOURS.map(|behaviour| Class::Behaviour(side, behaviour)));
            all.extend(TIMES.map(|time| Class::ChannelTime(side, time)));
        }
        for memory in SharedMemory::ALL {
            all.extend([Bits::Flip, Bits::Double].map(|bits| Class::Shared(memory, bits)));
        }
        all.extend(TIMES.map(Class::Time));
        all.push(Class::BothStop);
        all.extend([Bits::Flip, Bits::Double].map(Class::Image));
        all.push(Class::WireFlipped);
        all.extend(SharedMemory::ALL.into_iter().filter(|memory| memory.is_twofold()).map(Class::BothHalves));
        all.extend(Memory::ALL.map(Class::BothChannels));
        all
    }

    /// The group.
    pub const fn group(self) -> Group {
        match self {
            Class::Memory(..) | Class::Upset(..) | Class::Behaviour(..) | Class::ChannelTime(..) => Group::Channel,
            Class::Shared(..) | Class::Time(_) | Class::BothStop | Class::Image(_) => Group::Shared,
            Class::WireFlipped | Class::BothHalves(_) | Class::BothChannels(_) => Group::Residual,
        }
    }

    /// Whether a fault has a second number beside its place.
    pub(super) const fn has_second(self) -> bool {
        matches!(
            self,
            Class::Memory(_, _, Bits::Double | Bits::Stuck)
                | Class::Upset(_, Upset::RungJumped | Upset::ValueFlipped)
                | Class::Shared(_, Bits::Double)
                | Class::Image(Bits::Double)
        )
    }
}

impl fmt::Display for Class {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Class::Memory(side, memory, bits) => {
                write!(f, "{}.{}.{}", side_name(side), memory_name(memory), bits_name(bits))
            }
            Class::Upset(side, upset) => write!(f, "{}.{}", side_name(side), upset_name(upset)),
            Class::Behaviour(side, behaviour) => write!(f, "{}.{}", side_name(side), behaviour_name(behaviour)),
            Class::ChannelTime(side, time) => write!(f, "{}.time.{}", side_name(side), time_name(time)),
            Class::Shared(memory, bits) => write!(f, "shared.{}.{}", shared_name(memory), bits_name(bits)),
            Class::Time(time) => write!(f, "both.time.{}", time_name(time)),
            Class::BothStop => f.write_str("both.stop"),
            Class::Image(bits) => write!(f, "image.{}", bits_name(bits)),
            Class::WireFlipped => f.write_str("wire.flip"),
            Class::BothHalves(memory) => write!(f, "halves.{}.flip", shared_name(memory)),
            Class::BothChannels(memory) => write!(f, "channels.{}.flip", memory_name(memory)),
        }
    }
}

const fn side_name(side: Side) -> &'static str {
    match side {
        Side::Primary => "primary",
        Side::Partner => "partner",
    }
}

const fn memory_name(memory: Memory) -> &'static str {
    match memory {
        Memory::Program => "program",
        Memory::Cells => "cells",
        Memory::State => "state",
    }
}

const fn bits_name(bits: Bits) -> &'static str {
    match bits {
        Bits::Flip => "flip",
        Bits::Double => "double",
        Bits::Stuck => "stuck",
    }
}

const fn upset_name(upset: Upset) -> &'static str {
    match upset {
        Upset::RungSkipped => "rung.skip",
        Upset::RungRepeated => "rung.repeat",
        Upset::RungJumped => "rung.jump",
        Upset::InstructionSkipped => "instruction.skip",
        Upset::InstructionRepeated => "instruction.repeat",
        Upset::BranchWrong => "branch.wrong",
        Upset::ValueFlipped => "value.flip",
    }
}

const fn behaviour_name(behaviour: Behaviour) -> &'static str {
    match behaviour {
        Behaviour::Stops => "stop",
        Behaviour::Skips => "scan.skip",
        Behaviour::Repeats => "scan.repeat",
        Behaviour::Late => "result.late",
        Behaviour::EndWrong => "end.wrong",
        Behaviour::StatusWrong => "status.flip",
    }
}

const fn time_name(time: Time) -> &'static str {
    match time {
        Time::Fast => "fast",
        Time::Slow => "slow",
        Time::Backwards => "backwards",
        Time::Stuck => "stuck",
    }
}

const fn shared_name(memory: SharedMemory) -> &'static str {
    match memory {
        SharedMemory::Image => "image",
        SharedMemory::Inputs => "inputs",
        SharedMemory::Outputs => "outputs",
        SharedMemory::Configuration => "configuration",
        SharedMemory::Time => "time",
        SharedMemory::Budget => "budget",
        SharedMemory::Verdict => "verdict",
        SharedMemory::Permit => "permit",
        SharedMemory::Mode => "mode",
    }
}

/// A fault: where and when. Written as `SCAN:CLASS:PLACE`, or `SCAN:CLASS:PLACE:SECOND`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Fault {
    /// The scan, from 0.
    pub scan: u32,
    /// What kind.
    pub class: Class,
    /// Which of the places that the class has in that scan, from 0.
    pub place: u64,
    /// A second number, where the class has one: another bit, a value, a rung.
    pub second: u64,
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}:{}", self.scan, self.class, self.place)?;
        if self.class.has_second() { write!(f, ":{}", self.second) } else { Ok(()) }
    }
}

impl FromStr for Fault {
    type Err = String;

    fn from_str(text: &str) -> Result<Fault, String> {
        let wrong = || format!("`{text}` is no fault: SCAN:CLASS:PLACE, as 17:primary.program.flip:1234");
        let mut parts = text.split(':');
        let scan = parts.next().and_then(|part| part.parse().ok()).ok_or_else(wrong)?;
        let name = parts.next().ok_or_else(wrong)?;
        let class = Class::all().into_iter().find(|class| class.to_string() == name);
        let class = class.ok_or_else(|| format!("`{name}` is no class of faults; --list shows them"))?;
        let place = parts.next().and_then(|part| part.parse().ok()).ok_or_else(wrong)?;
        let second = match (parts.next(), class.has_second()) {
            (Some(part), true) => part.parse().map_err(|_| wrong())?,
            (None, _) => 0,
            (Some(_), false) => return Err(wrong()),
        };
        if parts.next().is_some() { Err(wrong()) } else { Ok(Fault { scan, class, place, second }) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn classes_when_written_then_each_has_a_name_of_its_own() {
        let names: std::collections::BTreeSet<String> = Class::all().iter().map(Class::to_string).collect();
        assert_eq!(names.len(), Class::all().len());
    }

    #[test]
    fn faults_when_written_then_they_are_read_as_they_were() {
        for class in Class::all() {
            let second = if class.has_second() { 7 } else { 0 };
            let fault = Fault { scan: 17, class, place: 1234, second };
            assert_eq!(fault.to_string().parse(), Ok(fault));
        }
    }

    #[test]
    fn faults_when_they_are_none_then_they_are_refused() {
        let texts = [
            "",
            "17",
            "17:primary.program.flip",
            "17:nothing:1",
            "x:both.stop:0",
            "1:both.stop:0:1",
            "1:both.stop:0:1:2",
        ];
        assert!(texts.iter().all(|text| text.parse::<Fault>().is_err()));
    }
}
