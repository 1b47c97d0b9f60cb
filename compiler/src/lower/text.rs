//! Canonical texts of routines. What an operand prints as is the image format's affair
//! ([`twinrung_bytecode::text`]); here each operand is printed once and put together for every rung that uses it, in the
//! blanks of the exporter (neutral-text-and-l5x.md C.1). The loader proves that the result is what it would have printed.

use twinrung_bytecode::error::ImageError;
use twinrung_bytecode::image::Image;
use twinrung_bytecode::index::OperandIndex;
use twinrung_bytecode::text::render_operand;
use twinrung_catalog::OperandKind;

use super::operands::Interner;
use super::order::Order;
use crate::project::{Call, Element, Project};

/// Fills the texts of an image whose other tables are complete. `operands` are the entries of the project's operands.
pub(super) fn routines(
    project: &Project,
    order: &Order,
    operands: &[Option<OperandIndex>],
    image: &mut Image,
) -> Result<(), ImageError> {
    let mut texts = Vec::with_capacity(order.routines.len());
    {
        let mut writer =
            Writer { project, operands, image, known: vec![None; image.operands.len()], buffer: String::new() };
        for id in &order.routines {
            let routine = project.routine(*id);
            let mut text = String::with_capacity(routine.rungs.len() * 64);
            for rung in &routine.rungs {
                writer.series(&rung.elements, false, &mut text)?;
                text.push_str(";\n");
            }
            texts.push(text);
        }
    }
    for (routine, text) in image.routines.iter_mut().zip(texts) {
        routine.text = text;
    }
    Ok(())
}

struct Writer<'a> {
    project: &'a Project,
    operands: &'a [Option<OperandIndex>],
    image: &'a Image,
    /// Where in the buffer the text of an operand lies, where it does not depend on the place.
    known: Vec<Option<(u32, u32)>>,
    buffer: String,
}

impl Writer<'_> {
    /// Bounded by the depth of branches, which the grammar limits.
    fn series(&mut self, elements: &[Element], in_leg: bool, out: &mut String) -> Result<(), ImageError> {
        for (position, element) in elements.iter().enumerate() {
            if in_leg && position > 0 {
                out.push(' ');
            }
            match element {
                Element::Branch(branch) => {
                    for (number, leg) in branch.legs.iter().enumerate() {
                        out.push_str(if number == 0 { "[" } else { "," });
                        self.series(leg, true, out)?;
                        if !leg.is_empty() {
                            out.push(' ');
                        }
                    }
                    out.push(']');
                }
                Element::Instruction(instruction) => {
                    let declaration = match instruction.call {
                        Call::Catalog(declaration) => Some(declaration),
                        Call::AddOn(_) => None,
                    };
                    match instruction.call {
                        Call::Catalog(declaration) => out.push_str(declaration.mnemonic),
                        Call::AddOn(add_on) => out.push_str(&self.project.add_on(add_on).name),
                    }
                    out.push('(');
                    for (at, one) in instruction.operands.iter().enumerate() {
                        if at > 0 {
                            out.push(',');
                        }
                        let kind = declaration.and_then(|known| known.operand(at)).map(|declared| declared.kind);
                        let index = self.operands.get(one.id.position()).copied().flatten();
                        let index = index.ok_or(ImageError::NoSuchOperand { operand: OperandIndex(one.id.0) })?;
                        self.operand(index, kind, out)?;
                    }
                    out.push(')');
                }
            }
        }
        Ok(())
    }

    fn operand(&mut self, index: OperandIndex, kind: Option<OperandKind>, out: &mut String) -> Result<(), ImageError> {
        // The text of a choice is a word of the list that the place declares.
        if matches!(kind, Some(OperandKind::Choice(_) | OperandKind::FileMode | OperandKind::ByteOrder)) {
            out.push_str(&render_operand(self.image, index, kind)?);
            return Ok(());
        }
        let known = self.known.get(index.position()).copied().flatten();
        let (begin, end) = match known {
            Some(place) => place,
            None => {
                let begin = self.buffer.len() as u32;
                self.buffer.push_str(&render_operand(self.image, index, kind)?);
                let place = (begin, self.buffer.len() as u32);
                if let Some(slot) = self.known.get_mut(index.position()) {
                    *slot = Some(place);
                }
                place
            }
        };
        out.push_str(&self.buffer[begin as usize..end as usize]);
        Ok(())
    }
}

/// The entries of the project's operands, for the texts.
pub(super) fn entries(operands: &Interner<'_>) -> Vec<Option<OperandIndex>> {
    operands.by_id().to_vec()
}
