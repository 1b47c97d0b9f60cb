//! Every runtime fault of the table that can happen, happens here in both channels; what no test reaches is found.

use std::collections::BTreeSet;

use twinrung_bytecode::channel::{Channel, MajorFault, Place};
use twinrung_bytecode::index::{ProgramIndex, RoutineIndex};
use twinrung_compiler::{Completion, check, compile};
use twinrung_controller::{
    Controller, Difference, DualController, RUNTIME_FAULTS, Raised, RuntimeFault, SafetyFault, StopReason,
};
use twinrung_grammar::tree::Sources;

/// A program that raises a fault in its first scan: tags, rungs.
struct Raising {
    code: u16,
    tags: &'static str,
    rungs: &'static str,
}

const PROGRAMS: &[Raising] = &[
    Raising {
        code: 20,
        tags: "Levels : DINT[4] (Class := Safety);\n At, To : DINT (Class := Safety);",
        rungs: "N: MOV(4,At);\n N: MOV(Levels[At],To);",
    },
    Raising {
        code: 21,
        tags: "Files : CONTROL (Class := Safety);\n Levels : DINT[4] (Class := Safety);",
        rungs: "N: SUB(0,1,Files.LEN);\n N: FAL(Files,?,?,ALL,Levels[Files.POS],1);",
    },
    Raising { code: 34, tags: "Wait : TIMER (Class := Safety);", rungs: "N: SUB(0,1,Wait.PRE);\n N: TON(Wait,?,?);" },
    Raising {
        code: 94,
        tags: "Passes : DINT (Class := Safety);",
        rungs: "N: LBL(Again)ADD(Passes,1,Passes);\n N: LES(Passes,2000000)JMP(Again);",
    },
    Raising { code: 990, tags: "Seen : BOOL (Class := Safety);", rungs: "N: JSR(Fault,1,990);" },
    Raising { code: 999, tags: "Seen : BOOL (Class := Safety);", rungs: "N: JSR(Fault,1,999);" },
];

fn controller(tags: &str, rungs: &str) -> DualController {
    let text = format!(
        "CONTROLLER Faulty (ProcessorType := \"1756-L73S\", Major := 20)
  TAG\n {tags}\n Number : DINT (Class := Safety);\n  END_TAG
  PROGRAM Safety_Main (Class := Safety, MAIN := \"Main\", FAULT := \"Fault\")
    ROUTINE Fault\n N: SBR(Number);\n N: NOP();\n    END_ROUTINE
    ROUTINE Main\n {rungs}\n    END_ROUTINE
  END_PROGRAM
  TASK Safety_Task (Type := PERIODIC, Class := Safety, Rate := 100, Watchdog := 100, Priority := 5)
    Safety_Main;
  END_TASK
END_CONTROLLER
"
    );
    let reading = twinrung_grammar::read(&mut Sources::new(), "faults.rll", text.into_bytes());
    let checked = check(&reading, &Completion::default());
    let bytes = compile(&checked.project.unwrap_or_else(|| panic!("{:?}", checked.findings))).unwrap().bytes;
    let mut controller = Controller::load(twinrung_bytecode::admit(&bytes).unwrap(), &bytes).unwrap();
    controller.power_up_in_run();
    controller
}

fn covers(fault: &RuntimeFault, code: u16) -> bool {
    (fault.first..=fault.last).contains(&code)
}

/// REQ-FAULT-006. A fault that is added to the table without a program here fails, and so does a program for no fault.
#[test]
fn faults_when_each_program_runs_then_each_major_fault_that_logic_can_raise_is_raised() {
    let of_logic: Vec<&RuntimeFault> =
        RUNTIME_FAULTS.iter().filter(|fault| fault.raised == Raised::ByLogic && !fault.minor).collect();
    for fault in &of_logic {
        let tested = |code: u16| PROGRAMS.iter().any(|program| program.code == code);
        assert!(tested(fault.first) && tested(fault.last), "no program raises 4/{} to 4/{}", fault.first, fault.last);
    }
    for Raising { code, tags, rungs } in PROGRAMS {
        assert!(of_logic.iter().any(|fault| covers(fault, *code)), "the table does not know 4/{code}");
        let mut controller = controller(tags, rungs);
        let stopped = controller.scan(0).stopped;
        let found = stopped.and_then(|reason| match reason {
            StopReason::Recoverable(fault) => Some(fault.code),
            StopReason::Safety(_) | StopReason::PartnershipLost => None,
        });
        assert_eq!(found, Some(*code), "{rungs}: {stopped:?}");
        let (primary, partner) = controller.channels_mut();
        let records = (primary.fault_record(ProgramIndex(0)), partner.fault_record(ProgramIndex(0)));
        assert_eq!(records.0, records.1);
        assert_eq!(records.0.unwrap()[2], i32::from(*code) << 16 | 4, "{rungs}");
    }
}

/// REQ-FAULT-006. Minor faults stop nothing, and are counted.
#[test]
fn minor_fault_when_a_result_does_not_fit_then_it_is_counted_and_the_scan_goes_on() {
    let minor: Vec<u16> = RUNTIME_FAULTS
        .iter()
        .filter(|fault| fault.minor && fault.raised == Raised::ByLogic)
        .map(|fault| fault.first)
        .collect();
    assert_eq!(minor, [4]);
    let mut controller = controller("Sum : DINT (Class := Safety);", "N: ADD(2147483647,1,Sum);");
    assert_eq!(controller.scan(0).stopped, None);
    assert_eq!(controller.status().minor_faults, 1);
}

/// REQ-FAULT-007. What the controller raises has the type and code that the table lists, and each listed one is raised.
#[test]
fn safety_faults_when_their_codes_are_collected_then_they_are_those_of_the_table() {
    let place = Place { program: ProgramIndex(0), routine: RoutineIndex(0), rung: 0, element: 0 };
    let fault = MajorFault { code: 20, place };
    let reasons = [
        StopReason::Recoverable(fault),
        StopReason::PartnershipLost,
        StopReason::Safety(SafetyFault::Difference(Difference::Status)),
        StopReason::Safety(SafetyFault::WatchdogExpired),
        StopReason::Safety(SafetyFault::BudgetExceeded),
        StopReason::Safety(SafetyFault::ImageCorrupted),
        StopReason::Safety(SafetyFault::ChannelStopped),
        StopReason::Safety(SafetyFault::SecondComparison),
        StopReason::Safety(SafetyFault::NothingExecuted),
        StopReason::Safety(SafetyFault::VerdictIncomplete),
        StopReason::Safety(SafetyFault::OutputsDiffer),
        StopReason::Safety(SafetyFault::ControllerCorrupted),
    ];
    let found: BTreeSet<(u16, u16)> = reasons.into_iter().map(StopReason::type_and_code).collect();
    let by_controller = RUNTIME_FAULTS.iter().filter(|fault| fault.raised == Raised::ByController);
    let listed: BTreeSet<(u16, u16)> = by_controller.map(|fault| (fault.fault_type, fault.first)).collect();
    assert_eq!(found, listed);
}

/// REQ-FAULT-007. 1756-RM093 Nonrecoverable Controller Faults: nothing executes any more, and outputs are off.
#[test]
fn controller_when_its_partnership_is_lost_then_it_executes_nothing_more() {
    let mut controller = controller("Sum : DINT (Class := Safety);", "N: ADD(Sum,1,Sum);");
    assert_eq!(controller.scan(0).stopped, None);
    controller.lose_partnership();
    let report = controller.scan(100);
    assert_eq!((report.executed, report.stopped), (false, Some(StopReason::PartnershipLost)));
}
