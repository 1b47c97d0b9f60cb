//! Which controllers admit which base instruction, as the catalog declares.

use twinrung_catalog::{Controller, Instruction, Requires, instructions};
use twinrung_trio::Subject;

/// Controllers and revisions on which every instruction is tried: both sides of each restriction of Table 12.
pub const CONTROLLERS: &[(&str, u16)] = &[
    ("1756-L61S", 14),
    ("1756-L61S", 16),
    ("1756-L63S", 17),
    ("1756-L63S", 20),
    ("1768-L43S", 18),
    ("1768-L43S", 20),
    ("1756-L73S", 20),
];

/// Controllers and revisions that do not exist: nothing is admitted.
pub const UNKNOWN: &[(&str, u16)] =
    &[("1756-L61S", 15), ("1756-L63S", 14), ("1756-L63S", 21), ("1756-L73S", 19), ("1756-L63", 20)];

/// A rung with each base instruction, and other lines that it needs: rungs begin with `N:`, a routine with `ROUTINE`.
const RUNGS: &[(&str, &str)] = &[
    ("XIC", "XIC(A)OTE(B)"),
    ("XIO", "XIO(A)OTE(B)"),
    ("OTE", "OTE(B)"),
    ("OTL", "OTL(B)"),
    ("OTU", "OTU(B)"),
    ("ONS", "ONS(A)OTE(B)"),
    ("OSR", "OSR(A,B)"),
    ("OSF", "OSF(A,B)"),
    ("TON", "TON(T,?,?)"),
    ("TOF", "TOF(T,?,?)"),
    ("RTO", "RTO(T,?,?)"),
    ("CTU", "CTU(C,?,?)"),
    ("CTD", "CTD(C,?,?)"),
    ("RES", "RES(C)"),
    ("EQU", "EQU(X,Y)OTE(B)"),
    ("NEQ", "NEQ(X,Y)OTE(B)"),
    ("GRT", "GRT(X,Y)OTE(B)"),
    ("GEQ", "GEQ(X,Y)OTE(B)"),
    ("LES", "LES(X,Y)OTE(B)"),
    ("LEQ", "LEQ(X,Y)OTE(B)"),
    ("LIM", "LIM(0,X,5)OTE(B)"),
    ("MEQ", "MEQ(X,15,Y)OTE(B)"),
    ("CMP", "CMP(X > Y)OTE(B)"),
    ("MOV", "MOV(X,Y)"),
    ("MVM", "MVM(X,15,Y)"),
    ("CLR", "CLR(X)"),
    ("COP", "COP(X,Y,1)"),
    ("SWPB", "SWPB(X,WORD,Y)"),
    ("AND", "AND(X,Y,Z)"),
    ("OR", "OR(X,Y,Z)"),
    ("XOR", "XOR(X,Y,Z)"),
    ("NOT", "NOT(X,Y)"),
    ("ADD", "ADD(X,Y,Z)"),
    ("SUB", "SUB(X,Y,Z)"),
    ("MUL", "MUL(X,Y,Z)"),
    ("DIV", "DIV(X,Y,Z)"),
    ("MOD", "MOD(X,Y,Z)"),
    ("SQR", "SQR(X,Y)"),
    ("NEG", "NEG(X,Y)"),
    ("ABS", "ABS(X,Y)"),
    ("CPT", "CPT(X,Y + Z)"),
    ("FAL", "FAL(K,4,0,ALL,L[K.POS],X)"),
    ("FSC", "FSC(K,4,0,ALL,L[K.POS] = X)"),
    ("FLL", "FLL(X,L[0],4)"),
    ("SIZE", "SIZE(L,0,X)"),
    ("JMP", "XIC(A)JMP(Past); N: LBL(Past)NOP()"),
    ("LBL", "LBL(Here)NOP()"),
    ("JSR", "JSR(Sub,0); END_ROUTINE ROUTINE Sub N: NOP()"),
    ("SBR", "JSR(Sub,1,X); END_ROUTINE ROUTINE Sub N: SBR(Y)NOP()"),
    ("RET", "JSR(Sub,0); END_ROUTINE ROUTINE Sub N: RET()"),
    ("TND", "XIC(A)TND()"),
    ("MCR", "XIC(A)MCR(); N: OTE(B); N: MCR()"),
    ("AFI", "AFI()OTE(B)"),
    ("NOP", "NOP()"),
    ("EVENT", "XIC(A)EVENT(Report)"),
    ("GSV", "GSV(SAFETY,,SafetySignatureExists,S)"),
    ("SSV", "SSV(PROGRAM,THIS,MajorFaultRecord,M[0])"),
];

/// The base instructions of the catalog: all that no half of the safety library executes.
pub fn base_instructions() -> impl Iterator<Item = &'static Instruction> {
    instructions::ALL.iter().copied().filter(|instruction| !instruction.group.is_safety_library())
}

/// Every instruction and controller for which the compiler decides otherwise than the catalog declares.
pub fn failures() -> Vec<String> {
    let mut wrong = Vec::new();
    for instruction in base_instructions() {
        let Some((_, rungs)) = RUNGS.iter().find(|(mnemonic, _)| *mnemonic == instruction.mnemonic) else {
            wrong.push(format!("{} has no rung here", instruction.mnemonic));
            continue;
        };
        for (catalog_number, revision) in CONTROLLERS {
            let declared = declared(instruction, catalog_number, *revision);
            let found = Subject::from_text(&project(rungs, catalog_number, *revision)).map(|_| ());
            let place = format!("{} on {catalog_number}/{revision}", instruction.mnemonic);
            match (declared, found) {
                (true, Ok(())) => {}
                (true, Err(findings)) => {
                    wrong.push(format!("{place}: declared as admitted, refused: {}", findings.join("; ")))
                }
                (false, Ok(())) => wrong.push(format!("{place}: declared as refused, admitted")),
                (false, Err(findings)) if findings.iter().all(|finding| finding.starts_with("S0102")) => {}
                (false, Err(findings)) => {
                    wrong.push(format!("{place}: refused for another reason: {}", findings.join("; ")))
                }
            }
        }
    }
    for (catalog_number, revision) in UNKNOWN {
        let known = Controller::by_catalog_number(catalog_number);
        if known.is_some_and(|controller| controller.knows_revision(*revision)) {
            wrong.push(format!("the catalog knows {catalog_number}/{revision}"));
        }
        if Subject::from_text(&project("NOP()", catalog_number, *revision)).is_ok() {
            wrong.push(format!("NOP on {catalog_number}/{revision}: admitted on a controller that does not exist"));
        }
    }
    wrong
}

fn declared(instruction: &Instruction, catalog_number: &str, revision: u16) -> bool {
    let Some(controller) = Controller::by_catalog_number(catalog_number) else { return false };
    let offers = match instruction.requires {
        Requires::Any => true,
        Requires::L7x | Requires::Real => controller.has_real(),
    };
    offers && revision >= u16::from(instruction.first_version)
}

fn project(rungs: &str, catalog_number: &str, revision: u16) -> String {
    format!(
        "CONTROLLER Admission (ProcessorType := \"{catalog_number}\", Major := {revision}, SafetyNetwork := 16#0000_0000_0001_0001)
  TAG
    A, B : BOOL (Class := Safety);
    X, Y, Z : DINT (Class := Safety);
    L : DINT[4] (Class := Safety);
    M : DINT[11] (Class := Safety);
    S : SINT (Class := Safety);
    T : TIMER (Class := Safety);
    C : COUNTER (Class := Safety);
    K : CONTROL (Class := Safety);
  END_TAG
  PROGRAM P (Class := Safety, MAIN := \"Main\")
    ROUTINE Main
      N: {rungs};
    END_ROUTINE
  END_PROGRAM
  TASK Safety_Task (Type := PERIODIC, Class := Safety, Rate := 20, Watchdog := 20, Priority := 5) P; END_TASK
  TASK Report (Type := EVENT, EventTrigger := \"EVENT Instruction Only\", Priority := 10, Watchdog := 500) END_TASK
END_CONTROLLER
"
    )
}
