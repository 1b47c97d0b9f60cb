//! The canonical text of a routine says what its code says: read again, it gives the same image.

mod support;

use support::{lines, read};
use twinrung_compiler::{Completion, check, compile};
use twinrung_grammar::tree::{RoutineBody, Sources};

fn samples() -> Vec<(String, String)> {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../samples");
    let mut list: Vec<(String, String)> = std::fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().path().join("project.rll"))
        .filter(|path| path.exists())
        .map(|path| (path.display().to_string(), std::fs::read_to_string(&path).unwrap()))
        .collect();
    list.sort();
    list
}

/// Compiles a text; then compiles it again with every routine replaced by its canonical text.
fn survives(name: &str, text: &str) {
    let mut sources = Sources::new();
    let mut reading = read(&mut sources, name, text);
    let checked = check(&reading, &Completion::default());
    let shown = lines(&sources, &checked);
    let first = compile(&checked.project.unwrap_or_else(|| panic!("{name}:\n{shown}"))).unwrap();
    let image = twinrung_bytecode::admit(&first.bytes).unwrap_or_else(|error| panic!("{name}: {error}"));
    let texts: Vec<(String, String)> = image
        .image()
        .routines
        .iter()
        .enumerate()
        .map(|(at, routine)| {
            let owner =
                twinrung_bytecode::text::routine_name(image.image(), twinrung_bytecode::index::RoutineIndex(at as u32));
            (owner, routine.text.clone())
        })
        .collect();
    let mut again = |owner: &str, routine: &mut twinrung_grammar::tree::Routine| {
        let Some((_, text)) =
            texts.iter().find(|(name, _)| name.eq_ignore_ascii_case(&format!("{owner}/{}", routine.name)))
        else {
            return;
        };
        let wrapped: String = text.lines().map(|rung| format!("N: {rung}\n")).collect();
        let parsed = read(&mut sources, "canonical.rll", &format!("ROUTINE {}\n{wrapped}END_ROUTINE\n", routine.name));
        assert!(parsed.errors.is_empty(), "{name}: {:?}\n{text}", parsed.errors);
        let body = parsed.file.routines.into_iter().next().map(|routine| routine.body);
        routine.body = body.unwrap_or(RoutineBody::Ladder(Vec::new()));
    };
    for program in &mut reading.file.programs {
        let owner = program.name.text.clone();
        program.routines.iter_mut().for_each(|routine| again(&owner, routine));
    }
    for add_on in &mut reading.file.add_on_instructions {
        let owner = add_on.name.text.clone();
        add_on.routines.iter_mut().for_each(|routine| again(&owner, routine));
    }
    let checked = check(&reading, &Completion::default());
    let shown = lines(&sources, &checked);
    let second =
        compile(&checked.project.unwrap_or_else(|| panic!("{name} from its canonical text:\n{shown}"))).unwrap();
    assert!(first.bytes == second.bytes, "{name}: another image from the canonical text");
}

#[test]
fn canonical_text_when_read_again_then_the_same_image() {
    for (name, text) in samples() {
        survives(&name, &text);
    }
}

#[test]
fn canonical_text_when_of_expressions_and_subscripts_then_the_same_image() {
    let rungs = "CMP((A-(B-C))>-1)OTE(X)
CPT(A,(A+B)*C/(A-1))
CPT(A,NOT A AND B OR C XOR (A OR B))
CPT(A,-(-A)- -3)
CPT(A,ABS(-A)*SQR(B MOD 7))
MOV(V[A+V[B-1,0],C*2],A)
XIC(A.[B AND 7])OTE(X)
CMP((A=B) AND (B<>C))OTE(X)
CPT(R,R*1.0e-3+2)
CPT(A,-(2#1010)*B- -(16#8000_0000))
CPT(R,R*-(1.5))
SIZE(V,1,A)";
    let text = support::project(
        "",
        "    A, B, C : DINT (Class := Safety);\n    R : REAL (Class := Safety);\n    X : BOOL (Class := Safety);\n    V : DINT[8,4] (Class := Safety);",
        rungs,
        "",
    );
    survives("expressions", &text);
}
