//! A rung drawn as ladder, in text, with operands marked.
//!
//! Contacts and coils are drawn as such, every other instruction as a box with its operands, branches as branches. What
//! does not fit into the width goes on in the next line. A rung that cannot be drawn in a readable size is not drawn.

mod block;
mod element;

use twinrung_grammar::tree::{Element, Rung, Span};

use block::{Block, Cell, Mark};

/// Instructions of the largest rung that is drawn.
const INSTRUCTIONS_MAX: usize = 64;
/// Lines of the highest drawing.
const LINES_MAX: usize = 72;
/// Characters of an operand, from generous to terse: the first that fits is taken.
const NAME_LENGTHS: [usize; 3] = [40, 22, 12];
/// Columns below which nothing is drawn.
const COLUMNS_MIN: usize = 24;

/// Which places of a rung are marked.
#[derive(Debug, Clone, Copy, Default)]
pub struct Places<'a> {
    /// What a finding is about.
    pub primary: Option<Span>,
    /// What has to do with it.
    pub related: &'a [Span],
}

/// Draws a rung within `columns`; nothing where it would not be readable.
pub fn draw(rung: &Rung, places: Places<'_>, columns: usize, colour: bool) -> Option<Vec<String>> {
    let count = instructions(&rung.elements);
    if rung.broken || count == 0 || count > INSTRUCTIONS_MAX || columns < COLUMNS_MIN {
        return None;
    }
    // Who means the whole rung marks nothing in it.
    let whole = |span: &Span| span.start <= rung.span.start && rung.span.end <= span.end;
    let places = Places { primary: places.primary.filter(|span| !whole(span)), ..places };
    NAME_LENGTHS.iter().find_map(|names| {
        let style = element::Style { names: *names, places };
        let blocks: Vec<Block> = rung.elements.iter().map(|one| of_element(one, &style)).collect();
        let lines = fold(blocks, columns)?;
        (lines.len() <= LINES_MAX).then(|| lines.iter().map(|line| text(line, colour)).collect())
    })
}

fn instructions(elements: &[Element]) -> usize {
    let of = |element: &Element| match element {
        Element::Instruction(_) => 1,
        Element::Branch(branch) => branch.legs.iter().map(|leg| instructions(&leg.elements)).sum(),
    };
    elements.iter().map(of).sum()
}

fn of_element(element: &Element, style: &element::Style<'_>) -> Block {
    match element {
        Element::Instruction(instruction) => element::block(instruction, style),
        Element::Branch(branch) => {
            let legs = branch
                .legs
                .iter()
                .map(|leg| Block::series(leg.elements.iter().map(|one| of_element(one, style)).collect()));
            Block::parallel(legs.collect())
        }
    }
}

/// Sets blocks in series between the rails, on as many lines as are needed.
fn fold(blocks: Vec<Block>, columns: usize) -> Option<Vec<Vec<Cell>>> {
    // Rails, a wire at each end, and the arrow of a line that goes on.
    let room = columns.checked_sub(6)?;
    let mut rows: Vec<Vec<Block>> = vec![Vec::new()];
    let mut used = 0;
    for block in blocks {
        let width = block.width();
        if width > room {
            return None;
        }
        if used + width > room {
            rows.push(Vec::new());
            used = 0;
        }
        used += width;
        rows.last_mut()?.push(block);
    }
    let last = rows.len() - 1;
    let mut lines = Vec::new();
    for (number, row) in rows.into_iter().enumerate() {
        let begin = if number == 0 { "├─" } else { "►─" };
        let end = if number == last { "─┤" } else { "─►" };
        lines.extend(Block::series(row).between(begin, end));
    }
    Some(lines)
}

/// A line as text. Marked cells are red, related ones yellow, where there is colour.
fn text(line: &[Cell], colour: bool) -> String {
    const RED: &str = "\u{1b}[1;31m";
    const YELLOW: &str = "\u{1b}[1;33m";
    const PLAIN: &str = "\u{1b}[0m";
    let mut out = String::new();
    let mut current = Mark::None;
    for cell in line {
        if colour && cell.mark != current {
            out.push_str(match cell.mark {
                Mark::None => PLAIN,
                Mark::Primary if current == Mark::None => RED,
                Mark::Related if current == Mark::None => YELLOW,
                Mark::Primary => "\u{1b}[0m\u{1b}[1;31m",
                Mark::Related => "\u{1b}[0m\u{1b}[1;33m",
            });
            current = cell.mark;
        }
        out.push(cell.character);
    }
    if colour && current != Mark::None {
        out.push_str(PLAIN);
    }
    out.truncate(out.trim_end().len());
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    fn drawn(neutral: &str, marked: &str) -> String {
        let mut sources = twinrung_grammar::tree::Sources::new();
        let text = format!("ROUTINE Main\n  N: {neutral}\nEND_ROUTINE\n");
        let start = text.find(marked).unwrap() as u32;
        let reading = twinrung_grammar::read(&mut sources, "rung.rll", text.into_bytes());
        let rung = &reading.file.routines[0].rungs()[0];
        let primary = Some(Span::new(rung.span.source, start, start + marked.len() as u32));
        draw(rung, Places { primary, related: &[] }, 72, false).unwrap().join("\n")
    }

    #[test]
    fn contacts_when_in_series_and_parallel_then_drawn_as_ladder() {
        let expected = "\
│    Start    Stop  Run
├─┬───┤ ├───┬─┤/├───( )──┤
│ │   Run   │  ▲
│ └───┤ ├───┘";
        let found = drawn("[XIC(Start) ,XIC(Run) ]XIO(Stop)OTE(Run);", "Stop");
        assert_eq!(found, expected, "\n{found}");
    }

    #[test]
    fn boxes_when_an_operand_is_marked_then_an_arrow_points_at_it() {
        let found = drawn("XIC(Door)TON(Delay,500,?);", "500");
        let expected = "\
│  Door  ┌─ TON ─────────┐
├──┤ ├───┤ Timer   Delay ├──┤
│        │ Preset  500  ◄│
│        │ Accum   ?     │
│        └───────────────┘";
        assert_eq!(found, expected, "\n{found}");
    }

    #[test]
    fn rungs_when_wider_than_the_page_then_go_on_in_the_next_line() {
        let neutral: String = (0..12).map(|number| format!("XIC(Contact_{number})")).collect();
        let found = drawn(&format!("{neutral}OTE(Coil);"), "Coil");
        assert!(found.contains("─►") && found.contains("►─"), "\n{found}");
        assert!(found.lines().all(|line| line.chars().count() <= 72), "\n{found}");
    }
}
