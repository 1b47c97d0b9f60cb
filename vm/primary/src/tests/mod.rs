//! Tests that put images together by hand.

mod assembler;
mod bits_and_timers;
mod calls;
mod files;
mod flow;
mod injection;
mod jumps;
mod limits;
mod lowering;
mod numbers;
mod path;
mod random;
mod rig;
mod safety;
mod upsets;
