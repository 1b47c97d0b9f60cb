//! Random valid programs over the whole instruction set run on primary, partner and judge, compared after every scan.
//!
//! A longer run: `cargo run --release --features judge -- fuzz --time 1h`.

use twinrung_catalog::Opcode;
use twinrung_grammar::tree::Sources;
use twinrung_grammar::{print_file_checked, read};
use twinrung_trio::Trios;
use twinrung_workbench::fuzz::Campaign;
use twinrung_workbench::generate::{self, Size};

#[test]
fn evaluators_when_300_random_programs_run_60_scans_then_they_agree_in_every_value() {
    let mut campaign = Campaign::default();
    (0..300).for_each(|seed| campaign.run::<Trios>(seed, Size::SMALL, 60));
    println!("{campaign}");
    assert!(campaign.failures.is_empty(), "{campaign}\n{}", campaign.failures_shown());
    assert!(campaign.refused * 20 < campaign.programs, "more than 5 % are refused: {:?}", campaign.reasons);
    assert!(campaign.total.faulted * 2 < campaign.total.scans, "faults end most scans: {campaign}");
}

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
