//! Online edits: which application another one can become while it runs (1756-RM093 Online Editing).

use alloc::string::String;
use alloc::vec::Vec;
use core::fmt;

use twinrung_bytecode::ImageError;
use twinrung_bytecode::image::{Image, Owner};
use twinrung_bytecode::signature::{LeafKind, leaves};

/// Why an image cannot take over from another one while a controller runs.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Unfit {
    /// Something else than the routines of safety programs differs: its kind and name.
    Other(&'static str, String),
    /// One of the images cannot be described.
    Image(ImageError),
}

impl fmt::Display for Unfit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Unfit::Other(kind, name) if name.is_empty() => write!(f, "the {kind} differ"),
            Unfit::Other(kind, name) => write!(f, "the {kind} `{name}` differs"),
            Unfit::Image(error) => write!(f, "{error}"),
        }
    }
}

/// The routines of safety programs, as `Program/Routine`, whose texts differ between two images that are the same in all else.
///
/// # Errors
///
/// [`Unfit`]: an online edit changes rungs of safety routines and nothing else (decided).
pub fn fits(before: &Image, after: &Image) -> Result<Vec<String>, Unfit> {
    let (old, new) = (leaves(before).map_err(Unfit::Image)?, leaves(after).map_err(Unfit::Image)?);
    let of_program = |image: &Image, position: usize| {
        image.routines.get(position).is_some_and(|routine| matches!(routine.owner, Owner::Program(_)))
    };
    let mut changed = Vec::new();
    for (position, leaf) in new.iter().enumerate() {
        match old.get(position) {
            Some(own) if own == leaf => {}
            Some(own)
                if own.kind == LeafKind::Routine
                    && leaf.kind == LeafKind::Routine
                    && own.name == leaf.name
                    && of_program(before, position)
                    && of_program(after, position) =>
            {
                changed.push(leaf.name.clone());
            }
            _ => return Err(Unfit::Other(leaf.kind.name(), leaf.name.clone())),
        }
    }
    if let Some(missing) = old.get(new.len()) {
        return Err(Unfit::Other(missing.kind.name(), missing.name.clone()));
    }
    Ok(changed)
}
