//! The components of a project out of their attributes: one place for the names that text and XML
//! give to the same thing. Where two are listed, the first is L5K's and ours, the second L5X's.

use crate::fields::Fields;
use crate::tree::{
    AddOnInstruction, Connection, ConsumeInfo, Controller, DataType, Dimensions, ErrorKind, MapEntry, Member, Module,
    Name, Operand, Parameter, ParameterUsage, ProduceInfo, Program, ReadError, Routine, RoutineBody, SafetyInfo, Span,
    Tag, TagKind, TagUsage, Task, Text, Trivia, Usage,
};

/// `Use="Context"` and the like.
pub(crate) fn usage(fields: &mut Fields<'_>) -> Usage {
    let choices = [("Target", Usage::Target), ("Context", Usage::Context), ("Reference", Usage::Reference)];
    fields.choice(&["Use"], &choices).map_or(Usage::Target, |usage| usage.value)
}

pub(crate) fn controller(name: Name, mut fields: Fields<'_>, span: Span) -> Controller {
    Controller {
        name,
        usage: usage(&mut fields),
        processor_type: fields.text(&["ProcessorType"]),
        major: fields.number(&["Major", "MajorRev"]),
        minor: fields.number(&["Minor", "MinorRev"]),
        safety_network: fields.text(&["SafetyNetwork"]),
        safety: safety_info(&mut fields, span),
        description: fields.boxed_text(&["Description"]),
        attributes: fields.rest(),
        trivia: Trivia::none(),
        span,
    }
}

/// Safety settings: attributes of the controller in text, of an element of their own in XML.
pub(crate) fn safety_info(fields: &mut Fields<'_>, span: Span) -> Option<Box<SafetyInfo>> {
    const KEYS: &[&str] = &[
        "SafetyLocked",
        "SafetySignature",
        "SafetyLevel",
        "ConfigureSafetyIOAlways",
        "SignatureRunModeProtect",
        "SafetyTagMap",
    ];
    if !fields.has(KEYS) {
        return None;
    }
    let mut safety = SafetyInfo {
        locked: fields.flag(&["SafetyLocked"]),
        signature: fields.text(&["SafetySignature"]),
        level: fields.text(&["SafetyLevel"]),
        configure_io_always: fields.flag(&["ConfigureSafetyIOAlways"]),
        signature_run_mode_protect: fields.flag(&["SignatureRunModeProtect"]),
        span,
        ..SafetyInfo::default()
    };
    if let Some(text) = fields.text(&["SafetyTagMap"]) {
        safety.tag_map = tag_map(&text, fields);
    }
    Some(Box::new(safety))
}

/// ` standard=safety, standard2=safety2`
pub(crate) fn tag_map(text: &Text, fields: &mut Fields<'_>) -> Vec<MapEntry> {
    let mut entries = Vec::new();
    let place = |piece: &str| {
        let offset = (piece.as_ptr() as usize - text.text.as_ptr() as usize) as u32;
        let start = (text.span.start + offset).min(text.span.end);
        Span { start, end: (start + piece.len() as u32).min(text.span.end), ..text.span }
    };
    for pair in text.text.split(',').map(str::trim).filter(|pair| !pair.is_empty()) {
        match pair.split_once('=') {
            Some((standard, safety)) if !safety.contains('=') => entries.push(MapEntry {
                standard: Name::new(standard.trim(), place(standard.trim())),
                safety: Name::new(safety.trim(), place(safety.trim())),
                span: place(pair),
            }),
            _ => {
                let message = format!("`{pair}` maps nothing");
                let error = ReadError::new(ErrorKind::BadAttribute, place(pair), message);
                fields.errors.push(error.with_help("write `standard tag=safety tag`"));
            }
        }
    }
    entries
}

pub(crate) fn data_type(name: Name, mut fields: Fields<'_>, span: Span) -> DataType {
    let family = [("NoFamily", false), ("StringFamily", true)];
    DataType {
        name,
        usage: usage(&mut fields),
        is_string: fields.choice(&["FamilyType", "Family"], &family).is_some_and(|family| family.value),
        type_class: fields.name(&["Class"]),
        members: Vec::new(),
        description: fields.boxed_text(&["Description"]),
        attributes: fields.rest(),
        trivia: Trivia::none(),
        span,
    }
}

pub(crate) fn member(name: Name, data_type: Name, mut fields: Fields<'_>, span: Span) -> Member {
    Member {
        name,
        data_type,
        dimensions: Dimensions::default(),
        hidden: fields.flag(&["Hidden"]).is_some_and(|hidden| hidden.value),
        bit: None,
        radix: fields.name(&["Radix"]),
        external_access: fields.external_access(),
        description: fields.boxed_text(&["Description"]),
        attributes: fields.rest(),
        trivia: Trivia::none(),
        span,
    }
}

pub(crate) fn add_on_instruction(name: Name, mut fields: Fields<'_>, span: Span) -> AddOnInstruction {
    AddOnInstruction {
        name,
        usage: usage(&mut fields),
        class: fields.class(),
        revision: fields.text(&["Revision"]),
        vendor: fields.text(&["Vendor"]),
        execute_prescan: fields.flag(&["ExecutePrescan"]),
        execute_postscan: fields.flag(&["ExecutePostscan"]),
        execute_enable_in_false: fields.flag(&["ExecuteEnableInFalse"]),
        parameters: Vec::new(),
        local_tags: Vec::new(),
        routines: Vec::new(),
        history: Vec::new(),
        islands: Vec::new(),
        description: fields.boxed_text(&["Description"]),
        attributes: fields.rest(),
        trivia: Trivia::none(),
        span,
    }
}

/// A text of an attribute as an operand.
fn as_operand(text: Text) -> Box<Operand> {
    Box::new(Operand { text: text.text, span: text.span, origin: None })
}

pub(crate) fn parameter(name: Name, mut fields: Fields<'_>, span: Span) -> Parameter {
    let usages =
        [("Input", ParameterUsage::Input), ("Output", ParameterUsage::Output), ("InOut", ParameterUsage::InOut)];
    // An early form of L5K calls the usage `Type`; L5X says `TagType="Base"`, which says nothing more.
    let tag_type = [("Base", ()), ("Alias", ())];
    fields.choice(&["TagType"], &tag_type);
    Parameter {
        name,
        usage: fields.choice(&["Usage", "Type"], &usages),
        data_type: None,
        dimensions: Dimensions::default(),
        alias_for: fields.text(&["AliasFor"]).map(as_operand),
        required: fields.flag(&["Required"]),
        visible: fields.flag(&["Visible"]),
        constant: fields.flag(&["Constant"]),
        default: Vec::new(),
        radix: fields.name(&["Radix"]),
        external_access: fields.external_access(),
        description: fields.boxed_text(&["Description"]),
        attributes: fields.rest(),
        trivia: Trivia::none(),
        span,
    }
}

pub(crate) fn tag(name: Name, mut fields: Fields<'_>, span: Span) -> Tag {
    let usages = [
        ("Local", TagUsage::Local),
        ("Input", TagUsage::Input),
        ("Output", TagUsage::Output),
        ("InOut", TagUsage::InOut),
        ("Public", TagUsage::Public),
    ];
    Tag {
        name,
        usage: usage(&mut fields),
        kind: tag_kind(&mut fields),
        data_type: None,
        dimensions: Dimensions::default(),
        class: fields.class(),
        parameter: fields.choice(&["Usage"], &usages),
        constant: fields.flag(&["Constant"]),
        external_access: fields.external_access(),
        radix: fields.name(&["Radix"]),
        mapped_from: fields.name(&["MappedFrom"]),
        sil: fields.number(&["SIL"]),
        data: Vec::new(),
        forces: Vec::new(),
        description: fields.boxed_text(&["Description"]),
        comments: Vec::new(),
        attributes: fields.rest(),
        joins_previous: false,
        trivia: Trivia::none(),
        span,
    }
}

/// L5X names the kind; text shows it by what else is set.
fn tag_kind(fields: &mut Fields<'_>) -> TagKind {
    #[derive(Clone, Copy, PartialEq)]
    enum Named {
        Base,
        Alias,
        Produced,
        Consumed,
    }
    let names =
        [("Base", Named::Base), ("Alias", Named::Alias), ("Produced", Named::Produced), ("Consumed", Named::Consumed)];
    let named = fields.choice(&["TagType"], &names).map(|named| named.value);
    if let Some(target) = fields.text(&["AliasFor"]) {
        return TagKind::Alias(as_operand(target));
    }
    if named == Some(Named::Produced) || fields.has(&["ProduceCount", "Produced"]) {
        return TagKind::Produced(Box::new(produce_info(fields)));
    }
    if named == Some(Named::Consumed) || fields.has(&["Producer", "RemoteTag"]) {
        return TagKind::Consumed(Box::new(consume_info(fields)));
    }
    TagKind::Base
}

pub(crate) fn produce_info(fields: &mut Fields<'_>) -> ProduceInfo {
    ProduceInfo {
        count: fields.number(&["Produced", "ProduceCount"]),
        rpi_us: fields.milliseconds(&["RPI", "DefaultRPI"]),
        rpi_min_us: fields.milliseconds(&["MinimumRPI"]),
        rpi_max_us: fields.milliseconds(&["MaximumRPI"]),
        connection_status: fields.flag(&["IncludeConnectionStatus"]),
        unicast: fields.flag(&["UnicastPermitted"]),
    }
}

pub(crate) fn consume_info(fields: &mut Fields<'_>) -> ConsumeInfo {
    ConsumeInfo {
        producer: fields.name(&["Producer"]),
        remote_tag: fields.text(&["RemoteTag"]),
        rpi_us: fields.milliseconds(&["RPI"]),
        timeout_multiplier: fields.number(&["TimeoutMultiplier"]),
        network_delay_multiplier: fields.number(&["NetworkDelayMultiplier"]),
        reaction_time_limit_us: fields.milliseconds(&["ReactionTimeLimit"]),
        connection_status: fields.flag(&["IncludeConnectionStatus"]),
        unicast: fields.flag(&["Unicast"]),
    }
}

pub(crate) fn module(name: Name, mut fields: Fields<'_>, span: Span) -> Module {
    Module {
        name,
        usage: usage(&mut fields),
        catalog_number: fields.text(&["CatalogNumber"]),
        vendor: fields.number(&["Vendor"]),
        product_type: fields.number(&["ProductType"]),
        product_code: fields.number(&["ProductCode"]),
        major: fields.number(&["Major"]),
        minor: fields.number(&["Minor"]),
        parent: fields.name(&["Parent", "ParentModule"]),
        parent_port: fields.number(&["ParentModPortId"]),
        slot: fields.number(&["Slot"]),
        address: fields.text(&["IPAddress", "NodeAddress", "Address"]),
        safety_network: fields.text(&["SafetyNetwork"]),
        safety_enabled: fields.flag(&["SafetyEnabled"]),
        inhibited: fields.flag(&["Inhibited"]),
        rpi_us: fields.milliseconds(&["RPI"]),
        electronic_key: fields.name(&["EKey", "Keying"]),
        points: Vec::new(),
        ports: Vec::new(),
        connections: Vec::new(),
        configuration: None,
        opaque: Vec::new(),
        description: fields.boxed_text(&["Description"]),
        attributes: fields.rest(),
        trivia: Trivia::none(),
        span,
    }
}

/// In L5K `Rate` is in microseconds, as is `RPI` in L5X; in `.rll` (`RPI`) it is in milliseconds.
pub(crate) fn connection(name: Name, mut fields: Fields<'_>, span: Span, rpi_in_milliseconds: bool) -> Connection {
    let rate = fields.microseconds(&["Rate"]);
    let rpi = if rpi_in_milliseconds { fields.milliseconds(&["RPI"]) } else { fields.microseconds(&["RPI"]) };
    Connection {
        name,
        connection_type: fields.text(&["Type"]),
        rpi_us: rate.or(rpi),
        timeout_multiplier: fields.number(&["TimeoutMultiplier"]),
        network_delay_multiplier: fields.number(&["NetworkDelayMultiplier"]),
        reaction_time_limit_us: fields.milliseconds(&["ReactionTimeLimit"]),
        unicast: fields.flag(&["Unicast"]),
        input: None,
        output: None,
        attributes: fields.rest(),
        trivia: Trivia::none(),
        span,
    }
}

pub(crate) fn program(name: Name, mut fields: Fields<'_>, span: Span) -> Program {
    Program {
        name,
        usage: usage(&mut fields),
        class: fields.class(),
        main_routine: fields.name(&["MAIN", "MainRoutineName"]),
        fault_routine: fields.name(&["FAULT", "FaultRoutineName"]),
        disabled: fields.flag(&["DisableFlag", "Disabled"]),
        test_edits: fields.flag(&["TestEdits"]),
        use_as_folder: fields.flag(&["UseAsFolder"]),
        tags: Vec::new(),
        routines: Vec::new(),
        encoded: Vec::new(),
        islands: Vec::new(),
        description: fields.boxed_text(&["Description"]),
        attributes: fields.rest(),
        trivia: Trivia::none(),
        span,
    }
}

pub(crate) fn routine(name: Name, mut fields: Fields<'_>, span: Span) -> Routine {
    Routine {
        name,
        usage: usage(&mut fields),
        body: RoutineBody::Ladder(Vec::new()),
        description: fields.boxed_text(&["Description"]),
        attributes: fields.rest(),
        trivia: Trivia::none(),
        span,
    }
}

pub(crate) fn task(name: Name, mut fields: Fields<'_>, span: Span) -> Task {
    Task {
        name,
        task_type: fields.name(&["Type"]),
        class: fields.class(),
        rate_us: fields.milliseconds(&["Rate"]),
        priority: fields.number(&["Priority"]),
        watchdog_us: fields.milliseconds(&["Watchdog"]),
        disable_update_outputs: fields.flag(&["DisableUpdateOutputs"]),
        inhibited: fields.flag(&["InhibitTask"]),
        programs: Vec::new(),
        description: fields.boxed_text(&["Description"]),
        attributes: fields.rest(),
        trivia: Trivia::none(),
        span,
    }
}
