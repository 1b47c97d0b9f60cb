//! Reads files and prints what was found in them.

use std::path::Path;

use twinrung_grammar::tree::Sources;

fn main() {
    for path in std::env::args().skip(1) {
        if let Some(path) = path.strip_prefix("--print=") {
            let reading = twinrung_grammar::read_path(&mut Sources::new(), Path::new(path));
            print!("{}", twinrung_grammar::print_file(&reading.file));
            continue;
        }
        let mut sources = Sources::new();
        let start = std::time::Instant::now();
        let reading = twinrung_grammar::read_path(&mut sources, Path::new(&path));
        let took = start.elapsed();
        let file = &reading.file;
        let rungs: usize = file.programs.iter().flat_map(|p| &p.routines).map(|r| r.rungs().len()).sum();
        println!(
            "{path}: {took:?}; {} types, {} modules, {} add-ons, {} tags, {} programs, {rungs} rungs, {} tasks, {} errors",
            file.data_types.len(),
            file.modules.len(),
            file.add_on_instructions.len(),
            file.tags.len(),
            file.programs.len(),
            file.tasks.len(),
            reading.errors.len()
        );
        for error in &reading.errors {
            let place = sources.line_column(error.span);
            println!("  {}:{}: {} {}", place.line, place.column, error.kind.name(), error.message);
        }
    }
}
