//! Declarations as canonical text, in the manner of `.rll`.

use core::fmt::{self, Write};

use super::operand::{OperandWriter, Stop};
use super::value::write_initial;
use crate::image::*;
use crate::index::ProgramIndex;
use crate::layout::TypeLayout;

/// Writes the controller's declaration.
pub fn write_controller(controller: &ControllerRecord, out: &mut dyn Write) -> fmt::Result {
    let ControllerRecord { name, processor, revision, attributes } = controller;
    write!(out, "CONTROLLER {name} (ProcessorType := \"{processor}\", Major := {revision}")?;
    write_attributes(attributes, out)?;
    out.write_str(")\n")
}

/// Writes a user-defined type.
pub fn write_type(image: &Image, record: &TypeRecord, out: &mut dyn Write) -> fmt::Result {
    writeln!(out, "DATATYPE {}", record.name)?;
    for member in &record.members {
        write!(out, "  {} {}", type_name(image, member.type_reference), member.name)?;
        write_dimensions(member.dimensions, out)?;
        out.write_str(";\n")?;
    }
    out.write_str("END_DATATYPE\n")
}

/// Writes an Add-On Instruction without its routines.
pub fn write_add_on(image: &Image, record: &AddOnRecord, out: &mut dyn Write) -> fmt::Result {
    write!(out, "ADD_ON_INSTRUCTION_DEFINITION {} (Class := Safety", record.name)?;
    if record.prescan.is_some() {
        out.write_str(", ExecutePrescan := Yes")?;
    }
    if record.enable_in_false.is_some() {
        out.write_str(", ExecuteEnableInFalse := Yes")?;
    }
    write_attributes(&record.attributes, out)?;
    out.write_str(")\n  PARAMETERS\n")?;
    for parameter in &record.parameters {
        write!(out, "    {} : {}", parameter.name, type_name(image, parameter.type_reference))?;
        write_dimensions(parameter.dimensions, out)?;
        let usage = match parameter.usage {
            Usage::Input => "Input",
            Usage::Output => "Output",
            Usage::InOut => "InOut",
        };
        let required = if parameter.argument { "Yes" } else { "No" };
        writeln!(out, " (Usage := {usage}, Required := {required});")?;
    }
    out.write_str("  END_PARAMETERS\n  LOCAL_TAGS\n")?;
    let held = record.parameters.iter().filter(|parameter| parameter.member.is_some()).count();
    let instance = image.types.get(record.instance_type.position());
    for local in instance.and_then(|instance| instance.members.get(held..)).unwrap_or_default() {
        write!(out, "    {} : {}", local.name, type_name(image, local.type_reference))?;
        write_dimensions(local.dimensions, out)?;
        out.write_str(";\n")?;
    }
    out.write_str("  END_LOCAL_TAGS\nEND_ADD_ON_INSTRUCTION_DEFINITION\n")
}

/// Writes a module.
pub fn write_module(record: &ModuleRecord, out: &mut dyn Write) -> fmt::Result {
    out.write_str(&record.text)
}

/// Writes the tag map, a line for each entry.
pub fn write_map(image: &Image, out: &mut dyn Write) -> fmt::Result {
    for line in &image.map {
        let safety = image.tags.get(line.safety.position()).map_or("?", |tag| tag.name.as_str());
        writeln!(out, "{safety} (MappedFrom := {});", line.standard)?;
    }
    Ok(())
}

/// Writes a program without its tags and routines.
pub fn write_program(image: &Image, record: &ProgramRecord, out: &mut dyn Write) -> fmt::Result {
    write!(out, "PROGRAM {} (Class := Safety", record.name)?;
    for (key, routine) in [("MAIN", record.main), ("FAULT", record.fault)] {
        if let Some(routine) = routine {
            let name = image.routines.get(routine.position()).map_or("?", |routine| routine.name.as_str());
            write!(out, ", {key} := \"{name}\"")?;
        }
    }
    writeln!(out, ", DisableFlag := {})", u8::from(record.disabled))
}

/// Writes the safety task.
pub fn write_task(image: &Image, record: &TaskRecord, out: &mut dyn Write) -> fmt::Result {
    write!(out, "TASK {} (Type := PERIODIC, Class := Safety, Rate := ", record.name)?;
    write_milliseconds(record.period_us, out)?;
    out.write_str(", Watchdog := ")?;
    write_milliseconds(record.watchdog_us, out)?;
    writeln!(out, ", Priority := {})", record.priority)?;
    for program in &record.schedule {
        let name = image.programs.get(program.position()).map_or("?", |program| program.name.as_str());
        writeln!(out, "  {name};")?;
    }
    out.write_str("END_TASK\n")
}

/// Writes the tags of the controller (`None`) or of a program, with their initial values.
pub fn write_tags(
    image: &Image,
    layouts: &[TypeLayout],
    program: Option<ProgramIndex>,
    out: &mut dyn Write,
) -> Result<(), Stop> {
    out.write_str("TAG\n")?;
    let mut operands = OperandWriter::new(image);
    for tag in image.tags.iter().filter(|tag| tag.program == program) {
        write!(out, "  {}", tag.name)?;
        if let TagKind::Alias(target) = tag.kind {
            out.write_str(" OF ")?;
            operands.write(target, None, out)?;
        } else {
            write!(out, " : {}", type_name(image, tag.type_reference))?;
            write_dimensions(tag.dimensions, out)?;
        }
        out.write_str(" (Class := Safety")?;
        out.write_str(match tag.kind {
            TagKind::Base | TagKind::Alias(_) => "",
            TagKind::Produced => ", Connection := Produced",
            TagKind::Consumed => ", Connection := Consumed",
            TagKind::ModuleInput => ", Connection := Input",
            TagKind::ModuleOutput => ", Connection := Output",
        })?;
        if tag.constant {
            out.write_str(", Constant := Yes")?;
        }
        write_attributes(&tag.attributes, out)?;
        out.write_str(")")?;
        if !matches!(tag.kind, TagKind::Alias(_)) {
            write_initial(image, layouts, tag, out)?;
        }
        out.write_str(";\n")?;
    }
    out.write_str("END_TAG\n")?;
    Ok(())
}

/// The name of a type.
pub fn type_name(image: &Image, type_reference: TypeReference) -> &str {
    match type_reference {
        TypeReference::Element(element) => element.name(),
        TypeReference::Structure(index) => {
            image.types.get(index.position()).map_or("?", |structure| structure.name.as_str())
        }
    }
}

fn write_dimensions(dimensions: [u32; 3], out: &mut dyn Write) -> fmt::Result {
    for (position, dimension) in dimensions.iter().enumerate().filter(|(_, dimension)| **dimension != 0) {
        write!(out, "{}{dimension}", if position == 0 { "[" } else { "," })?;
    }
    out.write_str(if dimensions == [0; 3] { "" } else { "]" })
}

fn write_attributes(attributes: &Attributes, out: &mut dyn Write) -> fmt::Result {
    attributes.iter().try_for_each(|(key, value)| write!(out, ", {key} := {value}"))
}

/// Milliseconds without trailing zeros: `20`, `0.5`.
fn write_milliseconds(microseconds: u32, out: &mut dyn Write) -> fmt::Result {
    let (whole, mut part) = (microseconds / 1000, microseconds % 1000);
    write!(out, "{whole}")?;
    if part > 0 {
        let mut digits = 3;
        while part.is_multiple_of(10) {
            part /= 10;
            digits = usize::saturating_sub(digits, 1);
        }
        write!(out, ".{part:0digits$}")?;
    }
    Ok(())
}
