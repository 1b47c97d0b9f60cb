//! Test vectors of the safety application instructions.
