//! `ADD_ON_INSTRUCTION_DEFINITION`.

use super::{Next, Reader};
use crate::components;
use crate::fields::Fields;

impl Reader<'_> {
    pub(super) fn add_on_instruction(&mut self) {
        let (head, span, trivia) = self.head("END_ADD_ON_INSTRUCTION_DEFINITION");
        let fields = Fields::new(head.attributes, &mut self.cursor.errors);
        let mut add_on = components::add_on_instruction(head.name, fields, span);
        add_on.trivia = trivia;
        while let Next::Word(word) = self.next_in_block(span) {
            match word {
                "PARAMETERS" => add_on.parameters.extend(self.parameters()),
                "LOCAL_TAGS" => add_on.local_tags.extend(self.tags("END_LOCAL_TAGS")),
                "ROUTINE" | "ST_ROUTINE" | "FBD_ROUTINE" | "SFC_ROUTINE" => {
                    add_on.routines.extend(self.routine(word));
                }
                "HISTORY_ENTRY" => add_on.history.push(self.history_entry()),
                "ENCODED_DATA" => match self.encoded_routine() {
                    Ok(routine) => add_on.routines.push(routine),
                    Err(encoded) => self.file.encoded.push(*encoded),
                },
                _ => {
                    if let Some(token) = self.cursor.peek() {
                        match self.island(word) {
                            Some(island) => add_on.islands.push(island),
                            None => self.unknown_declaration(word, token),
                        }
                    }
                }
            }
        }
        let end = self.close(&mut add_on.trivia);
        add_on.span = span.to(end);
        self.file.add_on_instructions.push(add_on);
    }
}
