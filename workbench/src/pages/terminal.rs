//! A page on a terminal.

use std::fmt::Write;

use super::{Block, Page, Table};

/// Narrowest page that is drawn; a narrower terminal breaks the lines itself.
const LEAST_COLUMNS: usize = 60;
const INDENT: usize = 2;

pub(super) fn draw(page: &Page, columns: usize) -> String {
    let columns = columns.max(LEAST_COLUMNS);
    let mut out = String::new();
    let _ = writeln!(out, "{}", page.title);
    let mut below_heading = false;
    for block in &page.blocks {
        // A heading stands right above what it heads.
        if !below_heading {
            out.push('\n');
        }
        below_heading = matches!(block, Block::Heading(_));
        match block {
            Block::Heading(text) => {
                let _ = writeln!(out, "{}", text.to_uppercase());
            }
            Block::Paragraph(text) => wrapped(&mut out, text, INDENT, INDENT, columns),
            Block::Verbatim(lines) => lines.iter().for_each(|line| broken(&mut out, line, columns)),
            Block::Table(table) => rows(&mut out, table, columns),
            Block::Entries(table) => entries(&mut out, table, columns),
            Block::Timing(timing) => {
                for line in timing.draw(columns - INDENT).lines() {
                    let _ = writeln!(out, "{}", format!("{:INDENT$}{line}", "").trim_end());
                }
            }
        }
    }
    out
}

/// Writes words with a first and a further indent, within the columns.
pub fn wrapped(out: &mut String, text: &str, first: usize, further: usize, columns: usize) {
    let mut column = first;
    let _ = write!(out, "{:first$}", "");
    let mut begun = false;
    for word in text.split_whitespace() {
        let length = word.chars().count();
        if begun && column + 1 + length > columns {
            let _ = write!(out, "\n{:further$}", "");
            column = further;
        } else if begun {
            out.push(' ');
            column += 1;
        }
        out.push_str(word);
        column += length;
        begun = true;
    }
    out.push('\n');
}

/// Writes a line of source text; one that is too long is broken after commas.
fn broken(out: &mut String, line: &str, columns: usize) {
    let (first, further) = (INDENT + 2, INDENT + 6);
    let mut column = first;
    let _ = write!(out, "{:first$}", "");
    for part in line.split_inclusive(',') {
        let length = part.chars().count();
        if column + length > columns && column > further {
            let _ = write!(out, "\n{:further$}", "");
            column = further;
        }
        out.push_str(part);
        column += length;
    }
    let kept = out.trim_end_matches(' ').len();
    out.truncate(kept);
    out.push('\n');
}

/// Columns as wide as their longest cell; the last one takes what is left.
fn rows(out: &mut String, table: &Table, columns: usize) {
    let width = |column: usize| table.rows.iter().map(|row| row[column].chars().count()).max().unwrap_or(0);
    let last = table.heads.len().saturating_sub(1);
    let widths: Vec<usize> = (0..last).map(width).collect();
    let hang = INDENT + widths.iter().map(|width| width + 2).sum::<usize>();
    for row in &table.rows {
        let _ = write!(out, "{:INDENT$}", "");
        for (cell, width) in row.iter().zip(&widths) {
            let _ = write!(out, "{cell:<width$}  ");
        }
        let mut text = String::new();
        wrapped(&mut text, &row[last], hang, hang, columns);
        out.push_str(text.get(hang..).unwrap_or_default());
        let kept = out.trim_end().len();
        out.truncate(kept);
        out.push('\n');
    }
}

/// The first cell stands alone; below it the others, each with its head.
fn entries(out: &mut String, table: &Table, columns: usize) {
    let (label, gap) = (table.heads.iter().skip(1).map(|head| head.chars().count()).max().unwrap_or(0), 2);
    let hang = INDENT + 2 + label + gap;
    for row in &table.rows {
        wrapped(out, &row[0], INDENT, INDENT, columns);
        for (head, cell) in table.heads.iter().zip(row).skip(1).filter(|(_, cell)| !cell.is_empty()) {
            let mut text = String::new();
            wrapped(&mut text, cell, hang, hang, columns);
            let _ = write!(out, "{:indent$}{head:<width$}", "", indent = INDENT + 2, width = label + gap);
            out.push_str(text.get(hang..).unwrap_or_default());
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn page(block: Block) -> String {
        Page { title: "T".into(), blocks: vec![block] }.terminal(60)
    }

    #[test]
    fn paragraph_when_longer_than_a_line_then_it_is_wrapped_within_the_columns() {
        let drawn = page(Block::Paragraph("word ".repeat(30)));
        assert_eq!(drawn.lines().filter(|line| line.chars().count() > 60).count(), 0);
        assert_eq!(drawn.split_whitespace().filter(|word| *word == "word").count(), 30);
    }

    #[test]
    fn source_text_when_longer_than_a_line_then_it_is_broken_after_commas() {
        let line = format!("DCS({})", ["OPERAND WITH BLANKS"; 5].join(","));
        let drawn = page(Block::Verbatim(vec![line.clone()]));
        assert_eq!(drawn.lines().filter(|line| line.chars().count() > 60).count(), 0);
        let joined: String = drawn.lines().skip(2).map(str::trim_start).collect();
        assert_eq!(joined, line);
    }

    #[test]
    fn table_when_drawn_then_columns_are_aligned_and_the_last_one_hangs() {
        let rows = vec![vec!["A".into(), "short".into()], vec!["Longer".into(), "word ".repeat(15)]];
        let drawn = page(Block::Table(Table { heads: vec!["a", "b"], rows }));
        let lines: Vec<&str> = drawn.lines().skip(2).collect();
        assert_eq!(lines[0], "  A       short");
        assert!(lines[1].starts_with("  Longer  word word"), "{drawn}");
        assert!(lines[2].starts_with("          word"), "{drawn}");
    }

    #[test]
    fn entries_when_drawn_then_each_cell_has_its_head() {
        let rows = vec![vec!["FaultCode 1".into(), "broken".into(), "mend it".into()]];
        let drawn = page(Block::Entries(Table { heads: vec!["code", "cause", "do"], rows }));
        assert_eq!(drawn, "T\n\n  FaultCode 1\n    cause  broken\n    do     mend it\n");
    }

    #[test]
    fn heading_when_drawn_then_it_stands_right_above_its_text() {
        let blocks = vec![Block::Heading("Codes".into()), Block::Paragraph("None.".into())];
        let drawn = Page { title: "T".into(), blocks }.terminal(60);
        assert_eq!(drawn, "T\n\nCODES\n  None.\n");
    }
}
