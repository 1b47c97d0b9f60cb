//! `PROGRAM`, `TASK` and `ROUTINE`.

use super::token::Token;
use super::{Next, Reader};
use crate::components;
use crate::fields::Fields;
use crate::tree::{Encoded, ErrorKind, Name, Routine, RoutineBody};

impl Reader<'_> {
    pub(super) fn program(&mut self) {
        let (head, span, trivia) = self.head("END_PROGRAM");
        let mut program = components::program(head.name, Fields::new(head.attributes, &mut self.cursor.errors), span);
        program.trivia = trivia;
        while let Next::Word(word) = self.next_in_block(span) {
            match word {
                "TAG" => program.tags.extend(self.tags("END_TAG")),
                "ROUTINE" | "ST_ROUTINE" | "FBD_ROUTINE" | "SFC_ROUTINE" => {
                    program.routines.extend(self.routine(word));
                }
                "ENCODED_DATA" => match self.encoded_routine() {
                    Ok(routine) => program.routines.push(routine),
                    Err(encoded) => program.encoded.push(*encoded),
                },
                _ => {
                    if let Some(token) = self.cursor.peek() {
                        match self.island(word) {
                            Some(island) => program.islands.push(island),
                            None => self.unknown_declaration(word, token),
                        }
                    }
                }
            }
        }
        let end = self.close(&mut program.trivia);
        program.span = span.to(end);
        self.file.programs.push(program);
    }

    pub(super) fn task(&mut self) {
        let (head, span, trivia) = self.head("END_TASK");
        let mut task = components::task(head.name, Fields::new(head.attributes, &mut self.cursor.errors), span);
        task.trivia = trivia;
        while let Next::Word(_) = self.next_in_block(span) {
            let Some(token) = self.cursor.next() else { break };
            task.programs.push(Name::new(self.cursor.slice(token), self.cursor.span(token)));
            if !self.cursor.take(Token::Semicolon) {
                let place = self.cursor.file.locate(token.2, token.2);
                let message = "a `;` is missing here: a task lists its programs, `Name;`";
                self.cursor.errors.add(ErrorKind::MalformedDeclaration, place, message);
            }
        }
        let end = self.close(&mut task.trivia);
        task.span = span.to(end);
        self.file.tasks.push(task);
    }

    /// A routine of any language; nothing when it has no end.
    pub(super) fn routine(&mut self, word: &str) -> Option<Routine> {
        if word != "ROUTINE" {
            return self.foreign_routine(word);
        }
        let (head, span, trivia) = self.head("END_ROUTINE");
        let mut routine = components::routine(head.name, Fields::new(head.attributes, &mut self.cursor.errors), span);
        routine.trivia = trivia;
        let rungs = self.rungs(span);
        routine.body = RoutineBody::Ladder(rungs);
        let end = self.close(&mut routine.trivia);
        routine.span = span.to(end);
        Some(routine)
    }

    /// A routine in another language is an island: named, and skipped to its end.
    fn foreign_routine(&mut self, word: &str) -> Option<Routine> {
        let language = word.strip_suffix("_ROUTINE").unwrap_or(word);
        let (head, span, trivia) = self.head("");
        self.end_block();
        let mut routine = components::routine(head.name, Fields::new(head.attributes, &mut self.cursor.errors), span);
        routine.trivia = trivia;
        let text = self.island_body(word, span);
        routine.span = span.to(text.span);
        routine.body = RoutineBody::Island { language: Name::new(language, span), text };
        Some(routine)
    }

    /// An encoded routine among the routines of a program or an Add-On Instruction.
    pub(super) fn encoded_routine(&mut self) -> Result<Routine, Box<Encoded>> {
        let encoded = self.encoded();
        if !encoded.kind.text.to_ascii_uppercase().ends_with("ROUTINE") {
            return Err(Box::new(encoded));
        }
        let name = encoded.name.unwrap_or_default();
        let mut routine =
            components::routine(name, Fields::new(encoded.attributes, &mut self.cursor.errors), encoded.span);
        routine.trivia = encoded.trivia;
        routine.body = RoutineBody::Encoded { text: encoded.text };
        Ok(routine)
    }
}
