//! What loading makes of a rung: what cannot fault stands beside its equals in a block, and only what may fault or
//! change the flow stands alone. A rung costs the same whatever its contacts say because of that.

extern crate std;

use alloc::string::String;
use alloc::vec;
use alloc::vec::Vec;
use std::format;

use twinrung_catalog::Opcode;

use super::assembler::{Assembler, Cell};
use super::rig::Rig;
use crate::lower::table::{Gate, Kind};
use crate::number::{Binary, Relation};
use crate::program::{Code, Program, Step};

const TAGS: &str = "a b c d e f g h BOOL; flags BOOL[8]; i j k DINT; n INT; p SINT; q r REAL; arr DINT[8]; \
                    big more DINT[80]; small SINT[8]; reals REAL[4]; t TIMER; u TIMER; s COUNTER; z CONTROL";

fn assembled(rungs: &[&str]) -> (Assembler, Program) {
    let mut assembler = Assembler::new();
    assembler.tags(TAGS);
    assembler.image.event_tasks.push("E".into());
    assembler.routine("Sub", &["NOP()"]);
    assembler.main(rungs);
    let program = assembler.build().program;
    (assembler, program)
}

fn lowered(rungs: &[&str]) -> Program {
    assembled(rungs).1
}

/// The kinds of work in the steps of a rung, in their order; `None` for an instruction that stands alone.
fn kinds(rung: &str) -> Vec<Option<Kind>> {
    let program = lowered(&[rung]);
    let main = program.bodies[program.programs[0].main as usize];
    let mut kinds = Vec::new();
    for step in main.steps.of(&program.steps) {
        match step {
            Step::Block { runs, .. } => kinds.extend(runs.of(&program.tables.runs).iter().map(|run| Some(run.kind))),
            Step::Single(_) => kinds.push(None),
            Step::End { .. } => {}
        }
    }
    kinds
}

#[track_caller]
fn assert_kinds(expected: &[(&str, &[Kind])]) {
    let found: Vec<(&str, Vec<Option<Kind>>)> = expected.iter().map(|(rung, _)| (*rung, kinds(rung))).collect();
    let expected: Vec<(&str, Vec<Option<Kind>>)> =
        expected.iter().map(|(rung, kinds)| (*rung, kinds.iter().copied().map(Some).collect())).collect();
    assert_eq!(found, expected);
}

#[test]
fn bits_timers_and_comparisons_when_fixed_then_stand_beside_their_equals() {
    use Kind::{Compares, Gates, OffDelays, OnDelays, Retentives, WordBits};
    assert_kinds(&[
        ("NOP()", &[]),
        ("XIC(a)XIO(b)OTE(c)", &[Gates]),
        ("AFI()OTE(c)", &[Gates]),
        ("XIC(S:FS)OTL(c)", &[Gates]),
        ("XIC(a)OTU(c)", &[Gates]),
        ("XIC(a)ONS(b)OTE(c)", &[Gates]),
        ("XIC(a)OSR(b,c)", &[Gates]),
        ("XIC(a)OSF(b,c)", &[Gates]),
        ("XIC(i.3)OTE(c)", &[WordBits, Gates]),
        ("TON(t,?,?)", &[OnDelays]),
        ("TOF(t,?,?)", &[OffDelays]),
        ("RTO(t,?,?)", &[Retentives]),
        ("EQU(i,n)OTE(a)", &[Compares(Relation::Equal), Gates]),
        ("NEQ(p,n)OTE(a)", &[Compares(Relation::NotEqual), Gates]),
        ("GRT(i,5)OTE(a)", &[Compares(Relation::Greater), Gates]),
        ("GEQ(5,i)OTE(a)", &[Compares(Relation::GreaterOrEqual), Gates]),
        ("LES(i,j)OTE(a)", &[Compares(Relation::Less), Gates]),
        ("LEQ(i,j)OTE(a)", &[Compares(Relation::LessOrEqual), Gates]),
    ]);
}

#[test]
fn moves_and_arithmetic_when_between_dints_then_stand_beside_their_equals() {
    use Kind::{Arithmetic, Moves};
    assert_kinds(&[
        ("MOV(i,j)", &[Moves]),
        ("MOV(n,j)", &[Moves]),
        ("MOV(7,j)", &[Moves]),
        ("CLR(j)", &[Moves]),
        ("ADD(i,n,j)", &[Arithmetic(Binary::Add)]),
        ("SUB(i,1,j)", &[Arithmetic(Binary::Subtract)]),
        ("MUL(i,p,j)", &[Arithmetic(Binary::Multiply)]),
        ("AND(i,1,j)", &[Arithmetic(Binary::And)]),
        ("OR(1,i,j)", &[Arithmetic(Binary::Or)]),
        ("XOR(i,k,j)", &[Arithmetic(Binary::Xor)]),
    ]);
}

#[test]
fn anything_else_that_cannot_fault_when_fixed_then_stands_in_a_block() {
    use Kind::{Gates, General};
    assert_kinds(&[
        ("MOV(i,n)", &[General]),
        ("MOV(q,i)", &[General]),
        ("CLR(q)", &[General]),
        ("ADD(i,j,n)", &[General]),
        ("ADD(i,q,j)", &[General]),
        ("DIV(i,j,k)", &[General]),
        ("AND(n,1,j)", &[General]),
        ("AND(1,n,j)", &[General]),
        ("NOT(i,j)", &[General]),
        ("MVM(i,j,k)", &[General]),
        ("SQR(q,r)", &[General]),
        ("EQU(q,1)OTE(a)", &[General, Gates]),
        ("LIM(1,i,5)OTE(a)", &[General, Gates]),
        ("MEQ(i,j,k)OTE(a)", &[General, Gates]),
        ("CMP(i = j)OTE(a)", &[General, Gates]),
        ("CPT(i,j + k)", &[General]),
        ("OTE(i.3)", &[General]),
        ("OSR(a,a)", &[General]),
        ("ONS(i.3)", &[General]),
        ("CTU(s,?,?)", &[General]),
        ("CTD(s,?,?)", &[General]),
        ("RES(s)", &[General]),
        ("SWPB(i,WORD,j)", &[General]),
        ("EVENT(0)", &[General]),
        ("MCR()", &[General]),
        ("COP(arr[0],arr[4],4)", &[General]),
        ("FLL(0,arr[0],8)", &[General]),
        ("SIZE(arr,0,i)", &[General]),
    ]);
}

#[test]
fn fill_when_its_source_fits_whatever_its_value_then_stands_in_a_block() {
    let fits =
        ["FLL(127,small[0],8)", "FLL(p,small[0],8)", "FLL(n,arr[0],8)", "FLL(i,reals[0],4)", "FLL(q,reals[0],4)"];
    assert_eq!(fits.map(kinds), [Kind::General; 5].map(|kind| vec![Some(kind)]));
    let may_not =
        ["FLL(128,small[0],8)", "FLL(n,small[0],8)", "FLL(i,small[0],8)", "FLL(q,arr[0],8)", "FLL(2.5,arr[0],8)"];
    assert_eq!(may_not.map(kinds), [(); 5].map(|()| vec![None]));
}

#[test]
fn instruction_when_it_may_fault_or_change_the_flow_then_stands_alone() {
    let alone = [
        "MOV(arr[i],j)",
        "OTE(flags[i])",
        "OTE(i.[j])",
        "JSR(Sub,0)",
        "TND()",
        "RET()",
        "FAL(z,?,?,ALL,arr[0],1)",
        "CPT(i,arr[j])",
        "CMP(i + j)",
        "COP(arr[4],arr[0],5)",
        "COP(arr[0],arr[4],5)",
        "FLL(0,arr[4],5)",
    ];
    let found: Vec<(&str, Vec<Option<Kind>>)> = alone.iter().map(|rung| (*rung, kinds(rung))).collect();
    let expected: Vec<(&str, Vec<Option<Kind>>)> = alone.iter().map(|rung| (*rung, vec![None])).collect();
    assert_eq!(found, expected);
}

#[test]
fn contact_when_it_reads_the_status_then_stands_alone_before_what_follows() {
    assert_eq!(kinds("XIC(S:V)OTE(a)"), [None, Some(Kind::Gates)]);
}

#[test]
fn timer_when_logic_may_make_its_words_negative_then_stands_alone() {
    let singles = |rungs: &[&str]| lowered(rungs).steps.iter().filter(|step| matches!(step, Step::Single(_))).count();
    assert_eq!(singles(&["TON(t,?,?)", "MOV(5,t.PRE)CLR(t.ACC)RES(t)", "MOV(i,u.PRE)"]), 0);
    assert_eq!(singles(&["TON(t,?,?)", "MOV(-5,t.PRE)"]), 1);
    assert_eq!(singles(&["TON(t,?,?)", "MOV(i,t.PRE)"]), 1);
    assert_eq!(singles(&["TON(t,?,?)", "ADD(i,j,t.ACC)"]), 1);
    assert_eq!(singles(&["TON(u,?,?)", "COP(u,t,1)"]), 0);
    assert_eq!(singles(&["TON(t,?,?)", "COP(u,t,1)"]), 1);
    assert_eq!(singles(&["TON(t,?,?)TON(u,?,?)", "MOV(t.PRE,i)MOV(u.ACC,j)"]), 0);
}

#[test]
fn timer_when_a_copy_over_its_array_and_moves_within_it_are_written_then_stands_alone() {
    let mut assembler = Assembler::new();
    assembler.tags("from to TIMER[8]; i DINT");
    assembler.main(&["COP(from[0],to[0],8)", "MOV(i,to[1].PRE)MOV(i,to[2].PRE)", "TON(to[6],?,?)TON(from[6],?,?)"]);
    let program = assembler.build().program;
    let singles: Vec<Opcode> = program
        .steps
        .iter()
        .filter_map(|step| match step {
            Step::Single(single) => Some(program.codes[single.code as usize]),
            Step::Block { .. } | Step::End { .. } => None,
        })
        .filter_map(|code| match code {
            Code::Instruction(index) => Some(program.instructions[index as usize].opcode),
            _ => None,
        })
        .collect();
    assert_eq!(singles, [Opcode::Ton]);
}

#[test]
fn scan_when_a_word_was_set_below_zero_then_goes_by_steps_where_no_timer_holds_it() {
    let mut rig = Rig::new("t TIMER; i DINT; b BOOL", &["TON(t,?,?)"]);
    rig.scan();
    rig.set("i", 0);
    assert!(!rig.silent.machine.doubtful);
    rig.set("i", -1);
    assert!(rig.silent.machine.doubtful);
    rig.scan();
    assert!(!rig.silent.machine.doubtful);
    rig.set("t.PRE", -1);
    rig.scan();
    assert!(rig.silent.machine.doubtful);
    rig.set("t.PRE", 0);
    rig.scan();
    assert!(!rig.silent.machine.doubtful);
    rig.set("t.ACC", -1);
    rig.scan();
    assert!(rig.silent.machine.doubtful);
    rig.set("t.ACC", 0);
    rig.set("i", 0);
    rig.scan();
    assert!(!rig.silent.machine.doubtful);
}

#[test]
fn instruction_when_it_touches_128_cells_then_stands_in_a_block_and_with_more_alone() {
    assert_eq!(kinds("COP(big[0],more[0],64)"), [Some(Kind::General)]);
    assert_eq!(kinds("COP(big[0],more[0],65)"), [None]);
}

#[test]
fn expression_when_it_has_128_operations_then_stands_in_a_block_and_with_more_alone() {
    let sum = ["1"; 64].join("+");
    assert_eq!(kinds(&format!("CPT(i,-({sum}))")), [Some(Kind::General)]);
    assert_eq!(kinds(&format!("CPT(i,{sum}+1)")), [None]);
}

#[test]
fn contacts_when_up_to_four_are_in_series_and_in_parallel_then_one_gate_stores_the_coil() {
    let (mut assembler, program) = assembled(&["XIC(a)[XIO(b) ,XIC(c) ]XIC(d)OTE(e)"]);
    let [a, b, c, d, e] = ["a", "b", "c", "d", "e"].map(|name| match assembler.cell(name) {
        Cell::Bit(cell) | Cell::Word(cell) => cell,
    });
    let gates = &program.tables.narrow;
    assert_eq!((gates.len(), program.tables.wide.len()), (1, 0));
    let Gate { mut inputs, out, .. } = gates[0];
    inputs.sort_unstable();
    assert_eq!(inputs.map(u32::from), [a, b, c, d]);
    assert_eq!(u32::from(out), e);
}

#[test]
fn gate_when_it_has_fewer_inputs_then_reads_the_first_again() {
    let (mut assembler, program) = assembled(&["XIO(a)OTE(b)"]);
    assert_eq!(assembler.cell("a"), Cell::Bit(u32::from(program.tables.narrow[0].inputs[0])));
    let Gate { inputs, table, .. } = program.tables.narrow[0];
    assert_eq!(inputs, [inputs[0]; 4]);
    assert_eq!(table, 0x5555);
}

#[test]
fn condition_when_several_coils_store_it_then_no_gate_is_spent_on_copies() {
    let gates = |rung: &str| lowered(&[rung]).tables.narrow.len();
    assert_eq!(gates("XIC(a)OTE(b)"), 1);
    assert_eq!(gates("XIC(a)XIC(b)OTE(c)OTE(d)"), 2);
    assert_eq!(gates("XIC(a)XIC(b)OTL(c)"), 1);
    assert_eq!(gates("XIC(a)[XIC(b)OTE(c) ,XIC(d)OTE(e) ]"), 2);
    assert_eq!(gates("XIC(a)ONS(b)OTE(c)"), 3);
    assert_eq!(gates("AFI()XIC(a)TON(t,?,?)"), 0);
    assert_eq!(gates("XIC(a)TON(t,?,?)"), 0);
    assert_eq!(gates("XIC(a)XIC(b)TON(t,?,?)"), 1);
    // One for the copy of b that the leg goes on with, one for the latch, one for d.
    assert_eq!(gates("[XIC(a) ,XIC(b)OTL(b)XIC(c) ]OTE(d)"), 3);
}

#[test]
fn comparison_when_nobody_reads_its_result_then_no_work_is_spent_on_it() {
    assert_eq!(kinds("EQU(i,j)"), []);
    assert_eq!(kinds("XIC(a)XIC(i.3)"), []);
    assert_eq!(kinds("LIM(1,i,5)"), [Some(Kind::General)]);
}

#[test]
fn constant_when_it_stands_in_several_places_then_is_kept_once() {
    let mut assembler = Assembler::new();
    assembler.tags(TAGS);
    assembler.main(&["MOV(7,i)ADD(7,8,j)EQU(i,8)OTE(a)"]);
    let primary = assembler.build();
    assert_eq!(primary.machine.constants, [7, 8]);
}

#[test]
fn rungs_when_their_work_exceeds_32768_pieces_then_the_block_ends_with_the_rung() {
    let blocks = |rungs: usize| {
        let rungs = vec!["XIC(a)OTE(b)"; rungs];
        let program = lowered(&rungs);
        let main = program.bodies[program.programs[0].main as usize];
        main.steps.of(&program.steps).iter().filter(|step| matches!(step, Step::Block { .. })).count()
    };
    assert_eq!(blocks(32_769), 1);
    assert_eq!(blocks(32_770), 2);
}

#[test]
fn gates_when_the_bit_bank_is_of_any_size_then_are_evaluated() {
    for (cells, bank) in
        [(100, 1 << 16), (70_000, 1 << 18), (300_000, 1 << 20), (1_100_000, 1 << 22), (4_200_000, 1 << 25)]
    {
        let tags = format!("many BOOL[{cells}]; a b BOOL");
        let rung = format!("XIC(many[{}])XIO(a)OTE(b)", cells - 1);
        let mut rig = Rig::new(&tags, &[rung.as_str()]);
        assert_eq!(rig.silent.machine.bits.len(), bank);
        rig.set(&format!("many[{}]", cells - 1), 1);
        rig.scan();
        assert_eq!(rig.get("b"), 1);
        rig.set("a", 1);
        rig.scan();
        assert_eq!(rig.get("b"), 0);
    }
}

#[test]
fn work_when_ordered_then_equal_work_of_many_rungs_is_one_run() {
    let rung = |bit: u32| format!("XIC(flags[{bit}])MOV({bit},arr[{bit}])ADD(i,{bit},big[{bit}])");
    let rungs: Vec<String> = (0..8).map(rung).collect();
    let rungs: Vec<&str> = rungs.iter().map(String::as_str).collect();
    let program = lowered(&rungs);
    let runs: Vec<(Kind, u32)> = program.tables.runs.iter().map(|run| (run.kind, run.range.count)).collect();
    assert_eq!(runs, [(Kind::Moves, 8), (Kind::Arithmetic(Binary::Add), 8)]);
}

#[test]
fn operand_when_several_instructions_name_it_then_is_decoded_once() {
    assert_eq!(lowered(&["XIC(a)OTE(b)", "XIO(a)OTL(b)"]).operands.len(), 2);
}

#[test]
fn scratch_when_a_signal_was_used_for_the_last_time_then_its_cell_serves_the_next() {
    let program = lowered(&["EQU(i,1)ADD(i,1,i)"; 20]);
    let mut cells: Vec<u32> = program.tables.compares.iter().map(|compare| compare.out).collect();
    assert_eq!(cells.len(), 20);
    cells.dedup();
    assert_eq!(cells.len(), 1);
}
