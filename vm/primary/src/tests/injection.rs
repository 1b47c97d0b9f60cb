//! Bits turned round: each is reached, each goes back, and whatever they are an execution ends and does not panic.

extern crate std;

use alloc::vec::Vec;

use twinrung_bytecode::channel::{Channel, ScanEnd, ScanInputs, Status};
use twinrung_bytecode::injection::{Flip, Injectable, Memory};
use twinrung_bytecode::observer::Silent;
use twinrung_catalog::Opcode;
use twinrung_safety_primary::State;

use super::assembler::Assembler;
use super::random::{Random, program};
use super::rig::{Recorder, Rig};
use crate::Primary;
use crate::machine::Slot;
use crate::number::Number;

const BUDGET: u64 = 3000;

/// Random programs to disturb, from one place in the sequence.
fn programs(first: u64) -> impl Iterator<Item = Rig> {
    let count = std::env::var("PROGRAMS").ok().and_then(|count| count.parse().ok()).unwrap_or(100);
    (first..first + count).map(program)
}

fn scan(primary: &mut Primary, now_ms: i64, observed: bool) -> ScanEnd {
    let inputs = ScanInputs { now_ms, budget: BUDGET, system_values: &[1, 2, 3] };
    match observed {
        true => primary.scan(inputs, &mut Recorder::default()),
        false => primary.scan(inputs, &mut Silent),
    }
}

fn prescan(primary: &mut Primary) -> ScanEnd {
    primary.prescan(ScanInputs { now_ms: 0, budget: BUDGET, system_values: &[1, 2, 3] }, &mut Silent)
}

/// What an execution shows.
fn shown(primary: &Primary) -> (Vec<u8>, Vec<u32>, Status, u32) {
    (primary.bits().to_vec(), primary.words().to_vec(), primary.status(), primary.path_signature())
}

#[test]
fn bit_when_turned_twice_then_is_as_before() {
    let mut primary = program(3).silent;
    prescan(&mut primary);
    for memory in Memory::ALL {
        let bits = primary.memory_bits(memory);
        assert!(bits > 0);
        let mut done = 0;
        for bit in (0..bits).step_by(5) {
            let before = primary.read_bit(memory, bit);
            let flip = primary.flip_bit(memory, bit);
            let after = primary.read_bit(memory, bit);
            assert_eq!(flip == Flip::Done, before != after, "{memory:?} {bit}");
            if flip == Flip::Done {
                // The other way there is always: that value was held before.
                assert_eq!(primary.flip_bit(memory, bit), Flip::Done, "{memory:?} {bit}");
                assert_eq!(primary.read_bit(memory, bit), before);
                done += 1;
            }
        }
        assert!(done > bits / 5 / 4, "{memory:?}: {done} of {bits}");
        assert_eq!(primary.flip_bit(memory, bits), Flip::OutOfRange);
        assert_eq!(primary.memory_bits(memory), bits, "the places stay");
    }
}

#[test]
fn cells_when_listed_then_are_all_bits_of_the_bytes_and_words() {
    let mut primary = Rig::new("a b BOOL; i DINT", &["XIC(a)OTE(b)", "MOV(i,i)"]).silent;
    assert_eq!(primary.memory_bits(Memory::Cells), 2 * 8 + 32);
    assert_eq!(primary.flip_bit(Memory::Cells, 9), Flip::Done);
    assert_eq!(primary.flip_bit(Memory::Cells, 16 + 31), Flip::Done);
    assert_eq!((primary.bits(), primary.words()), ([0, 2].as_slice(), [1 << 31].as_slice()));
    scan(&mut primary, 0, false);
    assert_eq!(primary.bits(), [0, 0]);
}

#[test]
fn program_when_a_gate_is_turned_round_then_another_value_comes_out() {
    let rig = Rig::new("a b BOOL", &["XIC(a)OTE(b)"]);
    let bits = rig.silent.clone().memory_bits(Memory::Program);
    let differs = |bit: &u64| {
        let mut disturbed = rig.silent.clone();
        disturbed.flip_bit(Memory::Program, *bit);
        scan(&mut disturbed, 0, false);
        disturbed.bits() != [0, 0]
    };
    assert!((0..bits).filter(differs).count() > 3);
}

#[test]
fn library_memory_when_a_bit_is_turned_twice_then_is_as_before() {
    let known = Opcode::ALL.iter().filter_map(|opcode| Some((opcode, State::new(*opcode)?)));
    for (opcode, state) in known {
        let mut turned = state.clone();
        for bit in 0..state.bits() {
            let flips = turned.flip(bit);
            assert_eq!(flips, turned != state, "{opcode:?} {bit}");
            assert_eq!(flips, turned.bit(bit) != state.bit(bit), "{opcode:?} {bit}");
            assert_eq!(turned.bits(), state.bits());
            // Where a value disappeared only a new one comes back.
            turned = state.clone();
        }
        assert!(!turned.flip(state.bits()), "{opcode:?}");
    }
}

/// Turns random bits of random programs round and runs them; gives how many executions ended in which way.
fn disturb(first: u64, bits_at_once: u64, memories: &[Memory]) -> [u32; 3] {
    let mut random = Random(first | 1);
    let mut ends = [0u32; 3];
    for rig in programs(first) {
        let mut whole = rig.silent;
        prescan(&mut whole);
        scan(&mut whole, 10, false);
        for round in 0..100 {
            let mut disturbed = whole.clone();
            for _ in 0..=random.below(bits_at_once) {
                let memory = memories[random.below(memories.len() as u64) as usize];
                let bits = disturbed.memory_bits(memory);
                disturbed.flip_bit(memory, random.below(bits));
            }
            let observed = round % 3 == 0;
            for time in [20, 30] {
                let end = scan(&mut disturbed, time, observed);
                ends[match end {
                    ScanEnd::Completed => 0,
                    ScanEnd::MajorFault(_) => 1,
                    ScanEnd::BudgetExceeded => 2,
                }] += 1;
            }
            if round % 10 == 0 {
                prescan(&mut disturbed);
                disturbed.reset();
                scan(&mut disturbed, 40, observed);
            }
        }
    }
    ends
}

#[test]
fn execution_when_one_bit_of_the_program_is_turned_round_then_ends() {
    let [completed, faulted, exceeded] = disturb(1000, 1, &[Memory::Program]);
    assert!(completed > 1000 && faulted > 100 && exceeded > 0, "{completed} {faulted} {exceeded}");
}

#[test]
fn execution_when_many_bits_of_the_program_are_turned_round_then_ends() {
    let [completed, faulted, _] = disturb(2000, 200, &[Memory::Program]);
    assert!(completed > 1000 && faulted > 1000, "{completed} {faulted}");
}

#[test]
fn execution_when_bits_of_everything_are_turned_round_then_ends() {
    let [completed, faulted, _] = disturb(3000, 20, &Memory::ALL);
    assert!(completed > 1000 && faulted > 100, "{completed} {faulted}");
}

#[test]
fn loop_when_its_jump_is_no_longer_told_to_be_backward_then_the_budget_ends_it() {
    let mut primary = Rig::new("i DINT", &["LBL(top)ADD(i,1,i)", "JMP(top)"]).silent;
    primary.program.jumps[0].backward = false;
    assert_eq!(scan(&mut primary, 0, false), ScanEnd::BudgetExceeded);
    assert_eq!(scan(&mut primary, 10, true), ScanEnd::BudgetExceeded);
}

#[test]
fn budget_when_the_count_of_executed_instructions_is_at_its_end_then_still_ends_a_loop() {
    let mut primary = Rig::new("i DINT", &["LBL(top)ADD(i,1,i)", "JMP(top)"]).silent;
    primary.machine.status.executed = u64::MAX - 1;
    let budget = ScanInputs { now_ms: 0, budget: 100, system_values: &[] };
    assert_eq!(primary.scan(budget, &mut Silent), ScanEnd::BudgetExceeded);
    assert_eq!(primary.status().executed, u64::MAX);
}

#[test]
fn calls_when_each_calls_the_next_many_times_then_end_when_they_have_run_away() {
    let mut assembler = Assembler::new();
    assembler.tags("a BOOL");
    assembler.routine("R0", &["NOP()"]);
    let names = ["R0", "R1", "R2", "R3", "R4", "R5", "R6", "R7", "R8", "R9"];
    for pair in names.windows(2) {
        let rung = std::format!("JSR({},0)", pair[0]).repeat(10);
        assembler.routine(pair[1], &[rung.as_str()]);
    }
    assembler.main(&["JSR(R9,0)"]);
    let mut primary = assembler.build();
    assert_eq!(scan(&mut primary, 0, false), ScanEnd::BudgetExceeded);
}

#[test]
fn clone_when_both_go_on_then_they_do_the_same() {
    for mut rig in programs(4000).take(30) {
        rig.prescan();
        rig.scan();
        let mut copied = rig.silent.clone();
        assert_eq!(copied.machine.frames.capacity(), rig.silent.machine.frames.capacity());
        assert_eq!(copied.machine.branches.capacity(), rig.silent.machine.branches.capacity());
        for time in [50, 60, 70] {
            assert_eq!(scan(&mut copied, time, false), scan(&mut rig.silent, time, false));
            assert_eq!(shown(&copied), shown(&rig.silent));
        }
    }
}

/// Fills everything that is not listed with what cannot be there.
fn fill_scratch(primary: &mut Primary) {
    let machine = &mut primary.machine;
    let cells = machine.initial_bits.len();
    for (cell, bit) in machine.bits.iter_mut().enumerate().skip(cells + 2) {
        *bit = (cell % 2) as u8;
    }
    machine.visited.fill(true);
    machine.jumps.fill(999);
    machine.values.fill(-1);
    machine.overflowed.fill(true);
    machine.addresses.fill((7, 7, 7));
    machine.slots.fill(Slot::Bit(0));
    machine.numbers.fill(Number::Integer(-1));
    machine.returns.fill(Slot::Bit(0));
    machine.passing_bits.fill(1);
    machine.passing_words.fill(77);
    machine.copied.fill(77);
    machine.program = 99;
    machine.handled = true;
    machine.spent = u64::MAX;
}

#[test]
fn scratch_when_filled_with_anything_between_executions_then_nobody_sees_it() {
    for mut rig in programs(5000) {
        rig.prescan();
        let mut filled = rig.silent.clone();
        for time in [10, 20, 30] {
            fill_scratch(&mut filled);
            let observed = time == 20;
            assert_eq!(scan(&mut filled, time, observed), scan(&mut rig.silent, time, observed));
            assert_eq!(shown(&filled), shown(&rig.silent));
        }
        fill_scratch(&mut filled);
        assert_eq!(prescan(&mut filled), prescan(&mut rig.silent));
        assert_eq!(shown(&filled), shown(&rig.silent));
    }
}
