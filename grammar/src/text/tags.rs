//! Blocks of tags, and parameters and local tags, which look like tags.

use super::build::TagDeclaration;
use super::{Next, Reader, declaration};
use crate::budget::BYTES_FOR_EACH;
use crate::components;
use crate::fields::Fields;
use crate::limits::{JOINED_BYTES_MAX, NAMES_MAX};
use crate::tree::{
    Attribute, AttributeValue, Data, DataForm, ErrorKind, OperandComment, Parameter, ReadError, Span, Tag, TagKind,
    Text, Trivia, Value,
};

/// What a tag without attributes takes in the tree.
const TAG_BYTES: usize = 500;

impl Reader<'_> {
    /// A block of tags; comments around the block itself go to the tags in it.
    pub(super) fn tags(&mut self, end: &'static str) -> Vec<Tag> {
        let block = self.block_without_name(end);
        let mut tags: Vec<Tag> = Vec::new();
        while let Some((declaration, span, trivia)) = self.tag_declaration(block) {
            add_tags(self, declaration, span, trivia, &mut tags);
        }
        self.end_block_keeping_comments();
        tags
    }

    pub(super) fn parameters(&mut self) -> Vec<Parameter> {
        let block = self.block_without_name("END_PARAMETERS");
        let mut parameters = Vec::new();
        while let Some((declaration, span, trivia)) = self.tag_declaration(block) {
            let data = default_data(&declaration);
            let attributes = without_default(declaration.attributes);
            for (index, name) in declaration.names.into_iter().enumerate() {
                let fields = Fields::new(attributes.clone(), &mut self.cursor.errors);
                let mut parameter = components::parameter(name, fields, span);
                parameter.data_type.clone_from(&declaration.data_type);
                parameter.dimensions = declaration.dimensions;
                if let Some(target) = &declaration.target {
                    parameter.alias_for = Some(Box::new(target.clone()));
                }
                parameter.default.clone_from(&data);
                if index == 0 {
                    parameter.trivia = trivia.clone();
                }
                parameters.push(parameter);
            }
        }
        self.end_block_keeping_comments();
        parameters
    }

    /// Takes the word that begins a block without a head.
    fn block_without_name(&mut self, end: &'static str) -> Span {
        let span = self.cursor.next().map_or(Span::default(), |token| self.cursor.span(token));
        self.open.push(end);
        span
    }

    /// Takes the end of a block that is not in the tree: its comments go to what follows.
    fn end_block_keeping_comments(&mut self) {
        let end = self.open.pop().unwrap_or("");
        if self.cursor.peek_word() == Some(end) {
            self.cursor.next();
        }
    }

    /// Each of several names has a copy of what is declared: that has a limit.
    fn limit_names(&mut self, declaration: &mut TagDeclaration, span: Span) {
        let names = declaration.names.len();
        if names > NAMES_MAX || (names > 1 && span.len() as usize > JOINED_BYTES_MAX) {
            let message = format!(
                "{names} names in a declaration of {} bytes; at most {NAMES_MAX} names in {JOINED_BYTES_MAX} bytes",
                span.len()
            );
            let error = ReadError::new(ErrorKind::TooMany, span, message);
            self.cursor.errors.push(error.with_help("declare them one by one"));
            declaration.names.truncate(1);
        }
        self.cursor.spend(declaration.names.len() * (TAG_BYTES + span.len() as usize * BYTES_FOR_EACH), span);
    }

    fn tag_declaration(&mut self, block: Span) -> Option<(TagDeclaration, Span, Trivia)> {
        while let Next::Word(_) = self.next_in_block(block) {
            let mut trivia = self.cursor.leading();
            let parsed = self.statement("a tag declaration such as `Name : TYPE;`", |file, run| {
                declaration::TagParser::new().parse(file, run.iter().copied())
            });
            if let Some((mut declaration, span)) = parsed {
                self.limit_names(&mut declaration, span);
                self.cursor.trailing(&mut trivia);
                return Some((declaration, span, trivia));
            }
        }
        None
    }
}

fn add_tags(reader: &mut Reader<'_>, declaration: TagDeclaration, span: Span, trivia: Trivia, tags: &mut Vec<Tag>) {
    let data = default_data(&declaration);
    let forces: Vec<Data> = declaration.forces.iter().map(|value| l5k(value.clone())).collect();
    let mut attributes = without_default(declaration.attributes);
    let comments = operand_comments(&mut attributes);
    let names = declaration.names.len();
    for (index, name) in declaration.names.into_iter().enumerate() {
        let last = index + 1 == names;
        let own = if last { std::mem::take(&mut attributes) } else { attributes.clone() };
        let mut tag = components::tag(name, Fields::new(own, &mut reader.cursor.errors), span);
        tag.data_type.clone_from(&declaration.data_type);
        tag.dimensions = declaration.dimensions;
        if let Some(target) = &declaration.target {
            tag.kind = TagKind::Alias(Box::new(target.clone()));
        }
        tag.data.clone_from(&data);
        tag.forces.clone_from(&forces);
        tag.comments.clone_from(&comments);
        tag.joins_previous = index > 0;
        if index == 0 {
            tag.trivia = trivia.clone();
        }
        tags.push(tag);
    }
}

fn l5k(value: Value) -> Data {
    Data { form: DataForm::L5k, value }
}

/// The value after `:=`, or `DefaultData := "..."` of a parameter or local tag.
fn default_data(declaration: &TagDeclaration) -> Vec<Data> {
    if let Some(value) = &declaration.value {
        return vec![l5k(value.clone())];
    }
    let is_default = |attribute: &&Attribute| attribute.key.is("DefaultData");
    match declaration.attributes.iter().find(is_default).map(|attribute| &attribute.value) {
        Some(AttributeValue::List(value)) => vec![l5k(value.clone())],
        Some(AttributeValue::Quoted(text) | AttributeValue::Words(text)) => vec![l5k(quoted_value(text))],
        None => Vec::new(),
    }
}

/// L5K quotes default data: `"[0,5000,0]"`.
fn quoted_value(text: &Text) -> Value {
    let excerpt =
        crate::excerpt::Excerpt { text: &text.text, source: text.span.source, start: text.span.start, map: None };
    super::read_value(excerpt).unwrap_or_else(|_| Value::Number(text.clone()))
}

fn without_default(mut attributes: Vec<Attribute>) -> Vec<Attribute> {
    attributes.retain(|attribute| !attribute.key.is("DefaultData"));
    attributes
}

/// `COMMENT.0 := "..."`, `COMMENT[3].Speed := "..."`: comments on parts of the tag.
fn operand_comments(attributes: &mut Vec<Attribute>) -> Vec<OperandComment> {
    const KEY: &str = "COMMENT";
    let mut comments = Vec::new();
    attributes.retain(|attribute| {
        let key = &attribute.key.text;
        let about = key.get(KEY.len()..).filter(|rest| rest.starts_with(['.', '[']));
        let (Some(about), Some(text)) = (about, attribute.value.text()) else { return true };
        if !key[..KEY.len()].eq_ignore_ascii_case(KEY) {
            return true;
        }
        comments.push(OperandComment { operand: Text::new(about, attribute.key.span), text: text.clone() });
        false
    });
    comments
}
