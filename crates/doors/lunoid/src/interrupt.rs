//! Ctrl-C: a command that can end well is told to, any other ends at once; no half file stays behind.

use std::sync::atomic::{AtomicBool, Ordering};

use files::abandon_temporaries;

use crate::Failure;

/// Exit code of a command that was interrupted.
pub const EXIT_CODE: u8 = 130;

/// Whether the command looks at [`TOLD`].
static LISTENS: AtomicBool = AtomicBool::new(false);
/// Set by the first Ctrl-C.
static TOLD: AtomicBool = AtomicBool::new(false);

/// Takes Ctrl-C from here on.
pub fn catch() -> Result<(), Failure> {
    let handler = || {
        let is_first = !TOLD.swap(true, Ordering::Relaxed);
        if !(is_first && LISTENS.load(Ordering::Relaxed)) {
            abandon_temporaries();
            std::process::exit(i32::from(EXIT_CODE));
        }
    };
    ctrlc::set_handler(handler).map_err(|error| Failure::output(format!("cannot catch Ctrl-C: {error}")))
}

/// What the first Ctrl-C sets, for a command that looks at it and ends by itself; the second ends it at once.
pub fn listen() -> &'static AtomicBool {
    LISTENS.store(true, Ordering::Relaxed);
    &TOLD
}
