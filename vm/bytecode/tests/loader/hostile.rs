//! Bytes that nobody vouches for: flipped, signed again, random. None panics, none is admitted unless it is consistent.

use proptest::prelude::*;
use twinrung_bytecode::container::{HEADER_BYTES, MAGIC, VERSION};
use twinrung_bytecode::{admit, admit_library, admit_read, encode, read, seal, text};

use crate::support::samples::{rich, small};
use crate::support::*;

#[test]
fn sealed_image_when_any_bit_is_flipped_then_is_refused() {
    for bytes in [small().bytes(), rich().b.bytes()] {
        let admitted: Vec<usize> = (0..bytes.len() * 8)
            .filter(|bit| {
                let mut flipped = bytes.clone();
                flipped[bit / 8] ^= 1 << (bit % 8);
                admit(&flipped).is_ok()
            })
            .collect();
        assert_eq!(admitted, [0usize; 0]);
    }
}

/// Signs what was read again, admits it, and says whether that succeeded; once with the texts it carries and once with the texts
/// of its code, so that the flip gets past the comparison.
fn signed_again(bytes: &[u8]) -> [bool; 2] {
    let Ok(read) = read(bytes) else { return [false; 2] };
    let mut image = Build { image: read.image };
    let carried = seal(&image.image).is_ok_and(|bytes| admit(&bytes).is_ok());
    image.texts();
    [carried, seal(&image.image).is_ok_and(|bytes| admit(&bytes).is_ok())]
}

#[test]
fn sealed_image_when_a_bit_is_flipped_and_signed_again_then_is_refused_or_says_what_it_does() {
    let bytes = rich().b.bytes();
    let admitted = (HEADER_BYTES * 8..bytes.len() * 8).map(|bit| {
        let mut flipped = bytes.clone();
        flipped[bit / 8] ^= 1 << (bit % 8);
        signed_again(&flipped)
    });
    let [carried, rewritten] = admitted.fold([0, 0], |sum, ok| [sum[0] + u32::from(ok[0]), sum[1] + u32::from(ok[1])]);
    // Names, initial values, settings: flips that make another application. Most are none.
    assert!(carried > 0 && carried < rewritten, "{carried} {rewritten}");
    assert!((rewritten as usize) < bytes.len() * 8 / 2, "{rewritten}");
}

/// Every image that is admitted carries the text of its code and encodes to the bytes that it was read from.
fn is_consistent(bytes: &[u8]) -> bool {
    let (Ok(admitted), Ok(read)) = (admit(bytes), read(bytes)) else { return true };
    let image = admitted.image();
    let texts = (0..image.routines.len()).all(|index| {
        text::render_routine(image, RoutineIndex(index as u32)).as_ref() == Ok(&image.routines[index].text)
    });
    texts && encode(&read.image, &read.carried) == bytes && admit_read(read).is_ok()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(256))]

    #[test]
    fn bytes_when_random_then_never_panic(bytes in proptest::collection::vec(any::<u8>(), 0..2000)) {
        prop_assert!(admit(&bytes).is_err() && admit_library(&bytes).is_err());
    }

    #[test]
    fn bytes_when_random_behind_a_header_then_never_panic(
        lengths in proptest::collection::vec(0u32..64, 14),
        body in proptest::collection::vec(prop_oneof![0u8..4, any::<u8>()], 1000),
    ) {
        let mut bytes = MAGIC.to_vec();
        bytes.extend(VERSION.to_le_bytes());
        bytes.extend(14u32.to_le_bytes());
        for (kind, length) in (1u32..).zip(&lengths) {
            bytes.extend(kind.to_le_bytes());
            bytes.extend(length.to_le_bytes());
        }
        bytes.extend([0; 64]);
        bytes.extend(&body[..lengths.iter().sum::<u32>() as usize]);
        prop_assert_eq!(admit(&bytes).is_err(), true);
        let _ = signed_again(&bytes);
    }

    #[test]
    fn sealed_image_when_mutated_and_signed_again_then_is_consistent(
        changes in proptest::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..6),
    ) {
        let mut bytes = rich().b.bytes();
        for (place, byte) in changes {
            let at = HEADER_BYTES + place.index(bytes.len() - HEADER_BYTES);
            bytes[at] = byte;
        }
        let sealed = read(&bytes).ok().and_then(|read| seal(&read.image).ok()).unwrap_or_default();
        prop_assert!(is_consistent(&sealed));
        let _ = signed_again(&bytes);
    }

    #[test]
    fn operand_when_its_bytes_decode_then_encodes_to_the_same(
        index in 0usize..60,
        changes in proptest::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 0..3),
    ) {
        let image = rich().b.image;
        let index = index % image.operands.len();
        let mut bytes = image.operands.entry(OperandIndex(index as u32)).unwrap().to_vec();
        for (place, byte) in changes {
            let at = place.index(bytes.len());
            bytes[at] = byte;
        }
        let again = OperandRecord::decode(&bytes).map(|record| {
            let mut again = Vec::new();
            record.encode(&mut again);
            again
        });
        prop_assert_eq!(again.unwrap_or_else(|_| bytes.clone()), bytes);
    }
}
