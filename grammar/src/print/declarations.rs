//! Everything that is declared, in the order of L5K.

use super::attributes::{List, quoted};
use super::layout::Layout;
use super::value::print_data;
use super::{modules, rung};
use crate::tree::{
    AddOnInstruction, Controller, DataType, Dimensions, Encoded, File, Island, MapEntry, Member, Parameter,
    ParameterUsage, Program, Routine, RoutineBody, Tag, TagKind, TagUsage, Task, Text,
};

pub(super) fn file(layout: &mut Layout, file: &File) {
    layout.leading(&file.trivia);
    if let Some(version) = &file.ie_version {
        let mut line = format!("IE_VER := {};", version.text);
        for comment in file.trivia.trailing() {
            line.push(' ');
            line.push_str(comment);
        }
        layout.line(&line);
    }
    match &file.controller {
        Some(controller) => {
            let list = controller_attributes(controller);
            let head = format!("CONTROLLER {}", controller.name);
            layout.block(&controller.trivia, &head, &list.items, "END_CONTROLLER", |layout| components(layout, file));
        }
        None => components(layout, file),
    }
    layout.closing(&file.trivia);
}

fn controller_attributes(controller: &Controller) -> List {
    let mut list = List::default();
    list.text("Description", controller.description.as_deref());
    list.text("ProcessorType", controller.processor_type.as_ref());
    list.number("Major", controller.major);
    list.number("Minor", controller.minor);
    list.word("SafetyNetwork", controller.safety_network.as_ref().map(|text| text.text.as_str()));
    if let Some(safety) = &controller.safety {
        list.flag("SafetyLocked", safety.locked);
        list.text("SafetySignature", safety.signature.as_ref());
        list.text("SafetyLevel", safety.level.as_ref());
        list.flag("SignatureRunModeProtect", safety.signature_run_mode_protect);
        list.flag("ConfigureSafetyIOAlways", safety.configure_io_always);
        if !safety.tag_map.is_empty() {
            let pair = |entry: &MapEntry| format!(" {}={}", entry.standard, entry.safety);
            let map: Vec<String> = safety.tag_map.iter().map(pair).collect();
            list.push("SafetyTagMap", &quoted(&map.join(",")));
        }
        list.rest(&safety.attributes);
    }
    list.rest(&controller.attributes);
    list
}

fn components(layout: &mut Layout, file: &File) {
    for data_type in &file.data_types {
        self::data_type(layout, data_type);
    }
    for module in &file.modules {
        modules::module(layout, module);
    }
    for add_on in &file.add_on_instructions {
        add_on_instruction(layout, add_on);
    }
    for encoded in &file.encoded {
        self::encoded(layout, encoded);
    }
    tags(layout, &file.tags, "TAG", "END_TAG");
    for program in &file.programs {
        self::program(layout, program);
    }
    for routine in &file.routines {
        self::routine(layout, routine);
    }
    for task in &file.tasks {
        self::task(layout, task);
    }
    islands(layout, &file.islands);
}

/// As they stood; those of an L5X are not in it.
fn islands(layout: &mut Layout, islands: &[Island]) {
    for island in islands.iter().filter(|island| !island.text.text.is_empty()) {
        layout.declaration(&island.trivia, &island.text.text, &[], "");
    }
}

fn encoded(layout: &mut Layout, encoded: &Encoded) {
    let mut list = List::default();
    list.name("EncodedType", Some(&encoded.kind));
    list.text("Name", encoded.name.as_ref().map(|name| Text::new(name.text.clone(), name.span)).as_ref());
    list.rest(&encoded.attributes);
    layout.block(&encoded.trivia, "ENCODED_DATA", &list.items, "END_ENCODED_DATA", |layout| {
        body(layout, &encoded.text);
    });
}

/// The text of an island, as it stood.
fn body(layout: &mut Layout, text: &Text) {
    if !text.text.is_empty() {
        layout.line(&text.text);
    }
}

fn brackets(dimensions: Dimensions) -> String {
    if dimensions.is_scalar() {
        return String::new();
    }
    let sizes: Vec<String> = dimensions.sizes().iter().map(u32::to_string).collect();
    format!("[{}]", sizes.join(","))
}

fn data_type(layout: &mut Layout, data_type: &DataType) {
    let mut list = List::default();
    list.text("Description", data_type.description.as_deref());
    if data_type.is_string {
        list.push("FamilyType", "StringFamily");
    }
    list.name("Class", data_type.type_class.as_ref());
    list.rest(&data_type.attributes);
    let head = format!("DATATYPE {}", data_type.name);
    layout.block(&data_type.trivia, &head, &list.items, "END_DATATYPE", |layout| {
        for member in &data_type.members {
            self::member(layout, member);
        }
    });
}

fn member(layout: &mut Layout, member: &Member) {
    let mut list = List::default();
    list.text("Description", member.description.as_deref());
    if member.hidden {
        list.push("Hidden", "1");
    }
    list.name("Radix", member.radix.as_ref());
    list.external_access(member.external_access);
    list.rest(&member.attributes);
    let head = match &member.bit {
        Some(bit) => format!("BIT {} {} : {}", member.name, bit.target, bit.number.value),
        None => format!("{} {}{}", member.data_type, member.name, brackets(member.dimensions)),
    };
    layout.declaration(&member.trivia, &head, &list.items, ";");
}

fn add_on_instruction(layout: &mut Layout, add_on: &AddOnInstruction) {
    let mut list = List::default();
    list.text("Description", add_on.description.as_deref());
    list.class(add_on.class);
    list.text("Revision", add_on.revision.as_ref());
    list.text("Vendor", add_on.vendor.as_ref());
    list.flag("ExecutePrescan", add_on.execute_prescan);
    list.flag("ExecutePostscan", add_on.execute_postscan);
    list.flag("ExecuteEnableInFalse", add_on.execute_enable_in_false);
    list.rest(&add_on.attributes);
    let head = format!("ADD_ON_INSTRUCTION_DEFINITION {}", add_on.name);
    layout.block(&add_on.trivia, &head, &list.items, "END_ADD_ON_INSTRUCTION_DEFINITION", |layout| {
        if !add_on.parameters.is_empty() {
            layout.list("PARAMETERS", "END_PARAMETERS", |layout| {
                for parameter in &add_on.parameters {
                    self::parameter(layout, parameter);
                }
            });
        }
        tags(layout, &add_on.local_tags, "LOCAL_TAGS", "END_LOCAL_TAGS");
        for routine in &add_on.routines {
            self::routine(layout, routine);
        }
        for entry in &add_on.history {
            let mut list = List::default();
            list.rest(&entry.attributes);
            layout.block(&entry.trivia, "HISTORY_ENTRY", &list.items, "END_HISTORY_ENTRY", |layout| {
                body(layout, &entry.text);
            });
        }
        islands(layout, &add_on.islands);
    });
}

fn parameter(layout: &mut Layout, parameter: &Parameter) {
    let mut list = List::default();
    list.text("Description", parameter.description.as_deref());
    if let Some(usage) = parameter.usage {
        let word = match usage.value {
            ParameterUsage::Input => "Input",
            ParameterUsage::Output => "Output",
            ParameterUsage::InOut => "InOut",
        };
        list.push("Usage", word);
    }
    list.name("RADIX", parameter.radix.as_ref());
    list.flag("Required", parameter.required);
    list.flag("Visible", parameter.visible);
    list.flag("Constant", parameter.constant);
    list.external_access(parameter.external_access);
    list.rest(&parameter.attributes);
    let mut head = match (&parameter.data_type, &parameter.alias_for) {
        (None, Some(target)) => format!("{} OF {}", parameter.name, target.text),
        (data_type, alias) => {
            if let Some(target) = alias {
                list.push("AliasFor", &quoted(&target.text));
            }
            let data_type = data_type.as_ref().map_or("BOOL", |name| name.text.as_str());
            format!("{} : {data_type}", parameter.name)
        }
    };
    head.push_str(&brackets(parameter.dimensions));
    if let Some(value) = print_data(&parameter.default) {
        list.push("DefaultData", &quoted(&value));
    }
    layout.declaration(&parameter.trivia, &head, &list.items, ";");
}

fn tags(layout: &mut Layout, tags: &[Tag], begin: &str, end: &str) {
    // The tag of a module (`Doors:I`), which an export lists among the context, is not declared in text.
    let declared = |tag: &Tag| !tag.name.text.contains(':');
    if !tags.iter().any(declared) {
        return;
    }
    layout.list(begin, end, |layout| {
        let mut rest = tags;
        while let Some((first, others)) = rest.split_first() {
            let joined = others.iter().take_while(|tag| tag.joins_previous && is_alike(first, tag)).count();
            let (joined, others) = others.split_at(joined);
            if declared(first) {
                tag(layout, first, joined);
            }
            rest = others;
        }
    });
}

/// Whether a tag says the same as another but for its name.
fn is_alike(first: &Tag, other: &Tag) -> bool {
    let declaration = |tag: &Tag| (tag_head(tag, ""), tag_attributes(tag).items, tag_values(tag));
    declaration(first) == declaration(other) && first.usage == other.usage
}

fn tag(layout: &mut Layout, tag: &Tag, joined: &[Tag]) {
    let names: Vec<&str> = std::iter::once(tag).chain(joined).map(|tag| tag.name.text.as_str()).collect();
    let after = format!("{};", tag_values(tag));
    layout.declaration(&tag.trivia, &tag_head(tag, &names.join(", ")), &tag_attributes(tag).items, &after);
}

fn tag_head(tag: &Tag, names: &str) -> String {
    match (&tag.kind, &tag.data_type) {
        (TagKind::Alias(target), _) => format!("{names} OF {}", target.text),
        (_, data_type) => {
            let data_type = data_type.as_ref().map_or("BOOL", |name| name.text.as_str());
            format!("{names} : {data_type}{}", brackets(tag.dimensions))
        }
    }
}

/// ` := value, TagForceData := value`
fn tag_values(tag: &Tag) -> String {
    let mut out = String::new();
    if let Some(value) = print_data(&tag.data) {
        out.push_str(" := ");
        out.push_str(&value);
    }
    if let Some(forces) = print_data(&tag.forces) {
        out.push_str(", TagForceData := ");
        out.push_str(&forces);
    }
    out
}

fn tag_attributes(tag: &Tag) -> List {
    let mut list = List::default();
    list.text("Description", tag.description.as_deref());
    list.class(tag.class);
    if let Some(usage) = tag.parameter {
        let word = match usage.value {
            TagUsage::Local => "Local",
            TagUsage::Input => "Input",
            TagUsage::Output => "Output",
            TagUsage::InOut => "InOut",
            TagUsage::Public => "Public",
        };
        list.push("Usage", word);
    }
    list.name("MappedFrom", tag.mapped_from.as_ref());
    list.number("SIL", tag.sil);
    tag_kind(&mut list, &tag.kind);
    list.flag("Constant", tag.constant);
    list.name("RADIX", tag.radix.as_ref());
    list.external_access(tag.external_access);
    for comment in &tag.comments {
        list.push(&format!("COMMENT{}", comment.operand.text), &quoted(&comment.text.text));
    }
    list.rest(&tag.attributes);
    list
}

fn tag_kind(list: &mut List, kind: &TagKind) {
    match kind {
        TagKind::Base | TagKind::Alias(_) => {}
        TagKind::Produced(info) => {
            if info.count.is_none() {
                list.push("TagType", "Produced");
            }
            list.number("Produced", info.count);
            list.milliseconds("RPI", info.rpi_us);
            list.milliseconds("MinimumRPI", info.rpi_min_us);
            list.milliseconds("MaximumRPI", info.rpi_max_us);
            list.flag("IncludeConnectionStatus", info.connection_status);
            list.flag("UnicastPermitted", info.unicast);
        }
        TagKind::Consumed(info) => {
            if info.producer.is_none() && info.remote_tag.is_none() {
                list.push("TagType", "Consumed");
            }
            list.name("Producer", info.producer.as_ref());
            list.word("RemoteTag", info.remote_tag.as_ref().map(|text| text.text.as_str()));
            list.milliseconds("RPI", info.rpi_us);
            list.number("TimeoutMultiplier", info.timeout_multiplier);
            list.number("NetworkDelayMultiplier", info.network_delay_multiplier);
            list.milliseconds("ReactionTimeLimit", info.reaction_time_limit_us);
            list.flag("IncludeConnectionStatus", info.connection_status);
            list.flag("Unicast", info.unicast);
        }
    }
}

fn program(layout: &mut Layout, program: &Program) {
    let mut list = List::default();
    list.text("Description", program.description.as_deref());
    list.class(program.class);
    let name = |name: &crate::tree::Name| Text::new(name.text.clone(), name.span);
    list.text("MAIN", program.main_routine.as_ref().map(name).as_ref());
    list.text("FAULT", program.fault_routine.as_ref().map(name).as_ref());
    list.flag("DisableFlag", program.disabled);
    list.flag("TestEdits", program.test_edits);
    list.flag("UseAsFolder", program.use_as_folder);
    list.rest(&program.attributes);
    let head = format!("PROGRAM {}", program.name);
    layout.block(&program.trivia, &head, &list.items, "END_PROGRAM", |layout| {
        tags(layout, &program.tags, "TAG", "END_TAG");
        for encoded in &program.encoded {
            self::encoded(layout, encoded);
        }
        for routine in &program.routines {
            self::routine(layout, routine);
        }
        islands(layout, &program.islands);
    });
}

fn routine(layout: &mut Layout, routine: &Routine) {
    let mut list = List::default();
    list.text("Description", routine.description.as_deref());
    match &routine.body {
        RoutineBody::Ladder(rungs) => {
            list.rest(&routine.attributes);
            let head = format!("ROUTINE {}", routine.name);
            layout.block(&routine.trivia, &head, &list.items, "END_ROUTINE", |layout| {
                for rung in rungs.iter().filter(|rung| !rung.broken) {
                    rung::rung(layout, rung);
                }
            });
        }
        RoutineBody::Island { language, text } => {
            list.rest(&routine.attributes);
            let word = format!("{}_ROUTINE", language.text.to_ascii_uppercase());
            let head = format!("{word} {}", routine.name);
            layout.block(&routine.trivia, &head, &list.items, &format!("END_{word}"), |layout| body(layout, text));
        }
        RoutineBody::Encoded { text } => {
            let mut list = List::default();
            list.push("EncodedType", "ROUTINE");
            list.push("Name", &quoted(&routine.name.text));
            list.text("Description", routine.description.as_deref());
            list.rest(&routine.attributes);
            layout.block(&routine.trivia, "ENCODED_DATA", &list.items, "END_ENCODED_DATA", |layout| body(layout, text));
        }
    }
}

fn task(layout: &mut Layout, task: &Task) {
    let mut list = List::default();
    list.text("Description", task.description.as_deref());
    list.name("Type", task.task_type.as_ref());
    list.class(task.class);
    list.milliseconds("Rate", task.rate_us);
    list.number("Priority", task.priority);
    list.milliseconds("Watchdog", task.watchdog_us);
    list.flag("DisableUpdateOutputs", task.disable_update_outputs);
    list.flag("InhibitTask", task.inhibited);
    list.rest(&task.attributes);
    let head = format!("TASK {}", task.name);
    layout.block(&task.trivia, &head, &list.items, "END_TASK", |layout| {
        for program in &task.programs {
            layout.line(&format!("{program};"));
        }
    });
}
