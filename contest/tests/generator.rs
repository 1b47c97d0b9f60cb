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
