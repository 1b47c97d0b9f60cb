//! Broken data: types, classes, the tag map, aliases, data flow.

use super::Mutation;

/// Each with the rule that refuses it.
pub(super) static ALL: &[Mutation] = &[
    Mutation {
        sample: "estop-with-contactors",
        what: "a BOOL declared as DINT",
        changes: &[("Motor_Run    : BOOL (Class := Safety);", "Motor_Run : DINT (Class := Safety);")],
        code: "E0302",
    },
    Mutation {
        sample: "estop-with-contactors",
        what: "a safety tag declared without its class",
        changes: &[("Motor_Run    : BOOL (Class := Safety);", "Motor_Run : BOOL;")],
        code: "S0301",
    },
    Mutation {
        sample: "estop-with-contactors",
        what: "a safety tag of a type that is not in Table 7",
        changes: &[(
            "Motor_Run    : BOOL (Class := Safety);",
            "Motor_Run    : BOOL (Class := Safety); Long : LINT (Class := Safety);",
        )],
        code: "S0201",
    },
    Mutation {
        sample: "qualified-standard-data",
        what: "a REAL tag on an L63S",
        changes: &[(
            "LatchOneShot : BOOL (Class := Safety);",
            "LatchOneShot : BOOL (Class := Safety); Speed : REAL (Class := Safety);",
        )],
        code: "S0202",
    },
    Mutation {
        sample: "qualified-standard-data",
        what: "a REAL within a type on an L63S",
        changes: &[
            ("  MODULE Rack", "  DATATYPE Axis_T\n    DINT Step;\n    REAL Speed;\n  END_DATATYPE\n  MODULE Rack"),
            (
                "LatchOneShot : BOOL (Class := Safety);",
                "LatchOneShot : BOOL (Class := Safety); Axis : Axis_T (Class := Safety);",
            ),
        ],
        code: "S0202",
    },
    Mutation {
        sample: "qualified-standard-data",
        what: "the line of the tag map missing",
        changes: &[(
            "MappedBooleanTag : BOOL (Class := Safety, MappedFrom := Panel_Start);",
            "MappedBooleanTag : BOOL;",
        )],
        code: "S0301",
    },
    Mutation {
        sample: "qualified-standard-data",
        what: "the line of the tag map between two types",
        changes: &[("Panel_Start : BOOL;", "Panel_Start : DINT;")],
        code: "S0305",
    },
    Mutation {
        sample: "qualified-standard-data",
        what: "the line of the tag map from a tag that does not exist",
        changes: &[("MappedFrom := Panel_Start", "MappedFrom := Panel_Stop")],
        code: "S0305",
    },
    Mutation {
        sample: "qualified-standard-data",
        what: "a mapped tag written",
        changes: &[(
            "OTE(Node30:O.Pt03Data);",
            "OTE(Node30:O.Pt03Data); N: XIC(Node31:I.Pt07Data)OTL(MappedBooleanTag);",
        )],
        code: "S0304",
    },
    Mutation {
        sample: "estop-with-contactors",
        what: "a constant tag written",
        changes: &[("Motor_Run    : BOOL (Class := Safety);", "Motor_Run : BOOL (Class := Safety, Constant := Yes);")],
        code: "S0304",
    },
    Mutation {
        sample: "estop-with-contactors",
        what: "an alias between the classes",
        changes: &[("Reset OF Field_In:I.Pt02Data;", "Reset OF Field_In:I.Pt02Data (Class := Standard);")],
        code: "S0303",
    },
    Mutation {
        sample: "estop-with-contactors",
        what: "an alias that leads back to itself",
        changes: &[(
            "Motor_Run    : BOOL (Class := Safety);",
            "Motor_Run    : BOOL (Class := Safety); Loop OF Loop_2; Loop_2 OF Loop;",
        )],
        code: "E0210",
    },
    Mutation {
        sample: "estop-with-contactors",
        what: "a name that is declared nowhere",
        changes: &[("OTE(K1);", "OTE(K9);")],
        code: "E0201",
    },
    Mutation {
        sample: "estop-with-contactors",
        what: "a member that the type does not have",
        changes: &[("XIC(EStop.O1)", "XIC(EStop.O7)")],
        code: "E0202",
    },
    Mutation {
        sample: "estop-with-contactors",
        what: "a type that is declared nowhere",
        changes: &[(
            "Motor_Run    : BOOL (Class := Safety);",
            "Motor_Run    : BOOL (Class := Safety); Box : Box_T (Class := Safety);",
        )],
        code: "E0203",
    },
    Mutation {
        sample: "estop-with-contactors",
        what: "a name declared twice",
        changes: &[(
            "Motor_Run    : BOOL (Class := Safety);",
            "Motor_Run    : BOOL (Class := Safety); EStop : BOOL (Class := Safety);",
        )],
        code: "E0206",
    },
    Mutation {
        sample: "estop-with-contactors",
        what: "a name with two underscores",
        changes: &[(
            "Motor_Run    : BOOL (Class := Safety);",
            "Motor_Run    : BOOL (Class := Safety); Motor__Run : BOOL (Class := Safety);",
        )],
        code: "E0207",
    },
    Mutation {
        sample: "estop-with-contactors",
        what: "a value that does not fit its type",
        changes: &[(
            "Motor_Run    : BOOL (Class := Safety);",
            "Motor_Run    : BOOL (Class := Safety); Small : SINT (Class := Safety) := 300;",
        )],
        code: "E0309",
    },
    Mutation {
        sample: "estop-with-contactors",
        what: "a subscript beyond the array",
        changes: &[
            (
                "Motor_Run    : BOOL (Class := Safety);",
                "Motor_Run    : BOOL (Class := Safety); List : DINT[4] (Class := Safety);",
            ),
            ("N: XIC(Contactors.O2)OTE(K2);", "N: XIC(Contactors.O2)OTE(K2); N: CLR(List[4]);"),
        ],
        code: "E0306",
    },
    Mutation {
        sample: "estop-with-contactors",
        what: "a force installed",
        changes: &[(
            "Motor_Run    : BOOL (Class := Safety);",
            "Motor_Run : BOOL (Class := Safety) := 0, TagForceData := [0,0,0,0,1,0,0,0];",
        )],
        code: "S0507",
    },
    Mutation {
        sample: "estop-with-contactors",
        what: "a produced tag without connection status",
        changes: &[
            ("  MODULE Rack", "  DATATYPE Link_T\n    BOOL Stop;\n    DINT Count;\n  END_DATATYPE\n  MODULE Rack"),
            (
                "Motor_Run    : BOOL (Class := Safety);",
                "Motor_Run    : BOOL (Class := Safety); Link : Link_T (Class := Safety, Produced := 1, RPI := 20);",
            ),
        ],
        code: "S0402",
    },
    Mutation {
        sample: "qualified-standard-data",
        what: "the safety contact taken out of the qualified path",
        changes: &[("]XIC(Node31:I.Pt07Data)", "]")],
        code: "S0701",
    },
    Mutation {
        sample: "qualified-standard-data",
        what: "a second writer that standard data alone drives",
        changes: &[(
            "OTE(Node30:O.Pt03Data);",
            "OTE(Node30:O.Pt03Data); N: XIC(MappedBooleanTag)OTL(Node30:O.Pt04Data);",
        )],
        code: "S0701",
    },
    Mutation {
        sample: "qualified-standard-data",
        what: "standard data behind a timer",
        changes: &[
            (
                "LatchOneShot : BOOL (Class := Safety);",
                "LatchOneShot : BOOL (Class := Safety); Wait : TIMER (Class := Safety);",
            ),
            (
                "OTE(Node30:O.Pt03Data);",
                "OTE(Node30:O.Pt03Data); N: XIC(MappedBooleanTag)TON(Wait,100,0); N: XIC(Wait.DN)OTE(Node30:O.Pt04Data);",
            ),
        ],
        code: "S0701",
    },
    Mutation {
        sample: "qualified-standard-data",
        what: "a member marked STANDARD as the qualifier",
        changes: &[("XIC(Node31:I.Pt07Data)", "XIC(Node31:I.InputPowerStatus)")],
        code: "S0701",
    },
    Mutation {
        sample: "estop-with-contactors",
        what: "standard data as a channel",
        changes: &[
            (
                "Motor_Run    : BOOL (Class := Safety);",
                "Motor_Run    : BOOL (Class := Safety); Panel : BOOL; Panel_Stop : BOOL (Class := Safety, MappedFrom := Panel);",
            ),
            ("Field_In:I.Pt00Data,Field_In:I.Pt01Data", "Panel_Stop,Field_In:I.Pt01Data"),
        ],
        code: "S0702",
    },
    Mutation {
        sample: "estop-with-contactors",
        what: "standard data as the feedback of a contactor",
        changes: &[
            (
                "Motor_Run    : BOOL (Class := Safety);",
                "Motor_Run    : BOOL (Class := Safety); Panel : BOOL; Panel_Contact : BOOL (Class := Safety, MappedFrom := Panel);",
            ),
            ("Motor_Run,K1_Feedback,", "Motor_Run,Panel_Contact,"),
        ],
        code: "S0702",
    },
    Mutation {
        sample: "estop-with-contactors",
        what: "SIL 2 data that switches a SIL 3 output",
        changes: &[
            ("K1 OF Field_Out:O.Pt00Data;", "K1 OF Field_Out:O.Pt00Data (SIL := 3);"),
            ("XIC(EStop.O1)XIO", "XIC(Start)XIO"),
        ],
        code: "S0703",
    },
    Mutation {
        sample: "parameter-from-terminal",
        what: "a parameter whose two tags are not compared",
        changes: &[("XIC(Limits_Equal)", "")],
        code: "S0704",
    },
    Mutation {
        sample: "parameter-from-terminal",
        what: "a parameter whose range is not checked",
        changes: &[("XIC(Limit_In_Range)", "")],
        code: "S0704",
    },
    Mutation {
        sample: "parameter-from-terminal",
        what: "a parameter whose upper end is not checked",
        changes: &[("LIM(100,Limit_1,1500)", "GEQ(Limit_1,100)")],
        code: "S0704",
    },
    Mutation {
        sample: "parameter-from-terminal",
        what: "a parameter that is not acknowledged",
        changes: &[("XIC(Acknowledge)ONS(Acknowledge_Edge)", "")],
        code: "S0704",
    },
    Mutation {
        sample: "parameter-from-terminal",
        what: "a parameter that a held button acknowledges",
        changes: &[("ONS(Acknowledge_Edge)", "")],
        code: "S0704",
    },
    Mutation {
        sample: "parameter-from-terminal",
        what: "a parameter that arrives in one standard tag",
        changes: &[("MappedFrom := Terminal_Limit_2", "MappedFrom := Terminal_Limit_1")],
        code: "S0704",
    },
    Mutation {
        sample: "parameter-from-terminal",
        what: "a bound that the terminal writes",
        changes: &[("LIM(100,Limit_1,1500)", "LIM(100,Limit_1,Limit_2)")],
        code: "S0704",
    },
];
