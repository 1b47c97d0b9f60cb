//! What a report quotes of a file: the lines of a place and no more, and of an endless line the part around it.

use miette::{MietteError, MietteSpanContents, SourceCode, SourceSpan, SpanContents};
use twinrung_grammar::tree::{Source, Sources, Span};

/// Bytes of a line that is quoted whole. An export may hold everything in one line.
const LINE_MAX: usize = 240;
/// Bytes that are quoted before and behind a place in a longer line.
const AROUND: usize = 80;
/// Lines that a mark may go over; a longer one marks the first line.
const LINES_MAX: u32 = 4;

/// A file as miette reads it.
#[derive(Debug)]
pub struct Quote<'a> {
    source: Option<&'a Source>,
}

impl<'a> Quote<'a> {
    /// The file of a place.
    pub fn of(sources: &'a Sources, span: Span) -> Quote<'a> {
        Quote { source: sources.get(span.source) }
    }
}

/// What to mark for a span: itself, or its first line where it is long.
pub fn range(sources: &Sources, span: Span) -> (usize, usize) {
    let whole = (span.start as usize, span.len() as usize);
    let Some(source) = sources.get(span.source) else { return whole };
    let (first, last) = (source.line_column(span.start).line, source.line_column(span.end).line);
    if last.saturating_sub(first) < LINES_MAX {
        return whole;
    }
    let end = line_start(source, first) + source.line(first).len();
    (whole.0, end.saturating_sub(whole.0))
}

/// Where a line begins in its file.
fn line_start(source: &Source, line: u32) -> usize {
    (source.line(line).as_ptr() as usize).saturating_sub(source.text().as_ptr() as usize).min(source.text().len())
}

impl SourceCode for Quote<'_> {
    fn read_span<'a>(
        &'a self,
        span: &SourceSpan,
        before: usize,
        after: usize,
    ) -> Result<Box<dyn SpanContents<'a> + 'a>, MietteError> {
        let source = self.source.ok_or(MietteError::OutOfBounds)?;
        let text = source.text();
        let (from, to) = (span.offset(), span.offset().saturating_add(span.len()));
        if to > text.len() {
            return Err(MietteError::OutOfBounds);
        }
        if before == 0 && after == 0 {
            // Where it begins, for the head of a quotation.
            return Ok(contents(source, from, to));
        }
        let line_of = |offset: usize| source.line_column(offset as u32).line;
        let first = line_of(from).saturating_sub(before as u32).max(1);
        let last = line_of(to).saturating_add(after as u32);
        let begin = line_start(source, first);
        let mut end = begin;
        let mut longest = 0;
        for line in first..=last {
            let length = source.line(line).len();
            let start = line_start(source, line);
            if start < end {
                break;
            }
            longest = longest.max(length);
            end = start + length;
        }
        let (begin, end) = if longest > LINE_MAX {
            (
                text.floor_char_boundary(from.saturating_sub(AROUND).max(begin)),
                text.floor_char_boundary((to + AROUND).min(end).max(to)),
            )
        } else {
            (begin, end.max(to))
        };
        Ok(contents(source, begin, end))
    }
}

fn contents(source: &Source, begin: usize, end: usize) -> Box<dyn SpanContents<'_> + '_> {
    let place = source.line_column(begin as u32);
    let data = source.text().get(begin..end).unwrap_or("").as_bytes();
    let count = data.iter().filter(|byte| **byte == b'\n').count() + 1;
    Box::new(MietteSpanContents::new_named(
        source.path().display().to_string(),
        data,
        (begin, end - begin).into(),
        place.line as usize - 1,
        place.column as usize - 1,
        count,
    ))
}
