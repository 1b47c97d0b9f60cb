//! A scan allocates nothing.
#![allow(unsafe_code)]

mod support;

use std::alloc::{GlobalAlloc, Layout, System};
use std::sync::atomic::{AtomicUsize, Ordering};

use support::{Rig, project, tags};
use twinrung_bytecode::channel::{Channel, ScanEnd, ScanInputs};
use twinrung_bytecode::observer::Silent;

/// Counts every request for memory.
struct Counting;

static REQUESTS: AtomicUsize = AtomicUsize::new(0);

// SAFETY: every call goes to the system's allocator unchanged.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        REQUESTS.fetch_add(1, Ordering::SeqCst);
        // SAFETY: the caller's promise is passed on.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        // SAFETY: the caller's promise is passed on.
        unsafe { System.dealloc(pointer, layout) }
    }

    unsafe fn realloc(&self, pointer: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        REQUESTS.fetch_add(1, Ordering::SeqCst);
        // SAFETY: the caller's promise is passed on.
        unsafe { System.realloc(pointer, layout, size) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

const TAGS: &[&str] = &[
    "In : BOOL",
    "Out : BOOL",
    "Second : BOOL",
    "N : DINT",
    "X : DINT",
    "A : DINT[8]",
    "B : DINT[8]",
    "R : REAL",
    "T : TIMER := [0,20,0]",
    "K : CONTROL := [0,8,0]",
    "Stop : DCI_STOP",
    "Rec : DINT[11]",
    "Zero : DINT[11]",
    "P : DINT",
    "Q : DINT",
];

const PROGRAM: &str = ", FAULT := \"Handler\")
ROUTINE Handler
N: GSV(PROGRAM,THIS,MajorFaultRecord,Rec[0])SSV(PROGRAM,THIS,MajorFaultRecord,Zero[0]);
END_ROUTINE
ROUTINE Main
N: XIO(In)OTE(In);
N: XIC(In)[TON(T,?,?) ,ADD(N,1,N) MOV(A[N],X) ];
N: FAL(K,?,?,ALL,A[K.POS],B[K.POS]*2+K.POS);
N: COP(A[0],B[0],8)CPT(R,SQR(N)*2.5);
N: DCS(Stop,E-STOP,EQUIVALENT - ACTIVE HIGH,100,AUTOMATIC,AUTOMATIC,In,Second,In,Out);
N: JSR(Sub,1,N,Q);
N: MOV(0,X)CLR(K.POS);
N: LBL(Again)ADD(X,1,X)LES(X,20)JMP(Again);
END_ROUTINE
ROUTINE Sub
N: SBR(P)ADD(P,1,P)RET(P);
END_ROUTINE";

#[test]
fn scan_when_everything_is_used_then_nothing_is_allocated() {
    let mut rig = Rig::new(&project("", &tags(TAGS), PROGRAM));
    let inputs = |now_ms| ScanInputs { now_ms, budget: u64::MAX, system_values: &[] };
    rig.partner.prescan(inputs(0), &mut Silent);
    let before = REQUESTS.load(Ordering::SeqCst);
    let mut completed = true;
    for scan in 0..100 {
        completed &= rig.partner.scan(inputs(scan * 10), &mut Silent) == ScanEnd::Completed;
    }
    rig.partner.prescan(inputs(2000), &mut Silent);
    let requests = REQUESTS.load(Ordering::SeqCst) - before;
    assert!(completed);
    assert!(rig.status().executed > 5000);
    assert_eq!(requests, 0);
}
