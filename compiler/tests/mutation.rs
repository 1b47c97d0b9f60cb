//! Mutated projects: never a panic, and whatever is found correct compiles to an image that the loader admits.

mod support;

use support::read;
use twinrung_compiler::{Completion, check, compile};
use twinrung_grammar::tree::Sources;

const BASE: &str = r#"CONTROLLER Sample (ProcessorType := "1756-L73S", Major := 20, SafetyNetwork := 16#0000_0000_0001_0001)
  DATATYPE Axis_T
    BOOL Enabled;
    BOOL Homed;
    INT Speed;
    DINT Limits[4];
    TIMER Delay;
  END_DATATYPE
  DATATYPE Line_T
    CONNECTION_STATUS Status;
    BOOL Stop;
    DINT Count;
  END_DATATYPE
  ADD_ON_INSTRUCTION_DEFINITION Inner (Class := Safety)
    PARAMETERS
      Value : DINT (Usage := Input);
      Result : DINT (Usage := Output, Required := Yes);
      Stop : DCI_STOP (Usage := InOut);
    END_PARAMETERS
    LOCAL_TAGS
      Wait : TIMER;
      Own : DCI_STOP;
    END_LOCAL_TAGS
    ROUTINE Logic
      N: XIC(EnableIn)TON(Wait,250,0);
      N: DCS(Stop,E-STOP,EQUIVALENT - ACTIVE HIGH,500,MANUAL,MANUAL,Wait.DN,Wait.TT,1,Wait.EN);
      N: DCS(Own,1,0,500,0,0,Wait.DN,Wait.TT,1,Wait.EN);
      N: ADD(Value,1,Result);
    END_ROUTINE
  END_ADD_ON_INSTRUCTION_DEFINITION
  ADD_ON_INSTRUCTION_DEFINITION Outer (Class := Safety)
    PARAMETERS
      Start : BOOL (Usage := Input);
      Done : BOOL (Usage := Output, Required := Yes);
      Axes : Axis_T[2] (Usage := InOut);
      Stop : DCI_STOP (Usage := InOut);
    END_PARAMETERS
    LOCAL_TAGS
      Inner_1 : Inner;
      Table : DINT[3] := [1,2,3];
    END_LOCAL_TAGS
    ROUTINE Logic
      N: Inner(Inner_1,Table[1],Axes[1].Limits[0],Stop);
      N: XIC(Start)XIC(Axes[0].Enabled)OTE(Done);
    END_ROUTINE
    ROUTINE EnableInFalse
      N: OTU(Done);
    END_ROUTINE
  END_ADD_ON_INSTRUCTION_DEFINITION
  MODULE Rack (CatalogNumber := "1734-AENT", Parent := "Local", IPAddress := "192.168.1.10") END_MODULE
  MODULE Doors (CatalogNumber := "1734-IB8S", Parent := "Rack", Slot := 1, SafetyNetwork := 16#0000_0000_0001_0002, RPI := 10) END_MODULE
  MODULE Drives (CatalogNumber := "1734-OB8S", Parent := "Rack", Slot := 2, SafetyNetwork := 16#0000_0000_0001_0002) END_MODULE
  TAG
    A, B, C : DINT (Class := Safety);
    W : INT (Class := Safety) := -3;
    S : SINT (Class := Safety);
    R, Q : REAL (Class := Safety);
    X, Y, Z, Edge : BOOL (Class := Safety);
    T, U : TIMER (Class := Safety);
    N : COUNTER (Class := Safety);
    K : CONTROL (Class := Safety);
    V, V2 : DINT[11] (Class := Safety);
    Cube : INT[2,3,4] (Class := Safety);
    Bits : BOOL[64] (Class := Safety);
    Axis : Axis_T (Class := Safety) := [3,7,[1,2,3,4],[0,90,0]];
    Axes : Axis_T[2] (Class := Safety);
    Stop, Stop_2 : DCI_STOP (Class := Safety);
    Out_1 : Outer (Class := Safety);
    Label : STRING (Class := Safety) := [2,'Ab'];
    Panel : DINT;
    Mapped : DINT (Class := Safety, MappedFrom := Panel);
    Fixed : DINT (Class := Safety, Constant := Yes) := 9;
    Out_Line : Line_T (Class := Safety, Produced := 1, RPI := 20);
    In_Line : Line_T (Class := Safety, Producer := Other, RemoteTag := "Out_Line", RPI := 20);
    Door OF Doors:I.Pt00Data;
    Bit_5 OF A.5;
    Third OF V[3];
    Motor OF Drives:O.Pt00Data;
  END_TAG
  PROGRAM Safety_Main (Class := Safety, MAIN := "Main", FAULT := "Handler")
    TAG
      Local : DINT;
      Step : Axis_T;
    END_TAG
    ROUTINE Main
      N: XIC(Door)XIO(Doors:I.ConnectionFaulted)[XIC(X) ,XIO(Bits[A]) [XIC(Bit_5) ,] ]ONS(Edge)[OTE(Motor) ,OTL(Y) ];
      N: EQU(A,B)NEQ(A,-5)GRT(W,16#ff)LIM(1,A,10)MEQ(A,16#ff,B)CMP((A*2+1)>B)OTE(Z);
      N: CPT(R,ABS(Q)*1.5-SQR(R));
      N: XIC(X)TON(T,500,0);
      N: XIC(Y)TOF(U,?,?);
      N: CTU(N,10,0);
      N: RES(N);
      N: NEQ(B,0)[DIV(A,B,C) ,MOD(A,B,W) ];
      N: MVM(A,16#f,B)AND(A,S,C)NOT(W,A)CLR(S)SWPB(A,REVERSE,B);
      N: COP(V[0],V2[2],8)FLL(0,V[0],10)SIZE(Cube,1,A);
      N: COP(Axes[0],Axis,1);
      N: FAL(K,10,0,ALL,V2[K.POS],V[K.POS]+1);
      N: FSC(K,10,?,INC,V[K.POS]=7);
      N: MOV(Cube[1,A,B-1],Axis.Limits[Third])MOV(Label.LEN,Local);
      N: DCS(Stop,E-STOP,EQUIVALENT - ACTIVE HIGH,500,MANUAL,MANUAL,Doors:I.Pt00Data,Doors:I.Pt01Data,Doors:I.CombinedInputStatus,X);
      N: Outer(Out_1,Door,Y,Axes,Stop_2);
      N: XIC(In_Line.Stop)XIO(In_Line.Status.ConnectionFaulted)OTE(Out_Line.Stop);
      N: XIC(In_Line.Stop)ADD(Mapped,Fixed,Out_Line.Count)GSV(TASK,Safety_Task,Rate,A)XIC(S:FS)OTE(X);
      N: XIC(X)JSR(Part,2,5,Step,A);
      N: XIC(Y)JMP(Skip);
      N: XIC(X)MCR();
      N: MCR();
      N: LBL(Skip)NOP();
    END_ROUTINE
    ROUTINE Part
      N: SBR(Local,Step)MOV(Local,Step.Speed);
      N: RET(Local);
    END_ROUTINE
    ROUTINE Handler
      N: GSV(PROGRAM,THIS,MajorFaultRecord,V[0])AFI();
    END_ROUTINE
  END_PROGRAM
  PROGRAM Panel_Main (MAIN := "Main")
    ROUTINE Main
      N: ADD(A,1,Panel);
    END_ROUTINE
  END_PROGRAM
  TASK Safety_Task (Type := PERIODIC, Class := Safety, Rate := 20, Watchdog := 20, Priority := 5)
    Safety_Main;
  END_TASK
END_CONTROLLER
"#;

struct Random(u64);

impl Random {
    fn below(&mut self, bound: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as usize % bound.max(1)
    }
}

/// The words and marks of a text, with where they stand.
fn tokens(text: &str) -> Vec<(usize, usize)> {
    let mut list = Vec::new();
    let mut begin = 0;
    let kind = |byte: u8| if byte.is_ascii_alphanumeric() || byte == b'_' { 1 } else { 0 };
    let bytes = text.as_bytes();
    for at in 1..=bytes.len() {
        if at == bytes.len() || kind(bytes[at]) != kind(bytes[at - 1]) || kind(bytes[at]) == 0 {
            list.push((begin, at));
            begin = at;
        }
    }
    list
}

/// Replaces a token or two by others of the same text, or leaves one out.
fn mutate(random: &mut Random) -> String {
    let mut text = BASE.to_owned();
    for _ in 0..=random.below(2) {
        let tokens = tokens(&text);
        let words: Vec<_> = tokens
            .iter()
            .filter(|(a, b)| text[*a..*b].bytes().all(|byte| byte.is_ascii_alphanumeric() || byte == b'_'))
            .collect();
        let (begin, end) = *words[random.below(words.len())];
        let replacement = match random.below(6) {
            0 => String::new(),
            1 => ["0", "1", "-1", "10", "16#ffff_ffff", "2147483647", "?", "1.5", "ALL", "32"][random.below(10)]
                .to_owned(),
            _ => {
                let (a, b) = *words[random.below(words.len())];
                text[a..b].to_owned()
            }
        };
        text.replace_range(begin..end, &replacement);
    }
    text
}

/// What a text comes to: refused, or admitted.
fn outcome(text: &str) -> Result<bool, String> {
    let mut sources = Sources::new();
    let reading = read(&mut sources, "mutant.rll", text);
    let checked = check(&reading, &Completion::default());
    let Some(project) = checked.project else {
        return if checked.findings.iter().any(|finding| finding.is_error()) {
            Ok(false)
        } else {
            Err("refused without an error".to_owned())
        };
    };
    let compiled = compile(&project).map_err(|finding| finding.message)?;
    twinrung_bytecode::admit(&compiled.bytes).map(|_| true).map_err(|error| error.to_string())
}

/// How many mutants; more by TWINRUNG_MUTANTS for a longer search.
fn count() -> usize {
    std::env::var("TWINRUNG_MUTANTS").ok().and_then(|text| text.parse().ok()).unwrap_or(1_000)
}

#[test]
fn project_when_mutated_then_refused_or_admitted() {
    let mut random = Random(0x2545_F491_4F6C_DD1D);
    let mut admitted = 0;
    let mut faults = Vec::new();
    for number in 0..count() {
        let text = mutate(&mut random);
        match outcome(&text) {
            Ok(result) => admitted += usize::from(result),
            Err(error) => faults.push(format!("mutant {number}: {error}\n{}", changes(&text))),
        }
    }
    assert!(faults.is_empty(), "{} of {admitted}:\n{}", faults.len(), faults.join("\n"));
    assert!(admitted > 0);
}

/// The lines of a mutant that differ from the base.
fn changes(text: &str) -> String {
    let base: std::collections::HashSet<&str> = BASE.lines().collect();
    text.lines().filter(|line| !base.contains(line)).map(|line| format!("{line}\n")).collect()
}

/// A partial export with changed bytes, completed by its rack: refused or admitted as well.
#[test]
fn export_when_bytes_are_changed_then_refused_or_admitted() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../shared/corpus/acd-l5x-tool-lib");
    let Ok(program) = std::fs::read(folder.join("SafetyProgram_Program.L5X")) else {
        println!("skipped: {} is not there", folder.display());
        return;
    };
    let mut random = Random(0x9E37_79B9_7F4A_7C15);
    let mut faults = Vec::new();
    let mut admitted = 0;
    for number in 0..count() / 20 {
        let mut bytes = program.clone();
        for _ in 0..=random.below(3) {
            let at = random.below(bytes.len());
            let from = random.below(bytes.len());
            bytes[at] = bytes[from];
        }
        let mut sources = Sources::new();
        let reading = twinrung_grammar::read(&mut sources, "mutant.L5X", bytes);
        let rack = twinrung_grammar::read_path(&mut sources, &folder.join("ENET_ECP103_A_0_Module.L5X"));
        let completion = Completion {
            controller: Some("1756-L84ES".to_owned()),
            revision: Some(35),
            period_ms: Some(20),
            watchdog_ms: None,
            contexts: vec![rack.file],
            ..Completion::default()
        };
        let Some(project) = check(&reading, &completion).project else { continue };
        let result = compile(&project).map_err(|finding| finding.message);
        match result.and_then(|image| twinrung_bytecode::admit(&image.bytes).map_err(|error| error.to_string())) {
            Ok(_) => admitted += 1,
            Err(error) => faults.push(format!("mutant {number}: {error}")),
        }
    }
    assert!(faults.is_empty(), "{} of {admitted}:\n{}", faults.len(), faults.join("\n"));
    assert!(admitted > 0);
}

#[test]
fn project_when_not_mutated_then_no_errors() {
    let mut sources = Sources::new();
    let reading = read(&mut sources, "base.rll", BASE);
    let checked = check(&reading, &Completion::default());
    let errors: Vec<String> =
        checked.findings.iter().filter(|finding| finding.is_error()).map(|finding| finding.message.clone()).collect();
    assert_eq!(errors, Vec::<String>::new());
}
