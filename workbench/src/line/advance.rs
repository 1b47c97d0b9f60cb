//! Time goes on: events, packets and scans in the order in which they happen.

use twinrung_bytecode::channel::Channel;
use twinrung_controller::Mode;
use twinrung_plant::Received;

use super::event::{Event, Target};
use super::{Line, LineError};
use crate::names;
use crate::recording::{Recording, Row};
use crate::run::RunError;
use crate::signal::{ReadSignal, Signal};

impl<A: Channel, B: Channel> Line<A, B> {
    /// Takes on the names to record: a row whenever a controller has scanned.
    ///
    /// # Errors
    ///
    /// [`LineError`].
    pub fn record(&mut self, list: &[String]) -> Result<(), LineError> {
        let mut signals = Vec::with_capacity(list.len());
        for name in list {
            let (at, rest) = self.split(name)?;
            let signal = names::signal(self.members[at].controller.image(), rest);
            let own = &self.members[at].name;
            signals.push((at, signal.map_err(|error| LineError::Run(own.clone(), RunError::Signal(error)))?));
        }
        self.signals = signals;
        self.recording = Recording { names: list.to_vec(), rows: Vec::new() };
        Ok(())
    }

    /// What was recorded so far.
    pub fn recording(&self) -> &Recording {
        &self.recording
    }

    /// Lets everything happen up to and including `until_ms`. At one moment events come first, then packets are sent, then
    /// controllers scan in their order.
    pub fn until(&mut self, until_ms: u64) {
        let until_us = until_ms.saturating_mul(1000);
        loop {
            let scan = self.members.iter().map(|member| member.next_ms().saturating_mul(1000)).min();
            let packet = self.joints.iter().map(|joint| joint.link.next_us()).min();
            let event = self.events.first().map(|(at_us, _)| *at_us);
            let next = scan.into_iter().chain(packet).chain(event).min();
            let Some(now_us) = next.filter(|now_us| *now_us <= until_us) else { break };
            let due = self.events.partition_point(|(at_us, _)| *at_us <= now_us);
            let events: Vec<(u64, Event)> = self.events.drain(..due).collect();
            events.into_iter().for_each(|(_, event)| self.happen(event));
            self.send(now_us);
            self.scan(now_us);
        }
    }

    fn happen(&mut self, event: Event) {
        match event.target {
            Target::Mode(at) => {
                let mode = if event.good { Mode::Run } else { Mode::Program };
                if let Some(member) = self.members.get_mut(at) {
                    member.controller.request_mode(mode);
                }
            }
            Target::Partner(at) => {
                if let Some(member) = self.members.get_mut(at).filter(|_| !event.good) {
                    member.controller.lose_partnership();
                }
            }
            Target::Network(at) => {
                if let Some(joint) = self.joints.get_mut(at) {
                    joint.link.carry(event.good);
                }
            }
        }
    }

    fn send(&mut self, now_us: u64) {
        for joint in &mut self.joints {
            let (member, tag) = joint.producer;
            if let Some(produced) = self.members.get_mut(member).and_then(|member| member.produced.get_mut(tag)) {
                joint.link.pass(now_us, || produced.at(now_us).clone());
            }
        }
    }

    fn scan(&mut self, now_us: u64) {
        let now_ms = now_us / 1000;
        let mut scanned = false;
        for (at, member) in self.members.iter_mut().enumerate() {
            if member.next_ms().saturating_mul(1000) != now_us {
                continue;
            }
            member.drive.until(&mut member.controller, now_ms);
            for joint in self.joints.iter_mut().filter(|joint| joint.consumer == at) {
                joint.consumed.receive(joint.link.at(now_us), &mut member.controller);
            }
            for (_, consumed, _) in self.alone.iter().filter(|(consumer, _, _)| *consumer == at) {
                consumed.receive(Received::Faulted, &mut member.controller);
            }
            member.scan(now_ms);
            scanned = true;
        }
        if scanned && !self.signals.is_empty() {
            let value = |(at, signal): &(usize, Signal)| signal.read(&self.members[*at].controller);
            let values = self.signals.iter().map(value).collect();
            self.recording.rows.push(Row { time_ms: now_ms, values });
        }
    }
}
