//! From bytes to a tree: which form a file has, and folders as one project.

use std::path::{Path, PathBuf};

use crate::errors::Errors;
use crate::limits::{FILE_BYTES_MAX, FOLDER_FILES_MAX};
use crate::text::read_text;
use crate::tree::{ErrorKind, File, ReadError, SourceId, Sources, Span};

/// What was read: always a tree, and what was wrong on the way.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Reading {
    /// Everything that could be read.
    pub file: File,
    /// Everything that could not, ordered by place.
    pub errors: Vec<ReadError>,
}

/// Reads the bytes of a file: an L5X when they are XML, `.rll` or L5K otherwise.
///
/// It never fails; bytes that hold nothing readable give an empty tree and an error.
pub fn read(sources: &mut Sources, path: impl Into<PathBuf>, bytes: Vec<u8>) -> Reading {
    let length = bytes.len();
    if length > FILE_BYTES_MAX {
        let message = format!("the file has {length} bytes; at most {FILE_BYTES_MAX} are read");
        return refused(sources, path, ErrorKind::TooLarge, message);
    }
    let mut errors = Errors::default();
    let (text, not_utf8) = match String::from_utf8(bytes) {
        Ok(text) => (text, None),
        Err(error) => {
            let at = error.utf8_error().valid_up_to();
            if is_utf16(error.as_bytes()) {
                let message = "the file is UTF-16; it must be UTF-8".to_string();
                return refused(sources, path, ErrorKind::NotUtf8, message);
            }
            (replace_invalid(&error.into_bytes()), Some(at))
        }
    };
    let source = sources.add(path, text);
    if let Some(at) = not_utf8 {
        let place = Span::new(source, at as u32, at as u32 + 1);
        let error = ReadError::new(ErrorKind::NotUtf8, place, "the file is not UTF-8 from here on");
        errors.push(error.with_help("save it as UTF-8; what is not UTF-8 was read as `?`"));
    }
    let text = sources.get(source).map_or("", |file| file.text());
    let (file, mut found) = if is_xml(text) { crate::xml::read_l5x(source, text) } else { read_text(source, text) };
    if is_empty(&file) && found.is_empty() {
        found.add(ErrorKind::Empty, Span::new(source, 0, 0), "the file declares nothing");
    }
    for error in found.into_list() {
        errors.push(error);
    }
    Reading { file, errors: errors.into_list() }
}

/// Reads a file, or a folder as one project: all `.rll` files in it and in folders below it, in the
/// order of their paths.
///
/// It never fails; what cannot be opened gives an empty tree and an error.
pub fn read_path(sources: &mut Sources, path: &Path) -> Reading {
    if path.is_dir() { read_folder(sources, path) } else { read_file(sources, path) }
}

fn read_file(sources: &mut Sources, path: &Path) -> Reading {
    let size = std::fs::metadata(path).map(|metadata| metadata.len());
    if let Ok(size) = size
        && size > FILE_BYTES_MAX as u64
    {
        let message = format!("the file has {size} bytes; at most {FILE_BYTES_MAX} are read");
        return refused(sources, path, ErrorKind::TooLarge, message);
    }
    match std::fs::read(path) {
        Ok(bytes) => read(sources, path, bytes),
        Err(error) => refused(sources, path, ErrorKind::Unreadable, format!("{}: {error}", path.display())),
    }
}

fn read_folder(sources: &mut Sources, folder: &Path) -> Reading {
    let mut paths = Vec::new();
    let mut waiting = vec![folder.to_path_buf()];
    while let Some(next) = waiting.pop() {
        let entries = match std::fs::read_dir(&next) {
            Ok(entries) => entries,
            Err(error) => {
                return refused(sources, &next, ErrorKind::Unreadable, format!("{}: {error}", next.display()));
            }
        };
        for entry in entries.flatten() {
            let path = entry.path();
            // A link could lead back into the folder.
            let kind = entry.file_type();
            if kind.as_ref().is_ok_and(|kind| kind.is_dir()) {
                waiting.push(path);
            } else if path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("rll")) {
                paths.push(path);
            }
        }
        if paths.len() + waiting.len() > FOLDER_FILES_MAX {
            let message = format!("{}: more than {FOLDER_FILES_MAX} files", folder.display());
            return refused(sources, folder, ErrorKind::TooMany, message);
        }
    }
    paths.sort();
    if paths.is_empty() {
        let message = format!("{}: no `.rll` file in this folder", folder.display());
        return refused(sources, folder, ErrorKind::Empty, message);
    }
    let mut whole = Reading::default();
    for path in paths {
        let next = read_file(sources, &path);
        whole.errors.extend(next.errors);
        whole.errors.extend(whole.file.merge(next.file));
    }
    whole
}

fn refused(sources: &mut Sources, path: impl Into<PathBuf>, kind: ErrorKind, message: String) -> Reading {
    let source = sources.add(path, String::new());
    let error = ReadError::new(kind, Span::new(source, 0, 0), message);
    Reading { file: File { sources: vec![source], ..File::default() }, errors: vec![error] }
}

impl File {
    /// Adds what another file declares: the files of a folder, or the context of a partial export.
    /// Routines outside a program stay so.
    ///
    /// A controller that is only context gives way to one that is not; of two real ones the first
    /// stays and the second is an error.
    pub fn merge(&mut self, other: File) -> Option<ReadError> {
        use crate::tree::Usage;
        if self.sources.is_empty() {
            self.form = other.form;
        }
        self.sources.extend(other.sources);
        self.export = self.export.take().or(other.export);
        self.ie_version = self.ie_version.take().or(other.ie_version);
        self.data_types.extend(other.data_types);
        self.modules.extend(other.modules);
        self.add_on_instructions.extend(other.add_on_instructions);
        self.tags.extend(other.tags);
        self.programs.extend(other.programs);
        self.routines.extend(other.routines);
        self.tasks.extend(other.tasks);
        self.encoded.extend(other.encoded);
        self.islands.extend(other.islands);
        for comment in other.trivia.leading().iter().chain(other.trivia.closing()) {
            self.trivia.push_closing(comment.clone());
        }
        match (&self.controller, other.controller) {
            (_, None) => None,
            (None, Some(theirs)) => {
                self.controller = Some(theirs);
                None
            }
            (Some(_), Some(theirs)) if theirs.usage == Usage::Context => None,
            (Some(ours), Some(theirs)) if ours.usage == Usage::Context => {
                self.controller = Some(theirs);
                None
            }
            (Some(ours), Some(theirs)) => {
                let message = format!("a second controller: `{}` is already declared in another file", ours.name);
                Some(ReadError::new(ErrorKind::TwoControllers, theirs.span, message))
            }
        }
    }
}

fn is_empty(file: &File) -> bool {
    file.controller.is_none()
        && file.data_types.is_empty()
        && file.modules.is_empty()
        && file.add_on_instructions.is_empty()
        && file.tags.is_empty()
        && file.programs.is_empty()
        && file.routines.is_empty()
        && file.tasks.is_empty()
        && file.encoded.is_empty()
        && file.islands.is_empty()
}

fn is_xml(text: &str) -> bool {
    let text = text.trim_start_matches('\u{feff}').trim_start();
    // No `.rll` begins with `<`.
    text.starts_with('<')
}

fn is_utf16(bytes: &[u8]) -> bool {
    bytes.starts_with(&[0xFF, 0xFE]) || bytes.starts_with(&[0xFE, 0xFF])
}

/// Every byte that is not part of UTF-8 becomes `?`, so that offsets stay.
fn replace_invalid(bytes: &[u8]) -> String {
    let mut text = String::with_capacity(bytes.len());
    for chunk in bytes.utf8_chunks() {
        text.push_str(chunk.valid());
        text.extend(std::iter::repeat_n('?', chunk.invalid().len()));
    }
    text
}

/// Where a source begins; for errors about a file as a whole.
pub(crate) fn beginning(source: SourceId) -> Span {
    Span::new(source, 0, 0)
}
