//! `<Tag>`, and `<LocalTag>`, which looks like it.

use super::cursor::Element;
use super::{Reader, usage};
use crate::components;
use crate::tree::{OperandComment, Tag, TagKind, Usage};

impl<'a> Reader<'a> {
    pub(super) fn tag(&mut self, element: &Element<'a>, around: Usage) -> Tag {
        let fields = element.fields(&["Name", "DataType", "Dimensions", "Use"], &mut self.xml.errors);
        let mut tag = components::tag(element.name_of("Name"), fields, element.span);
        tag.usage = usage(element, around);
        tag.data_type = element.optional_name("DataType");
        tag.dimensions = self.dimensions(element.get("Dimensions"));
        while let Some(child) = self.xml.child() {
            match child.name {
                "Description" => tag.description = self.description(),
                "Comments" => tag.comments = self.operand_comments(),
                "ProduceInfo" => {
                    let mut fields = child.fields(&[], &mut self.xml.errors);
                    tag.kind = TagKind::Produced(Box::new(components::produce_info(&mut fields)));
                    tag.attributes.extend(fields.rest());
                    self.xml.skip();
                }
                "ConsumeInfo" => {
                    let mut fields = child.fields(&[], &mut self.xml.errors);
                    tag.kind = TagKind::Consumed(Box::new(components::consume_info(&mut fields)));
                    tag.attributes.extend(fields.rest());
                    self.xml.skip();
                }
                "Data" | "DefaultData" => {
                    // L5K and decorated: most exports have these two.
                    tag.data.reserve_exact(2);
                    tag.data.extend(self.data(&child));
                }
                "ForceData" => tag.forces.extend(self.data(&child)),
                _ => self.xml.skip(),
            }
        }
        tag
    }

    /// `<Comment Operand=".0">`
    fn operand_comments(&mut self) -> Vec<OperandComment> {
        let mut comments = Vec::new();
        while let Some(child) = self.xml.child() {
            let operand = child.get("Operand");
            let text = self.xml.content().into_text();
            comments.extend(operand.map(|operand| OperandComment { operand, text }));
        }
        comments
    }
}
