//! Tags of modules become safety tags: with the structure that the export shows, or with the members that the rungs use.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;

use twinrung_grammar::tree::{Data, Expression, File, ModuleTag, Number, Operand, Part, Value};

/// Elements of an array whose size the export does not show.
const ELEMENTS: u32 = 64;

/// Whether a name is that of a module's tag: `Doors:I`, `Local:2:I`, and no status keyword.
pub fn is_module_tag(base: &str) -> bool {
    base.contains(':') && !base.get(..2).is_some_and(|start| start.eq_ignore_ascii_case("S:"))
}

/// A module's name, or that of its type, as an ordinary name.
pub fn plain_name(name: &str) -> String {
    let mut plain: String = name.replace(':', "_");
    while plain.contains("__") {
        plain = plain.replace("__", "_");
    }
    plain.chars().take(40).collect::<String>().trim_end_matches('_').to_owned()
}

/// The tags of modules that rungs use.
pub struct ModuleTags<'f> {
    export: &'f File,
    used: BTreeMap<String, Shape>,
    types: BTreeSet<String>,
}

/// What rungs use of a tag whose structure the export does not show.
#[derive(Default)]
struct Shape {
    members: BTreeMap<String, Shape>,
    is_array: bool,
    length: u32,
    type_name: String,
}

impl Shape {
    fn note(&mut self, parts: &[Part], used_as: &str) {
        match parts.split_first() {
            None => self.type_name = used_as.to_owned(),
            Some((Part::Member(name), rest)) => {
                self.members.entry(name.text.to_lowercase().to_string()).or_default().note(rest, used_as);
            }
            Some((Part::Subscripts { subscripts, .. }, rest)) => {
                self.is_array = true;
                self.length = self.length.max(elements(subscripts.first()));
                self.note(rest, used_as);
            }
            Some((Part::Bit { .. } | Part::BitSubscript { .. }, _)) => self.type_name = "DINT".to_owned(),
        }
    }
}

/// Elements that an array must have for a subscript.
fn elements(subscript: Option<&Expression>) -> u32 {
    match subscript {
        Some(Expression::Immediate(immediate)) => match immediate.number {
            Number::Integer { magnitude, .. } => magnitude as u32 + 1,
            _ => ELEMENTS,
        },
        _ => ELEMENTS,
    }
}

impl<'f> ModuleTags<'f> {
    /// None yet.
    pub fn new(export: &'f File) -> ModuleTags<'f> {
        ModuleTags { export, used: BTreeMap::new(), types: BTreeSet::new() }
    }

    /// Notes that a rung uses a module's tag.
    pub fn note(&mut self, base: &str, parts: &[Part], used_as: &str) {
        self.used.entry(base.to_owned()).or_default().note(parts, used_as);
    }

    /// Notes that a declaration uses a module's type.
    pub fn note_type(&mut self, name: &str) {
        self.types.insert(name.to_owned());
    }

    /// An operand with the ordinary names.
    pub fn renamed(&self, operand: &Operand) -> Operand {
        let mut text = operand.text.to_string();
        // Longer names first: one may begin with another.
        for base in self.used.keys().rev() {
            text = text.replace(base, &plain_name(base));
        }
        Operand { text: text.into(), ..Operand::default() }
    }

    /// Types and tags as text.
    pub fn declarations(&self) -> String {
        let mut types = BTreeMap::new();
        let mut tags = String::new();
        for (base, shape) in &self.used {
            let name = plain_name(base);
            let shown = shown(self.export, base).and_then(|tag| structure(&tag.data));
            let declared = match shown {
                Some(value) => type_of_value(value, &mut types),
                None => type_of_shape(&name, shape, &mut types),
            };
            let _ = writeln!(tags, "{name} : {declared} (Class := Safety);");
        }
        for wanted in &self.types {
            let of_modules = self.export.modules.iter().flat_map(tags_of).map(|(_, tag)| &tag.data);
            let of_tags = self.export.tags.iter().map(|tag| &tag.data);
            let of_type = |value: &&Value| matches!(value, Value::Structure { data_type, .. } if data_type == wanted);
            if let Some(value) = of_modules.chain(of_tags).filter_map(|data| structure(data)).find(of_type) {
                type_of_value(value, &mut types);
            }
        }
        let types: String = types.into_values().collect();
        format!("{types}TAG {tags} END_TAG")
    }
}

/// The tags that a module brings, with what follows its name.
fn tags_of(module: &twinrung_grammar::tree::Module) -> Vec<(&str, &ModuleTag)> {
    let connections = module.connections.iter().flat_map(|one| [&one.input, &one.output]);
    let all = connections.chain([&module.configuration]).flatten();
    all.map(|tag| (tag.suffix.as_str(), &**tag)).collect()
}

/// The tag of that name: `Name:I`, or `Adapter:Slot:I`.
fn shown<'f>(export: &'f File, base: &str) -> Option<&'f ModuleTag> {
    let parts: Vec<&str> = base.split(':').collect();
    let (module, suffix) = match parts[..] {
        [name, suffix] => (export.modules.iter().find(|one| one.name.is(name))?, suffix),
        [parent, slot, suffix] => {
            let in_slot = |one: &&twinrung_grammar::tree::Module| {
                one.parent.as_ref().is_some_and(|name| name.is(parent))
                    && one.slot.is_some_and(|at| at.value.to_string() == slot)
            };
            (export.modules.iter().find(in_slot)?, suffix)
        }
        _ => return None,
    };
    tags_of(module).into_iter().find(|(one, _)| one.eq_ignore_ascii_case(suffix)).map(|(_, tag)| tag)
}

fn structure(data: &[Data]) -> Option<&Value> {
    data.iter().map(|data| &data.value).find(|value| matches!(value, Value::Structure { .. }))
}

/// Declares the type of a structure that an export shows; its name.
fn type_of_value(value: &Value, types: &mut BTreeMap<String, String>) -> String {
    let Value::Structure { data_type, members, .. } = value else { return String::new() };
    let name = plain_name(data_type);
    let mut text = format!("DATATYPE {name}\n");
    for member in members {
        let (inner, sizes) = match &member.value {
            Value::Structure { .. } => (type_of_value(&member.value, types), String::new()),
            Value::Array { data_type, dimensions, elements, .. } => {
                let nested =
                    elements.first().map(|(_, value)| value).filter(|one| matches!(one, Value::Structure { .. }));
                let inner = nested.map_or_else(|| plain_name(data_type), |value| type_of_value(value, types));
                let sizes: Vec<String> = dimensions.sizes().iter().map(u32::to_string).collect();
                (inner, format!("[{}]", sizes.join(",")))
            }
            _ => (member.data_type.to_string(), String::new()),
        };
        let _ = writeln!(text, "  {inner} {}{sizes};", member.name);
    }
    text.push_str("END_DATATYPE\n");
    types.insert(name.clone(), text);
    name
}

/// Declares a type with the members that are used; its name and sizes.
fn type_of_shape(name: &str, shape: &Shape, types: &mut BTreeMap<String, String>) -> String {
    let sizes = if shape.is_array { format!("[{}]", shape.length) } else { String::new() };
    if shape.members.is_empty() {
        return format!("{}{sizes}", plain_name(&shape.type_name));
    }
    let own = format!("Used_{}", types.len());
    types.insert(own.clone(), String::new());
    let mut text = format!("DATATYPE {own} // {name}\n");
    for (member, inner) in &shape.members {
        let declared = type_of_shape(member, inner, types);
        let (inner, sizes) =
            declared.split_once('[').map_or((&*declared, String::new()), |(a, b)| (a, format!("[{b}")));
        let _ = writeln!(text, "  {inner} {member}{sizes};");
    }
    text.push_str("END_DATATYPE\n");
    types.insert(own.clone(), text);
    format!("{own}{sizes}")
}
