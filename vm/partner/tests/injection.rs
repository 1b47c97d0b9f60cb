//! Bits turned round: whatever they were, an execution neither panics nor runs on, and a flip undone leaves no trace.

mod support;

use std::fs;
use std::path::Path;

use support::random::{Numbers, program};
use support::{Rig, Watching, project, tags};
use twinrung_bytecode::channel::{Channel, ScanInputs, Status};
use twinrung_bytecode::index::{BitCell, WordCell};
use twinrung_bytecode::injection::{Flip, Injectable, Memory};
use twinrung_bytecode::observer::Silent;
use twinrung_partner::Partner;

/// What jumps, calls, loops, faults and computes places while it runs.
const EVERYTHING: &str = ", FAULT := \"Handler\")
ROUTINE Main
N: XIC(In[0])JSR(Sub,2,D[At],S,D[0]);
N: XIC(In[1])JMP(Over);
N: XIC(In[2])OTE(Out[0]);
N: LBL(Over)[XIC(In[3]) ,XIC(In[4])[XIC(In[5]) ,XIO(In[6]) ] ]OTL(Out[1])TON(T,?,?);
N: LBL(Again)ADD(At,1,At);
N: LES(At,3)JMP(Again);
N: FAL(K,?,?,ALL,D[K.POS],E[K.POS]*2+At);
N: XIC(In[7])FSC(L,?,?,2,D[L.POS]>At);
N: COP(D[At],E[At],2)FLL(At,D[0],4)CPT(R,(R+At)*1.5)CMP(D[At]>3)OTE(Out[2]);
N: XIC(In[6])MCR();
N: OTE(Out[3])CTU(C,?,?)GSV(PROGRAM,THIS,MajorFaultRecord,F[0])MOV(R,I)MVM(D[1],255,D[2])SWPB(D[3],REVERSE,D[3]);
N: MCR();
N: XIC(In[5])Twice(A,D[1],D[2]);
N: DCS(Stop,E-STOP,EQUIVALENT - ACTIVE HIGH,100,AUTOMATIC,AUTOMATIC,In[0],In[1],In[2],In[3]);
N: XIC(In[4])JSR(Handler,1,991);
END_ROUTINE
ROUTINE Sub
N: SBR(X,S)ADD(X,1,X)XIC(In[2])RET(X);
N: XIC(In[3])TND();
N: Twice(B,X,D[3])RET(X);
END_ROUTINE
ROUTINE Handler
N: SBR(X);
N: XIO(In[7])SSV(PROGRAM,THIS,MajorFaultRecord,Zero[0]);
END_ROUTINE";

const EVERYTHING_TAGS: &[&str] = &[
    "In : BOOL[8]",
    "Out : BOOL[8]",
    "D : DINT[8]",
    "E : DINT[8]",
    "F : DINT[11]",
    "Zero : DINT[11]",
    "At : DINT",
    "X : DINT",
    "I : INT",
    "R : REAL",
    "S : TIMER",
    "T : TIMER := [0,20,0]",
    "C : COUNTER := [0,3,0]",
    "K : CONTROL := [0,8,0]",
    "L : CONTROL := [0,8,0]",
    "A : Twice",
    "B : Twice",
    "Stop : DCI_STOP",
];

const TWICE: &str = "ADD_ON_INSTRUCTION_DEFINITION Twice (Class := Safety, Revision := \"1.0\", ExecutePrescan := Yes, \
    ExecuteEnableInFalse := Yes)\nPARAMETERS\nGiven : DINT (Usage := Input, Required := Yes, Visible := Yes);\n\
    Sum : DINT (Usage := Output, Required := Yes, Visible := Yes);\nEND_PARAMETERS\nLOCAL_TAGS\nN : DINT;\nEND_LOCAL_TAGS\n\
    ROUTINE Logic\nN: CLR(N);\nN: LBL(Again)ADD(N,1,N)ADD(Sum,Given,Sum)LES(N,2)JMP(Again);\nEND_ROUTINE\n\
    ROUTINE Prescan\nN: CLR(Sum);\nEND_ROUTINE\nROUTINE EnableInFalse\nN: NEG(Given,Sum);\nEND_ROUTINE\n\
    END_ADD_ON_INSTRUCTION_DEFINITION";

fn everything() -> Partner {
    Rig::new(&project(TWICE, &tags(EVERYTHING_TAGS), EVERYTHING)).partner
}

fn inputs(now_ms: i64) -> ScanInputs<'static> {
    ScanInputs { now_ms, budget: 20_000, system_values: &[3, 5, 8] }
}

/// Some scans with random inputs, what they left, and how they ended.
fn runs(partner: &mut Partner, seed: u64) -> (Vec<u8>, Vec<u32>, Status, u32, Vec<bool>) {
    let mut numbers = Numbers(seed | 1);
    let mut ends = vec![partner.prescan(inputs(0), &mut Silent)];
    for scan in 1..6 {
        for _ in 0..8 {
            partner.set_bit(BitCell(numbers.below(24) as u32), numbers.below(2) == 0);
        }
        partner.set_word(WordCell(numbers.below(24) as u32), numbers.below(9) as i32 - 1);
        let inputs = inputs(scan * 10);
        ends.push(match scan {
            4 => partner.scan(inputs, &mut Watching),
            _ => partner.scan(inputs, &mut Silent),
        });
    }
    let completed = ends.iter().map(|end| *end == twinrung_bytecode::channel::ScanEnd::Completed).collect();
    (partner.bits().to_vec(), partner.words().to_vec(), partner.status(), partner.path_signature(), completed)
}

/// A random bit of a random memory.
fn random_bit(partner: &mut Partner, numbers: &mut Numbers) -> (Memory, u64) {
    let memory = Memory::ALL[numbers.below(12).min(2)];
    let bits = partner.memory_bits(memory);
    (memory, numbers.below(bits as usize) as u64)
}

/// Executes copies of a partner in which up to three bits are turned round each; how many of them end as the original.
fn survives(original: &mut Partner, flips: usize, seed: u64) -> usize {
    let mut numbers = Numbers(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1);
    let sound = runs(&mut original.clone(), seed);
    let mut alike = 0;
    for _ in 0..flips {
        let mut damaged = original.clone();
        for _ in 0..=numbers.below(3) {
            let (memory, bit) = random_bit(original, &mut numbers);
            damaged.flip_bit(memory, bit);
        }
        alike += usize::from(runs(&mut damaged, seed) == sound);
        damaged.reset();
        damaged.scan(inputs(0), &mut Silent);
    }
    alike
}

fn samples() -> Vec<String> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../samples");
    let mut paths: Vec<_> =
        fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path().join("project.rll")).collect();
    paths.sort();
    paths.iter().filter_map(|path| fs::read_to_string(path).ok()).collect()
}

#[test]
fn bits_when_any_are_turned_round_in_the_samples_then_every_execution_ends() {
    let samples = samples();
    assert!(samples.len() >= 10);
    for (number, text) in samples.iter().enumerate() {
        survives(&mut Rig::new(text).partner, 500, number as u64);
    }
}

#[test]
fn bits_when_any_are_turned_round_in_random_programs_then_every_execution_ends() {
    for seed in 0..40 {
        survives(&mut Rig::new(&program(seed, 16, seed % 2 == 0)).partner, 250, seed);
    }
}

#[test]
fn bits_when_any_are_turned_round_in_what_jumps_and_calls_then_every_execution_ends() {
    let alike = survives(&mut everything(), 10_000, 7);
    // A flip changes something, or it does not.
    assert!(alike > 0 && alike < 9_000, "{alike}");
}

#[test]
fn bits_when_each_of_a_small_program_is_turned_round_then_every_execution_ends() {
    let text = "N: XIC(A)[JMP(Over) ,XIO(B) ]OTE(B);\nN: XIC(B)JSR(Sub,0);\nN: LBL(Over)TON(T,?,?);";
    let program = format!(")\nROUTINE Main\n{text}\nEND_ROUTINE\nROUTINE Sub\nN: LBL(Up)XIC(B)JMP(Up);\nEND_ROUTINE");
    let mut original = Rig::new(&project("", &tags(&["A : BOOL", "B : BOOL", "T : TIMER"]), &program)).partner;
    for bit in 0..original.memory_bits(Memory::Program) {
        let mut damaged = original.clone();
        let held = damaged.read_bit(Memory::Program, bit).unwrap();
        let flip = damaged.flip_bit(Memory::Program, bit);
        assert_eq!(damaged.read_bit(Memory::Program, bit), Some(held ^ (flip == Flip::Done)), "{bit}");
        runs(&mut damaged, bit);
    }
}

#[test]
fn bit_when_turned_round_and_back_then_executions_are_as_before() {
    let mut original = everything();
    let sound = runs(&mut original.clone(), 3);
    let mut numbers = Numbers(99);
    for _ in 0..2_000 {
        let (memory, bit) = random_bit(&mut original, &mut numbers);
        let mut restored = original.clone();
        let first = restored.flip_bit(memory, bit);
        assert_eq!(restored.flip_bit(memory, bit), first);
        assert_eq!(runs(&mut restored, 3), sound, "{memory:?} {bit}");
    }
}

#[test]
fn clone_when_taken_between_scans_then_it_goes_on_as_the_original() {
    let mut original = everything();
    runs(&mut original, 5);
    let mut clone = original.clone();
    assert_eq!(runs(&mut clone, 8), runs(&mut original, 8));
}

#[test]
fn bit_when_behind_the_last_of_its_memory_then_nothing_is_turned_round() {
    let mut partner = everything();
    for memory in Memory::ALL {
        let bits = partner.memory_bits(memory);
        assert!(bits > 0);
        assert_eq!(partner.flip_bit(memory, bits), Flip::OutOfRange);
    }
}
