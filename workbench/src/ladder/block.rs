//! Rectangles of characters with a wire through them, set in series and in parallel.

/// Whether a character belongs to something marked.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Default)]
pub enum Mark {
    /// No.
    #[default]
    None,
    /// What has to do with it.
    Related,
    /// What a finding is about.
    Primary,
}

/// One character.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Cell {
    /// The character.
    pub character: char,
    /// Whether it is marked.
    pub mark: Mark,
}

/// A text as cells.
pub fn cells(text: &str, mark: Mark) -> Vec<Cell> {
    text.chars().map(|character| Cell { character, mark }).collect()
}

/// A rectangle of characters; the wire goes in and out at row `wire`. All rows are equally long.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Block {
    rows: Vec<Vec<Cell>>,
    wire: usize,
}

const BLANK: Cell = Cell { character: ' ', mark: Mark::None };
const WIRE: Cell = Cell { character: '─', mark: Mark::None };

impl Block {
    /// A block of these rows, padded to one length: the row of the wire with wire, the others with blanks.
    pub fn new(mut rows: Vec<Vec<Cell>>, wire: usize) -> Block {
        let width = rows.iter().map(Vec::len).max().unwrap_or(0);
        for (number, row) in rows.iter_mut().enumerate() {
            row.resize(width, if number == wire { WIRE } else { BLANK });
        }
        Block { rows, wire }
    }

    /// Columns.
    pub fn width(&self) -> usize {
        self.rows.first().map_or(0, Vec::len)
    }

    /// Blocks one behind the other on one wire.
    pub fn series(blocks: Vec<Block>) -> Block {
        let above = blocks.iter().map(|block| block.wire).max().unwrap_or(0);
        let below = blocks.iter().map(|block| block.rows.len() - block.wire).max().unwrap_or(1);
        let mut rows = vec![Vec::new(); above + below];
        for block in blocks {
            let width = block.width();
            let first = above - block.wire;
            let last = first + block.rows.len();
            for row in rows.iter_mut().take(first) {
                row.resize(row.len() + width, BLANK);
            }
            for row in rows.iter_mut().skip(last) {
                row.resize(row.len() + width, BLANK);
            }
            for (row, own) in rows.iter_mut().skip(first).zip(block.rows) {
                row.extend(own);
            }
        }
        Block::new(rows, above)
    }

    /// Blocks below each other between two branch points. An empty one is a wire.
    pub fn parallel(legs: Vec<Block>) -> Block {
        let width = legs.iter().map(Block::width).max().unwrap_or(0).max(2);
        let count = legs.len();
        let wire = legs.first().map_or(0, |leg| leg.wire);
        let mut rows = Vec::new();
        for (number, leg) in legs.into_iter().enumerate() {
            let (first, last) = (number == 0, number + 1 == count);
            for (line, own) in leg.rows.into_iter().enumerate() {
                let (left, right) = match (line.cmp(&leg.wire), first, last) {
                    (std::cmp::Ordering::Equal, true, true) => ("──", "──"),
                    (std::cmp::Ordering::Equal, true, false) => ("┬─", "─┬"),
                    (std::cmp::Ordering::Equal, false, false) => ("├─", "─┤"),
                    (std::cmp::Ordering::Equal, false, true) => ("└─", "─┘"),
                    // Above the first wire and below the last one nothing leads from leg to leg.
                    (std::cmp::Ordering::Less, true, _) | (std::cmp::Ordering::Greater, _, true) => ("  ", "  "),
                    (std::cmp::Ordering::Less | std::cmp::Ordering::Greater, _, _) => ("│ ", " │"),
                };
                let fill = if line == leg.wire { WIRE } else { BLANK };
                let spare = width - own.len();
                let mut row = cells(left, Mark::None);
                row.resize(row.len() + spare / 2, fill);
                row.extend(own);
                row.resize(row.len() + spare - spare / 2, fill);
                row.extend(cells(right, Mark::None));
                rows.push(row);
            }
        }
        Block::new(rows, wire)
    }

    /// The rows with the left rail at each, and what begins and ends the wire.
    pub fn between(self, begin: &str, end: &str) -> Vec<Vec<Cell>> {
        let wire = self.wire;
        let lines = self.rows.into_iter().enumerate().map(|(number, own)| {
            let mut row = cells(if number == wire { begin } else { "│ " }, Mark::None);
            row.extend(own);
            if number == wire {
                row.extend(cells(end, Mark::None));
            }
            row
        });
        lines.collect()
    }
}
