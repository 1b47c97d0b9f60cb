//! Both comparisons beside each other: each finds alone whatever differs alone, and neither finds anything else.

use alloc::vec::Vec;

use twinrung_bytecode::channel::{MajorFault, Place, ScanEnd};
use twinrung_bytecode::index::{BitCell, EventTaskIndex, ProgramIndex, RoutineIndex, WordCell};

use crate::compare::{self, Difference, compared};
use crate::holding::{CELLS, Holding, image};
use crate::reciprocal;

type First = Holding<false>;
type Second = Holding<true>;

/// What is changed in a channel.
type Change<C> = fn(&mut C);

const COMPLETED: (ScanEnd, ScanEnd) = (ScanEnd::Completed, ScanEnd::Completed);

/// What the two comparisons find when the second of two equal channels is changed.
fn found(change: impl Fn(&mut Second), ends: (ScanEnd, ScanEnd)) -> (Option<Difference>, [bool; 2]) {
    let (first, mut second) = (First::new(), Second::new());
    change(&mut second);
    let records = image();
    let compared = compared(&records, &first, &second, ends);
    let reciprocal = reciprocal::remainder(&records, &second, &first, ends);
    (compared.difference, [compared.remainder != 0, reciprocal != 0])
}

/// REQ-SCAN-002, REQ-SCAN-013
#[test]
fn channels_when_nothing_differs_then_neither_comparison_finds_anything() {
    assert_eq!(found(|_| {}, COMPLETED), (None, [false; 2]));
}

/// REQ-SCAN-002, REQ-SCAN-013
#[test]
fn channels_when_one_thing_differs_alone_then_both_comparisons_find_it() {
    let changes: [(Change<Second>, Difference); 16] = [
        (|second| second.status.first_scan = true, Difference::Status),
        (|second| second.status.overflow = false, Difference::Status),
        (|second| second.status.zero = true, Difference::Status),
        (|second| second.status.negative = true, Difference::Status),
        (|second| second.status.carry = true, Difference::Status),
        (|second| second.status.minor_fault = true, Difference::Status),
        (|second| second.status.minor_faults ^= 1, Difference::Status),
        (|second| second.status.cleared_faults ^= 1 << 31, Difference::Status),
        (|second| second.status.executed ^= 1 << 63, Difference::Status),
        (|second| second.path ^= 1, Difference::Path),
        (|second| second.events[0] += 1, Difference::Event(EventTaskIndex(0))),
        (|second| second.events[1] += 1, Difference::Event(EventTaskIndex(1))),
        (|second| second.records[0][10] = 0, Difference::FaultRecord(ProgramIndex(0))),
        (|second| second.records[1][0] = 0, Difference::FaultRecord(ProgramIndex(1))),
        (|second| second.bits.truncate(CELLS - 1), Difference::Size),
        (|second| second.words.truncate(CELLS - 1), Difference::Size),
    ];
    let wrong: Vec<_> = changes
        .into_iter()
        .map(|(change, expected)| (found(change, COMPLETED), expected))
        .filter(|(found, expected)| *found != (Some(*expected), [true; 2]))
        .collect();
    assert!(wrong.is_empty(), "{wrong:?}");
}

/// REQ-SCAN-002
#[test]
fn channels_when_they_end_differently_then_both_comparisons_find_it() {
    let place = Place { program: ProgramIndex(0), routine: RoutineIndex(0), rung: 0, element: 0 };
    let fault = ScanEnd::MajorFault(MajorFault { code: 20, place });
    for ends in [(ScanEnd::Completed, fault), (fault, ScanEnd::BudgetExceeded), (ScanEnd::BudgetExceeded, fault)] {
        assert_eq!(found(|_| {}, ends), (Some(Difference::End(ends.0, ends.1)), [true; 2]));
    }
}

/// REQ-SCAN-010
#[test]
fn channels_when_the_budget_cut_off_both_then_their_paths_may_differ() {
    let ends = (ScanEnd::BudgetExceeded, ScanEnd::BudgetExceeded);
    assert_eq!(found(|second| second.path ^= 1, ends), (None, [false; 2]));
}

/// REQ-SCAN-013. Cells that both channels have lost are missing from the image.
#[test]
fn channels_when_both_lack_the_same_cell_then_the_second_comparison_finds_it() {
    let losses: [(Change<First>, Change<Second>); 2] = [
        (|first| first.bits.truncate(CELLS - 1), |second| second.bits.truncate(CELLS - 1)),
        (|first| first.words.truncate(CELLS - 1), |second| second.words.truncate(CELLS - 1)),
    ];
    for (of_first, of_second) in losses {
        let (mut first, mut second) = (First::new(), Second::new());
        of_first(&mut first);
        of_second(&mut second);
        assert_ne!(reciprocal::remainder(&image(), &second, &first, COMPLETED), 0);
    }
}

/// REQ-SCAN-013. Where all cells are alike, nothing but their number shows that one is missing.
#[test]
fn channels_when_one_lacks_a_cell_among_cells_that_are_alike_then_the_second_comparison_finds_it() {
    let (mut first, mut second) = (First::new(), Second::new());
    first.bits.fill(0);
    first.words.fill(0);
    second.bits.fill(u8::MAX);
    second.words.fill(u32::MAX);
    let wrong = |first: &First, second: &Second| reciprocal::remainder(&image(), second, first, COMPLETED) != 0;
    assert!(!wrong(&first, &second));
    let (mut fewer, mut other) = (first.clone(), second.clone());
    fewer.bits.pop();
    other.bits.pop();
    assert!(wrong(&fewer, &second) && wrong(&first, &other), "bits");
    let (mut fewer, mut other) = (first.clone(), second.clone());
    fewer.words.pop();
    other.words.pop();
    assert!(wrong(&fewer, &second) && wrong(&first, &other), "words");
}

/// REQ-SCAN-002, REQ-SCAN-013. Every bit of every cell, alone.
#[test]
fn cells_when_one_bit_differs_then_both_comparisons_say_which_and_the_first_says_where() {
    for (cell, bit) in (0..CELLS).flat_map(|cell| (0..32).map(move |bit| (cell, bit))) {
        let (first, mut second) = (First::new(), Second::new());
        second.words[cell] ^= 1 << bit;
        let (plain, other) = (first.words[cell] as i32, !second.words[cell] as i32);
        let difference = Difference::Word(WordCell(cell as u32), plain, other);
        let records = image();
        let compared = compared(&records, &first, &second, COMPLETED);
        assert_eq!((compared.remainder, compared.difference), (1 << (8 + bit), Some(difference)));
        assert_eq!(reciprocal::remainder(&records, &second, &first, COMPLETED), 1 << (8 + bit));
    }
    for (cell, bit) in (0..CELLS).flat_map(|cell| (0..8).map(move |bit| (cell, bit))) {
        let (first, mut second) = (First::new(), Second::new());
        second.bits[cell] ^= 1 << bit;
        let difference = Difference::Bit(BitCell(cell as u32), first.bits[cell], !second.bits[cell]);
        let records = image();
        let compared = compared(&records, &first, &second, COMPLETED);
        assert_eq!((compared.remainder, compared.difference), (1 << bit, Some(difference)));
        assert_eq!(reciprocal::remainder(&records, &second, &first, COMPLETED), 1 << bit);
    }
}

/// REQ-SCAN-002. Which of the two holds its cells complemented is all the same.
#[test]
fn cells_when_the_primary_is_the_complemented_channel_then_a_difference_is_said_in_plain_values() {
    let (records, first) = (image(), First::new());
    let mut second = Second::new();
    second.words[3] ^= 4;
    let difference = Difference::Word(WordCell(3), !second.words[3] as i32, first.words[3] as i32);
    assert_eq!(compared(&records, &second, &first, COMPLETED).difference, Some(difference));
    second.bits[5] ^= 1;
    let difference = Difference::Bit(BitCell(5), !second.bits[5], first.bits[5]);
    assert_eq!(compared(&records, &second, &first, COMPLETED).difference, Some(difference));
}

/// REQ-SCAN-002. Differences that would cancel each other out in a sum without carry.
#[test]
fn cells_when_two_differ_in_the_same_bit_then_both_comparisons_find_it() {
    for other in 1..CELLS {
        let change = |second: &mut Second| {
            second.words[0] ^= 0x100;
            second.words[other] ^= 0x100;
        };
        assert_eq!(found(change, COMPLETED).1, [true; 2], "words 0 and {other}");
        let change = |second: &mut Second| {
            second.bits[0] ^= 1;
            second.bits[other] ^= 1;
        };
        assert_eq!(found(change, COMPLETED).1, [true; 2], "bits 0 and {other}");
    }
}

/// REQ-SCAN-013. What either says of cells is what a comparison one by one says, whatever the number of cells.
#[test]
fn sums_when_cells_of_any_number_differ_then_both_say_the_bits_of_all_differences() {
    let pattern = |seed: u32, at: usize| (at as u32 + 1).wrapping_mul(seed).rotate_left(at as u32 % 31);
    for length in 0..CELLS {
        let bytes: Vec<u8> = (0..length).map(|at| pattern(0x9E37_79B9, at) as u8).collect();
        let words: Vec<u32> = (0..length).map(|at| pattern(0x85EB_CA6B, at)).collect();
        let other_bytes: Vec<u8> =
            bytes.iter().enumerate().map(|(at, byte)| byte ^ u8::from(at % 40 == 1) << (at % 8)).collect();
        let other_words: Vec<u32> =
            words.iter().enumerate().map(|(at, word)| word ^ u32::from(at % 33 == 2) << (at % 32)).collect();
        let bits = bytes.iter().zip(&other_bytes).fold(0, |all, (a, b)| all | u64::from(a ^ b));
        let all = words.iter().zip(&other_words).fold(bits, |all, (a, b)| all | u64::from(a ^ b) << 8);
        for mask in [0, u32::MAX] {
            let held: (Vec<u8>, Vec<u32>) = (
                other_bytes.iter().map(|byte| byte ^ mask as u8).collect(),
                other_words.iter().map(|word| word ^ mask).collect(),
            );
            let of = |sum: crate::self_test::Cells| sum((&bytes, &held.0), (&words, &held.1), mask);
            assert_eq!([of(compare::sum), of(reciprocal::sum)], [all; 2], "{length} cells, mask {mask:x}");
        }
    }
}
