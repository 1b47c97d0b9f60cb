//! What FPMS and EPMS share: which one of several inputs is on. `v14-and-metal-form.md` 3.2 and 5.

/// Longest time without a position. 3.2 recalled 80 %; 5, H-EPMS.
pub(crate) const NO_POSITION_MS: i32 = 250;

/// The inputs of a mode selector.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Selection {
    /// No input is on.
    None,
    /// Exactly this one is on, counted from 1.
    One(u8),
    /// More than one is on.
    Several,
}

impl Selection {
    /// Reads the inputs in the order of their positions.
    pub(crate) fn read<const POSITIONS: usize>(inputs: [i32; POSITIONS]) -> Selection {
        let mut selection = Selection::None;
        for (position, input) in (1u8..).zip(inputs) {
            if input != 0 {
                selection = match selection {
                    Selection::None => Selection::One(position),
                    _ => Selection::Several,
                };
            }
        }
        selection
    }
}
