//! What the generator of random programs promises.

use twinrung_catalog::Opcode;
use twinrung_contest::fuzz::Subject;
use twinrung_contest::generate::{self, Size};
use twinrung_grammar::tree::Sources;
use twinrung_grammar::{print_file_checked, read};

#[test]
fn generator_when_asked_for_many_programs_then_every_base_instruction_occurs() {
    let texts: Vec<String> = (0..60).map(|seed| generate::program(seed, Size::LARGE).text).collect();
    let base = Opcode::ALL.iter().map(|opcode| opcode.instruction()).filter(|one| !one.group.is_safety_library());
    let missing: Vec<&str> = base
        .map(|one| one.mnemonic)
        .filter(|mnemonic| !texts.iter().any(|text| text.contains(&format!("{mnemonic}("))))
        .collect();
    assert_eq!(missing, Vec::<&str>::new());
}

/// What mistakes hide behind, and what random choices alone would come upon once in ten thousand programs.
#[test]
fn generator_when_asked_for_many_programs_then_what_is_rare_by_itself_occurs_often() {
    let texts: Vec<String> = (0..600).map(|seed| generate::program(seed, Size::SMALL).text).collect();
    let rungs: Vec<&str> = texts.iter().flat_map(|text| text.lines()).filter(|line| line.contains(" N: ")).collect();
    let writes_negative = |member: &str| {
        let end = format!(".{member})");
        move |rung: &&&str| {
            let mut writes = rung.split("MOV(-").skip(1).filter_map(|rest| rest.split_inclusive(')').next());
            writes.any(|operands| operands.ends_with(&end))
        }
    };
    let switches_what_it_asks = |rung: &&&str| {
        let mut asked = rung.split("XIC(").skip(1).filter_map(|rest| rest.split_once(')'));
        asked.any(|(bit, behind)| behind.contains(&format!("OTE({bit})")))
    };
    let sets_its_position = |rung: &&&str| {
        let mut set = rung.split("MOV(-").skip(1).filter_map(|rest| rest.split_once(".POS)"));
        set.any(|(_, behind)| behind.starts_with("FAL(") || behind.starts_with("FSC("))
    };
    let masks_an_overflow = |rung: &&&str| rung.contains(" AND (");
    let jumps_to_the_limit = |rung: &&&str| rung.contains(",1001)JMP(") || rung.contains(",1002)JMP(");
    let count = |holds: &dyn Fn(&&&str) -> bool| rungs.iter().filter(|rung| holds(rung)).count();
    for (what, found) in [
        ("a negative preset", count(&writes_negative("PRE"))),
        ("a negative position", count(&writes_negative("POS"))),
        ("a negative position of what follows", count(&sets_its_position)),
        ("a negative length", count(&writes_negative("LEN"))),
        ("a rung that switches what it asks", count(&switches_what_it_asks)),
        ("a subscript that overflows and is in range", count(&masks_an_overflow)),
        ("a loop that ends at the limit of jumps back", count(&jumps_to_the_limit)),
    ] {
        assert!(found >= 2, "{what}: {found} in {} rungs", rungs.len());
    }
}

#[test]
fn generator_when_given_one_seed_twice_then_program_and_stimulus_are_the_same() {
    let (first, second) = (generate::program(7, Size::SMALL), generate::program(7, Size::SMALL));
    assert_eq!(first, second);
    assert_eq!(format!("{:?}", generate::stimulus(7, &first, 20)), format!("{:?}", generate::stimulus(7, &second, 20)));
}

/// REQ-LANG-030
#[test]
fn generated_programs_when_printed_then_their_text_reads_as_what_it_was_printed_from() {
    let texts = (0..60).map(|seed| generate::program(seed, Size::LARGE).text);
    let readings = texts.map(|text| read(&mut Sources::new(), "generated.rll", text.into_bytes()));
    let wrong: Vec<_> = readings
        .filter_map(|reading| {
            reading
                .errors
                .first()
                .cloned()
                .map(|error| error.message)
                .or_else(|| print_file_checked(&reading.file).err().map(|why| why.to_string()))
        })
        .collect();
    assert!(wrong.is_empty(), "{wrong:#?}");
}

#[test]
fn generated_programs_when_compiled_then_no_rule_refuses_one() {
    let wrong: Vec<String> = (0..1500)
        .map(|seed| generate::program(seed, Size::SMALL).text)
        .filter_map(|text| {
            let why = Subject::from_text(&text).err()?;
            let line: usize = why[0].split([' ', ':']).nth(1)?.parse().ok()?;
            Some(format!("{why:?} in {}", text.lines().nth(line - 1)?))
        })
        .collect();
    assert!(wrong.is_empty(), "{wrong:#?}");
}
