//! Faults of the safety task. Numbers: general-instructions.md 2.5 and B.7.

use twinrung_bytecode::channel::MajorFault;

use crate::compare::Difference;
use crate::time::TimeFault;

/// A nonrecoverable safety fault: outputs are off, and stay off until a download.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SafetyFault {
    /// The channels differ (14/7).
    Difference(Difference),
    /// The clock says that the scan took longer than the watchdog (14/1).
    WatchdogExpired,
    /// The scan executed more instructions than its budget (14/1).
    BudgetExceeded,
    /// The image in memory is no longer the one that was admitted (14/7).
    ImageCorrupted,
    /// A channel did not come to the end of an execution: it stopped, or gave no answer in time (14/4).
    ChannelStopped,
    /// The second comparison found a difference, and the first did not (14/7).
    SecondComparison,
    /// A channel has executed nothing in a scan in which it had to (14/7).
    NothingExecuted,
    /// A step of the scan was left out, or a verdict is not the one that a finished comparison gives (14/7).
    VerdictIncomplete,
    /// The outputs that the halves of the controller took over from their channels differ (14/7).
    OutputsDiffer,
    /// What the controller holds twice differs between two scans: published outputs, or whether logic may execute (14/7).
    ControllerCorrupted,
    /// The time that the scan was told is not plausible (14/7).
    Time(TimeFault),
}

impl SafetyFault {
    /// Type and code as the fault log shows them.
    pub const fn type_and_code(self) -> (u16, u16) {
        match self {
            SafetyFault::WatchdogExpired | SafetyFault::BudgetExceeded => (14, 1),
            SafetyFault::ChannelStopped => (14, 4),
            SafetyFault::Difference(_)
            | SafetyFault::ImageCorrupted
            | SafetyFault::SecondComparison
            | SafetyFault::NothingExecuted
            | SafetyFault::VerdictIncomplete
            | SafetyFault::OutputsDiffer
            | SafetyFault::ControllerCorrupted
            | SafetyFault::Time(_) => (14, 7),
        }
    }
}

/// Why the safety task does not execute.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum StopReason {
    /// Nonrecoverable.
    Safety(SafetyFault),
    /// A recoverable fault that no fault routine cleared (14/2).
    Recoverable(MajorFault),
    /// A nonrecoverable controller fault: the diagnostics of a channel's hardware failed, and the partnership is lost (14/9).
    PartnershipLost,
}

impl StopReason {
    /// Type and code of the controller-level fault: what `Controller:Fault` shows is type x 1000 + code.
    pub const fn type_and_code(self) -> (u16, u16) {
        match self {
            StopReason::Safety(fault) => fault.type_and_code(),
            StopReason::Recoverable(_) => (14, 2),
            StopReason::PartnershipLost => (14, 9),
        }
    }
}
