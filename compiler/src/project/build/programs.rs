//! Programs and their routines.

use twinrung_bytecode::limits;
use twinrung_grammar::tree::{self, Class, CompactString, RoutineBody, Rung as ShownRung};

use super::{Inputs, add_ons, encoded_finding};
use crate::diagnostic::{BAD_NAME, DUPLICATE_NAME, ENCODED, Finding, Findings, OVER_LIMIT, UNKNOWN_ROUTINE};
use crate::names::{Map, closest, fold, name_fault};
use crate::operand::Scope;
use crate::project::reading::{Context, Mnemonics, Operands, RoutineNames, RungReader};
use crate::project::{AddOn, AddOnId, Program, ProgramId, Routine, RoutineId, RoutineOwner, Rung, UNNAMED_PROGRAM};
use crate::rules;

/// Programs and routines before their rungs are read.
pub(super) struct Skeleton<'a> {
    pub programs: Vec<Program>,
    /// Routines of the safety programs, then of the Add-On Instructions.
    pub routines: Vec<Routine>,
    pub routine_names: RoutineNames,
    /// The safety programs of the tree, in order.
    pub safety: Vec<ShownProgram<'a>>,
    /// The standard programs of the tree.
    pub standard: Vec<&'a tree::Program>,
}

/// A safety program of the tree, or a file that begins at ROUTINE.
pub(super) struct ShownProgram<'a> {
    pub name: CompactString,
    pub tags: &'a [tree::Tag],
    pub routines: &'a [tree::Routine],
    pub shown: Option<&'a tree::Program>,
}

/// Sorts programs by class and lists the ladder routines that will be compiled.
pub(super) fn skeleton<'a>(
    inputs: &Inputs<'a>,
    shown_add_ons: &[&tree::AddOnInstruction],
    list: &mut [AddOn],
    findings: &mut Findings,
) -> Skeleton<'a> {
    let mut safety = Vec::new();
    let mut standard = Vec::new();
    let mut seen: Map<CompactString, tree::Span> = Map::default();
    for program in &inputs.file.programs {
        if program.usage == tree::Usage::Reference {
            continue;
        }
        if let Some(first) = seen.insert(fold(program.name.as_str()), program.name.span) {
            let message = format!("the program `{}` is declared twice", program.name);
            let finding = Finding::new(&DUPLICATE_NAME, program.name.span, message)
                .label(first, "first declared here")
                .help("rename one of the two");
            findings.push(finding);
            continue;
        }
        if program.class.is_some_and(|class| class.value == Class::Safety) {
            safety.push(ShownProgram {
                name: program.name.text.clone(),
                tags: &program.tags,
                routines: &program.routines,
                shown: Some(program),
            });
        } else {
            standard.push(program);
        }
    }
    if !inputs.file.routines.is_empty() {
        // A file that begins at ROUTINE is a safety program without a name (decided).
        safety.push(ShownProgram {
            name: UNNAMED_PROGRAM.into(),
            tags: &[],
            routines: &inputs.file.routines,
            shown: None,
        });
    }
    if safety.len() > limits::PROGRAMS {
        let message = format!("a safety task has at most {} programs", limits::PROGRAMS);
        findings.push(Finding::new(&OVER_LIMIT, inputs.file.programs[0].name.span, message));
        safety.truncate(limits::PROGRAMS);
    }
    let mut programs = Vec::new();
    let mut routines: Vec<Routine> = Vec::new();
    let mut routine_names = RoutineNames::default();
    for (position, shown) in safety.iter().enumerate() {
        let id = ProgramId(position as u16);
        let program = add_program(id, shown, &mut routines, &mut routine_names, findings);
        programs.push(program);
    }
    for (position, shown) in shown_add_ons.iter().enumerate() {
        let id = AddOnId(position as u16);
        add_ons::judge_routines(shown, findings);
        for routine in &shown.routines {
            let RoutineBody::Ladder(_) = &routine.body else { continue };
            let runs = |flag: Option<tree::Spanned<bool>>| flag.is_none_or(|flag| flag.value);
            let add_on = &mut list[position];
            let next = RoutineId(routines.len() as u32);
            let slot = if routine.name.is("Logic") {
                &mut add_on.logic
            } else if routine.name.is("Prescan") && runs(shown.execute_prescan) {
                &mut add_on.prescan
            } else if routine.name.is("EnableInFalse") && runs(shown.execute_enable_in_false) {
                &mut add_on.enable_in_false
            } else {
                // Postscan cannot run in a safety application (general-instructions.md 2.7).
                continue;
            };
            if slot.is_some() {
                let message = format!("the routine `{}` is declared twice", routine.name);
                findings.push(Finding::new(&DUPLICATE_NAME, routine.name.span, message));
                continue;
            }
            *slot = Some(next);
            routines.push(Routine {
                name: routine.name.text.clone(),
                span: routine.name.span,
                owner: RoutineOwner::AddOn(id),
                rungs: Vec::new(),
            });
        }
    }
    if routines.len() > limits::ROUTINES {
        let place = routines[limits::ROUTINES].span;
        findings.push(Finding::new(&OVER_LIMIT, place, format!("there are more than {} routines", limits::ROUTINES)));
    }
    Skeleton { programs, routines, routine_names, safety, standard }
}

fn add_program(
    id: ProgramId,
    shown: &ShownProgram<'_>,
    routines: &mut Vec<Routine>,
    routine_names: &mut RoutineNames,
    findings: &mut Findings,
) -> Program {
    let mut names: Map<CompactString, (RoutineId, CompactString)> = Map::default();
    let mut own = Vec::new();
    let span = shown.shown.map_or_else(|| shown.routines[0].name.span, |program| program.name.span);
    if let Some(program) = shown.shown {
        if let Some(fault) = name_fault(program.name.as_str()) {
            findings.push(Finding::new(&BAD_NAME, span, format!("`{}` is no name: {fault}", program.name)));
        }
        program.encoded.iter().for_each(|encoded| findings.push(encoded_finding(encoded)));
        if program.test_edits.is_some_and(|edits| edits.value) {
            let at = program.test_edits.map_or(span, |edits| edits.span);
            findings.push(rules::pending_edits::test_edits(program.name.as_str(), at));
        }
    }
    for routine in shown.routines {
        if routine.usage == tree::Usage::Reference {
            continue;
        }
        match &routine.body {
            RoutineBody::Ladder(_) => {}
            RoutineBody::Island { language, .. } => {
                let message = format!("routine `{}` of a safety program is written in {language}", routine.name);
                findings.push(rules::routine_language::finding(routine.name.span, &message));
                continue;
            }
            RoutineBody::Encoded { .. } => {
                let message = format!("routine `{}` is encoded and cannot be verified", routine.name);
                let finding = Finding::new(&ENCODED, routine.name.span, message);
                findings.push(finding.help("export it without source protection"));
                continue;
            }
        }
        if let Some(fault) = name_fault(routine.name.as_str()) {
            let message = format!("`{}` is no name: {fault}", routine.name);
            findings.push(Finding::new(&BAD_NAME, routine.name.span, message));
        }
        let next = RoutineId(routines.len() as u32);
        let folded = fold(routine.name.as_str());
        if let Some((first, _)) = names.get(&folded) {
            let message = format!("the routine `{}` is declared twice", routine.name);
            let finding = Finding::new(&DUPLICATE_NAME, routine.name.span, message)
                .label(routines[first.position()].span, "first declared here")
                .help("rename one of the two");
            findings.push(finding);
            continue;
        }
        names.insert(folded, (next, routine.name.text.clone()));
        own.push(next);
        routines.push(Routine {
            name: routine.name.text.clone(),
            span: routine.name.span,
            owner: RoutineOwner::Program(id),
            rungs: Vec::new(),
        });
    }
    routine_names.programs.push(names);
    routine_names.program_names.insert(fold(&shown.name), id);
    routine_names.program_spellings.push(shown.name.clone());
    Program {
        name: shown.name.clone(),
        span,
        main: None,
        fault: None,
        disabled: shown.shown.and_then(|program| program.disabled).is_some_and(|disabled| disabled.value),
        routines: own,
    }
}

/// The rungs of every routine, in the order of the routines.
pub(super) fn read_rungs(
    context: &Context<'_>,
    mnemonics: &Mnemonics,
    operands: &mut Operands,
    routines: &[Routine],
    safety: &[ShownProgram<'_>],
    shown_add_ons: &[&tree::AddOnInstruction],
    findings: &mut Findings,
) -> Vec<Vec<Rung>> {
    let mut by_place: Map<(tree::SourceId, u32), &[ShownRung]> = Map::default();
    let shown_routines = safety.iter().flat_map(|program| program.routines);
    for routine in shown_routines.chain(shown_add_ons.iter().flat_map(|add_on| &add_on.routines)) {
        by_place.insert((routine.name.span.source, routine.name.span.start), routine.rungs());
    }
    let mut all = Vec::with_capacity(routines.len());
    let mut last_owner = None;
    let mut total = 0;
    for (position, routine) in routines.iter().enumerate() {
        if last_owner != Some(routine.owner) {
            operands.begin_scope();
            last_owner = Some(routine.owner);
        }
        let scope = match routine.owner {
            RoutineOwner::Program(program) => Scope::Program(program),
            RoutineOwner::AddOn(add_on) => Scope::AddOn(add_on),
        };
        // Found by its place: two routines of one name were reported.
        let rungs: &[ShownRung] = by_place.get(&(routine.span.source, routine.span.start)).copied().unwrap_or_default();
        total += rungs.len();
        if total > limits::RUNGS {
            let message = format!("there are more than {} rungs", limits::RUNGS);
            findings.push(Finding::new(&OVER_LIMIT, routine.span, message));
            all.push(Vec::new());
            continue;
        }
        context.begin_routine(RoutineId(position as u32));
        let mut reader = RungReader::new(context, mnemonics, operands, findings, scope);
        reader.find_labels(rungs);
        let list = rungs.iter().map(|rung| reader.rung(rung)).collect();
        all.push(list);
    }
    all
}

/// Main and fault routines.
pub(super) fn entry_points(
    safety: &[ShownProgram<'_>],
    programs: &mut [Program],
    routine_names: &RoutineNames,
    findings: &mut Findings,
) {
    for ((shown, program), names) in safety.iter().zip(programs).zip(&routine_names.programs) {
        let Some(declared) = shown.shown else {
            program.main = program.routines.first().copied();
            continue;
        };
        let mut find = |name: &Option<tree::Name>, what: &str| -> Option<RoutineId> {
            let name = name.as_ref().filter(|name| !name.as_str().is_empty())?;
            if let Some((routine, _)) = names.get(&fold(name.as_str())) {
                return Some(*routine);
            }
            // A routine in another language or encoded was reported as such.
            if shown.routines.iter().any(|routine| routine.name.is(name.as_str())) {
                return None;
            }
            let message = format!("the program has no routine `{name}`, which is named as its {what}");
            let finding = Finding::new(&UNKNOWN_ROUTINE, name.span, message);
            findings.push(match closest(name.as_str(), names.values().map(|(_, name)| name.as_str())) {
                Some(like) => finding.help(format!("did you mean `{like}`?")),
                None => finding.help("name a ladder routine of the program"),
            });
            None
        };
        program.main = find(&declared.main_routine, "main routine");
        program.fault = find(&declared.fault_routine, "fault routine");
    }
}
