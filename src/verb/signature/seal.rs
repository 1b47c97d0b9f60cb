//! Generating and removing an instruction signature, and its history: the file that defines the instruction is written anew.

use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use jiff::{Timestamp, Unit};
use twinrung_bytecode::signature::{long_form, short_form};
use twinrung_commission::Refused;
use twinrung_compiler::instruction_signature::{self as signature, Definitions, HISTORY_ENTRIES_MAX, quoted};
use twinrung_controller::Mode;
use twinrung_controller::protection::{Action, Place, State, judge};
use twinrung_grammar::tree::{AddOnInstruction, Class, File, HistoryEntry, Sources, Span, Text, Trivia, Usage};
use twinrung_grammar::{print_file_checked, read_path};

use super::listing;
use crate::input::Complete;
use crate::{exit, failed, files};

/// The file of a project that defines an instruction.
struct Defined {
    path: PathBuf,
    tree: File,
    /// Which of its instructions it is.
    at: usize,
    /// The whole project, for what the instruction uses and for the lock.
    project: File,
}

impl Defined {
    fn find(file: &Path, name: &str) -> io::Result<Defined> {
        let mut paths = files::with_ending(file, "rll")?;
        if paths.is_empty() {
            paths.push(file.to_owned());
        }
        let project = read_path(&mut Sources::new(), file).file;
        for path in paths {
            let reading = read_path(&mut Sources::new(), &path);
            let at = reading.file.add_on_instructions.iter().position(|one| {
                // A reference is not what is compiled.
                one.usage != Usage::Reference && one.name.is(name)
            });
            let Some(at) = at else { continue };
            let in_file = |what: &str| io::Error::other(format!("{}: {what}", path.display()));
            if !files::has_ending(&path, "rll") {
                return Err(in_file(
                    "an export is sealed in the tool that wrote it; twinrung fmt writes it as .rll, which is sealed here",
                ));
            }
            if !reading.errors.is_empty() {
                return Err(in_file("it could not be read as a whole, and was left as it is; twinrung check says why"));
            }
            return Ok(Defined { path, tree: reading.file, at, project });
        }
        Err(io::Error::other(format!("{}: there is no Add-On Instruction `{name}`", file.display())))
    }

    fn instruction(&mut self) -> &mut AddOnInstruction {
        &mut self.tree.add_on_instructions[self.at]
    }

    fn is_sealed(&self) -> bool {
        let shown = &self.tree.add_on_instructions[self.at];
        // A seal that cannot be read is one.
        !matches!(signature::seal(shown), Ok(None))
    }

    /// Asks the table of protection.
    fn permit(&self, action: Action) -> Result<(), Refused> {
        let safety = self.project.controller.as_ref().and_then(|controller| controller.safety.as_ref());
        let locked = safety.and_then(|safety| safety.locked).is_some_and(|locked| locked.value);
        let signed = safety.is_some_and(|safety| safety.signature.is_some());
        let state = State { place: Place::Offline, ..State::online(Mode::Program, locked, signed) };
        judge(state, action).map_err(|rule| Refused::Rule { action, rule })
    }

    fn write(&self) -> io::Result<()> {
        let text = print_file_checked(&self.tree)
            .map_err(|why| io::Error::other(format!("{}: was left as it is; {why}", self.path.display())))?;
        files::write_whole(&self.path, text.as_bytes())
    }
}

fn refuse(out: &mut dyn Write, why: &dyn std::fmt::Display) -> io::Result<ExitCode> {
    writeln!(out, "{why}")?;
    Ok(ExitCode::from(exit::REFUSED))
}

pub(super) fn generate(
    out: &mut dyn Write,
    file: &Path,
    complete: &Complete,
    name: &str,
    clock: Option<Timestamp>,
) -> io::Result<ExitCode> {
    let mut defined = Defined::find(file, name)?;
    let sealed = defined.is_sealed();
    if let Err(why) = defined.permit(Action::SealAddOn { sealed }) {
        return refuse(out, &why);
    }
    if defined.instruction().class.is_none_or(|class| class.value != Class::Safety) {
        return refuse(out, &format!("`{name}` is no safety Add-On Instruction"));
    }
    // What is sealed is what compiles.
    let read = match listing::listed(out, file, complete)? {
        Ok((read, _)) => read,
        Err(code) => return Ok(code),
    };
    let trees: Vec<&File> = read.trees.iter().collect();
    let Some(project) = &read.project else { return Err(io::Error::other("what was listed is a project")) };
    let id = Definitions::new(&trees, project).signature(defined.instruction());
    let now = clock.unwrap_or_else(Timestamp::now).round(Unit::Second).map_err(failed)?.to_string();
    signature::set_seal(defined.instruction(), Some((long_form(&id), now.clone())));
    defined.write()?;
    writeln!(out, "{}: `{name}` is sealed", defined.path.display())?;
    writeln!(out, "instruction signature  {}  {now}\nID                     {}", short_form(&id), long_form(&id))?;
    Ok(ExitCode::SUCCESS)
}

pub(super) fn remove(out: &mut dyn Write, file: &Path, name: &str) -> io::Result<ExitCode> {
    let mut defined = Defined::find(file, name)?;
    let sealed = defined.is_sealed();
    if let Err(why) = defined.permit(Action::UnsealAddOn { sealed }) {
        return refuse(out, &why);
    }
    signature::set_seal(defined.instruction(), None);
    defined.write()?;
    writeln!(out, "the instruction signature of `{name}` is removed: test and validate it again before it is sealed")?;
    Ok(ExitCode::SUCCESS)
}

pub(super) fn entry(
    out: &mut dyn Write,
    file: &Path,
    name: &str,
    user: &str,
    description: &str,
) -> io::Result<ExitCode> {
    let mut defined = Defined::find(file, name)?;
    let entries = defined.instruction().history.len();
    let action = Action::AddHistoryEntry { sealed: defined.is_sealed(), full: entries >= HISTORY_ENTRIES_MAX };
    if let Err(why) = defined.permit(action) {
        return refuse(out, &why);
    }
    let seal = match signature::seal(defined.instruction()) {
        Ok(Some(seal)) => seal,
        Ok(None) => return refuse(out, &format!("`{name}` has no instruction signature")),
        Err(broken) => return refuse(out, &broken.message),
    };
    let attributes = vec![
        quoted("User", user),
        quoted("Timestamp", seal.timestamp),
        quoted(signature::ID, long_form(&seal.id)),
        quoted("Description", description),
    ];
    let entry = HistoryEntry { attributes, text: Text::default(), trivia: Trivia::none(), span: Span::default() };
    defined.instruction().history.push(entry);
    defined.write()?;
    writeln!(out, "the history of `{name}` holds {} of {HISTORY_ENTRIES_MAX} entries", entries + 1)?;
    Ok(ExitCode::SUCCESS)
}
