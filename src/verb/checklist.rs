//! `twinrung checklist`: the checklists of 1756-RM093 Appendix D, filled in as far as the project answers them.

use std::io::{self, Write};
use std::path::PathBuf;
use std::process::ExitCode;

use clap::Args;
use serde::Serialize;
use twinrung_compiler::compile;
use twinrung_workbench::checklist::{self, Answer, Evidence};
use twinrung_workbench::pages::markdown::escaped;

use crate::input::{self, Complete, Input};
use crate::{exit, failed, findings, terminal};

/// How the lists are printed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum Format {
    /// For a terminal.
    Human,
    /// One JSON object.
    Json,
    /// Tables to go on filling in.
    Markdown,
}

/// Arguments of `checklist`.
#[derive(Debug, Args)]
#[command(
    after_help = "A line is answered only where the files alone decide it, with the evidence; all others are left to a person.\n\
Exit code: 0 no line is answered with no, 1 one is, 2 could not read, or not all of it."
)]
pub struct Checklist {
    /// The project: .rll, .L5K, .L5X or a folder
    file: PathBuf,
    /// How to print the lists
    #[arg(long, value_enum, default_value = "human")]
    format: Format,
    #[command(flatten)]
    complete: Complete,
}

/// Fills in and prints.
pub fn run(arguments: &Checklist) -> io::Result<ExitCode> {
    let Input::Project(read) = input::open(&arguments.file, &arguments.complete).map_err(failed)? else {
        return Err(io::Error::other(format!("{} is an image: fill in from the project", arguments.file.display())));
    };
    let Some(file) = read.trees.first() else {
        return Err(io::Error::other(format!("{} holds nothing", arguments.file.display())));
    };
    let compiled = match read.project.as_ref().map(compile).transpose() {
        Ok(compiled) => compiled,
        Err(finding) => {
            terminal::tell(format_args!("no signature: {}: {}", finding.code.id, finding.message));
            None
        }
    };
    let evidence = Evidence {
        sources: &read.sources,
        file,
        findings: &read.findings,
        project: read.project.as_ref(),
        signature: compiled.as_ref().map(|compiled| &compiled.application_signature),
    };
    let lists = checklist::fill(&evidence);
    let mut out = terminal::out();
    match arguments.format {
        Format::Human => human(&mut out, &lists)?,
        Format::Json => json(&mut out, &lists)?,
        Format::Markdown => markdown(&mut out, &lists)?,
    }
    if read.is_unreadable() {
        let (path, summary) = (arguments.file.display(), findings::summary(read.count()));
        terminal::tell(format_args!("{path}: not read as a whole: {summary} (twinrung check {path} shows them)"));
        return Ok(ExitCode::from(exit::UNREADABLE));
    }
    let refused = lists.iter().flat_map(|list| &list.lines).any(|line| line.answer == Answer::No);
    Ok(if refused { ExitCode::from(exit::REFUSED) } else { ExitCode::SUCCESS })
}

fn count(lists: &[checklist::Checklist], answer: Answer) -> usize {
    lists.iter().flat_map(|list| &list.lines).filter(|line| line.answer == answer).count()
}

fn human(out: &mut dyn Write, lists: &[checklist::Checklist]) -> io::Result<()> {
    for list in lists {
        writeln!(out, "{}: {}  (1756-RM093 Appendix D, page {})", list.title, list.subject, list.page)?;
        for line in &list.lines {
            let mark = match line.answer {
                Answer::Yes => "[x]",
                Answer::No => "[NO]",
                Answer::Person => "[ ]",
            };
            writeln!(out, "  {:>2} {mark:<4} {}", line.number, line.requirement)?;
            for evidence in &line.evidence {
                writeln!(out, "            {evidence}")?;
            }
        }
        writeln!(out)?;
    }
    writeln!(
        out,
        "{} lines answered yes, {} no, {} left to a person",
        count(lists, Answer::Yes),
        count(lists, Answer::No),
        count(lists, Answer::Person)
    )
}

fn markdown(out: &mut dyn Write, lists: &[checklist::Checklist]) -> io::Result<()> {
    for list in lists {
        writeln!(out, "## {}: {}\n", list.title, escaped(&list.subject))?;
        writeln!(out, "1756-RM093 Appendix D, page {}\n", list.page)?;
        writeln!(out, "| | requirement | fulfilled | evidence and comment |\n|---|---|---|---|")?;
        for line in &list.lines {
            let answer = match line.answer {
                Answer::Yes => "yes",
                Answer::No => "no",
                Answer::Person => "",
            };
            let evidence: Vec<String> = line.evidence.iter().map(|text| escaped(text)).collect();
            writeln!(out, "| {} | {} | {answer} | {} |", line.number, line.requirement, evidence.join("<br>"))?;
        }
        writeln!(out)?;
    }
    Ok(())
}

#[derive(Serialize)]
struct Json<'a> {
    checklists: &'a [checklist::Checklist],
    yes: usize,
    no: usize,
    person: usize,
}

fn json(out: &mut dyn Write, lists: &[checklist::Checklist]) -> io::Result<()> {
    let json = Json {
        checklists: lists,
        yes: count(lists, Answer::Yes),
        no: count(lists, Answer::No),
        person: count(lists, Answer::Person),
    };
    serde_json::to_writer(&mut *out, &json)?;
    writeln!(out)
}
