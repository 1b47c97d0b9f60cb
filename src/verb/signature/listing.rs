//! The signature listing: what was recorded, and what is there now.

use std::fs;
use std::io::{self, Write};
use std::path::Path;
use std::process::ExitCode;

use twinrung_bytecode::signature::short_form;
use twinrung_commission::SealedInstruction;

use crate::format::write_json;
use crate::input::{self, Complete, Input, Read};
use crate::{exit, failed, instructions};

/// A project with its listing, or the exit code where it is refused.
pub(super) type Listed = Result<(Box<Read>, Vec<SealedInstruction>), ExitCode>;

/// The project, and what is listed of it; where it is refused, the exit code.
pub(super) fn listed(out: &mut dyn Write, file: &Path, complete: &Complete) -> io::Result<Listed> {
    let read = match input::open(file, complete).map_err(failed)? {
        Input::Project(read) => read,
        Input::Image(_) => {
            writeln!(out, "{}: an image holds no text that a signature of an instruction could cover", file.display())?;
            return Ok(Err(ExitCode::from(exit::REFUSED)));
        }
    };
    let Some(project) = &read.project else { return read.refuse(out, file, "; nothing was listed").map(Err) };
    let image = input::compiled(project).map_err(failed)?.image;
    let list = instructions::listing(&read.trees, &image)?;
    Ok(Ok((read, list)))
}

pub(super) fn show(out: &mut dyn Write, file: &Path, complete: &Complete, json: bool) -> io::Result<ExitCode> {
    let list = match listed(out, file, complete)? {
        Ok((_, list)) => list,
        Err(code) => return Ok(code),
    };
    if json {
        write_json(out, &list)?;
        return Ok(ExitCode::SUCCESS);
    }
    if list.is_empty() {
        writeln!(out, "no safety Add-On Instruction")?;
    }
    for one in &list {
        writeln!(out, "{}", one.name)?;
        match (&one.instruction, &one.generated) {
            (Some(id), Some(generated)) => {
                writeln!(out, "  instruction signature         {}  {generated}, sealed", short_form(id))?;
            }
            _ => writeln!(out, "  instruction signature         none: anybody may change it")?,
        }
        writeln!(out, "  safety instruction signature  {}", short_form(&one.safety))?;
        for entry in &one.history {
            writeln!(out, "  history                       {entry}")?;
        }
    }
    Ok(ExitCode::SUCCESS)
}

pub(super) fn compare(out: &mut dyn Write, file: &Path, complete: &Complete, recorded: &Path) -> io::Result<ExitCode> {
    let in_record = |error: &dyn std::fmt::Display| io::Error::other(format!("{}: {error}", recorded.display()));
    let text = fs::read_to_string(recorded).map_err(|error| in_record(&error))?;
    let recorded: Vec<SealedInstruction> = serde_json::from_str(&text).map_err(|error| in_record(&error))?;
    let list = match listed(out, file, complete)? {
        Ok((_, list)) => list,
        Err(code) => return Ok(code),
    };
    let mut same = true;
    for before in &recorded {
        let now = list.iter().find(|one| one.name.eq_ignore_ascii_case(&before.name));
        let differs = match now {
            None => vec!["it is not in the project"],
            Some(now) => now.differences(before),
        };
        same &= differs.is_empty();
        let words = if differs.is_empty() { "as recorded".to_owned() } else { differs.join("; ") };
        writeln!(out, "{}: {words}", before.name)?;
    }
    for new in list.iter().filter(|one| !recorded.iter().any(|before| before.name.eq_ignore_ascii_case(&one.name))) {
        same = false;
        writeln!(out, "{}: it was not recorded", new.name)?;
    }
    Ok(if same { ExitCode::SUCCESS } else { ExitCode::from(exit::REFUSED) })
}
