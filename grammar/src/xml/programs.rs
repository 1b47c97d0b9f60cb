//! `<Program>`, `<Routine>`, `<Rung>` and `<Task>`.

use super::cursor::{Content, Element};
use super::{Reader, adopt, usage};
use crate::components;
use crate::reading::number::clip;
use crate::text::{parse_rung, rung_kind};
use crate::tree::{ErrorKind, Name, ReadError, Routine, RoutineBody, Rung, RungKind, Spanned, Text, Trivia, Usage};

impl<'a> Reader<'a> {
    pub(super) fn program(&mut self, element: &Element<'a>, around: Usage) {
        let fields = element.fields(&["Name", "Use"], &mut self.xml.errors);
        let mut program = components::program(element.name_of("Name"), fields, element.span);
        program.usage = usage(element, around);
        while let Some(child) = self.xml.child() {
            let inner = usage(&child, program.usage);
            match child.name {
                "Description" => program.description = self.description(),
                "Tags" => {
                    while let Some(tag) = self.xml.child() {
                        let tag = self.tag(&tag, inner);
                        program.tags.push(tag);
                    }
                }
                "Routines" => {
                    while let Some(routine) = self.xml.child() {
                        let routine = self.routine(&routine, inner);
                        program.routines.push(routine);
                    }
                }
                "EncodedData" => {
                    let encoded = self.encoded(&child);
                    program.encoded.push(encoded);
                }
                _ => self.xml.skip(),
            }
        }
        self.file.programs.push(program);
    }

    /// `<Routine>`, or `<EncodedData>` in its place.
    pub(super) fn routine(&mut self, element: &Element<'a>, around: Usage) -> Routine {
        let fields = element.fields(&["Name", "Type", "Use", "EncodedType"], &mut self.xml.errors);
        let mut routine = components::routine(element.name_of("Name"), fields, element.span);
        routine.usage = usage(element, around);
        if element.name == "EncodedData" {
            routine.body = RoutineBody::Encoded { text: Text::default() };
            self.xml.skip();
            return routine;
        }
        let language = element.optional_name("Type");
        let mut rungs = Vec::new();
        let mut other = language.clone().filter(|language| !language.is("RLL"));
        while let Some(child) = self.xml.child() {
            match child.name {
                "Description" => routine.description = self.description(),
                "RLLContent" => {
                    while let Some(rung) = self.xml.child() {
                        if rung.name == "Rung" {
                            let rung = self.rung(&rung);
                            rungs.push(rung);
                        } else {
                            self.xml.skip();
                        }
                    }
                }
                name => {
                    let content = name.strip_suffix("Content");
                    other = other.or_else(|| content.map(|language| Name::new(language, child.span)));
                    self.xml.skip();
                }
            }
        }
        routine.body = match other {
            Some(language) if rungs.is_empty() => RoutineBody::Island { language, text: Text::default() },
            _ => RoutineBody::Ladder(rungs),
        };
        routine
    }

    fn rung(&mut self, element: &Element<'a>) -> Rung {
        let number = self.number(element.get("Number"), "Number");
        let kind = self.rung_kind(element);
        let mut rung = Rung {
            number,
            kind,
            comment: None,
            elements: Vec::new(),
            broken: false,
            trivia: Trivia::none(),
            span: element.span,
        };
        let mut has_text = false;
        while let Some(child) = self.xml.child() {
            match child.name {
                "Comment" => rung.comment = self.description(),
                "Text" if !has_text => {
                    has_text = true;
                    let content = self.xml.content();
                    rung.span = content.span;
                    self.rung_text(&content, &mut rung);
                }
                _ => self.xml.skip(),
            }
        }
        if !has_text {
            rung.broken = true;
            self.xml.errors.add(ErrorKind::MalformedRung, element.span, "a rung without text");
        }
        rung
    }

    fn rung_kind(&mut self, element: &Element<'a>) -> Spanned<RungKind> {
        let Some(text) = element.get("Type") else { return Spanned::new(RungKind::Normal, element.span) };
        let kind = rung_kind(&text.text).unwrap_or_else(|| {
            let message = format!("there is no rung kind `{}`", clip(&text.text));
            self.xml.errors.push(ReadError::new(ErrorKind::UnknownRungKind, text.span, message));
            RungKind::Normal
        });
        Spanned::new(kind, text.span)
    }

    fn rung_text(&mut self, content: &Content<'_>, rung: &mut Rung) {
        let mut comments = Vec::new();
        match parse_rung(content.excerpt(), &mut comments) {
            Ok(elements) => rung.elements = elements,
            Err(error) => {
                rung.broken = true;
                self.xml.errors.push(error);
            }
        }
        for comment in comments {
            rung.trivia.push_leading(comment);
        }
    }

    pub(super) fn task(&mut self, element: &Element<'a>) {
        let fields = element.fields(&["Name", "Use"], &mut self.xml.errors);
        let mut task = components::task(element.name_of("Name"), fields, element.span);
        while let Some(child) = self.xml.child() {
            match child.name {
                "Description" => task.description = self.description(),
                "EventInfo" => {
                    adopt(&mut task.attributes, &child, &[]);
                    self.xml.skip();
                }
                "ScheduledPrograms" => {
                    while let Some(program) = self.xml.child() {
                        task.programs.extend(program.optional_name("Name"));
                        self.xml.skip();
                    }
                }
                _ => self.xml.skip(),
            }
        }
        self.file.tasks.push(task);
    }
}
