//! Trees as a generator makes them: canonical in text, so that reading gives them back.

use proptest::collection::vec;
use proptest::option;
use proptest::prelude::*;
use twinrung_grammar::tree::*;

fn at() -> Span {
    Span::default()
}

fn spanned<T>(value: T) -> Spanned<T> {
    Spanned::new(value, at())
}

fn name() -> impl Strategy<Value = Name> {
    "[A-Z][a-z]{2,6}(_[0-9]{1,2})?".prop_map(|text| Name::new(text, at()))
}

fn text() -> impl Strategy<Value = Text> {
    r#"[a-zA-Z0-9 $'"/()*;:,\n\t\u{e4}]{1,20}"#.prop_map(|text| Text::new(text, at()))
}

fn description() -> impl Strategy<Value = Option<Box<Text>>> {
    option::weighted(0.2, text().prop_map(Box::new))
}

fn word() -> impl Strategy<Value = Text> {
    "[A-Z][A-Za-z0-9]{1,6}".prop_map(|text| Text::new(text, at()))
}

fn flag() -> impl Strategy<Value = Option<Spanned<bool>>> {
    option::weighted(0.2, any::<bool>().prop_map(spanned))
}

fn number() -> impl Strategy<Value = Option<Spanned<u32>>> {
    option::weighted(0.3, any::<u32>().prop_map(spanned))
}

fn time() -> impl Strategy<Value = Option<Spanned<u64>>> {
    option::weighted(0.5, (0u64..10_000_000).prop_map(spanned))
}

fn class() -> impl Strategy<Value = Option<Spanned<Class>>> {
    option::of(prop_oneof![Just(Class::Safety), Just(Class::Standard)].prop_map(spanned))
}

fn access() -> impl Strategy<Value = Option<Spanned<ExternalAccess>>> {
    let access =
        prop_oneof![Just(ExternalAccess::ReadWrite), Just(ExternalAccess::ReadOnly), Just(ExternalAccess::None)];
    option::weighted(0.2, access.prop_map(spanned))
}

fn attributes() -> impl Strategy<Value = Vec<Attribute>> {
    let value = prop_oneof![
        word().prop_map(AttributeValue::Words),
        Just(AttributeValue::Words(Text::new("BCC Error", at()))),
        Just(AttributeValue::Words(Text::new("16#00ff_01", at()))),
        text().prop_map(AttributeValue::Quoted),
        vec(scalar(), 0..3).prop_map(|items| AttributeValue::List(Value::List { items, span: at() })),
    ];
    // Keys that no component has a field for, each once.
    vec(value, 0..3).prop_map(|values| {
        let keyed = |(index, value)| Attribute { key: Name::new(format!("Extra{index}"), at()), value };
        values.into_iter().enumerate().map(keyed).collect()
    })
}

fn trivia() -> impl Strategy<Value = Trivia> {
    let comment = prop_oneof!["// [a-z;:']{0,8}", r"\(\* [a-z;:'/\n]{0,8}x \*\)"];
    let leading = vec(comment.clone(), 0..2);
    let inline = option::weighted(0.2, r"\(\* [a-z;]{1,5} \*\)");
    let last = option::weighted(0.2, "// [a-z;]{1,5}");
    option::weighted(0.2, (leading, inline, last)).prop_map(|comments| {
        let mut trivia = Trivia::none();
        let (leading, inline, last) = comments.unwrap_or_default();
        leading.into_iter().for_each(|line| trivia.push_leading(line.trim_end()));
        inline.into_iter().chain(last).for_each(|line| trivia.push_trailing(line.trim_end()));
        trivia
    })
}

/// Trivia of a block: also before its end.
fn block_trivia() -> impl Strategy<Value = Trivia> {
    (trivia(), option::weighted(0.1, "// [a-z]{1,5}")).prop_map(|(mut trivia, closing)| {
        closing.into_iter().for_each(|line| trivia.push_closing(line));
        trivia
    })
}

fn dimensions() -> impl Strategy<Value = Dimensions> {
    prop_oneof![4 => Just(vec![]), 1 => vec(1u32..100, 1..=3)].prop_map(|sizes| Dimensions::new(&sizes).unwrap())
}

fn scalar() -> impl Strategy<Value = Value> {
    let number = prop_oneof!["-?[0-9]{1,9}", "16#[0-9a-f]{1,8}", "-?[0-9]{1,3}\\.[0-9]{1,4}e[-+][0-9]{2}"];
    prop_oneof![
        4 => number.prop_map(|text| Value::Number(Text::new(text, at()))),
        1 => "([a-z ,;\\]]|\\$[0-9A-F]{2}){0,6}".prop_map(|text| Value::String(Text::new(text, at()))),
    ]
}

fn value() -> impl Strategy<Value = Value> {
    scalar().prop_recursive(3, 12, 4, |inner| vec(inner, 0..4).prop_map(|items| Value::List { items, span: at() }))
}

fn data() -> impl Strategy<Value = Vec<Data>> {
    option::weighted(0.4, value().prop_map(|value| Data { form: DataForm::L5k, value }))
        .prop_map(|data| data.into_iter().collect())
}

fn operand() -> impl Strategy<Value = Operand> {
    prop_oneof![
        6 => "[A-Z][a-z]{1,5}(:[0-9]:I)?(\\.[A-Z][a-z]{1,3})?(\\.[0-9])?",
        1 => Just("EQUIVALENT - ACTIVE HIGH".to_string()),
        1 => Just("E-STOP".to_string()),
        1 => Just("Arr[Idx+1,2].Member[3]".to_string()),
        1 => Just("(a+1)*b>16#0f".to_string()),
        1 => Just("'te;x,t$''".to_string()),
        1 => Just("?".to_string()),
        1 => Just(String::new()),
    ]
    .prop_map(|text| Operand { text: text.into(), span: at(), origin: None })
}

fn target() -> impl Strategy<Value = Operand> {
    "[A-Z][a-z]{1,5}(:[0-9]:I)?(\\[[0-9]\\])?(\\.[A-Z][a-z]{1,3})?(\\.[0-9])?".prop_map(|text| Operand {
        text: text.into(),
        span: at(),
        origin: None,
    })
}

fn element() -> impl Strategy<Value = Element> {
    let operands = prop_oneof![
        1 => Just(Vec::new()),
        6 => vec(operand(), 1..4).prop_filter("one empty operand is none", |list| {
            list.len() > 1 || !list[0].text.is_empty()
        }),
    ];
    let instruction = ("[A-Z]{2,4}", operands).prop_map(|(mnemonic, operands)| {
        Element::Instruction(Instruction { mnemonic: Name::new(mnemonic, at()), operands, span: at() })
    });
    instruction.prop_recursive(4, 20, 3, |inner| {
        let leg = vec(inner, 0..3).prop_map(|elements| Leg { elements, span: at() });
        vec(leg, 1..4).prop_map(|legs| Element::Branch(Branch { legs, span: at() }))
    })
}

fn rung() -> impl Strategy<Value = Rung> {
    let kind = prop_oneof![9 => Just(RungKind::Normal), 1 => Just(RungKind::PendingReplaceOfInsert)];
    (kind, description(), vec(element(), 0..5), trivia()).prop_map(|(kind, comment, elements, trivia)| Rung {
        number: None,
        kind: spanned(kind),
        comment,
        elements,
        broken: false,
        trivia,
        span: at(),
    })
}

fn routine() -> impl Strategy<Value = Routine> {
    let ladder = vec(rung(), 0..4).prop_map(RoutineBody::Ladder);
    let island = ("'[a-z;]{1,8}", prop_oneof![Just("ST"), Just("FBD"), Just("SFC")]).prop_map(|(text, language)| {
        RoutineBody::Island { language: Name::new(language, at()), text: Text::new(text, at()) }
    });
    let encoded = "[a-z+/]{4}".prop_map(|text| RoutineBody::Encoded { text: Text::new(text, at()) });
    let body = prop_oneof![8 => ladder, 1 => island, 1 => encoded];
    (name(), body, description(), attributes(), block_trivia()).prop_map(
        |(name, body, description, attributes, trivia)| {
            // Inside an island there are no comments.
            let plain = matches!(body, RoutineBody::Ladder(_));
            let trivia = if plain { trivia } else { Trivia::none() };
            Routine { name, usage: Usage::Target, body, description, attributes, trivia, span: at() }
        },
    )
}

fn tag_kind() -> impl Strategy<Value = TagKind> {
    let produced =
        (number(), time(), time(), flag(), flag()).prop_map(|(count, rpi_us, rpi_min_us, status, unicast)| {
            TagKind::Produced(Box::new(ProduceInfo {
                count,
                rpi_us,
                rpi_min_us,
                rpi_max_us: None,
                connection_status: status,
                unicast,
            }))
        });
    let consumed = (option::of(name()), option::of(word()), time(), number(), time(), flag()).prop_map(
        |(producer, remote_tag, rpi_us, timeout_multiplier, reaction_time_limit_us, unicast)| {
            TagKind::Consumed(Box::new(ConsumeInfo {
                producer,
                remote_tag,
                rpi_us,
                timeout_multiplier,
                network_delay_multiplier: None,
                reaction_time_limit_us,
                connection_status: None,
                unicast,
            }))
        },
    );
    prop_oneof![
        6 => Just(TagKind::Base),
        1 => target().prop_map(|target| TagKind::Alias(Box::new(target))),
        1 => produced,
        1 => consumed,
    ]
}

fn tag() -> impl Strategy<Value = Tag> {
    let type_name = prop_oneof!["[A-Z]{3,6}", Just("AB:1756_DI:I:0".to_string())];
    let first = (name(), tag_kind(), type_name, dimensions(), class(), data(), data(), description());
    let usage = prop_oneof![Just(TagUsage::Input), Just(TagUsage::Public), Just(TagUsage::Local)].prop_map(spanned);
    let comment = ("(\\.[0-9]|\\[[0-9]\\]\\.[A-Z][a-z]{1,4})", text());
    let comments = vec(comment, 0..2).prop_map(|list| {
        let comment = |(about, text)| OperandComment { operand: Text::new(about, at()), text };
        list.into_iter().map(comment).collect::<Vec<_>>()
    });
    let second = (
        option::weighted(0.2, usage),
        flag(),
        access(),
        option::weighted(0.2, name()),
        option::weighted(0.2, name()),
        number(),
        comments,
        attributes(),
        trivia(),
    );
    (first, second).prop_map(|(first, second)| {
        let (name, kind, type_name, dimensions, class, data, forces, description) = first;
        let (parameter, constant, external_access, radix, mapped_from, sil, comments, attributes, trivia) = second;
        let alias = matches!(kind, TagKind::Alias(_));
        Tag {
            name,
            usage: Usage::Target,
            data_type: (!alias).then(|| Name::new(type_name, at())),
            dimensions: if alias { Dimensions::default() } else { dimensions },
            kind,
            class,
            parameter,
            constant,
            external_access,
            radix,
            mapped_from,
            sil,
            data: if alias { Vec::new() } else { data },
            forces: if alias { Vec::new() } else { forces },
            description,
            comments,
            attributes,
            joins_previous: false,
            trivia,
            span: at(),
        }
    })
}

fn data_type() -> impl Strategy<Value = DataType> {
    let bit = option::weighted(0.3, (name(), 0u32..8))
        .prop_map(|bit| bit.map(|(target, number)| Box::new(BitPlace { target, number: spanned(number) })));
    let member =
        (name(), "[A-Z]{3,6}", dimensions(), any::<bool>(), bit, access(), description(), attributes(), trivia());
    let member = member.prop_map(
        |(name, data_type, dimensions, hidden, bit, external_access, description, attributes, trivia)| Member {
            name,
            data_type: Name::new(if bit.is_some() { "BIT".to_string() } else { data_type }, at()),
            dimensions: if bit.is_some() { Dimensions::default() } else { dimensions },
            hidden,
            bit,
            radix: None,
            external_access,
            description,
            attributes,
            trivia,
            span: at(),
        },
    );
    (name(), any::<bool>(), vec(member, 0..4), description(), attributes(), block_trivia()).prop_map(
        |(name, is_string, members, description, attributes, trivia)| DataType {
            name,
            usage: Usage::Target,
            is_string,
            type_class: None,
            members,
            description,
            attributes,
            trivia,
            span: at(),
        },
    )
}

fn add_on() -> impl Strategy<Value = AddOnInstruction> {
    let usage = prop_oneof![Just(ParameterUsage::Input), Just(ParameterUsage::Output), Just(ParameterUsage::InOut)];
    let alias = option::weighted(0.1, target().prop_map(Box::new));
    let parameter = (name(), usage, "[A-Z]{3,5}", dimensions(), alias, flag(), data(), description(), trivia());
    let parameter = parameter.prop_map(
        |(name, usage, data_type, dimensions, alias_for, required, default, description, trivia)| Parameter {
            name,
            usage: Some(spanned(usage)),
            data_type: alias_for.is_none().then(|| Name::new(data_type, at())),
            dimensions: if alias_for.is_some() { Dimensions::default() } else { dimensions },
            default: if alias_for.is_some() { Vec::new() } else { default },
            alias_for,
            required,
            visible: None,
            constant: None,
            radix: None,
            external_access: None,
            description,
            attributes: Vec::new(),
            trivia,
            span: at(),
        },
    );
    // What stands in an entry is kept as text: there are no comments in it.
    let entry = attributes().prop_map(|attributes| HistoryEntry {
        attributes,
        text: Text::default(),
        trivia: Trivia::none(),
        span: at(),
    });
    let lists = (vec(parameter, 0..3), vec(tag(), 0..2), vec(routine(), 0..2), vec(entry, 0..3));
    (name(), class(), option::of(text()), flag(), flag(), lists, description(), attributes(), block_trivia()).prop_map(
        |(name, class, revision, prescan, in_false, lists, description, attributes, trivia)| AddOnInstruction {
            name,
            usage: Usage::Target,
            class,
            revision,
            vendor: None,
            execute_prescan: prescan,
            execute_postscan: None,
            execute_enable_in_false: in_false,
            parameters: lists.0,
            local_tags: lists.1,
            routines: lists.2,
            history: lists.3,
            islands: Vec::new(),
            description,
            attributes,
            trivia,
            span: at(),
        },
    )
}

fn connection() -> impl Strategy<Value = Connection> {
    let tag = |suffix: &'static str| {
        let tag = (data(), data()).prop_filter("has data", |(data, forces)| !(data.is_empty() && forces.is_empty()));
        let tag = tag.prop_map(move |(data, forces)| {
            Box::new(ModuleTag {
                suffix: suffix.into(),
                data_type: None,
                data,
                forces,
                external_access: None,
                span: at(),
            })
        });
        option::weighted(0.3, tag)
    };
    (name(), option::of(word()), time(), number(), time(), tag("I"), tag("O"), attributes(), block_trivia()).prop_map(
        |(name, connection_type, rpi_us, timeout_multiplier, limit, input, output, attributes, trivia)| Connection {
            name,
            connection_type,
            rpi_us,
            timeout_multiplier,
            network_delay_multiplier: None,
            reaction_time_limit_us: limit,
            unicast: None,
            input,
            output,
            attributes,
            trivia,
            span: at(),
        },
    )
}

fn module() -> impl Strategy<Value = Module> {
    let kind = prop_oneof![Just(PointKind::Point), Just(PointKind::Test)];
    let point = (kind, "[IOT][0-9]{1,2}", attributes(), trivia()).prop_map(|(kind, name, attributes, trivia)| Point {
        kind,
        name: Name::new(name, at()),
        attributes,
        trivia,
        span: at(),
    });
    let opaque = value().prop_map(|value| OpaqueData { kind: Name::new("ConfigData", at()), value, span: at() });
    let own = (name(), option::of(text()), number(), option::of(name()), number(), flag(), time());
    let network = option::of(Just(Text::new("16#0000_41b4_02bb_cb7e", at())));
    let lists = (vec(point, 0..3), vec(opaque, 0..2), vec(connection(), 0..2));
    (own, network, lists, description(), attributes(), block_trivia()).prop_map(
        |(
            (name, catalog_number, major, parent, slot, inhibited, rpi_us),
            network,
            lists,
            description,
            attributes,
            trivia,
        )| {
            Module {
                name,
                usage: Usage::Target,
                catalog_number,
                vendor: None,
                product_type: None,
                product_code: None,
                major,
                minor: None,
                parent,
                parent_port: None,
                slot,
                address: None,
                safety_network: network,
                safety_enabled: None,
                inhibited,
                rpi_us,
                electronic_key: None,
                points: lists.0,
                ports: Vec::new(),
                connections: lists.2,
                configuration: None,
                opaque: lists.1,
                description,
                attributes,
                trivia,
                span: at(),
            }
        },
    )
}

fn program() -> impl Strategy<Value = Program> {
    let lists = (vec(tag(), 0..3), vec(routine(), 0..3));
    (name(), class(), option::of(name()), flag(), lists, description(), attributes(), block_trivia()).prop_map(
        |(name, class, main_routine, disabled, (tags, routines), description, attributes, trivia)| Program {
            name,
            usage: Usage::Target,
            class,
            main_routine,
            fault_routine: None,
            disabled,
            test_edits: None,
            use_as_folder: None,
            tags,
            routines,
            encoded: Vec::new(),
            islands: Vec::new(),
            description,
            attributes,
            trivia,
            span: at(),
        },
    )
}

fn task() -> impl Strategy<Value = Task> {
    (name(), class(), time(), number(), time(), vec(name(), 0..3), attributes(), block_trivia()).prop_map(
        |(name, class, rate_us, priority, watchdog_us, programs, attributes, trivia)| Task {
            name,
            task_type: Some(Name::new("PERIODIC", at())),
            class,
            rate_us,
            priority,
            watchdog_us,
            disable_update_outputs: None,
            inhibited: None,
            programs,
            description: None,
            attributes,
            trivia,
            span: at(),
        },
    )
}

fn controller() -> impl Strategy<Value = Controller> {
    let entry = (name(), name()).prop_map(|(standard, safety)| MapEntry { standard, safety, span: at() });
    let safety = (flag(), option::of(text()), vec(entry, 0..3)).prop_map(|(locked, signature, tag_map)| {
        let safety = SafetyInfo { locked, signature, tag_map, ..SafetyInfo::default() };
        // Nothing set is nothing written.
        (safety != SafetyInfo::default()).then(|| Box::new(safety))
    });
    (name(), option::of(text()), number(), safety, description(), attributes(), block_trivia()).prop_map(
        |(name, processor_type, major, safety, description, attributes, trivia)| Controller {
            name,
            usage: Usage::Target,
            processor_type,
            major,
            minor: None,
            safety_network: None,
            safety,
            description,
            attributes,
            trivia,
            span: at(),
        },
    )
}

/// A whole file, with a controller or without.
pub fn file() -> impl Strategy<Value = File> {
    let island = name().prop_map(|name| Island {
        kind: Name::new("TREND", at()),
        text: Text::new(format!("TREND {name} (a := 1) PEN END_PEN END_TREND"), at()),
        name: Some(name),
        trivia: Trivia::none(),
        span: at(),
    });
    let lists = (
        vec(data_type(), 0..2),
        vec(module(), 0..2),
        vec(add_on(), 0..2),
        vec(tag(), 0..4),
        vec(program(), 0..2),
        vec(routine(), 0..2),
        vec(task(), 0..2),
        vec(island, 0..2),
    );
    (option::of(controller()), lists)
        .prop_map(|(controller, lists)| File {
            sources: vec![SourceId(0)],
            controller: controller.map(Box::new),
            data_types: lists.0,
            modules: lists.1,
            add_on_instructions: lists.2,
            tags: lists.3,
            programs: lists.4,
            routines: lists
                .5
                .into_iter()
                .filter(|routine| !matches!(routine.body, RoutineBody::Encoded { .. }))
                .collect(),
            tasks: lists.6,
            islands: lists.7,
            ..File::default()
        })
        .prop_filter("declares something", |file| *file != File { sources: vec![SourceId(0)], ..File::default() })
}

/// An expression as the reader makes it.
pub fn expression() -> impl Strategy<Value = Expression> {
    let immediate = prop_oneof![
        (any::<bool>(), 0u64..100_000).prop_map(|(negative, magnitude)| {
            let text = format!("{}{magnitude}", if negative { "-" } else { "" });
            (Number::Integer { negative, magnitude, radix: Radix::Decimal }, text)
        }),
        (0u64..0xFFFF).prop_map(|magnitude| {
            (Number::Integer { negative: false, magnitude, radix: Radix::Hexadecimal }, format!("16#{magnitude:x}"))
        }),
        (0u32..1000).prop_map(|value| (Number::Real { bits: (value as f32).to_bits() }, format!("{value}.0"))),
    ];
    let leaf = prop_oneof![
        immediate.prop_map(|(number, text)| Expression::Immediate(Immediate { number, text: text.into(), span: at() })),
        name().prop_map(|base| Expression::Tag(TagReference { program: None, base, parts: Vec::new(), span: at() })),
    ];
    leaf.prop_recursive(5, 40, 3, |inner| {
        let operator = prop_oneof![
            Just(BinaryOperator::Power),
            Just(BinaryOperator::Multiply),
            Just(BinaryOperator::Divide),
            Just(BinaryOperator::Modulo),
            Just(BinaryOperator::Less),
            Just(BinaryOperator::GreaterOrEqual),
            Just(BinaryOperator::Equal),
            Just(BinaryOperator::NotEqual),
            Just(BinaryOperator::Subtract),
            Just(BinaryOperator::Add),
            Just(BinaryOperator::And),
            Just(BinaryOperator::Xor),
            Just(BinaryOperator::Or),
        ];
        let binary = (operator, inner.clone(), inner.clone()).prop_map(|(operator, left, right)| Expression::Binary {
            operator,
            left: Box::new(left),
            right: Box::new(right),
            span: at(),
        });
        let not = inner.clone().prop_map(|operand| Expression::Unary {
            operator: UnaryOperator::Not,
            operand: Box::new(operand),
            span: at(),
        });
        // The negation of a plain number is a negative number.
        let negate =
            inner.clone().prop_filter("not a number", |operand| !matches!(operand, Expression::Immediate(_))).prop_map(
                |operand| Expression::Unary { operator: UnaryOperator::Negate, operand: Box::new(operand), span: at() },
            );
        let call = (name(), vec(inner.clone(), 1..3)).prop_map(|(function, arguments)| Expression::Call {
            function,
            arguments,
            span: at(),
        });
        let part = prop_oneof![
            name().prop_map(Part::Member),
            vec(inner.clone(), 1..=3).prop_map(|subscripts| Part::Subscripts { subscripts, span: at() }),
            inner.prop_map(|index| Part::BitSubscript { index: Box::new(index), span: at() }),
        ];
        let bit = option::weighted(0.3, (0u32..32).prop_map(|number| Part::Bit { number, span: at() }));
        let tag =
            (option::weighted(0.1, name()), name(), vec(part, 0..3), bit).prop_map(|(program, base, parts, bit)| {
                Expression::Tag(TagReference {
                    program,
                    base,
                    parts: parts.into_iter().chain(bit).collect(),
                    span: at(),
                })
            });
        prop_oneof![4 => binary, 1 => not, 1 => negate, 1 => call, 2 => tag]
    })
}
