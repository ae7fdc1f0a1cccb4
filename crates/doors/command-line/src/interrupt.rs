//! Ctrl-C, and the signals TERM and HUP: a command that can end well is told to, any other ends at once; no half file stays behind.

use std::sync::atomic::{AtomicBool, Ordering};

use files::abandon_temporaries;

use crate::Failure;

/// Exit code of a command that was interrupted.
pub const EXIT_CODE: u8 = 130;

/// Whether the command looks at [`TOLD`].
static LISTENS: AtomicBool = AtomicBool::new(false);
/// Set by the first signal.
static TOLD: AtomicBool = AtomicBool::new(false);

/// Takes Ctrl-C, TERM and HUP from here on.
pub fn catch() -> Result<(), Failure> {
    let handler = || {
        let is_first = !TOLD.swap(true, Ordering::Relaxed);
        if !(is_first && LISTENS.load(Ordering::Relaxed)) {
            abandon_temporaries();
            std::process::exit(i32::from(EXIT_CODE));
        }
    };
    let failed = |error: &dyn std::fmt::Display| Failure::output(format!("cannot catch Ctrl-C: {error}"));
    #[cfg(target_os = "linux")]
    hangup::keep_ignoring().map_err(|error| failed(&error))?;
    ctrlc::set_handler(handler).map_err(|error| failed(&error))
}

/// `nohup` starts a command that is to outlive its terminal: it ignores HUP, and goes on to.
#[cfg(target_os = "linux")]
mod hangup {
    use nix::sys::signal::{SigSet, Signal};

    /// Holds HUP back from this thread, and so from those that it will start, if the command was started to ignore it.
    pub fn keep_ignoring() -> nix::Result<()> {
        let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
        if is_ignored(&status, Signal::SIGHUP) { SigSet::from(Signal::SIGHUP).thread_block() } else { Ok(()) }
    }

    /// Whether a status of the system says that the process ignores a signal: bit n - 1 of a hexadecimal number is signal n.
    fn is_ignored(status: &str, signal: Signal) -> bool {
        let mask = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
        let mask = mask.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok()).unwrap_or(0);
        mask >> (signal as u32 - 1) & 1 == 1
    }
}

/// What the first signal sets, for a command that looks at it and ends by itself; the second ends it at once.
pub fn listen() -> &'static AtomicBool {
    LISTENS.store(true, Ordering::Relaxed);
    &TOLD
}
