//! Random valid programs over the whole instruction set run on primary, partner and judge, compared after every scan.
//!
//! `TWINRUNG_PROGRAMS=1000 cargo test -p twinrung-conformance random` runs so many. A longer run: `cargo run --release
//! --features judge -- fuzz --time 1h`.

use twinrung_contest::fuzz::Campaign;
use twinrung_contest::generate::Size;
use twinrung_trio::Trios;

/// Programs where `TWINRUNG_PROGRAMS` does not say how many.
const PROGRAMS: u64 = 300;

#[test]
fn evaluators_when_random_programs_run_60_scans_then_they_agree_in_every_value() {
    let asked = std::env::var("TWINRUNG_PROGRAMS").ok().and_then(|programs| programs.parse().ok());
    let mut campaign = Campaign::default();
    // The first program on which they differ is made small, which takes longer than all the others: one is enough.
    (0..asked.unwrap_or(PROGRAMS))
        .take_while(|seed| {
            campaign.run::<Trios>(*seed, Size::SMALL, 60);
            campaign.failures.is_empty()
        })
        .for_each(drop);
    println!("{campaign}");
    assert!(campaign.failures.is_empty(), "{campaign}\n{}", campaign.failures_shown());
    assert!(campaign.refused * 20 < campaign.programs, "more than 5 % are refused: {:?}", campaign.reasons);
    assert!(campaign.total.faulted * 2 < campaign.total.scans, "faults end most scans: {campaign}");
}
