//! The table of all instruction pages, and the list of files that hold them.

use std::fmt::Write;

use twinrung_catalog::{Group, Instruction, instructions};

use super::{Block, Page, Table, instruction};

/// A file of `docs/instructions`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct File {
    /// Its name in that folder.
    pub name: String,
    /// Its content.
    pub text: String,
}

/// Every file of `docs/instructions`: a page for each instruction, and the table.
pub fn files() -> Vec<File> {
    let page = |one: &&'static Instruction| File {
        name: file_name(one),
        text: format!("{}\n[All instructions](README.md)\n", instruction::page(one).markdown()),
    };
    let table = File { name: "README.md".to_owned(), text: table() };
    std::iter::once(table).chain(instructions::ALL.iter().map(page)).collect()
}

/// The list of all instructions, for a terminal.
pub fn page() -> Page {
    let mut blocks = Vec::new();
    for (group, heading) in GROUPS {
        blocks.push(Block::Heading(heading.to_owned()));
        let of_group = instructions::ALL.iter().filter(|one| one.group == group);
        blocks.push(Block::Table(Table {
            heads: vec!["instruction", "name", "what it does"],
            rows: of_group.map(|one| [one.mnemonic, one.name, one.summary].map(str::to_owned).to_vec()).collect(),
        }));
    }
    Page { title: "Every instruction that safety logic may hold".to_owned(), blocks }
}

fn file_name(instruction: &Instruction) -> String {
    format!("{}.md", instruction.mnemonic.to_lowercase())
}

const GROUPS: [(Group, &str); 12] = [
    (Group::SafetyApplication, "Safety application instructions"),
    (Group::MetalForm, "Metal-form safety application instructions"),
    (Group::SafetyApplicationV14, "Safety application instructions of version 14"),
    (Group::Bit, "Bit"),
    (Group::TimerCounter, "Timers and counters"),
    (Group::Compare, "Compare"),
    (Group::Move, "Move"),
    (Group::Logical, "Logical"),
    (Group::Math, "Math"),
    (Group::Array, "Arrays"),
    (Group::ProgramControl, "Program control"),
    (Group::InputOutput, "System values"),
];

fn table() -> String {
    let mut out = String::from(
        "# Instructions\n\nEvery instruction that safety logic may hold. `twinrung explain DCS` prints a page; `twinrung \
         explain 16#4001 --for DCS` prints one code. The pages are made from the catalog and the vectors, and a test \
         compares them: `BLESS=1 cargo test -p twinrung --test integration pages` writes them anew.\n",
    );
    for (group, heading) in GROUPS {
        let _ =
            write!(out, "\n## {heading}\n\n| instruction | name | from version | what it does |\n|---|---|---|---|\n");
        for one in instructions::ALL.iter().filter(|one| one.group == group) {
            let _ = writeln!(
                out,
                "| [{}]({}) | {} | {} | {} |",
                one.mnemonic,
                file_name(one),
                one.name,
                one.first_version,
                super::markdown::escaped(one.summary)
            );
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn table_when_made_then_every_instruction_has_a_row_and_a_file() {
        let table = table();
        let names: Vec<String> = files().into_iter().map(|file| file.name).collect();
        for one in instructions::ALL {
            assert!(table.contains(&format!("| [{}](", one.mnemonic)), "{}", one.mnemonic);
            assert!(names.contains(&file_name(one)), "{}", one.mnemonic);
        }
    }
}
