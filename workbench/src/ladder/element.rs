//! One instruction as a block: a contact, a coil, or a box with its operands.

use twinrung_catalog::{Instruction as Declaration, Position};
use twinrung_grammar::tree::{Instruction, Span};

use super::Places;
use super::block::{Block, Cell, Mark, cells};

/// How instructions are drawn.
pub struct Style<'a> {
    /// Characters of an operand at most.
    pub names: usize,
    /// What is marked.
    pub places: Places<'a>,
}

impl Style<'_> {
    /// How a place is marked: an operand when a finding begins in it, or encloses it.
    fn mark(&self, place: Span) -> Mark {
        let touches = |span: &Span| {
            let within = (place.start..place.end.max(place.start + 1)).contains(&span.start);
            span.source == place.source && (within || (span.start <= place.start && place.end <= span.end))
        };
        if self.places.primary.as_ref().is_some_and(touches) {
            Mark::Primary
        } else if self.places.related.iter().any(touches) {
            Mark::Related
        } else {
            Mark::None
        }
    }

    /// How an instruction is marked by what encloses all of it.
    fn mark_of_whole(&self, place: Span) -> Mark {
        let covers = |span: &Span| span.source == place.source && span.start <= place.start && place.end <= span.end;
        if self.places.primary.as_ref().is_some_and(covers) {
            Mark::Primary
        } else if self.places.related.iter().any(covers) {
            Mark::Related
        } else {
            Mark::None
        }
    }

    fn name(&self, text: &str) -> String {
        let text = if text.is_empty() { "?" } else { text };
        if text.chars().count() <= self.names {
            return text.to_owned();
        }
        let kept: String = text.chars().take(self.names - 1).collect();
        format!("{kept}…")
    }
}

/// The block of an instruction.
pub fn block(instruction: &Instruction, style: &Style<'_>) -> Block {
    let declaration = Declaration::by_mnemonic(instruction.mnemonic.as_str());
    match instruction.operands.as_slice() {
        [] => symbol(instruction, "", &format!("[{}]", instruction.mnemonic), style),
        [one] => symbol(instruction, &one.text, &sign(instruction, declaration), style),
        _ => boxed(instruction, declaration, style),
    }
}

/// How an instruction of one operand is drawn on the wire.
fn sign(instruction: &Instruction, declaration: Option<&Declaration>) -> String {
    let mnemonic = instruction.mnemonic.as_str().to_ascii_uppercase();
    match mnemonic.as_str() {
        "XIC" => "┤ ├".to_owned(),
        "XIO" => "┤/├".to_owned(),
        "OTE" => "( )".to_owned(),
        "OTL" => "(L)".to_owned(),
        "OTU" => "(U)".to_owned(),
        // What decides whether the rung goes on looks like a contact, what acts like a coil.
        _ if declaration.is_some_and(|one| one.position == Position::Input) => format!("┤{mnemonic}├"),
        _ => format!("({mnemonic})"),
    }
}

/// A name above, a sign on the wire, and an arrow below what is marked.
fn symbol(instruction: &Instruction, name: &str, sign: &str, style: &Style<'_>) -> Block {
    let of_operand = instruction.operands.first().map_or(Mark::None, |operand| style.mark(operand.span));
    let mark = if of_operand == Mark::None { style.mark(instruction.span) } else { of_operand };
    let name = if name.is_empty() && instruction.operands.is_empty() { String::new() } else { style.name(name) };
    let width = name.chars().count().max(sign.chars().count()) + 2;
    let mut rows = vec![centred(&name, width, ' ', mark), centred(sign, width, '─', mark)];
    match mark {
        Mark::None => {}
        Mark::Primary => rows.push(centred("▲", width, ' ', mark)),
        Mark::Related => rows.push(centred("△", width, ' ', mark)),
    }
    Block::new(rows, 1)
}

fn centred(text: &str, width: usize, fill: char, mark: Mark) -> Vec<Cell> {
    let spare = width - text.chars().count();
    let filling = |count: usize| vec![Cell { character: fill, mark: Mark::None }; count];
    let mut row = filling(spare / 2);
    row.extend(cells(text, mark));
    row.extend(filling(spare - spare / 2));
    row
}

/// A box with the mnemonic above and one line for each operand; the wire goes in at the first one.
fn boxed(instruction: &Instruction, declaration: Option<&Declaration>, style: &Style<'_>) -> Block {
    struct Line {
        name: String,
        value: String,
        mark: Mark,
    }
    let operands = instruction.operands.iter().enumerate();
    let title_mark = style.mark_of_whole(instruction.span);
    let lines: Vec<Line> = operands
        .map(|(position, operand)| Line {
            name: declaration.and_then(|one| one.operand(position)).map(|one| one.name.to_owned()).unwrap_or_default(),
            value: style.name(&operand.text),
            mark: if title_mark == Mark::None { style.mark(operand.span) } else { Mark::None },
        })
        .collect();
    let names = lines.iter().map(|line| line.name.chars().count()).max().unwrap_or(0);
    let values = lines.iter().map(|line| line.value.chars().count()).max().unwrap_or(0);
    let gap = if names == 0 { 0 } else { 2 };
    let mnemonic = instruction.mnemonic.as_str();
    let inner = (names + gap + values).max(mnemonic.chars().count() + 3);
    let of_operands = lines.iter().any(|line| line.mark != Mark::None);
    let title_mark = if of_operands { Mark::None } else { title_mark.max(style.mark(instruction.span)) };

    let mut title = cells(" ┌─ ", Mark::None);
    title.extend(cells(mnemonic, title_mark));
    title.extend(cells(arrow(title_mark), title_mark));
    let rest = (inner + 3).saturating_sub(title.len());
    title.extend(cells(&format!(" {}┐ ", "─".repeat(rest)), Mark::None));
    let mut rows = vec![title];
    for (number, line) in lines.iter().enumerate() {
        let (left, right) = if number == 0 { ("─┤ ", "├─") } else { (" │ ", "│ ") };
        let mut row = cells(left, Mark::None);
        let name = format!("{:names$}{}", line.name, " ".repeat(gap));
        row.extend(cells(&name, Mark::None));
        row.extend(cells(&line.value, line.mark));
        let rest = inner - names - gap - line.value.chars().count();
        row.extend(cells(&" ".repeat(rest), Mark::None));
        row.extend(cells(
            match line.mark {
                Mark::None => " ",
                Mark::Primary => "◄",
                Mark::Related => "◁",
            },
            line.mark,
        ));
        row.extend(cells(right, Mark::None));
        rows.push(row);
    }
    rows.push(cells(&format!(" └{}┘ ", "─".repeat(inner + 2)), Mark::None));
    Block::new(rows, 1)
}

fn arrow(mark: Mark) -> &'static str {
    match mark {
        Mark::None => "",
        Mark::Primary => " ◄",
        Mark::Related => " ◁",
    }
}
