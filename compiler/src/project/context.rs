//! What names are resolved against, and why something could not be resolved.

use std::cell::{Cell, RefCell};

use twinrung_catalog::Instruction as Declaration;
use twinrung_grammar::tree::{CompactString, ReadError, Span};

use super::{AddOn, AddOnId, OpcodeSet, OperandId, Profile, RoutineId, ScopeNames, Tag, TagId, Types};
use crate::diagnostic::{Finding, Findings, reading_finding};
use crate::names::{Map, Set, fold};
use crate::operand::{self, Operand};
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
