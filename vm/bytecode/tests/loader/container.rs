//! The form of the file, and its signatures.

use sha2::{Digest, Sha256};
use twinrung_bytecode::container::{HEADER_BYTES, MAGIC, Section, encode, section_places};
use twinrung_bytecode::{ImageError, admit, limits, read, seal};

use crate::support::samples::rich;

/// The rule that `read` reports for changed bytes.
fn read_rule(change: impl FnOnce(&mut Vec<u8>)) -> &'static str {
    let mut bytes = rich().b.bytes();
    change(&mut bytes);
    read(&bytes).map_or_else(|error| error.rule(), |_| "read")
}

/// Puts a byte at a distance from the start of a section.
fn put(section: Section, distance: usize, byte: u8) -> impl FnOnce(&mut Vec<u8>) {
    move |bytes| {
        let places = section_places(bytes).unwrap();
        let place = places.iter().find(|place| place.section == section).unwrap();
        bytes[place.offset + distance] = byte;
    }
}

#[test]
fn header_when_not_that_of_an_image_then_is_refused() {
    assert_eq!(read_rule(|bytes| bytes[0] = b'T'), "NotAnImage");
    assert_eq!(read_rule(|bytes| bytes.clear()), "NotAnImage");
    assert_eq!(read_rule(|bytes| bytes[8] = 2), "UnknownVersion");
    assert_eq!(read_rule(|bytes| bytes[12] = 13), "SectionTable");
    assert_eq!(read_rule(|bytes| bytes[16] = 2), "SectionTable");
    assert_eq!(read_rule(|bytes| bytes.truncate(20)), "Truncated");
    assert_eq!(read_rule(|bytes| bytes.truncate(HEADER_BYTES)), "Truncated");
}

#[test]
fn file_when_longer_or_shorter_than_its_sections_then_is_refused() {
    assert_eq!(read_rule(|bytes| bytes.push(0)), "SlackBytes");
    assert_eq!(read_rule(|bytes| bytes.truncate(bytes.len() - 1)), "Truncated");
    // The first section one byte longer, the second one byte shorter.
    assert_eq!(read_rule(|bytes| (bytes[20], bytes[28]) = (bytes[20] + 1, bytes[28].wrapping_sub(1))), "SlackBytes");
}

#[test]
fn file_when_beyond_the_greatest_size_then_is_refused() {
    let mut bytes = vec![0; limits::IMAGE_BYTES + 1];
    bytes[..8].copy_from_slice(&MAGIC);
    assert_eq!(read(&bytes).unwrap_err().rule(), "TooManyBytes");
    bytes.pop();
    assert_eq!(read(&bytes).unwrap_err().rule(), "UnknownVersion");
}

#[test]
fn field_when_it_has_another_form_then_is_refused() {
    assert_eq!(read_rule(put(Section::Programs, 12, 2)), "NotABoolean");
    assert_eq!(read_rule(put(Section::Controller, 4, 0xFF)), "NotText");
    assert_eq!(read_rule(put(Section::Controller, 1, 0xFF)), "Truncated");
    assert_eq!(read_rule(put(Section::Types, 13, 9)), "UnknownChoice");
    assert_eq!(read_rule(put(Section::Operands, 8, 0)), "OperandOffsets");
    assert_eq!(read_rule(put(Section::Operands, 5, 0xFF)), "OperandOffsets");
}

#[test]
fn table_when_beyond_its_limit_then_is_refused_before_it_is_read() {
    assert_eq!(read_rule(put(Section::Programs, 0, 100)), "Truncated");
    assert_eq!(read_rule(put(Section::Programs, 0, 101)), "TooMany");
}

#[test]
fn content_when_changed_after_sealing_then_the_image_signature_refuses_it() {
    let mut bytes = rich().b.bytes();
    let places = section_places(&bytes).unwrap();
    let bits = places.iter().find(|place| place.section == Section::InitialBits).unwrap();
    bytes[bits.offset + 4] ^= 1;
    assert_eq!(admit(&bytes).unwrap_err(), ImageError::ImageSignature);
}

/// The image signature as `signature.rs` describes it.
fn image_signature(application: &[u8; 32], bytes: &[u8]) -> [u8; 32] {
    let body = Sha256::new_with_prefix(b"twinrung image body 1\0")
        .chain_update(&bytes[..HEADER_BYTES - 64])
        .chain_update(&bytes[HEADER_BYTES..])
        .finalize();
    Sha256::new_with_prefix(b"twinrung image 1\0").chain_update(application).chain_update(body).finalize().into()
}

#[test]
fn application_signature_when_of_another_application_then_is_refused() {
    let mut r = rich();
    let mut read = read(&r.b.bytes()).unwrap();
    assert_eq!(image_signature(&read.carried.application, &seal(&read.image).unwrap()), read.carried.image);
    read.image.task.as_mut().unwrap().period_us = 30_000;
    let unsigned = encode(&read.image, &read.carried);
    read.carried.image = image_signature(&read.carried.application, &unsigned);
    let forged = encode(&read.image, &read.carried);
    assert_eq!(admit(&forged).unwrap_err(), ImageError::ApplicationSignature);
}
