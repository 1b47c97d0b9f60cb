//! Lines, indentation, comments.

use crate::tree::Trivia;

/// Attributes go on in a new line before this column.
const LINE_MAX: usize = 120;
const INDENT: &str = "  ";

/// Text in the making.
pub(super) struct Layout {
    out: String,
    depth: usize,
    /// The last line begins a block, or there is none.
    opened: bool,
    /// The last thing was a block of several lines.
    closed: bool,
}

impl Layout {
    pub(super) fn new() -> Layout {
        Layout { out: String::new(), depth: 0, opened: true, closed: false }
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
        self.separate();
        self.indent();
        self.out.push_str(text);
        self.out.push('\n');
    }

    /// An empty line between a block and what follows it.
    fn separate(&mut self) {
        if self.closed {
            self.out.push('\n');
        }
        (self.opened, self.closed) = (false, false);
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
        self.separate();
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
        let begins_after = std::mem::replace(&mut self.opened, false);
        let start = self.out.len();
        self.declaration(trivia, head, attributes, "");
        let body = self.out.len();
        self.opened = true;
        self.inside(|layout| {
            print(layout);
            layout.closed = false;
            layout.closing(trivia);
        });
        let one_line = self.out.len() == body && trivia.trailing().is_empty();
        if one_line {
            self.out.truncate(body - 1);
            self.out.push(' ');
            self.out.push_str(end);
            self.out.push('\n');
        } else {
            self.indent();
            self.out.push_str(end);
            self.out.push('\n');
            // An empty line before a block that is not the first thing in its own.
            if !begins_after && !self.out[start..].starts_with('\n') {
                self.out.insert(start, '\n');
            }
        }
        (self.opened, self.closed) = (false, !one_line);
    }

    /// A block without a head: a list of tags.
    pub(super) fn list(&mut self, begin: &str, end: &str, print: impl FnOnce(&mut Layout)) {
        self.block(&Trivia::none(), begin, &[], end, print);
    }
}
