//! `DATATYPE`.

use super::{Next, Reader, declaration};
use crate::components;
use crate::fields::Fields;

impl Reader<'_> {
    pub(super) fn data_type(&mut self) {
        let (head, span, trivia) = self.head("END_DATATYPE");
        let mut data_type =
            components::data_type(head.name, Fields::new(head.attributes, &mut self.cursor.errors), span);
        data_type.trivia = trivia;
        while let Next::Word(_) = self.next_in_block(span) {
            let mut trivia = self.cursor.leading();
            let parsed = self
                .statement("a member", |file, run| declaration::MemberParser::new().parse(file, run.iter().copied()));
            if let Some(((typed, attributes), span)) = parsed {
                self.cursor.trailing(&mut trivia);
                let fields = Fields::new(attributes, &mut self.cursor.errors);
                let mut member = components::member(typed.name, typed.data_type, fields, span);
                member.dimensions = typed.dimensions;
                member.bit = typed.bit.map(Box::new);
                member.trivia = trivia;
                data_type.members.push(member);
            }
        }
        let end = self.close(&mut data_type.trivia);
        data_type.span = span.to(end);
        self.file.data_types.push(data_type);
    }
}
