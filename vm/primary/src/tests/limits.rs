//! The bounds of this channel's own tables: what reaches them loads and runs, what is one past them is refused.

extern crate std;

use alloc::string::{String, ToString};
use std::format;

use twinrung_bytecode::channel::{Channel, ScanEnd};
use twinrung_bytecode::image::Usage;
use twinrung_bytecode::index::{BitCell, WordCell};
use twinrung_bytecode::limits;

use super::assembler::Assembler;
use super::flow::with_record;
use super::rig::Rig;
use crate::error::LoadError;
use crate::load::formula::{ADDRESSES, VALUES};

fn assembled(tags: &str, rung: &str) -> Assembler {
    let mut assembler = Assembler::new();
    assembler.tags(tags);
    assembler.main(&[rung]);
    assembler
}

#[track_caller]
fn assert_refused(tags: &str, rung: &str, what: &'static str) {
    assert_eq!(assembled(tags, rung).load().err(), Some(LoadError::TooLarge(what)));
}

fn nested(depth: usize) -> String {
    format!("XIC(a){}XIC(b){}OTE(c)", "[".repeat(depth), " ]".repeat(depth))
}

#[test]
fn branches_when_64_are_open_then_run_and_with_65_are_refused() {
    let mut rig = Rig::new("a b c BOOL", &[&nested(limits::BRANCH_DEPTH)]);
    rig.set("a", 1);
    rig.scan();
    assert_eq!(rig.get("c"), 0);
    rig.set("b", 1);
    rig.scan();
    assert_eq!(rig.get("c"), 1);
    assert_refused("a b c BOOL", &nested(limits::BRANCH_DEPTH + 1), "the nesting of branches");
}

fn copy(length: u32) -> String {
    format!("COP(from[0],to[0],{length})")
}

#[test]
fn copy_when_it_moves_65536_bytes_then_runs_and_with_more_is_refused() {
    let tags = "from to DINT[20000]";
    let whole = limits::COPY_BYTES / 4;
    let mut rig = Rig::new(tags, &[&copy(whole)]);
    let last = whole - 1;
    rig.set(&format!("from[{last}]"), 7);
    rig.scan();
    assert_eq!(rig.get(&format!("to[{last}]")), 7);
    assert_refused(tags, &copy(whole + 1), "the bytes that one instruction moves");
}

fn within(depth: usize) -> String {
    format!("MOV({}i{},j)", "arr[".repeat(depth), "]".repeat(depth))
}

#[test]
fn subscripts_when_32_addresses_are_open_then_run_and_with_33_are_refused() {
    let tags = "arr DINT[4]; i j DINT";
    let mut rig = Rig::new(tags, &[&within(ADDRESSES)]);
    rig.set("arr[1]", 1);
    rig.set("i", 1);
    rig.scan();
    assert_eq!(rig.get("j"), 1);
    assert_refused(tags, &within(ADDRESSES + 1), "the nesting of one operand");
}

fn open_values(values: usize) -> String {
    format!("CPT(i,{}1{})", "(1+".repeat(values - 1), ")".repeat(values - 1))
}

#[test]
fn expression_when_512_values_are_open_then_runs_and_with_513_is_refused() {
    let mut rig = Rig::new("i DINT", &[&open_values(VALUES)]);
    rig.scan();
    assert_eq!(rig.get("i"), VALUES as i32);
    assert_refused("i DINT", &open_values(VALUES + 1), "the nesting of one operand");
}

#[test]
fn expression_when_it_has_16384_operations_then_runs_and_with_more_is_refused() {
    let sum = |ones: usize| ["1"].repeat(ones).join("+");
    let mut rig = Rig::new("i DINT", &[&format!("CPT(i,-({}))", sum(8192))]);
    rig.scan();
    assert_eq!(rig.get("i"), -8192);
    assert_refused("i DINT", &format!("CPT(i,{})", sum(8193)), "the subscripts of one operand");
}

/// A rung with the element within as many branches as may be open; their other legs stay false.
fn surrounded(element: &str) -> String {
    let depth = limits::BRANCH_DEPTH;
    format!("{}{element}{}", "[".repeat(depth), " ,AFI()]".repeat(depth))
}

/// As deep as the verifier admits: 25 subroutines, and in the last of them 16 Add-On Instructions within each other.
/// The innermost faults while PRE of `t` is negative; the fault routine goes the same way once more.
fn deepest() -> Rig {
    let mut assembler = Assembler::new();
    assembler.tags("f g BOOL; n DINT; t TIMER");
    with_record(&mut assembler);
    let parameters = [("N", "DINT", Usage::InOut), ("T", "TIMER", Usage::InOut)];
    let logic = ["ADD(N,1,N)", &surrounded("TON(T,?,?)")];
    assembler.add_on("A1", &parameters, &[], [&logic, &[], &[]]);
    for depth in 2..=limits::ADD_ON_DEPTH {
        let inner = format!("A{}", depth - 1);
        let call = surrounded(&format!("{inner}(Inner,N,T)"));
        assembler.add_on(&format!("A{depth}"), &parameters, &[("Inner", &inner)], [&[&call], &[], &[]]);
    }
    let outermost = format!("A{}", limits::ADD_ON_DEPTH);
    assembler.tag("inst", &outermost);
    assembler.routine("R1", &[&surrounded(&format!("{outermost}(inst,n,t)"))]);
    for depth in 2..=limits::CALL_DEPTH {
        assembler.routine(&format!("R{depth}"), &[&surrounded(&format!("JSR(R{},0)", depth - 1))]);
    }
    let call = surrounded(&format!("JSR(R{},0)", limits::CALL_DEPTH));
    assembler.fault(&["MOV(0,t.PRE)", &call, "SSV(PROGRAM,THIS,0,zero[0])"]);
    assembler.main(&[&format!("{call}OTE(f)"), "OTE(g)"]);
    Rig::of(assembler)
}

#[test]
fn routines_when_nested_as_deep_as_admitted_with_all_branches_open_then_run() {
    let mut rig = deepest();
    assert_eq!(rig.prescan(), ScanEnd::Completed);
    assert_eq!(rig.scan(), ScanEnd::Completed);
    assert_eq!(rig.all("n f g"), [1, 1, 1]);
}

#[test]
fn fault_routine_when_it_goes_as_deep_as_the_routines_that_it_interrupted_then_runs() {
    let mut rig = deepest();
    rig.prescan();
    rig.scan();
    rig.set("t.PRE", -1);
    assert_eq!(rig.scan(), ScanEnd::Completed);
    assert_eq!(rig.all("n t.PRE g"), [3, 0, 1]);
    assert_eq!(rig.status().cleared_faults, 1);
}

#[test]
fn cell_when_it_is_behind_the_last_then_setting_it_changes_nothing() {
    let mut rig = Rig::new("a b BOOL; i DINT", &["XIC(a)OTE(b)", "MOV(7,i)", "AFI()MOV(8,i)"]);
    for primary in [&mut rig.silent, &mut rig.observed] {
        for behind in 2..8 {
            primary.set_bit(BitCell(behind), behind % 2 == 0);
        }
        for behind in 1..3 {
            primary.set_word(WordCell(behind), -1);
        }
    }
    rig.set("a", 1);
    rig.scan();
    assert_eq!(rig.all("a b i"), [1, 1, 7]);
}

#[test]
fn load_error_when_shown_then_names_the_channel_and_what_it_was_about() {
    let errors = [LoadError::Malformed("a path"), LoadError::TooLarge("the steps"), LoadError::Unsupported("it")];
    assert_eq!(
        errors.map(|error| error.to_string()),
        [
            "the primary cannot decode a path",
            "the primary has no room for the steps",
            "the primary does not execute it"
        ]
    );
}

/// A call of an Add-On Instruction with an Input, an InOut BOOL and an Output, with these arguments.
fn call(arguments: &str) -> Option<LoadError> {
    let mut assembler = Assembler::new();
    assembler.tags("a BOOL; i j DINT; many BOOL[4]");
    let parameters = [("In", "DINT", Usage::Input), ("Bit", "BOOL", Usage::InOut), ("Out", "DINT", Usage::Output)];
    assembler.add_on("Block", &parameters, &[], [&["XIC(Bit)MOV(In,Out)"], &[], &[]]);
    assembler.tag("inst", "Block");
    assembler.tag("insts", "Block[2]");
    assembler.main(&[&format!("Block({arguments})")]);
    assembler.load().err()
}

#[test]
fn add_on_call_when_its_arguments_are_not_those_of_the_declaration_then_is_refused() {
    let malformed = Some(LoadError::Malformed("the call of an Add-On Instruction"));
    assert_eq!(call("inst,i,a,j"), None);
    assert_eq!(call("inst,i,a"), malformed);
    assert_eq!(call("inst,i,a,j,j"), malformed);
    assert_eq!(call("i,i,a,j"), malformed);
}

#[test]
fn add_on_call_when_what_it_binds_is_not_fixed_cells_then_is_refused() {
    let unbound = Some(LoadError::Unsupported("an InOut argument with a variable subscript"));
    assert_eq!(call("inst,i,many[1],j"), None);
    assert_eq!(call("inst,i,many[i],j"), unbound);
    assert_eq!(call("inst,i,i.3,j"), unbound);
    assert_eq!(call("insts[1],i,a,j"), None);
    let unfixed = Some(LoadError::Unsupported("an instance with a variable subscript"));
    assert_eq!(call("insts[i],i,a,j"), unfixed);
}
