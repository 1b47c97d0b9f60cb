//! An accepted online edit: the controller holds the original and the changed rungs, and a switch says which of them execute.
//!
//! Where a routine is changed, the rungs between what both versions have alike stand there twice:
//!
//! ```text
//! XIC(Online_Edit_Tested)JMP(Online_Edit_0_Changed);
//! the original rungs
//! JMP(Online_Edit_0_Alike);
//! LBL(Online_Edit_0_Changed)NOP();
//! the changed rungs
//! LBL(Online_Edit_0_Alike)NOP();
//! ```
//!
//! So one image holds both, each channel keeps all that it holds when the switch turns, and the switch is an input that is frozen
//! at the start of a scan: both channels change at the same scan boundary, and every tag and every timer goes on.

use std::fmt;

use twinrung_bytecode::image::{Image, Owner, RoutineRecord};
use twinrung_grammar::tree::{File, Program, Routine, RoutineBody, Rung, Sources, Tag};

/// The tag that is the switch.
pub const SWITCH: &str = "Online_Edit_Tested";

/// Why both versions cannot stand side by side.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum SideBySide {
    /// The project has no routine of this name, or one with other rungs than its image.
    Routine(String),
    /// The rungs that change hold a zone, a label or a jump, which do not stand in one routine twice.
    Control(String),
    /// The project has a tag of the switch's name.
    Switch,
}

impl fmt::Display for SideBySide {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            SideBySide::Routine(name) => write!(f, "the routine {name} is not in the text of the project"),
            SideBySide::Control(name) => {
                write!(f, "the rungs of {name} that change hold an LBL, a JMP or an MCR")
            }
            SideBySide::Switch => write!(f, "a tag is called {SWITCH}"),
        }
    }
}

impl std::error::Error for SideBySide {}

/// What a text that begins at a routine, or at a controller, declares.
fn read(text: String) -> File {
    twinrung_grammar::read(&mut Sources::new(), "online-edit.rll", text.into_bytes()).file
}

fn rungs(lines: &[&str]) -> Vec<Rung> {
    let lines: String = lines.iter().map(|line| format!("  N: {line}\n")).collect();
    let file = read(format!("ROUTINE Online_Edit\n{lines}END_ROUTINE\n"));
    file.routines.first().map_or_else(Vec::new, |routine| routine.rungs().to_vec())
}

fn switch() -> Option<Tag> {
    let text = format!(
        "CONTROLLER Online_Edit ()\n  TAG\n    {SWITCH} : BOOL (Class := Safety);\n  END_TAG\nEND_CONTROLLER\n"
    );
    read(text).tags.into_iter().next()
}

/// Makes of a project with changed rungs one that holds both versions: `before` is the image with the original rungs, `after` that of
/// the project, `changed` names the routines (`Program/Routine`).
///
/// # Errors
///
/// [`SideBySide`].
pub fn put_side_by_side(
    project: &mut File,
    before: &Image,
    after: &Image,
    changed: &[String],
) -> Result<(), SideBySide> {
    if project.tags.iter().any(|tag| tag.name.is(SWITCH)) {
        return Err(SideBySide::Switch);
    }
    for (number, name) in changed.iter().enumerate() {
        let missing = || SideBySide::Routine(name.clone());
        let (old, new) = (text_of(before, name).ok_or_else(missing)?, text_of(after, name).ok_or_else(missing)?);
        let (old, new): (Vec<&str>, Vec<&str>) = (old.lines().collect(), new.lines().collect());
        let routine = routine_of(project, name).ok_or_else(missing)?;
        let RoutineBody::Ladder(own) = &mut routine.body else { return Err(missing()) };
        if own.len() != new.len() {
            return Err(missing());
        }
        let head = old.iter().zip(&new).take_while(|(one, other)| one == other).count();
        let (old_rest, new_rest) = (old.get(head..).unwrap_or_default(), new.get(head..).unwrap_or_default());
        let tail = old_rest.iter().rev().zip(new_rest.iter().rev()).take_while(|(one, other)| one == other).count();
        let original = old_rest.get(..old_rest.len() - tail).unwrap_or_default();
        let differs = new_rest.get(..new_rest.len() - tail).unwrap_or_default();
        let holds = |line: &&str| ["LBL(", "JMP(", "MCR("].iter().any(|word| line.contains(word));
        if original.iter().chain(differs).any(holds) {
            return Err(SideBySide::Control(name.clone()));
        }
        let (label, alike) = (format!("Online_Edit_{number}_Changed"), format!("Online_Edit_{number}_Alike"));
        let jump = format!("XIC({SWITCH})JMP({label});");
        let (over, begin, end) =
            (format!("JMP({alike});"), format!("LBL({label})NOP();"), format!("LBL({alike})NOP();"));
        let mut list = vec![jump.as_str()];
        list.extend(original);
        list.extend([over.as_str(), begin.as_str()]);
        let changed_at = head + list.len();
        let inserted = rungs(&list);
        if inserted.len() != list.len() {
            return Err(missing());
        }
        own.splice(head..head, inserted);
        let after_changed = changed_at + differs.len();
        own.splice(after_changed..after_changed, rungs(&[end.as_str()]));
        own.iter_mut().for_each(|rung| rung.number = None);
    }
    project.tags.extend(switch());
    Ok(())
}

fn text_of<'i>(image: &'i Image, name: &str) -> Option<&'i str> {
    let (program, routine) = name.split_once('/')?;
    let is_of = |record: &&RoutineRecord| {
        let Owner::Program(index) = record.owner else { return false };
        record.name == routine && image.programs.get(index.position()).is_some_and(|own| own.name == program)
    };
    image.routines.iter().find(is_of).map(|record| record.text.as_str())
}

fn routine_of<'f>(project: &'f mut File, name: &str) -> Option<&'f mut Routine> {
    let (program, routine) = name.split_once('/')?;
    let program: &mut Program = project.programs.iter_mut().find(|own| own.name.is(program))?;
    program.routines.iter_mut().find(|own| own.name.is(routine))
}
