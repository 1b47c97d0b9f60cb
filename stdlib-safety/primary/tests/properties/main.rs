//! The reference's invariants, on random runs of every instruction: `dual-channel-inputs.md` 12, `muting-and-outputs.md`
//! 2.6 and 6 to 8, `v14-and-metal-form.md` 12.

mod analog;
mod dual_channel;
mod every_instruction;
mod metal_form;
mod muting;
mod outputs;
mod play;
mod version_14;
mod vocabulary;
