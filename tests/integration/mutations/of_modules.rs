//! Broken modules: points, networks, connections.

use super::Mutation;

/// Each with the rule that refuses it.
pub(super) static ALL: &[Mutation] = &[
    Mutation {
        sample: "estop-with-contactors",
        what: "a delay between two steps",
        changes: &[("POINT I02 (Mode := SAFETY);", "POINT I02 (Mode := SAFETY, OffOn := 7);")],
        code: "S0403",
    },
    Mutation {
        sample: "estop-with-contactors",
        what: "a point that the module does not have",
        changes: &[("POINT I05 (Mode := SAFETY);", "POINT I08 (Mode := SAFETY);")],
        code: "S0403",
    },
    Mutation {
        sample: "estop-with-contactors",
        what: "a pulse-tested input without test source",
        changes: &[(
            "POINT I00 (Mode := SAFETY_PULSE_TEST, TestSource := T0);",
            "POINT I00 (Mode := SAFETY_PULSE_TEST);",
        )],
        code: "S0404",
    },
    Mutation {
        sample: "estop-with-contactors",
        what: "a test source that does not pulse",
        changes: &[("TestSource := T1);", "TestSource := T3);")],
        code: "S0404",
    },
    Mutation {
        sample: "conveyor-muting-two-sensor",
        what: "a muting lamp on T2",
        changes: &[("TEST T1 (Mode := MUTING_LAMP)", "TEST T2 (Mode := MUTING_LAMP)")],
        code: "S0405",
    },
    Mutation {
        sample: "estop-with-contactors",
        what: "one output of a pair as single",
        changes: &[(
            "POINT O01 (Mode := SAFETY_PULSE_TEST, Channel := DUAL);",
            "POINT O01 (Mode := SAFETY_PULSE_TEST, Channel := SINGLE);",
        )],
        code: "S0406",
    },
    Mutation {
        sample: "estop-with-contactors",
        what: "a pair that module and instruction evaluate",
        changes: &[
            ("TestSource := T0);", "TestSource := T0, Type := EQUIVALENT);"),
            ("TestSource := T1);", "TestSource := T1, Type := EQUIVALENT);"),
        ],
        code: "S0407",
    },
    Mutation {
        sample: "estop-with-contactors",
        what: "a catalogue number that nobody knows",
        changes: &[(
            "  MODULE Field_Out",
            "  MODULE Further (CatalogNumber := \"1734-IB8X\", Parent := \"Rack\", Slot := 5, SafetyNetwork := 16#0000_41b4_02bb_cb7f) END_MODULE\n  MODULE Field_Out",
        )],
        code: "S0408",
    },
    Mutation {
        sample: "estop-with-contactors",
        what: "a connection choice that the module does not have",
        changes: &[(
            "  MODULE Field_Out",
            "  MODULE Further (CatalogNumber := \"1734-IB8S\", Parent := \"Rack\", Slot := 5, SafetyNetwork := 16#0000_41b4_02bb_cb7f, InputStatus := PT_STATES) END_MODULE\n  MODULE Field_Out",
        )],
        code: "S0401",
    },
    Mutation {
        sample: "estop-with-contactors",
        what: "a safety network number with a digit too few",
        changes: &[("cb7f, RPI", "cb7, RPI")],
        code: "S0409",
    },
    Mutation {
        sample: "estop-with-contactors",
        what: "a safety module without safety network number",
        changes: &[(", SafetyNetwork := 16#0000_41b4_02bb_cb7f, RPI", ", RPI")],
        code: "S0409",
    },
    Mutation {
        sample: "estop-with-contactors",
        what: "two modules in one slot",
        changes: &[("Slot := 2", "Slot := 1")],
        code: "S0410",
    },
    Mutation {
        sample: "estop-with-contactors",
        what: "a packet interval of 5 ms",
        changes: &[("RPI := 10", "RPI := 5")],
        code: "S0411",
    },
    Mutation {
        sample: "estop-with-contactors",
        what: "a packet interval of 501 ms",
        changes: &[("RPI := 10", "RPI := 501")],
        code: "S0411",
    },
    Mutation {
        sample: "estop-with-contactors",
        what: "a producer without safety network number",
        changes: &[
            (
                "  MODULE Rack",
                "  DATATYPE Link_T\n    CONNECTION_STATUS Status;\n    BOOL Stop;\n  END_DATATYPE\n  MODULE Other (CatalogNumber := \"1756-L73S\", Parent := \"Local\", Slot := 3) END_MODULE\n  MODULE Rack",
            ),
            (
                "Motor_Run    : BOOL (Class := Safety);",
                "Motor_Run    : BOOL (Class := Safety); Link : Link_T (Class := Safety, Producer := Other, RemoteTag := \"Link\", RPI := 20);",
            ),
        ],
        code: "S0413",
    },
    Mutation {
        sample: "estop-with-contactors",
        what: "a module with the number of the controller's chassis",
        changes: &[("cb7f, RPI", "cb7e, RPI")],
        code: "S0414",
    },
    Mutation {
        sample: "estop-with-contactors",
        what: "an output alone on a module that drives pairs",
        changes: &[(
            "  MODULE Field_Out",
            "  MODULE Further (CatalogNumber := \"1791DS-IB8XOB8\", Parent := \"Local\", IPAddress := \"192.168.1.90\", SafetyNetwork := 16#0000_41b4_02bb_cb70)\n    POINT O06 (Mode := SAFETY, Channel := SINGLE);\n    POINT O07 (Mode := SAFETY, Channel := SINGLE);\n  END_MODULE\n  MODULE Field_Out",
        )],
        code: "S0415",
    },
    Mutation {
        sample: "estop-with-contactors",
        what: "a muting lamp on T1 of a module that watches T3 and T7",
        changes: &[(
            "  MODULE Field_Out",
            "  MODULE Further (CatalogNumber := \"1732ES-IB8XOB8\", Parent := \"Local\", IPAddress := \"192.168.1.90\", SafetyNetwork := 16#0000_41b4_02bb_cb70)\n    TEST T1 (Mode := MUTING_LAMP);\n  END_MODULE\n  MODULE Field_Out",
        )],
        code: "S0405",
    },
    Mutation {
        sample: "estop-with-contactors",
        what: "a pulse-tested input of a module whose test outputs do not pulse by themselves",
        changes: &[(
            "  MODULE Field_Out",
            "  MODULE Further (CatalogNumber := \"1732ES-IB12XOB4\", Parent := \"Local\", IPAddress := \"192.168.1.90\", SafetyNetwork := 16#0000_41b4_02bb_cb70)\n    POINT I11 (Mode := SAFETY_PULSE_TEST, TestSource := T0);\n  END_MODULE\n  MODULE Field_Out",
        )],
        code: "S0404",
    },
    Mutation {
        sample: "estop-with-contactors",
        what: "a module of which no source tells the tags",
        changes: &[(
            "  MODULE Field_Out",
            "  MODULE Further (CatalogNumber := \"1791DS-IB4XOX4\", Parent := \"Local\", IPAddress := \"192.168.1.90\", SafetyNetwork := 16#0000_41b4_02bb_cb70) END_MODULE\n  MODULE Field_Out",
        )],
        code: "S0408",
    },
];
