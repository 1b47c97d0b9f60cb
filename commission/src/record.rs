//! A record: generation, content and image under one checksum, so that a part of one is never taken for one.
//!
//! ```text
//! magic | generation u64 | bytes of the content u64 | bytes of the image u64 | content (JSON) | image | SHA-256 of all before
//! ```
//!
//! Numbers are little-endian.

use std::fmt;

use serde::Serialize;
use serde::de::DeserializeOwned;
use sha2::{Digest, Sha256};

/// What a record holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RecordKind {
    /// The state of a controller.
    Controller,
    /// A memory card.
    Card,
}

impl RecordKind {
    const fn magic(self) -> &'static [u8; 16] {
        match self {
            RecordKind::Controller => b"twinrung state 1",
            RecordKind::Card => b"twinrung card  1",
        }
    }
}

/// Why bytes are no record.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum RecordError {
    /// They begin otherwise.
    Magic,
    /// They are cut off, longer than they say, or their checksum is another.
    Checksum,
    /// The content is not what this version reads or writes.
    Content(String),
}

impl fmt::Display for RecordError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            RecordError::Magic => f.write_str("it is not a record of this kind"),
            RecordError::Checksum => f.write_str("it is cut off or damaged: its checksum is not that of its bytes"),
            RecordError::Content(message) => write!(f, "this version cannot read its content: {message}"),
        }
    }
}

impl std::error::Error for RecordError {}

const MAGIC_BYTES: usize = 16;
const CHECKSUM_BYTES: usize = 32;

/// The bytes of a record.
///
/// # Errors
///
/// [`RecordError::Content`].
pub fn encode<T: Serialize>(
    kind: RecordKind,
    generation: u64,
    content: &T,
    image: &[u8],
) -> Result<Vec<u8>, RecordError> {
    let content = serde_json::to_vec(content).map_err(|error| RecordError::Content(error.to_string()))?;
    let mut bytes = kind.magic().to_vec();
    for number in [generation, content.len() as u64, image.len() as u64] {
        bytes.extend(number.to_le_bytes());
    }
    bytes.extend(content);
    bytes.extend(image);
    let checksum: [u8; CHECKSUM_BYTES] = Sha256::digest(&bytes).into();
    bytes.extend(checksum);
    Ok(bytes)
}

/// Reads a record: generation, content, image.
///
/// # Errors
///
/// [`RecordError`].
pub fn decode<T: DeserializeOwned>(kind: RecordKind, bytes: &[u8]) -> Result<(u64, T, Vec<u8>), RecordError> {
    if bytes.get(..MAGIC_BYTES) != Some(kind.magic().as_slice()) {
        return Err(RecordError::Magic);
    }
    let (body, checksum) = bytes.split_last_chunk::<CHECKSUM_BYTES>().ok_or(RecordError::Checksum)?;
    if Sha256::digest(body).as_slice() != checksum.as_slice() {
        return Err(RecordError::Checksum);
    }
    let mut rest = body.get(MAGIC_BYTES..).unwrap_or_default();
    let mut number = || {
        let (first, after) = rest.split_first_chunk::<8>().ok_or(RecordError::Checksum)?;
        rest = after;
        Ok(u64::from_le_bytes(*first))
    };
    let (generation, content_bytes, image_bytes) = (number()?, number()?, number()?);
    let (content, image) = usize::try_from(content_bytes)
        .ok()
        .and_then(|at| rest.split_at_checked(at))
        .filter(|(_, image)| image.len() as u64 == image_bytes)
        .ok_or(RecordError::Checksum)?;
    let content = serde_json::from_slice(content).map_err(|error| RecordError::Content(error.to_string()))?;
    Ok((generation, content, image.to_vec()))
}
