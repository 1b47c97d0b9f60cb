//! How the command ends.

use std::process::ExitCode;

use twinrung_controller::StopReason;

/// Something was found, or refused.
pub const REFUSED: u8 = 1;
/// A file cannot be read, or an argument is wrong.
pub const UNREADABLE: u8 = 2;
/// The safety task is shut down.
pub const NONRECOVERABLE: u8 = 3;
/// A fault of the program stopped the logic.
pub const RECOVERABLE: u8 = 4;

/// Scans came to their end, or stopped for a reason.
pub fn of_scans(stopped: Option<StopReason>) -> ExitCode {
    match stopped {
        None => ExitCode::SUCCESS,
        Some(StopReason::Safety(_) | StopReason::PartnershipLost) => ExitCode::from(NONRECOVERABLE),
        Some(StopReason::Recoverable(_)) => ExitCode::from(RECOVERABLE),
    }
}
