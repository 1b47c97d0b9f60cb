//! `MODULE`, with its points, test outputs, connections and what nobody can read.

use super::build::{Head, Property};
use super::{Next, Reader, declaration};
use crate::components;
use crate::fields::Fields;
use crate::tree::{Connection, Data, DataForm, Module, ModuleTag, OpaqueData, Point, PointKind, Span, Value};

impl Reader<'_> {
    pub(super) fn module(&mut self) {
        let (head, span, trivia) = self.head("END_MODULE");
        let mut module = components::module(head.name, Fields::new(head.attributes, &mut self.cursor.errors), span);
        module.trivia = trivia;
        while let Next::Word(word) = self.next_in_block(span) {
            match word {
                "POINT" => module.points.extend(self.point(PointKind::Point)),
                "TEST" => module.points.extend(self.point(PointKind::Test)),
                "CONNECTION" => {
                    let connection = self.connection();
                    module.connections.push(connection);
                }
                _ => self.module_property(&mut module),
            }
        }
        let end = self.close(&mut module.trivia);
        module.span = span.to(end);
        self.file.modules.push(module);
    }

    /// `POINT I00 (Mode := SAFETY, TestSource := T0);`
    fn point(&mut self, kind: PointKind) -> Option<Point> {
        let mut trivia = self.cursor.leading();
        self.cursor.next();
        let (Head { name, attributes }, span) = self
            .statement("a point such as `I00 (Mode := SAFETY)`", |file, run| {
                declaration::HeadParser::new().parse(file, run.iter().copied())
            })?;
        self.cursor.trailing(&mut trivia);
        Some(Point { kind, name, attributes, trivia, span })
    }

    fn property(&mut self) -> Option<(Property, Span)> {
        self.statement("`POINT`, `TEST`, `CONNECTION` or a property such as `ConfigData := [...]`", |file, run| {
            declaration::PropertyParser::new().parse(file, run.iter().copied())
        })
    }

    fn module_property(&mut self, module: &mut Module) {
        let Some((property, span)) = self.property() else { return };
        let value = property.value.unwrap_or(Value::List { items: Vec::new(), span });
        module.opaque.push(OpaqueData { kind: property.name, value, span });
    }

    fn connection(&mut self) -> Connection {
        let (head, span, trivia) = self.head("END_CONNECTION");
        let fields = Fields::new(head.attributes, &mut self.cursor.errors);
        let mut connection = components::connection(head.name, fields, span, true);
        connection.trivia = trivia;
        while let Next::Word(_) = self.next_in_block(span) {
            let Some((property, span)) = self.property() else { continue };
            let value = property.value.unwrap_or(Value::List { items: Vec::new(), span });
            let data = Data { form: DataForm::L5k, value };
            // Safety connections name their tags `InputData`, too.
            let name = property.name;
            if name.is("InputData") {
                module_tag(&mut connection.input, "I", span).data.push(data);
            } else if name.is("InputForceData") {
                module_tag(&mut connection.input, "I", span).forces.push(data);
            } else if name.is("OutputData") {
                module_tag(&mut connection.output, "O", span).data.push(data);
            } else if name.is("OutputForceData") {
                module_tag(&mut connection.output, "O", span).forces.push(data);
            }
        }
        let end = self.close(&mut connection.trivia);
        connection.span = span.to(end);
        connection
    }
}

fn module_tag<'t>(tag: &'t mut Option<Box<ModuleTag>>, suffix: &str, span: Span) -> &'t mut ModuleTag {
    tag.get_or_insert_with(|| {
        Box::new(ModuleTag {
            suffix: suffix.into(),
            data_type: None,
            data: Vec::new(),
            forces: Vec::new(),
            external_access: None,
            span,
        })
    })
}
