//! Lines, indentation, comments.

use crate::tree::Trivia;

/// Attributes go on in a new line before this column.
const LINE_MAX: usize = 120;
const INDENT: &str = "  ";

/// Text in the making.
pub(super) struct Layout {
    out: String,
    depth: usize,
}

impl Layout {
    pub(super) fn new() -> Layout {
        Layout { out: String::new(), depth: 0 }
    }

    pub(super) fn finish(self) -> String {
        self.out
    }

    fn indent(&mut self) {
        for _ in 0..self.depth {
            self.out.push_str(INDENT);
        }
    }

    /// A line of its own.
    pub(super) fn line(&mut self, text: &str) {
        self.indent();
        self.out.push_str(text);
        self.out.push('\n');
    }

    /// What is printed inside stands one step to the right.
    pub(super) fn inside(&mut self, print: impl FnOnce(&mut Layout)) {
        self.depth += 1;
        print(self);
        self.depth -= 1;
    }

    /// Comments before a declaration.
    pub(super) fn leading(&mut self, trivia: &Trivia) {
        for comment in trivia.leading() {
            self.line(comment);
        }
    }

    /// Comments before the end of a block.
    pub(super) fn closing(&mut self, trivia: &Trivia) {
        for comment in trivia.closing() {
            self.line(comment);
        }
    }

    /// A declaration with its comments: `before`, attributes in parentheses, `after`.
    pub(super) fn declaration(&mut self, trivia: &Trivia, before: &str, attributes: &[String], after: &str) {
        self.leading(trivia);
        self.indent();
        self.out.push_str(before);
        if !attributes.is_empty() {
            let mut column = self.depth * INDENT.len() + before.chars().count() + " (".len();
            self.out.push_str(" (");
            for (index, attribute) in attributes.iter().enumerate() {
                let width = attribute.chars().count() + ", ".len();
                if index > 0 && column + width > LINE_MAX {
                    self.out.push_str(",\n");
                    self.depth += 2;
                    self.indent();
                    self.depth -= 2;
                    column = (self.depth + 2) * INDENT.len();
                } else if index > 0 {
                    self.out.push_str(", ");
                }
                self.out.push_str(attribute);
                column += width;
            }
            self.out.push(')');
        }
        self.out.push_str(after);
        for comment in trivia.trailing() {
            self.out.push(' ');
            self.out.push_str(comment);
        }
        self.out.push('\n');
    }

    /// A block: its head, what is inside, the comments before its end, its end.
    pub(super) fn block(
        &mut self,
        trivia: &Trivia,
        head: &str,
        attributes: &[String],
        end: &str,
        print: impl FnOnce(&mut Layout),
    ) {
        self.declaration(trivia, head, attributes, "");
        self.inside(|layout| {
            print(layout);
            layout.closing(trivia);
        });
        self.line(end);
    }
}
