//! A page as Markdown.

use std::fmt::Write;

use super::{Block, Page, Table};

/// Columns of what keeps its lines: a diagram is not wrapped by a browser.
const COLUMNS: usize = 100;

pub(super) fn draw(page: &Page) -> String {
    let mut out = format!("# {}\n", escaped(&page.title));
    for block in &page.blocks {
        out.push('\n');
        match block {
            Block::Heading(text) => {
                let _ = writeln!(out, "## {}", escaped(text));
            }
            Block::Paragraph(text) => {
                let _ = writeln!(out, "{}", escaped(text));
            }
            Block::Verbatim(lines) => fenced(&mut out, &lines.join("\n")),
            Block::Table(table) | Block::Entries(table) => rows(&mut out, table),
            Block::Timing(timing) => fenced(&mut out, timing.draw(COLUMNS).trim_end()),
        }
    }
    out
}

fn fenced(out: &mut String, text: &str) {
    let _ = writeln!(out, "```text\n{text}\n```");
}

fn rows(out: &mut String, table: &Table) {
    let _ = writeln!(out, "| {} |", table.heads.join(" | "));
    let _ = writeln!(out, "|{}", "---|".repeat(table.heads.len()));
    for row in &table.rows {
        let cells: Vec<String> = row.iter().map(|cell| escaped(cell)).collect();
        let _ = writeln!(out, "| {} |", cells.join(" | "));
    }
}

/// Text in which no character is markup but the marks around quoted words. An underscore within a name is none.
pub fn escaped(text: &str) -> String {
    text.replace('\\', "\\\\").replace('|', "\\|").replace('*', "\\*").replace('<', "&lt;").replace('[', "\\[")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn page_when_drawn_then_markup_in_its_text_is_escaped_and_source_text_is_not() {
        let table = Table { heads: vec!["a", "b"], rows: vec![vec!["x|y".into(), "A_B".into()]] };
        let blocks = vec![Block::Heading("H".into()), Block::Verbatim(vec!["XIC(A_B)".into()]), Block::Table(table)];
        let drawn = Page { title: "T".into(), blocks }.markdown();
        assert_eq!(drawn, "# T\n\n## H\n\n```text\nXIC(A_B)\n```\n\n| a | b |\n|---|---|\n| x\\|y | A_B |\n");
    }
}
