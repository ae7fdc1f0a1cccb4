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
    /// It could not be started or ended badly.
    #[error("valgrind: {kernel}: {reason}")]
    Failed {
        /// Name of the kernel or of other work.
        kernel: String,
        /// What went wrong, in words.
        reason: String,
    },
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
/// If there is no valgrind, or the program does not end well under it.
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
    // None at all: the function was not found.
    let instructions = total.filter(|&total| total > 0).ok_or_else(|| failed("it counted nothing".into()))?;
    Ok(Count { instructions, told: String::from_utf8_lossy(&ended.stdout).trim().to_owned() })
}

/// A file that goes when it is no longer needed.
struct Remains(PathBuf);

impl Drop for Remains {
    fn drop(&mut self) {
        let _ = fs::remove_file(&self.0);
    }
}
