//! Codes of what cannot be read or resolved, and of our own defects. The codes of the rules stand with the rules.

use super::{Code, Severity};

macro_rules! codes {
    ($($(#[$doc:meta])* $name:ident = $id:literal, $title:literal, $explanation:literal, $citation:literal;)*) => {
        $(
            $(#[$doc])*
            pub static $name: Code = Code {
                id: $id,
                severity: Severity::Error,
                title: $title,
                explanation: $explanation,
                citation: $citation,
                good: "",
                bad: "",
            };
        )*
        pub(super) static HERE: &[&Code] = &[$(&$name,)* &UNUSED_SUPPRESSION];
    };
}

codes! {
    /// A file that cannot be read.
    UNREADABLE_FILE = "E0101", "the file cannot be read",
        "The file is missing, empty, or not text in UTF-8. Export it again, or name another file.", "DESIGN 7";
    /// A file that is no project file.
    BROKEN_FILE = "E0102", "the file is no project export",
        "An L5X is an XML file with RSLogix5000Content as its outermost element. The file is damaged or of another kind; export it again.",
        "neutral-text-and-l5x.md D.1";
    /// A declaration of the wrong shape.
    BROKEN_DECLARATION = "E0103", "a declaration cannot be understood",
        "A declaration has a shape that neither .rll nor L5K nor L5X knows. Compare it with a sample of its kind.",
        "neutral-text-and-l5x.md D.9";
    /// A rung of the wrong shape.
    BROKEN_RUNG = "E0104", "a rung cannot be understood",
        "A rung is a series of instructions and branches that ends with a semicolon: XIC(a)[XIC(b) ,XIC(c) ]OTE(d);",
        "neutral-text-and-l5x.md C.1";
    /// An operand of the wrong shape.
    BROKEN_OPERAND = "E0105", "an operand cannot be understood",
        "The operand is neither a tag, nor a value, nor what else its instruction wants in this place.",
        "neutral-text-and-l5x.md C.2";
    /// A relation whose grouping is uncertain.
    AMBIGUOUS_RELATION = "E0106", "an expression groups in two ways",
        "Two published tables of precedence rank relations (< = >) differently against + - AND XOR OR. Put parentheses around the relation.",
        "general-instructions.md A.9";
    /// Data of a tag that cannot be read.
    BROKEN_DATA = "E0107", "a tag's data cannot be understood",
        "The data is neither a number, a list, a string nor a decorated structure.", "neutral-text-and-l5x.md D.5";
    /// More than a limit.
    OVER_LIMIT = "E0108", "something is larger than the limit",
        "Every size and depth has a documented limit, so that no input can exhaust the machine. Split what is too large.",
        "limits of the grammar, the compiler and the image";

    /// A tag that is not declared.
    UNKNOWN_TAG = "E0201", "a tag is not declared",
        "The name is declared neither in the routine's program nor in the controller (in an Add-On Instruction: neither as a parameter nor as a local tag). Correct the name or declare the tag; for a partial export add the file that declares it as context.",
        "neutral-text-and-l5x.md C.2";
    /// A member that the type does not have.
    UNKNOWN_MEMBER = "E0202", "a member does not exist",
        "The type of the tag has no member of this name, or the tag has no members at all.",
        "neutral-text-and-l5x.md C.2";
    /// A type that is not declared.
    UNKNOWN_TYPE = "E0203", "a data type is not declared",
        "The type is neither elementary, nor predefined, nor declared in the project. Correct the name or declare it; for a partial export add the file that declares it as context.",
        "neutral-text-and-l5x.md D.4";
    /// A routine that the program does not have.
    UNKNOWN_ROUTINE = "E0204", "a routine does not exist",
        "JSR, the main routine and the fault routine name a routine of the same program.", "general-instructions.md A.8";
    /// A label that the routine does not have.
    UNKNOWN_LABEL = "E0205", "a label does not exist",
        "JMP names a label that an LBL at the beginning of a rung of the same routine defines.",
        "general-instructions.md A.8";
    /// A name declared twice.
    DUPLICATE_NAME = "E0206", "a name is declared twice",
        "Names are compared without regard to case and are unique in their scope. Rename one of the two.",
        "neutral-text-and-l5x.md D.10";
    /// A name that no component can have.
    BAD_NAME = "E0207", "a name is not admitted",
        "A name has 1 to 40 letters, digits and underscores, does not begin with a digit, has no two underscores in a row and does not end with one.",
        "neutral-text-and-l5x.md C.2";
    /// A program that does not exist.
    UNKNOWN_PROGRAM = "E0208", "a program does not exist",
        "The task schedules a program that the file does not hold.", "neutral-text-and-l5x.md D.7";
    /// An event task that does not exist.
    UNKNOWN_EVENT_TASK = "E0209", "an event task does not exist",
        "EVENT names a task of type EVENT and class Standard.", "general-instructions.md A.8";
    /// An alias without a target.
    BAD_ALIAS = "E0210", "an alias leads nowhere",
        "An alias names a tag, a member, an element with constant subscripts, or a bit, and does not lead back to itself.",
        "neutral-text-and-l5x.md C.2";

    /// Too few or too many operands.
    OPERAND_COUNT = "E0301", "wrong number of operands",
        "The instruction has another number of operands. An Add-On Instruction takes its tag and one argument for each required parameter.",
        "neutral-text-and-l5x.md C.3";
    /// An operand of the wrong type.
    OPERAND_TYPE = "E0302", "an operand has the wrong type",
        "The operand's type is not one that the instruction takes in this place.", "general-instructions.md A";
    /// `?` where a value is needed.
    OPERAND_MISSING = "E0303", "an operand is missing",
        "`?` stands for a value only where an instruction shows a member of its own tag (Preset, Accum, Length, Position). Anywhere else the rung is unfinished.",
        "neutral-text-and-l5x.md C.2";
    /// A word that is not in the list.
    UNKNOWN_CHOICE = "E0304", "an option word does not exist",
        "The operand takes one word out of a list, or its number. `explain` of the instruction shows the list.",
        "dual-channel-inputs.md 1.3";
    /// A value out of range.
    VALUE_RANGE = "E0305", "a value is out of range",
        "A number has the range of what takes it: SINT -128 to 127, INT -32768 to 32767, DINT and every literal in logic 32 bits, a preset 0 or more, and each operand of a safety instruction a range of its own (a discrepancy time 5 to 3000 ms). Write a value within the range that the message names; `twinrung explain DCS` lists those of DCS.", "general-instructions.md 2.1";
    /// A subscript out of range.
    SUBSCRIPT_RANGE = "E0306", "a subscript is out of range",
        "Elements count from 0, bits of a SINT, INT, DINT from 0 to 7, 15, 31. A constant beyond the end would be the major fault 4/20 when it is executed.",
        "general-instructions.md 2.6";
    /// A type that cannot be laid out.
    BAD_TYPE = "E0307", "a data type cannot be laid out",
        "A type does not contain itself, its BOOL arrays have a multiple of 32 elements, and its size stays within the limits.",
        "neutral-text-and-l5x.md D.4";
    /// Two forms of the same data that disagree.
    DATA_DISAGREES = "E0308", "two forms of a tag's data disagree",
        "An export writes the same data in several forms. Where they differ the file was changed by hand or damaged: export it again.",
        "neutral-text-and-l5x.md D.5";
    /// Data that its type cannot hold.
    DATA_DOES_NOT_FIT = "E0309", "data does not fit its type",
        "The initial value has another shape than the tag's type, or a number out of the type's range.",
        "neutral-text-and-l5x.md D.5";

    /// No controller is named.
    NO_CONTROLLER = "E0401", "the controller is not known",
        "What is admitted depends on the controller and its revision. The file does not say which it is: complete it with --controller CATALOG/REVISION.",
        "neutral-text-and-l5x.md D.1";
    /// A controller that is no safety controller.
    UNKNOWN_CONTROLLER = "E0402", "not a known safety controller",
        "The catalogue number is not that of a known GuardLogix controller, or the revision does not exist for it.",
        "DESIGN 4; 1756-RM093 Table 2";
    /// No task to run.
    NO_TASK = "E0403", "there is no safety task",
        "An image needs a safety task. A partial export has none: complete it with --period and --watchdog.",
        "neutral-text-and-l5x.md D.1";
    /// A rung without anything on it.
    EMPTY_RUNG = "E0406", "a rung is empty",
        "An empty rung executes nothing and does not verify. Delete it, or put NOP() on it.",
        "neutral-text-and-l5x.md C.1";
    /// A component that the maker encoded.
    ENCODED = "E0407", "a component is encoded",
        "The maker's software encoded this component; nobody but it can read or verify what it does. Export it without source protection.",
        "neutral-text-and-l5x.md D.6";
    /// Something that is read but not supported.
    NOT_SUPPORTED = "E0408", "not supported here",
        "This is known, and no rule forbids it, but this tool does not compile it.", "README, what is not done";
    /// A subroutine that does not exist within an Add-On Instruction.
    ADD_ON_SHAPE = "E0409", "an Add-On Instruction is malformed",
        "An Add-On Instruction has a routine Logic in ladder, parameters Input, Output or InOut, and nothing of another class than its own.",
        "neutral-text-and-l5x.md D.8";

    /// A scenario file of the wrong shape.
    BROKEN_SCENARIO = "E0501", "a scenario cannot be understood",
        "A statement of a scenario file has a shape that docs/scenarios.md does not know. Each begins with its own word: given, at, after, when, hold, toggle, mode, then, never.",
        "docs/scenarios.md";
    /// A name of a scenario that is none, or that it may not drive.
    SCENARIO_NAME = "E0502", "a scenario names what is not there",
        "A name is a safety tag, a member, an element or a bit of one, Published:TAG, Controller:Mode or Controller:Fault. A scenario drives only what no logic writes, and looks at everything.",
        "docs/scenarios.md";
    /// A value that its tag cannot have.
    SCENARIO_VALUE = "E0503", "a value does not fit its tag",
        "A BOOL is on or off (1 or 0); an integer is decimal or 2#, 8#, 16# within its range; a REAL is decimal. Only a REAL has a tolerance.",
        "docs/scenarios.md";
    /// A time that the grid of the scans does not have.
    SCENARIO_TIME = "E0504", "a time of a scenario cannot be met",
        "Times are whole milliseconds, moments of a block follow each other, and a check needs at least one scan to look at: between a moment and the end of its time a scan must begin.",
        "docs/scenarios.md";
    /// A block that does not exist, or twice, or within itself.
    SCENARIO_BLOCK = "E0505", "a scenario or setup is not in order",
        "Scenarios and setups have names of their own; `with` names a setup of the same file and stands first in its block; a setup does not begin with itself.",
        "docs/scenarios.md";
    /// An exclusion of what does not exist.
    SCENARIO_EXCLUSION = "E0506", "an exclusion names nothing",
        "An exclusion names an item of the coverage as the report lists it, and gives a reason.",
        "docs/scenarios.md";
    /// Something at a terminal that cannot be.
    SCENARIO_TERMINAL = "E0507", "a terminal cannot do this",
        "A terminal belongs to a 1734-IB8S, 1734-OB8S or 1734-IE4S of the project and is one that the project uses. Where a scenario acts at terminals, the tags of these modules follow, and are not driven by name.",
        "docs/scenarios.md";

    /// A suppression that is not admitted.
    BAD_SUPPRESSION = "E0411", "a suppression is not admitted",
        "A suppression accepts a warning and says why: `allow W0101: the last coil is meant to decide`. It stands in a comment of the source, in a rung comment or in a description, and covers the rung or declaration there. It needs the code of a warning and a reason; an error is mended, not suppressed.",
        "decided";

    /// Something that this tool did wrong.
    DEFECT = "D0001", "a defect of this tool",
        "The project was found correct, and still no image came of it. This is a fault of this tool, not of the project: please report it with the file.",
        "";
    /// More findings than are listed.
    TOO_MANY_FINDINGS = "E0109", "more findings than are listed",
        "Only the first findings of a run are listed. Mend those and check again.", "limits of the compiler";
}

/// A suppression that covers nothing.
pub static UNUSED_SUPPRESSION: Code = Code {
    id: "W0901",
    severity: Severity::Warning,
    title: "a suppression covers nothing",
    explanation: "The rung or declaration gives no warning of the code that is suppressed there: what was accepted has been mended or moved. Delete the suppression, so that it does not hide the same warning one day later.",
    citation: "decided",
    good: "",
    bad: "",
};
