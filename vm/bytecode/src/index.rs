//! Indices into the tables of an image, and into a channel's memory.

macro_rules! index {
    ($($(#[$doc:meta])* $name:ident($inner:ty);)*) => {
        $(
            $(#[$doc])*
            #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
            pub struct $name(pub $inner);

            impl $name {
                /// The index as a position in a slice.
                pub const fn position(self) -> usize {
                    self.0 as usize
                }
            }

            impl core::fmt::Display for $name {
                fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                    core::fmt::Display::fmt(&self.0, f)
                }
            }
        )*
    };
}

index! {
    /// A structure type of the image.
    TypeIndex(u16);
    /// An Add-On Instruction of the image.
    AddOnIndex(u16);
    /// A program of the image.
    ProgramIndex(u16);
    /// A routine of the image.
    RoutineIndex(u32);
    /// A tag of the image.
    TagIndex(u32);
    /// An operand of the image.
    OperandIndex(u32);
    /// A system value that GSV or SSV names.
    SystemValueIndex(u16);
    /// An event task that EVENT names.
    EventTaskIndex(u16);
    /// A cell of the bit space: one BOOL.
    BitCell(u32);
    /// A cell of the word space: one SINT, INT, DINT (sign-extended to 32 bits) or REAL (its bits).
    WordCell(u32);
}
