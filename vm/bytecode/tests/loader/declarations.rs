//! Rules of names, table order, controller, task, map, system values, types and Add-On Instructions.

use twinrung_bytecode::{admit_library, limits, seal};

use crate::support::samples::{Rich, SCALE, rich};
use crate::support::*;

/// The rule that refuses the rich sample after a change.
fn rule(change: impl FnOnce(&mut Rich)) -> &'static str {
    let mut r = rich();
    change(&mut r);
    r.b.rule()
}

fn program(name: &str) -> ProgramRecord {
    ProgramRecord { name: name.into(), main: None, fault: None, disabled: false }
}

fn module(name: &str) -> ModuleRecord {
    ModuleRecord { name: name.into(), text: String::new() }
}

#[test]
fn name_when_it_cannot_be_written_then_is_refused() {
    for name in ["", "1st", "a-b", "a b", "a,b", "a\n"] {
        assert_eq!(rule(|r| r.b.image.task.as_mut().unwrap().name = name.into()), "Name", "{name:?}");
    }
    assert_eq!(rule(|r| r.b.image.controller.name = "a.b".into()), "Name");
    assert_eq!(rule(|r| r.b.image.map[0].standard = "a=b".into()), "Name");
    assert_eq!(rule(|r| r.b.image.routines[0].name = "(".into()), "Name");
    assert_eq!(rule(|r| r.b.image.types[2].members[0].name = "A:B".into()), "Name");
    assert_eq!(rule(|r| r.b.image.modules[0].name = "N".repeat(limits::NAME_BYTES)), "admitted");
    assert_eq!(rule(|r| r.b.image.modules[0].name = "N".repeat(limits::NAME_BYTES + 1)), "Name");
}

#[test]
fn name_when_out_of_order_or_twice_then_is_refused() {
    assert_eq!(rule(|r| r.b.image.programs.push(program("Other"))), "admitted");
    assert_eq!(rule(|r| r.b.image.programs.push(program("Fill"))), "NameOrder");
    assert_eq!(rule(|r| r.b.image.programs.push(program("MAIN"))), "NameTwice");
    assert_eq!(rule(|r| r.b.image.modules.push(module("Late"))), "NameOrder");
    assert_eq!(rule(|r| r.b.image.event_tasks.push("REPORT".into())), "NameTwice");
    assert_eq!(rule(|r| r.b.image.types[2].members[1].name = "a".into()), "NameTwice");
    assert_eq!(rule(|r| r.b.image.routines[1].name = "main".into()), "NameTwice");
    assert_eq!(rule(|r| r.b.image.routines[1].name = "Aft".into()), "NameOrder");
    assert_eq!(rule(|r| r.b.image.add_ons[0].parameters[4].name = "GAIN".into()), "NameTwice");
}

#[test]
fn name_when_text_reads_it_as_something_else_then_is_refused() {
    assert_eq!(rule(|r| r.tag(r.tags.alias).name = "ABS".into()), "NameReserved");
    assert_eq!(rule(|r| r.b.image.types[2].name = "dint".into()), "NameReserved");
    assert_eq!(rule(|r| r.b.image.types[2].name = "Counter".into()), "NameReserved");
    assert_eq!(rule(|r| r.b.image.types[0].name = "timer".into()), "NameReserved");
    assert_eq!(rule(|r| r.b.image.add_ons[0].name = "Move".into()), "NameReserved");
    assert_eq!(rule(|r| r.b.image.add_ons[0].parameters[4].name = "mod".into()), "NameReserved");
}

#[test]
fn setting_when_it_could_be_read_as_two_then_is_refused() {
    let setting = |value: &str| rule(|r| r.b.image.controller.attributes = vec![("K".into(), value.into())]);
    assert_eq!(setting("16#00_ff -1.5 A/B"), "admitted");
    assert_eq!(setting("\"a, b := (c)\""), "admitted");
    for value in ["", "a, B := 1", "a)", "\"", "\"a\"b\"", "\"a\n\"", "a;"] {
        assert_eq!(setting(value), "AttributeKeys", "{value:?}");
    }
    let keys = |first: &str, second: &str| {
        let list = [first, second].map(|key| (key.to_string(), "1".to_string()));
        rule(|r| r.tag(r.tags.word).attributes = list.to_vec())
    };
    assert_eq!(keys("RPI", "SIL"), "admitted");
    assert_eq!(keys("SIL", "RPI"), "AttributeKeys");
    assert_eq!(keys("SIL", "SIL"), "AttributeKeys");
    assert_eq!(keys("a b", "c"), "AttributeKeys");
}

#[test]
fn controller_when_unknown_or_of_another_revision_then_is_refused() {
    assert_eq!(rule(|r| r.b.image.controller.processor = "1756-L61".into()), "UnknownController");
    assert_eq!(rule(|r| r.b.image.controller.processor = "1756-l72s".into()), "UnknownController");
    assert_eq!(rule(|r| r.b.image.controller.processor.clear()), "UnknownController");
    assert_eq!(rule(|r| r.b.image.controller.revision = 19), "UnknownRevision");
}

#[test]
fn task_when_beyond_its_bounds_then_is_refused() {
    let task = |change: fn(&mut TaskRecord)| rule(|r| change(r.b.image.task.as_mut().unwrap()));
    assert_eq!(rule(|r| r.b.image.task = None), "NoTask");
    assert_eq!(task(|task| (task.period_us, task.watchdog_us) = (1_000, 1_000)), "admitted");
    assert_eq!(task(|task| (task.period_us, task.watchdog_us) = (999, 999)), "Period");
    assert_eq!(task(|task| task.period_us = 500_000), "admitted");
    assert_eq!(task(|task| task.period_us = 500_001), "Period");
    assert_eq!(task(|task| task.watchdog_us = 20_000), "admitted");
    assert_eq!(task(|task| task.watchdog_us = 20_001), "Watchdog");
    assert_eq!(task(|task| task.watchdog_us = 0), "Watchdog");
    assert_eq!(task(|task| task.priority = 15), "admitted");
    assert_eq!(task(|task| task.priority = 16), "Priority");
    assert_eq!(task(|task| task.schedule.push(PROGRAM)), "ScheduledTwice");
    assert_eq!(task(|task| task.schedule.push(ProgramIndex(1))), "IndexRange");
}

#[test]
fn map_when_it_leads_elsewhere_then_is_refused() {
    let line = |safety| MapRecord { standard: "S".into(), safety };
    assert_eq!(rule(|r| r.b.image.map.push(line(r.tags.input))), "MapTarget");
    assert_eq!(rule(|r| r.b.image.map.push(line(r.tags.local))), "MapTarget");
    assert_eq!(rule(|r| r.b.image.map.push(line(TagIndex(99)))), "MapTarget");
    assert_eq!(rule(|r| r.b.image.map.push(line(r.tags.mapped))), "MapOrder");
    assert_eq!(rule(|r| r.b.image.map.push(line(r.tags.list))), "MapOrder");
    assert_eq!(rule(|r| r.tag(r.tags.mapped).constant = true), "MapTarget");
}

#[test]
fn system_value_when_it_does_not_exist_then_is_refused() {
    let value = |attribute, instance, first, program| SystemValueRecord { attribute, instance, first, program };
    let with = |record: SystemValueRecord| rule(|r| r.b.image.system_values.push(record.clone()));
    assert_eq!(with(value(9, 0, 1, Some(PROGRAM))), "admitted");
    assert_eq!(with(value(9, 0, 1, None)), "SystemValueInstance");
    assert_eq!(with(value(8, 1, 1, None)), "SystemValueInstance");
    assert_eq!(with(value(11, 3, 1, None)), "SystemValueInstance");
    assert_eq!(with(value(12, 0, 1, Some(ProgramIndex(1)))), "SystemValueInstance");
    assert_eq!(with(value(99, 0, 1, None)), "SystemValueAttribute");
    assert_eq!(with(value(8, 0, 2, None)), "SystemValueOrder");
    assert_eq!(with(value(6, 0, 1, None)), "SystemValueOrder");
}

#[test]
fn system_value_when_the_controller_lacks_it_then_is_refused() {
    let mut b = build_for("1756-L63S", 17);
    b.image.system_values.push(SystemValueRecord { attribute: 12, instance: 0, first: 0, program: None });
    assert_eq!(b.rule(), "SystemValueAttribute");
}

#[test]
fn type_when_it_has_no_layout_or_members_then_is_refused() {
    let member = |type_reference, dimensions| MemberRecord { name: "M".into(), type_reference, dimensions };
    let with = |kind, members: Vec<MemberRecord>| {
        let mut r = rich();
        r.b.image.types.push(TypeRecord { name: "More".into(), kind, members });
        r.b.rule()
    };
    assert_eq!(with(TypeKind::User, vec![member(DINT, [2, 0, 0])]), "admitted");
    assert_eq!(with(TypeKind::User, vec![]), "EmptyType");
    assert_eq!(with(TypeKind::User, vec![member(DINT, [2, 2, 0])]), "MemberDimensions");
    assert_eq!(with(TypeKind::User, vec![member(TypeReference::Structure(TypeIndex(4)), SCALAR)]), "Layout");
    assert_eq!(with(TypeKind::Predefined, vec![member(DINT, SCALAR)]), "Layout");
    assert_eq!(with(TypeKind::AddOn(SCALE), vec![member(DINT, SCALAR)]), "InstanceType");
    assert_eq!(with(TypeKind::AddOn(AddOnIndex(7)), vec![member(DINT, SCALAR)]), "InstanceType");
}

#[test]
fn types_when_nested_beyond_the_limit_then_are_refused() {
    let nested = |levels: usize| {
        let mut b = build();
        let mut inner = DINT;
        for level in 0..levels {
            inner = b.user(&format!("T{level}"), &[("M", inner, 0)]);
        }
        seal(&b.image).map_or_else(|error| error.rule(), |_| "sealed")
    };
    assert_eq!(nested(limits::TYPE_DEPTH), "sealed");
    assert_eq!(nested(limits::TYPE_DEPTH + 1), "Layout");
}

#[test]
fn real_when_the_controller_has_none_then_is_refused() {
    let mut b = build_for("1756-L63S", 17);
    b.user("R", &[("M", REAL, 0)]);
    assert_eq!(b.rule(), "RealType");
    let mut b = build_for("1756-L63S", 17);
    b.tag("R", REAL);
    assert_eq!(b.rule(), "TagReal");
    let mut b = build_for("1756-L63S", 17);
    b.operand(OperandRecord::Real(0));
    assert_eq!(b.rule(), "RealOperand");
}

#[test]
fn add_on_when_its_declaration_contradicts_its_type_then_is_refused() {
    let add_on = |change: fn(&mut AddOnRecord)| rule(|r| change(&mut r.b.image.add_ons[0]));
    assert_eq!(add_on(|add_on| add_on.instance_type = TypeIndex(2)), "InstanceType");
    assert_eq!(add_on(|add_on| add_on.parameters[0].argument = true), "EnableParameters");
    assert_eq!(add_on(|add_on| add_on.parameters.truncate(1)), "EnableParameters");
    assert_eq!(add_on(|add_on| add_on.parameters[2].member = Some(3)), "InstanceMembers");
    assert_eq!(add_on(|add_on| add_on.parameters[2].type_reference = INT), "InstanceMembers");
    assert_eq!(add_on(|add_on| add_on.parameters[4].member = Some(4)), "Parameter");
    assert_eq!(add_on(|add_on| add_on.parameters[4].argument = false), "Parameter");
    assert_eq!(add_on(|add_on| add_on.parameters[4].dimensions = [0, 2, 0]), "Parameter");
    assert_eq!(add_on(|add_on| add_on.logic = RoutineIndex(1)), "AddOnRoutines");
    assert_eq!(add_on(|add_on| add_on.prescan = Some(RoutineIndex(2))), "AddOnRoutines");
    assert_eq!(rule(|r| r.b.image.routines[2].name = "Code".into()), "AddOnRoutines");
    assert_eq!(rule(|r| _ = r.b.routine("Postscan", Owner::AddOn(SCALE))), "AddOnRoutines");
}

#[test]
fn routine_when_it_is_not_its_owners_then_is_refused() {
    assert_eq!(rule(|r| r.b.image.routines[1].owner = Owner::Program(ProgramIndex(4))), "RoutineOwner");
    assert_eq!(rule(|r| r.b.image.routines.swap(1, 2)), "RoutineOwner");
    assert_eq!(rule(|r| r.b.image.programs[0].fault = Some(RoutineIndex(2))), "ProgramRoutine");
    assert_eq!(rule(|r| r.b.image.programs[0].fault = Some(MAIN)), "ProgramRoutine");
    assert_eq!(rule(|r| r.b.image.programs[0].main = Some(RoutineIndex(9))), "ProgramRoutine");
}

/// What is left of the rich sample when it becomes a library.
fn library() -> Image {
    let mut r = rich();
    let (gain, result, reference) = (r.member(2, 0), r.member(3, 1), r.in_out());
    let mut b = r.b;
    let mut operands = build();
    let table = [gain, result, reference].map(|operand| {
        let record = OperandRecord::decode(b.image.operands.entry(operand).unwrap()).unwrap();
        operands.operand(record)
    });
    b.image.routines.drain(..2);
    b.image.routines[0].code.clear();
    b.rung(&[op(Opcode::Mul, &[table[0], table[2], table[1]])]);
    let image = Image {
        controller: ControllerRecord::default(),
        types: b.image.types,
        add_ons: b.image.add_ons,
        routines: b.image.routines,
        operands: operands.image.operands,
        ..Image::default()
    };
    let mut library = Build { image };
    library.image.add_ons[0].logic = RoutineIndex(0);
    library.texts();
    library.image
}

#[test]
fn library_when_admitted_then_needs_no_controller_and_no_task() {
    let mut image = library();
    let admitted = admit_library(&seal(&image).unwrap()).unwrap();
    assert_eq!(admitted.rung_counts(), [1]);
    assert_eq!(twinrung_bytecode::admit(&seal(&image).unwrap()).unwrap_err().rule(), "UnknownController");
    image.event_tasks.push("Report".into());
    assert_eq!(admit_library(&seal(&image).unwrap()).unwrap_err().rule(), "NotALibrary");
}
