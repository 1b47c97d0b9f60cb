//! The tags that the command line names as outputs: each must be one safety value that there is.

use twinrung_grammar::tree::{CompactString, Operand, Span};

use crate::diagnostic::{Finding, Findings, OPERAND_TYPE, UNKNOWN_PROGRAM};
use crate::names::{closest, fold};
use crate::operand::{Scope, Shape, read_reference};
use crate::project::reading::{Context, Refusal};

/// What stands before the name of a program.
const PROGRAM: &str = "Program:";

/// Reports every name that is not one safety value, at the controller: a command line has no place in a file.
pub(super) fn check(names: &[String], context: &Context<'_>, place: Span, findings: &mut Findings) {
    for name in names {
        if let Err(Refusal::Finding(finding)) = one_value(name, context, place) {
            let message = format!("the output `{name}` cannot be published: {}", finding.message);
            findings.push(Finding { message, span: place, ..*finding });
        }
    }
}

fn one_value(name: &str, context: &Context<'_>, place: Span) -> Result<(), Refusal> {
    let (scope, text) = match name.get(..PROGRAM.len()).filter(|head| head.eq_ignore_ascii_case(PROGRAM)) {
        None => (Scope::Controller, name),
        Some(_) => {
            let rest = name.get(PROGRAM.len()..).unwrap_or("");
            let (program, text) = rest.split_once('.').unwrap_or((rest, ""));
            (Scope::Program(find_program(program, context, place)?), text)
        }
    };
    let operand = Operand { text: CompactString::from(text), span: place, origin: None };
    let reference = read_reference(context, scope, &operand, false)?;
    if reference.shape() == Shape::Region || !reference.is_constant() {
        let finding = Finding::new(&OPERAND_TYPE, place, "it is not one BOOL or one number");
        return Err(finding.help("name a BOOL, a number, or a member or element with a constant subscript").into());
    }
    Ok(())
}

fn find_program(name: &str, context: &Context<'_>, place: Span) -> Result<crate::project::ProgramId, Refusal> {
    let names = context.routine_names;
    if let Some(program) = names.program_names.get(&fold(name)) {
        return Ok(*program);
    }
    let finding = Finding::new(&UNKNOWN_PROGRAM, place, format!("there is no safety program `{name}`"));
    Err(match closest(name, names.program_spellings.iter().map(CompactString::as_str)) {
        Some(like) => finding.help(format!("did you mean `{like}`?")).into(),
        None => finding.into(),
    })
}
