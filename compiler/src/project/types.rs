//! Structure types: resolved by name when something uses them, each after the types of its members.

use twinrung_bytecode::image::{MemberRecord, TypeKind, TypeRecord, TypeReference, Usage};
use twinrung_bytecode::index::{AddOnIndex, TypeIndex};
use twinrung_bytecode::layout::{LayoutError, TypeLayout, elements, layout};
use twinrung_bytecode::limits;
use twinrung_catalog::{Element, PredefinedType};
use twinrung_grammar::tree::{self, CompactString, Span, Value};

use super::packed_bits;
use crate::names::{Map, Set, fold};

/// Why a name is no type that safety data can have.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum TypeProblem {
    /// No type of this name is declared.
    Unknown(CompactString),
    /// A type of the controller that no safety tag may have (1756-RM093 Table 7).
    NotSafe(CompactString),
    /// A type that safety tags may have but whose layout is not published.
    NoLayout(CompactString),
    /// It contains itself.
    Recursive(CompactString),
    /// It cannot be laid out: why.
    Shape(&'static str),
}

/// A problem and the member of a type where it lies.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TypeFault {
    /// What is wrong.
    pub problem: TypeProblem,
    /// The member that has it, when it lies within a structure.
    pub member: Option<Span>,
}

impl From<TypeProblem> for TypeFault {
    fn from(problem: TypeProblem) -> TypeFault {
        TypeFault { problem, member: None }
    }
}

/// A member that a type will have.
struct Draft {
    name: CompactString,
    data_type: CompactString,
    dimensions: [u32; 3],
    span: Span,
}

enum State {
    /// Declared, not used so far.
    Declared(Vec<Draft>, TypeKind),
    /// Its members are being resolved.
    Building,
    /// In the table.
    Ready(TypeIndex),
    /// Cannot be used.
    Faulty(TypeFault),
}

/// The structure types that something uses.
#[derive(Default)]
pub struct Types {
    records: Vec<TypeRecord>,
    layouts: Vec<TypeLayout>,
    states: Map<CompactString, State>,
    /// Names as declared, where that is not lower case.
    spellings: Map<CompactString, CompactString>,
    depth: usize,
}

impl std::fmt::Debug for Types {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_list().entries(self.records.iter().map(|record| &record.name)).finish()
    }
}

impl Types {
    /// The types, each after those that its members use.
    pub fn records(&self) -> &[TypeRecord] {
        &self.records
    }

    /// Their layouts.
    pub fn layouts(&self) -> &[TypeLayout] {
        &self.layouts
    }

    /// One type.
    pub fn record(&self, index: TypeIndex) -> &TypeRecord {
        &self.records[index.position()]
    }

    /// The layout of one type.
    pub fn layout(&self, index: TypeIndex) -> &TypeLayout {
        &self.layouts[index.position()]
    }

    /// The name of a type, as declarations write it.
    pub fn name(&self, reference: TypeReference) -> &str {
        match reference {
            TypeReference::Element(element) => element.name(),
            TypeReference::Structure(index) => &self.record(index).name,
        }
    }

    /// Bit and word cells of one element of a type.
    pub fn cells(&self, reference: TypeReference) -> (u32, u32) {
        match reference {
            TypeReference::Element(Element::Bool) => (1, 0),
            TypeReference::Element(_) => (0, 1),
            TypeReference::Structure(index) => {
                let layout = self.layout(index);
                (layout.bit_cells, layout.word_cells)
            }
        }
    }

    /// The member of a structure with this name.
    pub fn member(&self, index: TypeIndex, name: &str) -> Option<u16> {
        let members = &self.record(index).members;
        members.iter().position(|member| member.name.eq_ignore_ascii_case(name)).map(|at| at as u16)
    }

    /// Whether a REAL lies anywhere within it.
    pub fn holds_real(&self, reference: TypeReference) -> bool {
        match reference {
            TypeReference::Element(element) => element == Element::Real,
            TypeReference::Structure(index) => self.layout(index).holds_real,
        }
    }

    /// The declaration of a predefined type.
    pub fn predefined(&self, reference: TypeReference) -> Option<&'static PredefinedType> {
        match reference {
            TypeReference::Structure(index) if self.record(index).kind == TypeKind::Predefined => {
                PredefinedType::by_name(&self.record(index).name)
            }
            _ => None,
        }
    }

    /// Whether a structure of this name is declared or known.
    pub fn knows(&self, name: &str) -> bool {
        self.states.contains_key(&fold(name)) || PredefinedType::by_name(name).is_some()
    }

    /// Names of everything that a declaration could mean, for suggestions.
    pub fn candidate_names(&self) -> impl Iterator<Item = &str> {
        let elementary = Element::ALL.into_iter().map(|element| -> &str { element.name() });
        elementary.chain(self.states.keys().map(CompactString::as_str))
    }

    /// Declares a user-defined type. The first declaration of a name counts.
    pub fn declare(&mut self, data_type: &tree::DataType) {
        let drafts = data_type.members.iter().filter(|member| !member.hidden).map(|member| Draft {
            name: member.name.text.clone(),
            data_type: if member.bit.is_some() { "BOOL".into() } else { member.data_type.text.clone() },
            dimensions: dimensions(member.dimensions),
            span: member.data_type.span,
        });
        let state = match packed_bits::fault(data_type) {
            Some((place, why)) => State::Faulty(TypeFault { problem: TypeProblem::Shape(why), member: Some(place) }),
            None => State::Declared(drafts.collect(), TypeKind::User),
        };
        self.states.entry(fold(&data_type.name.text)).or_insert(state);
        self.spell(&data_type.name.text);
    }

    /// Declares the instance type of an Add-On Instruction.
    pub fn declare_add_on(
        &mut self,
        index: AddOnIndex,
        name: &str,
        members: Vec<(CompactString, CompactString, [u32; 3], Span)>,
    ) {
        let drafts = members
            .into_iter()
            .map(|(name, data_type, dimensions, span)| Draft { name, data_type, dimensions, span })
            .collect();
        self.states.entry(fold(name)).or_insert(State::Declared(drafts, TypeKind::AddOn(index)));
        self.spell(name);
    }

    /// Notes a name that is a type, and none of safety data: that of an Add-On Instruction of class Standard.
    pub fn declare_not_safe(&mut self, name: &str) {
        let fault = TypeProblem::NotSafe(name.into()).into();
        self.states.entry(fold(name)).or_insert(State::Faulty(fault));
    }

    /// Declares a structure that no declaration in reach describes, from decorated data that shows it: the type of a
    /// module's tag (neutral-text-and-l5x.md D.3). No effect when the name is known.
    pub fn declare_as_shown(&mut self, value: &Value) {
        let Value::Structure { data_type, members, .. } = value else {
            if let Value::Array { elements, .. } = value
                && let Some((_, first)) = elements.first()
            {
                self.declare_as_shown(first);
            }
            return;
        };
        if self.knows(data_type) || Element::by_name(data_type).is_some() {
            return;
        }
        let mut drafts = Vec::new();
        for member in members {
            self.declare_as_shown(&member.value);
            let (shown, dimensions) = match &member.value {
                Value::Structure { data_type, .. } => (data_type.clone(), [0; 3]),
                Value::Array { data_type, dimensions: shown, .. } => (data_type.clone(), dimensions(*shown)),
                _ => (member.data_type.clone(), [0; 3]),
            };
            let data_type = if shown.is_empty() { member.data_type.clone() } else { shown };
            drafts.push(Draft { name: member.name.text.clone(), data_type, dimensions, span: member.name.span });
        }
        self.states.insert(fold(data_type), State::Declared(drafts, TypeKind::User));
        self.spell(data_type);
    }

    /// Declares a structure by its members: a module's tag that the catalog describes.
    pub fn declare_members(&mut self, name: &str, members: Vec<(CompactString, CompactString, [u32; 3], Span)>) {
        let drafts = members
            .into_iter()
            .map(|(name, data_type, dimensions, span)| Draft { name, data_type, dimensions, span })
            .collect();
        self.states.entry(fold(name)).or_insert(State::Declared(drafts, TypeKind::User));
        self.spell(name);
    }

    fn spell(&mut self, name: &str) {
        let folded = fold(name);
        if folded != name {
            self.spellings.entry(folded).or_insert_with(|| name.into());
        }
    }

    /// The type of this name, resolved with everything that it contains.
    ///
    /// # Errors
    /// When it, or a type within it, is none that safety data can have.
    pub fn resolve(&mut self, name: &str) -> Result<TypeReference, TypeFault> {
        if let Some(element) = Element::by_name(name) {
            return Ok(TypeReference::Element(element));
        }
        self.structure(name).map(TypeReference::Structure)
    }

    /// Bounded: a structure that is being built is refused, and depth is limited.
    fn structure(&mut self, name: &str) -> Result<TypeIndex, TypeFault> {
        let folded = fold(name);
        match self.states.get_mut(&folded) {
            Some(State::Ready(index)) => return Ok(*index),
            Some(State::Faulty(fault)) => return Err(fault.clone()),
            Some(State::Building) => return Err(TypeProblem::Recursive(name.into()).into()),
            Some(state @ State::Declared(..)) => {
                let State::Declared(drafts, kind) = std::mem::replace(state, State::Building) else {
                    return Err(TypeProblem::Recursive(name.into()).into());
                };
                let spelled = self.spellings.get(&folded).cloned().unwrap_or_else(|| folded.clone());
                let outcome = self.build(&spelled, drafts, kind);
                return self.settle(folded, outcome);
            }
            None => {}
        }
        if let Some(known) = PredefinedType::by_name(name) {
            let members = known.members.iter().map(|member| MemberRecord {
                name: member.name.into(),
                type_reference: TypeReference::Element(member.element),
                dimensions: [member.length, 0, 0],
            });
            let record = TypeRecord { name: known.name.into(), kind: TypeKind::Predefined, members: members.collect() };
            let outcome = self.add(record).map_err(TypeFault::from);
            return self.settle(folded, outcome);
        }
        let listed = |list: &[&str]| list.iter().any(|known| known.eq_ignore_ascii_case(name));
        let problem = if listed(twinrung_catalog::types::LISTED_WITHOUT_LAYOUT) {
            TypeProblem::NoLayout(name.into())
        } else if listed(&NOT_SAFE) {
            TypeProblem::NotSafe(name.into())
        } else {
            TypeProblem::Unknown(name.into())
        };
        Err(problem.into())
    }

    fn settle(&mut self, folded: CompactString, outcome: Result<TypeIndex, TypeFault>) -> Result<TypeIndex, TypeFault> {
        let state = match &outcome {
            Ok(index) => State::Ready(*index),
            Err(fault) => State::Faulty(fault.clone()),
        };
        self.states.insert(folded, state);
        outcome
    }

    fn build(&mut self, name: &str, drafts: Vec<Draft>, kind: TypeKind) -> Result<TypeIndex, TypeFault> {
        let mut seen = Set::default();
        for draft in &drafts {
            let problem = if !is_component(&draft.name) {
                "a member's name holds letters, digits and underscores only"
            } else if !seen.insert(fold(&draft.name)) {
                "two members have one name"
            } else {
                continue;
            };
            return Err(TypeFault { problem: TypeProblem::Shape(problem), member: Some(draft.span) });
        }
        if drafts.is_empty() {
            return Err(TypeProblem::Shape("the type has no members").into());
        }
        if !name.split(':').all(|part| part.bytes().all(|byte| byte.is_ascii_alphanumeric() || byte == b'_')) {
            return Err(TypeProblem::Shape("a type's name holds letters, digits and underscores only").into());
        }
        if drafts.len() > limits::MEMBERS {
            return Err(TypeProblem::Shape("a type has too many members").into());
        }
        self.depth += 1;
        let members = if self.depth > limits::TYPE_DEPTH {
            Err(TypeProblem::Shape("types are nested too deeply").into())
        } else {
            drafts.iter().map(|draft| self.member_record(draft)).collect::<Result<Vec<_>, TypeFault>>()
        };
        self.depth -= 1;
        let record = TypeRecord { name: name.into(), kind, members: members? };
        self.add(record).map_err(TypeFault::from)
    }

    fn member_record(&mut self, draft: &Draft) -> Result<MemberRecord, TypeFault> {
        let type_reference = self
            .resolve(&draft.data_type)
            .map_err(|fault| TypeFault { member: fault.member.or(Some(draft.span)), ..fault })?;
        if elements(draft.dimensions).is_none() {
            let problem = TypeProblem::Shape("an array has too many elements");
            return Err(TypeFault { problem, member: Some(draft.span) });
        }
        Ok(MemberRecord { name: draft.name.to_string(), type_reference, dimensions: draft.dimensions })
    }

    fn add(&mut self, record: TypeRecord) -> Result<TypeIndex, TypeProblem> {
        let layout = layout(&record, &self.layouts).map_err(|error| match error {
            LayoutError::BoolArrayLength => {
                TypeProblem::Shape("a BOOL array within a structure has a multiple of 32 elements")
            }
            LayoutError::TooLarge => TypeProblem::Shape("the type is too large or nested too deeply"),
            LayoutError::NotEarlier | LayoutError::NotInCatalog => {
                TypeProblem::Shape("the type does not agree with its declaration")
            }
        })?;
        if self.records.len() >= limits::TYPES {
            return Err(TypeProblem::Shape("there are too many types"));
        }
        self.records.push(record);
        self.layouts.push(layout);
        Ok(TypeIndex((self.records.len() - 1) as u16))
    }
}

/// Whether an image can write this name.
fn is_component(name: &str) -> bool {
    let begins = name.bytes().next().is_some_and(|first| first.is_ascii_alphabetic() || first == b'_');
    begins && name.len() <= limits::NAME_BYTES && name.bytes().all(|byte| byte.is_ascii_alphanumeric() || byte == b'_')
}

/// Dimensions of the tree as an image has them.
pub fn dimensions(shown: tree::Dimensions) -> [u32; 3] {
    let mut sizes = [0; 3];
    for (slot, size) in sizes.iter_mut().zip(shown.sizes()) {
        *slot = *size;
    }
    sizes
}

/// Usage of a parameter as an image has it.
pub fn usage(shown: tree::ParameterUsage) -> Usage {
    match shown {
        tree::ParameterUsage::Input => Usage::Input,
        tree::ParameterUsage::Output => Usage::Output,
        tree::ParameterUsage::InOut => Usage::InOut,
    }
}

/// Types of the controller that are not in Table 7 of 1756-RM093; others of the same kind are unknown to this tool and
/// reported as such.
const NOT_SAFE: [&str; 38] = [
    "LINT",
    "LREAL",
    "USINT",
    "UINT",
    "UDINT",
    "ULINT",
    "TIME",
    "TIME32",
    "LTIME",
    "DT",
    "LDT",
    "MESSAGE",
    "PID",
    "PIDE_AUTOTUNE",
    "PID_ENHANCED",
    "ALARM",
    "ALARM_ANALOG",
    "ALARM_DIGITAL",
    "ALARM_SET",
    "AXIS_CIP_DRIVE",
    "AXIS_CONSUMED",
    "AXIS_GENERIC",
    "AXIS_SERVO",
    "AXIS_SERVO_DRIVE",
    "AXIS_VIRTUAL",
    "CAM",
    "COORDINATE_SYSTEM",
    "MOTION_GROUP",
    "FBD_MATH",
    "FBD_COMPARE",
    "FBD_MATH_ADVANCED",
    "FBD_ONESHOT",
    "FBD_LOGICAL_ADVANCED",
    "FILTER_LOW_PASS",
    "FILTER_HIGH_PASS",
    "SCALE",
    "TOTALIZER",
    "DATALOG_INSTRUCTION",
];
