//! Which texts of a project may hold a suppression, and what each covers.

use twinrung_grammar::tree::{CompactString, File, Routine, Span, Tag, Text, Trivia};

/// What is told of each text: what it covers, where it is written (or what it is written beside), and the text.
pub(super) type Visitor<'v> = dyn FnMut(Span, Span, &str) + 'v;

/// Visits every comment of the source, rung comment and description that belongs to a rung or a declaration.
pub(super) fn visit(file: &File, visitor: &mut Visitor<'_>) {
    if let Some(controller) = &file.controller {
        declaration(controller.span, &controller.trivia, controller.description.as_deref(), visitor);
    }
    for data_type in &file.data_types {
        declaration(data_type.span, &data_type.trivia, data_type.description.as_deref(), visitor);
    }
    for module in &file.modules {
        declaration(module.span, &module.trivia, module.description.as_deref(), visitor);
        for point in &module.points {
            comments(module.span, &point.trivia, visitor);
        }
    }
    for add_on in &file.add_on_instructions {
        declaration(add_on.name.span, &add_on.trivia, add_on.description.as_deref(), visitor);
        for parameter in &add_on.parameters {
            declaration(parameter.span, &parameter.trivia, parameter.description.as_deref(), visitor);
        }
        tags(&add_on.local_tags, visitor);
        add_on.routines.iter().for_each(|one| routine(one, visitor));
    }
    tags(&file.tags, visitor);
    for program in &file.programs {
        declaration(program.name.span, &program.trivia, program.description.as_deref(), visitor);
        tags(&program.tags, visitor);
        program.routines.iter().for_each(|one| routine(one, visitor));
    }
    file.routines.iter().for_each(|one| routine(one, visitor));
    for task in &file.tasks {
        declaration(task.span, &task.trivia, task.description.as_deref(), visitor);
    }
}

fn routine(routine: &Routine, visitor: &mut Visitor<'_>) {
    declaration(routine.name.span, &routine.trivia, routine.description.as_deref(), visitor);
    for rung in routine.rungs() {
        declaration(rung.span, &rung.trivia, rung.comment.as_deref(), visitor);
    }
}

fn tags(tags: &[Tag], visitor: &mut Visitor<'_>) {
    for tag in tags {
        declaration(tag.span, &tag.trivia, tag.description.as_deref(), visitor);
    }
}

fn declaration(covers: Span, trivia: &Trivia, text: Option<&Text>, visitor: &mut Visitor<'_>) {
    comments(covers, trivia, visitor);
    if let Some(text) = text {
        visitor(covers, text.span, text.as_str());
    }
}

fn comments(covers: Span, trivia: &Trivia, visitor: &mut Visitor<'_>) {
    let all = trivia.leading().iter().chain(trivia.trailing()).map(CompactString::as_str);
    all.for_each(|comment| visitor(covers, covers, comment));
}
