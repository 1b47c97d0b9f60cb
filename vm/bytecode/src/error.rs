//! Why an image is refused: one variant for each rule, with its place.

use core::fmt;

use crate::index::*;
use crate::operand::DecodeError;

/// An instruction of the image.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Site {
    /// The routine.
    pub routine: RoutineIndex,
    /// The rung, from 0.
    pub rung: u32,
    /// The instruction on the rung, from 0, in the order of the code.
    pub element: u32,
}

impl fmt::Display for Site {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "routine {}, rung {}, element {}", self.routine, self.rung, self.element)
    }
}

macro_rules! rules {
    ($($name:ident $({ $($field:ident: $type:ty),* $(,)? })? => $text:literal;)*) => {
        /// Why an image is refused. The sentence of a variant is what it prints.
        #[derive(Debug, Clone, PartialEq, Eq)]
        pub enum ImageError {
            $(
                #[doc = $text]
                $name $({
                    $(#[doc = concat!("The ", stringify!($field), " that the sentence names.")] $field: $type,)*
                })?,
            )*
        }

        impl ImageError {
            /// The names of all rules.
            pub const RULES: &'static [&'static str] = &[$(stringify!($name),)*];

            /// The name of the rule that the image breaks.
            pub const fn rule(&self) -> &'static str {
                match self {
                    $(ImageError::$name { .. } => stringify!($name),)*
                }
            }
        }

        impl fmt::Display for ImageError {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                match self {
                    $(ImageError::$name $({ $($field),* })? => write!(f, $text),)*
                }
            }
        }
    };
}

rules! {
    // The file.
    TooManyBytes { count: usize } => "an image of {count} bytes is larger than any that is read";
    NotAnImage => "the file does not begin as an image does";
    UnknownVersion { version: u32 } => "version {version} of the image format is not known here";
    SectionTable { offset: usize } => "byte {offset}: the sections are not those of an image, in their order";
    Truncated { offset: usize } => "byte {offset}: the bytes end before what they promise";
    SlackBytes { offset: usize } => "byte {offset}: bytes are left over";
    NotABoolean { offset: usize } => "byte {offset}: neither 0 nor 1";
    NotText { offset: usize } => "byte {offset}: the text is not UTF-8";
    TooMany { offset: usize, count: usize, limit: usize } => "byte {offset}: {count} entries are more than the {limit} that a table may have";
    UnknownChoice { offset: usize } => "byte {offset}: no choice has this number";
    OperandOffsets { offset: usize } => "byte {offset}: the entries of the operand table do not follow each other";

    // The signatures.
    ImageSignature => "the image signature is not that of the file's content";
    ApplicationSignature => "the application signature is not that of the application's texts and declarations";

    // Code and operands as such.
    UnknownOpcode { routine: RoutineIndex, offset: usize, opcode: u8 } => "routine {routine}, byte {offset}: no instruction has the number {opcode}";
    CodeTruncated { routine: RoutineIndex, offset: usize } => "routine {routine}, byte {offset}: the code ends within an element";
    OperandEncoding { operand: OperandIndex, why: DecodeError } => "operand {operand} is not encoded as operands are: {why}";
    NoSuchOperand { operand: OperandIndex } => "operand {operand} does not exist";
    OperandOrder { operand: OperandIndex } => "operand {operand} does not stand before the operand that uses it";
    OperandDepth { operand: OperandIndex } => "operand {operand} stands too deep within the subscripts of another";
    OperandWithoutText { operand: OperandIndex } => "operand {operand} names what does not exist, or stands where it has no text";
    CallWithoutInstance { operand: OperandIndex } => "operand {operand} is called as the instance of an Add-On Instruction, and is none";
    ExpressionShape { operand: OperandIndex } => "operand {operand} is not a postfix expression that leaves one value";
    MarkOrder { routine: RoutineIndex, rung: u32 } => "routine {routine}, rung {rung}: rungs, branches and legs do not begin and end in turn";

    OperandScope { operand: OperandIndex } => "operand {operand} joins what belongs to different programs or Add-On Instructions";
    AccessDiffers { operand: OperandIndex } => "operand {operand} does not reach the data that its path names";
    PathRoot { operand: OperandIndex } => "operand {operand} begins at a tag, member or parameter that does not exist";
    PathMember { operand: OperandIndex } => "operand {operand} goes into a member that its type does not have";
    PathSubscript { operand: OperandIndex } => "operand {operand} does not have one subscript for each dimension of an array";
    PathBit { operand: OperandIndex } => "operand {operand} takes a bit of what is no SINT, INT or DINT";
    PathInternal { operand: OperandIndex } => "operand {operand} names a member that only the instruction itself may use";
    PathPrivate { operand: OperandIndex } => "operand {operand} names an instance or backing tag that belongs to the inside of an Add-On Instruction";
    PathLength { operand: OperandIndex } => "operand {operand} has more steps or variable subscripts than an image may hold";
    SubscriptRange { operand: OperandIndex } => "operand {operand} has a subscript or bit number beyond its range";
    SubscriptType { operand: OperandIndex } => "operand {operand} has a subscript that is neither an integer tag nor an integer expression";
    ExpressionLength { operand: OperandIndex } => "operand {operand} has more operations than an expression may have";
    ExpressionDepth { operand: OperandIndex } => "operand {operand} leaves more values open than an expression may";
    ExpressionOperand { operand: OperandIndex } => "operand {operand} takes what is no number into an expression";
    RealOperand { operand: OperandIndex } => "operand {operand} is REAL, which the controller does not have";
    RealNotFinite { operand: OperandIndex } => "operand {operand} is a REAL literal that is not finite";

    // Names and declarations.
    Name { what: &'static str, index: usize } => "{what} {index} has a name that cannot be written";
    NameOrder { what: &'static str, index: usize } => "{what} {index} has a name that does not come after the one before it";
    NameTwice { what: &'static str, index: usize } => "{what} {index} has the name of another in its scope";
    NameReserved { what: &'static str, index: usize } => "{what} {index} has a name that text reads as something else";
    AttributeKeys { what: &'static str, index: usize } => "{what} {index} has settings that are not named, sorted and written as settings are";
    IndexRange { what: &'static str, index: usize } => "{what} {index} refers to a table entry that does not exist";
    UnknownController => "no safety controller has this catalogue number";
    UnknownRevision { revision: u16 } => "the controller has no revision {revision} with a safety task";
    NoTask => "an application has a safety task, and this image has none";
    NotALibrary => "a library of Add-On Instructions has no task, program, tag, module or map";
    Period { microseconds: u32 } => "a period of {microseconds} us is not one that a safety task may have";
    Watchdog { microseconds: u32 } => "a watchdog of {microseconds} us is 0 or above the period";
    Priority { priority: u8 } => "no task has the priority {priority}";
    ScheduledTwice { program: ProgramIndex } => "program {program} is scheduled twice";
    MapTarget { line: usize } => "line {line} of the tag map does not lead to a plain safety tag of the controller";
    MapOrder { line: usize } => "line {line} of the tag map does not come after the one before it, or has its target again";
    SystemValueAttribute { value: SystemValueIndex } => "system value {value} is no attribute that this controller's safety task can reach";
    SystemValueInstance { value: SystemValueIndex } => "system value {value} belongs to an object that does not exist";
    SystemValueOrder { value: SystemValueIndex } => "system value {value} does not begin where the one before it ends, or is listed twice";

    // Types and Add-On Instructions.
    Layout { why: crate::layout::LayoutError } => "the structure types have no layout: {why:?}";
    EmptyType { type_index: TypeIndex } => "type {type_index} has no members";
    MemberDimensions { type_index: TypeIndex, member: usize } => "type {type_index}, member {member}: a member has at most one dimension";
    RealType { type_index: TypeIndex } => "type {type_index} holds REAL, which the controller does not have";
    InstanceType { add_on: AddOnIndex } => "Add-On Instruction {add_on} and its instance type do not name each other";
    InstanceMembers { add_on: AddOnIndex } => "Add-On Instruction {add_on} has an instance type that does not begin with its parameters";
    EnableParameters { add_on: AddOnIndex } => "Add-On Instruction {add_on} does not begin with EnableIn and EnableOut";
    Parameter { add_on: AddOnIndex, parameter: usize } => "Add-On Instruction {add_on}, parameter {parameter}: its type, dimensions or member do not fit its direction";
    AddOnRoutines { add_on: AddOnIndex } => "Add-On Instruction {add_on} does not own exactly the routines that it names";
    RoutineOwner { routine: RoutineIndex } => "routine {routine} does not stand with its owner's routines";
    ProgramRoutine { program: ProgramIndex } => "program {program} names a routine that is not its own, or one routine as main and fault routine";

    // Tags and their cells.
    TagScope { tag: TagIndex } => "tag {tag} does not stand with the tags of its scope";
    TagDimensions { tag: TagIndex } => "tag {tag} has dimensions that no array has";
    TagCells { tag: TagIndex } => "tag {tag} does not begin at the cells that follow the tag before it";
    TagConnection { tag: TagIndex } => "tag {tag} is connected to the outside and does not belong to the controller";
    TagReal { tag: TagIndex } => "tag {tag} holds REAL, which the controller does not have";
    TooManyCells { tag: TagIndex } => "tag {tag} takes more cells than an image may have";
    CellCount => "the initial values are not one for each cell";
    InitialBit { cell: BitCell } => "bit cell {cell} begins as neither 0 nor 1";
    InitialWord { cell: WordCell } => "word cell {cell} begins with a value that its type does not have";
    AliasTarget { tag: TagIndex } => "tag {tag} is an alias of what is no fixed data that its scope can see";
    AliasCircle { tag: TagIndex } => "tag {tag} is an alias of itself";
    AliasType { tag: TagIndex } => "tag {tag} has another type than what it is an alias of";

    // The structure of code.
    RungOutside { routine: RoutineIndex, offset: usize } => "routine {routine}, byte {offset}: an element stands outside a rung, or a rung within one";
    RungOpen { routine: RoutineIndex } => "routine {routine} ends within a rung";
    RungEmpty { routine: RoutineIndex, rung: u32 } => "routine {routine}, rung {rung}: it has no element";
    BranchOpen { routine: RoutineIndex, rung: u32 } => "routine {routine}, rung {rung}: it ends within a branch";
    BranchUnopened { routine: RoutineIndex, rung: u32 } => "routine {routine}, rung {rung}: a leg or branch ends that did not begin";
    BranchDepth { routine: RoutineIndex, rung: u32 } => "routine {routine}, rung {rung}: more branches within branches than a rung may have";
    BranchLegs { routine: RoutineIndex, rung: u32 } => "routine {routine}, rung {rung}: more legs than a branch may have";
    RungLength { routine: RoutineIndex, rung: u32 } => "routine {routine}, rung {rung}: more instructions than a rung may have";
    RungCount => "more rungs than an image may have";
    ExpandedLength => "more instructions than an image may have with every Add-On call replaced by what it runs";
    StraightLength { routine: RoutineIndex } => "routine {routine} and its subroutines execute more instructions than a scan may without a backward jump";
    NotFirst { at: Site } => "{at}: the instruction is not the first element of its rung (SBR: of its routine)";

    // Instructions and their operands.
    InstructionRequires { at: Site } => "{at}: the controller does not admit the instruction";
    InstructionVersion { at: Site } => "{at}: the instruction is admitted from a later revision on";
    OperandCount { at: Site } => "{at}: the instruction does not have so many operands";
    OperandKind { at: Site, position: usize } => "{at}, operand {position}: not what the instruction takes there";
    OperandRange { at: Site, position: usize } => "{at}, operand {position}: a value that the instruction does not take";
    ForeignOperand { at: Site, position: usize } => "{at}, operand {position}: it belongs to another program or Add-On Instruction";
    HiddenTag { at: Site, tag: TagIndex } => "{at}: the text names a tag of the program, and the operand is tag {tag} of the controller";
    WriteConstant { at: Site, tag: TagIndex } => "{at}: it writes tag {tag}, which is constant";
    WriteConsumed { at: Site, tag: TagIndex } => "{at}: it writes tag {tag}, which another controller produces";
    WriteMapped { at: Site, tag: TagIndex } => "{at}: it writes tag {tag}, which receives a standard tag";
    WriteBacking { at: Site } => "{at}: it writes into the backing tag of a safety instruction";
    BackingVariable { at: Site } => "{at}: a variable subscript selects the backing tag";
    BackingTwice { at: Site } => "{at}: its backing tag, or one within its instance, serves another call already";
    BackingCount => "more calls with backing tags than an image may have";
    PresetDiffers { at: Site, position: usize } => "{at}, operand {position}: the text gives a value that the tag does not begin with";
    CopySize { at: Site } => "{at}: source and destination do not have the same size";
    CopyLength { at: Site, position: usize } => "{at}, operand {position}: fewer elements than the length says, or more bytes than one copy moves";
    CopyType { at: Site, position: usize } => "{at}, operand {position}: data that cannot be copied byte by byte";
    SwapTypes { at: Site } => "{at}: source and destination do not have the same type";
    SizeDimension { at: Site } => "{at}: the array does not have this dimension";
    OperandRelation { at: Site } => "{at}: the operands contradict each other or the task";
    SystemData { at: Site } => "{at}: the tag does not have the bytes of the attribute";
    SystemObject { at: Site } => "{at}: class, instance and attribute do not belong together";
    SystemReadOnly { at: Site } => "{at}: the attribute cannot be set";

    // Labels, subroutines, Add-On calls.
    LabelTwice { at: Site } => "{at}: the label is defined twice";
    LabelMissing { at: Site } => "{at}: no rung of the routine has this label";
    LabelName { at: Site } => "{at}: the label has a name that cannot be written";
    MasterControlInAddOn { at: Site } => "{at}: an MCR within an Add-On Instruction would switch the zones of its callers";
    CallOutside { at: Site } => "{at}: a subroutine is called, or begins, within an Add-On Instruction";
    CallCount { at: Site } => "{at}: more parameters than a call may have, or fewer than the number that it states";
    CallParameters { at: Site } => "{at}: the parameters are not those of the routine's SBR and RET";
    CallCircle { routine: RoutineIndex } => "routine {routine} calls itself through its subroutines";
    CallDepth { routine: RoutineIndex } => "routine {routine} has more subroutines within subroutines than a program may";
    AddOnOrder { at: Site } => "{at}: an Add-On Instruction calls one that does not stand before it";
    AddOnDepth { at: Site } => "{at}: more Add-On Instructions within Add-On Instructions than there may be";
    AddOnInstance { at: Site } => "{at}: the first operand is not one instance of an Add-On Instruction";
    AddOnVariable { at: Site, position: usize } => "{at}, operand {position}: a variable subscript selects an instance or an InOut argument";
    AddOnArgument { at: Site, position: usize } => "{at}, operand {position}: not what the parameter takes";

    // The text.
    TextDiffers { routine: RoutineIndex, offset: usize } => "routine {routine}: its code says something else than its text from byte {offset} on";
}

impl core::error::Error for ImageError {}
