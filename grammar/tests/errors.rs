//! Text in, errors out: each `errors/NAME.rll` (or `.L5X`) gives exactly the lines of `errors/NAME.txt`.
//! `BLESS=1 cargo test -p twinrung-grammar --test errors` writes what is given now.

use std::path::Path;

use twinrung_grammar::read;
use twinrung_grammar::tree::Sources;

/// Errors as an engineer would see them, then what was read in spite of them.
fn given(path: &Path) -> String {
    let mut sources = Sources::new();
    let reading = read(&mut sources, "sample", std::fs::read(path).unwrap());
    let mut out = String::new();
    for error in &reading.errors {
        let place = sources.line_column(error.span);
        let text = sources.text(error.span).escape_debug().take(60).collect::<String>();
        out += &format!("{}:{} {}: {error} | {text}\n", place.line, place.column, error.kind.name());
        out += &error.help.iter().map(|help| format!("    help: {help}\n")).collect::<String>();
    }
    let file = &reading.file;
    let tags = file.tags.iter().chain(file.programs.iter().flat_map(|program| &program.tags));
    let names: Vec<&str> = tags.map(|tag| tag.name.as_str()).collect();
    let routines = file.programs.iter().flat_map(|program| &program.routines).chain(&file.routines);
    let rungs: Vec<String> = routines.flat_map(|routine| routine.rungs()).map(twinrung_grammar::print_rung).collect();
    out += &format!("tags: {}\n", names.join(" "));
    out + &rungs.iter().map(|rung| format!("rung: {rung}\n")).collect::<String>()
}

/// REQ-LANG-002
#[test]
fn text_when_wrong_then_errors_are_those_written_down() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/errors");
    let mut inputs: Vec<_> = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    inputs.retain(|path| path.extension().is_some_and(|extension| extension != "txt"));
    inputs.sort();
    let bless = std::env::var_os("BLESS").is_some();
    for path in inputs {
        let expected = path.with_extension("txt");
        let given = given(&path);
        bless.then(|| std::fs::write(&expected, &given).unwrap());
        assert_eq!(given, std::fs::read_to_string(&expected).unwrap(), "{}", path.display());
    }
}
