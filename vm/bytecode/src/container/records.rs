//! The byte form of every record: its fields in declared order.

use alloc::string::String;
use alloc::vec::Vec;

use twinrung_catalog::Element;

use super::cursor::Cursor;
use super::field::{Field, Listed, read_count, write_count};
use crate::error::ImageError;
use crate::image::*;
use crate::index::{AddOnIndex, OperandIndex, ProgramIndex, RoutineIndex, TagIndex, TypeIndex};
use crate::limits;

macro_rules! index {
    ($($name:ident($inner:ty)),*) => {$(
        impl Field for $name {
            const LEAST_BYTES: usize = <$inner>::LEAST_BYTES;

            fn write(&self, out: &mut Vec<u8>) {
                self.0.write(out);
            }

            fn read(from: &mut Cursor<'_>) -> Result<$name, ImageError> {
                Ok($name(<$inner>::read(from)?))
            }
        }
    )*};
}

index!(TypeIndex(u16), AddOnIndex(u16), ProgramIndex(u16), RoutineIndex(u32), TagIndex(u32), OperandIndex(u32));

macro_rules! record {
    ($($name:ident { $($field:ident: $type:ty),* $(,)? })*) => {$(
        impl Field for $name {
            const LEAST_BYTES: usize = {
                let mut least: usize = 0;
                $(least = least.saturating_add(<$type as Field>::LEAST_BYTES);)*
                least
            };

            fn write(&self, out: &mut Vec<u8>) {
                let $name { $($field),* } = self;
                $($field.write(out);)*
            }

            fn read(from: &mut Cursor<'_>) -> Result<$name, ImageError> {
                $(let $field = <$type as Field>::read(from)?;)*
                Ok($name { $($field),* })
            }
        }
    )*};
}

record! {
    ControllerRecord { name: String, processor: String, revision: u16, attributes: Attributes }
    TypeRecord { name: String, kind: TypeKind, members: Vec<MemberRecord> }
    MemberRecord { name: String, type_reference: TypeReference, dimensions: [u32; 3] }
    ParameterRecord {
        name: String,
        usage: Usage,
        type_reference: TypeReference,
        dimensions: [u32; 3],
        argument: bool,
        member: Option<u16>,
    }
    AddOnRecord {
        name: String,
        instance_type: TypeIndex,
        parameters: Vec<ParameterRecord>,
        logic: RoutineIndex,
        prescan: Option<RoutineIndex>,
        enable_in_false: Option<RoutineIndex>,
        attributes: Attributes,
    }
    ProgramRecord { name: String, main: Option<RoutineIndex>, fault: Option<RoutineIndex>, disabled: bool }
    RoutineRecord { owner: Owner, name: String, code: Vec<u8>, text: String }
    TagRecord {
        name: String,
        program: Option<ProgramIndex>,
        type_reference: TypeReference,
        dimensions: [u32; 3],
        kind: TagKind,
        constant: bool,
        bit_cell: u32,
        word_cell: u32,
        attributes: Attributes,
    }
    TaskRecord { name: String, period_us: u32, watchdog_us: u32, priority: u8, schedule: Vec<ProgramIndex> }
    ModuleRecord { name: String, text: String }
    MapRecord { standard: String, safety: TagIndex }
    SystemValueRecord { attribute: u8, instance: u32, first: u32, program: Option<ProgramIndex> }
}

macro_rules! listed {
    ($($type:ty: $limit:expr;)*) => {$(
        impl Listed for $type {
            const LIMIT: usize = $limit;
        }
    )*};
}

listed! {
    u8: limits::IMAGE_BYTES;
    i32: limits::WORD_CELLS as usize;
    String: limits::EVENT_TASKS;
    (String, String): limits::ATTRIBUTES;
    ProgramIndex: limits::PROGRAMS;
    TypeRecord: limits::TYPES;
    MemberRecord: limits::MEMBERS;
    ParameterRecord: limits::ADD_ON_PARAMETERS;
    AddOnRecord: limits::TYPES;
    ProgramRecord: limits::PROGRAMS;
    RoutineRecord: limits::ROUTINES;
    TagRecord: limits::TAGS;
    ModuleRecord: limits::MODULES;
    MapRecord: limits::MAP_LINES;
    SystemValueRecord: limits::SYSTEM_VALUES;
}

/// A choice of a tag byte and, for some choices, a value.
macro_rules! choice {
    ($($name:ident { $($tag:literal => $variant:ident $(($type:ty))?),* $(,)? })*) => {$(
        impl Field for $name {
            const LEAST_BYTES: usize = 1;

            fn write(&self, out: &mut Vec<u8>) {
                match self {
                    $(choice!(@pattern $name $variant $(value $type)?) => {
                        out.push($tag);
                        $(<$type as Field>::write(value, out);)?
                    })*
                }
            }

            fn read(from: &mut Cursor<'_>) -> Result<$name, ImageError> {
                let offset = from.offset();
                match u8::read(from)? {
                    $($tag => Ok($name::$variant $((<$type as Field>::read(from)?))?),)*
                    _ => Err(ImageError::UnknownChoice { offset }),
                }
            }
        }
    )*};
    (@pattern $name:ident $variant:ident) => { $name::$variant };
    (@pattern $name:ident $variant:ident $value:ident $type:ty) => { $name::$variant($value) };
}

choice! {
    Element { 0 => Bool, 1 => Sint, 2 => Int, 3 => Dint, 4 => Real }
    TypeReference { 0 => Element(Element), 1 => Structure(TypeIndex) }
    TypeKind { 0 => Predefined, 1 => User, 2 => AddOn(AddOnIndex) }
    Usage { 0 => Input, 1 => Output, 2 => InOut }
    Owner { 0 => Program(ProgramIndex), 1 => AddOn(AddOnIndex) }
    TagKind { 0 => Base, 1 => Alias(OperandIndex), 2 => Produced, 3 => Consumed, 4 => ModuleInput, 5 => ModuleOutput }
}

/// Number of entries, where each ends, and their bytes.
impl Field for OperandTable {
    const LEAST_BYTES: usize = 8;

    fn write(&self, out: &mut Vec<u8>) {
        let ends = self.offsets.get(1..).unwrap_or_default();
        write_count(ends.len(), out);
        u32::write_all(ends, out);
        self.bytes.write(out);
    }

    fn read(from: &mut Cursor<'_>) -> Result<OperandTable, ImageError> {
        let count = read_count::<u32>(limits::OPERANDS, from)?;
        let mut offsets = Vec::with_capacity(count.saturating_add(1));
        let mut last = 0;
        if count > 0 {
            offsets.push(0);
        }
        for _ in 0..count {
            let offset = from.offset();
            let end = u32::read(from)?;
            if end <= last {
                return Err(ImageError::OperandOffsets { offset });
            }
            offsets.push(end);
            last = end;
        }
        let offset = from.offset();
        let bytes = Vec::read(from)?;
        if bytes.len() != last as usize {
            return Err(ImageError::OperandOffsets { offset });
        }
        Ok(OperandTable { offsets, bytes })
    }
}
