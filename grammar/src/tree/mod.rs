//! The tree: what a project file says, as plain data.
//!
//! The same tree comes out of `.rll`, `.L5K` and `.L5X`, so that a compiler never asks which file
//! it was. Whatever the three spell differently (`MAIN` and `MainRoutineName`, `Yes` and `true`,
//! milliseconds and microseconds) is one typed field here. What has no field stays in `attributes`,
//! spelled as in the file.
//!
//! Every name and every piece of text carries the [`Span`] of the file's own bytes it came from,
//! in XML as in text. Nothing here is checked beyond its shape: duplicate names, unknown types and
//! values out of range are for the compiler to refuse.

mod add_on;
mod attribute;
mod data_type;
mod error;
mod file;
mod module;
mod operand;
mod program;
mod rung;
pub mod scenario;
mod source;
mod tag;
mod task;
mod value;

pub use add_on::{AddOnInstruction, HistoryEntry, Parameter, ParameterUsage};
pub use attribute::{Attribute, AttributeValue, Class, ExternalAccess, Name, Spanned, Text};
pub use compact_str::CompactString;
pub use data_type::{BitPlace, DataType, Dimensions, Member};
pub use error::{ErrorKind, ReadError};
pub use file::{Controller, Encoded, Export, File, FileForm, Island, MapEntry, SafetyInfo, Usage};
pub use module::{Connection, Module, ModuleTag, OpaqueData, Point, PointKind, Port};
pub use operand::{BinaryOperator, Expression, Immediate, Number, Part, Radix, TagReference, UnaryOperator, Words};
pub use program::{Program, Routine, RoutineBody};
pub use rung::{Branch, Element, Instruction, Leg, Operand, OriginMap, Rung, RungKind, Trivia};
pub use source::{LineColumn, Source, SourceId, Sources, Span};
pub use tag::{ConsumeInfo, OperandComment, ProduceInfo, Tag, TagKind, TagUsage};
pub use task::Task;
pub use value::{Data, DataForm, MemberValue, Value};
