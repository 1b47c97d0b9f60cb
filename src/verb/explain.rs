//! `twinrung explain`: the page of a code, an instruction, or a code of an instruction.

use std::io::{self, Write};
use std::process::ExitCode;

use clap::Args;
use twinrung_catalog::Instruction;
use twinrung_compiler::rules::uncertified;
use twinrung_workbench::pages::{Page, codes, findings, index, instruction};

use crate::exit;
use crate::terminal::{self, Terminal};

/// Arguments of `explain`.
#[derive(Debug, Args)]
#[command(
    after_help = "Examples:\n  twinrung explain S0101\n  twinrung explain DCS\n  twinrung explain instructions\n  twinrung explain 16#4001 --for DCS\n  \
twinrung explain II --for DIN"
)]
pub struct Explain {
    /// A finding's code (S0101), a mnemonic (DCS), `instructions` for the list of them, or the fault or diagnostic code that an instruction shows (16#4001)
    what: String,
    /// The instruction that shows the fault or diagnostic code
    #[arg(long = "for", value_name = "MNEMONIC")]
    instruction: Option<String>,
}

/// Widest page: longer lines are hard to read.
const COLUMNS_MAX: usize = 100;

/// Prints the page.
pub fn run(arguments: &Explain) -> io::Result<ExitCode> {
    let page = match &arguments.instruction {
        Some(mnemonic) => codes::of_instruction(&arguments.what, mnemonic),
        None => of(&arguments.what),
    };
    match page {
        Ok(page) => {
            let columns = Terminal::of_stdout().columns.min(COLUMNS_MAX);
            terminal::out().write_all(page.terminal(columns).as_bytes())?;
            Ok(ExitCode::SUCCESS)
        }
        Err(message) => {
            terminal::tell(format_args!("{message}"));
            Ok(ExitCode::from(exit::UNREADABLE))
        }
    }
}

fn of(what: &str) -> Result<Page, String> {
    if what.eq_ignore_ascii_case("instructions") {
        return Ok(index::page());
    }
    findings::page(what)
        .or_else(|| Instruction::by_mnemonic(what).map(instruction::page))
        .or_else(|| codes::of_every_instruction(what))
        .ok_or_else(|| match what {
            _ if uncertified::is_known(what) => format!(
                "{what} is an instruction of standard logic, and not certified for safety logic; `twinrung explain \
                 instructions` lists those that are, `twinrung explain S0101` says why"
            ),
            _ => format!(
                "nothing is known as `{what}`; give a code such as S0101, or a certified instruction such as DCS \
                 (`twinrung explain instructions` lists them)"
            ),
        })
}
