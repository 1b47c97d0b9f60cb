//! Broken structure: tasks, programs, routines, rungs.

use super::Mutation;

/// Each with the rule that refuses it.
pub(super) static ALL: &[Mutation] = &[
    Mutation {
        sample: "estop-with-contactors",
        what: "a period of 501 ms",
        changes: &[("Rate := 20, Watchdog := 10", "Rate := 501, Watchdog := 10")],
        code: "S0502",
    },
    Mutation {
        sample: "estop-with-contactors",
        what: "a watchdog above the period",
        changes: &[("Watchdog := 10", "Watchdog := 21")],
        code: "S0503",
    },
    Mutation {
        sample: "estop-with-contactors",
        what: "a safety task that is not periodic",
        changes: &[("Type := PERIODIC", "Type := CONTINUOUS")],
        code: "S0501",
    },
    Mutation {
        sample: "estop-with-contactors",
        what: "a second safety task",
        changes: &[(
            "  TASK Safety_Task",
            "  TASK Other_Task (Type := PERIODIC, Class := Safety, Rate := 20, Watchdog := 10, Priority := 6)\n  END_TASK\n  TASK Safety_Task",
        )],
        code: "S0501",
    },
    Mutation {
        sample: "estop-with-contactors",
        what: "a standard program in the safety task",
        changes: &[
            (
                "  TASK Safety_Task",
                "  PROGRAM Panel_Main (MAIN := \"Main\")\n    ROUTINE Main\n      N: NOP();\n    END_ROUTINE\n  END_PROGRAM\n  TASK Safety_Task",
            ),
            ("    Safety_Main;\n  END_TASK", "    Safety_Main;\n    Panel_Main;\n  END_TASK"),
        ],
        code: "S0504",
    },
    Mutation {
        sample: "estop-with-contactors",
        what: "a program that the task names and nobody declares",
        changes: &[("    Safety_Main;\n  END_TASK", "    Safety_Mian;\n  END_TASK")],
        code: "E0208",
    },
    Mutation {
        sample: "estop-with-contactors",
        what: "one routine as main and fault routine",
        changes: &[("MAIN := \"Main\")", "MAIN := \"Main\", FAULT := \"Main\")")],
        code: "S0505",
    },
    Mutation {
        sample: "estop-with-contactors",
        what: "a main routine that does not exist",
        changes: &[("MAIN := \"Main\")", "MAIN := \"Mian\")")],
        code: "E0204",
    },
    Mutation {
        sample: "estop-with-contactors",
        what: "standard logic that writes a safety tag",
        changes: &[(
            "  TASK Safety_Task",
            "  PROGRAM Panel_Main (MAIN := \"Main\")\n    ROUTINE Main\n      N: OTE(Motor_Run);\n    END_ROUTINE\n  END_PROGRAM\n  TASK Safety_Task",
        )],
        code: "S0302",
    },
    Mutation {
        sample: "estop-with-contactors",
        what: "an online edit pending",
        changes: &[("N: XIC(Contactors.O1)OTE(K1);", "I: XIC(Contactors.O1)OTE(K1);")],
        code: "S0506",
    },
    Mutation {
        sample: "estop-with-contactors",
        what: "a routine that calls itself",
        changes: &[("N: XIC(Contactors.O2)OTE(K2);", "N: XIC(Contactors.O2)OTE(K2); N: JSR(Main,0);")],
        code: "S0604",
    },
    Mutation {
        sample: "estop-with-contactors",
        what: "a routine that does not exist",
        changes: &[("N: XIC(Contactors.O2)OTE(K2);", "N: XIC(Contactors.O2)OTE(K2); N: JSR(Part,0);")],
        code: "E0204",
    },
    Mutation {
        sample: "estop-with-contactors",
        what: "a label that does not exist",
        changes: &[("N: XIC(Contactors.O2)OTE(K2);", "N: XIC(Contactors.O2)OTE(K2); N: XIC(Start)JMP(Past);")],
        code: "E0205",
    },
    Mutation {
        sample: "estop-with-contactors",
        what: "a zone of MCR left open",
        changes: &[("N: XIC(Contactors.O2)OTE(K2);", "N: XIC(Contactors.O2)OTE(K2); N: XIC(Start)MCR();")],
        code: "S0607",
    },
    Mutation {
        sample: "estop-with-contactors",
        what: "an empty rung",
        changes: &[("N: XIC(Contactors.O2)OTE(K2);", "N: XIC(Contactors.O2)OTE(K2); N: ;")],
        code: "E0406",
    },
    Mutation {
        sample: "estop-with-contactors",
        what: "a parenthesis missing",
        changes: &[("OTE(K1);", "OTE(K1;")],
        code: "E0104",
    },
    Mutation {
        sample: "estop-with-contactors",
        what: "parameters that the subroutine does not have",
        changes: &[
            ("    END_ROUTINE", "    END_ROUTINE\n    ROUTINE Part\n      N: NOP();\n    END_ROUTINE"),
            ("N: XIC(Contactors.O2)OTE(K2);", "N: XIC(Contactors.O2)OTE(K2); N: JSR(Part,1,7);"),
        ],
        code: "E0405",
    },
    Mutation {
        sample: "estop-with-contactors",
        what: "a routine in structured text",
        changes: &[(
            "    END_ROUTINE",
            "    END_ROUTINE\n    ST_ROUTINE Text\n      'Motor_Run := 1;\n    END_ST_ROUTINE",
        )],
        code: "S0109",
    },
    Mutation {
        sample: "estop-with-contactors",
        what: "a controller without safety task",
        changes: &[("\"1756-L72S\"", "\"1756-L72\"")],
        code: "E0402",
    },
];
