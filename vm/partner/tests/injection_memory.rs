//! Alone in its process, because memory is counted for the whole of it: a damaged program requests none.

mod support;

use peak_alloc::PeakAlloc;
use support::random::Numbers;
use support::{project, tags};
use twinrung_bytecode::channel::{Channel, ScanInputs};
use twinrung_bytecode::injection::{Injectable, Memory};
use twinrung_bytecode::observer::Silent;

#[global_allocator]
static MEMORY: PeakAlloc = PeakAlloc;

const PROGRAM: &str = ")
ROUTINE Main
N: LBL(Again)JSR(Sub,2,D[0],T,D[1]);
N: FAL(K,?,?,ALL,D[K.POS],D[K.POS]+1)COP(D[0],E[0],4)FLL(1,E[4],4);
N: LES(D[1],3)JMP(Again);
END_ROUTINE
ROUTINE Sub
N: SBR(X,T)ADD(X,1,X)JSR(Sum,0)RET(X);
END_ROUTINE
ROUTINE Sum
N: CPT(X,(X*D[2]+7)/3)TON(T,?,?);
END_ROUTINE";

#[test]
fn bits_when_any_are_turned_round_then_an_execution_requests_no_memory() {
    let tag_list = ["D : DINT[8]", "E : DINT[8]", "X : DINT", "T : TIMER := [0,20,0]", "K : CONTROL := [0,8,0]"];
    let mut original = support::Rig::new(&project("", &tags(&tag_list), PROGRAM)).partner;
    let bits = original.memory_bits(Memory::Program) as usize;
    let mut numbers = Numbers(0x51ED_270B);
    for _ in 0..3_000 {
        let mut damaged = original.clone();
        damaged.flip_bit(Memory::Program, numbers.below(bits) as u64);
        MEMORY.reset_peak_usage();
        let before = MEMORY.peak_usage();
        for scan in 0..3 {
            let inputs = ScanInputs { now_ms: scan * 10, budget: 5_000, system_values: &[] };
            damaged.scan(inputs, &mut Silent);
        }
        assert_eq!(MEMORY.peak_usage(), before);
    }
}
