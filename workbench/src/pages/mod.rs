//! The instruction pages: what `explain` prints, and what lies in `docs/instructions`. Both are one text, drawn for a
//! terminal or as Markdown; it is made of the catalog and of the vectors of normal operation.

pub mod codes;
pub mod findings;
pub mod index;
pub mod instruction;
pub mod markdown;
mod operands;
pub mod protection;
mod structures;
pub mod terminal;
pub mod timing;

pub use timing::Timing;

/// A page: a title and blocks, drawn by [`Page::terminal`] or [`Page::markdown`].
#[derive(Debug, Clone, PartialEq)]
pub struct Page {
    /// The first line.
    pub title: String,
    /// What follows.
    pub blocks: Vec<Block>,
}

/// A part of a page.
#[derive(Debug, Clone, PartialEq)]
pub enum Block {
    /// Begins a section.
    Heading(String),
    /// Running text.
    Paragraph(String),
    /// Text that keeps its lines; longer ones are broken after a comma.
    Verbatim(Vec<String>),
    /// Rows of short cells; only the last column may be long.
    Table(Table),
    /// Rows whose cells are all sentences: on a terminal each is a paragraph of its own.
    Entries(Table),
    /// A timing diagram.
    Timing(Timing),
}

/// Rows of cells below column heads.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Table {
    /// One head for each column.
    pub heads: Vec<&'static str>,
    /// The rows, each with a cell for every head.
    pub rows: Vec<Vec<String>>,
}

impl Page {
    /// The page for a terminal of so many columns.
    pub fn terminal(&self, columns: usize) -> String {
        terminal::draw(self, columns)
    }

    /// The page as Markdown.
    pub fn markdown(&self) -> String {
        markdown::draw(self)
    }

    fn heading(&mut self, text: &str) {
        self.blocks.push(Block::Heading(text.to_owned()));
    }

    fn paragraph(&mut self, text: impl Into<String>) {
        self.blocks.push(Block::Paragraph(text.into()));
    }
}
