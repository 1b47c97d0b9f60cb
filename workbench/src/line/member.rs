//! One controller of a line: its scans, and what it publishes when.

use std::collections::VecDeque;

use twinrung_bytecode::AdmittedImage;
use twinrung_bytecode::channel::Channel;
use twinrung_bytecode::observer::Silent;
use twinrung_controller::{Controller, Mode, Simulated, StopReason};
use twinrung_plant::Sent;

use super::copy::Shape;
use crate::drive::Drive;
use crate::run::{RunError, powered_up};

/// A controller that is to take part.
#[derive(Debug, Clone)]
pub struct Joining {
    /// The name that a stimulus and a recording call it by, and that consumers know their producer by.
    pub name: String,
    /// Its admitted image.
    pub image: AdmittedImage,
    /// The sealed bytes of it.
    pub bytes: Vec<u8>,
    /// When its first scan begins, ms.
    pub phase_ms: u64,
    /// How long a scan takes until outputs are published, µs; at most the watchdog.
    pub execution_us: u64,
}

/// What a produced tag holds from a moment on.
#[derive(Debug, Clone)]
struct Publication {
    at_us: u64,
    sent: Sent,
}

/// A produced tag that somebody consumes.
#[derive(Debug, Clone)]
pub(super) struct Produced {
    shape: Shape,
    now: Sent,
    coming: VecDeque<Publication>,
}

impl Produced {
    pub(super) fn new(shape: Shape) -> Produced {
        Produced { shape, now: Sent::Idle, coming: VecDeque::new() }
    }

    /// What is published at a moment, which does not go back.
    pub(super) fn at(&mut self, now_us: u64) -> &Sent {
        while let Some(publication) = self.coming.pop_front_if(|next| next.at_us <= now_us) {
            self.now = publication.sent;
        }
        &self.now
    }
}

/// A controller that takes part.
pub(super) struct Member<A: Channel, B: Channel> {
    pub(super) name: String,
    pub(super) controller: Controller<A, B>,
    pub(super) drive: Drive,
    pub(super) produced: Vec<Produced>,
    /// When and why its safety task stopped, if it did: ms.
    pub(super) stopped: Option<(u64, StopReason)>,
    clock: Simulated,
    period_ms: u64,
    phase_ms: u64,
    execution_us: u64,
    scans: u64,
}

impl<A: Channel, B: Channel> Member<A, B> {
    pub(super) fn new(joining: Joining) -> Result<Member<A, B>, RunError> {
        let Joining { name, image, bytes, phase_ms, execution_us } = joining;
        let watchdog_us = image.image().task.as_ref().map_or(0, |task| u64::from(task.watchdog_us));
        let (controller, period_ms) = powered_up(image, &bytes, Mode::Run)?;
        Ok(Member {
            name,
            controller,
            drive: Drive::default(),
            produced: Vec::new(),
            stopped: None,
            clock: Simulated::new(period_ms as i64),
            period_ms,
            phase_ms,
            execution_us: execution_us.min(watchdog_us),
            scans: 0,
        })
    }

    /// When the next scan begins, ms.
    pub(super) fn next_ms(&self) -> u64 {
        self.phase_ms.saturating_add(self.scans.saturating_mul(self.period_ms))
    }

    /// Passes a scan boundary at `now_ms`; what it produces is there when the scan has ended.
    pub(super) fn scan(&mut self, now_ms: u64) {
        let own_ms = now_ms.saturating_sub(self.phase_ms);
        let report = self.controller.scan_observed(own_ms as i64, &mut self.clock, &mut Silent, &mut Silent);
        self.scans = self.scans.saturating_add(1);
        if let (Some(reason), None) = (report.stopped, self.stopped) {
            self.stopped = Some((now_ms, reason));
        }
        let at_us = now_ms.saturating_mul(1000).saturating_add(self.execution_us);
        for produced in &mut self.produced {
            let sent = match self.controller.stopped() {
                Some(StopReason::Safety(_) | StopReason::PartnershipLost) => Sent::Nothing,
                Some(StopReason::Recoverable(_)) => Sent::Idle,
                None if report.executed => Sent::Run(produced.shape.published(&self.controller)),
                None => Sent::Idle,
            };
            produced.coming.push_back(Publication { at_us, sent });
        }
    }
}
