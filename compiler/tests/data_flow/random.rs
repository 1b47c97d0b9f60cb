//! Soundness on random programs: where standard data alone can be seen to switch the output, the analysis reports it.

use crate::programs::{Dice, MOTOR, Program};
use crate::three_valued::standard_data_alone_decides;
use crate::{findings, text};

const PROGRAMS: u64 = 3_000;

/// What came out of the programs.
#[derive(Debug, Default)]
struct Count {
    decided: usize,
    reported: usize,
    silent: usize,
    missed: Vec<String>,
}

fn source(program: &Program) -> String {
    let (main, part) = program.text();
    let gate = if program.logic.is_empty() { "" } else { "\n    G : Gate (Class := Safety);" };
    let set: String = program
        .set
        .iter()
        .map(|bit| format!("    {} : BOOL (Class := Safety) := 1;\n", crate::programs::NAMES[*bit]))
        .collect();
    let text = text(
        &program.definition(),
        &format!("    Once, Given, Taken, Turn : BOOL (Class := Safety);{gate}"),
        &main,
        &part,
    );
    // Bits that begin with 1 are declared apart.
    let rest: Vec<&str> = ["A", "B"].into_iter().filter(|name| !set.contains(&format!("    {name} :"))).collect();
    let names: Vec<&str> = rest.into_iter().chain(["C", "D", "Edge"]).collect();
    text.replace(
        "    A, B, C, D, Edge : BOOL (Class := Safety);\n",
        &format!("{set}    {} : BOOL (Class := Safety);\n", names.join(", ")),
    )
}

fn judge(seed: u64, count: &mut Count) {
    let program = Dice::new(seed).program();
    let text = source(&program);
    let found = findings(&text);
    let reported = found.iter().any(|line| line.starts_with("S0701"));
    let faulty = found.iter().any(|line| !line.starts_with("S0701"));
    assert!(!faulty, "seed {seed}: {found:?}\n{text}");
    let decided = standard_data_alone_decides(&program, MOTOR);
    count.decided += usize::from(decided);
    count.reported += usize::from(reported);
    count.silent += usize::from(!reported);
    if decided && !reported {
        let (main, part) = program.text();
        count.missed.push(format!("seed {seed}, set {:?}\n{main}{part}{}", program.set, program.definition()));
    }
}

/// REQ-CHECK-012
#[test]
fn random_programs_when_standard_data_alone_switches_the_output_then_the_analysis_reports_it() {
    let mut count = Count::default();
    (1..=PROGRAMS).for_each(|seed| judge(seed, &mut count));
    let Count { decided, reported, silent, missed } = count;
    println!("{decided} decided, {reported} reported, {silent} silent, {} missed", missed.len());
    assert!(missed.is_empty(), "{} missed:\n{}", missed.len(), missed[..missed.len().min(5)].join("\n"));
    assert!(decided > 200 && silent > 200, "too few of a kind: {decided} decided, {silent} silent");
}
