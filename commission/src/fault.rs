//! Faults of the safety task, and their log.

use serde::{Deserialize, Serialize};
use twinrung_controller::StopReason;
use twinrung_controller::protection::SafetyTaskStatus;

/// Entries that the fault log keeps; the oldest goes first.
pub const LOG_ENTRIES_MAX: usize = 100;

/// The three kinds of faults (1756-RM093 GuardLogix System Faults).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum FaultKind {
    /// Of the user's program, and not handled: the logic has stopped, connections are active and idle.
    Recoverable,
    /// The safety task is shut down.
    NonrecoverableSafety,
    /// The diagnostics of a channel failed: partnership is lost.
    NonrecoverableController,
}

impl FaultKind {
    /// Its name.
    pub const fn name(self) -> &'static str {
        match self {
            FaultKind::Recoverable => "recoverable fault",
            FaultKind::NonrecoverableSafety => "nonrecoverable safety fault",
            FaultKind::NonrecoverableController => "nonrecoverable controller fault",
        }
    }

    /// The status of a safety task that has it.
    pub const fn status(self) -> SafetyTaskStatus {
        match self {
            FaultKind::Recoverable => SafetyTaskStatus::RecoverableFault,
            FaultKind::NonrecoverableSafety => SafetyTaskStatus::NonrecoverableSafetyFault,
            FaultKind::NonrecoverableController => SafetyTaskStatus::NonrecoverableControllerFault,
        }
    }
}

/// A fault.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Fault {
    /// Its kind.
    pub kind: FaultKind,
    /// Type, as the controller shows it.
    #[serde(rename = "type")]
    pub fault_type: u16,
    /// Code, as the controller shows it.
    pub code: u16,
    /// When in simulated time, in ms.
    pub at_ms: u64,
    /// What happened, in words.
    pub what: String,
}

impl Fault {
    /// What stopped a safety task at `at_ms`.
    pub fn of(reason: StopReason, at_ms: u64, what: String) -> Fault {
        let (fault_type, code) = reason.type_and_code();
        let kind = match reason {
            StopReason::Safety(_) => FaultKind::NonrecoverableSafety,
            StopReason::Recoverable(_) => FaultKind::Recoverable,
            StopReason::PartnershipLost => FaultKind::NonrecoverableController,
        };
        Fault { kind, fault_type, code, at_ms, what }
    }
}

/// An entry of the fault log.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct LogEntry {
    /// The fault.
    pub fault: Fault,
    /// What became of it, in words.
    pub outcome: Option<String>,
}
