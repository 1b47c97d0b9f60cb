//! A program and its inputs, chosen by the bytes, on both channels; what libFuzzer guides itself by is the coverage of their
//! code, beside what `twinrung fuzz` is guided by. The judge takes no part: it would take most of the time.
#![no_main]

use libfuzzer_sys::fuzz_target;
use twinrung_partner::Partner;
use twinrung_primary::Primary;
use twinrung_workbench::fuzz::{Pairs, Ran, ran};
use twinrung_workbench::generate::{Genome, Size};

/// Choices of a rung or a step that libFuzzer gives; the rest follows from a seed that they make.
const GENE: usize = 24;
/// Scans of a program: long enough for a timer and a subroutine.
const SCANS: usize = 40;

fuzz_target!(|data: &[u8]| {
    let (program, inputs) = data.split_at(data.len() / 2);
    let genes = |bytes: &[u8]| bytes.chunks(GENE).map(<[u8]>::to_vec).collect();
    let genome = Genome { program: genes(program), inputs: genes(inputs), seed: 0 };
    if let Ran::Failed(mut failure) = ran::<Pairs<Primary, Partner>>(0, &genome, Size::TINY, SCANS) {
        failure.shrink::<Pairs<Primary, Partner>>();
        panic!("{failure}");
    }
});
