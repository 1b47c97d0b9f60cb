//! Which value of a produced tag becomes which value of the tag that consumes it.

use twinrung_bytecode::AdmittedImage;
use twinrung_bytecode::channel::Channel;
use twinrung_bytecode::image::TagKind;
use twinrung_bytecode::index::TagIndex;
use twinrung_controller::Controller;
use twinrung_plant::Received;

use crate::names;
use crate::signal::Signal;

/// The values of a produced or consumed tag, in the order of its declaration, without its CONNECTION_STATUS.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Shape {
    /// RunMode and ConnectionFaulted.
    status: [Signal; 2],
    data: Vec<Signal>,
    /// What both sides must have alike: the names of the values behind that of the tag.
    paths: Vec<String>,
}

impl Shape {
    /// Of a tag whose first member is its CONNECTION_STATUS; nothing where that is not so.
    pub(super) fn of(image: &AdmittedImage, tag: TagIndex) -> Option<Shape> {
        let name = &image.image().tags.get(tag.position())?.name;
        let values = names::values_of(image, tag);
        let [(run, run_mode), (fault, faulted), data @ ..] = values.as_slice() else { return None };
        let is = |path: &str, member: &str| path.rsplit('.').next().is_some_and(|last| last == member);
        if !is(run, "RunMode") || !is(fault, "ConnectionFaulted") {
            return None;
        }
        let path = |(value, signal): &(String, Signal)| {
            let kind = if let Signal::Word(_, element) = signal { element.name() } else { "BOOL" };
            format!("{} {kind}", value.get(name.len()..).unwrap_or_default().to_ascii_lowercase())
        };
        Some(Shape {
            status: [*run_mode, *faulted],
            data: data.iter().map(|(_, signal)| *signal).collect(),
            paths: data.iter().map(path).collect(),
        })
    }

    /// Whether what another tag sends fits this one.
    pub(super) fn fits(&self, other: &Shape) -> bool {
        self.paths == other.paths
    }

    /// Whether a value is one of these: a stimulus cannot drive it.
    pub(super) fn holds(&self, signal: Signal) -> bool {
        self.status.contains(&signal) || self.data.contains(&signal)
    }

    /// What is published of a produced tag.
    pub(super) fn published<A: Channel, B: Channel>(&self, controller: &Controller<A, B>) -> Vec<i32> {
        let value = |signal: &Signal| match *signal {
            Signal::Bit(cell) => i32::from(controller.published_bit(cell).unwrap_or_default()),
            Signal::Word(cell, _) => controller.published_word(cell).unwrap_or_default(),
            _ => 0,
        };
        self.data.iter().map(value).collect()
    }

    /// Sets a consumed tag to what was received.
    pub(super) fn receive<A: Channel, B: Channel>(&self, received: Received<'_>, controller: &mut Controller<A, B>) {
        let mut set = |signal: Signal, value: i32| match signal {
            Signal::Bit(cell) => controller.drive_bit(cell, value == 1),
            Signal::Word(cell, _) => controller.drive_word(cell, value),
            _ => {}
        };
        for (signal, value) in self.status.into_iter().zip([received.run_mode(), received.connection_faulted()]) {
            set(signal, i32::from(value));
        }
        for (position, signal) in self.data.iter().enumerate() {
            set(*signal, received.value(position));
        }
    }
}

/// A tag that is connected to another controller.
pub(super) fn connected(image: &AdmittedImage, kind: TagKind) -> impl Iterator<Item = TagIndex> {
    let tags = image.image().tags.iter().enumerate();
    tags.filter(move |(_, tag)| tag.kind == kind).map(|(index, _)| TagIndex(index as u32))
}
