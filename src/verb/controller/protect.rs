//! Lock, passwords, forces, inhibited modules, faults.

use std::fs;
use std::io::{self, Read, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::{Args, ValueEnum};
use twinrung_commission::password::PASSWORD_BYTES_MAX;
use twinrung_commission::{Fault, Force};
use twinrung_controller::StopReason;
use twinrung_controller::protection::Action;
use twinrung_workbench::connected;

use super::folder::Kept;
use super::{Ended, refuse};
use crate::exit;

/// Arguments of `controller FOLDER password`.
#[derive(Debug, Args)]
pub(super) struct Password {
    /// Which password
    of: Of,
    /// The file that holds the new password, - for the standard input; without it the password is removed
    #[arg(long, value_name = "FILE")]
    new: Option<PathBuf>,
    /// The file that holds the password that is set, - for the standard input
    #[arg(long, value_name = "FILE")]
    password: Option<PathBuf>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Of {
    /// For locking.
    Lock,
    /// For unlocking.
    Unlock,
}

/// The first line of a file, or of the standard input: never an argument, which other users of the machine can see.
fn secret(path: Option<&Path>) -> io::Result<Option<Vec<u8>>> {
    let Some(path) = path else { return Ok(None) };
    // One byte more than a password can have, and its line end.
    let most = PASSWORD_BYTES_MAX as u64 + 3;
    let mut bytes = Vec::new();
    if path == Path::new("-") {
        io::stdin().take(most).read_to_end(&mut bytes)?;
    } else {
        let file = fs::File::open(path).map_err(|error| io::Error::other(format!("{}: {error}", path.display())))?;
        file.take(most).read_to_end(&mut bytes)?;
    }
    let line = bytes.split(|byte| *byte == b'\n').next().unwrap_or_default();
    Ok(Some(line.strip_suffix(b"\r").unwrap_or(line).to_vec()))
}

pub(super) fn lock(out: &mut dyn Write, kept: &mut Kept, password: Option<&Path>) -> Ended {
    if let Err(why) = kept.state.lock(secret(password)?.as_deref()) {
        return refuse(out, &why);
    }
    kept.keep()?;
    writeln!(out, "safety-locked")?;
    if kept.state.signature.is_none() {
        writeln!(out, "there is no safety task signature: the lock alone does not reach SIL 3")?;
    }
    Ok(ExitCode::SUCCESS)
}

pub(super) fn unlock(out: &mut dyn Write, kept: &mut Kept, password: Option<&Path>) -> Ended {
    if let Err(why) = kept.state.unlock(secret(password)?.as_deref()) {
        return refuse(out, &why);
    }
    kept.keep()?;
    writeln!(out, "safety-unlocked")?;
    Ok(ExitCode::SUCCESS)
}

pub(super) fn password(out: &mut dyn Write, kept: &mut Kept, arguments: &Password) -> Ended {
    let both_from_input =
        [&arguments.new, &arguments.password].iter().all(|path| path.as_deref() == Some(Path::new("-")));
    if both_from_input {
        return Err(io::Error::other("only one of two passwords can come from the standard input"));
    }
    let (old, new) = (secret(arguments.password.as_deref())?, secret(arguments.new.as_deref())?);
    let changed = kept.state.set_password(arguments.of == Of::Lock, old.as_deref(), new.as_deref());
    if let Err(why) = changed {
        return refuse(out, &why);
    }
    kept.keep()?;
    let which = if arguments.of == Of::Lock { "lock" } else { "unlock" };
    writeln!(out, "the {which} password is {}", if new.is_some() { "set" } else { "removed" })?;
    Ok(ExitCode::SUCCESS)
}

pub(super) fn force(out: &mut dyn Write, kept: &mut Kept, assignment: &str) -> Ended {
    let (tag, value) = assignment
        .split_once('=')
        .map(|(tag, value)| (tag.trim(), value.trim()))
        .ok_or_else(|| io::Error::other(format!("`{assignment}` is not TAG=VALUE, as Doors:I.Pt00Data=1")))?;
    if let Err(why) = kept.state.permit(Action::InstallForce) {
        return refuse(out, &why);
    }
    let Some((image, _)) = kept.admitted()? else { return Ok(ExitCode::from(exit::REFUSED)) };
    if let Err(why) = connected::force(&image, tag, value) {
        return refuse(out, &why);
    }
    let force = Force { tag: tag.to_owned(), value: value.to_owned() };
    if let Err(why) = kept.state.install_force(force) {
        return refuse(out, &why);
    }
    kept.keep()?;
    writeln!(out, "{tag} is forced to {value}; forces are enabled")?;
    Ok(ExitCode::SUCCESS)
}

pub(super) fn unforce(out: &mut dyn Write, kept: &mut Kept, tag: Option<&str>) -> Ended {
    if let Err(why) = kept.state.remove_force(tag) {
        return refuse(out, &why);
    }
    kept.keep()?;
    writeln!(out, "{} left", count(kept.state.forces.len(), "force"))?;
    Ok(ExitCode::SUCCESS)
}

pub(super) fn enable(out: &mut dyn Write, kept: &mut Kept, enabled: bool) -> Ended {
    if let Err(why) = kept.state.enable_forces(enabled) {
        return refuse(out, &why);
    }
    kept.keep()?;
    let words = if enabled { "enabled" } else { "disabled, and still installed" };
    writeln!(out, "{} {words}", count(kept.state.forces.len(), "force"))?;
    Ok(ExitCode::SUCCESS)
}

pub(super) fn inhibit(out: &mut dyn Write, kept: &mut Kept, module: &str, inhibited: bool) -> Ended {
    if let Some((image, _)) = kept.admitted()?
        && connected::inhibited(&image, module).is_none()
    {
        return refuse(out, &format!("no safety tag is of a module `{module}`"));
    }
    if let Err(why) = kept.state.inhibit(module, inhibited) {
        return refuse(out, &why);
    }
    kept.keep()?;
    writeln!(out, "the connection of {module} is {}", if inhibited { "inhibited" } else { "no longer inhibited" })?;
    Ok(ExitCode::SUCCESS)
}

pub(super) fn clear(out: &mut dyn Write, kept: &mut Kept) -> Ended {
    // Safety memory is initialized from what the signature names, or not at all.
    kept.admitted()?;
    if let Err(why) = kept.state.clear_fault() {
        return refuse(out, &why);
    }
    kept.keep()?;
    let outcome = kept.state.log.last().and_then(|entry| entry.outcome.as_deref()).unwrap_or("cleared");
    writeln!(out, "{outcome}")?;
    Ok(ExitCode::SUCCESS)
}

/// A simulation has no hardware that fails: a person says that it did.
pub(super) fn lose_partner(out: &mut dyn Write, kept: &mut Kept) -> Ended {
    let what = "the diagnostics of a channel failed, and the partnership is lost".to_owned();
    kept.state.report_fault(Fault::of(StopReason::PartnershipLost, 0, what));
    kept.keep()?;
    writeln!(
        out,
        "nonrecoverable controller fault 14/9: the partnership is lost, outputs are off and the application is gone"
    )?;
    writeln!(out, "download the project")?;
    Ok(ExitCode::from(exit::NONRECOVERABLE))
}

pub(super) fn override_fault(out: &mut dyn Write, kept: &mut Kept) -> Ended {
    if let Err(why) = kept.state.override_fault() {
        return refuse(out, &why);
    }
    kept.keep()?;
    writeln!(out, "overridden, not cleared: standard tasks go on, the safety task does not")?;
    writeln!(out, "to prove that this keeps the safety function is the user's responsibility")?;
    Ok(ExitCode::SUCCESS)
}

fn count(number: usize, thing: &str) -> String {
    format!("{number} {thing}{}", if number == 1 { "" } else { "s" })
}
