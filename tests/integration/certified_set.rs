//! The certified set of safety application instructions, and for each: catalog entry, primary half, partner half, vectors,
//! codes. `-- --nocapture` prints the table; a gap fails.

use std::fmt::Write as _;

use twinrung_bytecode::channel::{Channel, ScanEnd, ScanInputs};
use twinrung_bytecode::observer::Silent;
use twinrung_catalog::{Instruction, Opcode};
use twinrung_partner::Partner;
use twinrung_primary::Primary;
use twinrung_safety_vectors::{Coverage, Vector, coverage, normal_operation};
use twinrung_trio::Subject;
use twinrung_workbench::{Signal, Value, cells, names};

use crate::vectors::{configuration, driven_operands, expected_members, program, same};

/// 1756-RM093 Tables 10 and 11, the metal-form set and the version-14 set that Appendix F names.
const CERTIFIED: &[(&str, &[&str])] = &[
    ("1756-RM093 Table 10", &["DCA", "DCAF"]),
    (
        "1756-RM093 Table 11",
        &["CROUT", "DCS", "DCST", "DCSTL", "DCSTM", "DCM", "DCSRT", "SMAT", "THRSe", "TSAM", "TSSM", "FSBM"],
    ),
    ("1756-RM093 Table 11b", &["CBCM", "CBIM", "CBSSM", "CPM", "CSM", "EPMS", "AVC", "MVC", "MMVC"]),
    ("1756-RM093 Appendix F", &["DIN", "RIN", "ENPEND", "ESTOP", "LC", "FPMS", "THRS", "ROUT"]),
];

/// One row of the list.
struct Row {
    source: &'static str,
    mnemonic: &'static str,
    catalog: Option<&'static Instruction>,
    primary: Result<u32, String>,
    partner: Result<u32, String>,
    coverage: Option<Coverage>,
}

impl Row {
    fn of(source: &'static str, mnemonic: &'static str) -> Row {
        let catalog = Instruction::by_mnemonic(mnemonic).filter(|one| one.source == source && one.safety.is_some());
        let missing = || Err("no vector of normal operation".to_owned());
        let normal = catalog.and_then(|one| normal_operation(one.opcode).ok().flatten());
        let half = |run: fn(&Vector) -> Result<u32, String>| normal.as_ref().map_or_else(missing, run);
        Row {
            source,
            mnemonic,
            catalog,
            primary: half(scans_alone::<Primary>),
            partner: half(scans_alone::<Partner>),
            coverage: catalog.and_then(|one| coverage(one.opcode).ok()),
        }
    }

    fn is_complete(&self) -> bool {
        let covered = self.coverage.as_ref().is_some_and(|found| found.vectors > 0 && found.missing.is_empty());
        self.catalog.is_some() && self.primary.is_ok() && self.partner.is_ok() && covered
    }

    fn line(&self) -> String {
        let scans =
            |run: &Result<u32, String>| run.as_ref().map_or_else(Clone::clone, |scans| format!("{scans} scans"));
        let (vectors, codes) = self.coverage.as_ref().map_or(("none".to_owned(), "none".to_owned()), |found| {
            let declared = found.reached.len() + found.missing.len();
            (found.vectors.to_string(), format!("{}/{declared}", found.reached.len()))
        });
        let opcode = self.catalog.map_or("missing".to_owned(), |one| format!("opcode {}", one.opcode as u8));
        format!(
            "{:<7} {:<22} {opcode:<10} {:<10} {:<10} {vectors:>7} {codes:>7}",
            self.mnemonic,
            self.source.trim_start_matches("1756-RM093 "),
            scans(&self.primary),
            scans(&self.partner),
        )
    }
}

/// What a member holds, as its vector writes it.
fn value<C: Channel>(channel: &C, signal: Signal) -> Value {
    let held = cells::read(channel, signal);
    match signal {
        Signal::Word(_, element) => crate::vectors::value(element, held),
        _ => Value::Bool(held == 1),
    }
}

/// Runs a vector on one channel alone, with the half of the library that belongs to it; how many scans gave what is expected.
fn scans_alone<C: Channel>(vector: &Vector) -> Result<u32, String> {
    let instruction = vector.opcode.instruction();
    let subject =
        Subject::from_text(&program(instruction, &configuration(vector))).map_err(|found| found.join("; "))?;
    let signal = |name: &str| names::signal(&subject.image, name).map_err(|error| error.to_string());
    let mut channel = C::load(&subject.image).map_err(|error| error.to_string())?;
    let mut replay = vector.replay(vector.periods_ms[0]);
    let mut scans = 0;
    while let Some(scan) = replay.next_scan() {
        for (name, _, place) in driven_operands(instruction) {
            cells::write(&mut channel, signal(&name)?, replay.operands()[place]);
        }
        cells::write(&mut channel, signal("Rung")?, i32::from(scan.rung));
        let inputs = ScanInputs { now_ms: scan.now_ms, budget: u64::MAX, system_values: &[] };
        if scan.prescan && channel.prescan(inputs, &mut Silent) != ScanEnd::Completed {
            return Err("the prescan does not end".to_owned());
        }
        if channel.scan(inputs, &mut Silent) != ScanEnd::Completed {
            return Err(format!("the scan at {} ms does not end", scan.now_ms));
        }
        for (name, expected) in expected_members(instruction, &replay) {
            let found = value(&channel, signal(&name)?);
            if !same(expected, found) {
                return Err(format!("at {} ms {name} is {found:?}, expected {expected:?}", scan.now_ms));
            }
        }
        scans += 1;
    }
    Ok(scans)
}

#[test]
fn certified_set_when_listed_then_every_instruction_has_catalog_both_halves_vectors_and_all_codes_reached() {
    let rows: Vec<Row> = CERTIFIED
        .iter()
        .flat_map(|(source, mnemonics)| mnemonics.iter().map(|mnemonic| Row::of(source, mnemonic)))
        .collect();
    let mut table = String::from("        source                 catalog    primary    partner    vectors   codes\n");
    for row in &rows {
        let _ = writeln!(table, "{}", row.line());
    }
    println!("{table}");
    assert_eq!(rows.len(), 31);
    let gaps: Vec<String> = rows.iter().filter(|row| !row.is_complete()).map(Row::line).collect();
    assert!(gaps.is_empty(), "{gaps:#?}");
}

#[test]
fn catalog_when_compared_with_the_certified_set_then_no_other_safety_application_is_declared() {
    let listed: Vec<&str> = CERTIFIED.iter().flat_map(|(_, mnemonics)| mnemonics.iter().copied()).collect();
    let unlisted: Vec<&str> = Opcode::ALL
        .iter()
        .map(|opcode| opcode.instruction())
        .filter(|one| one.safety.is_some() && !listed.contains(&one.mnemonic))
        .map(|one| one.mnemonic)
        .collect();
    assert_eq!(unlisted, Vec::<&str>::new());
}
