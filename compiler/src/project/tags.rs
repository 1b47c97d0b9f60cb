//! Making the tag table: declarations of the controller and of programs, tags that modules bring, aliases.

use twinrung_bytecode::layout::elements;
use twinrung_bytecode::limits;
use twinrung_catalog::modules;
use twinrung_grammar::tree::{self, Class, CompactString, Span};

use super::data::{self, Defaults};
use super::names_in_scope::{Found, ScopeNames};
use super::tag::AliasTarget;
use super::types::{TypeFault, TypeProblem, dimensions};
use super::{Module, Tag, TagClass, TagId, TagKind, TagScope, Types};
use crate::diagnostic::{
    BAD_NAME, BAD_TYPE, DUPLICATE_NAME, Finding, Findings, NOT_SUPPORTED, OVER_LIMIT, UNKNOWN_TYPE,
};
use crate::names::{RESERVED, closest, fold, name_fault};
use crate::rules;

/// The tags and what they hold.
pub(crate) struct TagTable<'b, 'a> {
    pub tags: Vec<Tag>,
    pub names: ScopeNames,
    pub types: &'b mut Types,
    pub defaults: &'b mut Defaults,
    pub findings: &'b mut Findings,
    /// What each alias designates: the operand, to be resolved when all names are known.
    pub aliases: Vec<(TagId, &'a tree::Operand)>,
    /// Bit and word cells of the safety tags so far.
    pub cells: (u64, u64),
    /// Whether a declaration that is there already is passed over in silence: what a context repeats.
    pub context: bool,
}

impl<'a> TagTable<'_, 'a> {
    /// Declares a tag under its names.
    pub fn add(&mut self, tag: Tag) -> Option<TagId> {
        let id = TagId(self.tags.len() as u32);
        let context = self.context;
        let table = self.names.table(tag.scope)?;
        let name = fold(&tag.name);
        if let Some(known) = table.get(&name) {
            if !context {
                let first = &self.tags[known.tag.position()];
                let message = format!("`{}` is declared twice", tag.name);
                let finding = Finding::new(&DUPLICATE_NAME, tag.span, message)
                    .label(first.span, "first declared here")
                    .help("rename one of the two; upper and lower case make no difference");
                self.findings.push(finding);
            }
            return None;
        }
        table.insert(name, Found { tag: id, by_slot: false });
        if let Some(slot_name) = &tag.slot_name {
            table.entry(fold(slot_name)).or_insert(Found { tag: id, by_slot: true });
        }
        self.tags.push(tag);
        Some(id)
    }

    /// A tag declaration. `class` is that of a program, for its tags.
    pub fn declare(&mut self, shown: &'a tree::Tag, scope: TagScope, program_class: Option<TagClass>) {
        let class = match (&shown.class, program_class) {
            (Some(class), _) => class_of(class.value),
            (None, Some(class)) => class,
            (None, None) => TagClass::Standard,
        };
        if class == TagClass::Safety || matches!(scope, TagScope::Program(_)) {
            self.judge_name(&shown.name);
        }
        let kind = match &shown.kind {
            tree::TagKind::Base => TagKind::Base,
            tree::TagKind::Alias(_) => TagKind::Alias(None),
            tree::TagKind::Produced(_) => TagKind::Produced,
            tree::TagKind::Consumed(_) => TagKind::Consumed,
        };
        let (type_name, type_span) = match &shown.data_type {
            Some(name) => (name.text.clone(), name.span),
            None => (CompactString::default(), shown.name.span),
        };
        let mut tag = Tag {
            name: shown.name.text.clone(),
            slot_name: None,
            uses_slot_name: false,
            span: shown.name.span,
            scope,
            class,
            kind,
            type_name,
            type_span,
            type_reference: None,
            dimensions: dimensions(shown.dimensions),
            constant: shown.constant.is_some_and(|constant| constant.value),
            sil: shown.sil.map(|sil| sil.value),
            attributes: attributes(shown),
            initial: None,
            explicit_class: shown.class.map(|class| (class_of(class.value), class.span)),
            fault: None,
            connection: match &shown.kind {
                tree::TagKind::Consumed(info) => Some(info.clone()),
                _ => None,
            },
            mapped_from: shown.mapped_from.as_ref().map(|name| (name.text.clone(), name.span)),
        };
        if class == TagClass::Safety && !tag.is_alias() {
            self.lay_out(&mut tag, &shown.data);
        }
        let Some(id) = self.add(tag) else { return };
        if let tree::TagKind::Alias(operand) = &shown.kind {
            self.aliases.push((id, operand));
        }
    }

    /// Resolves the type of a safety tag and reads its data.
    fn lay_out(&mut self, tag: &mut Tag, shown: &[tree::Data]) {
        if elements(tag.dimensions).is_none() {
            let message = format!("`{}` has more than {} elements", tag.name, limits::ARRAY_ELEMENTS);
            self.findings.push(Finding::new(&BAD_TYPE, tag.type_span, message));
            return;
        }
        let mut outcome = self.types.resolve(&tag.type_name);
        if matches!(&outcome, Err(TypeFault { problem: TypeProblem::Unknown(_), .. })) {
            // The type of a module's tag may be visible in decorated data only.
            for one in shown.iter().filter(|one| one.form == tree::DataForm::Decorated) {
                self.types.declare_as_shown(&one.value);
            }
            outcome = self.types.resolve(&tag.type_name);
        }
        match outcome {
            Ok(type_reference) => {
                let (bits, words) = self.types.cells(type_reference);
                let count = u64::from(elements(tag.dimensions).unwrap_or(1));
                let cells = (self.cells.0 + u64::from(bits) * count, self.cells.1 + u64::from(words) * count);
                if cells.0 > u64::from(limits::BIT_CELLS) || cells.1 > u64::from(limits::WORD_CELLS) {
                    let message = format!("with `{}` the safety tags take more memory than an image has", tag.name);
                    self.findings.push(Finding::new(&OVER_LIMIT, tag.type_span, message));
                    return;
                }
                self.cells = cells;
                tag.type_reference = Some(type_reference);
                if !shown.is_empty() {
                    tag.initial =
                        data::read(self.types, self.defaults, shown, type_reference, tag.dimensions, self.findings)
                            .map(Box::new);
                }
            }
            Err(fault) => {
                let finding = type_finding(self.types, &tag.name, &tag.type_name, tag.type_span, &fault);
                self.findings.push(finding);
            }
        }
    }

    fn judge_name(&mut self, name: &tree::Name) {
        if let Some(fault) = name_fault(name.as_str()) {
            let message = format!("`{name}` is no name: {fault}");
            self.findings.push(Finding::new(&BAD_NAME, name.span, message));
        } else if RESERVED.iter().any(|reserved| name.is(reserved)) {
            let message = format!("`{name}` is an operator of expressions and no name of a tag");
            self.findings.push(Finding::new(&BAD_NAME, name.span, message).help("choose another name"));
        }
    }

    /// The tags that a module brings.
    pub fn declare_module(&mut self, shown: &'a tree::Module, module: &Module, position: usize) {
        let known = modules::Module::by_catalog_number(&module.catalog_number);
        let mut has = (false, false);
        for connection in &shown.connections {
            let safety = known.is_some()
                || connection
                    .connection_type
                    .as_ref()
                    .is_some_and(|kind| kind.as_str().to_ascii_lowercase().starts_with("safety"));
            for (tag, is_input) in [(&connection.input, true), (&connection.output, false)]
                .into_iter()
                .filter_map(|(tag, input)| tag.as_deref().map(|tag| (tag, input)))
            {
                let class = if safety { TagClass::Safety } else { TagClass::Standard };
                if safety && is_input {
                    has.0 = true;
                } else if safety {
                    has.1 = true;
                }
                self.module_tag(shown, module, position, tag, is_input, class, known);
            }
        }
        if let Some(configuration) = &shown.configuration {
            self.module_tag(shown, module, position, configuration, true, TagClass::Standard, known);
        }
        if let Some(known) = known {
            if !has.0 {
                self.catalog_tag(shown, module, position, known, true);
            }
            if !has.1 {
                self.catalog_tag(shown, module, position, known, false);
            }
        }
    }

    #[allow(clippy::too_many_arguments)]
    fn module_tag(
        &mut self,
        shown: &'a tree::Module,
        module: &Module,
        position: usize,
        module_tag: &'a tree::ModuleTag,
        is_input: bool,
        class: TagClass,
        known: Option<&'static modules::Module>,
    ) {
        let visible = module_tag.data.iter().find(|one| one.form == tree::DataForm::Decorated);
        let type_name = match (&module_tag.data_type, visible.map(|one| &one.value)) {
            (Some(name), _) => name.text.clone(),
            (None, Some(tree::Value::Structure { data_type, .. })) => data_type.clone(),
            _ => CompactString::default(),
        };
        if class == TagClass::Safety && type_name.is_empty() {
            if let Some(known) = known {
                self.catalog_tag(shown, module, position, known, is_input);
            }
            return;
        }
        let mut tag = module_tag_named(module, position, &module_tag.suffix, is_input, class, module_tag.span);
        tag.type_name = type_name;
        if class == TagClass::Safety {
            // What an input held when it was exported is no initial value: it reads 0 until the first frozen input.
            if let Some(one) = visible {
                self.types.declare_as_shown(&one.value);
            }
            self.lay_out(&mut tag, &[]);
        }
        self.add(tag);
    }

    /// The tag of a module that the catalog describes, by the words of its declaration.
    fn catalog_tag(
        &mut self,
        shown: &tree::Module,
        module: &Module,
        position: usize,
        known: &'static modules::Module,
        is_input: bool,
    ) {
        let (key, choices, always) = if is_input {
            ("InputStatus", known.input_status, known.input)
        } else {
            ("OutputData", known.output_data, &[][..])
        };
        let attribute = shown.attributes.iter().find(|attribute| attribute.key.is(key));
        let choice = match attribute.and_then(|attribute| attribute.value.text()) {
            None => choices.first(),
            Some(word) => {
                let found = choices.iter().find(|choice| choice.word.eq_ignore_ascii_case(word.as_str().trim()));
                if found.is_none() {
                    self.findings.push(rules::module_setting::choice(known, key, choices, word));
                }
                found
            }
        };
        let Some(choice) = choice else { return };
        let members = || always.iter().copied().flatten().chain(choice.each_member());
        if members().next().is_none() {
            return;
        }
        let suffix = if is_input { "I" } else { "O" };
        let type_name =
            CompactString::from(format!("AB:{}:{suffix}:{}", known.catalog_number.replace('-', "_"), choice.word));
        let drafts =
            members().map(|member| (member.name.into(), member.element.name().into(), [0; 3], module.span)).collect();
        self.types.declare_members(&type_name, drafts);
        let mut tag = module_tag_named(module, position, suffix, is_input, TagClass::Safety, module.span);
        tag.type_name = type_name;
        self.lay_out(&mut tag, &[]);
        self.add(tag);
    }
}

fn module_tag_named(
    module: &Module,
    position: usize,
    suffix: &str,
    is_input: bool,
    class: TagClass,
    span: Span,
) -> Tag {
    let slot_name = match (module.slot, module.parent.is_empty()) {
        (Some(slot), false) => Some(CompactString::from(format!("{}:{slot}:{suffix}", module.parent))),
        _ => None,
    };
    Tag {
        name: CompactString::from(format!("{}:{suffix}", module.name)),
        slot_name,
        uses_slot_name: false,
        span,
        scope: TagScope::Controller,
        class,
        kind: if is_input { TagKind::ModuleInput(position) } else { TagKind::ModuleOutput(position) },
        type_name: CompactString::default(),
        type_span: span,
        type_reference: None,
        dimensions: [0; 3],
        constant: false,
        sil: None,
        attributes: Vec::new(),
        initial: None,
        explicit_class: None,
        fault: None,
        connection: None,
        mapped_from: None,
    }
}

/// The class of the tree as a tag has it.
pub(crate) fn class_of(class: Class) -> TagClass {
    match class {
        Class::Standard => TagClass::Standard,
        Class::Safety => TagClass::Safety,
    }
}

/// Settings of a tag that belong to the signed declaration: key and canonical text, sorted.
fn attributes(shown: &tree::Tag) -> Vec<(String, String)> {
    let mut list = Vec::new();
    let mut add = |key: &str, value: Option<String>| {
        if let Some(value) = value {
            list.push((key.to_owned(), value));
        }
    };
    add("SIL", shown.sil.map(|sil| sil.value.to_string()));
    match &shown.kind {
        tree::TagKind::Produced(info) => {
            add("Produced", info.count.map(|count| count.value.to_string()));
            add("RPI_us", info.rpi_us.map(|rpi| rpi.value.to_string()));
            add("MinimumRPI_us", info.rpi_min_us.map(|rpi| rpi.value.to_string()));
            add("MaximumRPI_us", info.rpi_max_us.map(|rpi| rpi.value.to_string()));
        }
        tree::TagKind::Consumed(info) => {
            add("Producer", info.producer.as_ref().map(|name| name.text.to_string()));
            add("RemoteTag", info.remote_tag.as_ref().map(|text| text.text.to_string()));
            add("RPI_us", info.rpi_us.map(|rpi| rpi.value.to_string()));
            add("TimeoutMultiplier", info.timeout_multiplier.map(|value| value.value.to_string()));
            add("NetworkDelayMultiplier", info.network_delay_multiplier.map(|value| value.value.to_string()));
            add("ReactionTimeLimit_us", info.reaction_time_limit_us.map(|value| value.value.to_string()));
        }
        tree::TagKind::Base | tree::TagKind::Alias(_) => {}
    }
    list.sort();
    list
}

/// Why a safety tag cannot have its type.
pub(crate) fn type_finding(types: &Types, what: &str, type_name: &str, span: Span, fault: &TypeFault) -> Finding {
    let within =
        |name: &str| if name.eq_ignore_ascii_case(type_name) { String::new() } else { format!(" within {type_name}") };
    // What is wrong with the type itself stands at the member, once for all tags that have it.
    let of_type = matches!(fault.problem, TypeProblem::Unknown(_) | TypeProblem::Recursive(_) | TypeProblem::Shape(_));
    let span = fault.member.filter(|_| of_type).unwrap_or(span);
    let finding = match &fault.problem {
        TypeProblem::Unknown(name) if name.is_empty() => {
            Finding::new(&UNKNOWN_TYPE, span, format!("the type of `{what}` is not visible"))
        }
        TypeProblem::Unknown(name) => {
            let finding =
                Finding::new(&UNKNOWN_TYPE, span, format!("the type `{name}`{} is not declared", within(name)));
            match closest(name, types.candidate_names()) {
                Some(like) => finding.help(format!("did you mean `{}`?", like.to_ascii_uppercase())),
                None => {
                    finding.help("declare the type; for a partial export give the file that declares it with --context")
                }
            }
        }
        TypeProblem::NotSafe(name) => rules::safety_type::finding(what, name, type_name, span),
        TypeProblem::NoLayout(name) => {
            let message = format!(
                "a safety tag may be a {name}, but no admitted instruction uses one and its layout is not published"
            );
            Finding::new(&NOT_SUPPORTED, span, message).help("declare the tag with a type that safety instructions use")
        }
        TypeProblem::Recursive(name) => Finding::new(&BAD_TYPE, span, format!("the type {name} contains itself")),
        TypeProblem::Shape(text) => Finding::new(&BAD_TYPE, span, format!("{type_name}: {text}")),
    };
    match fault.member {
        Some(member) if member != span => finding.label(member, "here"),
        _ => finding,
    }
}

/// What an alias is known to designate.
pub(crate) fn settle_alias(tag: &mut Tag, target: AliasTarget) {
    tag.type_reference = Some(target.reference.type_reference);
    tag.dimensions = target.reference.dimensions;
    tag.kind = TagKind::Alias(Some(Box::new(target)));
}
