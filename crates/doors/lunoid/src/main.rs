//! `lunoid`: a lunar rover's television picture, as the hybrid generator of 1970 made it.
//!
//! Results go to standard output, everything else to standard error. Exit codes: 0 done, 1 the answer is no,
//! 2 wrong usage, 3 bad input, 4 output failed, 130 interrupted.

mod browser;
mod cli;
mod commands;
mod frame;
mod rehearsing;
mod served;
#[cfg(test)]
mod written;

use std::process::ExitCode;
use std::time::Instant;

use cli::Cli;
use command_line::{Failure, Verdict, interrupt, output};
// Here for their features alone, as the manifest says.
#[cfg(unix)]
use rustix as _;
use {either as _, miniz_oxide as _, num_traits as _, serde_core as _};

fn main() -> ExitCode {
    let start = Instant::now();
    let cli = Cli::read();
    let code = match interrupt::catch().and_then(|()| commands::run(&cli, start)) {
        Ok(Verdict::Yes) | Err(Failure::ClosedPipe) => 0,
        Ok(Verdict::No) => 1,
        Ok(Verdict::Interrupted) => interrupt::EXIT_CODE,
        Err(failure) => {
            if let Some(message) = failure.message(cli.color.on_stderr()) {
                output::tell(&format!("{message}\n"));
            }
            failure.exit_code()
        }
    };
    ExitCode::from(code)
}
