//! The running check: the sealed bytes are hashed again, a piece in every scan.

use alloc::vec::Vec;

use sha2::{Digest, Sha256};

/// Bytes hashed per scan: an image of n bytes is checked once in n / 256 scans, rounded up.
pub const IMAGE_CHECK_BYTES_PER_SCAN: usize = 256;

/// Hashes the sealed image over and over.
#[derive(Debug, Clone)]
pub(crate) struct ImageCheck {
    bytes: Vec<u8>,
    expected: [u8; 32],
    hasher: Sha256,
    next: usize,
}

impl ImageCheck {
    pub(crate) fn new(bytes: &[u8]) -> ImageCheck {
        ImageCheck { bytes: bytes.to_vec(), expected: Sha256::digest(bytes).into(), hasher: Sha256::new(), next: 0 }
    }

    /// Hashes the next piece; false when a whole pass has given another hash.
    pub(crate) fn step(&mut self) -> bool {
        let end = self.next.saturating_add(IMAGE_CHECK_BYTES_PER_SCAN).min(self.bytes.len());
        self.hasher.update(self.bytes.get(self.next..end).unwrap_or_default());
        self.next = end;
        if end < self.bytes.len() {
            return true;
        }
        self.next = 0;
        let found: [u8; 32] = self.hasher.finalize_reset().into();
        found == self.expected
    }

    /// For tests and fault injection: the bytes that are being checked.
    pub(crate) fn bytes_mut(&mut self) -> &mut [u8] {
        &mut self.bytes
    }

    /// For fault injection: all but the hash in the making, which the library keeps to itself.
    #[cfg(feature = "injection")]
    pub(crate) fn visit_bits(&mut self, visitor: &mut twinrung_bytecode::injection::BitVisitor) {
        visitor.fields(&mut self.bytes);
        visitor.fields(&mut self.expected);
        visitor.field(&mut self.next);
    }
}
