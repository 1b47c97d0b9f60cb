//! One file for each verb: arguments in, text out.

pub mod bench;
pub mod build;
pub mod check;
pub mod checklist;
pub mod controller;
pub mod diff;
#[cfg(feature = "injection")]
pub mod evidence;
pub mod explain;
pub mod fmt;
pub mod fuzz;
#[cfg(feature = "injection")]
pub mod inject;
pub mod line;
pub mod reaction;
pub mod run;
pub mod show;
pub mod signature;
pub mod test;
