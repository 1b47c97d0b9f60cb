//! An image with any single bit flipped is refused; flipped and sealed again it is refused by the verifier, or both
//! channels run it without a panic and agree.

use twinrung_bytecode::signature::seal;
use twinrung_bytecode::{admit, read};
use twinrung_controller::{DualController, SafetyFault, StopReason};

use crate::support::{image_of, project_path, read_whole};

fn sealed() -> Vec<u8> {
    image_of(&read_whole(&project_path("samples/qualified-standard-data/project.rll"))).1
}

/// REQ-IMAGE-001
#[test]
fn image_when_any_bit_is_flipped_then_the_loader_refuses_it() {
    let mut bytes = sealed();
    let admitted: Vec<usize> = (0..bytes.len() * 8)
        .filter(|bit| {
            bytes[bit / 8] ^= 1 << (bit % 8);
            let admitted = admit(&bytes).is_ok();
            bytes[bit / 8] ^= 1 << (bit % 8);
            admitted
        })
        .collect();
    assert!(admitted.is_empty(), "admitted with these bits flipped: {admitted:?}");
}

/// REQ-IMAGE-002
#[test]
fn image_when_a_bit_is_flipped_and_sealed_again_then_it_is_refused_or_both_channels_agree() {
    let original = sealed();
    let mut ran = 0;
    for bit in 0..original.len() * 8 {
        let mut bytes = original.clone();
        bytes[bit / 8] ^= 1 << (bit % 8);
        let Ok(again) = read(&bytes).map_err(drop).and_then(|read| seal(&read.image).map_err(drop)) else { continue };
        let Ok(image) = admit(&again) else { continue };
        let Ok(mut controller) = DualController::load(image, &again) else { continue };
        controller.power_up_in_run();
        for scan in 0..4 {
            let report = controller.scan(scan * 10);
            let differs = matches!(report.stopped, Some(StopReason::Safety(SafetyFault::Difference(_))));
            assert!(!differs, "bit {bit}: {:?}", report.stopped);
        }
        ran += 1;
    }
    assert!(ran > 0, "some flips make another valid program");
}
