//! Predefined structures: members in layout order.

/// An elementary type.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
#[repr(u8)]
pub enum Element {
    /// One bit.
    Bool = 0,
    /// 8 bits, signed.
    Sint = 1,
    /// 16 bits, signed.
    Int = 2,
    /// 32 bits, signed.
    Dint = 3,
    /// IEEE-754 binary32.
    Real = 4,
}

impl Element {
    /// All elementary types.
    pub const ALL: [Element; 5] = [Element::Bool, Element::Sint, Element::Int, Element::Dint, Element::Real];

    /// The name as declarations write it.
    pub const fn name(self) -> &'static str {
        match self {
            Element::Bool => "BOOL",
            Element::Sint => "SINT",
            Element::Int => "INT",
            Element::Dint => "DINT",
            Element::Real => "REAL",
        }
    }

    /// The type of that name; upper and lower case are the same.
    pub fn by_name(name: &str) -> Option<Element> {
        Element::ALL.into_iter().find(|element| element.name().eq_ignore_ascii_case(name))
    }

    /// Size and alignment in bytes in the Logix memory layout; a BOOL is a bit of its host word and has none of its own.
    pub const fn bytes(self) -> u32 {
        match self {
            Element::Bool => 0,
            Element::Sint => 1,
            Element::Int => 2,
            Element::Dint | Element::Real => 4,
        }
    }

    /// Number of bits.
    pub const fn bits(self) -> u8 {
        match self {
            Element::Bool => 1,
            Element::Sint => 8,
            Element::Int => 16,
            Element::Dint | Element::Real => 32,
        }
    }
}

/// What a member of a predefined structure is for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MemberRole {
    /// Plain data that logic may read and write (TIMER.PRE).
    Data,
    /// Mirrors an operand or the rung condition of the instruction that the tag backs.
    Input,
    /// Holds a configuration operand of the instruction that the tag backs.
    Configuration,
    /// Result of the instruction that the tag backs.
    Output,
    /// `EnableIn` of a safety application instruction: may not be referenced at all.
    Internal,
}

/// A member of a predefined structure.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Member {
    /// Its name.
    pub name: &'static str,
    /// Its type.
    pub element: Element,
    /// How many elements; 0 = not an array.
    pub length: u32,
    /// Offset in bytes from the start of the structure (for a BOOL: of its host word).
    pub byte: u32,
    /// For a BOOL: its bit in the host word.
    pub bit: u8,
    /// What it is for.
    pub role: MemberRole,
    /// What it says, for `explain`; may be empty where the name says it.
    pub meaning: &'static str,
}

/// Output members that report on the instruction itself: its rung condition, faults, codes, prompts, elapsed times. No
/// safety function may take them for what a device says. (decided)
pub const REPORTS: &[&str] = &[
    "EnableOut",
    "FP",
    "FaultCode",
    "DiagnosticCode",
    "CRHO",
    "II",
    "LCB",
    "LCM",
    "NM",
    "MMS",
    "O1FF",
    "O2FF",
    "SAF",
    "RBF",
    "LBF",
    "SRCA",
    "SRCB",
    "O1OnTime",
    "MeasuredStartTime",
    "MeasuredStopTime",
    "Revision",
];

impl Member {
    /// Whether it is an output that reports on the instruction, and is no safety data.
    pub fn reports(&self) -> bool {
        self.role == MemberRole::Output && REPORTS.contains(&self.name)
    }
}

/// A predefined structure.
#[derive(Debug, PartialEq, Eq)]
pub struct PredefinedType {
    /// The type's name as declarations write it.
    pub name: &'static str,
    /// Size in bytes in the Logix memory layout, private words included.
    pub bytes: u32,
    /// The named members in layout order.
    pub members: &'static [Member],
    /// Whether a tag of this type backs exactly one call of a safety application instruction.
    pub backs_one_call: bool,
    /// Where the layout stands.
    pub source: &'static str,
}

impl PredefinedType {
    /// Finds a structure by name; upper and lower case are the same.
    pub fn by_name(name: &str) -> Option<&'static PredefinedType> {
        crate::types::ALL.iter().copied().find(|known| known.name.eq_ignore_ascii_case(name))
    }

    /// Finds a member by name; upper and lower case are the same.
    pub fn member(&self, name: &str) -> Option<(usize, &'static Member)> {
        self.members.iter().enumerate().find(|(_, member)| member.name.eq_ignore_ascii_case(name))
    }
}

/// Declares a BOOL member: bit `bit` of the word at `byte`.
pub const fn flag(name: &'static str, byte: u32, bit: u8, role: MemberRole, meaning: &'static str) -> Member {
    Member { name, element: Element::Bool, length: 0, byte, bit, role, meaning }
}

/// Declares a DINT member.
pub const fn word(name: &'static str, byte: u32, role: MemberRole, meaning: &'static str) -> Member {
    Member { name, element: Element::Dint, length: 0, byte, bit: 0, role, meaning }
}

/// Declares a REAL member.
pub const fn real(name: &'static str, byte: u32, role: MemberRole, meaning: &'static str) -> Member {
    Member { name, element: Element::Real, length: 0, byte, bit: 0, role, meaning }
}
