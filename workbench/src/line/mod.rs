//! A line: several controllers in one simulated time, with produced and consumed safety tags between them, as in the chain of
//! 1756-RM093 Figure 21.
//!
//! Names have the controller before them: `Cell_A/Doors:I.Pt00Data`. Three more can be driven: `Cell_A/Controller:Mode` (0 Program,
//! 1 Run), `Cell_A/Controller:Partner` (0: the safety partner fails, for good) and `Cell_B/Line_Stop:Network` (whether the network
//! carries what the consumed tag waits for: 0 lost, 1 carried).

mod advance;
mod copy;
mod event;
mod member;

use std::fmt;

use twinrung_bytecode::channel::Channel;
use twinrung_bytecode::image::{TagKind, TagRecord};
use twinrung_bytecode::index::TagIndex;
use twinrung_controller::{Controller, StopReason};
use twinrung_plant::Times;

use copy::{Shape, connected};
use event::{Event, Target, events};
use member::{Member, Produced};

pub use member::Joining;

use crate::drive::Drive;
use crate::names;
use crate::reaction::Connection;
use crate::recording::Recording;
use crate::run::RunError;
use crate::signal::Signal;
use crate::stimulus::{Stimulus, StimulusRow};

/// Why controllers cannot be a line.
#[derive(Debug, Clone, PartialEq)]
pub enum LineError {
    /// Two of them have one name.
    Name(String),
    /// A name without a controller before it, or with one that is not there.
    Member(String),
    /// One of them.
    Run(String, RunError),
    /// The types of a produced tag and of the tag that consumes it differ.
    Shape {
        /// The consumed tag, with its controller.
        consumed: String,
        /// The produced tag, with its controller.
        produced: String,
    },
    /// A stimulus drives what a producer drives.
    Driven(String),
    /// A value of a name of this module that is not 0 or 1.
    Value(String),
}

impl fmt::Display for LineError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            LineError::Name(name) => write!(f, "two controllers are called `{name}`"),
            LineError::Member(name) => {
                write!(f, "`{name}` does not begin with a controller of the line, as Cell_A/Doors:I.Pt00Data")
            }
            LineError::Run(name, error) => write!(f, "{name}: {error}"),
            LineError::Shape { consumed, produced } => {
                write!(f, "{consumed} has another type than {produced}, which it consumes: give both the same members")
            }
            LineError::Driven(name) => write!(f, "`{name}` is driven by its producer; drive what the producer reads"),
            LineError::Value(name) => write!(f, "`{name}` takes 0 or 1"),
        }
    }
}

impl std::error::Error for LineError {}

/// A consumed tag whose producer takes part.
struct Joint {
    link: twinrung_plant::Connection,
    /// The producing member, and which of its produced tags it is.
    producer: (usize, usize),
    consumer: usize,
    consumed: Shape,
    name: String,
}

/// Controllers with the connections between them.
pub struct Line<A: Channel, B: Channel> {
    members: Vec<Member<A, B>>,
    joints: Vec<Joint>,
    /// Consumed tags, with their controller, whose producer does not take part: their connection is faulted.
    alone: Vec<(usize, Shape, String)>,
    events: Vec<(u64, Event)>,
    signals: Vec<(usize, Signal)>,
    recording: Recording,
}

impl<A: Channel, B: Channel> Line<A, B> {
    /// Powers up controllers in Run. `delay_us` is how long a packet is on its way; the n-th connection sends its first packet
    /// at `first_us(n)`.
    ///
    /// # Errors
    ///
    /// [`LineError`].
    pub fn new(joining: Vec<Joining>, delay_us: u64, first_us: impl Fn(usize) -> u64) -> Result<Line<A, B>, LineError> {
        let mut members: Vec<Member<A, B>> = Vec::new();
        for one in joining {
            let name = one.name.clone();
            if members.iter().any(|other| other.name.eq_ignore_ascii_case(&name)) {
                return Err(LineError::Name(name));
            }
            members.push(Member::new(one).map_err(|error| LineError::Run(name, error))?);
        }
        let (mut joints, mut alone) = (Vec::new(), Vec::new());
        for consumer in 0..members.len() {
            let image = members[consumer].controller.image().clone();
            for index in connected(&image, TagKind::Consumed) {
                let (Some(tag), Some(consumed)) = (image.image().tags.get(index.position()), Shape::of(&image, index))
                else {
                    continue;
                };
                let name = format!("{}/{}", members[consumer].name, tag.name);
                let Some((producer, produced, sending)) = producer_of(&members, consumer, tag) else {
                    alone.push((consumer, consumed, name));
                    continue;
                };
                if !consumed.fits(&sending) {
                    return Err(LineError::Shape { consumed: name, produced });
                }
                let connection = Connection::of_consumed_record(tag);
                let times = Times {
                    rpi_us: connection.rpi_us(),
                    limit_us: connection.limit_us(),
                    delay_us,
                    first_us: first_us(joints.len()),
                };
                let list = &mut members[producer].produced;
                list.push(Produced::new(sending));
                let producer = (producer, list.len() - 1);
                joints.push(Joint { link: twinrung_plant::Connection::new(times), producer, consumer, consumed, name });
            }
        }
        Ok(Line { members, joints, alone, events: Vec::new(), signals: Vec::new(), recording: Recording::default() })
    }

    /// The names of the controllers.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.members.iter().map(|member| member.name.as_str())
    }

    /// Consumed tags, with their controller, whose producer does not take part: their connection is faulted.
    pub fn unconnected(&self) -> impl Iterator<Item = &str> {
        self.alone.iter().map(|(_, _, name)| name.as_str())
    }

    /// What is recorded when nobody says: what the stimulus drives that can be recorded, then the data and status of what is
    /// consumed, then what is published of output modules.
    pub fn recordable(&self, stimulus: Option<&Stimulus>) -> Vec<String> {
        let mut found: Vec<String> = stimulus.map(|stimulus| stimulus.tags.clone()).unwrap_or_default();
        found.retain(|name| {
            self.split(name).is_ok_and(|(at, rest)| names::signal(self.members[at].controller.image(), rest).is_ok())
        });
        for member in &self.members {
            let image = member.controller.image();
            for index in connected(image, TagKind::Consumed) {
                found.extend(
                    names::values_of(image, index).into_iter().map(|(name, _)| format!("{}/{name}", member.name)),
                );
            }
            let written = image.program_writes();
            for index in connected(image, TagKind::ModuleOutput) {
                let values = names::values_of(image, index).into_iter();
                let on = values.filter(|(_, signal)| matches!(signal, Signal::Bit(cell) if written.has_bit(*cell)));
                found.extend(on.map(|(name, _)| format!("{}/Published:{name}", member.name)));
            }
        }
        found
    }

    /// One of the controllers.
    pub fn controller(&self, name: &str) -> Option<&Controller<A, B>> {
        self.members.iter().find(|member| member.name.eq_ignore_ascii_case(name)).map(|member| &member.controller)
    }

    /// When (in ms) and why a controller's safety task stopped, of those that stopped.
    pub fn stopped(&self) -> impl Iterator<Item = (&str, u64, StopReason)> {
        self.members
            .iter()
            .filter_map(|member| member.stopped.map(|(at_ms, reason)| (member.name.as_str(), at_ms, reason)))
    }

    /// The member that a name begins with, and the rest of the name.
    fn split<'n>(&self, name: &'n str) -> Result<(usize, &'n str), LineError> {
        let wrong = || LineError::Member(name.to_owned());
        let (member, rest) = name.split_once('/').ok_or_else(wrong)?;
        let at = self.members.iter().position(|one| one.name.eq_ignore_ascii_case(member)).ok_or_else(wrong)?;
        Ok((at, rest))
    }

    /// Takes on a stimulus.
    ///
    /// # Errors
    ///
    /// [`LineError`].
    pub fn stimulate(&mut self, stimulus: &Stimulus) -> Result<(), LineError> {
        let mut own: Vec<(Vec<String>, Vec<usize>)> = vec![Default::default(); self.members.len()];
        self.events.clear();
        for (column, name) in stimulus.tags.iter().enumerate() {
            let (at, rest) = self.split(name)?;
            match self.target(at, rest) {
                Some(target) => self.events.extend(events(stimulus, column, target)?),
                None => {
                    self.is_free(at, rest, name)?;
                    own[at].0.push(rest.to_owned());
                    own[at].1.push(column);
                }
            }
        }
        self.events.sort_by_key(|(at_us, _)| *at_us);
        for (member, (tags, columns)) in self.members.iter_mut().zip(own) {
            let cells = |row: &StimulusRow| columns.iter().map(|at| row.cells.get(*at).cloned().flatten()).collect();
            let rows = stimulus.rows.iter().map(|row| StimulusRow { cells: cells(row), ..row.clone() }).collect();
            let drive = Drive::new(&mut member.controller, &Stimulus { tags, rows });
            member.drive = drive.map_err(|error| LineError::Run(member.name.clone(), error))?;
        }
        Ok(())
    }

    /// What a name drives that is no tag of a controller.
    fn target(&self, at: usize, rest: &str) -> Option<Target> {
        let is = |name: &str| rest.eq_ignore_ascii_case(name);
        if is("Controller:Mode") {
            return Some(Target::Mode(at));
        }
        if is("Controller:Partner") {
            return Some(Target::Partner(at));
        }
        let tag = rest.rsplit_once(':').filter(|(_, word)| word.eq_ignore_ascii_case("Network"))?.0;
        let own = format!("{}/{tag}", self.members.get(at)?.name);
        self.joints.iter().position(|joint| joint.name.eq_ignore_ascii_case(&own)).map(Target::Network)
    }

    fn is_free(&self, at: usize, rest: &str, name: &str) -> Result<(), LineError> {
        let Ok(signal) = names::signal(self.members[at].controller.image(), rest) else { return Ok(()) };
        let joined = self.joints.iter().any(|joint| joint.consumer == at && joint.consumed.holds(signal));
        let alone = self.alone.iter().any(|(member, shape, _)| *member == at && shape.holds(signal));
        if joined || alone { Err(LineError::Driven(name.to_owned())) } else { Ok(()) }
    }
}

/// The member, other than the consumer, whose produced tag a consumed one names: the one with the name of its producer, else
/// the only one that produces a tag of this name. With the name of the produced tag for people, and its shape.
fn producer_of<A: Channel, B: Channel>(
    members: &[Member<A, B>],
    consumer: usize,
    tag: &TagRecord,
) -> Option<(usize, String, Shape)> {
    let setting = |key: &str| {
        let value = tag.attributes.iter().find(|(own, _)| own == key).map(|(_, value)| value.trim_matches('"'));
        value.unwrap_or_default()
    };
    let remote = Some(setting("RemoteTag")).filter(|remote| !remote.is_empty()).unwrap_or(&tag.name);
    let produced = |member: &Member<A, B>| -> Option<TagIndex> {
        let records = &member.controller.image().image().tags;
        connected(member.controller.image(), TagKind::Produced)
            .find(|index| records.get(index.position()).is_some_and(|own| own.name.eq_ignore_ascii_case(remote)))
    };
    let others = members.iter().enumerate().filter(|(at, _)| *at != consumer);
    let candidates: Vec<(usize, TagIndex)> = others.filter_map(|(at, one)| Some((at, produced(one)?))).collect();
    let named = candidates.iter().find(|(at, _)| members[*at].name.eq_ignore_ascii_case(setting("Producer")));
    let (at, index) = match (named, candidates.as_slice()) {
        (Some(found), _) => *found,
        (None, [only]) => *only,
        (None, _) => return None,
    };
    let shape = Shape::of(members[at].controller.image(), index)?;
    Some((at, format!("{}/{remote}", members[at].name), shape))
}
