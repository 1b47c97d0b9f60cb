//! Reads a table file; [`super::table`] describes the format.

use super::table::{Case, End, PERIOD_MS, Program, Row, Show, Table};

/// Reads a table file.
///
/// # Errors
///
/// `FILE:LINE: what is wrong`, for the first line that cannot be read.
pub fn read(file: &str, text: &str) -> Result<Table, String> {
    let mut reader = Reader {
        table: Table { file: file.to_owned(), instruction: None, without: Vec::new(), cases: Vec::new() },
        subject: None,
        declaring: false,
    };
    for (index, line) in text.lines().enumerate() {
        let at = |what: String| format!("{file}:{}: {what}", index + 1);
        reader.line(index + 1, line.trim()).map_err(at)?;
    }
    reader.finish().map_err(|(line, what)| format!("{file}:{line}: {what}"))
}

struct Reader {
    table: Table,
    subject: Option<String>,
    declaring: bool,
}

impl Reader {
    fn line(&mut self, number: usize, line: &str) -> Result<(), String> {
        if self.declaring {
            match line {
                "end" => self.declaring = false,
                line => self.case()?.declarations.push(line.to_owned()),
            }
            return Ok(());
        }
        if line.is_empty() || line.starts_with('#') {
            return Ok(());
        }
        if let Some(cells) = line.strip_prefix('|') {
            return self.trace_line(number, cells);
        }
        if line == "declare" {
            self.declaring = true;
            return self.case().map(|_| ());
        }
        let (word, rest) = line.split_once(char::is_whitespace).unwrap_or((line, ""));
        let rest = rest.trim();
        match word {
            "instruction:" => self.table.instruction = Some(rest.to_owned()),
            "subject:" => self.subject = Some(rest.to_owned()),
            "without" => {
                let (show, why) = rest.split_once(':').ok_or("expected `without SHOWN: why`")?;
                let show =
                    Show::of(show).ok_or_else(|| format!("`{show}` is none of true false prescan fault limit"))?;
                self.table.without.push((show, why.trim().to_owned()));
            }
            "case:" => {
                let program = Program {
                    name: "P".to_owned(),
                    routines: vec![("Main".to_owned(), Vec::new())],
                    ..Program::default()
                };
                let case = Case { name: rest.to_owned(), line: number, programs: vec![program], ..Case::default() };
                self.table.cases.push(case);
            }
            _ => return self.case_line(word, rest),
        }
        Ok(())
    }

    fn case(&mut self) -> Result<&mut Case, String> {
        self.table.cases.last_mut().ok_or_else(|| "there is no case yet".to_owned())
    }

    fn case_line(&mut self, word: &str, rest: &str) -> Result<(), String> {
        let case = self.case()?;
        let program = case.programs.last_mut().ok_or("a case has a program")?;
        match word {
            "source:" => case.source = rest.to_owned(),
            "requirements:" => case.requirements.extend(rest.split_whitespace().map(str::to_owned)),
            "shows:" => {
                for word in rest.split_whitespace() {
                    let show = Show::of(word);
                    case.shows.push(show.ok_or_else(|| format!("`{word}` is none of true false prescan fault limit"))?);
                }
            }
            "controller:" => {
                let (catalog_number, revision) = rest.split_once('/').ok_or("expected CATALOG/REVISION")?;
                let revision = revision.parse().map_err(|_| format!("`{revision}` is no revision"))?;
                case.controller = Some((catalog_number.to_owned(), revision));
            }
            "period:" => case.period = Some(rest.parse().map_err(|_| format!("`{rest}` is no period in ms"))?),
            "budget:" => case.budget = Some(rest.parse().map_err(|_| format!("`{rest}` is no budget"))?),
            "tag" => case.tags.push(declaration(rest)?),
            "local" => program.tags.push(declaration(rest)?),
            "program" => {
                let program = Program {
                    name: rest.to_owned(),
                    routines: vec![("Main".to_owned(), Vec::new())],
                    ..Program::default()
                };
                case.programs.push(program);
            }
            "routine" => program.routines.push((rest.to_owned(), Vec::new())),
            "fault" => {
                let name = rest.strip_prefix("routine ").ok_or("expected `fault routine NAME`")?;
                program.fault = Some(name.to_owned());
                program.routines.push((name.to_owned(), Vec::new()));
            }
            "event" => {
                let name = rest.strip_prefix("task ").ok_or("expected `event task NAME`")?;
                case.event_tasks.push(name.to_owned());
            }
            "rung" => {
                let (_, rungs) = program.routines.last_mut().ok_or("a program has a routine")?;
                rungs.push(rest.to_owned());
            }
            "refused" => case.refused = Some(rest.to_owned()),
            other => return Err(format!("`{other}` begins no line of a case")),
        }
        Ok(())
    }

    fn trace_line(&mut self, number: usize, line: &str) -> Result<(), String> {
        let case = self.case()?;
        let cells: Vec<&str> = line.split('|').map(str::trim).collect();
        let (time, inputs, outputs) = match cells.as_slice() {
            [time, inputs, outputs] | [time, inputs, outputs, _] | [time, inputs, outputs, _, ""] => {
                (*time, *inputs, *outputs)
            }
            _ => return Err("a line of a trace has a time, inputs, outputs and an end, separated by `|`".to_owned()),
        };
        if time == "ms" {
            if !case.rows.is_empty() || !case.outputs.is_empty() {
                return Err("a case has one heading".to_owned());
            }
            case.inputs = expanded(inputs)?;
            case.outputs = expanded(outputs)?;
            return Ok(());
        }
        let (wanted_inputs, wanted_outputs) = (case.inputs.len(), case.outputs.len());
        if wanted_outputs == 0 {
            return Err("a trace begins with its heading, whose first cell is `ms`".to_owned());
        }
        let (prescan, time) = match time.strip_prefix("prescan") {
            Some(rest) => (true, rest.trim()),
            None => (false, time),
        };
        let before = case.rows.last().map(|row| row.time);
        let step = if prescan { 0 } else { case.period.unwrap_or(PERIOD_MS) };
        let first_scan = case.rows.iter().all(|row| row.prescan);
        let time = match (time, before) {
            ("+", Some(before)) if !first_scan => before + step,
            ("" | "+", before) => before.unwrap_or(0),
            (text, _) => text.parse().map_err(|_| format!("`{text}` is no time in ms"))?,
        };
        let row = Row {
            line: number,
            prescan,
            time,
            inputs: values(inputs, wanted_inputs, "inputs")?,
            outputs: values(outputs, wanted_outputs, "outputs")?,
            end: end(cells.get(3).copied().unwrap_or_default())?,
        };
        case.rows.push(row);
        Ok(())
    }

    fn finish(self) -> Result<Table, (usize, String)> {
        if self.declaring {
            return Err((0, "a `declare` has no `end`".to_owned()));
        }
        if self.table.instruction.is_some() == self.subject.is_some() {
            return Err((1, "a table is about an `instruction:` or a `subject:`".to_owned()));
        }
        for case in &self.table.cases {
            let has_trace = !case.rows.is_empty();
            let shows = |show| case.shows.contains(&show);
            let what = if case.source.is_empty() {
                "a case has a source"
            } else if has_trace == case.refused.is_some() {
                "a case has a trace, or is refused"
            } else if shows(Show::Prescan) && !case.rows.iter().any(|row| row.prescan) {
                "a case that shows the prescan has a row for it"
            } else if shows(Show::Fault) && !case.rows.iter().any(|row| matches!(row.end, End::Fault(_))) {
                "a case that shows a fault has a row that ends in it"
            } else {
                continue;
            };
            return Err((case.line, format!("case `{}`: {what}", case.name)));
        }
        Ok(self.table)
    }
}

fn declaration(text: &str) -> Result<(String, Option<String>), String> {
    let (declared, value) = match text.split_once(":=") {
        Some((declared, value)) => (declared.trim(), Some(value.trim().to_owned())),
        None => (text, None),
    };
    let names = declared.contains(':') || declared.contains(" OF ");
    if names { Ok((declared.to_owned(), value)) } else { Err("expected NAME : TYPE or NAME OF TARGET".to_owned()) }
}

/// Column names of a heading.
fn expanded(heading: &str) -> Result<Vec<String>, String> {
    let mut names = Vec::new();
    for word in heading.split_whitespace() {
        names.extend(expanded_word(word)?);
    }
    Ok(names)
}

fn expanded_word(word: &str) -> Result<Vec<String>, String> {
    if let Some((front, rest)) = word.split_once(".(") {
        let (list, back) = rest.split_once(')').ok_or_else(|| format!("`{word}` has no `)`"))?;
        return all(list.split(',').map(|part| expanded_word(&format!("{front}.{part}{back}"))));
    }
    let Some((before, after)) = word.split_once("..") else { return Ok(vec![word.to_owned()]) };
    let wrong = || format!("`{word}`: expected NAME[FIRST..LAST]");
    let (front, first) = before.rsplit_once(['[', ',']).ok_or_else(wrong)?;
    let opening = &before[front.len()..=front.len()];
    let length = after.find([']', ',']).ok_or_else(wrong)?;
    let (last, back) = after.split_at(length);
    let (first, last): (u32, u32) = (first.parse().map_err(|_| wrong())?, last.parse().map_err(|_| wrong())?);
    all((first..=last).map(|number| expanded_word(&format!("{front}{opening}{number}{back}"))))
}

fn all(lists: impl Iterator<Item = Result<Vec<String>, String>>) -> Result<Vec<String>, String> {
    let lists: Vec<Vec<String>> = lists.collect::<Result<_, _>>()?;
    Ok(lists.into_iter().flatten().collect())
}

fn values(cell: &str, wanted: usize, what: &str) -> Result<Vec<Option<String>>, String> {
    let found: Vec<Option<String>> =
        cell.split_whitespace().map(|word| (word != ".").then(|| word.to_owned())).collect();
    match found.len() {
        0 => Ok(vec![None; wanted]),
        length if length == wanted => Ok(found),
        length => Err(format!("the heading has {wanted} {what}, the row {length}")),
    }
}

fn end(cell: &str) -> Result<End, String> {
    match cell.split_whitespace().collect::<Vec<_>>().as_slice() {
        [] => Ok(End::Completed),
        ["budget"] => Ok(End::Budget),
        ["fault", code] => code.parse().map(End::Fault).map_err(|_| format!("`{code}` is no fault code")),
        _ => Err(format!("`{cell}` is neither empty, `fault CODE` nor `budget`")),
    }
}
