//! The review of what the channels share, read from the page on which it stands.

use serde::Serialize;

use crate::inject::{Class, Group};

use super::{EvidenceError, Origin, Sources};

/// Something that both channels share.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize)]
pub struct Area {
    /// What it is.
    pub name: String,
    /// What covers it.
    pub covered_by: String,
    /// What nothing covers.
    pub not_covered: String,
    /// What the user must do.
    pub user: String,
}

/// The review.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Independence {
    /// The page, in the project.
    pub file: String,
    /// What is shared.
    pub areas: Vec<Area>,
    /// Residual classes of faults that the page does not name.
    pub unnamed: Vec<String>,
}

/// The section whose subsections are what is shared.
const SECTION: &str = "## What is shared";
const COVERED_BY: &str = "*Covered by*:";
const NOT_COVERED: &str = "*Not covered*:";
const USER: &str = "*The user*:";

impl Independence {
    pub(super) fn read(sources: &Sources, origins: &mut Vec<Origin>) -> Result<Option<Independence>, EvidenceError> {
        let Some(file) = &sources.independence else { return Ok(None) };
        let text = file.text()?;
        origins.push(file.origin(Vec::new()));
        let residual = Class::all().into_iter().filter(|class| class.group() == Group::Residual);
        let unnamed = residual.map(|class| class.to_string()).filter(|name| !names(text, name)).collect();
        Ok(Some(Independence { file: file.name.clone(), areas: areas(text), unnamed }))
    }

    /// Areas of which nothing is said that covers them; nothing where the page has no areas, and so says nothing about anything.
    pub(super) fn uncovered(&self) -> Option<f64> {
        let uncovered = self.areas.iter().filter(|area| area.covered_by.is_empty()).count();
        (!self.areas.is_empty()).then_some(uncovered as f64)
    }
}

/// Whether a page names a class of faults: as it is, or all that differ from it in the middle, as `halves.*.flip`.
fn names(text: &str, class: &str) -> bool {
    let all = match (class.split_once('.'), class.rsplit_once('.')) {
        (Some((first, _)), Some((_, last))) => format!("`{first}.*.{last}`"),
        _ => return false,
    };
    text.contains(&format!("`{class}`")) || text.contains(&all)
}

fn areas(text: &str) -> Vec<Area> {
    let section = text.split_once(SECTION).map_or("", |(_, rest)| rest);
    let section = section.split_once("\n## ").map_or(section, |(inside, _)| inside);
    section.split("\n### ").skip(1).map(area).collect()
}

/// One of the texts of an area.
type Part = fn(&mut Area) -> &mut String;

fn area(text: &str) -> Area {
    let (name, body) = text.split_once('\n').unwrap_or((text, ""));
    let mut area = Area { name: name.trim().to_owned(), ..Area::default() };
    let mut into: Option<Part> = None;
    for line in body.lines().map(str::trim).filter(|line| !line.is_empty()) {
        let parts: [(&str, Part); 3] = [
            (COVERED_BY, |area| &mut area.covered_by),
            (NOT_COVERED, |area| &mut area.not_covered),
            (USER, |area| &mut area.user),
        ];
        let begun = parts.into_iter().find_map(|(mark, part)| line.strip_prefix(mark).map(|rest| (part, rest)));
        let rest = match begun {
            Some((part, rest)) => {
                into = Some(part);
                rest
            }
            None => line,
        };
        if let Some(part) = into {
            let part = part(&mut area);
            if !part.is_empty() {
                part.push(' ');
            }
            part.push_str(&rest.trim().replace('`', ""));
        }
    }
    area
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn page_when_read_then_each_area_has_its_parts_and_what_follows_the_section_is_none() {
        let text = "# X\n\n## What is shared\n\n### The clock\n\nWords.\n*Covered by*: two of `a`,\nand b.\n*The user*: looks.\n\n### Nothing\n\n## Residual\n\n### No\n";
        let read = areas(text);
        let clock = Area {
            name: "The clock".into(),
            covered_by: "two of a, and b.".into(),
            user: "looks.".into(),
            ..Area::default()
        };
        assert_eq!(read, [clock, Area { name: "Nothing".into(), ..Area::default() }]);
    }

    #[test]
    fn class_when_a_page_names_its_kind_then_it_is_named() {
        let text = "`wire.flip` and `halves.*.flip`";
        let named = ["wire.flip", "halves.inputs.flip", "channels.cells.flip"].map(|class| names(text, class));
        assert_eq!(named, [true, true, false]);
    }
}
