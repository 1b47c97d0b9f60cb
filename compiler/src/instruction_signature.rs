//! The instruction signature of a safety Add-On Instruction: which content was sealed. It covers everything that a person wrote into
//! the definition, comments and descriptions among it, and the types and instructions that it uses. (1756-RM093 Appendix B; how the
//! maker computes his is not published: this one is decided.)
//!
//! ```text
//! part = SHA-256("twinrung instruction part 2", canonical text without data, initial values)
//! ID   = SHA-256("twinrung instruction 2", name, part of the definition and of all that it uses *)
//! ```
//!
//! What only says the same in another way is not part of it: what the file states and the language assumes anyway, numbers of
//! rungs, dates and authors, signatures, the history. A file can write data in several forms; the initial values are therefore
//! the cells that the compiler has read, whatever they were read from.

use sha2::{Digest, Sha256};
use twinrung_bytecode::signature::of_long_form;
use twinrung_grammar::print_file;
use twinrung_grammar::tree::{
    AddOnInstruction, Attribute, AttributeValue, Class, CompactString, DataType, Element, File, Name, Parameter,
    ParameterUsage, Routine, RoutineBody, Span, Spanned, Tag, Text, Usage,
};

use crate::names::{Map, Set, fold};
use crate::project::data::Region;
use crate::project::{Project, is_argument};

/// The attribute that holds the ID, in 64 hexadecimal digits.
pub const ID: &str = "InstructionSignature";
/// The attribute that holds its date and time.
pub const TIMESTAMP: &str = "InstructionSignatureTimestamp";
/// The attribute that holds the maker's ID.
pub const MAKER_ID: &str = "SignatureID";
/// The attribute that holds the date and time of the maker's ID.
pub const MAKER_TIMESTAMP: &str = "SignatureTimestamp";
/// The attribute that says when the maker's tool last changed the instruction.
pub const MAKER_EDITED: &str = "EditedDate";
/// Entries that a signature history holds (1756-RM093 Appendix B).
pub const HISTORY_ENTRIES_MAX: usize = 6;

/// Attributes that are content: a person wrote them.
const CONTENT: [&str; 3] = ["RevisionExtension", "RevisionNote", "AdditionalHelpText"];

/// What a file says of a seal.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Seal {
    /// The ID that is stated.
    pub id: [u8; 32],
    /// Its date and time.
    pub timestamp: CompactString,
    /// Where the ID stands.
    pub span: Span,
}

/// A seal that cannot be read.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct BrokenSeal {
    /// What is wrong with it.
    pub message: &'static str,
    /// Where.
    pub span: Span,
}

/// The safety Add-On Instructions that files define.
pub fn safety_add_ons<'t>(files: &[&'t File]) -> impl Iterator<Item = &'t AddOnInstruction> {
    let is_safety = |one: &&AddOnInstruction| {
        one.usage != Usage::Reference && one.class.is_some_and(|class| class.value == Class::Safety)
    };
    files.iter().flat_map(|file| &file.add_on_instructions).filter(is_safety).collect::<Vec<_>>().into_iter()
}

/// The text of an attribute, where the component has it.
pub fn attribute<'t>(attributes: &'t [Attribute], key: &str) -> Option<&'t Text> {
    attributes.iter().find(|one| one.key.is(key)).and_then(|one| one.value.text())
}

/// The seal of an Add-On Instruction; nothing where it has none.
///
/// # Errors
///
/// The ID is not 64 hexadecimal digits, or it has no date and time, or these stand without an ID.
pub fn seal(shown: &AddOnInstruction) -> Result<Option<Seal>, BrokenSeal> {
    let (id, timestamp) = (attribute(&shown.attributes, ID), attribute(&shown.attributes, TIMESTAMP));
    match (id, timestamp) {
        (None, None) => Ok(None),
        (None, Some(timestamp)) => Err(BrokenSeal {
            message: "the date and time of an instruction signature that is not there",
            span: timestamp.span,
        }),
        (Some(id), timestamp) => {
            let broken = |message| BrokenSeal { message, span: id.span };
            let timestamp = timestamp.ok_or_else(|| broken("the instruction signature has no date and time"))?;
            let bytes = of_long_form(&id.text)
                .ok_or_else(|| broken("the instruction signature is not 64 hexadecimal digits"))?;
            Ok(Some(Seal { id: bytes, timestamp: timestamp.text.clone(), span: id.span }))
        }
    }
}

/// Sets the seal of an Add-On Instruction, or removes it.
pub fn set_seal(shown: &mut AddOnInstruction, seal: Option<(String, String)>) {
    shown.attributes.retain(|one| !one.key.is(ID) && !one.key.is(TIMESTAMP));
    if let Some((id, timestamp)) = seal {
        for (key, value) in [(ID, id), (TIMESTAMP, timestamp)] {
            shown.attributes.push(quoted(key, value));
        }
    }
}

/// An attribute with a quoted value.
pub fn quoted(key: &str, value: impl Into<CompactString>) -> Attribute {
    let span = Span::default();
    Attribute { key: Name::new(key, span), value: AttributeValue::Quoted(Text::new(value, span)) }
}

/// A type or an Add-On Instruction: what of it is signed.
struct Part {
    hash: [u8; 32],
    /// Names of what it uses, folded.
    uses: Vec<CompactString>,
}

/// What instances hold before anything runs, by folded name of the Add-On Instruction, where that is not 0.
type Initial<'p> = Map<CompactString, &'p Region>;

/// All that the safety Add-On Instructions of a project can use, by folded name.
pub struct Definitions<'p> {
    initial: Initial<'p>,
    types: Map<CompactString, Part>,
    add_ons: Map<CompactString, Part>,
}

impl<'p> Definitions<'p> {
    /// The definitions that are compiled: of each name the first that is no mere reference (neutral-text-and-l5x.md D.1).
    pub fn new(files: &[&File], project: &'p Project) -> Definitions<'p> {
        let built = project.add_ons.iter().filter_map(|one| {
            let region = project.defaults.of(one.instance_type?)?;
            Some((fold(&one.name), region))
        });
        let mut all = Definitions { initial: built.collect(), types: Map::default(), add_ons: Map::default() };
        let compiled = |usage: Usage| usage != Usage::Reference;
        for one in files.iter().flat_map(|file| &file.data_types).filter(|one| compiled(one.usage)) {
            all.types.entry(fold(one.name.as_str())).or_insert_with(|| type_part(one));
        }
        for one in files.iter().flat_map(|file| &file.add_on_instructions).filter(|one| compiled(one.usage)) {
            all.add_ons.entry(fold(one.name.as_str())).or_insert_with(|| add_on_part(one, &all.initial));
        }
        all
    }

    /// The ID that the content of a safety Add-On Instruction gives.
    pub fn signature(&self, shown: &AddOnInstruction) -> [u8; 32] {
        let own = add_on_part(shown, &self.initial);
        let mut seen: Set<CompactString> = Set::default();
        seen.insert(fold(shown.name.as_str()));
        let mut open = own.uses;
        let mut used: Vec<(CompactString, [u8; 32])> = Vec::new();
        while let Some(name) = open.pop() {
            if !seen.insert(name.clone()) {
                continue;
            }
            for part in [self.types.get(&name), self.add_ons.get(&name)].into_iter().flatten() {
                open.extend(part.uses.iter().filter(|name| !seen.contains(*name)).cloned());
                used.push((name.clone(), part.hash));
            }
        }
        // A type and an instruction of one name stay in the order in which they were taken.
        used.sort_by(|one, other| one.0.cmp(&other.0));
        let mut hash = Sha256::new_with_prefix(b"twinrung instruction 2\0");
        closed(&mut hash, shown.name.as_str().as_bytes());
        hash.update(own.hash);
        used.iter().for_each(|(_, part)| hash.update(part));
        hash.finalize().into()
    }
}

/// A part of a hash that its length closes off from the next.
fn closed(hash: &mut Sha256, part: &[u8]) {
    hash.update(part);
    hash.update((part.len() as u64).to_le_bytes());
}

fn part(content: &File, bits: &[u8], words: &[i32]) -> [u8; 32] {
    let mut hash = Sha256::new_with_prefix(b"twinrung instruction part 2\0");
    closed(&mut hash, print_file(content).as_bytes());
    closed(&mut hash, bits);
    closed(&mut hash, &words.iter().flat_map(|word| word.to_le_bytes()).collect::<Vec<u8>>());
    hash.finalize().into()
}

fn type_part(one: &DataType) -> Part {
    let content = DataType { usage: Usage::Target, attributes: Vec::new(), ..one.clone() };
    let content = File { data_types: vec![content], ..File::default() };
    let uses = one.members.iter().map(|member| fold(&member.data_type.text)).collect();
    Part { hash: part(&content, &[], &[]), uses }
}

fn add_on_part(one: &AddOnInstruction, initial: &Initial<'_>) -> Part {
    let content = File { add_on_instructions: vec![only_content(one)], ..File::default() };
    let (bits, words) =
        initial.get(&fold(one.name.as_str())).map_or((&[][..], &[][..]), |region| (&region.bits, &region.words));
    Part { hash: part(&content, bits, words), uses: used_by(one) }
}

/// Names that a definition uses, folded: types, and instructions, those that are built in among them.
fn used_by(shown: &AddOnInstruction) -> Vec<CompactString> {
    let parameters = shown.parameters.iter().filter_map(|one| one.data_type.as_ref());
    let locals = shown.local_tags.iter().filter_map(|one| one.data_type.as_ref());
    let mut names: Vec<CompactString> = parameters.chain(locals).map(|name| fold(&name.text)).collect();
    let mut open: Vec<&Element> =
        shown.routines.iter().flat_map(Routine::rungs).flat_map(|rung| &rung.elements).collect();
    while let Some(element) = open.pop() {
        match element {
            Element::Instruction(instruction) => names.push(fold(&instruction.mnemonic.text)),
            Element::Branch(branch) => open.extend(branch.legs.iter().flat_map(|leg| &leg.elements)),
        }
    }
    names
}

fn only_content(shown: &AddOnInstruction) -> AddOnInstruction {
    let mut one = shown.clone();
    one.usage = Usage::Target;
    one.class = Some(Spanned::new(Class::Safety, Span::default()));
    for flag in [&mut one.execute_prescan, &mut one.execute_postscan, &mut one.execute_enable_in_false] {
        *flag = flag.filter(|flag| flag.value);
    }
    one.attributes = CONTENT
        .iter()
        .filter_map(|key| attribute(&shown.attributes, key).map(|text| quoted(key, text.text.clone())))
        .collect();
    one.history.clear();
    one.islands.clear();
    one.parameters.retain(|parameter| !parameter.name.is("EnableIn") && !parameter.name.is("EnableOut"));
    one.parameters.iter_mut().for_each(parameter);
    one.local_tags.iter_mut().for_each(local);
    one.routines.iter_mut().for_each(routine);
    one
}

fn parameter(one: &mut Parameter) {
    let required = is_argument(one);
    one.usage.get_or_insert(Spanned::new(ParameterUsage::Input, Span::default()));
    one.required = Some(Spanned::new(required, Span::default()));
    one.visible.get_or_insert(Spanned::new(required, Span::default()));
    one.constant = one.constant.filter(|constant| constant.value);
    one.radix = one.radix.take().filter(|radix| !is_usual(radix, one.data_type.as_ref()));
    one.attributes.clear();
    one.default.clear();
}

fn local(one: &mut Tag) {
    one.usage = Usage::Target;
    one.class = None;
    one.constant = one.constant.filter(|constant| constant.value);
    one.radix = one.radix.take().filter(|radix| !is_usual(radix, one.data_type.as_ref()));
    one.attributes.clear();
    one.joins_previous = false;
    one.data.clear();
}

fn routine(one: &mut Routine) {
    one.usage = Usage::Target;
    one.attributes.clear();
    if let RoutineBody::Ladder(rungs) = &mut one.body {
        rungs.iter_mut().for_each(|rung| rung.number = None);
    }
}

/// Whether a radix is the one that a tag of this type has where nobody says another.
fn is_usual(radix: &Name, data_type: Option<&Name>) -> bool {
    radix.is(if data_type.is_some_and(|name| name.is("REAL")) { "Float" } else { "Decimal" })
}
