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
use twinrung_grammar::tree::{Element, File, Program, Routine, RoutineBody, Rung, Sources, Tag};

/// The tag that is the switch.
pub const SWITCH: &str = "Online_Edit_Tested";

/// Why both versions cannot stand side by side.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum SideBySide {
    /// The project has no routine of this name, or one with other rungs than its image.
    Routine(String),
    /// The rungs that change hold a zone, a label or a jump, which do not stand in one routine twice.
    Control(String),
    /// The rungs that change stand in an MCR zone: while it is off, the jumps over them do not jump.
    Zone(String),
    /// The project has a tag of the switch's name, in whatever scope.
    Switch,
}

impl fmt::Display for SideBySide {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            SideBySide::Routine(name) => write!(f, "the routine {name} is not in the text of the project"),
            SideBySide::Control(name) => {
                write!(f, "the rungs of {name} that change hold an LBL, a JMP or an MCR")
            }
            SideBySide::Zone(name) => write!(f, "the rungs of {name} that change stand in an MCR zone"),
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
    // What completes a partial export has tags too: the image holds them all.
    let own = project.tags.iter().chain(project.programs.iter().flat_map(|program| &program.tags));
    let is_switch = |name: &str| name.eq_ignore_ascii_case(SWITCH);
    if own.map(|tag| tag.name.as_str()).any(is_switch) || after.tags.iter().any(|tag| is_switch(&tag.name)) {
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
        let [originals, changes] = [original, differs].map(rungs);
        if originals.iter().chain(&changes).any(|rung| ["LBL", "JMP", "MCR"].iter().any(|word| calls(rung, word))) {
            return Err(SideBySide::Control(name.clone()));
        }
        // A zone is begun by one MCR and ended by the next.
        if !own.iter().take(head).filter(|rung| calls(rung, "MCR")).count().is_multiple_of(2) {
            return Err(SideBySide::Zone(name.clone()));
        }
        let Switches { jump, over, begin, end } = Switches::of(number);
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

/// The rungs that an edit puts between those of the two versions.
struct Switches {
    jump: String,
    over: String,
    begin: String,
    end: String,
}

impl Switches {
    fn of(number: usize) -> Switches {
        let (label, alike) = (format!("Online_Edit_{number}_Changed"), format!("Online_Edit_{number}_Alike"));
        Switches {
            jump: format!("XIC({SWITCH})JMP({label});"),
            over: format!("JMP({alike});"),
            begin: format!("LBL({label})NOP();"),
            end: format!("LBL({alike})NOP();"),
        }
    }
}

/// Which rung of each version, from 0, a rung of a routine with both versions is; nothing where it is not of that version.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct OwnRung {
    /// Its number before the edit.
    pub original: Option<usize>,
    /// Its number in the changed project.
    pub changed: Option<usize>,
}

/// What a rung of a routine is, whose text may hold both versions.
pub fn own_rung(text: &str, rung: usize) -> OwnRung {
    let begins = format!("XIC({SWITCH})JMP(Online_Edit_");
    let number = text.lines().find_map(|line| line.strip_prefix(&begins)?.split('_').next()?.parse().ok());
    let same = OwnRung { original: Some(rung), changed: Some(rung) };
    let Some(Switches { jump, over, begin, end }) = number.map(Switches::of) else { return same };
    let at = |switch: &str| text.lines().position(|line| line == switch);
    let (Some(jump), Some(over), Some(begin), Some(end)) = (at(&jump), at(&over), at(&begin), at(&end)) else {
        return same;
    };
    let original = match rung {
        _ if rung < jump => Some(rung),
        _ if jump < rung && rung < over => Some(rung - 1),
        _ if rung > end => Some(rung - (end - over) - 2),
        _ => None,
    };
    let changed = match rung {
        _ if rung < jump => Some(rung),
        _ if begin < rung && rung < end => Some(rung - (begin - jump) - 1),
        _ if rung > end => Some(rung - (begin - jump) - 2),
        _ => None,
    };
    OwnRung { original, changed }
}

/// Whether a rung holds an instruction, in a branch too.
fn calls(rung: &Rung, mnemonic: &str) -> bool {
    let mut open: Vec<&Element> = rung.elements.iter().collect();
    while let Some(element) = open.pop() {
        match element {
            Element::Instruction(instruction) if instruction.mnemonic.is(mnemonic) => return true,
            Element::Instruction(_) => {}
            Element::Branch(branch) => open.extend(branch.legs.iter().flat_map(|leg| &leg.elements)),
        }
    }
    false
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

#[cfg(test)]
mod tests {
    use super::*;

    /// Two rungs alike, one original rung, two changed ones, one alike.
    const BOTH: &str = "NOP();\nNOP();\nXIC(Online_Edit_Tested)JMP(Online_Edit_3_Changed);\nOTE(A);\nJMP(Online_Edit_3_Alike);\nLBL(Online_Edit_3_Changed)NOP();\nOTE(B);\nOTE(C);\nLBL(Online_Edit_3_Alike)NOP();\nOTE(D);\n";

    fn numbers(text: &str) -> Vec<(Option<usize>, Option<usize>)> {
        let own = |rung| own_rung(text, rung);
        (0..text.lines().count()).map(own).map(|own| (own.original, own.changed)).collect()
    }

    /// REQ-EDIT-004.
    #[test]
    fn rung_when_both_versions_stand_side_by_side_then_it_has_the_number_of_each_version_that_has_it() {
        let both = |original, changed| (Some(original), Some(changed));
        let none = (None, None);
        let expected = [
            both(0, 0),
            both(1, 1),
            none,
            (Some(2), None),
            none,
            none,
            (None, Some(2)),
            (None, Some(3)),
            none,
            both(3, 4),
        ];
        assert_eq!(numbers(BOTH), expected);
    }

    /// REQ-EDIT-004.
    #[test]
    fn rung_when_its_routine_is_not_edited_then_it_keeps_its_number() {
        assert_eq!(numbers("NOP();\nOTE(A);\n"), [(Some(0), Some(0)), (Some(1), Some(1))]);
    }
}
