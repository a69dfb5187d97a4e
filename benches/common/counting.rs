//! The bytes that a run holds, and the most that it needed on the way.

use mimalloc::MiMalloc;
use std::alloc::{GlobalAlloc, Layout};
use std::sync::atomic::{AtomicBool, AtomicIsize, Ordering};

/// Runs with every byte counted: the result, the bytes it holds, and the most that were held on the way.
pub fn counted<T>(run: impl Fn() -> T) -> (T, isize, isize) {
    LIVE.store(0, Ordering::Relaxed);
    PEAK.store(0, Ordering::Relaxed);
    COUNTS.store(true, Ordering::Relaxed);
    let result = run();
    COUNTS.store(false, Ordering::Relaxed);
    (result, LIVE.load(Ordering::Relaxed), PEAK.load(Ordering::Relaxed))
}

/// The command's allocator, with the bytes asked for counted while [`counted`] runs. (The one place with `unsafe`: an
/// allocator cannot be written without; the library forbids it.)
struct Counting;

#[global_allocator]
static ALLOCATOR: Counting = Counting;
static COUNTS: AtomicBool = AtomicBool::new(false);
static LIVE: AtomicIsize = AtomicIsize::new(0);
static PEAK: AtomicIsize = AtomicIsize::new(0);

fn note(bytes: isize) {
    if COUNTS.load(Ordering::Relaxed) {
        let live = LIVE.fetch_add(bytes, Ordering::Relaxed) + bytes;
        PEAK.fetch_max(live, Ordering::Relaxed);
    }
}

// SAFETY: every call goes to the command's allocator unchanged; counting touches no memory of the caller.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, block: Layout) -> *mut u8 {
        note(block.size() as isize);
        unsafe { MiMalloc.alloc(block) }
    }

    unsafe fn dealloc(&self, place: *mut u8, block: Layout) {
        note(-(block.size() as isize));
        unsafe { MiMalloc.dealloc(place, block) }
    }

    unsafe fn realloc(&self, place: *mut u8, block: Layout, size: usize) -> *mut u8 {
        note(size as isize - block.size() as isize);
        unsafe { MiMalloc.realloc(place, block, size) }
    }
}
