//! XML as a sequence of elements with their places. A reader asks for the children of the element it
//! is in, one by one, and takes each to its end: as children, as text, or by skipping it.
//!
//! After an error in the XML there are no more children: what was read before it stays.

use std::borrow::Cow;

use quick_xml::events::{BytesStart, Event};

use crate::budget::{BYTES_FOR_EACH, Budget};
use crate::errors::Errors;
use crate::excerpt::Excerpt;
use crate::fields::Fields;
use crate::limits::{XML_ATTRIBUTES_MAX, XML_DEPTH_MAX};
use crate::tree::{Attribute, AttributeValue, CompactString, ErrorKind, Name, OriginMap, SourceId, Span, Text};

/// What an element takes in the tree: a tag takes more, a value less.
const ELEMENT_BYTES: usize = 300;

/// A position in an XML file.
pub(crate) struct Xml<'a> {
    reader: quick_xml::Reader<&'a [u8]>,
    text: &'a str,
    source: SourceId,
    pub(crate) errors: Errors,
    budget: Budget,
    depth: usize,
    /// After the end of the file, or an error.
    ended: bool,
}

/// The start of an element.
pub(crate) struct Element<'a> {
    pub(crate) name: &'a str,
    attributes: Vec<RawAttribute<'a>>,
    /// The start tag.
    pub(crate) span: Span,
}

/// An attribute as written, entities in place.
struct RawAttribute<'a> {
    key: &'a str,
    value: &'a str,
    key_start: u32,
    value_start: u32,
}

impl RawAttribute<'_> {
    fn key(&self, source: SourceId) -> Name {
        Name::new(self.key, Span::new(source, self.key_start, self.key_start + self.key.len() as u32))
    }

    fn value(&self, source: SourceId) -> Text {
        let span = Span::new(source, self.value_start, self.value_start + self.value.len() as u32);
        Text { text: unescape(self.value).as_ref().into(), span }
    }
}

/// The text of an element.
pub(crate) struct Content<'a> {
    pub(crate) text: Cow<'a, str>,
    /// Where it stands, without blanks around it.
    pub(crate) span: Span,
    /// Where its bytes stand, when it is not one piece of the file.
    map: Option<OriginMap>,
}

impl Content<'_> {
    pub(crate) fn excerpt(&self) -> Excerpt<'_> {
        Excerpt { text: &self.text, source: self.span.source, start: self.span.start, map: self.map.as_ref() }
    }

    /// For people: with the line ends of XML.
    pub(crate) fn into_text(self) -> Text {
        let text: CompactString =
            if self.text.contains('\r') { self.text.replace("\r\n", "\n").into() } else { self.text.into() };
        Text { text, span: self.span }
    }
}

impl<'a> Element<'a> {
    fn raw(&self, key: &str) -> Option<&RawAttribute<'a>> {
        self.attributes.iter().find(|attribute| attribute.key == key)
    }

    /// The value of an attribute.
    pub(crate) fn get(&self, key: &str) -> Option<Text> {
        self.raw(key).map(|raw| raw.value(self.span.source))
    }

    /// The value of an attribute as a name; empty when it is missing.
    pub(crate) fn name_of(&self, key: &str) -> Name {
        self.optional_name(key).unwrap_or_else(|| Name::new("", self.span))
    }

    /// The value of an attribute as a name; nothing when it is missing or empty.
    pub(crate) fn optional_name(&self, key: &str) -> Option<Name> {
        self.get(key).filter(|text| !text.text.is_empty()).map(|text| Name { text: text.text, span: text.span })
    }

    /// All attributes but some.
    pub(crate) fn attributes_without(&self, without: &[&str]) -> Vec<Attribute> {
        let mut list = Vec::with_capacity(self.attributes.len());
        list.extend(self.attributes.iter().filter(|raw| !without.contains(&raw.key)).map(|raw| Attribute {
            key: raw.key(self.span.source),
            value: AttributeValue::Quoted(raw.value(self.span.source)),
        }));
        list
    }

    /// All attributes but some, to be taken by name.
    pub(crate) fn fields<'e>(&self, without: &[&str], errors: &'e mut Errors) -> Fields<'e> {
        Fields::new(self.attributes_without(without), errors)
    }
}

/// Entities and line ends of an attribute's value. An entity that does not exist stays as written.
fn unescape(value: &str) -> Cow<'_, str> {
    let value = if value.contains(['\n', '\r', '\t']) {
        Cow::Owned(value.replace("\r\n", " ").replace(['\n', '\r', '\t'], " "))
    } else {
        Cow::Borrowed(value)
    };
    if !value.contains('&') {
        return value;
    }
    match quick_xml::escape::unescape(&value) {
        Ok(text) => Cow::Owned(text.into_owned()),
        Err(_) => Cow::Owned(value.into_owned()),
    }
}

impl<'a> Xml<'a> {
    pub(crate) fn new(source: SourceId, text: &'a str) -> Xml<'a> {
        let without_mark = text.trim_start_matches('\u{feff}');
        let mut reader = quick_xml::Reader::from_str(without_mark);
        reader.config_mut().expand_empty_elements = true;
        Xml { reader, text, source, errors: Errors::default(), budget: Budget::default(), depth: 0, ended: false }
    }

    /// Where a piece of the file's text begins in it.
    fn offset(&self, piece: &[u8]) -> usize {
        (piece.as_ptr() as usize).saturating_sub(self.text.as_ptr() as usize).min(self.text.len())
    }

    fn span(&self, start: usize, end: usize) -> Span {
        Span::new(self.source, start as u32, end as u32)
    }

    /// The piece of the file that some bytes of it are, and where it begins.
    fn piece(&self, bytes: &[u8]) -> (&'a str, usize) {
        let start = self.offset(bytes);
        (self.text.get(start..start + bytes.len()).unwrap_or(""), start)
    }

    fn position(&self) -> usize {
        let mark = self.text.len() - self.text.trim_start_matches('\u{feff}').len();
        (self.reader.buffer_position() as usize + mark).min(self.text.len())
    }

    fn stop(&mut self, message: String) {
        if !self.ended {
            let at = self.position();
            let start = self.text.floor_char_boundary(at.saturating_sub(1));
            self.errors.add(ErrorKind::MalformedXml, self.span(start, at), message);
        }
        self.ended = true;
    }

    fn event(&mut self) -> Option<Event<'a>> {
        if self.ended {
            return None;
        }
        match self.reader.read_event() {
            Ok(Event::Eof) => {
                if self.depth > 0 {
                    self.stop("the file breaks off: an element is not closed".to_string());
                }
                self.ended = true;
                None
            }
            Ok(Event::DocType(_)) => {
                self.stop("a document type; an L5X has none".to_string());
                None
            }
            Ok(event) => {
                match &event {
                    Event::Start(_) => self.depth += 1,
                    Event::End(_) => self.depth = self.depth.saturating_sub(1),
                    _ => {}
                }
                Some(event)
            }
            Err(error) => {
                self.stop(format!("no well-formed XML: {error}"));
                None
            }
        }
    }

    /// The next child of the element last started and not ended; at its end, nothing.
    pub(crate) fn child(&mut self) -> Option<Element<'a>> {
        loop {
            match self.event()? {
                Event::Start(start) if self.depth > XML_DEPTH_MAX => {
                    let (_, at) = self.piece(&start);
                    let message = format!("elements nested deeper than {XML_DEPTH_MAX}");
                    self.errors.add(ErrorKind::TooDeep, self.span(at, at + start.len()), message);
                    self.skip();
                }
                Event::Start(start) => return Some(self.element(&start)),
                Event::End(_) => return None,
                _ => {}
            }
        }
    }

    /// Goes on after the end of the element last started.
    pub(crate) fn skip(&mut self) {
        let outside = self.depth.saturating_sub(1);
        while self.depth > outside && self.event().is_some() {}
    }

    /// Counts what a piece of tree takes; when nothing is left, the file ends here.
    fn spend(&mut self, bytes: usize, place: Span) {
        if let Err(error) = self.budget.spend(bytes, place)
            && !self.ended
        {
            self.errors.push(error);
            self.ended = true;
        }
    }

    fn element(&mut self, start: &BytesStart<'_>) -> Element<'a> {
        let (tag, at) = self.piece(start);
        let span = self.span(at.saturating_sub(1), at + tag.len());
        self.spend(ELEMENT_BYTES + tag.len() * 2, span);
        let (name, _) = self.piece(start.name().into_inner());
        // Most elements have fewer.
        let mut attributes: Vec<RawAttribute<'a>> = Vec::with_capacity(8);
        for attribute in start.attributes().with_checks(false) {
            let attribute = match attribute {
                Ok(attribute) => attribute,
                Err(error) => {
                    self.errors.add(ErrorKind::MalformedXml, span, format!("no well-formed attribute: {error}"));
                    continue;
                }
            };
            let (key, key_start) = self.piece(attribute.key.into_inner());
            let (value, value_start) = self.piece(&attribute.value);
            if attributes.len() >= XML_ATTRIBUTES_MAX {
                let message = format!("an element with more than {XML_ATTRIBUTES_MAX} attributes");
                self.errors.add(ErrorKind::TooMany, self.span(key_start, key_start + key.len()), message);
                break;
            }
            if attributes.iter().any(|other| other.key == key) {
                let place = self.span(key_start, key_start + key.len());
                self.errors.add(ErrorKind::MalformedXml, place, format!("`{key}` is set twice"));
                continue;
            }
            let (key_start, value_start) = (key_start as u32, value_start as u32);
            attributes.push(RawAttribute { key, value, key_start, value_start });
        }
        Element { name, attributes, span }
    }

    /// The text of the element last started, to its end. Of texts in several languages, the first.
    pub(crate) fn content(&mut self) -> Content<'a> {
        let outside = self.depth.saturating_sub(1);
        let mut pieces = Pieces::default();
        let mut children = 0;
        while let Some(event) = self.event() {
            if self.depth <= outside {
                break;
            }
            match event {
                Event::Start(_) => children += 1,
                _ if children > 1 => {}
                Event::Text(text) => pieces.text(self.piece(&text)),
                Event::CData(text) => pieces.literal(self.piece(&text)),
                Event::GeneralRef(entity) => {
                    let (name, start) = self.piece(&entity);
                    match resolve(name) {
                        Some(character) => pieces.entity(character, start.saturating_sub(1)),
                        None => {
                            let place = self.span(start.saturating_sub(1), start + name.len());
                            self.errors.add(ErrorKind::MalformedXml, place, format!("no entity is called `{name}`"));
                        }
                    }
                }
                _ => {}
            }
        }
        let end = self.position();
        let content = pieces.joined(self.source, end);
        self.spend(content.text.len() * BYTES_FOR_EACH, content.span);
        content
    }
}

/// The character of `&lt;`, `&#10;`, `&#xA;`.
fn resolve(name: &str) -> Option<char> {
    let code = match name {
        "lt" => return Some('<'),
        "gt" => return Some('>'),
        "amp" => return Some('&'),
        "quot" => return Some('"'),
        "apos" => return Some('\''),
        _ => name.strip_prefix('#')?,
    };
    let code = match code.strip_prefix('x') {
        Some(digits) => u32::from_str_radix(digits, 16).ok()?,
        None => code.parse().ok()?,
    };
    char::from_u32(code)
}

/// The pieces that the text of an element consists of.
#[derive(Default)]
struct Pieces<'a> {
    list: Vec<(Cow<'a, str>, usize)>,
    /// There is a CDATA section: blanks around it are the XML's layout.
    literal: bool,
}

impl<'a> Pieces<'a> {
    fn text(&mut self, (text, start): (&'a str, usize)) {
        // Blanks between a tag and a CDATA section are the XML's layout.
        if !(text.trim().is_empty() && (self.literal || self.list.is_empty())) {
            self.list.push((Cow::Borrowed(text), start));
        }
    }

    fn literal(&mut self, (text, start): (&'a str, usize)) {
        self.literal = true;
        self.list.push((Cow::Borrowed(text), start));
    }

    fn entity(&mut self, character: char, start: usize) {
        self.list.push((Cow::Owned(character.to_string()), start));
    }

    fn joined(mut self, source: SourceId, end: usize) -> Content<'a> {
        let span = |start: usize, end: usize| Span::new(source, start as u32, end as u32);
        match self.list.as_slice() {
            [] => Content { text: Cow::Borrowed(""), span: span(end, end), map: None },
            [(Cow::Borrowed(text), start)] => {
                let trimmed = if self.literal { text } else { text.trim() };
                let start = start + (trimmed.as_ptr() as usize - text.as_ptr() as usize);
                Content { text: Cow::Borrowed(trimmed), span: span(start, start + trimmed.len()), map: None }
            }
            _ => {
                let mut text = String::new();
                let mut map = Vec::new();
                for (piece, start) in self.list.drain(..) {
                    map.push((text.len() as u32, start as u32));
                    text.push_str(&piece);
                }
                let map = OriginMap::new(map);
                let span = span(map.locate(0) as usize, map.locate_end(text.len()) as usize);
                Content { text: Cow::Owned(text), span, map: Some(map) }
            }
        }
    }
}
