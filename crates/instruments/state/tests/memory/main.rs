//! How much a file has allocated: a program of its own, because the count is that of all its threads.

#[path = "../format/written.rs"]
mod written;

use std::alloc::System;
use std::sync::{Mutex, PoisonError};

use state::{Gone, State};
use stats_alloc::{INSTRUMENTED_SYSTEM, Region, StatsAlloc};

use written::{example, reworded, sealed, state};

#[global_allocator]
static COUNTED: &StatsAlloc<System> = &INSTRUMENTED_SYSTEM;

/// Held by the one test that counts: the count has what every thread allocates.
static COUNTING: Mutex<()> = Mutex::new(());

fn allocated(bytes: &[u8]) -> (usize, bool) {
    let region = Region::new(COUNTED);
    let is_read = State::parse(bytes).is_ok();
    (region.change().bytes_allocated, is_read)
}

/// A file of a thousand bytes that claims to hold as much as numbers can say has no more allocated for it than itself takes.
#[test]
fn a_length_in_the_file_allocates_nothing() {
    let _alone = COUNTING.lock().unwrap_or_else(PoisonError::into_inner);
    for wrong in [
        reworded("\"rows\": 2,", "\"rows\": 1000000000000,"),
        reworded("\"values_a_row\": 3", "\"values_a_row\": 4611686018427387904"),
        reworded("\"digital_bytes\": ", "\"digital_bytes\": 9000000000"),
        sealed([&example().bytes()[..12], &[0xff; 4], &example().bytes()[16..]].concat()),
    ] {
        let (taken, is_read) = allocated(&wrong);
        assert!(!is_read && taken < 40 * wrong.len(), "{taken} bytes for {}", wrong.len());
    }
}

/// A whole state takes as much as its file, and little more.
#[test]
fn a_whole_file_takes_its_own_size() {
    let _alone = COUNTING.lock().unwrap_or_else(PoisonError::into_inner);
    let bytes = state(900, 8, Gone::Nothing, 800, Vec::new()).bytes();
    let (taken, is_read) = allocated(&bytes);
    assert!(is_read && taken < 4 * bytes.len(), "{taken} bytes for {}", bytes.len());
}
