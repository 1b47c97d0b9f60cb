//! HTML pages that need nothing from elsewhere: one style, one way to write a table, readable on paper and without colour.

use std::fmt::{Display, Write as _};

const STYLE: &str = "body{font:15px/1.5 system-ui,sans-serif;max-width:72rem;margin:2rem auto;padding:0 1rem;color:#1b1f24;background:#fff}\
table{border-collapse:collapse;margin:1rem 0}td,th{padding:.2rem .8rem;text-align:left;vertical-align:top;border-bottom:1px solid #d0d7de}\
.n,.numbers td,.numbers th{text-align:right;font-variant-numeric:tabular-nums}.numbers td:first-child,.numbers th:first-child{text-align:left}code{font-size:13px;overflow-wrap:anywhere}\
pre{font:13px/1.25 ui-monospace,monospace;overflow-x:auto;padding:.6rem 1rem;background:#f6f8fa}\
.bar{fill:#3b73b9}.mark{stroke:#b3261e;stroke-dasharray:4 3}.axis{stroke:#8c959f}text{font-size:12px;fill:currentColor}\
.met{color:#1a7f37}.not{color:#b3261e;font-weight:600}.verdict{border-left:4px solid #3b73b9;padding:.4rem 1rem}\
@media(prefers-color-scheme:dark){body{color:#e6edf3;background:#0d1117}td,th{border-color:#30363d}pre{background:#161b22}\
.met{color:#3fb950}.not,.mark{color:#ff7b72;stroke:#ff7b72}text.not{stroke:none}}\
@media print{body{max-width:none;margin:0;font-size:11px;color:#000;background:#fff}td,th{padding:.1rem .4rem;border-color:#888}\
tr,svg{break-inside:avoid}h2,h3{break-after:avoid}thead{display:table-header-group}pre{white-space:pre-wrap;background:#fff}\
.met{color:#000}.not{color:#000;text-decoration:underline}}";

/// The end of a page.
pub const END: &str = "</body></html>\n";

/// The begin of a page, with its title as its first heading.
pub fn begin(title: &str) -> String {
    format!("{}<h1>{}</h1>\n", head(title), escaped(title))
}

/// The begin of a page without a heading.
pub fn head(title: &str) -> String {
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>{}</title>\
         <meta name=\"viewport\" content=\"width=device-width\"><style>{STYLE}</style></head><body>\n",
        escaped(title)
    )
}

/// Text in which no character is markup.
pub fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

/// What stands in a table.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Cell {
    /// Words.
    Text(String),
    /// A number, with its digits below each other.
    Number(String),
    /// What is typed or read by a machine.
    Code(String),
    /// What is as it should be.
    Met(String),
    /// What is not as it should be; the words say so as well.
    Not(String),
}

impl Cell {
    /// Words.
    pub fn text(text: impl Display) -> Cell {
        Cell::Text(text.to_string())
    }

    /// A count, its thousands apart.
    pub fn count(count: u64) -> Cell {
        Cell::Number(crate::bench::count(count))
    }

    fn class(&self) -> &'static str {
        match self {
            Cell::Text(_) | Cell::Code(_) => "",
            Cell::Number(_) => " class=\"n\"",
            Cell::Met(_) => " class=\"met\"",
            Cell::Not(_) => " class=\"not\"",
        }
    }

    fn words(&self) -> &str {
        match self {
            Cell::Text(text) | Cell::Number(text) | Cell::Code(text) | Cell::Met(text) | Cell::Not(text) => text,
        }
    }

    fn write(&self, out: &mut String) {
        let (class, words) = (self.class(), escaped(self.words()));
        // Writing to a String does not fail.
        let _ = match self {
            Cell::Code(_) => write!(out, "<td{class}><code>{words}</code>"),
            _ => write!(out, "<td{class}>{words}"),
        };
    }
}

/// A heading of the second or third level.
pub fn heading(out: &mut String, level: u8, text: &str) {
    let _ = writeln!(out, "<h{level}>{}</h{level}>", escaped(text));
}

/// A paragraph of words.
pub fn paragraph(out: &mut String, text: &str) {
    let _ = writeln!(out, "<p>{}</p>", escaped(text));
}

/// A paragraph that says what is not as it should be.
pub fn warning(out: &mut String, text: &str) {
    let _ = writeln!(out, "<p class=\"not\">{}</p>", escaped(text));
}

/// The verdict of a page, before everything else.
pub fn verdict(out: &mut String, is_good: bool, text: &str) {
    let class = if is_good { "met" } else { "not" };
    let _ = writeln!(out, "<p class=\"verdict\"><strong class=\"{class}\">{}</strong></p>", escaped(text));
}

/// A list; nothing where there is nothing in it.
pub fn list(out: &mut String, lines: impl IntoIterator<Item = Cell>) {
    let mut lines = lines.into_iter().peekable();
    if lines.peek().is_none() {
        return;
    }
    out.push_str("<ul>\n");
    for line in lines {
        let _ = writeln!(out, "<li{}>{}</li>", line.class(), escaped(line.words()));
    }
    out.push_str("</ul>\n");
}

/// Lines that are typed.
pub fn commands<'t>(out: &mut String, lines: impl IntoIterator<Item = &'t str>) {
    let lines: Vec<String> = lines.into_iter().map(escaped).collect();
    let _ = writeln!(out, "<pre>{}</pre>", lines.join("\n"));
}

/// A table; nothing where it has no rows. The head of a column of numbers stands over their digits.
pub fn table(out: &mut String, heads: &[&str], rows: impl IntoIterator<Item = Vec<Cell>>) {
    let mut rows = rows.into_iter().peekable();
    let Some(first) = rows.peek() else { return };
    out.push_str("<table><thead><tr>");
    for (index, name) in heads.iter().enumerate() {
        let class = if matches!(first.get(index), Some(Cell::Number(_))) { " class=\"n\"" } else { "" };
        let _ = write!(out, "<th{class}>{}", escaped(name));
    }
    out.push_str("</tr></thead><tbody>\n");
    for row in rows {
        out.push_str("<tr>");
        row.iter().for_each(|cell| cell.write(out));
        out.push_str("</tr>\n");
    }
    out.push_str("</tbody></table>\n");
}

/// Seconds as people say them.
pub fn duration(seconds: f64) -> String {
    let whole = seconds.max(0.0) as u64;
    match whole {
        0..60 => format!("{seconds:.1} s"),
        60..3600 => format!("{} min {} s", whole / 60, whole % 60),
        _ => format!("{} h {} min", whole / 3600, whole / 60 % 60),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn table_when_written_then_text_is_no_markup_and_numbers_stand_below_each_other() {
        let mut out = String::new();
        table(&mut out, &["a", "n"], [vec![Cell::text("<b>&"), Cell::count(1_234_567)]]);
        assert_eq!(
            out,
            "<table><thead><tr><th>a<th class=\"n\">n</tr></thead><tbody>\n\
             <tr><td>&lt;b&gt;&amp;<td class=\"n\">1,234,567</tr>\n</tbody></table>\n"
        );
    }

    #[test]
    fn durations_when_said_then_the_unit_suits_them() {
        let said = [0.25, 59.0, 61.0, 3600.0, 86_399.0].map(duration);
        assert_eq!(said, ["0.2 s", "59.0 s", "1 min 1 s", "1 h 0 min", "23 h 59 min"]);
    }
}
