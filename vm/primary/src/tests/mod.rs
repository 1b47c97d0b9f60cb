//! Tests that put images together by hand.

mod assembler;
mod bench;
mod random;
mod rig;
