//! A whole program: types, Add-On Instructions, tags, programs with their routines, tasks.

use std::collections::HashSet;

use twinrung_catalog::Element;
use twinrung_catalog::instructions::ALL;

use super::data::{Kind, Member, Names, Record, Role, Variable};
use super::palette::Palette;
use super::random::Random;
use super::writer::{AddOn, Parameter, Passing, Shared, Subroutine, Writer};
use super::{Actor, Generated, Input, Size, literals, text};

const BOOL: Kind = Kind::Element(Element::Bool);
const SINT: Kind = Kind::Element(Element::Sint);
const INT: Kind = Kind::Element(Element::Int);
const DINT: Kind = Kind::Element(Element::Dint);
const REAL: Kind = Kind::Element(Element::Real);

/// The position of the data type that holds a timer of TOF.
const OFF: usize = 3;

/// How the names of InOut parameters begin.
pub const IN_OUT: &str = "Passed";

/// The program of a seed.
pub fn program(seed: u64, size: Size) -> Generated {
    program_of(&mut Random::new(seed), size)
}

/// The program that these choices make.
pub fn program_of(random: &mut Random, size: Size) -> Generated {
    let mut shared = Shared { records: records(random), palette: Palette::of(random), ..Shared::default() };
    shared.event_tasks = ["Report", "Log"].iter().take(random.between(1, 2)).map(|name| (*name).to_owned()).collect();
    let programs = random.between(1, size.programs);
    shared.programs =
        ["Safety_Main", "Safety_Second", "Safety_Third"].iter().take(programs).map(|name| (*name).to_owned()).collect();
    let add_ons: Vec<String> =
        (0..random.between(0, size.add_ons)).map(|number| add_on(random, &mut shared, number)).collect();
    random.gene();
    let mut outer = Names::default();
    let mut inputs = controller_tags(random, &mut outer, &shared.records);
    let (mut body, mut actors) = (String::new(), Vec::new());
    for number in 0..programs {
        actors.extend(safety_program(random, &shared, &outer, number, size, &mut body));
    }
    // What nothing uses is left out: it would cost time and show nothing.
    for (own, add_on) in shared.add_ons.iter().zip(&add_ons).rev() {
        if text::words(&body).contains(own.name.as_str()) {
            body.insert_str(0, add_on);
        }
    }
    let mut tags = String::new();
    let kept = used(&outer.variables, &text::words(&body));
    text::tags(&mut tags, &kept, &shared.records, &shared.add_ons, " (Class := Safety)");
    inputs.retain(|input| {
        let base = input.name.split(['.', '[']).next();
        kept.iter().any(|one| Some(one.name.as_str()) == base)
    });
    let mut whole = String::new();
    text::line_of(
        &mut whole,
        0,
        "CONTROLLER Random_Program (ProcessorType := \"1756-L73S\", Major := 20, SafetyNetwork := 16#0000_0000_0001_0001)",
    );
    let mut types = String::new();
    let mut named = text::words(&tags);
    named.extend(text::words(&body));
    let mut named: HashSet<String> = named.into_iter().map(str::to_owned).collect();
    for record in shared.records.iter().rev() {
        if named.contains(&record.name) {
            let mut one = String::new();
            text::record(&mut one, record, &shared.records);
            named.extend(text::words(&one).into_iter().map(str::to_owned));
            types.insert_str(0, &one);
        }
    }
    whole.push_str(&types);
    // Add-On Instructions stand before the tags, programs behind them.
    let at = body.find("  PROGRAM ").unwrap_or(body.len());
    whole.push_str(&body[..at]);
    text::line_of(&mut whole, 2, "TAG");
    whole.push_str(&tags);
    text::line_of(&mut whole, 2, "END_TAG");
    whole.push_str(&body[at..]);
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
    Generated { text: whole, inputs, actors }
}

/// The variables that a text names, and those that these are aliases of.
fn used(variables: &[Variable], words: &HashSet<&str>) -> Vec<Variable> {
    let named: Vec<&Variable> = variables.iter().filter(|one| words.contains(one.name.as_str())).collect();
    let meant = |one: &&Variable| {
        let base = |alias: &String| alias.split(['.', '[']).next() == Some(one.name.as_str());
        named.iter().any(|other| other.name == one.name || other.alias.as_ref().is_some_and(base))
    };
    variables.iter().filter(meant).cloned().collect()
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
        member("Tally", Kind::Counter, 0),
        member("Search", Kind::Control, 0),
        member("Wait", Kind::Timer, 0),
        member("Waits", Kind::Timer, 2),
        member("Step", INT, 0),
        member("Grid", DINT, 4),
        member("Journal", DINT, 12),
        member("Exact", Kind::Record(0), 0),
        member("Level", REAL, 2),
    ];
    members.extend((0..random.between(1, 10)).map(|number| member(&format!("Bit{number}"), BOOL, 0)));
    for at in (1..members.len()).rev() {
        let other = random.below(at + 1);
        members.swap(at, other);
    }
    let off = Record { name: "Off".to_owned(), members: vec![member("Late", Kind::Timer, 0)] };
    let outer = Record { name: "Outer".to_owned(), members };
    // One for each type that backs a safety instruction: a member is as good a backing tag as a tag.
    let safety = ALL.iter().filter_map(|instruction| instruction.safety);
    let holders = safety.map(|safety| Record {
        name: format!("Holder_{}", safety.backing.name),
        members: vec![member("Count", DINT, 0), member("Held", Kind::Backing(safety.backing), 0)],
    });
    let mut records = vec![twelve, inner, outer, off];
    for holder in holders {
        if records.iter().all(|record| record.name != holder.name) {
            records.push(holder);
        }
    }
    records
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
    // The length of the last list, which is the one of REALs.
    let mut reals = 0;
    for element in [Element::Sint, Element::Int, Element::Dint, Element::Real] {
        for number in 0..3 {
            let name = format!("{}{number}", element.name());
            let name = name[..1].to_owned() + &name[1..].to_lowercase();
            drive(name.clone(), element, None);
            add(Variable::new(name, Kind::Element(element)).initial(initial(random, element)));
        }
        let length = random.between(4, 12) as u32;
        reals = length;
        add(Variable::new(format!("List_{}", element.name()), Kind::Element(element)).array([length, 0, 0]));
    }
    for (name, kind, dimensions) in [
        ("Plane", DINT, [3, 5, 0]),
        ("Solid", INT, [2, 3, 4]),
        ("Cube", REAL, [2, 2, 2]),
        ("Bytes", SINT, [4, 3, 0]),
        ("Journal", SINT, [48, 0, 0]),
        ("Records", INT, [24, 0, 0]),
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
    // A preset below 0 is a fault where the timer is reached, whoever set it.
    add(Variable::new("Timer", Kind::Timer).initial(if random.one_in(40) { "[0,-30,0]" } else { "[0,30,0]" }));
    if random.one_in(8) {
        drive("Timer.PRE".to_owned(), Element::Dint, None);
    }
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
        ("Alias_Exact", "Exacts[1]", Kind::Record(0)),
        ("Alias_Real", "Cube[0,1,0]", REAL),
        ("Alias_Half", "Solid[1,0,1]", INT),
        ("Alias_Byte", "Bytes[2,1]", SINT),
        ("Alias_Flag", "Bits[7]", BOOL),
        ("Alias_Timer", "Timers[1]", Kind::Timer),
        ("Alias_Counter", "Counters[2]", Kind::Counter),
        ("Alias_Control", "Controls[1]", Kind::Control),
    ] {
        add(Variable { alias: Some(target.to_owned()), ..Variable::new(name, kind) });
    }
    // Timers that nothing but TOF writes: RES must not name them.
    add(Variable::new("Off_Timers", Kind::Timer).array([3, 0, 0]).role(Role::Owned));
    add(Variable::new("Off_One", Kind::Record(OFF)).role(Role::Owned));
    let off = Variable::new("Off_Alias", Kind::Timer).role(Role::Owned);
    add(Variable { alias: Some("Off_Timers[2]".to_owned()), ..off });
    for (name, target, kind, length) in [
        ("Alias_List", "Words", DINT, 14),
        ("Alias_Exacts", "Exacts", Kind::Record(0), 4),
        ("Alias_Reals", "List_REAL", REAL, 0),
    ] {
        let length = if length > 0 { length } else { reals };
        let whole = Variable::new(name, kind).array([length, 0, 0]);
        add(Variable { alias: Some(target.to_owned()), ..whole });
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
        near_bits: Vec::new(),
        owned: Vec::new(),
        passed_off: Vec::new(),
        reset: Vec::new(),
        instances: Vec::new(),
        scope: None,
        actors: Vec::new(),
        passed_backings: Vec::new(),
        control: None,
    }
}

fn passed_kind(random: &mut Random) -> Kind {
    *random.of(&[BOOL, SINT, INT, DINT, DINT, REAL, REAL, Kind::Record(0), Kind::Record(1), Kind::Timer])
}

fn safety_program(
    random: &mut Random,
    shared: &Shared,
    outer: &Names,
    number: usize,
    size: Size,
    body: &mut String,
) -> Vec<Actor> {
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
    random.gene();
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
    writer.scope = Some(format!("Program:{}.", shared.programs[number]));
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
        writer.random.gene();
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
    let actors = std::mem::take(&mut writer.actors);
    let mut rungs = String::new();
    routines.iter().for_each(|(name, list)| text::routine(&mut rungs, name, list));
    let kept = used(&own.variables, &text::words(&rungs));
    let fault = if has_fault_routine { ", FAULT := \"Handler\"" } else { "" };
    text::line_of(body, 2, &format!("PROGRAM {} (Class := Safety, MAIN := \"Main\"{fault})", shared.programs[number]));
    text::line_of(body, 4, "TAG");
    text::tags(body, &kept, &shared.records, &shared.add_ons, "");
    text::line_of(body, 4, "END_TAG");
    body.push_str(&rungs);
    text::line_of(body, 2, "END_PROGRAM");
    actors
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

/// The text of an Add-On Instruction.
fn add_on(random: &mut Random, shared: &mut Shared, number: usize) -> String {
    random.gene();
    let mut text = String::new();
    let body = &mut text;
    let name = format!("Own_Instruction{number}");
    let mut own = Names::default();
    let mut parameters = Vec::new();
    let mut lines = Vec::new();
    for at in 0..random.between(1, 5) {
        let passing = *random.of(&[Passing::Input, Passing::Input, Passing::Output, Passing::InOut, Passing::InOut]);
        let (kind, dimensions) = match passing {
            Passing::InOut if random.percent(15) => {
                let safety: Vec<_> = ALL.iter().filter_map(|instruction| instruction.safety).collect();
                (Kind::Backing(random.of(&safety).backing), [0; 3])
            }
            Passing::InOut => *random.of(&[
                (DINT, [0; 3]),
                (INT, [0; 3]),
                (SINT, [0; 3]),
                (REAL, [0; 3]),
                (Kind::Counter, [0; 3]),
                (Kind::Control, [0; 3]),
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
        let name = if passing == Passing::InOut { format!("{IN_OUT}{at}") } else { format!("Given{at}") };
        let parameter = Parameter { name, kind, dimensions, passing };
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
        ("Local_List", DINT, [12, 0, 0], Role::Data),
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
    let mut rungs = String::new();
    routines.iter().for_each(|(name, list)| text::routine(&mut rungs, name, list));
    let kept = used(&own.variables[declared..], &text::words(&rungs));
    text::tags(body, &kept, &shared.records, &shared.add_ons, "");
    text::line_of(body, 4, "END_LOCAL_TAGS");
    body.push_str(&rungs);
    text::line_of(body, 2, "END_ADD_ON_INSTRUCTION_DEFINITION");
    let named = text::words(&rungs);
    let guards = ALL.iter().any(|one| one.safety.is_some() && named.contains(one.mnemonic))
        || shared.add_ons.iter().any(|one| one.guards && named.contains(one.name.as_str()));
    shared.add_ons.push(AddOn { name, parameters, guards });
    text
}
