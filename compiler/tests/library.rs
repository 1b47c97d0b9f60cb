//! Libraries of Add-On Instructions.

use std::path::Path;

use twinrung_compiler::compile_library;

/// The partner's half of the safety library, as its build script reads it.
fn partner() -> Vec<(String, String)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../stdlib-safety/partner/rll");
    let mut files: Vec<(String, String)> = std::fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .map(|path| (path.file_name().unwrap().to_string_lossy().into_owned(), std::fs::read_to_string(&path).unwrap()))
        .collect();
    files.sort();
    files
}

#[test]
fn library_when_the_partners_ladder_is_compiled_then_the_loader_reads_it() {
    let files = partner();
    let sources: Vec<(&str, &str)> = files.iter().map(|(name, text)| (name.as_str(), text.as_str())).collect();
    let bytes = compile_library(&sources).unwrap_or_else(|error| panic!("{error}"));
    let read = twinrung_bytecode::read(&bytes).unwrap();
    assert!(read.image.task.is_none());
    assert!(read.image.add_ons.iter().any(|add_on| add_on.name == "Safety_DCS"));
}

#[test]
fn library_when_a_file_is_faulty_then_the_error_names_file_line_and_code() {
    let text = "ADD_ON_INSTRUCTION_DEFINITION Broken (Class := Safety)\n  PARAMETERS\n    In : BOOL (Usage := Input);\n  END_PARAMETERS\n  ROUTINE Logic\n    N: XIC(Inn)NOP();\n  END_ROUTINE\nEND_ADD_ON_INSTRUCTION_DEFINITION\n";
    let error = compile_library(&[("broken.rll", text)]).unwrap_err().to_string();
    assert!(error.starts_with("broken.rll:6:12: E0201"), "{error}");
}
