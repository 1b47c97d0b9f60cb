//! Real exports parse. They lie beside the project; where they are not, this says so and passes.

use std::path::{Path, PathBuf};

use twinrung_grammar::tree::{Element, ErrorKind, File, Instruction, RoutineBody, Sources};
use twinrung_grammar::{Reading, print_file, read, read_expression, read_path, read_tag};

fn corpus() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../shared/corpus");
    let mut files = Vec::new();
    let mut waiting = vec![folder];
    while let Some(next) = waiting.pop() {
        let entries = std::fs::read_dir(&next).into_iter().flatten().flatten().map(|entry| entry.path());
        let (folders, exports): (Vec<_>, Vec<_>) = entries.partition(|path| path.is_dir());
        waiting.extend(folders);
        files.extend(exports.into_iter().filter(|path| path.extension().is_some_and(|ext| ext == "L5X")));
    }
    files.sort();
    println!("{} exports{}", files.len(), if files.is_empty() { ": skipped" } else { "" });
    files
}

fn read_all() -> Vec<(PathBuf, Sources, Reading)> {
    let read = |path: PathBuf| {
        let mut sources = Sources::new();
        let reading = read_path(&mut sources, &path);
        (path, sources, reading)
    };
    corpus().into_iter().map(read).collect()
}

fn rungs(file: &File) -> usize {
    let add_ons = file.add_on_instructions.iter().flat_map(|add_on| &add_on.routines);
    let programs = file.programs.iter().flat_map(|program| &program.routines);
    add_ons.chain(programs).chain(&file.routines).map(|routine| routine.rungs().len()).sum()
}

#[test]
fn corpus_when_read_then_only_broken_rungs_are_errors() {
    for (path, sources, reading) in read_all() {
        println!(
            "{:55} {:4} types {:3} modules {:3} add-ons {:4} tags {:5} rungs {:2} errors",
            path.file_name().unwrap().to_string_lossy(),
            reading.file.data_types.len(),
            reading.file.modules.len(),
            reading.file.add_on_instructions.len(),
            reading.file.tags.len(),
            rungs(&reading.file),
            reading.errors.len()
        );
        for error in &reading.errors {
            let place = sources.line_column(error.span);
            println!("    {}:{} {}: {error}", place.line, place.column, error.kind.name());
        }
        // One export of the corpus, made by a tool, has a rung whose text is `//`.
        let broken = reading.errors.iter().filter(|error| error.kind == ErrorKind::MalformedRung).count();
        assert_eq!(broken, reading.errors.len(), "{}", path.display());
        assert!(broken <= usize::from(path.ends_with("ControlRox/mytest.L5X")), "{}", path.display());
    }
}

/// REQ-LANG-006, REQ-LANG-031
#[test]
fn corpus_when_read_then_every_instruction_is_where_its_span_says() {
    for (path, sources, reading) in read_all() {
        for rung in all_rungs(&reading.file) {
            let text = sources.text(rung.span);
            let printed = twinrung_grammar::print_rung(rung);
            let squeezed = |text: &str| text.chars().filter(|c| !c.is_whitespace()).collect::<String>();
            assert!(
                rung.broken || squeezed(text) == squeezed(&printed) || text.contains('&'),
                "{}: {text}\n{printed}",
                path.display()
            );
        }
    }
}

#[test]
fn corpus_when_printed_and_read_then_rungs_are_the_same() {
    for (path, _, reading) in read_all() {
        let text = print_file(&reading.file);
        let again = read(&mut Sources::new(), "printed.rll", text.into_bytes());
        let texts = |file: &File| {
            let whole = all_rungs(file).into_iter().filter(|rung| !rung.broken);
            whole.map(twinrung_grammar::print_rung).collect::<Vec<_>>()
        };
        assert_eq!(again.errors, vec![], "{}", path.display());
        assert_eq!(texts(&again.file), texts(&reading.file), "{}", path.display());
        assert_eq!(print_file(&again.file), print_file(&reading.file), "{}", path.display());
    }
}

#[test]
fn corpus_when_expressions_are_read_then_none_is_malformed() {
    let mut count = 0;
    for (path, _, reading) in read_all() {
        for rung in all_rungs(&reading.file) {
            for instruction in instructions(&rung.elements) {
                let reads = match instruction.mnemonic.text.as_str() {
                    "XIC" | "XIO" | "OTE" | "OTL" | "OTU" => {
                        instruction.operands.iter().map(|operand| read_tag(operand).err()).collect::<Vec<_>>()
                    }
                    "CMP" | "ADD" | "MOV" => {
                        instruction.operands.iter().map(|operand| read_expression(operand).err()).collect()
                    }
                    _ => Vec::new(),
                };
                let unfinished = |operand: &twinrung_grammar::tree::Operand| operand.is_unassigned();
                let wrong: Vec<_> = reads.into_iter().flatten().collect();
                assert!(
                    wrong.is_empty() || instruction.operands.iter().any(unfinished),
                    "{}: {instruction:?} {wrong:?}",
                    path.display()
                );
                count += 1;
            }
        }
    }
    println!("{count} instructions");
}

fn all_rungs(file: &File) -> Vec<&twinrung_grammar::tree::Rung> {
    let add_ons = file.add_on_instructions.iter().flat_map(|add_on| &add_on.routines);
    let programs = file.programs.iter().flat_map(|program| &program.routines);
    let ladders = add_ons.chain(programs).chain(&file.routines).filter_map(|routine| match &routine.body {
        RoutineBody::Ladder(rungs) => Some(rungs),
        _ => None,
    });
    ladders.flatten().collect()
}

fn instructions(elements: &[Element]) -> Vec<&Instruction> {
    elements.iter().flat_map(instructions_of).collect()
}

fn instructions_of(element: &Element) -> Vec<&Instruction> {
    match element {
        Element::Instruction(instruction) => vec![instruction],
        Element::Branch(branch) => branch.legs.iter().flat_map(|leg| instructions(&leg.elements)).collect(),
    }
}
