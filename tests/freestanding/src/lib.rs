//! Loads an image and runs scans without std: what a firmware would link.
//!
//! A workspace of its own, because a library with its own panic handler can neither unwind nor share a build with std:
//! were std anywhere among the dependencies, this would not compile (there would be two panic handlers). It may depend on
//! the four crates of `vm/` alone, and no other crate may depend on it. The test `freestanding` builds it.

#![no_std]

extern crate alloc;

use alloc::alloc::{GlobalAlloc, Layout};
use core::cell::UnsafeCell;
use core::panic::PanicInfo;
use core::ptr::null_mut;
use core::slice;
use core::sync::atomic::{AtomicUsize, Ordering};

use twinrung_bytecode::admit;
use twinrung_controller::{DualController, Mode};
use twinrung_partner::Partner;
use twinrung_primary::Primary;

/// What a firmware with 64 MiB of memory for images would reserve.
const HEAP_BYTES: usize = 64 << 20;

/// Memory that is handed out once and never taken back: everything is allocated while loading.
struct Heap {
    bytes: UnsafeCell<[u8; HEAP_BYTES]>,
    used: AtomicUsize,
}

// Every byte is handed out at most once, by the atomic counter.
unsafe impl Sync for Heap {}

unsafe impl GlobalAlloc for Heap {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        let base = self.bytes.get().cast::<u8>();
        let Some(room) = layout.size().checked_add(layout.align()) else { return null_mut() };
        let start = self.used.fetch_add(room, Ordering::Relaxed);
        if start.checked_add(room).is_none_or(|end| end > HEAP_BYTES) {
            return null_mut();
        }
        let address = unsafe { base.add(start) };
        unsafe { address.add(address.align_offset(layout.align())) }
    }

    unsafe fn dealloc(&self, _: *mut u8, _: Layout) {}
}

#[global_allocator]
static HEAP: Heap = Heap { bytes: UnsafeCell::new([0; HEAP_BYTES]), used: AtomicUsize::new(0) };

/// A firmware would switch its outputs off here; no admitted image reaches it.
#[panic_handler]
fn stop(_: &PanicInfo<'_>) -> ! {
    loop {
        core::hint::spin_loop();
    }
}

/// Loads an image and runs so many scans at its period; how many of them completed without a fault, -1 when the image is
/// refused.
///
/// # Safety
///
/// `image` points to `length` readable bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn twinrung_run(image: *const u8, length: usize, scans: u32) -> i64 {
    let bytes = unsafe { slice::from_raw_parts(image, length) };
    let Ok(admitted) = admit(bytes) else { return -1 };
    let Some(task) = &admitted.image().task else { return -1 };
    let period_us = i64::from(task.period_us);
    let Ok(mut controller) = DualController::load(admitted, bytes) else { return -1 };
    controller.request_mode(Mode::Run);
    let mut completed = 0;
    for scan in 0..i64::from(scans) {
        controller.scan(scan.saturating_mul(period_us) / 1000);
        completed += i64::from(controller.stopped().is_none());
    }
    completed
}

/// The sizes of the two channels in bytes: both are linked, each by its own name.
#[unsafe(no_mangle)]
pub extern "C" fn twinrung_channel_bytes() -> usize {
    size_of::<Primary>() + size_of::<Partner>()
}
