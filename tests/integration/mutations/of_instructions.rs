//! Broken instructions: which ones, their operands, their tags.

use super::Mutation;

/// Each with the rule that refuses it.
pub(super) static ALL: &[Mutation] = &[
    Mutation {
        sample: "estop-with-contactors",
        what: "an instruction that is not certified",
        changes: &[("OTE(K1);", "OTE(K1)SIN(1,Motor_Run);")],
        code: "S0101",
    },
    Mutation {
        sample: "qualified-standard-data",
        what: "CMP on an L63S",
        changes: &[("XIC(Node31:I.Pt07Data)", "XIC(Node31:I.Pt07Data)CMP(1>0)")],
        code: "S0102",
    },
    Mutation {
        sample: "dual-analog-trip-integer",
        what: "DCA before the version that has it",
        changes: &[("Major := 20", "Major := 19")],
        code: "S0102",
    },
    Mutation {
        sample: "estop-with-contactors",
        what: "a trigonometric function in CPT",
        changes: &[
            (
                "Motor_Run    : BOOL (Class := Safety);",
                "Motor_Run    : BOOL (Class := Safety); A, B : REAL (Class := Safety);",
            ),
            ("N: XIC(Contactors.O2)OTE(K2);", "N: XIC(Contactors.O2)OTE(K2); N: CPT(A,SIN(B));"),
        ],
        code: "S0104",
    },
    Mutation {
        sample: "estop-with-contactors",
        what: "COP with a tag as length",
        changes: &[
            (
                "Motor_Run    : BOOL (Class := Safety);",
                "Motor_Run    : BOOL (Class := Safety); From, To : DINT[8] (Class := Safety); Count : DINT (Class := Safety);",
            ),
            ("N: XIC(Contactors.O2)OTE(K2);", "N: XIC(Contactors.O2)OTE(K2); N: COP(From[0],To[0],Count);"),
        ],
        code: "S0105",
    },
    Mutation {
        sample: "estop-with-contactors",
        what: "a COP longer than its destination",
        changes: &[
            (
                "Motor_Run    : BOOL (Class := Safety);",
                "Motor_Run    : BOOL (Class := Safety); From : DINT[8] (Class := Safety); To : DINT[4] (Class := Safety);",
            ),
            ("N: XIC(Contactors.O2)OTE(K2);", "N: XIC(Contactors.O2)OTE(K2); N: COP(From[0],To[0],8);"),
        ],
        code: "S0106",
    },
    Mutation {
        sample: "estop-with-contactors",
        what: "a COP between elements of two sizes",
        changes: &[
            (
                "Motor_Run    : BOOL (Class := Safety);",
                "Motor_Run    : BOOL (Class := Safety); From : DINT[8] (Class := Safety); To : INT[8] (Class := Safety);",
            ),
            ("N: XIC(Contactors.O2)OTE(K2);", "N: XIC(Contactors.O2)OTE(K2); N: COP(From[0],To[0],8);"),
        ],
        code: "S0106",
    },
    Mutation {
        sample: "estop-with-contactors",
        what: "GSV of an attribute out of reach",
        changes: &[
            (
                "Motor_Run    : BOOL (Class := Safety);",
                "Motor_Run    : BOOL (Class := Safety); Clock : DINT[7] (Class := Safety);",
            ),
            (
                "N: XIC(Contactors.O2)OTE(K2);",
                "N: XIC(Contactors.O2)OTE(K2); N: GSV(WALLCLOCKTIME,,LocalDateTime,Clock[0]);",
            ),
        ],
        code: "S0107",
    },
    Mutation {
        sample: "estop-with-contactors",
        what: "a discrepancy time of 4 ms",
        changes: &[("ACTIVE HIGH,500", "ACTIVE HIGH,4")],
        code: "E0305",
    },
    Mutation {
        sample: "estop-with-contactors",
        what: "a word that is not in the list",
        changes: &[("500,MANUAL,MANUAL", "500,SOMETIMES,MANUAL")],
        code: "E0304",
    },
    Mutation {
        sample: "estop-with-contactors",
        what: "a reset operand missing",
        changes: &[("CombinedInputStatus,Reset);", "CombinedInputStatus);")],
        code: "E0301",
    },
    Mutation {
        sample: "estop-with-contactors",
        what: "a rung left unfinished",
        changes: &[("Motor_Run,K1_Feedback,", "?,K1_Feedback,")],
        code: "E0303",
    },
    Mutation {
        sample: "estop-with-contactors",
        what: "an immediate as a channel",
        changes: &[("Field_In:I.Pt00Data,Field_In:I.Pt01Data", "1,Field_In:I.Pt01Data")],
        code: "E0302",
    },
    Mutation {
        sample: "estop-with-contactors",
        what: "one point for both channels",
        changes: &[("Field_In:I.Pt00Data,Field_In:I.Pt01Data", "Field_In:I.Pt00Data,Field_In:I.Pt00Data")],
        code: "S0605",
    },
    Mutation {
        sample: "estop-with-contactors",
        what: "a backing tag of another type",
        changes: &[("EStop        : DCI_STOP", "EStop : DCI_START")],
        code: "E0302",
    },
    Mutation {
        sample: "estop-with-contactors",
        what: "a backing tag that serves two calls",
        changes: &[(
            "N: XIC(Contactors.O2)OTE(K2);",
            "N: XIC(Contactors.O2)OTE(K2); N: CROUT(Contactors,NEGATIVE,200,Motor_Run,K1_Feedback,K2_Feedback,1,1,Reset);",
        )],
        code: "S0601",
    },
    Mutation {
        sample: "estop-with-contactors",
        what: "a member of a backing tag written",
        changes: &[("N: XIC(Contactors.O2)OTE(K2);", "N: XIC(Contactors.O2)OTE(K2); N: XIC(Start)OTL(EStop.O1);")],
        code: "S0602",
    },
    Mutation {
        sample: "estop-with-contactors",
        what: "EnableIn of a backing tag examined",
        changes: &[("XIC(EStop.O1)", "XIC(EStop.EnableIn)")],
        code: "S0603",
    },
    Mutation {
        sample: "estop-with-contactors",
        what: "RES of the timer of a TOF",
        changes: &[
            (
                "Motor_Run    : BOOL (Class := Safety);",
                "Motor_Run    : BOOL (Class := Safety); Wait : TIMER (Class := Safety);",
            ),
            (
                "N: XIC(Contactors.O2)OTE(K2);",
                "N: XIC(Contactors.O2)OTE(K2); N: XIC(Start)TOF(Wait,100,0); N: XIC(Start)RES(Wait);",
            ),
        ],
        code: "S0606",
    },
    Mutation {
        sample: "add-on-instruction",
        what: "an argument of another type",
        changes: &[("Fault_Reset,150,", "Fault_Reset,Guard_Closed,")],
        code: "E0302",
    },
    Mutation {
        sample: "add-on-instruction",
        what: "an argument missing",
        changes: &[("Fault_Reset,150,", "Fault_Reset,")],
        code: "E0301",
    },
    Mutation {
        sample: "dual-analog-trip-integer",
        what: "a limit above the other",
        changes: &[("300,50,3000,500", "300,50,500,3000")],
        code: "S0605",
    },
];
