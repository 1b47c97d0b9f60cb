//! The format of a table file ([`super::reader`] reads it).
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
//! tag Motor OF Word.3                  an alias
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

    /// What a word in a table means.
    pub fn of(word: &str) -> Option<Show> {
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
    /// Controller-scoped tags, each as `NAME : TYPE` with its value, or as `NAME OF TARGET`.
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
