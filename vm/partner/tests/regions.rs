//! Regions of panels against the walk that an observer forces: the same program, the same state after every scan.

mod support;

use support::Rig;
use support::random::{Numbers, program};
use twinrung_bytecode::channel::Channel;

fn agree(seed: u64, rungs: usize, scans: usize, zones: bool) {
    let text = program(seed, rungs, zones);
    let (mut fast, mut walked) = (Rig::new(&text), Rig::new(&text).watched());
    let mut numbers = Numbers(seed | 1);
    let mut now = 0;
    assert_eq!(fast.prescan(now), walked.prescan(now));
    for scan in 0..scans {
        now += numbers.below(30) as i64;
        for _ in 0..8 {
            let (name, value) = (format!("x[{}]", numbers.below(32)), numbers.below(2) as i32);
            fast.set(&name, value);
            walked.set(&name, value);
        }
        let ends = (fast.scan(now), walked.scan(now));
        assert_eq!(ends.0, ends.1, "seed {seed} scan {scan}");
        assert_eq!(fast.status(), walked.status(), "seed {seed} scan {scan}\n{text}");
        assert!(fast.partner.bits() == walked.partner.bits(), "bits: seed {seed} scan {scan}\n{text}");
        assert!(fast.partner.words() == walked.partner.words(), "words: seed {seed} scan {scan}\n{text}");
        assert_eq!(fast.record(), walked.record());
    }
}

#[test]
fn regions_when_small_random_programs_then_same_state_as_the_walk() {
    for seed in 1..300 {
        agree(seed, 6, 12, false);
    }
}

#[test]
fn regions_when_long_random_programs_then_same_state_as_the_walk() {
    for seed in 1000..1030 {
        agree(seed, 200, 20, false);
    }
}

#[test]
fn regions_when_zones_switch_rungs_off_then_same_state_as_the_walk() {
    for seed in 2000..2100 {
        agree(seed, 48, 15, true);
    }
}
