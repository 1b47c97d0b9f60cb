//! From a routine of an export to a safety project of its own: the rungs as they stand, and around them what they use,
//! declared Safety.

use std::collections::{BTreeMap, BTreeSet};

use twinrung_catalog::{Element, Instruction as Declaration, OperandKind, PredefinedType};
use twinrung_grammar::tree::{
    AddOnInstruction, Class, DataType, File, Instruction, Name, Operand, ParameterUsage, Program, Routine, RoutineBody,
    Rung, Span, Spanned, Tag, TagKind, TagReference, Task, Usage,
};
use twinrung_grammar::{print_file, read_tag};

use super::certified::stops;
use super::module_tags::{ModuleTags, is_module_tag, plain_name};
use super::scaffold::{SKELETON, declared, fold, ladder, name, plain, safety_tag};
use super::walk::{instructions, instructions_mut, references};

/// A routine as a safety project.
pub struct Idiom {
    /// `Program/Routine`.
    pub name: String,
    /// Rungs of the routine.
    pub rungs: usize,
    /// The project.
    pub file: File,
    /// Its text.
    pub text: String,
    /// Subroutines that are not certified themselves, or not ladder: they stand there empty.
    pub stubs: Vec<String>,
    /// What the rungs name and the export does not declare.
    pub undeclared: BTreeSet<String>,
}

/// Every ladder routine of an export.
pub fn idioms(export: &File) -> Vec<Idiom> {
    let mut list = Vec::new();
    for program in &export.programs {
        for routine in program.routines.iter().filter(|routine| is_written_ladder(routine)) {
            let mut conversion = Conversion::new(export, Some(program));
            conversion.routine(routine);
            list.push(conversion.finish(&format!("{}/{}", program.name, routine.name), routine));
        }
    }
    for add_on in &export.add_on_instructions {
        for routine in add_on.routines.iter().filter(|routine| is_written_ladder(routine)) {
            let mut conversion = Conversion::new(export, None);
            conversion.call(add_on);
            list.push(conversion.finish(&format!("{}/{}", add_on.name, routine.name), routine));
        }
    }
    list
}

fn is_written_ladder(routine: &Routine) -> bool {
    matches!(&routine.body, RoutineBody::Ladder(rungs) if !rungs.is_empty())
}

struct Conversion<'f> {
    export: &'f File,
    program: Option<&'f Program>,
    modules: ModuleTags<'f>,
    tags: BTreeMap<String, Tag>,
    program_tags: BTreeMap<String, Tag>,
    types: BTreeMap<String, DataType>,
    add_ons: BTreeMap<String, AddOnInstruction>,
    routines: Vec<Routine>,
    stubs: Vec<String>,
    undeclared: BTreeSet<String>,
    /// Routines whose subroutines are being judged.
    judged: Vec<String>,
}

impl<'f> Conversion<'f> {
    fn new(export: &'f File, program: Option<&'f Program>) -> Conversion<'f> {
        Conversion {
            export,
            program,
            modules: ModuleTags::new(export),
            tags: BTreeMap::new(),
            program_tags: BTreeMap::new(),
            types: BTreeMap::new(),
            add_ons: BTreeMap::new(),
            routines: Vec::new(),
            stubs: Vec::new(),
            undeclared: BTreeSet::new(),
            judged: Vec::new(),
        }
    }

    /// A routine of the program, with the subroutines that it calls.
    fn routine(&mut self, routine: &Routine) {
        if self.routines.iter().any(|one| one.name.is(routine.name.as_str())) {
            return;
        }
        let at = self.routines.len();
        self.routines.push(Routine { usage: Usage::Target, attributes: Vec::new(), ..routine.clone() });
        let mut rungs = routine.rungs().to_vec();
        for rung in &mut rungs {
            for instruction in instructions(&rung.elements) {
                self.instruction(instruction);
            }
        }
        self.rename_module_tags(&mut rungs);
        self.routines[at].body = RoutineBody::Ladder(rungs);
    }

    fn instruction(&mut self, instruction: &Instruction) {
        let declaration = Declaration::by_mnemonic(instruction.mnemonic.as_str());
        let add_on = self.export.add_on_instructions.iter().find(|one| one.name.is(instruction.mnemonic.as_str()));
        if let Some(add_on) = add_on {
            self.add_on(add_on);
        }
        for (index, operand) in instruction.operands.iter().enumerate() {
            let kind = declaration.and_then(|one| one.operand(index)).map(|one| one.kind);
            if kind == Some(OperandKind::Routine) {
                self.subroutine(operand, instruction.operands.get(2..).unwrap_or_default());
            }
            let argument = index.checked_sub(1).and_then(|at| add_on.and_then(|add_on| argument_type(add_on, at)));
            let used_as = argument.unwrap_or_else(|| type_of_use(kind));
            for reference in references(operand) {
                let found = self.reference(&reference, &used_as);
                if !found && kind.is_none_or(names_a_tag) {
                    self.undeclared.insert(reference.base.text.to_string());
                }
            }
        }
    }

    /// Carries over what a reference names; false when the export does not declare it.
    fn reference(&mut self, reference: &TagReference, used_as: &str) -> bool {
        if is_module_tag(reference.base.as_str()) {
            self.modules.note(reference.base.as_str(), &reference.parts, used_as);
            return true;
        }
        let own = self.program.and_then(|program| find(&program.tags, reference.base.as_str()));
        let (tag, is_own) = match own {
            Some(tag) => (tag, true),
            None => match find(&self.export.tags, reference.base.as_str()) {
                Some(tag) => (tag, false),
                None => return matches!(reference.base.text.split_once(':'), Some(("S" | "s", _))),
            },
        };
        if let TagKind::Alias(target) = &tag.kind
            && let Ok(mut target) = read_tag(target)
        {
            target.parts.extend(reference.parts.iter().cloned());
            self.reference(&target, used_as);
        }
        let known = if is_own { &self.program_tags } else { &self.tags };
        if !known.contains_key(&fold(tag.name.as_str())) {
            self.tag(tag, is_own);
        }
        true
    }

    fn tag(&mut self, tag: &Tag, is_own: bool) {
        let mut carried = plain(tag);
        if let TagKind::Alias(target) = &tag.kind {
            carried.kind = TagKind::Alias(Box::new(self.modules.renamed(target)));
            carried.data_type = None;
            carried.data = Vec::new();
            carried.class = None;
        } else if let Some(data_type) = &tag.data_type {
            self.data_type(data_type.as_str());
            self.drop_data_by_name(&mut carried);
            carried.data_type = Some(name(plain_name(data_type.as_str())));
        }
        let list = if is_own { &mut self.program_tags } else { &mut self.tags };
        list.insert(fold(tag.name.as_str()), carried);
    }

    /// The data of an instance, and of a module's type, stand in the export by member name alone, which text has no words for.
    fn drop_data_by_name(&self, tag: &mut Tag) {
        let Some(data_type) = tag.data_type.as_ref().map(Name::as_str) else { return };
        if data_type.contains(':') || self.export.add_on_instructions.iter().any(|one| one.name.is(data_type)) {
            tag.data.clear();
        }
    }

    /// Carries over a type that the export declares, and the types within it.
    fn data_type(&mut self, wanted: &str) {
        if Element::by_name(wanted).is_some() || PredefinedType::by_name(wanted).is_some() {
            return;
        }
        if let Some(add_on) = self.export.add_on_instructions.iter().find(|one| one.name.is(wanted)) {
            return self.add_on(add_on);
        }
        if wanted.contains(':') {
            self.modules.note_type(wanted);
            return;
        }
        let declared = self.export.data_types.iter().find(|one| one.name.is(wanted));
        let Some(declared) = declared.filter(|_| !self.types.contains_key(&fold(wanted))) else { return };
        let mut carried =
            DataType { usage: Usage::Target, attributes: Vec::new(), type_class: None, ..declared.clone() };
        self.types.insert(fold(wanted), carried.clone());
        for member in &mut carried.members {
            if member.bit.is_none() {
                self.data_type(member.data_type.as_str());
                member.data_type = name(plain_name(member.data_type.as_str()));
            }
        }
        self.types.insert(fold(wanted), carried);
    }

    /// Carries over an Add-On Instruction as one of class Safety, and what it needs.
    fn add_on(&mut self, declared: &AddOnInstruction) {
        let key = fold(declared.name.as_str());
        if self.add_ons.contains_key(&key) {
            return;
        }
        let mut carried = AddOnInstruction {
            usage: Usage::Target,
            class: Some(Spanned::new(Class::Safety, Span::default())),
            islands: Vec::new(),
            attributes: Vec::new(),
            ..declared.clone()
        };
        self.add_ons.insert(key.clone(), carried.clone());
        for parameter in &mut carried.parameters {
            if let Some(data_type) = &mut parameter.data_type {
                self.data_type(data_type.as_str());
                *data_type = name(plain_name(data_type.as_str()));
            }
            parameter.attributes = Vec::new();
        }
        for tag in &mut carried.local_tags {
            self.drop_data_by_name(tag);
            if let Some(data_type) = &mut tag.data_type {
                self.data_type(data_type.as_str());
                *data_type = name(plain_name(data_type.as_str()));
            }
            tag.attributes = Vec::new();
        }
        for routine in &mut carried.routines {
            routine.attributes = Vec::new();
            for instruction in routine.rungs().iter().flat_map(|rung| instructions(&rung.elements)) {
                let called =
                    self.export.add_on_instructions.iter().find(|one| one.name.is(instruction.mnemonic.as_str()));
                called.into_iter().for_each(|called| self.add_on(called));
            }
        }
        self.add_ons.insert(key, carried);
    }

    /// The routine that a JSR names; one that is not certified stands there empty, and is a routine of the table itself.
    fn subroutine(&mut self, operand: &Operand, parameters: &[Operand]) {
        let routines = self.program.map_or(&[][..], |program| &program.routines);
        let Some(routine) = routines.iter().find(|one| one.name.is(&operand.text)) else {
            self.undeclared.insert(operand.text.to_string());
            return;
        };
        if self.routines.iter().any(|one| one.name.is(routine.name.as_str())) {
            return;
        }
        if self.is_certified(routine) {
            return self.routine(routine);
        }
        self.stubs.push(routine.name.text.to_string());
        let body = self.stub(parameters);
        self.routines.push(Routine { body, usage: Usage::Target, attributes: Vec::new(), ..routine.clone() });
    }

    fn is_certified(&self, routine: &Routine) -> bool {
        if self.judged.contains(&fold(routine.name.as_str())) {
            return true;
        }
        let mut alone = Conversion::new(self.export, self.program);
        alone.judged.clone_from(&self.judged);
        alone.judged.push(fold(routine.name.as_str()));
        alone.routine(routine);
        is_written_ladder(routine) && stops(&alone.finish("", routine)).is_empty()
    }

    /// Takes and returns as many parameters as its call passes, and does nothing.
    fn stub(&mut self, parameters: &[Operand]) -> RoutineBody {
        let mut received = Vec::new();
        for parameter in parameters {
            let own = self.program.and_then(|program| find(&program.tags, &parameter.text));
            let Some(tag) = own.or_else(|| find(&self.export.tags, &parameter.text)) else { continue };
            let stub = Tag { name: name(format!("Stub_{}", tag.name)), ..plain(tag) };
            received.push(stub.name.text.to_string());
            self.program_tags.insert(fold(stub.name.as_str()), stub);
        }
        match received.pop() {
            Some(returned) => ladder(&[format!("SBR({})", received.join(",")), format!("RET({returned})")]),
            None => ladder(&["NOP()".to_owned()]),
        }
    }

    /// A routine that calls an Add-On Instruction with tags of its parameters' types.
    fn call(&mut self, add_on: &AddOnInstruction) {
        self.add_on(add_on);
        self.tags.insert("instance".to_owned(), safety_tag("Instance", add_on.name.as_str()));
        let mut arguments = vec!["Instance".to_owned()];
        for parameter in add_on.parameters.iter().filter(|one| is_argument(one)) {
            let given = format!("Given_{}", parameter.name);
            let data_type = parameter.data_type.as_ref().map_or_else(String::new, |one| plain_name(one.as_str()));
            let tag = Tag { dimensions: parameter.dimensions, ..safety_tag(&given, &data_type) };
            self.tags.insert(fold(&given), tag);
            arguments.push(given);
        }
        let mut skeleton = declared("ROUTINE Main END_ROUTINE");
        let main = Routine {
            body: ladder(&[format!("{}({})", add_on.name, arguments.join(","))]),
            ..skeleton.routines.remove(0)
        };
        self.routines.push(main);
    }

    fn rename_module_tags(&self, rungs: &mut [Rung]) {
        for instruction in rungs.iter_mut().flat_map(|rung| instructions_mut(&mut rung.elements)) {
            for operand in instruction.operands.iter_mut().filter(|operand| operand.text.contains(':')) {
                *operand = self.modules.renamed(operand);
            }
        }
    }

    fn finish(mut self, title: &str, routine: &Routine) -> Idiom {
        let modules = declared(&self.modules.declarations());
        let mut file = declared(SKELETON);
        file.data_types = self.types.into_values().chain(modules.data_types).collect();
        file.add_on_instructions = self.add_ons.into_values().collect();
        file.tags = self.tags.into_values().chain(modules.tags).collect();
        file.programs[0].main_routine = self.routines.first().map(|routine| routine.name.clone());
        file.programs[0].tags = self.program_tags.into_values().collect();
        file.programs[0].routines = self.routines;
        let events = self.export.tasks.iter().filter(|task| task.task_type.as_ref().is_some_and(|one| one.is("EVENT")));
        file.tasks.extend(events.map(|task| Task { programs: Vec::new(), ..task.clone() }));
        Idiom {
            name: title.to_owned(),
            rungs: routine.rungs().len(),
            text: print_file(&file),
            file,
            stubs: std::mem::take(&mut self.stubs),
            undeclared: std::mem::take(&mut self.undeclared),
        }
    }
}

fn find<'t>(tags: &'t [Tag], wanted: &str) -> Option<&'t Tag> {
    tags.iter().find(|tag| tag.name.is(wanted))
}

/// Whether a call writes an argument for a parameter: InOut always, the others when required, an Input when silent.
fn is_argument(parameter: &twinrung_grammar::tree::Parameter) -> bool {
    let usage = parameter.usage.map_or(ParameterUsage::Input, |usage| usage.value);
    let is_enable = parameter.name.is("EnableIn") || parameter.name.is("EnableOut");
    let required = parameter.required.map_or(usage == ParameterUsage::Input, |required| required.value);
    !is_enable && (usage == ParameterUsage::InOut || required)
}

fn argument_type(add_on: &AddOnInstruction, index: usize) -> Option<String> {
    let parameter = add_on.parameters.iter().filter(|one| is_argument(one)).nth(index)?;
    parameter.data_type.as_ref().map(|one| one.text.to_string())
}

fn type_of_use(kind: Option<OperandKind>) -> String {
    match kind {
        Some(OperandKind::Bit(_) | OperandKind::SafetyBit { .. }) => "BOOL".to_owned(),
        Some(OperandKind::Structure(wanted, _)) => wanted.name.to_owned(),
        _ => "DINT".to_owned(),
    }
}

/// Whether a name in this operand is the name of a tag, and no word, label or routine.
fn names_a_tag(kind: OperandKind) -> bool {
    !matches!(
        kind,
        OperandKind::FileMode
            | OperandKind::ByteOrder
            | OperandKind::Label
            | OperandKind::LabelDefinition
            | OperandKind::Routine
            | OperandKind::EventTask
            | OperandKind::SystemClass
            | OperandKind::SystemInstance
            | OperandKind::SystemAttribute
            | OperandKind::Choice(_)
    )
}
