//! What engineers do with a controller: drive it with a stimulus, record it, look at the timing diagram, measure it; and
//! what they read about an instruction or a finding, a rung drawn as ladder among it.
//!
//! It may use the catalog, the vectors, the compiler, the controller and, through it, both channels; it never executes logic
//! itself, and it never writes a file: the command does.

#![forbid(unsafe_code)]

pub mod bench;
pub mod both_versions;
pub mod checklist;
pub mod connected;
pub mod coverage;
pub mod diagram;
pub mod difference;
pub mod drive;
#[cfg(feature = "injection")]
pub mod evidence;
pub mod fuzz;
pub mod hold;
pub mod html;
#[cfg(feature = "injection")]
pub mod inject;
pub mod instruction_rungs;
pub mod ladder;
pub mod line;
pub mod mix;
pub mod online_edit;
pub mod pages;
pub mod provenance;
pub mod reaction;
pub mod recording;
pub mod run;
pub mod scenario;
pub mod signal;
pub mod site;
pub mod stimulus;
pub mod threads;
pub mod transition;
mod usage;

pub use twinrung_contest::{cells, generate, names};

pub use recording::{Recording, Row};
pub use run::{Outcome, Run, RunError};
pub use signal::{ReadSignal, Signal, SignalError, Value};
pub use stimulus::{Stimulus, StimulusError};
pub use threads::{OnThread, Threads};
