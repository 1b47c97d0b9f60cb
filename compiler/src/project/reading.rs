//! Reading rungs: every mnemonic and operand resolved, what is faulty reported once and left out.

use std::cell::{Cell, RefCell};

use twinrung_bytecode::limits;
use twinrung_catalog::{Instruction as Declaration, OperandKind};
use twinrung_grammar::tree::{self, CompactString, ReadError, Span};

use super::{
    AddOn, AddOnId, Branch, Call, Element, Instruction, OpcodeSet, OperandId, OperandUse, Profile, RoutineId, Rung,
    ScopeNames, Tag, TagId, Types,
};
use crate::diagnostic::{
    DUPLICATE_NAME, EMPTY_RUNG, Finding, Findings, OPERAND_COUNT, OPERAND_MISSING, OVER_LIMIT, reading_finding,
};
use crate::names::{Map, Set, fold};
use crate::operand::{self, Operand, Scope};
use crate::rules;

/// Why something could not be resolved.
#[derive(Debug)]
pub(crate) enum Refusal {
    /// Somebody else has said so.
    Reported,
    /// This.
    Finding(Box<Finding>),
}

impl From<Finding> for Refusal {
    fn from(finding: Finding) -> Refusal {
        Refusal::Finding(Box::new(finding))
    }
}

impl From<&ReadError> for Refusal {
    fn from(error: &ReadError) -> Refusal {
        reading_finding(error).into()
    }
}

impl Refusal {
    /// Reports it.
    pub fn report(self, findings: &mut Findings) {
        if let Refusal::Finding(finding) = self {
            findings.push(*finding);
        }
    }
}

/// Suggestions of one run: looking through all names for each of many errors would take quadratic time.
const SUGGESTIONS_MAX: u32 = 20;

/// Everything that names are resolved against.
pub(crate) struct Context<'a> {
    pub types: &'a Types,
    pub tags: &'a [Tag],
    pub names: &'a ScopeNames,
    pub add_ons: &'a [AddOn],
    pub profile: Option<&'a Profile>,
    pub routine_names: &'a RoutineNames,
    pub event_tasks: &'a [CompactString],
    pub safety_tasks: &'a [CompactString],
    slot_names: RefCell<Set<TagId>>,
    suggestions: Cell<u32>,
    own_routine: Cell<Option<RoutineId>>,
}

/// Names of safety programs and of their routines.
#[derive(Debug, Default)]
pub(crate) struct RoutineNames {
    /// Program by program: fold name to routine, with the spelling.
    pub programs: Vec<Map<CompactString, (RoutineId, CompactString)>>,
    /// Names of the programs, fold case.
    pub program_names: Map<CompactString, super::ProgramId>,
    /// Names of the programs as spelled.
    pub program_spellings: Vec<CompactString>,
}

impl<'a> Context<'a> {
    #[allow(clippy::too_many_arguments)]
    pub fn new(
        types: &'a Types,
        tags: &'a [Tag],
        names: &'a ScopeNames,
        add_ons: &'a [AddOn],
        profile: Option<&'a Profile>,
        routine_names: &'a RoutineNames,
        event_tasks: &'a [CompactString],
        safety_tasks: &'a [CompactString],
    ) -> Context<'a> {
        Context {
            types,
            tags,
            names,
            add_ons,
            profile,
            routine_names,
            event_tasks,
            safety_tasks,
            slot_names: RefCell::default(),
            suggestions: Cell::new(0),
            own_routine: Cell::new(None),
        }
    }

    /// The routine that is being read, what THIS means for a routine.
    pub fn own_routine(&self) -> Option<RoutineId> {
        self.own_routine.get()
    }

    /// Another routine begins.
    pub fn begin_routine(&self, routine: RoutineId) {
        self.own_routine.set(Some(routine));
    }

    /// Notes that the project writes a module's tag by rack and slot.
    pub fn note_slot_name(&self, tag: TagId) {
        self.slot_names.borrow_mut().insert(tag);
    }

    /// The tags that the project writes by rack and slot.
    pub fn into_slot_names(self) -> Set<TagId> {
        self.slot_names.into_inner()
    }

    /// A suggestion, while the run has any left.
    pub fn suggest(&self, search: impl FnOnce() -> Option<String>) -> Option<String> {
        let used = self.suggestions.get();
        if used >= SUGGESTIONS_MAX {
            return None;
        }
        self.suggestions.set(used + 1);
        search()
    }

    /// Refuses a REAL where the controller has none.
    pub fn require_real(&self, span: Span) -> Result<(), Refusal> {
        match self.profile {
            Some(profile) if !profile.has_real() => Err(rules::real::literal(profile, span).into()),
            _ => Ok(()),
        }
    }
}

/// What a mnemonic means.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Meaning {
    /// An instruction of the catalog.
    Catalog(&'static Declaration),
    /// A safety Add-On Instruction.
    AddOn(AddOnId),
    /// An Add-On Instruction of class Standard.
    StandardAddOn,
    /// An Add-On Instruction that is faulty or encoded, and reported as such.
    Reported,
}

/// All mnemonics.
pub(crate) struct Mnemonics {
    table: Map<CompactString, Meaning>,
}

impl Mnemonics {
    /// The catalog's mnemonics and their newer names.
    pub fn new() -> Mnemonics {
        let mut table = Map::default();
        for declaration in twinrung_catalog::instructions::ALL {
            for name in std::iter::once(declaration.mnemonic).chain(declaration.also.iter().copied()) {
                table.insert(fold(name), Meaning::Catalog(declaration));
            }
        }
        Mnemonics { table }
    }

    /// Adds an Add-On Instruction; `false` when the name is taken.
    pub fn add(&mut self, name: &str, meaning: Meaning) -> bool {
        use std::collections::hash_map::Entry;
        match self.table.entry(fold(name)) {
            Entry::Occupied(_) => false,
            Entry::Vacant(slot) => {
                slot.insert(meaning);
                true
            }
        }
    }

    /// What a mnemonic means.
    pub fn find(&self, mnemonic: &str) -> Option<Meaning> {
        self.table.get(&fold(mnemonic)).copied()
    }

    /// All of them, for suggestions.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.table.keys().map(CompactString::as_str)
    }
}

/// Operands of all rungs, each once where that is cheap to see.
#[derive(Default)]
pub(crate) struct Operands {
    pub table: Vec<Operand>,
    /// Instructions that were read.
    pub opcodes: OpcodeSet,
    /// References of the scope that is being read, by their text.
    references: Map<CompactString, OperandId>,
    /// Literals by their text.
    literals: Map<CompactString, OperandId>,
}

impl Operands {
    /// Adds an operand.
    pub fn add(&mut self, operand: Operand) -> OperandId {
        self.table.push(operand);
        OperandId((self.table.len() - 1) as u32)
    }

    /// Forgets references: another scope begins.
    pub fn begin_scope(&mut self) {
        self.references.clear();
    }

    /// The operand of a text that was read as a reference before.
    pub fn known_reference(&self, text: &str) -> Option<OperandId> {
        self.references.get(text).copied()
    }

    /// Adds a reference under its text.
    pub fn add_reference(&mut self, text: &CompactString, reference: operand::Reference) -> OperandId {
        let id = self.add(Operand::Reference(reference));
        self.references.insert(text.clone(), id);
        id
    }

    /// The operand of a text that was read as a literal before.
    pub fn known_literal(&self, text: &str) -> Option<OperandId> {
        self.literals.get(text).copied()
    }

    /// Adds a literal under its text.
    pub fn add_literal(&mut self, text: &CompactString, literal: Operand) -> OperandId {
        let id = self.add(literal);
        self.literals.insert(text.clone(), id);
        id
    }
}

/// Reads the rungs of one routine after the other.
pub(crate) struct RungReader<'a, 'c> {
    pub context: &'a Context<'c>,
    pub mnemonics: &'a Mnemonics,
    pub operands: &'a mut Operands,
    pub findings: &'a mut Findings,
    pub scope: Scope,
    /// Labels of the routine that is being read, fold case, as they are spelled where they are defined.
    pub labels: Map<CompactString, (CompactString, Span)>,
    /// Whether the instruction that is being read writes a system value (SSV).
    pub sets_system_value: bool,
    /// Instructions on the rung so far.
    element: u32,
    incomplete: bool,
}

impl<'a, 'c> RungReader<'a, 'c> {
    pub fn new(
        context: &'a Context<'c>,
        mnemonics: &'a Mnemonics,
        operands: &'a mut Operands,
        findings: &'a mut Findings,
        scope: Scope,
    ) -> RungReader<'a, 'c> {
        RungReader {
            context,
            mnemonics,
            operands,
            findings,
            scope,
            labels: Map::default(),
            sets_system_value: false,
            element: 0,
            incomplete: false,
        }
    }

    /// Finds the labels of a routine before its rungs are read: jumps lead forward too.
    pub fn find_labels(&mut self, rungs: &[tree::Rung]) {
        for rung in rungs {
            // A label that stands elsewhere on its rung is refused where it is read.
            let Some(tree::Element::Instruction(first)) = rung.elements.first() else { continue };
            let ([label], true) = (first.operands.as_slice(), first.mnemonic.is("LBL")) else { continue };
            if let Some((_, known)) = self.labels.get(&fold(&label.text)) {
                let message = format!("the label `{}` is defined twice", label.text);
                let finding = Finding::new(&DUPLICATE_NAME, label.span, message).label(*known, "first defined here");
                self.findings.push(finding.help("rename one of the two"));
                continue;
            }
            self.labels.insert(fold(&label.text), (label.text.clone(), label.span));
        }
    }

    /// Reads one rung.
    pub fn rung(&mut self, shown: &tree::Rung) -> Rung {
        self.element = 0;
        self.incomplete = shown.broken;
        let elements = self.series(&shown.elements);
        if shown.elements.is_empty() && !shown.broken {
            let finding = Finding::new(&EMPTY_RUNG, shown.span, "the rung is empty").help("delete it, or write NOP()");
            self.findings.push(finding);
        }
        if self.element as usize > limits::INSTRUCTIONS_PER_RUNG {
            let message = format!("a rung has at most {} instructions", limits::INSTRUCTIONS_PER_RUNG);
            self.findings.push(Finding::new(&OVER_LIMIT, shown.span, message));
        }
        Rung { elements, kind: shown.kind.value, span: shown.span, incomplete: self.incomplete }
    }

    fn series(&mut self, shown: &[tree::Element]) -> Vec<Element> {
        let mut elements = Vec::with_capacity(shown.len());
        for element in shown {
            match element {
                tree::Element::Instruction(instruction) => {
                    let read = self.instruction(instruction);
                    self.element += 1;
                    match read {
                        Some(instruction) => elements.push(Element::Instruction(instruction)),
                        None => self.incomplete = true,
                    }
                }
                tree::Element::Branch(branch) => {
                    if branch.legs.len() > limits::BRANCH_LEGS {
                        let message = format!("a branch has at most {} legs", limits::BRANCH_LEGS);
                        self.findings.push(Finding::new(&OVER_LIMIT, branch.span, message));
                    }
                    let legs = branch.legs.iter().map(|leg| self.series(&leg.elements)).collect();
                    elements.push(Element::Branch(Branch { legs, span: branch.span }));
                }
            }
        }
        elements
    }

    fn instruction(&mut self, shown: &tree::Instruction) -> Option<Instruction> {
        match self.mnemonics.find(shown.mnemonic.as_str()) {
            Some(Meaning::Catalog(declaration)) => self.catalog_instruction(declaration, shown),
            Some(Meaning::AddOn(add_on)) => self.add_on_call(add_on, shown),
            Some(Meaning::StandardAddOn) => {
                self.findings.push(rules::uncertified::standard_add_on(&shown.mnemonic));
                None
            }
            Some(Meaning::Reported) => None,
            None => {
                let finding = rules::uncertified::finding(self.context, self.mnemonics, &shown.mnemonic);
                self.findings.push(finding);
                None
            }
        }
    }

    fn catalog_instruction(
        &mut self,
        declaration: &'static Declaration,
        shown: &tree::Instruction,
    ) -> Option<Instruction> {
        if let Some(profile) = self.context.profile
            && let Some(finding) = rules::admission::finding(profile, declaration, &shown.mnemonic)
        {
            self.findings.push(finding);
            return None;
        }
        let (least, most) = declaration.operand_count();
        let count = shown.operands.len();
        // `AFI()` is read with one empty operand by some tools, with none by others; the grammar gives none.
        if count < least || most.is_some_and(|most| count > most) || count > limits::OPERANDS_PER_INSTRUCTION {
            let names: Vec<&str> = declaration.operands.iter().map(|operand| operand.name).collect();
            let message = format!("{} has {}, not {count} operands", declaration.mnemonic, count_text(least, most));
            let help = format!("{}({})", declaration.mnemonic, names.join(", "));
            self.findings.push(Finding::new(&OPERAND_COUNT, shown.span, message).help(help));
            return None;
        }
        self.sets_system_value = declaration.opcode == twinrung_catalog::Opcode::Ssv;
        let mut uses = Vec::with_capacity(count);
        let mut faulty = false;
        let mut inputs: Option<usize> = None;
        for (position, operand) in shown.operands.iter().enumerate() {
            let Some(declared) = declaration.operand(position) else { continue };
            let kind = match (declared.kind, inputs) {
                // Of a JSR's parameters the first `Number of Inputs` are read, the others written.
                (OperandKind::Parameter(_), Some(inputs)) => OperandKind::Parameter(if position < 2 + inputs {
                    twinrung_catalog::Access::Read
                } else {
                    twinrung_catalog::Access::Write
                }),
                (kind, _) => kind,
            };
            match self.operand(kind, declared.name, operand, &uses) {
                Ok(id) => {
                    if kind == OperandKind::InputCount {
                        inputs = match self.operands.table[id.position()] {
                            Operand::Integer { value, .. } => usize::try_from(value).ok(),
                            _ => None,
                        };
                    }
                    uses.push(OperandUse { id, span: operand.span });
                }
                Err(refusal) => {
                    refusal.report(self.findings);
                    faulty = true;
                    if !uses_may_go_on(kind) {
                        return None;
                    }
                }
            }
        }
        if faulty {
            return None;
        }
        self.operands.opcodes.insert(declaration.opcode);
        Some(Instruction {
            call: Call::Catalog(declaration),
            operands: uses.into_boxed_slice(),
            element: self.element,
            span: shown.span,
        })
    }

    fn operand(
        &mut self,
        kind: OperandKind,
        name: &'static str,
        shown: &tree::Operand,
        before: &[OperandUse],
    ) -> Result<OperandId, Refusal> {
        let may_be_empty = matches!(kind, OperandKind::SystemInstance);
        if (shown.is_unassigned() && !matches!(kind, OperandKind::Pseudo(_))) || (shown.is_empty() && !may_be_empty) {
            let message = format!("{name} is missing: the rung is unfinished");
            return Err(Finding::new(&OPERAND_MISSING, shown.span, message)
                .help("enter a tag or a value where it is missing")
                .into());
        }
        operand::read(self, kind, name, shown, before)
    }

    fn add_on_call(&mut self, id: AddOnId, shown: &tree::Instruction) -> Option<Instruction> {
        let add_on = &self.context.add_ons[id.position()];
        let arguments: Vec<usize> =
            (0..add_on.parameters.len()).filter(|position| add_on.parameters[*position].argument).collect();
        if shown.operands.len() > limits::OPERANDS_PER_INSTRUCTION {
            let message = format!("an instruction has at most {} operands", limits::OPERANDS_PER_INSTRUCTION);
            self.findings.push(Finding::new(&OVER_LIMIT, shown.span, message));
            return None;
        }
        if shown.operands.len() != arguments.len() + 1 {
            let names: Vec<&str> = arguments.iter().map(|at| add_on.parameters[*at].name.as_str()).collect();
            let message = format!(
                "{} has {}, not {} operands",
                add_on.name,
                count_text(arguments.len() + 1, Some(arguments.len() + 1)),
                shown.operands.len()
            );
            let comma = if names.is_empty() { "" } else { ", " };
            let help = format!("{}(tag of type {}{comma}{})", add_on.name, add_on.name, names.join(", "));
            self.findings.push(Finding::new(&OPERAND_COUNT, shown.span, message).help(help));
            return None;
        }
        let mut uses = Vec::with_capacity(shown.operands.len());
        let mut faulty = false;
        for (position, operand) in shown.operands.iter().enumerate() {
            let missing = operand.is_unassigned() || operand.is_empty();
            let outcome = if missing {
                let finding =
                    Finding::new(&OPERAND_MISSING, operand.span, "an argument is missing: the rung is unfinished");
                Err(finding.help("enter a tag or a value where it is missing").into())
            } else if position == 0 {
                operand::read_instance(self, id, operand)
            } else {
                operand::read_argument(self, id, arguments[position - 1], operand)
            };
            match outcome {
                Ok(id) => uses.push(OperandUse { id, span: operand.span }),
                Err(refusal) => {
                    refusal.report(self.findings);
                    faulty = true;
                }
            }
        }
        if faulty {
            return None;
        }
        Some(Instruction {
            call: Call::AddOn(id),
            operands: uses.into_boxed_slice(),
            element: self.element,
            span: shown.span,
        })
    }
}

/// Whether the operands after a faulty one can still be judged by themselves.
fn uses_may_go_on(kind: OperandKind) -> bool {
    !matches!(kind, OperandKind::InputCount | OperandKind::SystemClass | OperandKind::SystemInstance)
}

fn count_text(least: usize, most: Option<usize>) -> String {
    let plural = |count: usize| if count == 1 { "1 operand".to_owned() } else { format!("{count} operands") };
    match most {
        Some(most) if most == least => plural(least),
        Some(most) => format!("{least} to {most} operands"),
        None => format!("at least {}", plural(least)),
    }
}
