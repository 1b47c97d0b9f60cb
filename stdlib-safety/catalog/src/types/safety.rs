//! Backing types of the safety application instructions, as a v36 export lays them out: the BOOL inputs are bits of a
//! first word, then the DINT inputs, then a word of BOOL outputs, the codes, and private words that read 0 here.
//!
//! `EnableIn` has the role Internal. `EnableOut` has the role Output and equals the rung condition of the last
//! execution: the interpreter writes it, not the half of the safety library.

pub mod analog;
pub mod dual_channel;
pub mod muting;
pub mod output;
pub mod press;
pub mod version_14;
