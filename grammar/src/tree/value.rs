//! Values of tags: initial data, default data of parameters, forces.

use super::{CompactString, Dimensions, Name, Span, Text};

/// How a file wrote a piece of data. An L5X export often writes the same data in two forms; all are
/// kept, for the compiler to see that they agree.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum DataForm {
    /// `0`, `[1,14]`: text of L5K and `.rll`, or `Format="L5K"`.
    L5k,
    /// `Format="Decorated"`: members by name.
    Decorated,
    /// No format: the memory image, as bytes.
    Raw,
    /// `Format="String"`.
    String,
    /// Messages, axes and the like: not read (the value is an empty list).
    Other,
}

/// One piece of data in one form.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Data {
    /// How it was written.
    pub form: DataForm,
    /// What it says.
    pub value: Value,
}

/// A value, of whatever shape the file gave it.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Value {
    /// A number as written (`-5`, `16#00ff`, `1.5e+01`, `1.#QNAN`), or a word in the place of one.
    /// [`crate::read_number`] reads it.
    Number(Text),
    /// `'text'`: the characters, with `$` escapes still in place (they may name bytes that are no
    /// character); [`crate::unescape`] resolves them.
    String(Text),
    /// `[a,b,[c,d]]`: structure members or array elements in order. Form L5K.
    List {
        /// The items in order.
        items: Vec<Value>,
        /// Brackets included.
        span: Span,
    },
    /// Members by name. Form Decorated.
    Structure {
        /// The type that the export names.
        data_type: CompactString,
        /// The members in the file's order.
        members: Vec<MemberValue>,
        /// The element.
        span: Span,
    },
    /// Elements by index. Form Decorated; the elements stand in the file's order with their index.
    Array {
        /// The type that the export names.
        data_type: CompactString,
        /// The dimensions that the export names.
        dimensions: Dimensions,
        /// Index and value.
        elements: Vec<(Dimensions, Value)>,
        /// The element.
        span: Span,
    },
    /// The memory image, little-endian. Form Raw.
    Bytes {
        /// The bytes.
        bytes: Vec<u8>,
        /// The text.
        span: Span,
    },
}

/// One member of a decorated structure.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct MemberValue {
    /// The member.
    pub name: Name,
    /// The type that the export names (`DataType` of the member's element); empty where it names none. The structure
    /// of a module's tag is visible nowhere else.
    pub data_type: CompactString,
    /// Its value.
    pub value: Value,
}

impl Value {
    /// Where the value stands.
    pub fn span(&self) -> Span {
        match self {
            Value::Number(text) | Value::String(text) => text.span,
            Value::List { span, .. }
            | Value::Structure { span, .. }
            | Value::Array { span, .. }
            | Value::Bytes { span, .. } => *span,
        }
    }
}
