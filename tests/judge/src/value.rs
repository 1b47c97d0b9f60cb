//! Data as a tree of values: nothing is packed, nothing has an address.

use twinrung_bytecode::image::TypeReference;
use twinrung_catalog::Element;
use twinrung_compiler::project::Types;

/// The value of a tag, member or element.
#[derive(Debug, Clone, PartialEq)]
pub enum Value {
    /// BOOL.
    Bit(bool),
    /// SINT, INT or DINT.
    Integer(Element, i32),
    /// REAL, as its bits.
    Real(u32),
    /// A structure: one value for each member, in declared order.
    Structure(Vec<Value>),
    /// An array: its elements, last dimension fastest.
    Array(Vec<Value>),
}

impl Value {
    /// Zero of a type with dimensions.
    pub fn zero(types: &Types, type_reference: TypeReference, dimensions: [u32; 3]) -> Value {
        if dimensions != [0; 3] {
            let count = dimensions.iter().map(|size| (*size).max(1)).product::<u32>() as usize;
            return Value::Array(vec![Value::zero(types, type_reference, [0; 3]); count]);
        }
        match type_reference {
            TypeReference::Element(Element::Bool) => Value::Bit(false),
            TypeReference::Element(Element::Real) => Value::Real(0),
            TypeReference::Element(element) => Value::Integer(element, 0),
            TypeReference::Structure(index) => Value::Structure(
                types
                    .record(index)
                    .members
                    .iter()
                    .map(|member| Value::zero(types, member.type_reference, member.dimensions))
                    .collect(),
            ),
        }
    }

    /// Appends every BOOL and every number, depth first in declared order.
    pub fn flatten(&self, bits: &mut Vec<u8>, words: &mut Vec<i32>) {
        match self {
            Value::Bit(value) => bits.push(u8::from(*value)),
            Value::Integer(_, value) => words.push(*value),
            Value::Real(value) => words.push(*value as i32),
            Value::Structure(parts) | Value::Array(parts) => {
                parts.iter().for_each(|part| part.flatten(bits, words));
            }
        }
    }

    /// Takes every BOOL and every number from the iterators, in the order of [`Value::flatten`].
    pub fn fill(&mut self, bits: &mut impl Iterator<Item = u8>, words: &mut impl Iterator<Item = i32>) {
        match self {
            Value::Bit(value) => *value = bits.next() == Some(1),
            Value::Integer(_, value) => *value = words.next().unwrap_or_default(),
            Value::Real(value) => *value = words.next().unwrap_or_default() as u32,
            Value::Structure(parts) | Value::Array(parts) => {
                parts.iter_mut().for_each(|part| part.fill(bits, words));
            }
        }
    }

    /// Whether it holds what the iterators give, in the order of [`Value::flatten`], which are advanced past it when it does.
    pub fn holds(&self, bits: &mut impl Iterator<Item = u8>, words: &mut impl Iterator<Item = i32>) -> bool {
        match self {
            Value::Bit(value) => bits.next() == Some(u8::from(*value)),
            Value::Integer(_, value) => words.next() == Some(*value),
            Value::Real(value) => words.next() == Some(*value as i32),
            Value::Structure(parts) | Value::Array(parts) => parts.iter().all(|part| part.holds(bits, words)),
        }
    }

    /// The part at a path.
    pub fn at(&self, path: &[u32]) -> &Value {
        path.iter().fold(self, |value, step| match value {
            Value::Structure(parts) | Value::Array(parts) => &parts[*step as usize],
            other => panic!("a path leads into {other:?}"),
        })
    }

    /// The part at a path, to be changed.
    pub fn at_mut(&mut self, path: &[u32]) -> &mut Value {
        path.iter().fold(self, |value, step| match value {
            Value::Structure(parts) | Value::Array(parts) => &mut parts[*step as usize],
            other => panic!("a path leads into {other:?}"),
        })
    }
}
