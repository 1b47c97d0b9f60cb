//! From a checked project to an image: tables in their order, cells, operands, code, canonical texts, initial values.
//! Everything depends on content alone: names are sorted, schedules keep their order.

mod code;
mod initial;
mod operands;
mod order;
mod records;
mod text;

use twinrung_bytecode::container::HEADER_BYTES;
use twinrung_bytecode::error::ImageError;
use twinrung_bytecode::image::Image;
use twinrung_grammar::tree::Span;

use crate::CheckedProject;
use crate::diagnostic::{DEFECT, Finding, OVER_LIMIT};
use crate::project::{Project, RoutineId, TagId};
use order::Order;

/// An image and what it is known by.
#[derive(Debug, Clone)]
pub struct CompiledImage {
    /// The sealed image, as the loader reads it.
    pub bytes: Vec<u8>,
    /// Over texts and declarations; the same across releases of this tool.
    pub application_signature: [u8; 32],
    /// Over the application signature and the bytecode.
    pub image_signature: [u8; 32],
    /// Which routine of the project each routine of the image is, in the order of the image: the rungs of
    /// [`Project::routines`] keep the order of the text, so that a place in the image leads to its span.
    pub routines: Vec<RoutineId>,
    /// Which tag of the project each tag of the image is, in the order of the image.
    pub tags: Vec<TagId>,
}

impl CompiledImage {
    /// The text of an instruction of the image: routine by its position in the image, rung and element from 0. Nothing
    /// where there is none.
    pub fn span(&self, project: &Project, routine: usize, rung: u32, element: u32) -> Option<Span> {
        let routine = project.routines.get(self.routines.get(routine)?.position())?;
        let mut found = None;
        routine.rungs.get(rung as usize)?.visit(&mut |instruction| {
            if instruction.element == element {
                found = Some(instruction.span);
            }
        });
        found
    }
}

/// Compiles a checked project.
///
/// # Errors
///
/// A finding of code E0108 where the whole is beyond a limit of the image, else of code D0001: a defect of this compiler.
pub fn compile(project: &CheckedProject) -> Result<CompiledImage, Finding> {
    let (image, order) = build(project).map_err(|error| defect(project, &error))?;
    let bytes = twinrung_bytecode::seal(&image).map_err(|error| defect(project, &error))?;
    let signature = |from: usize| -> [u8; 32] {
        bytes.get(from..from + 32).and_then(|piece| piece.try_into().ok()).unwrap_or_default()
    };
    Ok(CompiledImage {
        application_signature: signature(HEADER_BYTES - 64),
        image_signature: signature(HEADER_BYTES - 32),
        routines: order.routines,
        tags: order.tags,
        bytes,
    })
}

/// Whether an image is refused for its size alone, which no place of the project can be blamed for.
pub fn is_limit(error: &ImageError) -> bool {
    matches!(
        error,
        ImageError::TooManyBytes { .. }
            | ImageError::TooMany { .. }
            | ImageError::TooManyCells { .. }
            | ImageError::ExpandedLength
            | ImageError::StraightLength { .. }
            | ImageError::BackingCount
    )
}

fn defect(project: &Project, error: &ImageError) -> Finding {
    if is_limit(error) {
        return Finding::new(&OVER_LIMIT, project.span, format!("the project is larger than an image can be: {error}"))
            .help("take parts out, or split it into two controllers");
    }
    Finding::new(&DEFECT, project.span, format!("no image came of a correct project: {error}"))
        .help("please report this with the file; it is a fault of this tool")
}

/// The records of the image, unsealed.
pub(crate) fn build(project: &Project) -> Result<(Image, Order), ImageError> {
    let order = Order::of(project);
    let mut image =
        Image { controller: records::controller(project), types: records::types(project, &order), ..Image::default() };
    records::tags(project, &order, &mut image);
    let mut operands = operands::Interner::new(project, &order, &image);
    records::aliases(project, &order, &mut operands, &mut image);
    image.add_ons = records::add_ons(project, &order);
    image.programs = records::programs(project, &order);
    image.routines = code::routines(project, &order, &mut operands);
    let entries = text::entries(&operands);
    let operands::Tables { operands, system_values, event_tasks } = operands.finish();
    image.operands = operands;
    image.system_values = system_values;
    image.event_tasks = event_tasks;
    image.task = records::task(project, &order);
    image.modules = records::modules(project);
    image.map = records::map(project, &order);
    initial::values(project, &order, &mut image);
    text::routines(project, &order, &entries, &mut image)?;
    Ok((image, order))
}
