//! The format of a table file, and its reader.
//!
//! A file holds the cases of one instruction (`instruction: TON`) or of one subject (`subject: branches`). A line that
//! begins with `#` is a comment; indentation has no meaning. What stands before the first case:
//!
//! ```text
//! instruction: TON                     the instruction that the file is about
//! without fault: why there is no case  why `true`, `false`, `prescan`, `fault` or `limit` has no case here
//! ```
//!
//! A case begins with its name and holds, in any order before its trace:
//!
//! ```text
//! case: the first true execution adds no time
//! source: general-instructions.md A.2  where the expectation stands; `decided` where only this project decides
//! requirements: REQ-EXEC-040           numbers of docs/spec that it shows
//! shows: true false prescan fault limit
//! controller: 1756-L63S/20             catalogue number and revision; 1756-L73S/20 where it is not given
//! period: 10                           of the safety task in ms; 10 where it is not given
//! budget: 100                          instructions that a scan may execute
//! declare                              lines up to `end` are text before the TAG block: DATATYPE, Add-On Instructions
//! end
//! tag T : TIMER := [0,500,0]           a controller-scoped safety tag, with a value as L5K writes it
//! local Step : DINT                    a tag of the current program
//! program Second                       another program; the first is `P`; each begins with its routine `Main`
//! routine Sub                          another routine of the current program; rungs follow
//! fault routine Handler                the same, and it is the program's fault routine
//! event task Report                    a standard event task
//! rung XIC(In)TON(T,?,?)               a rung of the current routine, without the semicolon
//! refused E0306                        the project is refused with this code: there is no trace
//! ```
//!
//! The trace is a table of lines that begin with `|`. The first one names the columns: time in ms, tags that are set
//! before the scan, what is compared after it, and how the scan ends:
//!
//! ```text
//! | ms      | In | T.(EN,DN,ACC) A[0..2] S:V executed | end
//! | prescan | .  | 0 0 0           0 0 0    0   1        |
//! | 0       | 1  | 1 0 0           0 0 0    0   1        |
//! | +       | .  | 1 0 10          . . .    0   1        | fault 20
//! ```
//!
//! A time is a number, `+` (one period after the row before), or `prescan` (at the time of the row before, or a time
//! after the word). A prescan is made before the first row when that is none. `.` leaves a tag as it is, or compares
//! nothing. `T.(EN,DN)` and `A[0..2]` in a heading stand for several columns. The fourth cell is empty for a scan that completes, or `fault`
//! with the code of a major fault of type 4, or `budget`. Columns that are no tags: `S:V S:Z S:N S:C S:MINOR S:FS`,
//! `minor` (minor faults logged since the last prescan), `cleared` (major faults that a fault routine cleared since
//! then), `executed` (instructions executed in this row), `events:TASK` (triggers of an event task in this row).

use std::fmt;

/// A table file.
pub struct Table {
    /// Name of the file.
    pub file: String,
    /// Mnemonic of the instruction that it is about; `None` for a file about a subject.
    pub instruction: Option<String>,
    /// What has no case, and why.
    pub without: Vec<(Show, String)>,
    /// Its cases.
    pub cases: Vec<Case>,
}

/// What a case shows of its instruction.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Show {
    /// What it does with a true rung condition.
    True,
    /// What it does with a false rung condition.
    False,
    /// What it does in prescan.
    Prescan,
    /// A major fault that it raises.
    Fault,
    /// What it does at the ends of the range of a type.
    Limit,
}

impl Show {
    /// All of them, in the order of a report's columns.
    pub const ALL: [Show; 5] = [Show::True, Show::False, Show::Prescan, Show::Fault, Show::Limit];

    /// The word in a table.
    pub fn word(self) -> &'static str {
        match self {
            Show::True => "true",
            Show::False => "false",
            Show::Prescan => "prescan",
            Show::Fault => "fault",
            Show::Limit => "limit",
        }
    }

    fn of(word: &str) -> Option<Show> {
        Show::ALL.into_iter().find(|show| show.word() == word)
    }
}

/// A program and what it does.
#[derive(Default)]
pub struct Case {
    /// Its name.
    pub name: String,
    /// Line of its name.
    pub line: usize,
    /// Where the expectation stands.
    pub source: String,
    /// Requirements that it shows.
    pub requirements: Vec<String>,
    /// What it shows of its instruction.
    pub shows: Vec<Show>,
    /// Catalogue number and revision of the controller.
    pub controller: Option<(String, u16)>,
    /// Period of the safety task in ms.
    pub period: Option<i64>,
    /// Instructions that a scan may execute.
    pub budget: Option<u64>,
    /// Text before the TAG block.
    pub declarations: Vec<String>,
    /// Controller-scoped tags, each as `NAME : TYPE` with its value.
    pub tags: Vec<(String, Option<String>)>,
    /// Programs.
    pub programs: Vec<Program>,
    /// Standard event tasks.
    pub event_tasks: Vec<String>,
    /// The code with which the project is refused, where it is.
    pub refused: Option<String>,
    /// Tags that rows set.
    pub inputs: Vec<String>,
    /// What rows compare.
    pub outputs: Vec<String>,
    /// The trace.
    pub rows: Vec<Row>,
}

/// A program of a case.
#[derive(Default)]
pub struct Program {
    /// Its name.
    pub name: String,
    /// Its tags.
    pub tags: Vec<(String, Option<String>)>,
    /// Its routines: name and rungs.
    pub routines: Vec<(String, Vec<String>)>,
    /// Its fault routine.
    pub fault: Option<String>,
}

/// A row of a trace.
pub struct Row {
    /// Its line in the file.
    pub line: usize,
    /// Whether it is a prescan.
    pub prescan: bool,
    /// Time in ms.
    pub time: i64,
    /// Value of each input; `None` leaves it.
    pub inputs: Vec<Option<String>>,
    /// Value of each output; `None` compares nothing.
    pub outputs: Vec<Option<String>>,
    /// How it ends.
    pub end: End,
}

/// How a row ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum End {
    /// All programs ran.
    Completed,
    /// Major fault 4/code.
    Fault(u16),
    /// The budget ran out.
    Budget,
}

impl fmt::Display for End {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            End::Completed => write!(f, "completed"),
            End::Fault(code) => write!(f, "fault 4/{code}"),
            End::Budget => write!(f, "budget exceeded"),
        }
    }
}

/// Period of the safety task in ms where a case does not say.
pub const PERIOD_MS: i64 = 10;

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
                let show = Show::of(show).ok_or_else(|| format!("`{show}` is none of true false prescan fault limit"))?;
                self.table.without.push((show, why.trim().to_owned()));
            }
            "case:" => {
                let program = Program {
                    name: "P".to_owned(),
                    routines: vec![("Main".to_owned(), Vec::new())],
                    ..Program::default()
                };
                let case =
                    Case { name: rest.to_owned(), line: number, programs: vec![program], ..Case::default() };
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
            [time, inputs, outputs] | [time, inputs, outputs, _] | [time, inputs, outputs, _, ""] => (*time, *inputs, *outputs),
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
    if declared.contains(':') { Ok((declared.to_owned(), value)) } else { Err("expected NAME : TYPE".to_owned()) }
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
