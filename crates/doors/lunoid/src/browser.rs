//! The browser of this computer.

use std::process::{Command, Stdio};

use command_line::output::tell;

/// Has the system's own program open `address`, or says that none could be started.
pub fn open_in_browser(address: &str) {
    if !is_opened(address) {
        tell("no browser could be started; open the address in one\n");
    }
}

/// Whether the system's own program was started.
fn is_opened(address: &str) -> bool {
    let opener = match std::env::consts::OS {
        "macos" => "open",
        "windows" => "explorer",
        _ => "xdg-open",
    };
    let mut command = Command::new(opener);
    command.arg(address).stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
    command.spawn().is_ok()
}
