//! A whole program: types, Add-On Instructions, tags, programs with their routines, tasks.

use twinrung_catalog::Element;

use super::data::{Kind, Member, Names, Record, Role, Variable};
use super::random::Random;
use super::writer::{AddOn, Parameter, Passing, Shared, Subroutine, Writer};
use super::{Generated, Input, Size, literals, text};

const BOOL: Kind = Kind::Element(Element::Bool);
const SINT: Kind = Kind::Element(Element::Sint);
const INT: Kind = Kind::Element(Element::Int);
const DINT: Kind = Kind::Element(Element::Dint);
const REAL: Kind = Kind::Element(Element::Real);

/// The program of a seed.
pub fn program(seed: u64, size: Size) -> Generated {
    program_of(&mut Random::new(seed), size)
}

/// The program that these choices make.
pub fn program_of(random: &mut Random, size: Size) -> Generated {
    let mut shared = Shared { records: records(random), ..Shared::default() };
    let mut body = String::new();
    let listed = shared.records.clone();
    listed.iter().for_each(|record| text::record(&mut body, record, &listed));
    shared.event_tasks = ["Report", "Log"].iter().take(random.between(1, 2)).map(|name| (*name).to_owned()).collect();
    let programs = random.between(1, size.programs);
    shared.programs =
        ["Safety_Main", "Safety_Second", "Safety_Third"].iter().take(programs).map(|name| (*name).to_owned()).collect();
    for number in 0..random.between(0, size.add_ons) {
        add_on(random, &mut shared, number, &mut body);
    }
    let mut outer = Names::default();
    let inputs = controller_tags(random, &mut outer, &shared.records);
    text::line_of(&mut body, 2, "TAG");
    text::tags(&mut body, &outer.variables, &shared.records, &shared.add_ons, " (Class := Safety)");
    text::line_of(&mut body, 2, "END_TAG");
    for number in 0..programs {
        safety_program(random, &shared, &outer, number, size, &mut body);
    }
    let mut whole = String::new();
    text::line_of(
        &mut whole,
        0,
        "CONTROLLER Random_Program (ProcessorType := \"1756-L73S\", Major := 20, SafetyNetwork := 16#0000_0000_0001_0001)",
    );
    whole.push_str(&body);
    text::line_of(
        &mut whole,
        2,
        "TASK Safety_Task (Type := PERIODIC, Class := Safety, Rate := 10, Watchdog := 10, Priority := 5)",
    );
    shared.programs.iter().for_each(|name| text::line_of(&mut whole, 4, &format!("{name};")));
    text::line_of(&mut whole, 2, "END_TASK");
    for task in &shared.event_tasks {
        let line = format!(
            "TASK {task} (Type := EVENT, EventTrigger := \"EVENT Instruction Only\", Priority := 10, Watchdog := 500) END_TASK"
        );
        text::line_of(&mut whole, 2, &line);
    }
    text::line_of(&mut whole, 0, "END_CONTROLLER");
    Generated { text: whole, inputs }
}

/// Data types: one with the size of a TIMER, one with a packed bit and arrays, one that nests both.
fn records(random: &mut Random) -> Vec<Record> {
    let member = |name: &str, kind: Kind, length: u32| Member { name: name.to_owned(), kind, length };
    let twelve = Record {
        name: "Twelve".to_owned(),
        members: vec![
            member("Whole", DINT, 0),
            member("Half", INT, 2),
            member("First", BOOL, 0),
            member("Second", BOOL, 0),
        ],
    };
    let inner = Record {
        name: "Inner".to_owned(),
        members: vec![
            member("Speed", REAL, 0),
            member("Flags", BOOL, 32),
            member("Ready", BOOL, 0),
            member("Small", SINT, 3),
        ],
    };
    let mut members = vec![
        member("Parts", Kind::Record(1), 2),
        member("Wait", Kind::Timer, 0),
        member("Waits", Kind::Timer, 2),
        member("Step", INT, 0),
        member("Grid", DINT, 4),
        member("Exact", Kind::Record(0), 0),
        member("Level", REAL, 2),
    ];
    members.extend((0..random.between(1, 10)).map(|number| member(&format!("Bit{number}"), BOOL, 0)));
    for at in (1..members.len()).rev() {
        let other = random.below(at + 1);
        members.swap(at, other);
    }
    vec![twelve, inner, Record { name: "Outer".to_owned(), members }]
}

fn controller_tags(random: &mut Random, names: &mut Names, records: &[Record]) -> Vec<Input> {
    let mut inputs = Vec::new();
    let mut drive = |name: String, element: Element, bound: Option<u32>| inputs.push(Input { name, element, bound });
    let mut add = |variable: Variable| names.add(variable, records);
    for number in 0..8 {
        add(Variable::new(format!("In{number}"), BOOL));
        drive(format!("In{number}"), Element::Bool, None);
        add(Variable::new(format!("Out{number}"), BOOL));
    }
    for element in [Element::Sint, Element::Int, Element::Dint, Element::Real] {
        for number in 0..3 {
            let name = format!("{}{number}", element.name());
            let name = name[..1].to_owned() + &name[1..].to_lowercase();
            drive(name.clone(), element, None);
            add(Variable::new(name, Kind::Element(element)).initial(initial(random, element)));
        }
        let length = random.between(4, 12) as u32;
        add(Variable::new(format!("List_{}", element.name()), Kind::Element(element)).array([length, 0, 0]));
    }
    for (name, kind, dimensions) in [
        ("Plane", DINT, [3, 5, 0]),
        ("Solid", INT, [2, 3, 4]),
        ("Cube", REAL, [2, 2, 2]),
        ("Bytes", SINT, [4, 3, 0]),
        ("Words", DINT, [14, 0, 0]),
        ("Bits", BOOL, [64, 0, 0]),
        ("Timers", Kind::Timer, [4, 0, 0]),
        ("Counters", Kind::Counter, [3, 0, 0]),
        ("Controls", Kind::Control, [2, 0, 0]),
        ("Exacts", Kind::Record(0), [4, 0, 0]),
        ("Inners", Kind::Record(1), [3, 0, 0]),
        ("Outers", Kind::Record(2), [2, 2, 0]),
    ] {
        add(Variable::new(name, kind).array(dimensions));
    }
    add(Variable::new("Timer", Kind::Timer).initial("[0,30,0]"));
    add(Variable::new("Counter", Kind::Counter).initial("[0,2,2147483645]"));
    add(Variable::new("Control", Kind::Control).initial("[0,3,0]"));
    add(Variable::new("Exact", Kind::Record(0)));
    add(Variable::new("Inner_One", Kind::Record(1)));
    add(Variable::new("Outer_One", Kind::Record(2)));
    for (name, element) in [
        ("Timer.EN", Element::Bool),
        ("Timer.DN", Element::Bool),
        ("Control.IN", Element::Bool),
        ("Control.ER", Element::Bool),
        ("Control.EN", Element::Bool),
        ("Outer_One.Level[1]", Element::Real),
        ("Cube[1,0,1]", Element::Real),
        ("Solid[1,2,3]", Element::Int),
        ("Plane[0,0]", Element::Dint),
    ] {
        drive(name.to_owned(), element, None);
    }
    for (name, element, bound) in [
        ("At2", Element::Dint, 2),
        ("At3", Element::Sint, 3),
        ("At4", Element::Int, 4),
        ("At4_Too", Element::Dint, 4),
        ("At8", Element::Dint, 8),
    ] {
        drive(name.to_owned(), element, Some(bound));
        add(Variable::new(name, Kind::Element(element)).role(Role::Index(bound)));
    }
    for number in 0..3 {
        drive(format!("Places[{number}]"), Element::Dint, Some(3));
    }
    add(Variable::new("Places", DINT).array([3, 0, 0]).role(Role::Index(3)));
    for (name, target, kind) in [
        ("Alias_Word", "Plane[1,2]", DINT),
        ("Alias_Bit", "Dint0.17", BOOL),
        ("Alias_Part", "Outer_One.Parts[1]", Kind::Record(1)),
    ] {
        add(Variable { alias: Some(target.to_owned()), ..Variable::new(name, kind) });
    }
    inputs
}

fn initial(random: &mut Random, element: Element) -> String {
    match element {
        Element::Bool => random.below(2).to_string(),
        Element::Sint => (literals::integer(random) as i8).to_string(),
        Element::Int => (literals::integer(random) as i16).to_string(),
        Element::Dint => literals::integer(random).to_string(),
        Element::Real => literals::real_text(random),
    }
}

/// A writer of a program's or Add-On Instruction's routines; numbers of fresh names are kept between routines by the caller.
fn writer<'w>(random: &'w mut Random, shared: &'w Shared, outer: &'w Names, own: &'w mut Names) -> Writer<'w> {
    Writer {
        random,
        shared,
        outer,
        own,
        subroutines: Vec::new(),
        returns: Vec::new(),
        fault_routine: None,
        in_add_on: false,
        pending_labels: Vec::new(),
        fresh: 0,
        off_timers: Vec::new(),
        instances: Vec::new(),
        control: None,
    }
}

fn passed_kind(random: &mut Random) -> Kind {
    *random.of(&[BOOL, SINT, INT, DINT, DINT, REAL, REAL, Kind::Record(0), Kind::Record(1), Kind::Timer])
}

fn safety_program(random: &mut Random, shared: &Shared, outer: &Names, number: usize, size: Size, body: &mut String) {
    let mut own = Names::default();
    for (name, kind, dimensions) in [
        ("Own_Bit", BOOL, [0; 3]),
        ("Own_Word", DINT, [0; 3]),
        ("Own_Half", INT, [0; 3]),
        ("Own_Real", REAL, [0; 3]),
        ("Own_List", DINT, [12, 0, 0]),
        ("Own_Timer", Kind::Timer, [0; 3]),
        ("Own_Record", Kind::Record(2), [0; 3]),
        // A tag of the controller that this one hides.
        ("Dint2", DINT, [0; 3]),
    ] {
        own.add(Variable::new(name, kind).array(dimensions), &shared.records);
    }
    own.add(Variable::new("Zero", DINT).array([11, 0, 0]).role(Role::Owned), &shared.records);
    own.add(Variable::new("Fault_Record", DINT).array([11, 0, 0]).role(Role::Owned), &shared.records);
    // The controller's tag of that name is out of reach here.
    let mut outer = outer.clone();
    outer.places.retain(|place| place.base != "Dint2");
    outer.variables.retain(|one| one.name != "Dint2");
    let subroutines: Vec<Subroutine> = (0..random.between(0, size.subroutines))
        .map(|at| Subroutine {
            name: format!("Part{at}"),
            receives: (0..random.below(4)).map(|_| passed_kind(random)).collect(),
            returns: (0..random.below(3)).map(|_| passed_kind(random)).collect(),
        })
        .collect();
    let has_fault_routine = random.percent(60);
    let clears = random.below(4);
    let mut writer = writer(random, shared, &outer, &mut own);
    writer.fault_routine = has_fault_routine.then(|| "Handler".to_owned());
    let mut routines: Vec<(String, Vec<String>)> = Vec::new();
    writer.subroutines = subroutines.clone();
    let mut main = Vec::new();
    if !subroutines.is_empty() {
        // A subroutine that nothing calls would test nothing.
        let call = writer.call(twinrung_catalog::Opcode::Jsr.instruction());
        main.extend(call.map(|call| format!("{}{call}", writer.input())));
    }
    let rungs = writer.random.between(size.rungs / 2, size.rungs);
    main.extend(writer.rungs(rungs));
    routines.push(("Main".to_owned(), main));
    for (at, subroutine) in subroutines.iter().enumerate() {
        writer.subroutines = subroutines[at + 1..].to_vec();
        writer.returns = subroutine.returns.clone();
        let mut list = received(&mut writer, subroutine);
        let rungs = writer.random.between(1, (size.rungs / 4).max(2));
        list.extend(writer.rungs(rungs));
        let return_call = writer.call(twinrung_catalog::Opcode::Ret.instruction());
        list.extend(
            return_call.map(|call| if writer.random.percent(30) { format!("{}{call}", writer.input()) } else { call }),
        );
        routines.push((subroutine.name.clone(), list));
    }
    if has_fault_routine {
        writer.subroutines = Vec::new();
        writer.returns = Vec::new();
        let before = writer.random.below(3);
        let mut list = if before > 0 { writer.rungs(before) } else { Vec::new() };
        list.push("GSV(PROGRAM,THIS,MajorFaultRecord,Fault_Record[0])".to_owned());
        list.push("ADD(Own_Word,1,Own_Word)".to_owned());
        let clear = "SSV(PROGRAM,THIS,MajorFaultRecord,Zero[0])";
        match clears {
            0 => {}
            1 => list.push(format!("XIC(In0){clear}")),
            2 => list.push("CLR(Fault_Record[2])SSV(PROGRAM,THIS,MajorFaultRecord,Fault_Record[0])".to_owned()),
            _ => list.push(clear.to_owned()),
        }
        routines.push(("Handler".to_owned(), list));
    }
    let fault = if has_fault_routine { ", FAULT := \"Handler\"" } else { "" };
    text::line_of(body, 2, &format!("PROGRAM {} (Class := Safety, MAIN := \"Main\"{fault})", shared.programs[number]));
    text::line_of(body, 4, "TAG");
    text::tags(body, &own.variables, &shared.records, &shared.add_ons, "");
    text::line_of(body, 4, "END_TAG");
    routines.iter().for_each(|(name, rungs)| text::routine(body, name, rungs));
    text::line_of(body, 2, "END_PROGRAM");
}

/// The rung that receives the inputs of a subroutine.
fn received(writer: &mut Writer<'_>, subroutine: &Subroutine) -> Vec<String> {
    if subroutine.receives.is_empty() {
        return Vec::new();
    }
    let mut operands = Vec::new();
    for kind in &subroutine.receives {
        let operand = if writer.random.percent(30) { writer.passed(*kind, true) } else { None };
        operands.push(match operand {
            Some(operand) => operand,
            None => writer.declare("Received", *kind, Role::Data),
        });
    }
    let after = writer.output();
    vec![format!("SBR({}){after}", operands.join(","))]
}

fn add_on(random: &mut Random, shared: &mut Shared, number: usize, body: &mut String) {
    let name = format!("Own_Instruction{number}");
    let mut own = Names::default();
    let mut parameters = Vec::new();
    let mut lines = Vec::new();
    for at in 0..random.between(1, 5) {
        let passing = *random.of(&[Passing::Input, Passing::Input, Passing::Output, Passing::InOut]);
        let (kind, dimensions) = match passing {
            Passing::InOut => *random.of(&[
                (DINT, [0; 3]),
                (DINT, [4, 0, 0]),
                (REAL, [2, 2, 2]),
                (INT, [2, 3, 4]),
                (Kind::Record(1), [0; 3]),
                (Kind::Record(0), [3, 0, 0]),
                (Kind::Timer, [0; 3]),
                (Kind::Timer, [2, 0, 0]),
                (BOOL, [32, 0, 0]),
                (BOOL, [0; 3]),
            ]),
            _ => (*random.of(&[BOOL, BOOL, SINT, INT, DINT, REAL]), [0; 3]),
        };
        let parameter = Parameter { name: format!("Given{at}"), kind, dimensions, passing };
        let usage = format!("{passing:?}");
        lines.push(format!(
            "{} : {}{} (Usage := {usage}, Required := Yes, Visible := Yes);",
            parameter.name,
            text::type_name(kind, &shared.records, &shared.add_ons),
            text::sizes_text(dimensions)
        ));
        let role = if passing == Passing::Input { Role::Owned } else { Role::Data };
        own.add(Variable::new(parameter.name.clone(), kind).array(dimensions).role(role), &shared.records);
        parameters.push(parameter);
    }
    let declared = own.variables.len();
    for (name, kind, dimensions, role) in [
        ("Bit", BOOL, [0; 3], Role::Data),
        ("Byte", SINT, [0; 3], Role::Data),
        ("Half", INT, [0; 3], Role::Data),
        ("Whole", DINT, [0; 3], Role::Data),
        ("Exact", REAL, [0; 3], Role::Data),
        ("Local_List", DINT, [5, 0, 0], Role::Data),
        ("Local_Timers", Kind::Timer, [2, 0, 0], Role::Data),
        ("Local_Counter", Kind::Counter, [0; 3], Role::Data),
        ("Local_Control", Kind::Control, [0; 3], Role::Data),
        ("Local_Record", Kind::Record(0), [0; 3], Role::Data),
        // Stays 0: nothing writes it.
        ("Local_At", DINT, [0; 3], Role::Index(2)),
    ] {
        own.add(Variable::new(name, kind).array(dimensions).role(role), &shared.records);
    }
    // The two bits that every instance has; they are not declared.
    let mut hidden = Names::default();
    hidden.add(Variable::new("EnableIn", BOOL).role(Role::Owned), &shared.records);
    hidden.add(Variable::new("EnableOut", BOOL), &shared.records);
    let (in_false, prescan) = (random.percent(40), random.percent(40));
    let counts = [random.between(2, 8), random.between(1, 4), random.between(1, 4)];
    let mut writer = writer(random, shared, &hidden, &mut own);
    writer.in_add_on = true;
    let mut routines = vec![("Logic", writer.rungs(counts[0]))];
    if in_false {
        routines.push(("EnableInFalse", writer.rungs(counts[1])));
    }
    if prescan {
        routines.push(("Prescan", writer.rungs(counts[2])));
    }
    let yes = |is: bool| if is { "Yes" } else { "No" };
    text::line_of(
        body,
        2,
        &format!(
            "ADD_ON_INSTRUCTION_DEFINITION {name} (Class := Safety, Revision := \"1.0\", ExecutePrescan := {}, ExecuteEnableInFalse := {})",
            yes(prescan),
            yes(in_false)
        ),
    );
    text::line_of(body, 4, "PARAMETERS");
    lines.iter().for_each(|line| text::line_of(body, 6, line));
    text::line_of(body, 4, "END_PARAMETERS");
    text::line_of(body, 4, "LOCAL_TAGS");
    text::tags(body, &own.variables[declared..], &shared.records, &shared.add_ons, "");
    text::line_of(body, 4, "END_LOCAL_TAGS");
    routines.iter().for_each(|(name, rungs)| text::routine(body, name, rungs));
    text::line_of(body, 2, "END_ADD_ON_INSTRUCTION_DEFINITION");
    shared.add_ons.push(AddOn { name, parameters });
}
