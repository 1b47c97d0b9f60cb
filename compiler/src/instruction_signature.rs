//! The instruction signature of a safety Add-On Instruction: which content was sealed. It covers everything that a person wrote into
//! the definition, comments and descriptions among it, and the types and instructions that it uses. (1756-RM093 Appendix B; how the
//! maker computes his is not published: this one is decided.)
//!
//! ```text
//! ID = SHA-256("twinrung instruction 1", name, canonical text of the definition and of all that it uses)
//! ```
//!
//! What only says the same in another way is not part of it: what the file states and the language assumes anyway, numbers of
//! rungs, dates and authors, signatures, the history.

use std::collections::BTreeMap;

use sha2::{Digest, Sha256};
use twinrung_grammar::print_file;
use twinrung_grammar::tree::{
    AddOnInstruction, Attribute, AttributeValue, Class, CompactString, Data, DataType, Element, File, Name, Parameter,
    ParameterUsage, Routine, RoutineBody, Span, Spanned, Tag, Text, Usage, Value,
};

use crate::names::fold;
use crate::project::is_argument;

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
            let bytes =
                digits(&id.text).ok_or_else(|| broken("the instruction signature is not 64 hexadecimal digits"))?;
            Ok(Some(Seal { id: bytes, timestamp: timestamp.text.clone(), span: id.span }))
        }
    }
}

fn digits(text: &str) -> Option<[u8; 32]> {
    let nibbles: Vec<u8> =
        text.chars().map(|digit| digit.to_digit(16).map(|nibble| nibble as u8)).collect::<Option<_>>()?;
    let bytes: Vec<u8> = nibbles.chunks(2).map(|pair| pair.iter().fold(0, |byte, nibble| byte << 4 | nibble)).collect();
    if nibbles.len() == 64 { bytes.try_into().ok() } else { None }
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

/// The ID that the content of a safety Add-On Instruction gives; `files` declare what it uses.
pub fn instruction_signature(files: &[&File], shown: &AddOnInstruction) -> [u8; 32] {
    let mut hash = Sha256::new_with_prefix(b"twinrung instruction 1\0");
    for part in [shown.name.as_str(), &print_file(&content(files, shown))] {
        hash.update(part.as_bytes());
        hash.update((part.len() as u64).to_le_bytes());
    }
    hash.finalize().into()
}

/// The definition and all that it uses, in the order of their names, with nothing in them but content.
fn content(files: &[&File], shown: &AddOnInstruction) -> File {
    let mut types: BTreeMap<CompactString, DataType> = BTreeMap::new();
    let mut add_ons: BTreeMap<CompactString, AddOnInstruction> = BTreeMap::new();
    let mut open: Vec<CompactString> = Vec::new();
    let mut take = |one: &AddOnInstruction, open: &mut Vec<CompactString>| {
        open.extend(used_by(one));
        add_ons.insert(fold(one.name.as_str()), only_content(one));
    };
    take(shown, &mut open);
    let mut seen = vec![fold(shown.name.as_str())];
    while let Some(name) = open.pop() {
        let name = fold(&name);
        if seen.contains(&name) {
            continue;
        }
        let data_type = files.iter().flat_map(|file| &file.data_types).find(|one| fold(one.name.as_str()) == name);
        let add_on =
            files.iter().flat_map(|file| &file.add_on_instructions).find(|one| fold(one.name.as_str()) == name);
        if let Some(data_type) = data_type {
            open.extend(data_type.members.iter().map(|member| member.data_type.text.clone()));
            types.insert(name.clone(), DataType { usage: Usage::Target, attributes: Vec::new(), ..data_type.clone() });
        }
        if let Some(add_on) = add_on {
            take(add_on, &mut open);
        }
        seen.push(name);
    }
    File {
        data_types: types.into_values().collect(),
        add_on_instructions: add_ons.into_values().collect(),
        ..File::default()
    }
}

/// Names that a definition uses: types, and instructions, those that are built in among them.
fn used_by(shown: &AddOnInstruction) -> Vec<CompactString> {
    let parameters = shown.parameters.iter().filter_map(|one| one.data_type.as_ref());
    let locals = shown.local_tags.iter().filter_map(|one| one.data_type.as_ref());
    let mut names: Vec<CompactString> = parameters.chain(locals).map(|name| name.text.clone()).collect();
    let mut open: Vec<&Element> =
        shown.routines.iter().flat_map(Routine::rungs).flat_map(|rung| &rung.elements).collect();
    while let Some(element) = open.pop() {
        match element {
            Element::Instruction(instruction) => names.push(instruction.mnemonic.text.clone()),
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
    one.default.retain(says_something);
}

fn local(one: &mut Tag) {
    one.usage = Usage::Target;
    one.class = None;
    one.constant = one.constant.filter(|constant| constant.value);
    one.radix = one.radix.take().filter(|radix| !is_usual(radix, one.data_type.as_ref()));
    one.attributes.clear();
    one.joins_previous = false;
    one.data.retain(says_something);
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

/// Whether data is something else than zeros, which is what stands where nobody says anything.
fn says_something(data: &Data) -> bool {
    let mut open = vec![&data.value];
    while let Some(value) = open.pop() {
        match value {
            Value::Number(text) if text.text.bytes().all(|byte| b"0.+-e".contains(&byte)) => {}
            Value::Bytes { bytes, .. } if bytes.iter().all(|byte| *byte == 0) => {}
            Value::List { items, .. } => open.extend(items),
            Value::Structure { members, .. } => open.extend(members.iter().map(|member| &member.value)),
            Value::Array { elements, .. } => open.extend(elements.iter().map(|(_, value)| value)),
            Value::Number(_) | Value::String(_) | Value::Bytes { .. } => return true,
        }
    }
    false
}
