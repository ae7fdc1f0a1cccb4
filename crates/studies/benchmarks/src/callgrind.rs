//! Instructions of a kernel, counted by callgrind of valgrind.

use std::ffi::OsStr;
use std::hint::black_box;
use std::io;
use std::path::{Path, PathBuf};
use std::process::{self, Command};
use std::{env, fs};

/// Runs `work` once. Instructions are counted within this function alone: callgrind knows it by its name, so it is never
/// part of another.
#[inline(never)]
pub fn counted(work: &mut dyn FnMut()) {
    work();
    // Without anything after it the call would be a jump, and callgrind would not see the return.
    black_box(());
}

/// Why instructions could not be counted.
#[derive(Debug, thiserror::Error)]
pub enum CountError {
    /// No valgrind on this system.
    #[error("valgrind: no such program; install it (Debian: valgrind), it counts the instructions")]
    NoValgrind,
    /// The program has no function of the name [`counted`].
    #[error(
        "{kernel}: the program has no symbols, by which valgrind finds what is counted; build it with `--profile counted`"
    )]
    NoSymbols {
        /// Name of the kernel or of other work.
        kernel: String,
    },
    /// It could not be started or ended badly.
    #[error("valgrind: {kernel}: {reason}")]
    Failed {
        /// Name of the kernel or of other work.
        kernel: String,
        /// What went wrong, in words.
        reason: String,
    },
}

impl CountError {
    /// Whether nothing is wrong with the program, and it cannot be counted here or as it was built.
    pub fn is_of_place(&self) -> bool {
        matches!(self, Self::NoValgrind | Self::NoSymbols { .. })
    }
}

/// What was counted of a kernel.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Count {
    /// Number of instructions within [`counted`].
    pub instructions: u64,
    /// What the kernel wrote to its output.
    pub told: String,
}

/// Instructions that `program` takes within [`counted`], given `arguments` by which it does the work `name`. The same build gives the same
/// number again; only what goes by addresses or by random keys may vary.
///
/// # Errors
/// If there is no valgrind, the program has no symbols, or it does not end well under valgrind.
pub fn instructions_of(
    program: &Path,
    name: &str,
    arguments: &[impl AsRef<OsStr>],
) -> Result<Count, CountError> {
    let failed = |reason: String| CountError::Failed { kernel: name.to_owned(), reason };
    let out =
        Remains(env::temp_dir().join(format!("callgrind-{}-{}", process::id(), name.replace('/', "-"))));
    let mut valgrind = Command::new("valgrind");
    valgrind.args(["--tool=callgrind", "--quiet", "--toggle-collect=*benchmarks*counted*"]);
    valgrind.arg(format!("--callgrind-out-file={}", out.0.display()));
    valgrind.arg(program).args(arguments);
    let ended = valgrind.output().map_err(|error| match error.kind() {
        io::ErrorKind::NotFound => CountError::NoValgrind,
        _ => failed(error.to_string()),
    })?;
    if !ended.status.success() {
        return Err(failed(format!("{}\n{}", ended.status, String::from_utf8_lossy(&ended.stderr))));
    }
    let written = fs::read_to_string(&out.0).map_err(|error| failed(error.to_string()))?;
    let total = written.lines().find_map(|line| line.strip_prefix("totals:")?.trim().parse().ok());
    let no_symbols = || CountError::NoSymbols { kernel: name.to_owned() };
    let instructions = total.filter(|&total| total > 0).ok_or_else(no_symbols)?;
    Ok(Count { instructions, told: String::from_utf8_lossy(&ended.stdout).trim().to_owned() })
}

/// A file that goes when it is no longer needed.
struct Remains(PathBuf);

impl Drop for Remains {
    fn drop(&mut self) {
        let _ = fs::remove_file(&self.0);
    }
}
