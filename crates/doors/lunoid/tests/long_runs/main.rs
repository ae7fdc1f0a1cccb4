//! The long forms of what `bad_input` does in short: minutes each, and only where they are asked for by name.
//!
//! ```sh
//! cargo test -p lunoid --test long_runs -- --nocapture long_
//! ```
//!
//! docs/robustness.md has the last results.

#[cfg(target_os = "linux")]
#[path = "../bad_input/build.rs"]
#[allow(dead_code, reason = "other tests need the rest")]
mod build;
#[cfg(target_os = "linux")]
#[path = "../bad_input/failing_disk.rs"]
mod failing_disk;
#[cfg(unix)]
#[path = "../bad_input/killed.rs"]
mod killed;
#[path = "../bad_input/room.rs"]
#[allow(dead_code, reason = "other tests need the rest")]
mod room;

/// A hundred runs, each killed twice.
#[cfg(unix)]
#[test]
fn long_two_hundred_kills() {
    killed::killed_and_resumed(100, 11);
}

/// Every file operation of every command, under every fault.
#[cfg(target_os = "linux")]
#[test]
fn long_every_operation_under_every_fault() {
    use failing_disk::{Fault, NO_SPACE, longer, replay, survey, timing};

    let once = |errno| Fault { errno, stays: false };
    let stays = |errno| Fault { errno, stays: true };
    // No space, no permission, a device error, half a write; a disk that stays full, and a folder that is gone.
    let faults = [NO_SPACE, once("13"), once("5"), once("short"), stays("28"), stays("2")];
    for case in [replay(), longer(), survey(), timing()] {
        faults.into_iter().for_each(|fault| case.fails_everywhere(fault, 1));
    }
}
